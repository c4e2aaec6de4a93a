//! `range`: its constructor, indexing and methods.

use super::{containers, slice};
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::iterate;
use crate::python::native::{Args, Native};
use crate::python::value::{CompareOp, Value};
use crate::python::vm::Vm;
use num_bigint::BigInt;
use num_traits::ToPrimitive;

/// Methods of `slice`.
pub const SLICE: &[Native] = slice::METHODS;

/// Bounds stay below this, so that no sum of two overflows.
const LIMIT: i128 = 1 << 125;

fn too_large(vm: &mut Vm<'_>) -> Raise {
    vm.error(Builtin::OverflowError, "range() bounds beyond 125 bits are not supported".into())
}

fn bound(vm: &mut Vm<'_>, value: Value) -> R<i128> {
    match vm.pin(value) {
        Value::Int(v, _) => Ok(v.into()),
        other => match vm.index_big(other)?.to_i128() {
            Some(v) if v.abs() < LIMIT => Ok(v),
            _ => Err(too_large(vm)),
        },
    }
}

/// `range(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if !args.kw.is_empty() {
        return Err(vm.type_error("range() takes no keyword arguments"));
    }
    let range = match *args.pos {
        [stop] => Range { start: 0, stop: bound(vm, stop)?, step: 1 },
        [start, stop] => Range { start: bound(vm, start)?, stop: bound(vm, stop)?, step: 1 },
        [start, stop, step] => Range { start: bound(vm, start)?, stop: bound(vm, stop)?, step: bound(vm, step)? },
        [] => return Err(vm.type_error("range expected at least 1 argument, got 0")),
        _ => return Err(vm.type_error(format!("range expected at most 3 arguments, got {}", args.pos.len()))),
    };
    if range.step == 0 {
        return Err(vm.value_error("range() arg 3 must not be zero"));
    }
    Ok(Value::Range(vm.heap.alloc(range)))
}

fn this(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Range> {
    match args.at(0) {
        Value::Range(r) => Ok(vm.heap[r]),
        other => {
            let name = vm.type_name(other);
            Err(vm.type_error(format!("descriptor requires a 'range' object but received a '{name}'")))
        }
    }
}

/// `range[index]`
pub fn get_item(vm: &mut Vm<'_>, range: Ref<Range>, index: Value) -> R<Value> {
    let range = vm.heap[range];
    let len = range.len() as i128;
    if let Value::Slice(s) = index {
        let [start, stop, step] = slice::big_indices(vm, s, &len.into())?;
        let at = |i: BigInt| range.start + i * range.step;
        let (start, stop, step) = (at(start).to_i128(), at(stop).to_i128(), (step * range.step).to_i128());
        return match (start, stop, step) {
            (Some(start), Some(stop), Some(step)) if step.abs() < LIMIT => Ok(Value::Range(vm.heap.alloc(Range { start, stop, step }))),
            _ => Err(too_large(vm)),
        };
    }
    let place = match vm.pin(index) {
        Value::Int(i, _) if i < 0 => i as i128 + len,
        Value::Int(i, _) => i.into(),
        Value::Big(_) => vm.index_big(index)?.to_i128().map_or(-1, |i| if i.is_negative() { i + len } else { i }),
        _ => vm.position_in("range", index, usize::try_from(len).unwrap_or(usize::MAX >> 1))? as i128,
    };
    if place < 0 || place >= len {
        return Err(vm.error(Builtin::IndexError, "range object index out of range".into()));
    }
    Ok(vm.heap.big((range.start + place * range.step).into()))
}

/// Where a number stands in a range.
fn place(vm: &mut Vm<'_>, range: Range, item: Value) -> Option<i128> {
    let v: i128 = match vm.pin(item) {
        Value::Int(v, _) => v.into(),
        Value::Bool(b) => b.into(),
        Value::Big(b) => vm.heap[b].to_i128()?,
        Value::Float(v, _) if v.fract() == 0.0 && v.abs() < LIMIT as f64 => v as i128,
        _ => return None,
    };
    let inside = if range.step > 0 { v >= range.start && v < range.stop } else { v <= range.start && v > range.stop };
    (inside && (v - range.start) % range.step == 0).then(|| (v - range.start) / range.step)
}

/// `item in range`
pub fn contains(vm: &mut Vm<'_>, range: Ref<Range>, item: Value) -> R<bool> {
    match item {
        Value::Int(..) | Value::Bool(_) | Value::Big(_) | Value::Float(..) => {
            let range = vm.heap[range];
            Ok(place(vm, range, item).is_some())
        }
        Value::Str(_) | Value::None | Value::Tuple(_) | Value::List(_) => Ok(false),
        _ => vm.contains_by_iteration(Value::Range(range), item),
    }
}

/// `a == b`, `a != b`: the same numbers. `None` for the other operators.
pub fn equal(a: &Range, b: &Range, op: CompareOp) -> Option<bool> {
    let len = a.len();
    let same = len == b.len() && (len == 0 || a.start == b.start && (len == 1 || a.step == b.step));
    match op {
        CompareOp::Eq => Some(same),
        CompareOp::Ne => Some(!same),
        _ => None,
    }
}

/// `repr(range)`
pub fn repr(range: &Range) -> String {
    let Range { start, stop, step } = range;
    if *step == 1 { format!("range({start}, {stop})") } else { format!("range({start}, {stop}, {step})") }
}

fn index(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let range = this(vm, &args)?;
    if let Some(at) = place(vm, range, args.at(1)) {
        return Ok(vm.heap.big(at.into()));
    }
    let shown = vm.repr(args.at(1))?;
    match args.at(1) {
        Value::Int(..) | Value::Bool(_) | Value::Big(_) => Err(vm.value_error(format!("{shown} is not in range"))),
        _ => Err(vm.value_error("sequence.index(x): x not in sequence")),
    }
}

fn count(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::int(vm.contains(args.at(0), args.at(1))?.into()))
}

fn part(vm: &mut Vm<'_>, args: Args<'_>, part: fn(Range) -> i128) -> R<Value> {
    let range = this(vm, &args)?;
    Ok(vm.heap.big(part(range).into()))
}

/// Methods of `range`.
pub const METHODS: &[Native] = &[
    Native::getter("start", |vm, args| part(vm, args, |r| r.start)),
    Native::getter("stop", |vm, args| part(vm, args, |r| r.stop)),
    Native::getter("step", |vm, args| part(vm, args, |r| r.step)),
    Native::method("index", 1, 1, index),
    Native::method("count", 1, 1, count),
    Native::method("__len__", 0, 0, containers::method_len),
    Native::method("__contains__", 1, 1, containers::method_contains),
    Native::method("__getitem__", 1, 1, containers::method_get_item),
    Native::method("__iter__", 0, 0, containers::method_iter),
    Native::method("__reversed__", 0, 0, |vm, args| {
        let range = this(vm, &args)?;
        Ok(vm.new_iter(iterate::range_reversed(range)))
    }),
    Native::method("__repr__", 0, 0, containers::method_repr),
    Native::method("__hash__", 0, 0, containers::method_hash),
    Native::method("__eq__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Eq, args)),
    Native::method("__ne__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ne, args)),
];

/// `slice(...)`
pub use slice::construct as construct_slice;
