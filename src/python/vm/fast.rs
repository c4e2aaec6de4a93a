//! What the main loop does at once: arithmetic and comparison of untraced numbers, and copies of values.
//!
//! A number that was just computed was written tag, handle and payload apart; a processor that reads it back as one piece of 16 bytes
//! waits until all three have left its store buffer. So numbers are copied field by field here, and operands are looked at where they
//! stand instead of being taken off the stack first. Other values are copied as a slice of one, which keeps the compiler from making one
//! piece of both ways again.

use super::Vm;
use crate::python::error::R;
use crate::python::value::{BinaryOp, CompareOp, Value};
use std::slice;

/// Pushes a copy of a value.
#[inline(always)]
pub(super) fn push_copy(stack: &mut Vec<Value>, value: &Value) {
    match *value {
        Value::Float(x, h) => stack.push(Value::Float(x, h)),
        Value::Int(x, h) => stack.push(Value::Int(x, h)),
        _ => stack.extend_from_slice(slice::from_ref(value)),
    }
}

/// Copies a value to a place.
#[inline(always)]
pub(super) fn set(place: &mut Value, value: &Value) {
    match *value {
        Value::Float(x, h) => *place = Value::Float(x, h),
        Value::Int(x, h) => *place = Value::Int(x, h),
        _ => slice::from_mut(place).copy_from_slice(slice::from_ref(value)),
    }
}

/// The first values of a slice, which has that many.
#[inline(always)]
pub(super) fn array<const N: usize>(values: &[Value]) -> [Value; N] {
    let mut array = [Value::Undefined; N];
    for (place, value) in array.iter_mut().zip(values) {
        set(place, value);
    }
    array
}

impl Vm<'_> {
    /// Pushes a copy of a value that stands on the stack.
    #[inline(always)]
    pub(super) fn push_from(&mut self, at: usize) {
        match self.stack[at] {
            Value::Float(x, h) => self.stack.push(Value::Float(x, h)),
            Value::Int(x, h) => self.stack.push(Value::Int(x, h)),
            _ => self.stack.extend_from_within(at..at + 1),
        }
    }

    /// Copies a value on the stack to another place there.
    #[inline(always)]
    pub(super) fn copy_on_stack(&mut self, from: usize, to: usize) {
        match self.stack[from] {
            Value::Float(x, h) => self.stack[to] = Value::Float(x, h),
            Value::Int(x, h) => self.stack[to] = Value::Int(x, h),
            _ => self.stack.copy_within(from..from + 1, to),
        }
    }

    /// Puts a result in the place of the operand at `at`, which is the last that is left.
    #[inline(always)]
    pub(super) fn finish(&mut self, at: usize, result: R<Value>) -> R<()> {
        match &result {
            Ok(value) => {
                self.stack.truncate(at);
                push_copy(&mut self.stack, value);
                Ok(())
            }
            Err(raise) => Err(*raise),
        }
    }
}

/// An untraced number, or the need to look closer.
pub(super) enum Quick {
    Int(i64),
    Float(f64),
    No,
}

impl Quick {
    #[inline(always)]
    fn int(value: Option<i64>) -> Quick {
        match value {
            Some(value) => Quick::Int(value),
            None => Quick::No,
        }
    }
}

/// Ints below this are floats without loss.
const EXACT: u64 = 1 << 53;

/// Arithmetic on untraced numbers that needs no thought.
#[inline(always)]
pub(super) fn arithmetic(op: BinaryOp, a: &Value, b: &Value) -> Quick {
    match (a, b) {
        (&Value::Float(x, h), &Value::Float(y, k)) if (h.0 | k.0) == 0 => floats(op, x, y),
        (&Value::Int(x, h), &Value::Int(y, k)) if (h.0 | k.0) == 0 => ints(op, x, y),
        (&Value::Float(x, h), &Value::Int(y, k)) if (h.0 | k.0) == 0 && y.unsigned_abs() < EXACT => floats(op, x, y as f64),
        (&Value::Int(x, h), &Value::Float(y, k)) if (h.0 | k.0) == 0 && x.unsigned_abs() < EXACT => floats(op, x as f64, y),
        _ => Quick::No,
    }
}

#[inline(always)]
fn ints(op: BinaryOp, x: i64, y: i64) -> Quick {
    match op {
        BinaryOp::Add => Quick::int(x.checked_add(y)),
        BinaryOp::Sub => Quick::int(x.checked_sub(y)),
        BinaryOp::Mul => Quick::int(x.checked_mul(y)),
        BinaryOp::Div if y != 0 && x.unsigned_abs() < EXACT && y.unsigned_abs() < EXACT => Quick::Float(x as f64 / y as f64),
        BinaryOp::FloorDiv if y > 0 => Quick::Int(x.div_euclid(y)),
        BinaryOp::Mod if y > 0 => Quick::Int(x.rem_euclid(y)),
        BinaryOp::And => Quick::Int(x & y),
        BinaryOp::Or => Quick::Int(x | y),
        BinaryOp::Xor => Quick::Int(x ^ y),
        _ => Quick::No,
    }
}

#[inline(always)]
fn floats(op: BinaryOp, x: f64, y: f64) -> Quick {
    match op {
        BinaryOp::Add => Quick::Float(x + y),
        BinaryOp::Sub => Quick::Float(x - y),
        BinaryOp::Mul => Quick::Float(x * y),
        BinaryOp::Div if y != 0.0 => Quick::Float(x / y),
        _ => Quick::No,
    }
}

/// A comparison of untraced numbers.
#[inline(always)]
pub(super) fn comparison(op: CompareOp, a: &Value, b: &Value) -> Option<bool> {
    match (a, b) {
        (&Value::Int(x, h), &Value::Int(y, k)) if (h.0 | k.0) == 0 => Some(ordered(op, x, y)),
        (&Value::Float(x, h), &Value::Float(y, k)) if (h.0 | k.0) == 0 => Some(ordered(op, x, y)),
        (&Value::Float(x, h), &Value::Int(y, k)) if (h.0 | k.0) == 0 && y.unsigned_abs() < EXACT => Some(ordered(op, x, y as f64)),
        (&Value::Int(x, h), &Value::Float(y, k)) if (h.0 | k.0) == 0 && x.unsigned_abs() < EXACT => Some(ordered(op, x as f64, y)),
        _ => None,
    }
}

#[inline(always)]
fn ordered<T: PartialOrd>(op: CompareOp, x: T, y: T) -> bool {
    match op {
        CompareOp::Lt => x < y,
        CompareOp::Le => x <= y,
        CompareOp::Eq => x == y,
        CompareOp::Ne => x != y,
        CompareOp::Gt => x > y,
        CompareOp::Ge => x >= y,
    }
}
