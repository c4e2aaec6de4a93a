//! What the methods of `str` and `bytes` look for: pieces of bytes, and ranges of items.

use crate::python::error::R;
use crate::python::native::Args;
use crate::python::symbols::sym;
use crate::python::value::Value;
use crate::python::vm::Vm;
use memchr::memmem;
use num_bigint::Sign;

/// The first or the last place of a piece.
pub(super) fn find(text: &[u8], piece: &[u8], last: bool) -> Option<usize> {
    if last { memmem::rfind(text, piece) } else { memmem::find(text, piece) }
}

/// The places of a piece that is not empty, from the left, none over another.
pub(super) fn places(text: &[u8], piece: &[u8], most: usize) -> Vec<usize> {
    memmem::find_iter(text, piece).take(most).collect()
}

/// The places of a piece that is not empty, from the right, none over another, in the order of the text.
pub(super) fn places_from_end(text: &[u8], piece: &[u8], most: usize) -> Vec<usize> {
    let mut end = text.len();
    let mut found = Vec::new();
    while found.len() < most
        && let Some(at) = memmem::rfind(&text[..end], piece)
    {
        found.push(at);
        end = at;
    }
    found.reverse();
    found
}

/// What `splitlines` gives: where lines begin, where they end without their break, and where with it. `is_break` says how many bytes of
/// a break stand at a place.
pub(super) fn lines(text: &[u8], break_at: impl Fn(&[u8]) -> usize) -> Vec<(usize, usize, usize)> {
    let mut lines = Vec::new();
    let (mut start, mut at) = (0, 0);
    while at < text.len() {
        let length = if text[at..].starts_with(b"\r\n") { 2 } else { break_at(&text[at..]) };
        if length == 0 {
            at += 1;
            continue;
        }
        lines.push((start, at, at + length));
        at += length;
        start = at;
    }
    if start < text.len() {
        lines.push((start, text.len(), text.len()));
    }
    lines
}

/// `start` and `end` of `find`, `count`, `startswith`…, at the arguments `first` and the next; clipped to `len`, but `start` may lie behind it.
pub(super) fn range(vm: &mut Vm<'_>, args: &Args<'_>, first: usize, len: usize) -> R<(usize, usize)> {
    let start = bound(vm, args.get(first), 0, len)?;
    let end = bound(vm, args.get(first + 1), len, len)?;
    Ok((start, end.min(len)))
}

fn bound(vm: &mut Vm<'_>, value: Option<Value>, default: usize, len: usize) -> R<usize> {
    let Some(value) = value.filter(|v| !v.is_none()) else { return Ok(default) };
    let plain = vm.plain(value);
    let at = match vm.pin(plain) {
        Value::Int(v, _) => v,
        Value::Bool(b) => i64::from(b),
        Value::Big(r) => {
            if vm.heap[r].sign() == Sign::Minus {
                i64::MIN
            } else {
                i64::MAX
            }
        }
        Value::Instance(_) if vm.special(value, sym::INDEX).is_some() => {
            let big = vm.index_big(value)?;
            i64::try_from(&big).unwrap_or(if big.sign() == Sign::Minus { i64::MIN } else { i64::MAX })
        }
        _ => return Err(vm.type_error("slice indices must be integers or None or have an __index__ method")),
    };
    Ok(if at < 0 { at.saturating_add(len as i64).max(0) as usize } else { at as usize })
}

/// A count that is negative for "all": `maxsplit`, and the count of `replace`.
pub(super) fn limit(vm: &mut Vm<'_>, value: Option<Value>) -> R<usize> {
    let Some(value) = value else { return Ok(usize::MAX) };
    let value = vm.pin(value);
    Ok(usize::try_from(vm.index(value)?).unwrap_or(usize::MAX))
}

/// Asks for the memory of so many pieces of this total length, each an object of its own.
pub(super) fn reserve_pieces(vm: &mut Vm<'_>, count: usize, bytes: usize) -> R<()> {
    vm.charge((count + bytes / 16) as u64)?;
    vm.reserve(count.saturating_mul(80).saturating_add(bytes))
}
