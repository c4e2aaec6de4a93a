//! `itertools`: its iterators as states, how they are made (`make.rs`), and what each gives next (here, and the combinatoric ones in
//! `choose.rs`).

mod choose;
mod make;

pub use choose::Choice;
pub use make::{ITEMS, chain, construct};

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::{Iter, List, Ref};
use crate::python::iter::IterState;
use crate::python::value::{BinaryOp, Value};
use crate::python::vm::Vm;
use std::mem::size_of;

/// Where an iterator of `itertools` stands.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum Tool {
    /// `function` None: `+`. `total` Undefined: not begun.
    Accumulate {
        iter: Value,
        function: Value,
        total: Value,
        initial: Option<Value>,
    },
    /// `current` Undefined: the next iterable is due.
    Chain {
        source: Value,
        current: Value,
    },
    Choose(Choice),
    Compress {
        data: Value,
        selectors: Value,
    },
    Count {
        next: Value,
        step: Value,
    },
    Cycle {
        iter: Value,
        saved: Vec<Value>,
        index: usize,
        ended: bool,
    },
    DropWhile {
        predicate: Value,
        iter: Value,
        dropped: bool,
    },
    FilterFalse {
        predicate: Value,
        iter: Value,
    },
    GroupBy {
        iter: Value,
        key: Value,
        target: Value,
        current_key: Value,
        current: Value,
        group: Option<Ref<Iter>>,
    },
    Grouper {
        parent: Ref<Iter>,
        target: Value,
    },
    Slice {
        iter: Value,
        taken: u64,
        next: u64,
        stop: Option<u64>,
        step: u64,
    },
    Pairwise {
        iter: Value,
        old: Value,
    },
    Repeat {
        value: Value,
        left: Option<u64>,
    },
    StarMap {
        function: Value,
        iter: Value,
    },
    TakeWhile {
        predicate: Value,
        iter: Value,
        over: bool,
    },
    ZipLongest {
        iters: Vec<Value>,
        fill: Value,
    },
    /// Reads from the shared buffer, and fills it from the source when it has come to its end.
    Tee {
        source: Value,
        buffer: Ref<List>,
        index: usize,
    },
}

impl Tool {
    /// Bytes beyond its own size.
    pub fn extra(&self) -> usize {
        match self {
            Tool::Cycle { saved, .. } => saved.capacity() * size_of::<Value>(),
            Tool::ZipLongest { iters, .. } => iters.capacity() * size_of::<Value>(),
            Tool::Choose(choice) => choice.extra(),
            _ => 0,
        }
    }

    /// The values it holds.
    pub fn children(&self, out: &mut Vec<Value>) {
        match self {
            Tool::Accumulate { iter, function, total, initial } => {
                out.extend([*iter, *function, *total]);
                out.extend(*initial);
            }
            Tool::Chain { source, current } => out.extend([*source, *current]),
            Tool::Choose(choice) => choice.children(out),
            Tool::Compress { data, selectors } => out.extend([*data, *selectors]),
            Tool::Count { next, step } => out.extend([*next, *step]),
            Tool::Cycle { iter, saved, .. } => {
                out.push(*iter);
                out.extend_from_slice(saved);
            }
            Tool::DropWhile { predicate, iter, .. } | Tool::FilterFalse { predicate, iter } | Tool::TakeWhile { predicate, iter, .. } => {
                out.extend([*predicate, *iter]);
            }
            Tool::GroupBy { iter, key, target, current_key, current, .. } => out.extend([*iter, *key, *target, *current_key, *current]),
            Tool::Grouper { parent, target } => out.extend([Value::Iter(*parent), *target]),
            Tool::Slice { iter, .. } => out.push(*iter),
            Tool::Pairwise { iter, old } => out.extend([*iter, *old]),
            Tool::Repeat { value, .. } => out.push(*value),
            Tool::StarMap { function, iter } => out.extend([*function, *iter]),
            Tool::ZipLongest { iters, fill } => {
                out.extend_from_slice(iters);
                out.push(*fill);
            }
            Tool::Tee { source, buffer, .. } => out.extend([*source, Value::List(*buffer)]),
        }
    }

    /// Its class.
    pub fn class(&self) -> Builtin {
        match self {
            Tool::Accumulate { .. } => Builtin::ToolAccumulate,
            Tool::Chain { .. } => Builtin::ToolChain,
            Tool::Choose(choice) => choice.class(),
            Tool::Compress { .. } => Builtin::ToolCompress,
            Tool::Count { .. } => Builtin::ToolCount,
            Tool::Cycle { .. } => Builtin::ToolCycle,
            Tool::DropWhile { .. } => Builtin::ToolDropwhile,
            Tool::FilterFalse { .. } => Builtin::ToolFilterfalse,
            Tool::GroupBy { .. } => Builtin::ToolGroupby,
            Tool::Grouper { .. } => Builtin::ToolGrouper,
            Tool::Slice { .. } => Builtin::ToolIslice,
            Tool::Pairwise { .. } => Builtin::ToolPairwise,
            Tool::Repeat { .. } => Builtin::ToolRepeat,
            Tool::StarMap { .. } => Builtin::ToolStarmap,
            Tool::TakeWhile { .. } => Builtin::ToolTakewhile,
            Tool::ZipLongest { .. } => Builtin::ToolZipLongest,
            Tool::Tee { .. } => Builtin::ToolTee,
        }
    }

    /// How many items are left, where that is known.
    pub fn length_hint(&self) -> Option<u64> {
        match self {
            Tool::Repeat { left, .. } => *left,
            _ => None,
        }
    }
}

/// `repr()` of `count` and `repeat`.
pub fn repr(vm: &mut Vm<'_>, iter: Value) -> R<String> {
    let Some(tool) = tool(vm, iter) else { return Ok(String::new()) };
    Ok(match tool {
        Tool::Count { next, step: Value::Int(1, _) } => format!("count({})", vm.repr(next)?),
        Tool::Count { next, step } => format!("count({}, {})", vm.repr(next)?, vm.repr(step)?),
        Tool::Repeat { value, left: None } => format!("repeat({})", vm.repr(value)?),
        Tool::Repeat { value, left: Some(left) } => format!("repeat({}, {left})", vm.repr(value)?),
        _ => String::new(),
    })
}

fn tool(vm: &Vm<'_>, iter: Value) -> Option<Tool> {
    match iter {
        Value::Iter(r) => match &vm.heap[r].0 {
            IterState::Tool(tool) => Some((**tool).clone()),
            _ => None,
        },
        _ => None,
    }
}

/// The tool at `r`, to change.
fn at<'a>(vm: &'a mut Vm<'_>, r: Ref<Iter>) -> Option<&'a mut Tool> {
    match &mut vm.heap[r].0 {
        IterState::Tool(tool) => Some(tool),
        _ => None,
    }
}

macro_rules! set {
    ($vm:expr, $r:expr, $variant:ident { $($field:ident = $value:expr),* }) => {
        if let Some(Tool::$variant { $($field,)* .. }) = at($vm, $r) {
            $(*$field = $value;)*
        }
    };
}

/// The next item.
pub fn next(vm: &mut Vm<'_>, r: Ref<Iter>) -> R<Option<Value>> {
    let Some(tool) = at(vm, r) else { return Ok(None) };
    match *tool {
        Tool::Choose(ref mut choice) => match choice.advance() {
            Some(items) => {
                vm.charge(items.len() as u64 / 4)?;
                Ok(Some(vm.new_tuple(items)))
            }
            None => Ok(None),
        },
        Tool::Count { next, step } => {
            let following = match (next, step) {
                (Value::Int(a, h), Value::Int(b, k)) if h.is_none() && k.is_none() && a.checked_add(b).is_some() => Value::int(a + b),
                _ => vm.binary(BinaryOp::Add, next, step)?,
            };
            set!(vm, r, Count { next = following });
            Ok(Some(next))
        }
        Tool::Repeat { value, ref mut left } => match left {
            None => Ok(Some(value)),
            Some(0) => Ok(None),
            Some(n) => {
                *n -= 1;
                Ok(Some(value))
            }
        },
        Tool::Chain { .. } => next_chained(vm, r),
        Tool::Slice { .. } => next_sliced(vm, r),
        Tool::Accumulate { iter, function, total, initial } => next_accumulated(vm, r, [iter, function, total], initial),
        Tool::Cycle { .. } => next_cycled(vm, r),
        Tool::Pairwise { iter, old } => next_pair(vm, r, iter, old),
        Tool::GroupBy { .. } => next_group(vm, r),
        Tool::Grouper { parent, target } => next_in_group(vm, r, parent, target),
        Tool::ZipLongest { .. } => next_zipped(vm, r),
        Tool::StarMap { function, iter } => {
            let Some(args) = vm.next_inner(iter)? else { return Ok(None) };
            let args = vm.collect(args)?;
            vm.call(function, &args).map(Some)
        }
        Tool::Tee { source, buffer, index } => {
            let item = match vm.heap[buffer].0.get(index) {
                Some(&item) => item,
                None => {
                    let Some(item) = vm.next_inner(source)? else { return Ok(None) };
                    vm.list_push(buffer, item)?;
                    item
                }
            };
            let following = index + 1;
            set!(vm, r, Tee { index = following });
            Ok(Some(item))
        }
        Tool::Compress { data, selectors } => loop {
            let Some(item) = vm.next_inner(data)? else { return Ok(None) };
            let Some(selector) = vm.next_inner(selectors)? else { return Ok(None) };
            vm.charge(1)?;
            if vm.truth(selector)? {
                return Ok(Some(item));
            }
        },
        Tool::FilterFalse { predicate, iter } => loop {
            let Some(item) = vm.next_inner(iter)? else { return Ok(None) };
            if !test(vm, predicate, item)? {
                return Ok(Some(item));
            }
        },
        Tool::DropWhile { predicate, iter, dropped } => loop {
            let Some(item) = vm.next_inner(iter)? else { return Ok(None) };
            if dropped || !test(vm, predicate, item)? {
                set!(vm, r, DropWhile { dropped = true });
                return Ok(Some(item));
            }
        },
        Tool::TakeWhile { predicate, iter, over } => {
            if over {
                return Ok(None);
            }
            let Some(item) = vm.next_inner(iter)? else { return Ok(None) };
            if test(vm, predicate, item)? {
                return Ok(Some(item));
            }
            set!(vm, r, TakeWhile { over = true });
            Ok(None)
        }
    }
}

/// Whether `predicate(item)` is true; a predicate None asks for the truth of the item.
fn test(vm: &mut Vm<'_>, predicate: Value, item: Value) -> R<bool> {
    vm.charge(1)?;
    if predicate.is_none() {
        return vm.truth(item);
    }
    let verdict = vm.call(predicate, &[item])?;
    vm.truth(verdict)
}

fn next_chained(vm: &mut Vm<'_>, r: Ref<Iter>) -> R<Option<Value>> {
    loop {
        let Some(&mut Tool::Chain { source, current }) = at(vm, r) else { return Ok(None) };
        if source.is_undefined() {
            return Ok(None);
        }
        vm.charge(1)?;
        if current.is_undefined() {
            let Some(iterable) = vm.next_inner(source)? else {
                set!(vm, r, Chain { source = Value::Undefined });
                return Ok(None);
            };
            let iter = vm.iter(iterable)?;
            set!(vm, r, Chain { current = iter });
            continue;
        }
        if let Some(item) = vm.next_inner(current)? {
            return Ok(Some(item));
        }
        set!(vm, r, Chain { current = Value::Undefined });
    }
}

fn next_sliced(vm: &mut Vm<'_>, r: Ref<Iter>) -> R<Option<Value>> {
    let Some(&mut Tool::Slice { iter, taken: mut count, next, stop, step }) = at(vm, r) else { return Ok(None) };
    if iter.is_undefined() {
        return Ok(None);
    }
    let mut item = None;
    if stop.is_none_or(|stop| count < stop || count < next) {
        while count < next {
            vm.charge(1)?;
            if vm.next_inner(iter)?.is_none() {
                set!(vm, r, Slice { iter = Value::Undefined });
                return Ok(None);
            }
            count += 1;
            set!(vm, r, Slice { taken = count });
        }
        if stop.is_none_or(|stop| count < stop) {
            item = vm.next_inner(iter)?;
        }
    }
    if item.is_none() {
        set!(vm, r, Slice { iter = Value::Undefined });
        return Ok(None);
    }
    let following = next.saturating_add(step);
    let following = stop.map_or(following, |stop| following.min(stop));
    let read = count + 1;
    set!(vm, r, Slice { taken = read, next = following });
    Ok(item)
}

fn next_accumulated(vm: &mut Vm<'_>, r: Ref<Iter>, [iter, function, total]: [Value; 3], first: Option<Value>) -> R<Option<Value>> {
    if let Some(first) = first {
        set!(vm, r, Accumulate { initial = None, total = first });
        return Ok(Some(first));
    }
    let Some(item) = vm.next_inner(iter)? else { return Ok(None) };
    let sum = if total.is_undefined() {
        item
    } else if function.is_none() {
        vm.binary(BinaryOp::Add, total, item)?
    } else {
        vm.call(function, &[total, item])?
    };
    set!(vm, r, Accumulate { total = sum });
    Ok(Some(sum))
}

fn next_cycled(vm: &mut Vm<'_>, r: Ref<Iter>) -> R<Option<Value>> {
    let Some(&mut Tool::Cycle { iter, ended, .. }) = at(vm, r) else { return Ok(None) };
    if !ended {
        if let Some(item) = vm.next_inner(iter)? {
            let mut grown = 0;
            if let Some(Tool::Cycle { saved, .. }) = at(vm, r) {
                let before = saved.capacity();
                saved.push(item);
                grown = (saved.capacity() - before) * size_of::<Value>();
            }
            vm.heap.bytes += grown;
            vm.reserve(grown)?;
            return Ok(Some(item));
        }
        set!(vm, r, Cycle { ended = true });
    }
    let Some(Tool::Cycle { saved, index, .. }) = at(vm, r) else { return Ok(None) };
    let item = saved.get(*index).copied();
    *index = if *index + 1 >= saved.len() { 0 } else { *index + 1 };
    Ok(item)
}

fn next_pair(vm: &mut Vm<'_>, r: Ref<Iter>, iter: Value, old: Value) -> R<Option<Value>> {
    let old = if old.is_undefined() {
        let Some(first) = vm.next_inner(iter)? else { return Ok(None) };
        set!(vm, r, Pairwise { old = first });
        first
    } else {
        old
    };
    let Some(new) = vm.next_inner(iter)? else { return Ok(None) };
    set!(vm, r, Pairwise { old = new });
    Ok(Some(vm.new_tuple([old, new].as_slice())))
}

/// Reads one more item of a `groupby`; false at the end.
fn step_group(vm: &mut Vm<'_>, r: Ref<Iter>) -> R<bool> {
    vm.charge(1)?;
    let Some(&mut Tool::GroupBy { iter, key, .. }) = at(vm, r) else { return Ok(false) };
    let Some(item) = vm.next_inner(iter)? else { return Ok(false) };
    let item_key = if key.is_none() { item } else { vm.call(key, &[item])? };
    set!(vm, r, GroupBy { current = item, current_key = item_key });
    Ok(true)
}

fn next_group(vm: &mut Vm<'_>, r: Ref<Iter>) -> R<Option<Value>> {
    set!(vm, r, GroupBy { group = None });
    loop {
        let Some(&mut Tool::GroupBy { target, current_key, .. }) = at(vm, r) else { return Ok(None) };
        if !current_key.is_undefined() && (target.is_undefined() || !vm.eq(target, current_key)?) {
            break;
        }
        if !step_group(vm, r)? {
            return Ok(None);
        }
    }
    let Some(&mut Tool::GroupBy { current_key, .. }) = at(vm, r) else { return Ok(None) };
    let grouper = vm.heap.alloc(Iter(IterState::Tool(Box::new(Tool::Grouper { parent: r, target: current_key }))));
    set!(vm, r, GroupBy { target = current_key, group = Some(grouper) });
    Ok(Some(vm.new_tuple([current_key, Value::Iter(grouper)].as_slice())))
}

fn next_in_group(vm: &mut Vm<'_>, r: Ref<Iter>, parent: Ref<Iter>, target: Value) -> R<Option<Value>> {
    let Some(&mut Tool::GroupBy { group, current, .. }) = at(vm, parent) else { return Ok(None) };
    if group != Some(r) || current.is_undefined() && !step_group(vm, parent)? {
        return Ok(None);
    }
    let Some(&mut Tool::GroupBy { current_key, .. }) = at(vm, parent) else { return Ok(None) };
    if !vm.eq(target, current_key)? {
        return Ok(None);
    }
    let Some(Tool::GroupBy { current, .. }) = at(vm, parent) else { return Ok(None) };
    let item = std::mem::replace(current, Value::Undefined);
    Ok((!item.is_undefined()).then_some(item))
}

fn next_zipped(vm: &mut Vm<'_>, r: Ref<Iter>) -> R<Option<Value>> {
    let mut row = smallvec::SmallVec::<[Value; 3]>::new();
    loop {
        let Some(Tool::ZipLongest { iters, fill }) = at(vm, r) else { return Ok(None) };
        let fill = *fill;
        let Some(&iter) = iters.get(row.len()) else { break };
        let item = if iter.is_undefined() { None } else { vm.next_inner(iter)? };
        if item.is_none()
            && !iter.is_undefined()
            && let Some(Tool::ZipLongest { iters, .. }) = at(vm, r)
        {
            iters[row.len()] = Value::Undefined;
            if iters.iter().all(|i| i.is_undefined()) {
                return Ok(None);
            }
        }
        row.push(item.unwrap_or(fill));
    }
    let Some(Tool::ZipLongest { iters, .. }) = at(vm, r) else { return Ok(None) };
    if iters.iter().all(|i| i.is_undefined()) {
        return Ok(None);
    }
    Ok(Some(vm.new_tuple(row)))
}
