//! Ints of 64 bits.

use super::{EXACT, big, float, num, to_big, true_divide, zero_division};
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::value::{BinaryOp, Value};
use crate::python::vm::Vm;
use crate::trace::{Handle, Num, Op as TraceOp};
use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

type Small = (i64, Handle);

/// `a op b`
#[inline]
pub(super) fn binary(vm: &mut Vm<'_>, op: BinaryOp, a: Small, b: Small) -> R<Option<Value>> {
    let ((x, _), (y, _)) = (a, b);
    let (trace_op, result) = match op {
        BinaryOp::Add => (TraceOp::Add, x.checked_add(y)),
        BinaryOp::Sub => (TraceOp::Sub, x.checked_sub(y)),
        BinaryOp::Mul => (TraceOp::Mul, x.checked_mul(y)),
        BinaryOp::FloorDiv | BinaryOp::Mod => {
            vm.trace.zero(float_of(b));
            if y == 0 {
                let message = if op == BinaryOp::Mod { "integer modulo by zero" } else { "integer division or modulo by zero" };
                return Err(zero_division(vm, message));
            }
            match op {
                BinaryOp::Mod if y == -1 => (TraceOp::Mod, Some(0)),
                BinaryOp::Mod => (TraceOp::Mod, Some(Integer::mod_floor(&x, &y))),
                _ if y == -1 => (TraceOp::FloorDiv, x.checked_neg()),
                _ => (TraceOp::FloorDiv, Some(Integer::div_floor(&x, &y))),
            }
        }
        BinaryOp::Div => return divide(vm, a, b).map(Some),
        _ => return rare(vm, op, a, b),
    };
    match result {
        Some(r) => Ok(Some(traced_binary(vm, trace_op, a, b, r))),
        None => by_big(vm, op, a, b),
    }
}

fn divide(vm: &mut Vm<'_>, a: Small, b: Small) -> R<Value> {
    vm.trace.zero(float_of(b));
    if b.0 == 0 {
        return Err(zero_division(vm, "division by zero"));
    }
    let exact = |v: i64| v.unsigned_abs() < EXACT as u64;
    if exact(a.0) && exact(b.0) {
        let result = a.0 as f64 / b.0 as f64;
        let handle = vm.trace.binary(TraceOp::Div, float_of(a), float_of(b), result);
        return Ok(Value::Float(result, handle));
    }
    pin(vm, a);
    pin(vm, b);
    // The quotient of two ints of 64 bits is always in range.
    Ok(Value::float(true_divide(&BigInt::from(a.0), &BigInt::from(b.0)).unwrap_or(0.0)))
}

/// Powers, shifts and bits: nothing here is in the trace's table.
fn rare(vm: &mut Vm<'_>, op: BinaryOp, a: Small, b: Small) -> R<Option<Value>> {
    pin(vm, a);
    pin(vm, b);
    let (x, y) = (a.0, b.0);
    let result = match op {
        BinaryOp::And => Some(x & y),
        BinaryOp::Or => Some(x | y),
        BinaryOp::Xor => Some(x ^ y),
        BinaryOp::Pow if y < 0 => return float::power(vm, Num::plain(x as f64), Num::plain(y as f64)).map(Some),
        BinaryOp::Pow => u32::try_from(y).ok().and_then(|y| x.checked_pow(y)),
        BinaryOp::LShift | BinaryOp::RShift if y < 0 => return Err(vm.value_error("negative shift count")),
        BinaryOp::LShift if y < 63 => Some(x << y).filter(|r| r >> y == x),
        BinaryOp::LShift => None,
        BinaryOp::RShift => Some(x >> y.min(63)),
        _ => return Ok(None),
    };
    match result {
        Some(r) => Ok(Some(Value::int(r))),
        None => by_big(vm, op, a, b),
    }
}

#[cold]
fn by_big(vm: &mut Vm<'_>, op: BinaryOp, a: Small, b: Small) -> R<Option<Value>> {
    pin(vm, a);
    pin(vm, b);
    big::binary(vm, op, Value::int(a.0), Value::int(b.0))
}

fn pin(vm: &mut Vm<'_>, a: Small) {
    vm.trace.pin(float_of(a));
}

fn float_of(a: Small) -> Num {
    num(a.0 as f64, a.1)
}

/// An int made from two ints by an operation of the trace's table.
#[inline]
fn traced_binary(vm: &mut Vm<'_>, op: TraceOp, a: Small, b: Small, result: i64) -> Value {
    if a.1.is_none() && b.1.is_none() {
        return Value::int(result);
    }
    let handle = vm.trace.binary(op, float_of(a), float_of(b), result as f64);
    keep_exact(vm, result, handle, &[float_of(a), float_of(b)])
}

/// An int made from one int by an operation of the trace's table.
#[inline]
pub(super) fn traced_unary(vm: &mut Vm<'_>, op: TraceOp, a: Small, result: i64) -> Value {
    if a.1.is_none() {
        return Value::int(result);
    }
    let handle = vm.trace.unary(op, float_of(a), result as f64);
    keep_exact(vm, result, handle, &[float_of(a)])
}

/// Gives an int its handle, sees to it that its float is no negative zero, and guards that it stays an exact float; an int beyond that
/// pins what it was made from.
#[cold]
pub(super) fn keep_exact(vm: &mut Vm<'_>, result: i64, handle: Handle, from: &[Num]) -> Value {
    let value = result as f64;
    if value.abs() >= EXACT {
        for &operand in from {
            vm.trace.pin(operand);
        }
        return Value::int(result);
    }
    let handle = vm.trace.binary(TraceOp::Add, num(value, handle), Num::plain(0.0), value);
    let magnitude = vm.trace.unary(TraceOp::Abs, num(value, handle), value.abs());
    vm.trace.order(num(value.abs(), magnitude), Num::plain(EXACT));
    Value::Int(result, handle)
}

/// `pow(base, exponent, modulus)` of ints; `None` where one of the three is no int.
pub fn pow_mod(vm: &mut Vm<'_>, base: Value, exponent: Value, modulus: Value) -> R<Option<Value>> {
    let values = [base, exponent, modulus].map(|v| vm.pin(v));
    let [Some(base), Some(mut exponent), Some(modulus)] = values.map(|v| to_big(vm, v).map(|b| b.into_owned())) else { return Ok(None) };
    if modulus.is_zero() {
        return Err(vm.value_error("pow() 3rd argument cannot be 0"));
    }
    let mut base = base.mod_floor(&modulus);
    if exponent.is_negative() {
        base = match inverse(&base, &modulus) {
            Some(inverse) => inverse,
            None => return Err(vm.value_error("base is not invertible for the given modulus")),
        };
        exponent = -exponent;
    }
    let bits = modulus.bits();
    vm.charge(exponent.bits().saturating_mul(big::mul_cost(bits, bits).saturating_mul(4)).saturating_add(8))?;
    let result = base.modpow(&exponent, &modulus);
    Ok(Some(vm.heap.big(result)))
}

fn inverse(base: &BigInt, modulus: &BigInt) -> Option<BigInt> {
    let magnitude = BigInt::from_biguint(Sign::Plus, modulus.magnitude().clone());
    if magnitude.is_one() {
        return Some(BigInt::zero());
    }
    let extended = base.mod_floor(&magnitude).extended_gcd(&magnitude);
    extended.gcd.is_one().then(|| extended.x.mod_floor(modulus))
}

/// `math.isqrt`: the integer square root; an error where the number is negative.
pub fn isqrt(vm: &mut Vm<'_>, value: &BigInt) -> R<BigInt> {
    if value.is_negative() {
        return Err(vm.error(Builtin::ValueError, "isqrt() argument must be nonnegative".into()));
    }
    let bits = value.bits();
    vm.charge(big::mul_cost(bits, bits).saturating_mul(8))?;
    Ok(value.sqrt())
}
