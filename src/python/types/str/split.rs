//! Taking texts apart and putting them together: `split`, `partition`, `strip`, `join` and their like.

use super::{text_arg, this};
use crate::python::error::R;
use crate::python::heap::{Ref, Str};
use crate::python::native::Args;
use crate::python::text::unicode;
use crate::python::types::{containers, search};
use crate::python::value::Value;
use crate::python::vm::Vm;
use std::ops::Range;

/// Parts of a text as a list of strings.
fn list_of(vm: &mut Vm<'_>, text: Ref<Str>, parts: Vec<Range<usize>>) -> R<Value> {
    search::reserve_pieces(vm, parts.len(), vm.heap[text].text.len())?;
    let items = parts
        .into_iter()
        .map(|part| {
            let piece: Box<str> = vm.text(text)[part].into();
            vm.new_str(piece)
        })
        .collect();
    Ok(vm.new_list(items))
}

fn split_at(vm: &mut Vm<'_>, args: Args<'_>, name: &str, from_end: bool) -> R<Value> {
    let text = this(vm, &args)?;
    let [separator, most] = vm.bind(name, Args { pos: &args.pos[1..], kw: args.kw }, ["sep", "maxsplit"], 0)?;
    let most = search::limit(vm, most)?;
    vm.charge(vm.heap[text].text.len() as u64 / 16)?;
    let Some(separator) = separator.filter(|s| !s.is_none()) else {
        let parts = words(vm.text(text), most, from_end);
        return list_of(vm, text, parts);
    };
    let separator = text_arg(vm, separator, "must be str or None")?;
    let (source, piece) = (vm.text(text).as_bytes(), vm.text(separator).as_bytes());
    if piece.is_empty() {
        return Err(vm.value_error("empty separator"));
    }
    let places = if from_end { search::places_from_end(source, piece, most) } else { search::places(source, piece, most) };
    let mut parts = Vec::with_capacity(places.len() + 1);
    let mut start = 0;
    for place in places {
        parts.push(start..place);
        start = place + piece.len();
    }
    parts.push(start..source.len());
    list_of(vm, text, parts)
}

/// The words of a text, at most so many splits; what is left over stays as it is, but for the blanks at the side where splitting began.
fn words(text: &str, most: usize, from_end: bool) -> Vec<Range<usize>> {
    if text.is_ascii() && most == usize::MAX {
        return ascii_words(text.as_bytes());
    }
    let mut parts = Vec::new();
    let mut rest = 0..text.len();
    loop {
        let left = &text[rest.clone()];
        if from_end {
            rest.end = rest.start + left.trim_end_matches(unicode::is_space).len();
        } else {
            rest.start = rest.end - left.trim_start_matches(unicode::is_space).len();
        }
        if rest.is_empty() {
            break;
        }
        let left = &text[rest.clone()];
        let last = parts.len() == most;
        let part = if last {
            rest.clone()
        } else if from_end {
            let blank = left.char_indices().rev().find(|(_, c)| unicode::is_space(*c));
            rest.start + blank.map_or(0, |(at, c)| at + c.len_utf8())..rest.end
        } else {
            rest.start..left.find(unicode::is_space).map_or(rest.end, |at| rest.start + at)
        };
        if from_end {
            rest.end = part.start;
        } else {
            rest.start = part.end;
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

/// All words of an ASCII text.
fn ascii_words(text: &[u8]) -> Vec<Range<usize>> {
    let blank = |byte: &u8| matches!(byte, b'\t'..=b'\r' | 0x1C..=b' ');
    let mut parts = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..].iter().position(|b| !blank(b)).map(|n| at + n) {
        at = text[start..].iter().position(blank).map_or(text.len(), |n| start + n);
        parts.push(start..at);
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
    let text = this(vm, &args)?;
    let [keep] = vm.bind("splitlines", Args { pos: &args.pos[1..], kw: args.kw }, ["keepends"], 0)?;
    let keep = match keep {
        Some(keep) => vm.index(keep)? != 0,
        None => false,
    };
    vm.charge(vm.heap[text].text.len() as u64 / 16)?;
    let break_at = |rest: &[u8]| match rest {
        [b'\n'..=b'\r' | 0x1C..=0x1E, ..] => 1,
        [0xC2, 0x85, ..] => 2,
        [0xE2, 0x80, 0xA8 | 0xA9, ..] => 3,
        _ => 0,
    };
    let lines = search::lines(vm.text(text).as_bytes(), break_at);
    let parts = lines.into_iter().map(|(start, end, with_break)| start..if keep { with_break } else { end }).collect();
    list_of(vm, text, parts)
}

fn part_at(vm: &mut Vm<'_>, args: Args<'_>, last: bool) -> R<Value> {
    let text = this(vm, &args)?;
    let separator = text_arg(vm, args.at(1), "must be str")?;
    let (source, piece) = (vm.text(text), vm.text(separator));
    if piece.is_empty() {
        return Err(vm.value_error("empty separator"));
    }
    let (size, width) = (source.len(), piece.len());
    let found = search::find(source.as_bytes(), piece.as_bytes(), last);
    search::reserve_pieces(vm, 3, size)?;
    let parts = match found {
        Some(at) => [0..at, at..at + width, at + width..size],
        None if last => [0..0, 0..0, 0..size],
        None => [0..size, size..size, size..size],
    };
    let parts = parts.map(|part| {
        let piece = vm.text(text)[part].to_string();
        vm.new_str(piece)
    });
    Ok(vm.new_tuple(parts.as_slice()))
}

pub(super) fn partition(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    part_at(vm, args, false)
}

pub(super) fn rpartition(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    part_at(vm, args, true)
}

/// Strips characters from the ends.
fn strip_ends(vm: &mut Vm<'_>, args: Args<'_>, name: &str, left: bool, right: bool) -> R<Value> {
    let text = this(vm, &args)?;
    let set: Option<Vec<char>> = match args.get(1).filter(|c| !c.is_none()) {
        None => None,
        Some(chars) => match vm.plain(chars) {
            Value::Str(s) => Some(vm.text(s).chars().collect()),
            _ => return Err(vm.type_error(format!("{name} arg must be None or str"))),
        },
    };
    let source = vm.text(text);
    let gone = |c: char| match &set {
        Some(set) => set.contains(&c),
        None => unicode::is_space(c),
    };
    let mut part = source;
    if left {
        part = part.trim_start_matches(gone);
    }
    if right {
        part = part.trim_end_matches(gone);
    }
    let work = (source.len() - part.len()).saturating_mul(1 + set.as_ref().map_or(0, Vec::len) / 8);
    if part.len() == source.len() {
        return Ok(Value::Str(text));
    }
    let part = part.to_string();
    vm.charge(work as u64 / 8)?;
    Ok(vm.new_str(part))
}

pub(super) fn strip(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    strip_ends(vm, args, "strip", true, true)
}

pub(super) fn lstrip(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    strip_ends(vm, args, "lstrip", true, false)
}

pub(super) fn rstrip(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    strip_ends(vm, args, "rstrip", false, true)
}

pub(super) fn removeprefix(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let prefix = text_arg(vm, args.at(1), "removeprefix() argument must be str")?;
    let rest = vm.text(text).strip_prefix(vm.text(prefix)).map(str::to_string);
    Ok(rest.map_or(Value::Str(text), |rest| vm.new_str(rest)))
}

pub(super) fn removesuffix(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let suffix = text_arg(vm, args.at(1), "removesuffix() argument must be str")?;
    let rest = vm.text(text).strip_suffix(vm.text(suffix)).map(str::to_string);
    Ok(rest.map_or(Value::Str(text), |rest| vm.new_str(rest)))
}

pub(super) fn join(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let separator = this(vm, &args)?;
    let Some(items) = containers::try_collect(vm, args.at(1))? else { return Err(vm.type_error("can only join an iterable")) };
    let mut size = vm.heap[separator].text.len().saturating_mul(items.len());
    for (i, &item) in items.iter().enumerate() {
        let Value::Str(s) = vm.plain(item) else {
            let class = vm.type_name(item);
            return Err(vm.type_error(format!("sequence item {i}: expected str instance, {class} found")));
        };
        size = size.saturating_add(vm.heap[s].text.len());
    }
    if let &[only @ Value::Str(_)] = items.as_slice() {
        return Ok(only);
    }
    vm.charge(size as u64 / 32)?;
    vm.reserve(size)?;
    let mut out = String::with_capacity(size);
    for (i, &item) in items.iter().enumerate() {
        if i > 0 {
            out.push_str(vm.text(separator));
        }
        if let Value::Str(s) = vm.plain(item) {
            out.push_str(vm.text(s));
        }
    }
    Ok(vm.new_str(out))
}

#[cfg(test)]
mod tests {
    use super::words;

    fn split(text: &str, most: usize, from_end: bool) -> Vec<&str> {
        words(text, most, from_end).into_iter().map(|part| &text[part]).collect()
    }

    #[test]
    fn words_are_split_at_runs_of_blanks() {
        let text = "  a b\u{3000} c  ";
        assert_eq!(split(text, usize::MAX, false), ["a", "b", "c"]);
        assert_eq!(split(text, usize::MAX, true), ["a", "b", "c"]);
        assert_eq!(split(text, 1, false), ["a", "b\u{3000} c  "]);
        assert_eq!(split(text, 1, true), ["  a b", "c"]);
        assert_eq!(split(text, 0, false), ["a b\u{3000} c  "]);
        assert_eq!(split(text, 0, true), ["  a b\u{3000} c"]);
        assert_eq!(split(" \t", 5, false), [""; 0]);
    }
}
