//! `find`, `count`, `replace`, `startswith` and their like.

use super::{text_arg, this};
use crate::python::error::R;
use crate::python::heap::{Ref, Str};
use crate::python::native::Args;
use crate::python::types::search;
use crate::python::value::Value;
use crate::python::vm::Vm;

impl Str {
    /// The byte at which a character stands; the length of the text for one behind it.
    fn byte_at(&self, position: usize) -> usize {
        if self.is_ascii() {
            return position.min(self.text.len());
        }
        self.text.char_indices().nth(position).map_or(self.text.len(), |(at, _)| at)
    }

    /// The character that begins at a byte.
    fn character_at(&self, byte: usize) -> usize {
        if self.is_ascii() { byte } else { self.text[..byte].chars().count() }
    }
}

/// The part of the receiver that `start` and `end` leave, in bytes; `None` where `start` lies behind `end`.
fn window(vm: &mut Vm<'_>, text: Ref<Str>, args: &Args<'_>) -> R<Option<(usize, usize)>> {
    let (start, end) = search::range(vm, args, 2, vm.heap[text].chars)?;
    vm.charge(vm.heap[text].text.len() as u64 / 32)?;
    if start > end {
        return Ok(None);
    }
    let text = &vm.heap[text];
    Ok(Some((text.byte_at(start), text.byte_at(end))))
}

fn locate(vm: &mut Vm<'_>, args: &Args<'_>, last: bool) -> R<Option<i64>> {
    let text = this(vm, args)?;
    let piece = text_arg(vm, args.at(1), "must be str")?;
    let Some((start, end)) = window(vm, text, args)? else { return Ok(None) };
    let (text, piece) = (&vm.heap[text], vm.text(piece));
    let found = search::find(&text.text.as_bytes()[start..end], piece.as_bytes(), last);
    Ok(found.map(|at| text.character_at(start + at) as i64))
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
        None => Err(vm.value_error("substring not found")),
    }
}

pub(super) fn rindex(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    match locate(vm, &args, true)? {
        Some(at) => Ok(Value::int(at)),
        None => Err(vm.value_error("substring not found")),
    }
}

pub(super) fn count(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let piece = text_arg(vm, args.at(1), "must be str")?;
    let Some((start, end)) = window(vm, text, &args)? else { return Ok(Value::int(0)) };
    let (part, piece) = (&vm.text(text)[start..end], vm.text(piece));
    let count =
        if piece.is_empty() { part.chars().count() + 1 } else { memchr::memmem::find_iter(part.as_bytes(), piece.as_bytes()).count() };
    Ok(Value::int(count as i64))
}

fn affix(vm: &mut Vm<'_>, args: &Args<'_>, name: &str, matches: fn(&str, &str) -> bool) -> R<Value> {
    let text = this(vm, args)?;
    let candidates = match vm.plain(args.at(1)) {
        Value::Tuple(t) => vm.heap[t].0.to_vec(),
        Value::Str(s) => vec![Value::Str(s)],
        _ => {
            let class = vm.type_name(args.at(1));
            return Err(vm.type_error(format!("{name} first arg must be str or a tuple of str, not {class}")));
        }
    };
    let window = window(vm, text, args)?;
    for candidate in candidates {
        let piece = text_arg(vm, candidate, &format!("tuple for {name} must only contain str"))?;
        vm.charge(1)?;
        if let Some((start, end)) = window
            && matches(&vm.text(text)[start..end], vm.text(piece))
        {
            return Ok(Value::Bool(true));
        }
    }
    Ok(Value::Bool(false))
}

pub(super) fn startswith(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    affix(vm, &args, "startswith", |text, piece| text.starts_with(piece))
}

pub(super) fn endswith(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    affix(vm, &args, "endswith", |text, piece| text.ends_with(piece))
}

pub(super) fn replace(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let old = text_arg(vm, args.at(1), "replace() argument 1 must be str")?;
    let new = text_arg(vm, args.at(2), "replace() argument 2 must be str")?;
    let most = search::limit(vm, args.get(3))?;
    vm.charge(vm.heap[text].text.len() as u64 / 16)?;
    let (source, piece) = (vm.text(text), vm.text(old));
    let places: Vec<usize> = if piece.is_empty() {
        source.char_indices().map(|(at, _)| at).chain([source.len()]).take(most).collect()
    } else {
        search::places(source.as_bytes(), piece.as_bytes(), most)
    };
    if places.is_empty() {
        return Ok(Value::Str(text));
    }
    let size = source.len().saturating_add(places.len().saturating_mul(vm.text(new).len()));
    vm.reserve(size)?;
    vm.charge(places.len() as u64 + size as u64 / 64)?;
    let (source, skipped, new) = (vm.text(text), vm.text(old).len(), vm.text(new));
    let mut out = String::with_capacity(size);
    let mut at = 0;
    for place in places {
        out.push_str(&source[at..place]);
        out.push_str(new);
        at = place + skipped;
    }
    out.push_str(&source[at..]);
    Ok(vm.new_str(out))
}
