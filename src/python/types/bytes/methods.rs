//! Searching bytes, and changing them byte by byte: only ASCII letters have a case.

use super::{Receiver, buffer, byte, content, make, this};
use crate::python::error::R;
use crate::python::heap::Bytes;
use crate::python::native::Args;
use crate::python::numbers;
use crate::python::types::search;
use crate::python::value::Value;
use crate::python::vm::Vm;

/// A piece to look for: bytes, or an int for a byte.
fn piece(vm: &mut Vm<'_>, value: Value) -> R<Vec<u8>> {
    let plain = vm.plain(value);
    if let Some(data) = content(vm, plain) {
        return Ok(data.to_vec());
    }
    if numbers::int_value(plain).is_some() {
        return Ok(vec![byte(vm, plain, "byte")?]);
    }
    let class = vm.type_name(value);
    Err(vm.type_error(format!("argument should be integer or bytes-like object, not '{class}'")))
}

fn locate(vm: &mut Vm<'_>, args: &Args<'_>, last: bool) -> R<Option<i64>> {
    let Receiver { data, .. } = this(vm, args)?;
    let piece = piece(vm, args.at(1))?;
    let (start, end) = search::range(vm, args, 2, data.len())?;
    if start > end {
        return Ok(None);
    }
    Ok(search::find(&data[start..end], &piece, last).map(|at| (start + at) as i64))
}

pub(super) fn find(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::int(locate(vm, &args, false)?.unwrap_or(-1)))
}

pub(super) fn rfind(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::int(locate(vm, &args, true)?.unwrap_or(-1)))
}

pub(super) fn index(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    match locate(vm, &args, false)? {
        Some(at) => Ok(Value::int(at)),
        None => Err(vm.value_error("subsection not found")),
    }
}

pub(super) fn rindex(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    match locate(vm, &args, true)? {
        Some(at) => Ok(Value::int(at)),
        None => Err(vm.value_error("subsection not found")),
    }
}

pub(super) fn count(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Receiver { data, .. } = this(vm, &args)?;
    let piece = piece(vm, args.at(1))?;
    let (start, end) = search::range(vm, &args, 2, data.len())?;
    if start > end {
        return Ok(Value::int(0));
    }
    let count = if piece.is_empty() { end - start + 1 } else { memchr::memmem::find_iter(&data[start..end], &piece).count() };
    Ok(Value::int(count as i64))
}

fn affix(vm: &mut Vm<'_>, args: &Args<'_>, name: &str, matches: fn(&[u8], &[u8]) -> bool) -> R<Value> {
    let Receiver { data, .. } = this(vm, args)?;
    let plain = vm.plain(args.at(1));
    let candidates = match plain {
        Value::Tuple(t) => vm.heap[t].0.to_vec(),
        _ if content(vm, plain).is_some() => vec![plain],
        _ => {
            let class = vm.type_name(args.at(1));
            return Err(vm.type_error(format!("{name} first arg must be bytes or a tuple of bytes, not {class}")));
        }
    };
    let (start, end) = search::range(vm, args, 2, data.len())?;
    for candidate in candidates {
        let piece = buffer(vm, candidate)?;
        vm.charge(1)?;
        if start <= end && matches(&data[start..end], &piece) {
            return Ok(Value::Bool(true));
        }
    }
    Ok(Value::Bool(false))
}

pub(super) fn startswith(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    affix(vm, &args, "startswith", |data, piece| data.starts_with(piece))
}

pub(super) fn endswith(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    affix(vm, &args, "endswith", |data, piece| data.ends_with(piece))
}

pub(super) fn replace(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let old = buffer(vm, args.at(1))?;
    let new = buffer(vm, args.at(2))?;
    let most = search::limit(vm, args.get(3))?;
    let data = &receiver.data;
    let places = if old.is_empty() { (0..=data.len()).take(most).collect() } else { search::places(data, &old, most) };
    let size = data.len().saturating_add(places.len().saturating_mul(new.len()));
    vm.reserve(size)?;
    vm.charge(places.len() as u64 + size as u64 / 64)?;
    let mut out = Vec::with_capacity(size);
    let mut at = 0;
    for place in places {
        out.extend_from_slice(&data[at..place]);
        out.extend_from_slice(&new);
        at = place + old.len();
    }
    out.extend_from_slice(&data[at..]);
    receiver.make(vm, out)
}

pub(super) fn translate(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    // The first parameter has no name in CPython.
    let [table, delete] = vm.bind("translate", Args { pos: &args.pos[1..], kw: args.kw }, ["", "delete"], 1)?;
    let table = match table.filter(|t| !t.is_none()) {
        Some(table) => Some(buffer(vm, table)?),
        None => None,
    };
    if table.as_ref().is_some_and(|t| t.len() != 256) {
        return Err(vm.value_error("translation table must be 256 characters long"));
    }
    let mut gone = [false; 256];
    if let Some(delete) = delete {
        buffer(vm, delete)?.into_iter().for_each(|b| gone[usize::from(b)] = true);
    }
    let kept = receiver.data.iter().filter(|b| !gone[usize::from(**b)]);
    let out = kept.map(|b| table.as_ref().map_or(*b, |t| t[usize::from(*b)])).collect();
    receiver.make(vm, out)
}

/// `bytes.maketrans(from, to)`: static, so that no receiver stands before its arguments.
pub(super) fn maketrans(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let from = buffer(vm, args.at(0))?;
    let to = buffer(vm, args.at(1))?;
    if from.len() != to.len() {
        return Err(vm.value_error("maketrans arguments must have same length"));
    }
    let mut table: Vec<u8> = (0..=255).collect();
    for (from, to) in from.into_iter().zip(to) {
        table[usize::from(from)] = to;
    }
    Ok(Value::Bytes(vm.heap.alloc(Bytes(table.into()))))
}

fn map(vm: &mut Vm<'_>, args: &Args<'_>, change: impl FnOnce(&mut [u8])) -> R<Value> {
    let mut receiver = this(vm, args)?;
    change(&mut receiver.data);
    let Receiver { data, array } = receiver;
    vm.reserve(data.len())?;
    Ok(make(vm, data, array))
}

pub(super) fn lower(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, <[u8]>::make_ascii_lowercase)
}

pub(super) fn upper(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, <[u8]>::make_ascii_uppercase)
}

pub(super) fn capitalize(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, |data| {
        data.make_ascii_lowercase();
        if let Some(first) = data.first_mut() {
            first.make_ascii_uppercase();
        }
    })
}

pub(super) fn title(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, |data| {
        let mut within = false;
        for byte in data {
            *byte = if within { byte.to_ascii_lowercase() } else { byte.to_ascii_uppercase() };
            within = byte.is_ascii_alphabetic();
        }
    })
}

pub(super) fn swapcase(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    map(vm, &args, |data| {
        for byte in data {
            *byte = if byte.is_ascii_lowercase() { byte.to_ascii_uppercase() } else { byte.to_ascii_lowercase() };
        }
    })
}

fn ask(vm: &mut Vm<'_>, args: &Args<'_>, question: impl FnOnce(&[u8]) -> bool) -> R<Value> {
    let receiver = this(vm, args)?;
    Ok(Value::Bool(question(&receiver.data)))
}

fn all(data: &[u8], kind: impl Fn(&u8) -> bool) -> bool {
    !data.is_empty() && data.iter().all(kind)
}

pub(super) fn isalnum(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |data| all(data, u8::is_ascii_alphanumeric))
}

pub(super) fn isalpha(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |data| all(data, u8::is_ascii_alphabetic))
}

pub(super) fn isascii(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, <[u8]>::is_ascii)
}

pub(super) fn isdigit(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |data| all(data, u8::is_ascii_digit))
}

pub(super) fn isspace(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |data| all(data, |b| matches!(b, b' ' | b'\t'..=b'\r')))
}

pub(super) fn islower(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |data| data.iter().any(u8::is_ascii_lowercase) && !data.iter().any(u8::is_ascii_uppercase))
}

pub(super) fn isupper(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |data| data.iter().any(u8::is_ascii_uppercase) && !data.iter().any(u8::is_ascii_lowercase))
}

pub(super) fn istitle(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    ask(vm, &args, |data| {
        let (mut within, mut cased) = (false, false);
        for byte in data {
            if byte.is_ascii_uppercase() && within || byte.is_ascii_lowercase() && !within {
                return false;
            }
            within = byte.is_ascii_alphabetic();
            cased |= within;
        }
        cased
    })
}

/// Pads to a width; `split` says how many of the missing bytes go before.
fn pad(vm: &mut Vm<'_>, args: &Args<'_>, name: &str, split: fn(usize, usize) -> usize) -> R<Value> {
    let receiver = this(vm, args)?;
    let width = vm.pin(args.at(1));
    let width = usize::try_from(vm.index(width)?).unwrap_or(0);
    let fill = match args.get(2) {
        None => b' ',
        Some(fill) => {
            let plain = vm.plain(fill);
            match content(vm, plain) {
                Some(&[fill]) => fill,
                _ => {
                    let class = vm.type_name(fill);
                    return Err(vm.type_error(format!("{name}() argument 2 must be a byte string of length 1, not {class}")));
                }
            }
        }
    };
    let missing = width.saturating_sub(receiver.data.len());
    vm.reserve(missing.saturating_add(receiver.data.len()))?;
    vm.charge(missing as u64 / 64)?;
    let before = split(missing, width);
    let mut out = vec![fill; before];
    out.extend_from_slice(&receiver.data);
    out.resize(out.len() + missing - before, fill);
    receiver.make(vm, out)
}

pub(super) fn center(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    pad(vm, &args, "center", crate::python::types::str::centered)
}

pub(super) fn ljust(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    pad(vm, &args, "ljust", |_, _| 0)
}

pub(super) fn rjust(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    pad(vm, &args, "rjust", |missing, _| missing)
}

pub(super) fn zfill(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let width = vm.pin(args.at(1));
    let width = usize::try_from(vm.index(width)?).unwrap_or(0);
    let missing = width.saturating_sub(receiver.data.len());
    vm.reserve(missing.saturating_add(receiver.data.len()))?;
    vm.charge(missing as u64 / 64)?;
    let mut out = receiver.data.clone();
    let sign = usize::from(matches!(out.first(), Some(b'+' | b'-')));
    out.splice(sign..sign, std::iter::repeat_n(b'0', missing));
    receiver.make(vm, out)
}

pub(super) fn expandtabs(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let [size] = vm.bind("expandtabs", Args { pos: &args.pos[1..], kw: args.kw }, ["tabsize"], 0)?;
    let size = match size {
        Some(size) => usize::try_from(vm.index(size)?).unwrap_or(0),
        None => 8,
    };
    let tabs = receiver.data.iter().filter(|b| **b == b'\t').count();
    let most = tabs.saturating_mul(size).saturating_add(receiver.data.len());
    vm.charge(most as u64 / 16)?;
    vm.reserve(most.saturating_mul(2))?;
    let out = crate::python::types::str::expand(&super::latin1(&receiver.data), size);
    receiver.make(vm, out.chars().map(|c| c as u8).collect())
}
