//! Taking bytes apart and putting them together.

use super::{Receiver, buffer, content, this};
use crate::python::error::R;
use crate::python::native::Args;
use crate::python::types::{containers, search};
use crate::python::value::Value;
use crate::python::vm::Vm;
use std::ops::Range;

fn is_space(byte: &u8) -> bool {
    matches!(byte, b' ' | b'\t'..=b'\r')
}

fn list_of(vm: &mut Vm<'_>, receiver: &Receiver, parts: Vec<Range<usize>>) -> R<Value> {
    search::reserve_pieces(vm, parts.len(), receiver.data.len())?;
    let mut items = Vec::with_capacity(parts.len());
    for part in parts {
        items.push(receiver.make(vm, receiver.data[part].to_vec())?);
    }
    Ok(vm.new_list(items))
}

fn split_at(vm: &mut Vm<'_>, args: Args<'_>, name: &str, from_end: bool) -> R<Value> {
    let receiver = this(vm, &args)?;
    let [separator, most] = vm.bind(name, Args { pos: &args.pos[1..], kw: args.kw }, ["sep", "maxsplit"], 0)?;
    let most = search::limit(vm, most)?;
    let Some(separator) = separator.filter(|s| !s.is_none()) else {
        let parts = words(&receiver.data, most, from_end);
        return list_of(vm, &receiver, parts);
    };
    let piece = buffer(vm, separator)?;
    if piece.is_empty() {
        return Err(vm.value_error("empty separator"));
    }
    let data = &receiver.data;
    let places = if from_end { search::places_from_end(data, &piece, most) } else { search::places(data, &piece, most) };
    let mut parts = Vec::with_capacity(places.len() + 1);
    let mut start = 0;
    for place in places {
        parts.push(start..place);
        start = place + piece.len();
    }
    parts.push(start..data.len());
    list_of(vm, &receiver, parts)
}

/// The words, at most so many splits; what is left over stays as it is, but for the blanks at the side where splitting began.
fn words(data: &[u8], most: usize, from_end: bool) -> Vec<Range<usize>> {
    let mut parts = Vec::new();
    let mut rest = 0..data.len();
    loop {
        while !rest.is_empty() && is_space(&data[if from_end { rest.end - 1 } else { rest.start }]) {
            if from_end { rest.end -= 1 } else { rest.start += 1 }
        }
        if rest.is_empty() {
            break;
        }
        let left = &data[rest.clone()];
        let last = parts.len() == most;
        let part = if last {
            rest.clone()
        } else if from_end {
            rest.start + left.iter().rposition(is_space).map_or(0, |at| at + 1)..rest.end
        } else {
            rest.start..left.iter().position(is_space).map_or(rest.end, |at| rest.start + at)
        };
        if from_end {
            rest.end = part.start
        } else {
            rest.start = part.end
        }
        parts.push(part);
        if last {
            break;
        }
    }
    if from_end {
        parts.reverse();
    }
    parts
}

pub(super) fn split(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    split_at(vm, args, "split", false)
}

pub(super) fn rsplit(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    split_at(vm, args, "rsplit", true)
}

pub(super) fn splitlines(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let [keep] = vm.bind("splitlines", Args { pos: &args.pos[1..], kw: args.kw }, ["keepends"], 0)?;
    let keep = match keep {
        Some(keep) => vm.truth(keep)?,
        None => false,
    };
    let lines = search::lines(&receiver.data, |rest| usize::from(matches!(rest, [b'\n' | b'\r', ..])));
    let parts = lines.into_iter().map(|(start, end, with_break)| start..if keep { with_break } else { end }).collect();
    list_of(vm, &receiver, parts)
}

fn part_at(vm: &mut Vm<'_>, args: Args<'_>, last: bool) -> R<Value> {
    let receiver = this(vm, &args)?;
    let piece = buffer(vm, args.at(1))?;
    if piece.is_empty() {
        return Err(vm.value_error("empty separator"));
    }
    let size = receiver.data.len();
    let parts = match search::find(&receiver.data, &piece, last) {
        Some(at) => [0..at, at..at + piece.len(), at + piece.len()..size],
        None if last => [0..0, 0..0, 0..size],
        None => [0..size, size..size, size..size],
    };
    let mut items = Vec::with_capacity(3);
    for part in parts {
        items.push(receiver.make(vm, receiver.data[part].to_vec())?);
    }
    Ok(vm.new_tuple(items))
}

pub(super) fn partition(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    part_at(vm, args, false)
}

pub(super) fn rpartition(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    part_at(vm, args, true)
}

fn strip_ends(vm: &mut Vm<'_>, args: Args<'_>, left: bool, right: bool) -> R<Value> {
    let receiver = this(vm, &args)?;
    let mut set = [false; 256];
    match args.get(1).filter(|s| !s.is_none()) {
        Some(chars) => buffer(vm, chars)?.into_iter().for_each(|b| set[usize::from(b)] = true),
        None => (0..=255u8).filter(is_space).for_each(|b| set[usize::from(b)] = true),
    }
    let kept = |b: &u8| !set[usize::from(*b)];
    let data = &receiver.data;
    let start = if left { data.iter().position(kept).unwrap_or(data.len()) } else { 0 };
    let end = if right { data[start..].iter().rposition(kept).map_or(start, |at| start + at + 1) } else { data.len() };
    receiver.make(vm, data[start..end].to_vec())
}

pub(super) fn strip(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    strip_ends(vm, args, true, true)
}

pub(super) fn lstrip(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    strip_ends(vm, args, true, false)
}

pub(super) fn rstrip(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    strip_ends(vm, args, false, true)
}

pub(super) fn removeprefix(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let prefix = buffer(vm, args.at(1))?;
    let rest = receiver.data.strip_prefix(prefix.as_slice()).unwrap_or(&receiver.data).to_vec();
    receiver.make(vm, rest)
}

pub(super) fn removesuffix(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let suffix = buffer(vm, args.at(1))?;
    let rest = receiver.data.strip_suffix(suffix.as_slice()).unwrap_or(&receiver.data).to_vec();
    receiver.make(vm, rest)
}

pub(super) fn join(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let Some(items) = containers::try_collect(vm, args.at(1))? else { return Err(vm.type_error("can only join an iterable")) };
    let mut size = receiver.data.len().saturating_mul(items.len());
    for (i, &item) in items.iter().enumerate() {
        let plain = vm.plain(item);
        let Some(data) = content(vm, plain) else {
            let class = vm.type_name(item);
            return Err(vm.type_error(format!("sequence item {i}: expected a bytes-like object, {class} found")));
        };
        size = size.saturating_add(data.len());
    }
    vm.charge(size as u64 / 32)?;
    vm.reserve(size)?;
    let mut out = Vec::with_capacity(size);
    for (i, &item) in items.iter().enumerate() {
        if i > 0 {
            out.extend_from_slice(&receiver.data);
        }
        let plain = vm.plain(item);
        out.extend_from_slice(content(vm, plain).unwrap_or_default());
    }
    receiver.make(vm, out)
}
