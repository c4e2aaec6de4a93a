//! Vectors: `Vec(x, y, z)`, and the arithmetic of `o.center`, whose results are vectors that cannot be written.

use smallvec::{SmallVec, smallvec};

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::Record;
use crate::python::value::{BinaryOp, UnaryOp, Value};
use crate::python::vm::HostCx;
use crate::trace::{Num, Op};

use super::convert::scalar;
use super::{SceneHost, Thing, VECTOR};

/// A new vector.
pub(super) fn record(cx: &mut HostCx<'_>, items: [Value; 3]) -> Value {
    Value::Record(cx.heap.alloc(Record { kind: VECTOR, items: SmallVec::from(items) }))
}

/// A plain number as an exact int, if it is one, and as a recorded float.
fn operand(value: Value) -> Option<(Option<i64>, Num)> {
    match value {
        Value::Bool(truth) => Some((Some(truth.into()), Num::plain(f64::from(truth)))),
        Value::Int(int, _) => scalar(value).map(|scalar| (Some(int), scalar.num)),
        _ => scalar(value).map(|scalar| (None, scalar.num)),
    }
}

/// `a op b` of two numbers: ints stay ints while they fit.
fn combine(cx: &mut HostCx<'_>, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
    let (Some((i, a)), Some((j, b))) = (operand(a), operand(b)) else { return Ok(None) };
    let ints = i.zip(j);
    let (op, result, int) = match op {
        BinaryOp::Add => (Op::Add, a.value + b.value, ints.and_then(|(i, j)| i.checked_add(j))),
        BinaryOp::Sub => (Op::Sub, a.value - b.value, ints.and_then(|(i, j)| i.checked_sub(j))),
        BinaryOp::Mul => (Op::Mul, a.value * b.value, ints.and_then(|(i, j)| i.checked_mul(j))),
        BinaryOp::Div => {
            cx.trace.zero(b);
            if b.value == 0.0 {
                let message = if ints.is_some() { "division by zero" } else { "float division by zero" };
                return Err(cx.error(Builtin::ZeroDivisionError, message));
            }
            (Op::Div, a.value / b.value, None)
        }
        _ => return Ok(None),
    };
    let handle = cx.trace.binary(op, a, b, result);
    Ok(Some(match int {
        Some(int) => Value::Int(int, handle),
        None => Value::Float(result, handle),
    }))
}

impl SceneHost {
    /// The items of a vector or of a part of an object.
    fn vector(&mut self, cx: &mut HostCx<'_>, value: Value) -> Option<SmallVec<[Value; 4]>> {
        let is_vector = matches!(value, Value::Record(_)) || matches!(Thing::of(value), Some(Thing::Part(..)));
        if is_vector { self.sequence(cx, value) } else { None }
    }

    pub(super) fn vector_binary(&mut self, cx: &mut HostCx<'_>, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
        if op == BinaryOp::Mul && operand(a).is_some() {
            return self.vector_binary(cx, op, b, a);
        }
        // The left side is read first: reading settles.
        let Some(left) = self.vector(cx, a) else { return Ok(None) };
        let right: SmallVec<[Value; 4]> = match op {
            BinaryOp::Add | BinaryOp::Sub => match self.sequence(cx, b) {
                Some(items) if items.len() < 3 => return Err(cx.error(Builtin::IndexError, "tuple index out of range")),
                Some(items) => items,
                None => return Ok(None),
            },
            BinaryOp::Mul | BinaryOp::Div if operand(b).is_some() => smallvec![b; 3],
            _ => return Ok(None),
        };
        let mut items = [Value::None; 3];
        for (item, (a, b)) in items.iter_mut().zip(left.into_iter().zip(right)) {
            match combine(cx, op, a, b)? {
                Some(value) => *item = value,
                None => return Ok(None),
            }
        }
        Ok(Some(record(cx, items)))
    }

    pub(super) fn vector_unary(&mut self, cx: &mut HostCx<'_>, op: UnaryOp, a: Value) -> R<Option<Value>> {
        if op != UnaryOp::Neg {
            return Ok(None);
        }
        let Some(left) = self.vector(cx, a) else { return Ok(None) };
        let mut items = [Value::None; 3];
        for (item, value) in items.iter_mut().zip(left) {
            let Some((int, num)) = operand(value) else { return Ok(None) };
            let handle = cx.trace.unary(Op::Neg, num, -num.value);
            *item = match int.and_then(i64::checked_neg) {
                Some(int) => Value::Int(int, handle),
                None => Value::Float(-num.value, handle),
            };
        }
        Ok(Some(record(cx, items)))
    }

    /// A part of an object equals every sequence of the same numbers; a vector equals vectors only.
    pub(super) fn vector_equals(&mut self, cx: &mut HostCx<'_>, a: Value, b: Value) -> Option<bool> {
        let other_is_record = matches!(b, Value::Record(_));
        let left = match (a, Thing::of(a)) {
            (Value::Record(_), _) if other_is_record => self.sequence(cx, a)?,
            (Value::Record(_), _) => return Some(false),
            (_, Some(Thing::Part(..))) => self.sequence(cx, a)?,
            _ if matches!(Thing::of(b), Some(Thing::Part(..))) => return self.vector_equals(cx, b, a),
            _ if other_is_record => return Some(false),
            _ => return None,
        };
        let Some(right) = self.sequence(cx, b) else { return Some(false) };
        if left.len() != right.len() {
            return Some(false);
        }
        Some(left.into_iter().zip(right).all(|(a, b)| match (operand(a), operand(b)) {
            (Some((_, a)), Some((_, b))) => {
                cx.trace.order(a, b);
                a.value == b.value
            }
            _ => a.is(b),
        }))
    }
}
