//! Ints of any size. Each operation asks for the time and the memory that it will take before it begins.

use super::{convert, float, num, to_big, true_divide, zero_division};
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::value::{BinaryOp, Value};
use crate::python::vm::Vm;
use crate::trace::Handle;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Pow, Signed, ToPrimitive, Zero};

/// Words that are worked through in the time of one step.
const WORDS_A_STEP: u64 = 4;

/// Steps to multiply numbers of so many bits.
pub(super) fn mul_cost(a: u64, b: u64) -> u64 {
    let (small, large) = (a.min(b) / 64 + 1, a.max(b) / 64 + 1);
    large.saturating_mul(2 * small.isqrt()) / WORDS_A_STEP
}

/// `a op b` of two ints without handles.
pub(super) fn binary(vm: &mut Vm<'_>, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
    let (Some(x), Some(y)) = (to_big(vm, a), to_big(vm, b)) else { return Ok(None) };
    let (n, m) = (x.bits(), y.bits());
    let (cost, bytes) = match op {
        BinaryOp::Mul => (mul_cost(n, m), (n + m) / 8),
        BinaryOp::FloorDiv | BinaryOp::Mod | BinaryOp::Div => ((n / 64 + 1).saturating_mul(m.min(n) / 64 + 1) / WORDS_A_STEP, n / 8),
        BinaryOp::Pow => return power(vm, a, b).map(Some),
        BinaryOp::LShift | BinaryOp::RShift => return shift(vm, op, a, b).map(Some),
        BinaryOp::MatMul => return Ok(None),
        _ => (n.max(m) / 64 / WORDS_A_STEP, n.max(m) / 8),
    };
    vm.charge(cost)?;
    vm.reserve(bytes as usize)?;
    let (Some(x), Some(y)) = (to_big(vm, a), to_big(vm, b)) else { return Ok(None) };
    let result = match op {
        BinaryOp::Add => &*x + &*y,
        BinaryOp::Sub => &*x - &*y,
        BinaryOp::Mul => &*x * &*y,
        BinaryOp::And => &*x & &*y,
        BinaryOp::Or => &*x | &*y,
        BinaryOp::Xor => &*x ^ &*y,
        BinaryOp::Div if y.is_zero() => return Err(zero_division(vm, "division by zero")),
        BinaryOp::FloorDiv if y.is_zero() => return Err(zero_division(vm, "integer division or modulo by zero")),
        _ if y.is_zero() => return Err(zero_division(vm, "integer modulo by zero")),
        BinaryOp::FloorDiv => x.div_floor(&y),
        BinaryOp::Mod => x.mod_floor(&y),
        _ => {
            return match true_divide(&x, &y) {
                Some(result) => Ok(Some(Value::float(result))),
                None => Err(vm.error(Builtin::OverflowError, "integer division result too large for a float".into())),
            };
        }
    };
    Ok(Some(vm.heap.big(result)))
}

fn power(vm: &mut Vm<'_>, a: Value, b: Value) -> R<Value> {
    let (Some(x), Some(y)) = (to_big(vm, a), to_big(vm, b)) else { return Ok(Value::NotImplemented) };
    if y.is_negative() {
        let (x, y) = (x.into_owned(), y.into_owned());
        let x = convert::float_of_big(vm, &x)?;
        let y = convert::float_of_big(vm, &y)?;
        return float::power(vm, num(x, Handle::NONE), num(y, Handle::NONE));
    }
    if y.is_zero() {
        return Ok(Value::int(1));
    }
    if x.magnitude().to_u64().is_some_and(|m| m <= 1) {
        let negative = x.is_negative() && y.is_odd();
        return Ok(Value::int(if x.is_zero() {
            0
        } else if negative {
            -1
        } else {
            1
        }));
    }
    // The result has at least (bits − 1) × exponent bits.
    let bits = x.bits();
    let Some(exponent) = y.to_u64() else { return Err(too_large(vm)) };
    reserve_bits(vm, (bits - 1).max(1).saturating_mul(exponent))?;
    let most = bits.saturating_mul(exponent);
    vm.charge(mul_cost(most / 2, most / 2).saturating_mul(2))?;
    let result = match to_big(vm, a) {
        Some(x) => Pow::pow(&*x, exponent),
        None => BigInt::zero(),
    };
    Ok(vm.heap.big(result))
}

fn shift(vm: &mut Vm<'_>, op: BinaryOp, a: Value, b: Value) -> R<Value> {
    let (Some(x), Some(y)) = (to_big(vm, a), to_big(vm, b)) else { return Ok(Value::NotImplemented) };
    if y.is_negative() {
        return Err(vm.value_error("negative shift count"));
    }
    if x.is_zero() {
        return Ok(Value::int(0));
    }
    let (bits, count) = (x.bits(), y.to_u64());
    if op == BinaryOp::RShift {
        vm.charge(bits / 64 / WORDS_A_STEP)?;
        let Some(x) = to_big(vm, a) else { return Ok(Value::NotImplemented) };
        return Ok(match count {
            Some(count) if count < bits => {
                let result = &*x >> count;
                vm.heap.big(result)
            }
            _ => Value::int(if x.is_negative() { -1 } else { 0 }),
        });
    }
    // CPython's digits have 30 bits, and a number at most 2⁶¹ of them.
    let Some(count) = count.filter(|c| c / 30 < 1 << 61) else {
        return Err(vm.error(Builtin::OverflowError, "too many digits in integer".into()));
    };
    reserve_bits(vm, bits.saturating_add(count))?;
    vm.charge((bits + count) / 64 / WORDS_A_STEP)?;
    let result = match to_big(vm, a) {
        Some(x) => &*x << count,
        None => BigInt::zero(),
    };
    Ok(vm.heap.big(result))
}

fn reserve_bits(vm: &mut Vm<'_>, bits: u64) -> R<()> {
    vm.reserve(usize::try_from(bits / 8).unwrap_or(usize::MAX))
}

fn too_large(vm: &mut Vm<'_>) -> Raise {
    vm.error(Builtin::MemoryError, String::new())
}
