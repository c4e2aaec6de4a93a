//! `slice`: which items of a sequence it means, and its methods.

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::native::{Args, Native, NativeFn};
use crate::python::symbols::sym;
use crate::python::value::{CompareOp, Value};
use crate::python::vm::Vm;
use num_bigint::{BigInt, Sign};
use num_traits::Signed;

/// A slice whose bounds were evaluated, not yet laid over a sequence. Bounds outside 64 bits are clipped.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    start: Option<i64>,
    stop: Option<i64>,
    step: i64,
}

/// The items of a sequence that a slice means: `len` of them from `start` on, `step` apart. Where `len` is 0 nothing else has a meaning
/// but `start` of a plain slice: the place to insert at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// The first index.
    pub start: isize,
    /// The distance, never 0.
    pub step: isize,
    /// How many.
    pub len: usize,
    /// Where it would end, as `slice.indices` says it.
    pub stop: isize,
}

impl Span {
    /// The indices, in the order of the slice.
    pub fn indices(self) -> impl DoubleEndedIterator<Item = usize> + ExactSizeIterator {
        (0..self.len).map(move |i| (self.start + i as isize * self.step) as usize)
    }

    /// The items of `from` that it means.
    pub fn of<T: Copy>(self, from: &[T]) -> Vec<T> {
        if self.step == 1 { from[self.start as usize..][..self.len].to_vec() } else { self.indices().map(|i| from[i]).collect() }
    }
}

impl Bounds {
    /// Lays the slice over a sequence of `len` items.
    pub fn over(self, len: usize) -> Span {
        let len = len as i64;
        let (low, high) = if self.step < 0 { (-1, len - 1) } else { (0, len) };
        let place = |bound: Option<i64>, default: i64| match bound {
            None => default,
            Some(b) if b < 0 => b.saturating_add(len).max(low),
            Some(b) => b.min(high),
        };
        let (start, stop) =
            if self.step < 0 { (place(self.start, high), place(self.stop, low)) } else { (place(self.start, low), place(self.stop, high)) };
        let count = if self.step < 0 {
            if stop < start { (start - stop - 1) as u64 / self.step.unsigned_abs() + 1 } else { 0 }
        } else if start < stop {
            (stop - start - 1) as u64 / self.step as u64 + 1
        } else {
            0
        };
        Span { start: start as isize, step: self.step as isize, len: count as usize, stop: stop as isize }
    }

    /// True for a slice without a step, or with the step 1.
    pub fn is_plain(self) -> bool {
        self.step == 1
    }
}

/// The bound of a slice: `None`, or an index clipped to 64 bits.
fn bound(vm: &mut Vm<'_>, value: Value) -> R<Option<i64>> {
    let value = vm.pin(value);
    Ok(Some(match value {
        Value::None => return Ok(None),
        Value::Int(v, _) => v,
        Value::Bool(b) => i64::from(b),
        Value::Float(..) | Value::Str(_) => return Err(vm.type_error(BAD_INDEX)),
        other => {
            if !matches!(other, Value::Big(_)) && vm.special(other, sym::INDEX).is_none() {
                return Err(vm.type_error(BAD_INDEX));
            }
            let big = vm.index_big(other)?;
            i64::try_from(&big).unwrap_or(if big.sign() == Sign::Minus { i64::MIN + 1 } else { i64::MAX })
        }
    }))
}

const BAD_INDEX: &str = "slice indices must be integers or None or have an __index__ method";

/// Evaluates the bounds of a slice.
pub fn bounds(vm: &mut Vm<'_>, slice: Ref<Slice>) -> R<Bounds> {
    let Slice { start, stop, step } = vm.heap[slice];
    let step = bound(vm, step)?.unwrap_or(1).max(i64::MIN + 1);
    if step == 0 {
        return Err(vm.value_error("slice step cannot be zero"));
    }
    Ok(Bounds { start: bound(vm, start)?, stop: bound(vm, stop)?, step })
}

/// What a slice means in a sequence of `len` items.
pub fn span(vm: &mut Vm<'_>, slice: Ref<Slice>, len: usize) -> R<Span> {
    Ok(bounds(vm, slice)?.over(len))
}

/// `slice(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if !args.kw.is_empty() {
        return Err(vm.type_error("slice() takes no keyword arguments"));
    }
    let (start, stop, step) = match *args.pos {
        [stop] => (Value::None, stop, Value::None),
        [start, stop] => (start, stop, Value::None),
        [start, stop, step] => (start, stop, step),
        [] => return Err(vm.type_error("slice expected at least 1 argument, got 0")),
        _ => return Err(vm.type_error(format!("slice expected at most 3 arguments, got {}", args.pos.len()))),
    };
    Ok(Value::Slice(vm.heap.alloc(Slice { start, stop, step })))
}

/// `repr(slice)`
pub fn repr(vm: &mut Vm<'_>, slice: Ref<Slice>) -> R<String> {
    let Slice { start, stop, step } = vm.heap[slice];
    Ok(format!("slice({}, {}, {})", vm.repr(start)?, vm.repr(stop)?, vm.repr(step)?))
}

/// The slice as a tuple: how slices compare.
fn as_tuple(vm: &mut Vm<'_>, slice: Value) -> Value {
    match slice {
        Value::Slice(s) => {
            let Slice { start, stop, step } = vm.heap[s];
            vm.new_tuple([start, stop, step])
        }
        other => other,
    }
}

/// `a op b` of two slices.
pub fn compare(vm: &mut Vm<'_>, op: CompareOp, a: Value, b: Value) -> R<Value> {
    let (a, b) = (as_tuple(vm, a), as_tuple(vm, b));
    vm.compare(op, a, b)
}

fn get(vm: &mut Vm<'_>, args: Args<'_>, part: fn(&Slice) -> Value) -> R<Value> {
    match args.at(0) {
        Value::Slice(s) => Ok(part(&vm.heap[s])),
        _ => Ok(Value::None),
    }
}

/// `slice.indices(length)`
fn indices(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Value::Slice(s) = args.at(0) else { return Ok(Value::None) };
    let len = vm.index_big(args.at(1))?;
    if len.is_negative() {
        return Err(vm.value_error("length should not be negative"));
    }
    let parts = big_indices(vm, s, &len)?.map(|v| vm.heap.big(v));
    Ok(vm.new_tuple(parts))
}

/// Start, stop and step of a slice laid over a sequence of any length.
pub fn big_indices(vm: &mut Vm<'_>, s: Ref<Slice>, len: &BigInt) -> R<[BigInt; 3]> {
    let Slice { start, stop, step } = vm.heap[s];
    let mut part = |v: Value| -> R<Option<BigInt>> {
        if v.is_none() {
            return Ok(None);
        }
        if !matches!(v, Value::Int(..) | Value::Bool(_) | Value::Big(_)) && vm.special(v, sym::INDEX).is_none() {
            return Err(vm.type_error(BAD_INDEX));
        }
        vm.index_big(v).map(Some)
    };
    let (start, stop, step) = (part(start)?, part(stop)?, part(step)?.unwrap_or_else(|| 1.into()));
    if step.sign() == Sign::NoSign {
        return Err(vm.value_error("slice step cannot be zero"));
    }
    let back = step.is_negative();
    let (low, high) = if back { (BigInt::from(-1), len - 1) } else { (BigInt::ZERO, len.clone()) };
    let place = |bound: Option<BigInt>, default: &BigInt| match bound {
        None => default.clone(),
        Some(b) if b.is_negative() => (b + len).max(low.clone()),
        Some(b) => b.min(high.clone()),
    };
    let (start, stop) = if back { (place(start, &high), place(stop, &low)) } else { (place(start, &low), place(stop, &high)) };
    Ok([start, stop, step])
}

/// Methods of `slice`.
pub const METHODS: &[Native] = &[
    Native::getter("start", |vm, args| get(vm, args, |s| s.start)),
    Native::getter("stop", |vm, args| get(vm, args, |s| s.stop)),
    Native::getter("step", |vm, args| get(vm, args, |s| s.step)),
    Native::method("indices", 1, 1, indices),
    Native::method("__repr__", 0, 0, |vm, args| match args.at(0) {
        Value::Slice(s) => {
            let text = repr(vm, s)?;
            Ok(vm.new_str(text))
        }
        _ => Err(vm.error(Builtin::TypeError, "descriptor '__repr__' requires a 'slice' object".into())),
    }),
    compared("__eq__", |vm, args| rich(vm, args, CompareOp::Eq)),
    compared("__ne__", |vm, args| rich(vm, args, CompareOp::Ne)),
    compared("__lt__", |vm, args| rich(vm, args, CompareOp::Lt)),
    compared("__le__", |vm, args| rich(vm, args, CompareOp::Le)),
    compared("__gt__", |vm, args| rich(vm, args, CompareOp::Gt)),
    compared("__ge__", |vm, args| rich(vm, args, CompareOp::Ge)),
];

const fn compared(name: &'static str, body: NativeFn) -> Native {
    Native::method(name, 1, 1, body)
}

fn rich(vm: &mut Vm<'_>, args: Args<'_>, op: CompareOp) -> R<Value> {
    match (args.at(0), args.at(1)) {
        (a @ Value::Slice(_), b @ Value::Slice(_)) => compare(vm, op, a, b),
        _ => Ok(Value::NotImplemented),
    }
}
