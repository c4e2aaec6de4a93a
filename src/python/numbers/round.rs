//! `round()`.

use super::{Number, convert, num};
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::value::Value;
use crate::python::vm::Vm;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{FromPrimitive, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;

/// `round(value, ndigits)` of a plain int or float; `None` for all else. Without `ndigits`, an int.
pub fn round(vm: &mut Vm<'_>, value: Value, ndigits: Option<Value>) -> R<Option<Value>> {
    let ndigits = ndigits.filter(|n| !n.is_none());
    match (Number::of(vm, value), ndigits) {
        (Some(Number::Int(v, h)), None) => Ok(Some(Value::Int(v, h))),
        (Some(Number::Big(_)), None) => Ok(Some(value)),
        (Some(Number::Int(..) | Number::Big(_)), Some(n)) => round_int(vm, value, n).map(Some),
        (Some(Number::Float(v, h)), None) => convert::round_to_int(vm, num(v, h)).map(Some),
        (Some(Number::Float(v, h)), Some(n)) => {
            let n = vm.pin(n);
            let digits = vm.index_big(n)?;
            let digits = digits.to_i64().unwrap_or(if digits.is_negative() { i64::MIN } else { i64::MAX });
            vm.pin(Value::Float(v, h));
            match round_float(v, digits) {
                Some(result) => Ok(Some(Value::float(result))),
                None => Err(vm.error(Builtin::OverflowError, "rounded value too large to represent".into())),
            }
        }
        (Some(Number::Complex(_)) | None, _) => Ok(None),
    }
}

fn round_int(vm: &mut Vm<'_>, value: Value, ndigits: Value) -> R<Value> {
    let n = vm.pin(ndigits);
    let n = vm.index_big(n)?;
    if !n.is_negative() {
        return Ok(convert::int_value(value).unwrap_or(value));
    }
    let value = vm.pin(value);
    let Some(big) = convert::to_big(vm, value).map(|b| b.into_owned()) else { return Ok(value) };
    // Beyond its own digits everything rounds to zero.
    let digits = n.magnitude().to_u64().unwrap_or(u64::MAX);
    if digits > big.bits() {
        return Ok(Value::int(0));
    }
    vm.charge(super::big::mul_cost(big.bits(), big.bits()).saturating_mul(4))?;
    let unit = BigInt::from(10).pow(digits as u32);
    let rounded = to_multiple(&big, &unit, false);
    Ok(vm.heap.big(rounded))
}

/// The multiple of `unit` nearest to `value` (plus a bit more, away from zero, if `more`), half to even.
fn to_multiple(value: &BigInt, unit: &BigInt, more: bool) -> BigInt {
    let (mut quotient, rest) = value.magnitude().div_rem(unit.magnitude());
    let half = match (rest << 1u32).cmp(unit.magnitude()) {
        Ordering::Equal if more => Ordering::Greater,
        order => order,
    };
    if half == Ordering::Greater || half == Ordering::Equal && quotient.is_odd() {
        quotient += 1u32;
    }
    BigInt::from_biguint(value.sign(), quotient * unit.magnitude())
}

/// `round(x, digits)`: the float nearest to the decimal that is nearest to x, half to even; `None` where no float is that large.
pub fn round_float(x: f64, digits: i64) -> Option<f64> {
    if !x.is_finite() || x == 0.0 || digits > 323 {
        return Some(x);
    }
    if digits < -308 {
        return Some(0.0 * x);
    }
    if digits >= 0 {
        return format!("{x:.*}", digits as usize).parse().ok();
    }
    let whole = BigInt::from_f64(x.trunc())?;
    if whole.is_zero() {
        return Some(0.0 * x);
    }
    let rounded = to_multiple(&whole, &BigInt::from(10).pow(digits.unsigned_abs() as u32), x.fract() != 0.0);
    if rounded.is_zero() {
        return Some(0.0 * x);
    }
    rounded.to_f64().filter(|v| v.is_finite())
}
