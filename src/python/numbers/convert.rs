//! Between the kinds of numbers, and to and from text.

use super::parse::IntError;
use super::{EXACT, Number, int, num};
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::Ref;
use crate::python::value::Value;
use crate::python::vm::Vm;
use crate::trace::{Num, Op as TraceOp};
use num_bigint::BigInt;
use num_traits::{FromPrimitive, ToPrimitive};
use std::borrow::Cow;

/// The most digits that an int may have in decimal text.
pub(super) const MAX_DIGITS: usize = 4300;
/// An int of more bits has more digits than that.
const MAX_BITS: u64 = 14_285;

/// The int or bool as a big int; `None` for all else. Handles are lost: pin before.
pub fn to_big<'a>(vm: &'a Vm<'_>, value: Value) -> Option<Cow<'a, BigInt>> {
    match value {
        Value::Int(v, _) => Some(Cow::Owned(BigInt::from(v))),
        Value::Bool(v) => Some(Cow::Owned(BigInt::from(v as i64))),
        Value::Big(r) => Some(Cow::Borrowed(&vm.heap[r])),
        _ => None,
    }
}

/// The float of a plain real number, pinned where it is traced; OverflowError for an int beyond all floats, `None` for all else.
pub fn to_float(vm: &mut Vm<'_>, value: Value) -> R<Option<f64>> {
    Ok(match int_to_float(vm, value)? {
        Some(n) => {
            vm.trace.pin(n);
            Some(n.value)
        }
        None => None,
    })
}

/// The float of a plain real number, with its handle; OverflowError for an int beyond all floats, `None` for all else.
pub fn int_to_float(vm: &mut Vm<'_>, value: Value) -> R<Option<Num>> {
    Ok(match Number::of(vm, value) {
        Some(Number::Int(v, h)) => Some(num(v as f64, h)),
        Some(Number::Float(v, h)) => Some(num(v, h)),
        Some(Number::Big(r)) => Some(Num::plain(big_to_float(vm, r)?)),
        Some(Number::Complex(_)) | None => None,
    })
}

/// The float nearest to a big int; OverflowError where none is that large.
pub fn big_to_float(vm: &mut Vm<'_>, r: Ref<BigInt>) -> R<f64> {
    let float = nearest(&vm.heap[r]);
    float.ok_or_else(|| overflow(vm))
}

pub(super) fn float_of_big(vm: &mut Vm<'_>, value: &BigInt) -> R<f64> {
    nearest(value).ok_or_else(|| overflow(vm))
}

fn nearest(value: &BigInt) -> Option<f64> {
    value.to_f64().filter(|v| v.is_finite())
}

fn overflow(vm: &mut Vm<'_>) -> Raise {
    vm.error(Builtin::OverflowError, "int too large to convert to float".into())
}

/// The int that a whole float is.
pub fn float_to_big(value: f64) -> Option<BigInt> {
    BigInt::from_f64(value)
}

/// The int of a float that `op` (of the trace's table) made from `a`; ValueError and OverflowError where it is not finite.
fn rounded(vm: &mut Vm<'_>, op: TraceOp, a: Num, result: f64) -> R<Value> {
    if !result.is_finite() {
        vm.trace.pin(a);
        return Err(if result.is_nan() {
            vm.value_error("cannot convert float NaN to integer")
        } else {
            vm.error(Builtin::OverflowError, "cannot convert float infinity to integer".into())
        });
    }
    if result.abs() < EXACT {
        let value = result as i64;
        if a.handle.is_none() {
            return Ok(Value::int(value));
        }
        let handle = vm.trace.unary(op, a, result);
        return Ok(int::keep_exact(vm, value, handle, &[a]));
    }
    vm.trace.pin(a);
    let value = BigInt::from_f64(result).unwrap_or_default();
    Ok(vm.heap.big(value))
}

/// `int(x)`: towards zero.
pub fn trunc(vm: &mut Vm<'_>, a: Num) -> R<Value> {
    rounded(vm, TraceOp::Trunc, a, a.value.trunc())
}

/// `math.floor(x)`
pub fn floor(vm: &mut Vm<'_>, a: Num) -> R<Value> {
    rounded(vm, TraceOp::Floor, a, a.value.floor())
}

/// `math.ceil(x)`
pub fn ceil(vm: &mut Vm<'_>, a: Num) -> R<Value> {
    rounded(vm, TraceOp::Ceil, a, a.value.ceil())
}

/// `round(x)`: to the nearest int, half to even.
pub(super) fn round_to_int(vm: &mut Vm<'_>, a: Num) -> R<Value> {
    rounded(vm, TraceOp::Round, a, a.value.round_ties_even())
}

/// A plain int or bool as an int with its handle; `None` for all else.
pub fn int_value(value: Value) -> Option<Value> {
    match value {
        Value::Int(..) | Value::Big(_) => Some(value),
        Value::Bool(v) => Some(Value::int(v as i64)),
        _ => None,
    }
}

/// An int has more decimal digits than may be converted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyDigits;

impl TooManyDigits {
    /// CPython's words.
    pub const MESSAGE: &'static str =
        "Exceeds the limit (4300 digits) for integer string conversion; use sys.set_int_max_str_digits() to increase the limit";

    /// The exception.
    pub fn raise(self, vm: &mut Vm<'_>) -> Raise {
        vm.value_error(TooManyDigits::MESSAGE)
    }
}

/// The decimal digits of a big int, within the limit.
pub fn int_to_string(value: &BigInt) -> Result<String, TooManyDigits> {
    if value.bits() > MAX_BITS {
        return Err(TooManyDigits);
    }
    let text = value.to_string();
    if text.trim_start_matches('-').len() > MAX_DIGITS { Err(TooManyDigits) } else { Ok(text) }
}

/// The exception for a text that is no int; `shown` is its repr.
pub fn parse_error(vm: &mut Vm<'_>, error: IntError, base: u32, shown: &str) -> Raise {
    let message = match error {
        IntError::Invalid => {
            let shown: String = shown.chars().take(200).collect();
            format!("invalid literal for int() with base {base}: {shown}")
        }
        IntError::TooManyDigits(n) => format!(
            "Exceeds the limit ({MAX_DIGITS} digits) for integer string conversion: value has {n} digits; \
             use sys.set_int_max_str_digits() to increase the limit"
        ),
    };
    vm.value_error(message)
}
