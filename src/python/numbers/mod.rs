//! Arithmetic of ints, floats and complex numbers, traced: the last digit and the error messages are CPython's.
//!
//! Invariants: an `int` result is normalised (`Value::Big` never fits 64 bits); a float or int that a literal reaches keeps its
//! handle through everything in the trace's table, with a guard wherever another value could raise or leave the table; all else pins.
//! A traced int is below 2⁵³, so that its float is exact. The work on big ints is charged in proportion to their size, before it is
//! done. Must not know: attributes, classes of the program, text formatting.

mod big;
mod compare;
mod complex;
mod convert;
mod divide;
mod float;
mod int;
mod parse;
mod round;
#[cfg(test)]
mod tests;

pub use compare::{compare, hash_big, hash_float, hash_number};
pub use complex::{complex_abs, complex_of};
pub use convert::{
    TooManyDigits, big_to_float, ceil, float_to_big, floor, int_to_float, int_to_string, int_value, parse_error, to_big, to_float, trunc,
};
pub use divide::true_divide;
pub use float::{float_divmod, float_floor_div, float_mod};
pub use int::{isqrt, pow_mod};
pub use parse::{IntError, misplaces_underscores, parse_complex, parse_float, parse_int};
pub use round::{round, round_float};

use super::error::{R, Raise};
use super::heap::{Complex, Ref};
use super::value::{BinaryOp, UnaryOp, Value};
use super::vm::Vm;
use crate::python::classes::Builtin;
use crate::trace::{Handle, Num, Op as TraceOp};
use num_bigint::BigInt;

/// A plain number: what arithmetic here is about.
#[derive(Clone, Copy, Debug)]
pub enum Number {
    /// `bool` or a small `int`.
    Int(i64, Handle),
    /// Any other `int`.
    Big(Ref<BigInt>),
    /// `float`
    Float(f64, Handle),
    /// `complex`
    Complex(Complex),
}

impl Number {
    /// The number that a value is; `None` for all that is no plain number.
    #[inline]
    pub fn of(vm: &Vm<'_>, value: Value) -> Option<Number> {
        Some(match value {
            Value::Int(v, h) => Number::Int(v, h),
            Value::Float(v, h) => Number::Float(v, h),
            Value::Bool(v) => Number::Int(v as i64, Handle::NONE),
            Value::Big(r) => Number::Big(r),
            Value::Complex(r) => Number::Complex(vm.heap[r]),
            _ => return None,
        })
    }
}

/// The largest magnitude of a traced int, exclusive: below it each int is a float.
pub(crate) const EXACT: f64 = 9_007_199_254_740_992.0;

/// `a op b` among plain numbers; `None` where the types do not take the operator (the caller goes on to `NotImplemented`).
#[inline]
pub fn binary(vm: &mut Vm<'_>, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
    match (a, b) {
        (Value::Float(x, h), Value::Float(y, k)) => float::binary(vm, op, num(x, h), num(y, k)),
        (Value::Int(x, h), Value::Int(y, k)) => int::binary(vm, op, (x, h), (y, k)),
        (Value::Float(x, h), Value::Int(y, k)) => float::binary(vm, op, num(x, h), num(y as f64, k)),
        (Value::Int(x, h), Value::Float(y, k)) => float::binary(vm, op, num(x as f64, h), num(y, k)),
        _ => mixed(vm, op, a, b),
    }
}

fn mixed(vm: &mut Vm<'_>, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
    if let (Value::Bool(x), Value::Bool(y)) = (a, b) {
        match op {
            BinaryOp::And => return Ok(Some(Value::Bool(x & y))),
            BinaryOp::Or => return Ok(Some(Value::Bool(x | y))),
            BinaryOp::Xor => return Ok(Some(Value::Bool(x ^ y))),
            _ => {}
        }
    }
    let (Some(x), Some(y)) = (Number::of(vm, a), Number::of(vm, b)) else { return Ok(None) };
    match (x, y) {
        (Number::Int(x, h), Number::Int(y, k)) => int::binary(vm, op, (x, h), (y, k)),
        (Number::Complex(_), _) | (_, Number::Complex(_)) => {
            if !matches!(op, BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul | BinaryOp::Div | BinaryOp::Pow) {
                return Ok(None);
            }
            let x = complex_of(vm, x)?;
            let y = complex_of(vm, y)?;
            complex::binary(vm, op, x, y)
        }
        (Number::Float(..), _) | (_, Number::Float(..)) => {
            if !float::takes(op) {
                return Ok(None);
            }
            let x = real(vm, x)?;
            let y = real(vm, y)?;
            float::binary(vm, op, x, y)
        }
        (Number::Int(..) | Number::Big(_), Number::Int(..) | Number::Big(_)) => {
            let (a, b) = (vm.pin(a), vm.pin(b));
            big::binary(vm, op, a, b)
        }
    }
}

/// `-a`, `+a`, `~a` of a plain number; `None` where the type does not take the operator.
pub fn unary(vm: &mut Vm<'_>, op: UnaryOp, a: Value) -> R<Option<Value>> {
    let Some(number) = Number::of(vm, a) else { return Ok(None) };
    Ok(Some(match (op, number) {
        (UnaryOp::Pos, Number::Int(v, h)) => Value::Int(v, h),
        (UnaryOp::Pos, _) => a,
        (UnaryOp::Neg, Number::Float(v, h)) => vm.float_of(TraceOp::Neg, num(v, h), -v),
        (UnaryOp::Neg, Number::Int(v, h)) => match v.checked_neg() {
            Some(r) => int::traced_unary(vm, TraceOp::Neg, (v, h), r),
            None => vm.heap.big(-BigInt::from(v)),
        },
        (UnaryOp::Neg, Number::Big(r)) => {
            let negated = -&vm.heap[r];
            vm.heap.big(negated)
        }
        (UnaryOp::Neg, Number::Complex(c)) => Value::Complex(vm.heap.alloc(Complex { re: -c.re, im: -c.im })),
        (UnaryOp::Invert, Number::Int(v, h)) => {
            vm.pin(Value::Int(v, h));
            Value::int(!v)
        }
        (UnaryOp::Invert, Number::Big(r)) => {
            let inverted: BigInt = -(&vm.heap[r] + 1i32);
            vm.heap.big(inverted)
        }
        (UnaryOp::Invert, _) => return Ok(None),
    }))
}

/// `abs(a)` of a plain number.
pub fn absolute(vm: &mut Vm<'_>, a: Value) -> R<Option<Value>> {
    let Some(number) = Number::of(vm, a) else { return Ok(None) };
    Ok(Some(match number {
        Number::Float(v, h) => vm.float_of(TraceOp::Abs, num(v, h), v.abs()),
        Number::Int(v, h) => match v.checked_abs() {
            Some(r) => int::traced_unary(vm, TraceOp::Abs, (v, h), r),
            None => vm.heap.big(-BigInt::from(v)),
        },
        Number::Big(r) => {
            let positive = BigInt::from(vm.heap[r].magnitude().clone());
            vm.heap.big(positive)
        }
        Number::Complex(c) => Value::float(complex_abs(vm, c)?),
    }))
}

/// `divmod(a, b)` of plain numbers, as a tuple.
pub fn divmod(vm: &mut Vm<'_>, a: Value, b: Value) -> R<Option<Value>> {
    let (Some(x), Some(y)) = (Number::of(vm, a), Number::of(vm, b)) else { return Ok(None) };
    if matches!(x, Number::Complex(_)) || matches!(y, Number::Complex(_)) {
        return Ok(None);
    }
    if matches!(x, Number::Float(..)) || matches!(y, Number::Float(..)) {
        let divisor = real(vm, y)?;
        if divisor.value == 0.0 {
            vm.trace.pin(divisor);
            return Err(vm.error(Builtin::ZeroDivisionError, "float divmod()".into()));
        }
    }
    let quotient = binary(vm, BinaryOp::FloorDiv, a, b)?;
    let remainder = binary(vm, BinaryOp::Mod, a, b)?;
    Ok(quotient.zip(remainder).map(|(q, r)| vm.new_tuple([q, r].as_slice())))
}

/// Whether a plain number is not zero, guarded; `None` for all else.
pub fn truth(vm: &mut Vm<'_>, a: Value) -> Option<bool> {
    Some(match Number::of(vm, a)? {
        Number::Int(v, h) => {
            vm.trace.zero(num(v as f64, h));
            v != 0
        }
        Number::Float(v, h) => {
            vm.trace.zero(num(v, h));
            v != 0.0
        }
        Number::Big(_) => true,
        Number::Complex(c) => c.re != 0.0 || c.im != 0.0,
    })
}

/// A value and where it came from, as the trace takes them.
#[inline(always)]
pub(crate) const fn num(value: f64, handle: Handle) -> Num {
    Num { value, handle }
}

/// The float of a real number, with its handle.
fn real(vm: &mut Vm<'_>, a: Number) -> R<Num> {
    Ok(match a {
        Number::Int(v, h) => num(v as f64, h),
        Number::Float(v, h) => num(v, h),
        Number::Big(r) => Num::plain(big_to_float(vm, r)?),
        Number::Complex(c) => Num::plain(c.re),
    })
}

fn zero_division(vm: &mut Vm<'_>, message: &str) -> Raise {
    vm.error(Builtin::ZeroDivisionError, message.into())
}

/// `OverflowError(34, 'Numerical result out of range')`.
pub(crate) fn out_of_range(vm: &mut Vm<'_>) -> Raise {
    let text = vm.new_str("Numerical result out of range");
    match vm.call(Builtin::OverflowError.value(), &[Value::int(34), text]) {
        Ok(exception) => Raise::Exception(exception),
        Err(raise) => raise,
    }
}
