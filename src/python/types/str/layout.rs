//! Padding: `center`, `ljust`, `rjust`, `zfill`, `expandtabs`.

use super::this;
use crate::python::error::R;
use crate::python::native::Args;
use crate::python::value::Value;
use crate::python::vm::Vm;

/// A width or tab size among the arguments.
fn width_arg(vm: &mut Vm<'_>, value: Value) -> R<i64> {
    let value = vm.pin(value);
    vm.index(value)
}

/// The fill character.
fn fill_arg(vm: &mut Vm<'_>, args: &Args<'_>) -> R<char> {
    let Some(fill) = args.get(2) else { return Ok(' ') };
    let Value::Str(s) = vm.plain(fill) else {
        let class = vm.type_name(fill);
        return Err(vm.type_error(format!("The fill character must be a unicode character, not {class}")));
    };
    let mut chars = vm.text(s).chars();
    match (chars.next(), chars.next()) {
        (Some(fill), None) => Ok(fill),
        _ => Err(vm.type_error("The fill character must be exactly one character long")),
    }
}

/// Pads the receiver to a width; `split` says how many of the missing characters go before it.
fn pad(vm: &mut Vm<'_>, args: &Args<'_>, split: fn(usize, usize) -> usize) -> R<Value> {
    let text = this(vm, args)?;
    let width = usize::try_from(width_arg(vm, args.at(1))?).unwrap_or(0);
    let fill = fill_arg(vm, args)?;
    let missing = width.saturating_sub(vm.heap[text].chars);
    if missing == 0 {
        return Ok(Value::Str(text));
    }
    let size = missing.saturating_mul(fill.len_utf8()).saturating_add(vm.heap[text].text.len());
    vm.reserve(size)?;
    vm.charge(size as u64 / 64)?;
    let before = split(missing, width);
    let mut out = String::with_capacity(size);
    out.extend(std::iter::repeat_n(fill, before));
    out.push_str(vm.text(text));
    out.extend(std::iter::repeat_n(fill, missing - before));
    Ok(vm.new_str(out))
}

/// How many of the missing characters `center` puts before the text.
pub(in crate::python::types) fn centered(missing: usize, width: usize) -> usize {
    missing / 2 + (missing & width & 1)
}

pub(super) fn center(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    pad(vm, &args, centered)
}

pub(super) fn ljust(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    pad(vm, &args, |_, _| 0)
}

pub(super) fn rjust(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    pad(vm, &args, |missing, _| missing)
}

pub(super) fn zfill(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let width = usize::try_from(width_arg(vm, args.at(1))?).unwrap_or(0);
    let missing = width.saturating_sub(vm.heap[text].chars);
    if missing == 0 {
        return Ok(Value::Str(text));
    }
    vm.reserve(width.saturating_mul(2))?;
    vm.charge(width as u64 / 64)?;
    let source = vm.text(text);
    let sign = if source.starts_with(['+', '-']) { 1 } else { 0 };
    let mut out = String::with_capacity(source.len() + missing);
    out.push_str(&source[..sign]);
    out.extend(std::iter::repeat_n('0', missing));
    out.push_str(&source[sign..]);
    Ok(vm.new_str(out))
}

pub(super) fn expandtabs(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let [size] = vm.bind("expandtabs", Args { pos: &args.pos[1..], kw: args.kw }, ["tabsize"], 0)?;
    let size = match size {
        Some(size) => usize::try_from(width_arg(vm, size)?).unwrap_or(0),
        None => 8,
    };
    let tabs = vm.text(text).bytes().filter(|b| *b == b'\t').count();
    let most = tabs.saturating_mul(size).saturating_add(vm.heap[text].text.len());
    vm.charge(most as u64 / 16)?;
    vm.reserve(most)?;
    let made = expand(vm.text(text), size);
    Ok(vm.new_str(made))
}

/// Replaces tabs by blanks up to the next multiple of `size`.
pub(in crate::python::types) fn expand(text: &str, size: usize) -> String {
    let mut out = String::with_capacity(text.len());
    let mut column = 0;
    for c in text.chars() {
        match c {
            '\t' => {
                if size > 0 {
                    let blanks = size - column % size;
                    out.extend(std::iter::repeat_n(' ', blanks));
                    column += blanks;
                }
            }
            _ => {
                out.push(c);
                column = if matches!(c, '\n' | '\r') { 0 } else { column + 1 };
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{centered, expand};

    #[test]
    fn odd_padding_goes_where_cpython_puts_it() {
        assert_eq!([centered(3, 4), centered(3, 5), centered(2, 4), centered(1, 3)], [1, 2, 1, 1]);
    }

    #[test]
    fn tabs_reach_the_next_stop() {
        assert_eq!(expand("a\tbc\n\td", 4), "a   bc\n    d");
        assert_eq!(expand("a\tb", 0), "ab");
    }
}
