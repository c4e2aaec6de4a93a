//! `str.format`.

use super::unicode;
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::native::Args;
use crate::python::value::{Symbol, Value};
use crate::python::vm::Vm;

/// `template.format(*args.pos, **args.kw)`: the receiver is not among the arguments.
pub fn str_format(vm: &mut Vm<'_>, template: &str, args: Args<'_>) -> R<String> {
    let mut formatter = Formatter { positional: Some(args.pos), named: Named::Keywords(args.kw), numbering: None, next: 0 };
    formatter.expand(vm, template, 2)
}

/// `template.format_map(mapping)`
pub fn format_map(vm: &mut Vm<'_>, template: &str, mapping: Value) -> R<String> {
    let mut formatter = Formatter { positional: None, named: Named::Mapping(mapping), numbering: None, next: 0 };
    formatter.expand(vm, template, 2)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Numbering {
    Automatic,
    Manual,
}

#[derive(Clone, Copy)]
enum Named<'a> {
    Keywords(&'a [(Symbol, Value)]),
    Mapping(Value),
}

struct Formatter<'a> {
    /// `None` in `format_map`.
    positional: Option<&'a [Value]>,
    named: Named<'a>,
    /// How fields are numbered, once one has been.
    numbering: Option<Numbering>,
    /// The next automatic number.
    next: usize,
}

/// A replacement field: `{name!conversion:spec}`.
struct Field<'t> {
    name: &'t str,
    conversion: Option<char>,
    spec: &'t str,
    nested: bool,
}

impl Formatter<'_> {
    fn expand(&mut self, vm: &mut Vm<'_>, template: &str, depth: u32) -> R<String> {
        if depth == 0 {
            return Err(vm.value_error("Max string recursion exceeded"));
        }
        vm.charge(template.len() as u64 / 16)?;
        let mut out = String::new();
        let mut rest = template;
        while let Some(at) = rest.find(['{', '}']) {
            let brace = rest.as_bytes()[at];
            let after = &rest[at + 1..];
            out.push_str(&rest[..at]);
            if after.as_bytes().first() == Some(&brace) {
                out.push(char::from(brace));
                rest = &after[1..];
                continue;
            }
            if brace == b'}' {
                return Err(vm.value_error("Single '}' encountered in format string"));
            }
            if after.is_empty() {
                return Err(vm.value_error("Single '{' encountered in format string"));
            }
            let field = match parse_field(after) {
                Ok((field, remaining)) => {
                    rest = remaining;
                    field
                }
                Err(message) => return Err(vm.value_error(message)),
            };
            let text = self.field(vm, &field, depth)?;
            out.push_str(&text);
            if out.len() > 1 << 14 {
                vm.reserve(out.len() * 2)?;
            }
        }
        out.push_str(rest);
        Ok(out)
    }

    fn field(&mut self, vm: &mut Vm<'_>, field: &Field<'_>, depth: u32) -> R<String> {
        let mut value = self.lookup(vm, field.name)?;
        if let Some(conversion) = field.conversion {
            let text = match conversion {
                'r' => vm.repr(value)?,
                's' => vm.str(value)?,
                'a' => vm.ascii(value)?,
                other => {
                    let shown =
                        if (' '..'\x7f').contains(&other) && other != ' ' { other.to_string() } else { format!("\\x{:x}", other as u32) };
                    return Err(vm.value_error(format!("Unknown conversion specifier {shown}")));
                }
            };
            value = vm.new_str(text);
        }
        if field.nested {
            let spec = self.expand(vm, field.spec, depth - 1)?;
            return vm.format(value, &spec);
        }
        vm.format(value, field.spec)
    }

    /// The value of `name`, with all its `.attribute` and `[index]`.
    fn lookup(&mut self, vm: &mut Vm<'_>, name: &str) -> R<Value> {
        let end = name.find(['.', '[']).unwrap_or(name.len());
        let (first, mut rest) = name.split_at(end);
        let mut value = self.first(vm, first)?;
        while let Some(mark) = rest.chars().next() {
            let body = &rest[mark.len_utf8()..];
            let (part, after) = match mark {
                '.' => body.split_at(body.find(['.', '[']).unwrap_or(body.len())),
                '[' => match body.split_once(']') {
                    Some(parts) => parts,
                    None => return Err(vm.value_error("Missing ']' in format string")),
                },
                _ => return Err(vm.value_error("Only '.' or '[' may follow ']' in format field specifier")),
            };
            if part.is_empty() {
                return Err(vm.value_error("Empty attribute in format string"));
            }
            value = if mark == '.' {
                let attribute = vm.symbols.intern(part);
                vm.get_attr(value, attribute)?
            } else {
                let index = match number(vm, part)? {
                    Some(index) => Value::int(index as i64),
                    None => vm.new_str(part),
                };
                vm.get_item(value, index)?
            };
            rest = after;
        }
        Ok(value)
    }

    fn first(&mut self, vm: &mut Vm<'_>, name: &str) -> R<Value> {
        let index = match number(vm, name)? {
            _ if name.is_empty() => {
                self.number(vm, Numbering::Automatic)?;
                self.next += 1;
                self.next - 1
            }
            Some(index) => {
                self.number(vm, Numbering::Manual)?;
                index
            }
            None => return self.named(vm, name),
        };
        let Some(positional) = self.positional else { return Err(vm.value_error("Format string contains positional fields")) };
        match positional.get(index) {
            Some(&value) => Ok(value),
            None => {
                let message = format!("Replacement index {index} out of range for positional args tuple");
                Err(vm.error(Builtin::IndexError, message))
            }
        }
    }

    fn number(&mut self, vm: &mut Vm<'_>, wanted: Numbering) -> R<()> {
        if self.positional.is_none() {
            return Ok(());
        }
        if *self.numbering.get_or_insert(wanted) == wanted {
            return Ok(());
        }
        Err(vm.value_error(match wanted {
            Numbering::Automatic => "cannot switch from manual field specification to automatic field numbering",
            Numbering::Manual => "cannot switch from automatic field numbering to manual field specification",
        }))
    }

    fn named(&mut self, vm: &mut Vm<'_>, name: &str) -> R<Value> {
        match self.named {
            Named::Keywords(keywords) => {
                let found = vm.symbols.find(name).and_then(|symbol| keywords.iter().find(|(key, _)| *key == symbol));
                if let Some(&(_, value)) = found {
                    return Ok(value);
                }
                let key = vm.new_str(name);
                Err(vm.key_error(key))
            }
            Named::Mapping(mapping) => {
                let key = vm.new_str(name);
                vm.get_item(mapping, key)
            }
        }
    }
}

/// The number that a part of a field name is, if it is one.
fn number(vm: &mut Vm<'_>, text: &str) -> R<Option<usize>> {
    let mut value = 0usize;
    for c in text.chars() {
        let Some(digit) = unicode::decimal(c) else { return Ok(None) };
        value = match value.checked_mul(10).and_then(|v| v.checked_add(digit as usize)).filter(|v| *v <= isize::MAX as usize) {
            Some(value) => value,
            None => return Err(vm.value_error("Too many decimal digits in format string")),
        };
    }
    Ok((!text.is_empty()).then_some(value))
}

/// Reads a field behind its `{`; gives what follows its `}`.
fn parse_field(text: &str) -> Result<(Field<'_>, &str), &'static str> {
    let mut chars = text.char_indices();
    let mut end = None;
    while let Some((i, c)) = chars.next() {
        match c {
            '{' => return Err("unexpected '{' in field name"),
            '[' => {
                // The bracket's own `]` is looked at again, and means nothing here.
                chars.by_ref().find(|(_, c)| *c == ']');
            }
            '}' | ':' | '!' => {
                end = Some((i, c));
                break;
            }
            _ => {}
        }
    }
    let Some((end, mark)) = end else { return Err("expected '}' before end of string") };
    let name = &text[..end];
    let mut conversion = None;
    match mark {
        '}' => return Ok((Field { name, conversion, spec: "", nested: false }, chars.as_str())),
        '!' => {
            let Some((_, c)) = chars.next() else { return Err("end of string while looking for conversion specifier") };
            conversion = Some(c);
            match chars.next() {
                Some((_, '}')) => return Ok((Field { name, conversion, spec: "", nested: false }, chars.as_str())),
                Some((_, ':')) | None => {}
                Some(_) => return Err("expected ':' after conversion specifier"),
            }
        }
        _ => {}
    }
    let spec = chars.as_str();
    let (mut depth, mut nested) = (1u32, false);
    for (i, c) in spec.char_indices() {
        match c {
            '{' => {
                nested = true;
                depth += 1;
            }
            '}' => {
                depth -= 1;
                if depth == 0 {
                    return Ok((Field { name, conversion, spec: &spec[..i], nested }, &spec[i + 1..]));
                }
            }
            _ => {}
        }
    }
    Err("unmatched '{' in format spec")
}
