//! `template % values`.

use super::number::{digits_of, style};
use super::{FormatError, float, quote};
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::Bytes;
use crate::python::numbers;
use crate::python::symbols::sym;
use crate::python::value::Value;
use crate::python::vm::Vm;
use num_traits::Signed;

/// `template % values` of strings.
pub fn percent(vm: &mut Vm<'_>, template: &str, values: Value) -> R<String> {
    let chars: Vec<char> = template.chars().collect();
    Percent::new(vm, &chars, values, false).run(vm)
}

/// `template % values` of bytes.
pub fn percent_bytes(vm: &mut Vm<'_>, template: &[u8], values: Value) -> R<Vec<u8>> {
    let chars: Vec<char> = template.iter().map(|b| char::from(*b)).collect();
    let text = Percent::new(vm, &chars, values, true).run(vm)?;
    Ok(text.chars().map(|c| c as u8).collect())
}

/// A template under way. One of bytes is worked on as the text with a character for each byte.
struct Percent<'a> {
    template: &'a [char],
    /// The next character.
    at: usize,
    values: Vec<Value>,
    /// The next value.
    next: usize,
    mapping: Option<Value>,
    of_bytes: bool,
    out: String,
}

/// What stands between `%` and the type.
#[derive(Default)]
struct Field {
    left: bool,
    plus: bool,
    blank: bool,
    alternate: bool,
    zero: bool,
    width: usize,
    precision: Option<usize>,
}

impl<'a> Percent<'a> {
    fn new(vm: &mut Vm<'_>, template: &'a [char], values: Value, of_bytes: bool) -> Self {
        let plain = vm.plain(values);
        let (list, mapping) = match plain {
            Value::Tuple(t) => (vm.heap[t].0.to_vec(), None),
            Value::Str(_) => (vec![values], of_bytes.then_some(values)),
            Value::Bytes(_) | Value::ByteArray(_) => (vec![values], (!of_bytes).then_some(values)),
            Value::Dict(_) | Value::List(_) | Value::Range(_) | Value::Proxy(_) | Value::Alias(_) => (vec![values], Some(values)),
            Value::Instance(_) => (vec![values], vm.special(values, sym::GETITEM).map(|_| values)),
            _ => (vec![values], None),
        };
        Percent { template, at: 0, values: list, next: 0, mapping, of_bytes, out: String::new() }
    }

    fn run(mut self, vm: &mut Vm<'_>) -> R<String> {
        vm.charge(self.template.len() as u64 / 16)?;
        while let Some(&c) = self.template.get(self.at) {
            self.at += 1;
            if c != '%' {
                self.out.push(c);
            } else if self.template.get(self.at) == Some(&'%') {
                self.at += 1;
                self.out.push('%');
            } else {
                self.field(vm)?;
                if self.out.len() > 1 << 14 {
                    vm.reserve(self.out.len() * 2)?;
                }
            }
        }
        if self.next < self.values.len() && self.mapping.is_none() {
            let what = if self.of_bytes { "bytes" } else { "string" };
            return Err(vm.type_error(format!("not all arguments converted during {what} formatting")));
        }
        Ok(self.out)
    }

    fn peek(&self, vm: &mut Vm<'_>) -> R<char> {
        match self.template.get(self.at) {
            Some(&c) => Ok(c),
            None => Err(vm.value_error("incomplete format")),
        }
    }

    fn value(&mut self, vm: &mut Vm<'_>) -> R<Value> {
        match self.values.get(self.next) {
            Some(&value) => {
                self.next += 1;
                Ok(value)
            }
            None => Err(vm.type_error("not enough arguments for format string")),
        }
    }

    fn field(&mut self, vm: &mut Vm<'_>) -> R<()> {
        if self.template.get(self.at) == Some(&'(') {
            self.key(vm)?;
        }
        let mut field = Field::default();
        loop {
            match self.peek(vm)? {
                '-' => field.left = true,
                '+' => field.plus = true,
                ' ' => field.blank = true,
                '#' => field.alternate = true,
                '0' => field.zero = true,
                _ => break,
            }
            self.at += 1;
        }
        if self.peek(vm)? == '*' {
            let width = self.star(vm)?;
            field.left |= width < 0;
            field.width = width.unsigned_abs() as usize;
        } else {
            field.width = self.digits(vm, isize::MAX as usize, "width too big")?;
        }
        if self.peek(vm)? == '.' {
            self.at += 1;
            field.precision = Some(match self.peek(vm)? {
                '*' => usize::try_from(self.star(vm)?).unwrap_or(0),
                _ => self.digits(vm, i32::MAX as usize, "precision too big")?,
            });
        }
        if matches!(self.peek(vm)?, 'h' | 'l' | 'L') {
            self.at += 1;
        }
        let kind = self.peek(vm)?;
        self.at += 1;
        let value = self.value(vm)?;
        let size = field.width.saturating_add(field.precision.filter(|_| !matches!(kind, 's' | 'r' | 'a' | 'b')).unwrap_or(0));
        if size > 4096 {
            vm.reserve(size.saturating_mul(2))?;
            vm.charge(size as u64 / 64)?;
        }
        self.convert(vm, kind, &field, value)
    }

    /// `(key)`: the value is looked up, and there are no others from now on.
    fn key(&mut self, vm: &mut Vm<'_>) -> R<()> {
        let Some(mapping) = self.mapping else { return Err(vm.type_error("format requires a mapping")) };
        let start = self.at + 1;
        let mut depth = 0;
        let end = (self.at..self.template.len()).find(|&i| {
            match self.template[i] {
                '(' => depth += 1,
                ')' => depth -= 1,
                _ => {}
            }
            depth == 0
        });
        let Some(end) = end else { return Err(vm.value_error("incomplete format key")) };
        let key = if self.of_bytes {
            let bytes: Vec<u8> = self.template[start..end].iter().map(|c| *c as u8).collect();
            Value::Bytes(vm.heap.alloc(Bytes(bytes.into())))
        } else {
            vm.new_str(self.template[start..end].iter().collect::<String>())
        };
        self.at = end + 1;
        self.values = vec![vm.get_item(mapping, key)?];
        self.next = 0;
        Ok(())
    }

    fn star(&mut self, vm: &mut Vm<'_>) -> R<i64> {
        self.at += 1;
        let value = self.value(vm)?;
        let value = vm.plain(value);
        if numbers::int_value(value).is_none() {
            return Err(vm.type_error("* wants int"));
        }
        let value = vm.pin(value);
        vm.index(value)
    }

    fn digits(&mut self, vm: &mut Vm<'_>, most: usize, too_big: &str) -> R<usize> {
        let mut number = 0usize;
        while let Some(digit) = self.template.get(self.at).and_then(|c| c.to_digit(10)) {
            self.at += 1;
            number = match number.checked_mul(10).and_then(|n| n.checked_add(digit as usize)).filter(|n| *n <= most) {
                Some(n) => n,
                None => return Err(vm.value_error(too_big)),
            };
        }
        Ok(number)
    }

    fn convert(&mut self, vm: &mut Vm<'_>, kind: char, field: &Field, value: Value) -> R<()> {
        match kind {
            'd' | 'i' | 'u' | 'o' | 'x' | 'X' => {
                let (prefix, digits, negative) = self.int(vm, kind, field, value)?;
                self.put_number(field, negative, prefix, &digits);
            }
            'e' | 'E' | 'f' | 'F' | 'g' | 'G' => {
                let x = self.float(vm, value)?;
                let wishes = float::Wishes { alternate: field.alternate, ..Default::default() };
                let mut text = float::write(x, style(kind, Some(field.precision.unwrap_or(6))), wishes);
                if kind.is_ascii_uppercase() {
                    text.make_ascii_uppercase();
                }
                let body = text.strip_prefix('-');
                self.put_number(field, body.is_some(), "", body.unwrap_or(&text));
            }
            'c' => {
                let c = if self.of_bytes { self.byte(vm, value)? } else { self.character(vm, value)? };
                self.put_text(field, None, &c.to_string());
            }
            's' | 'b' if self.of_bytes => {
                let bytes = bytes_of(vm, value)?;
                let text: String = bytes.iter().map(|b| char::from(*b)).collect();
                self.put_text(field, field.precision, &text);
            }
            's' => {
                let text = vm.str(value)?;
                self.put_text(field, field.precision, &text);
            }
            'r' | 'a' => {
                let repr = vm.repr(value)?;
                let text = if kind == 'a' || self.of_bytes { quote::ascii(&repr) } else { repr };
                self.put_text(field, field.precision, &text);
            }
            _ => {
                let shown = if ('\x1f'..'\x7f').contains(&kind) { kind } else { '?' };
                let message = format!("unsupported format character '{shown}' ({:#x}) at index {}", kind as u32, self.at - 1);
                return Err(vm.value_error(message));
            }
        }
        Ok(())
    }

    fn int(&mut self, vm: &mut Vm<'_>, kind: char, field: &Field, value: Value) -> R<(&'static str, String, bool)> {
        let based = matches!(kind, 'o' | 'x' | 'X');
        let value = vm.pin(vm.plain(value));
        let int = match (numbers::int_value(value), value) {
            (Some(int), _) => int,
            (None, Value::Float(..)) if !based => vm.call(Builtin::Int.value(), &[value])?,
            (None, Value::Instance(_)) if based && vm.special(value, sym::INDEX).is_some() => {
                let index = vm.index_big(value)?;
                vm.heap.big(index)
            }
            (None, Value::Instance(_)) if !based && [sym::INT, sym::INDEX].into_iter().any(|s| vm.special(value, s).is_some()) => {
                vm.call(Builtin::Int.value(), &[value])?
            }
            _ => {
                let (class, wanted) = (vm.type_name(value), if based { "an integer" } else { "a real number" });
                let kind = if self.of_bytes && kind == 'i' { 'd' } else { kind };
                return Err(vm.type_error(format!("%{kind} format: {wanted} is required, not {class}")));
            }
        };
        let int = vm.plain(int);
        let Some(big) = numbers::to_big(vm, int).map(|b| b.into_owned()) else { return Ok(("", String::new(), false)) };
        vm.charge(big.bits() / 8)?;
        let (prefix, mut digits) = digits_of(&big, if based { kind } else { 'd' }).map_err(|e: FormatError| e.raise(vm))?;
        if let Some(missing) = field.precision.and_then(|p| p.checked_sub(digits.len())) {
            digits.insert_str(0, &"0".repeat(missing));
        }
        Ok((if field.alternate { prefix } else { "" }, digits, big.is_negative()))
    }

    fn float(&self, vm: &mut Vm<'_>, value: Value) -> R<f64> {
        let real = matches!(value, Value::Int(..) | Value::Float(..) | Value::Bool(_) | Value::Big(_) | Value::Instance(_));
        if self.of_bytes && !real {
            let class = vm.type_name(value);
            return Err(vm.type_error(format!("float argument required, not {class}")));
        }
        vm.as_float(value)
    }

    fn character(&self, vm: &mut Vm<'_>, value: Value) -> R<char> {
        let value = vm.plain(value);
        if let Value::Str(r) = value {
            let mut chars = vm.text(r).chars();
            if let (Some(c), None) = (chars.next(), chars.next()) {
                return Ok(c);
            }
        } else if numbers::int_value(value).is_some() || matches!(value, Value::Instance(_)) && vm.special(value, sym::INDEX).is_some() {
            let code = vm.index_big(value)?;
            return match u32::try_from(&code).ok().filter(|c| *c < 0x110000) {
                Some(code) => Ok(char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER)),
                None => Err(vm.error(Builtin::OverflowError, "%c arg not in range(0x110000)".into())),
            };
        }
        Err(vm.type_error("%c requires int or char"))
    }

    fn byte(&self, vm: &mut Vm<'_>, value: Value) -> R<char> {
        let value = vm.plain(value);
        let bytes: Option<&[u8]> = match value {
            Value::Bytes(r) => Some(&vm.heap[r].0),
            Value::ByteArray(r) => Some(&vm.heap[r].0),
            _ => None,
        };
        if let Some([byte]) = bytes {
            return Ok(char::from(*byte));
        }
        if numbers::int_value(value).is_some() || matches!(value, Value::Instance(_)) && vm.special(value, sym::INDEX).is_some() {
            let code = vm.index_big(value)?;
            return match u8::try_from(&code) {
                Ok(code) => Ok(char::from(code)),
                Err(_) => Err(vm.error(Builtin::OverflowError, "%c arg not in range(256)".into())),
            };
        }
        Err(vm.type_error("%c requires an integer in range(256) or a single byte"))
    }

    fn put_number(&mut self, field: &Field, negative: bool, prefix: &str, digits: &str) {
        let sign = match field {
            _ if negative => "-",
            Field { plus: true, .. } => "+",
            Field { blank: true, .. } => " ",
            _ => "",
        };
        let missing = field.width.saturating_sub(sign.len() + prefix.len() + digits.len());
        let (before, zeros, after) = match (field.left, field.zero) {
            (true, _) => (0, 0, missing),
            (false, true) => (0, missing, 0),
            (false, false) => (missing, 0, 0),
        };
        self.fill(' ', before);
        self.out.push_str(sign);
        self.out.push_str(prefix);
        self.fill('0', zeros);
        self.out.push_str(digits);
        self.fill(' ', after);
    }

    fn put_text(&mut self, field: &Field, most: Option<usize>, text: &str) {
        let kept = most.and_then(|n| text.char_indices().nth(n)).map_or(text, |(end, _)| &text[..end]);
        let missing = if field.width == 0 { 0 } else { field.width.saturating_sub(kept.chars().count()) };
        if !field.left {
            self.fill(' ', missing);
        }
        self.out.push_str(kept);
        if field.left {
            self.fill(' ', missing);
        }
    }

    fn fill(&mut self, c: char, count: usize) {
        self.out.extend(std::iter::repeat_n(c, count));
    }
}

/// The bytes that `%b` takes.
fn bytes_of(vm: &mut Vm<'_>, value: Value) -> R<Vec<u8>> {
    match vm.plain(value) {
        Value::Bytes(r) => Ok(vm.heap[r].0.to_vec()),
        Value::ByteArray(r) => Ok(vm.heap[r].0.clone()),
        _ => match vm.special(value, sym::BYTES) {
            Some(method) => {
                let made = vm.call(method, &[])?;
                match vm.plain(made) {
                    Value::Bytes(r) => Ok(vm.heap[r].0.to_vec()),
                    other => {
                        let class = vm.type_name(other);
                        Err(vm.type_error(format!("__bytes__ returned non-bytes (type {class})")))
                    }
                }
            }
            None => {
                let class = vm.type_name(value);
                Err(vm.type_error(format!("%b requires a bytes-like object, or an object that implements __bytes__, not '{class}'")))
            }
        },
    }
}
