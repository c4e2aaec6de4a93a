//! `list`: its constructor, operators and methods.

mod sort;

pub use sort::{sort_values, sorted};

use super::containers;
use super::slice;
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::iter::IterState;
use crate::python::iterate::VALUE;
use crate::python::native::{ANY, Args, Native};
use crate::python::value::{BinaryOp, CompareOp, Value};
use crate::python::vm::Vm;

/// The list that a method was called on.
fn this(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Ref<List>> {
    match vm.plain(args.at(0)) {
        Value::List(list) => Ok(list),
        other => {
            let name = vm.type_name(other);
            Err(vm.type_error(format!("descriptor requires a 'list' object but received a '{name}'")))
        }
    }
}

impl Vm<'_> {
    /// Appends to a list and counts its growth.
    #[inline]
    pub fn list_push(&mut self, list: Ref<List>, value: Value) -> R<()> {
        let items = &mut self.heap[list].0;
        if items.len() < items.capacity() {
            items.push(value);
            return Ok(());
        }
        let grown = items.len().max(4) * VALUE;
        self.reserve(grown)?;
        let items = &mut self.heap[list].0;
        let before = items.capacity();
        items.push(value);
        self.heap.bytes += (self.heap[list].0.capacity() - before) * VALUE;
        Ok(())
    }

    /// Appends many to a list.
    pub fn list_extend(&mut self, list: Ref<List>, values: &[Value]) -> R<()> {
        self.reserve(values.len() * VALUE)?;
        let items = &mut self.heap[list].0;
        let before = items.capacity();
        items.extend_from_slice(values);
        self.heap.bytes += (self.heap[list].0.capacity() - before) * VALUE;
        Ok(())
    }
}

/// `list(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if !args.kw.is_empty() {
        return Err(vm.type_error("list() takes no keyword arguments"));
    }
    let items = match *args.pos {
        [] => Vec::new(),
        [iterable] => vm.collect(iterable)?,
        _ => return Err(vm.type_error(format!("list expected at most 1 argument, got {}", args.pos.len()))),
    };
    Ok(vm.new_list(items))
}

/// `list.__init__(self, iterable)`: replaces what the list holds.
pub fn init(vm: &mut Vm<'_>, list: Ref<List>, args: Args<'_>) -> R<()> {
    let Value::List(made) = construct(vm, args)? else { return Ok(()) };
    let items = std::mem::take(&mut vm.heap[made].0);
    vm.heap[list].0 = items;
    Ok(())
}

/// `a + b`
pub fn concat(vm: &mut Vm<'_>, a: Ref<List>, b: Ref<List>) -> R<Value> {
    let len = vm.heap[a].0.len() + vm.heap[b].0.len();
    vm.reserve(len * VALUE)?;
    vm.charge(len as u64 / 16)?;
    let items = [vm.heap[a].0.as_slice(), vm.heap[b].0.as_slice()].concat();
    Ok(vm.new_list(items))
}

/// `list[slice] = value`
pub fn set_slice(vm: &mut Vm<'_>, list: Ref<List>, index: Ref<Slice>, value: Value) -> R<()> {
    let bounds = slice::bounds(vm, index)?;
    let plain = bounds.is_plain();
    let values = match containers::try_collect(vm, value)? {
        Some(values) => values,
        None if plain => return Err(vm.type_error("can only assign an iterable")),
        None => return Err(vm.type_error("must assign iterable to extended slice")),
    };
    vm.charge(values.len() as u64 / 16)?;
    let span = bounds.over(vm.heap[list].0.len());
    if plain {
        vm.reserve(values.len() * VALUE)?;
        let (items, start) = (&mut vm.heap[list].0, span.start as usize);
        let before = items.capacity();
        items.splice(start..start + span.len, values);
        vm.heap.bytes += vm.heap[list].0.capacity().saturating_sub(before) * VALUE;
        return Ok(());
    }
    if values.len() != span.len {
        return Err(vm.value_error(format!("attempt to assign sequence of size {} to extended slice of size {}", values.len(), span.len)));
    }
    for (i, value) in span.indices().zip(values) {
        vm.heap[list].0[i] = value;
    }
    Ok(())
}

/// `del list[slice]`
pub fn del_slice(vm: &mut Vm<'_>, list: Ref<List>, index: Ref<Slice>) -> R<()> {
    let span = slice::span(vm, index, vm.heap[list].0.len())?;
    vm.charge(vm.heap[list].0.len() as u64 / 64)?;
    let items = &mut vm.heap[list].0;
    if span.step == 1 {
        items.drain(span.start as usize..span.start as usize + span.len);
    } else if span.len > 0 {
        let (low, step) = if span.step > 0 {
            (span.start as usize, span.step as usize)
        } else {
            ((span.start + (span.len as isize - 1) * span.step) as usize, span.step.unsigned_abs())
        };
        let (mut at, high) = (0, low + (span.len - 1) * step);
        items.retain(|_| {
            let gone = at >= low && at <= high && (at - low).is_multiple_of(step);
            at += 1;
            !gone
        });
    }
    Ok(())
}

fn append(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = this(vm, &args)?;
    vm.list_push(list, args.at(1))?;
    Ok(Value::None)
}

fn extend(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = this(vm, &args)?;
    extend_with(vm, list, args.at(1))?;
    Ok(Value::None)
}

/// `list += iterable`
pub fn extend_with(vm: &mut Vm<'_>, list: Ref<List>, iterable: Value) -> R<()> {
    if matches!(iterable, Value::List(_) | Value::Tuple(_)) {
        let items = vm.collect(iterable)?;
        return vm.list_extend(list, &items);
    }
    vm.for_each(iterable, |vm, item| vm.list_push(list, item).map(|()| true))
}

fn insert(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = this(vm, &args)?;
    let index = vm.pin(args.at(1));
    let index = vm.index(index)?;
    let len = vm.heap[list].0.len();
    let place = if index < 0 { index.saturating_add(len as i64).max(0) as usize } else { (index as usize).min(len) };
    vm.charge((len - place) as u64 / 64)?;
    vm.list_push(list, Value::None)?;
    let items = &mut vm.heap[list].0;
    items.pop();
    items.insert(place, args.at(2));
    Ok(Value::None)
}

fn pop(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = this(vm, &args)?;
    let index = match args.get(1) {
        None => -1,
        Some(index) => {
            let index = vm.pin(index);
            vm.index(index)?
        }
    };
    let len = vm.heap[list].0.len();
    if len == 0 {
        return Err(vm.error(crate::python::classes::Builtin::IndexError, "pop from empty list".into()));
    }
    let place = if index < 0 { index.saturating_add(len as i64) } else { index };
    if place < 0 || place as usize >= len {
        return Err(vm.error(crate::python::classes::Builtin::IndexError, "pop index out of range".into()));
    }
    vm.charge((len - place as usize) as u64 / 64)?;
    Ok(vm.heap[list].0.remove(place as usize))
}

fn remove(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = this(vm, &args)?;
    let mut i = 0;
    while let Some(&item) = vm.heap[list].0.get(i) {
        vm.charge(1)?;
        if vm.eq(item, args.at(1))? {
            if i < vm.heap[list].0.len() {
                vm.heap[list].0.remove(i);
            }
            return Ok(Value::None);
        }
        i += 1;
    }
    Err(vm.value_error("list.remove(x): x not in list"))
}

fn index(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = this(vm, &args)?;
    let (start, stop) = containers::search_range(vm, &args, vm.heap[list].0.len())?;
    let mut i = start;
    while i < stop
        && let Some(&item) = vm.heap[list].0.get(i)
    {
        vm.charge(1)?;
        if vm.eq(item, args.at(1))? {
            return Ok(Value::int(i as i64));
        }
        i += 1;
    }
    let shown = vm.repr(args.at(1))?;
    Err(vm.value_error(format!("{shown} is not in list")))
}

fn count(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = this(vm, &args)?;
    let (mut i, mut n) = (0, 0);
    while let Some(&item) = vm.heap[list].0.get(i) {
        vm.charge(1)?;
        n += i64::from(vm.eq(item, args.at(1))?);
        i += 1;
    }
    Ok(Value::int(n))
}

fn reverse(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = this(vm, &args)?;
    vm.charge(vm.heap[list].0.len() as u64 / 16)?;
    vm.heap[list].0.reverse();
    Ok(Value::None)
}

fn copy(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = this(vm, &args)?;
    let items = vm.collect(Value::List(list))?;
    Ok(vm.new_list(items))
}

fn clear(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = this(vm, &args)?;
    vm.heap[list].0.clear();
    Ok(Value::None)
}

/// Methods of `list`.
pub const METHODS: &[Native] = &[
    Native::static_method("__new__", 1, ANY, |vm, a| super::object::new_builtin(vm, a, Builtin::List)).keywords(),
    Native::method("append", 1, 1, append),
    Native::method("extend", 1, 1, extend),
    Native::method("insert", 2, 2, insert),
    Native::method("pop", 0, 1, pop),
    Native::method("remove", 1, 1, remove),
    Native::method("index", 1, 3, index),
    Native::method("count", 1, 1, count),
    Native::method("reverse", 0, 0, reverse),
    Native::method("copy", 0, 0, copy),
    Native::method("clear", 0, 0, clear),
    Native::method("sort", 0, ANY, sort::sort).keywords(),
    Native::method("__init__", 0, ANY, |vm, args| {
        let list = this(vm, &args)?;
        init(vm, list, Args { pos: &args.pos[1..], kw: args.kw })?;
        Ok(Value::None)
    })
    .keywords(),
    Native::method("__len__", 0, 0, containers::method_len),
    Native::method("__contains__", 1, 1, containers::method_contains),
    Native::method("__getitem__", 1, 1, containers::method_get_item),
    Native::method("__setitem__", 2, 2, containers::method_set_item),
    Native::method("__delitem__", 1, 1, containers::method_del_item),
    Native::method("__iter__", 0, 0, containers::method_iter),
    Native::method("__reversed__", 0, 0, |vm, args| {
        let list = this(vm, &args)?;
        let left = vm.heap[list].0.len();
        Ok(vm.new_iter(IterState::ListReversed { list, left }))
    }),
    Native::method("__repr__", 0, 0, containers::method_repr),
    Native::method("__add__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Add, args)),
    Native::method("__mul__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Mul, args)),
    Native::method("__rmul__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Mul, args)),
    Native::method("__iadd__", 1, 1, |vm, args| containers::method_inplace(vm, BinaryOp::Add, args)),
    Native::method("__imul__", 1, 1, |vm, args| containers::method_inplace(vm, BinaryOp::Mul, args)),
    Native::method("__eq__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Eq, args)),
    Native::method("__ne__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ne, args)),
    Native::method("__lt__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Lt, args)),
    Native::method("__le__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Le, args)),
    Native::method("__gt__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Gt, args)),
    Native::method("__ge__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ge, args)),
    Native::class_method("__class_getitem__", 1, 1, containers::method_class_getitem),
];
