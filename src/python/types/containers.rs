//! What list, tuple, dict, set and range have in common: operators, comparison, repr, and the dunder methods that lead to them.

use super::{dict, list, range, set, slice, tuple};
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::iterate::VALUE;
use crate::python::native::Args;
use crate::python::symbols::sym;
use crate::python::value::{BinaryOp, CompareOp, Value};
use crate::python::vm::Vm;
use num_bigint::Sign;

/// `a op b` where a container is on either side; `None` for NotImplemented.
pub fn binary(vm: &mut Vm<'_>, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
    let (p, q) = (vm.plain(a), vm.plain(b));
    match (op, p, q) {
        (BinaryOp::Add, Value::List(x), Value::List(y)) => list::concat(vm, x, y).map(Some),
        (BinaryOp::Add, Value::Tuple(x), Value::Tuple(y)) => tuple::concat(vm, x, y).map(Some),
        (BinaryOp::Add, Value::List(_), _) => {
            let name = vm.type_name(b);
            Err(vm.type_error(format!("can only concatenate list (not \"{name}\") to list")))
        }
        (BinaryOp::Add, Value::Tuple(_), _) => {
            let name = vm.type_name(b);
            Err(vm.type_error(format!("can only concatenate tuple (not \"{name}\") to tuple")))
        }
        (BinaryOp::Mul, Value::List(_) | Value::Tuple(_), _) => repeat(vm, p, q).map(Some),
        (BinaryOp::Mul, _, Value::List(_) | Value::Tuple(_)) => repeat(vm, q, p).map(Some),
        (BinaryOp::Or, Value::Dict(_) | Value::Proxy(_), Value::Dict(_) | Value::Proxy(_)) => dict::union(vm, p, q),
        (BinaryOp::Or | BinaryOp::And | BinaryOp::Xor | BinaryOp::Sub, _, _) => set::binary(vm, op, p, q),
        _ => Ok(None),
    }
}

/// `a op= b` where `a` is a container that changes in place; `None` where it does not: then `a = a op b`.
pub fn inplace(vm: &mut Vm<'_>, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
    match (op, vm.plain(a)) {
        (BinaryOp::Add, Value::List(list)) => list::extend_with(vm, list, b)?,
        (BinaryOp::Mul, Value::List(list)) => {
            let count = repeat_count(vm, b)?;
            let len = vm.heap[list].0.len();
            if count <= 0 {
                vm.heap[list].0.clear();
            } else {
                reserve_repeat(vm, len, count)?;
                let items = vm.heap[list].0.clone();
                for _ in 1..if len == 0 { 1 } else { count } {
                    vm.list_extend(list, &items)?;
                }
            }
        }
        (BinaryOp::Or, Value::Dict(d)) => dict::update_from(vm, d, b)?,
        (BinaryOp::Or | BinaryOp::And | BinaryOp::Xor | BinaryOp::Sub, Value::Set(s)) => {
            let (Value::Set(other) | Value::FrozenSet(other)) = vm.plain(b) else { return Ok(None) };
            set::inplace(vm, op, s, other)?;
        }
        _ => return Ok(None),
    }
    Ok(Some(a))
}

/// How often to repeat a sequence.
pub(super) fn repeat_count(vm: &mut Vm<'_>, count: Value) -> R<i64> {
    let count = vm.pin(count);
    match count {
        Value::Int(n, _) => Ok(n),
        Value::Bool(b) => Ok(i64::from(b)),
        _ => {
            if matches!(count, Value::Float(..) | Value::Str(_))
                || (!matches!(count, Value::Big(_)) && vm.special(count, sym::INDEX).is_none())
            {
                let name = vm.type_name(count);
                return Err(vm.type_error(format!("can't multiply sequence by non-int of type '{name}'")));
            }
            let big = vm.index_big(count)?;
            i64::try_from(&big).map_err(|_| {
                let name = vm.type_name(count);
                vm.error(Builtin::OverflowError, format!("cannot fit '{name}' into an index-sized integer"))
            })
        }
    }
}

fn reserve_repeat(vm: &mut Vm<'_>, len: usize, count: i64) -> R<()> {
    let total = len.saturating_mul(count.max(0) as usize);
    vm.reserve(total.saturating_mul(VALUE))?;
    vm.charge(total as u64 / 32)
}

/// `sequence * count`
fn repeat(vm: &mut Vm<'_>, sequence: Value, count: Value) -> R<Value> {
    let count = repeat_count(vm, count)?;
    let items = match sequence {
        Value::List(l) => vm.heap[l].0.as_slice(),
        Value::Tuple(t) if count == 1 => return Ok(Value::Tuple(t)),
        Value::Tuple(t) => vm.heap[t].0.as_slice(),
        _ => return Ok(Value::None),
    }
    .to_vec();
    reserve_repeat(vm, items.len(), count)?;
    let times = if items.is_empty() { 0 } else { count.max(0) as usize };
    let items = items.repeat(times);
    Ok(if matches!(sequence, Value::List(_)) { vm.new_list(items) } else { vm.new_tuple(items) })
}

/// `a op b` of two containers of one kind; `None` for NotImplemented.
pub fn compare(vm: &mut Vm<'_>, op: CompareOp, a: Value, b: Value) -> R<Option<bool>> {
    let (p, q) = (vm.plain(a), vm.plain(b));
    match (p, q) {
        (Value::List(_), Value::List(_)) | (Value::Tuple(_), Value::Tuple(_)) => {
            vm.nested(" in comparison", |vm| compare_items(vm, op, p, q)).map(Some)
        }
        (Value::Dict(x), Value::Dict(y)) if op == CompareOp::Eq => vm.nested(" in comparison", |vm| dict::equal(vm, x, y)).map(Some),
        (Value::Dict(x), Value::Dict(y)) if op == CompareOp::Ne => {
            vm.nested(" in comparison", |vm| dict::equal(vm, x, y)).map(|e| Some(!e))
        }
        (Value::Proxy(x), _) if !matches!(vm.heap[x].0, Value::Class(_)) => {
            let inner = vm.heap[x].0;
            compare(vm, op, inner, q)
        }
        (_, Value::Proxy(y)) if !matches!(vm.heap[y].0, Value::Class(_)) => {
            let inner = vm.heap[y].0;
            compare(vm, op, p, inner)
        }
        (Value::Range(x), Value::Range(y)) => Ok(range::equal(&vm.heap[x], &vm.heap[y], op)),
        (Value::Slice(_), Value::Slice(_)) => {
            let verdict = slice::compare(vm, op, p, q)?;
            vm.truth(verdict).map(Some)
        }
        (Value::Set(_) | Value::FrozenSet(_) | Value::View(_), Value::Set(_) | Value::FrozenSet(_) | Value::View(_)) => {
            vm.nested(" in comparison", |vm| set::compare(vm, op, p, q))
        }
        _ => Ok(None),
    }
}

fn item_at(heap: &Heap, sequence: Value, i: usize) -> Option<Value> {
    match sequence {
        Value::List(l) => heap[l].0.get(i).copied(),
        Value::Tuple(t) => heap[t].0.get(i).copied(),
        _ => None,
    }
}

/// Lists and tuples: decided by the first items that differ, else by length.
fn compare_items(vm: &mut Vm<'_>, op: CompareOp, a: Value, b: Value) -> R<bool> {
    if matches!(op, CompareOp::Eq | CompareOp::Ne) && vm.len(a)? != vm.len(b)? {
        return Ok(op == CompareOp::Ne);
    }
    let mut i = 0;
    while let (Some(x), Some(y)) = (item_at(&vm.heap, a, i), item_at(&vm.heap, b, i)) {
        vm.charge(1)?;
        if !vm.eq(x, y)? {
            return match op {
                CompareOp::Eq => Ok(false),
                CompareOp::Ne => Ok(true),
                _ => {
                    let verdict = vm.compare(op, x, y)?;
                    vm.truth(verdict)
                }
            };
        }
        i += 1;
    }
    Ok(op.holds(vm.len(a)?.cmp(&vm.len(b)?)))
}

/// `repr(value)` of a container; `None` where it is none.
pub fn repr(vm: &mut Vm<'_>, value: Value) -> R<Option<String>> {
    let recursive = match value {
        Value::List(_) => "[...]",
        Value::Tuple(_) => "(...)",
        Value::Dict(_) => "{...}",
        Value::Set(_) => "set(...)",
        Value::FrozenSet(_) => "frozenset(...)",
        Value::View(_) | Value::Proxy(_) => "...",
        Value::Range(r) => return Ok(Some(range::repr(&vm.heap[r]))),
        Value::Slice(s) => return slice::repr(vm, s).map(Some),
        _ => return Ok(None),
    };
    if vm.repr_stack.iter().any(|v| v.is(value)) {
        return Ok(Some(recursive.into()));
    }
    vm.repr_stack.push(value);
    let text = vm.nested(" while getting the repr of an object", |vm| repr_of(vm, value));
    vm.repr_stack.pop();
    let text = text?;
    vm.reserve(text.len())?;
    Ok(Some(text))
}

fn repr_of(vm: &mut Vm<'_>, value: Value) -> R<String> {
    match value {
        Value::List(_) => joined(vm, value, "[", "]"),
        Value::Tuple(t) if vm.heap[t].0.len() == 1 => joined(vm, value, "(", ",)"),
        Value::Tuple(_) => joined(vm, value, "(", ")"),
        Value::Dict(d) => {
            let mut text = String::from("{");
            let mut position = 0;
            while let Some((at, entry)) = vm.heap[d].0.next_from(position) {
                vm.charge(1)?;
                if position > 0 {
                    text += ", ";
                }
                position = at + 1;
                text += &vm.repr(entry.key)?;
                text += ": ";
                text += &vm.repr(entry.value)?;
            }
            Ok(text + "}")
        }
        Value::Set(s) | Value::FrozenSet(s) => {
            let name = vm.type_name(value);
            let bare = matches!(value, Value::Set(_));
            if vm.heap[s].0.is_empty() {
                return Ok(format!("{name}()"));
            }
            let items = vm.collect(value)?;
            let items = vm.new_tuple(items);
            if bare { joined(vm, items, "{", "}") } else { joined(vm, items, &format!("{name}({{"), "})") }
        }
        Value::View(_) => {
            let name = vm.type_name(value);
            let items = vm.collect(value)?;
            let items = vm.new_list(items);
            joined(vm, items, &format!("{name}(["), "])")
        }
        Value::Proxy(p) => {
            let inner = dict::of_proxy(vm, p);
            let text = vm.repr(inner)?;
            Ok(format!("mappingproxy({text})"))
        }
        _ => Ok(String::new()),
    }
}

fn joined(vm: &mut Vm<'_>, sequence: Value, open: &str, close: &str) -> R<String> {
    let mut text = String::from(open);
    let mut i = 0;
    while let Some(item) = item_at(&vm.heap, sequence, i) {
        vm.charge(1)?;
        if i > 0 {
            text += ", ";
        }
        text += &vm.repr(item)?;
        i += 1;
    }
    Ok(text + close)
}

/// All items of an iterable; `None` where it is none.
pub fn try_collect(vm: &mut Vm<'_>, value: Value) -> R<Option<Vec<Value>>> {
    if matches!(value, Value::List(_) | Value::Tuple(_)) {
        return vm.collect(value).map(Some);
    }
    match vm.iter(value) {
        Ok(iter) => vm.collect(iter).map(Some),
        Err(Raise::Exception(e)) if vm.is_instance(e, Builtin::TypeError) => Ok(None),
        Err(other) => Err(other),
    }
}

/// `start` and `stop` of `sequence.index(value, start, stop)`.
pub fn search_range(vm: &mut Vm<'_>, args: &Args<'_>, len: usize) -> R<(usize, usize)> {
    let mut place = |i: usize, default: usize| -> R<usize> {
        let Some(value) = args.get(i) else { return Ok(default) };
        let value = vm.pin(value);
        if matches!(value, Value::None | Value::Float(..) | Value::Str(_))
            || (value.index().is_some() && !matches!(value, Value::Big(_)) && vm.special(value, sym::INDEX).is_none())
        {
            return Err(vm.type_error("slice indices must be integers or have an __index__ method"));
        }
        let big = vm.index_big(value)?;
        let at = i64::try_from(&big).unwrap_or(if big.sign() == Sign::Minus { i64::MIN + 1 } else { i64::MAX });
        Ok(if at < 0 { at.saturating_add(len as i64).max(0) as usize } else { at as usize })
    };
    Ok((place(2, 0)?, place(3, usize::MAX)?))
}

/// `self.__len__()`
pub fn method_len(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::int(vm.len(args.at(0))? as i64))
}

/// `self.__contains__(item)`
pub fn method_contains(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::Bool(vm.contains(args.at(0), args.at(1))?))
}

/// `self.__getitem__(index)`
pub fn method_get_item(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    vm.get_item(args.at(0), args.at(1))
}

/// `self.__setitem__(index, value)`
pub fn method_set_item(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    vm.set_item(args.at(0), args.at(1), args.at(2))?;
    Ok(Value::None)
}

/// `self.__delitem__(index)`
pub fn method_del_item(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    vm.del_item(args.at(0), args.at(1))?;
    Ok(Value::None)
}

/// `self.__iter__()`
pub fn method_iter(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    vm.iter(args.at(0))
}

/// `self.__repr__()`
pub fn method_repr(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = repr(vm, args.at(0))?.unwrap_or_default();
    Ok(vm.new_str(text))
}

/// `self.__hash__()`
pub fn method_hash(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::int(vm.hash(args.at(0))?))
}

/// `self.__add__(other)` and its like.
pub fn method_binary(vm: &mut Vm<'_>, op: BinaryOp, args: Args<'_>) -> R<Value> {
    Ok(binary(vm, op, args.at(0), args.at(1))?.unwrap_or(Value::NotImplemented))
}

/// `self.__ror__(other)` and its like.
pub fn method_reflected(vm: &mut Vm<'_>, op: BinaryOp, args: Args<'_>) -> R<Value> {
    Ok(binary(vm, op, args.at(1), args.at(0))?.unwrap_or(Value::NotImplemented))
}

/// `self.__iadd__(other)` and its like.
pub fn method_inplace(vm: &mut Vm<'_>, op: BinaryOp, args: Args<'_>) -> R<Value> {
    Ok(inplace(vm, op, args.at(0), args.at(1))?.unwrap_or(Value::NotImplemented))
}

/// `self.__eq__(other)` and its like.
pub fn method_compare(vm: &mut Vm<'_>, op: CompareOp, args: Args<'_>) -> R<Value> {
    Ok(compare(vm, op, args.at(0), args.at(1))?.map_or(Value::NotImplemented, Value::Bool))
}

/// `list[int]`
pub fn method_class_getitem(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(vm.alias(args.at(0), args.at(1)))
}
