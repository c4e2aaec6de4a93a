//! Functions of one or two floats.

use super::pair;
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::native::Args;
use crate::python::numbers;
use crate::python::symbols::sym;
use crate::python::value::{BinaryOp, Value};
use crate::python::vm::Vm;
use crate::trace::{Arith, Num, Op};
use num_bigint::{BigInt, Sign};
use num_traits::ToPrimitive;

pub(super) fn domain(vm: &mut Vm<'_>) -> Raise {
    vm.value_error("math domain error")
}

pub(super) fn range(vm: &mut Vm<'_>) -> Raise {
    vm.error(Builtin::OverflowError, "math range error".into())
}

/// The argument as a float, with its handle.
pub(super) fn number(vm: &mut Vm<'_>, value: Value) -> R<Num> {
    match value {
        Value::Float(value, handle) => Ok(Num { value, handle }),
        Value::Instance(_) => Ok(Num::plain(vm.as_float(value)?)),
        _ => match numbers::int_to_float(vm, value)? {
            Some(num) => Ok(num),
            None => Ok(Num::plain(vm.as_float(value)?)),
        },
    }
}

/// A function of one float.
pub(super) struct One {
    /// What it computes.
    pub function: fn(f64) -> f64,
    /// The operation of the trace that does the same.
    pub op: Option<Op>,
    /// Whether an infinite result means that it is too large; where not, that the argument is outside the domain.
    pub overflows: bool,
}

/// Applies it as CPython does: errors are told by results that are not finite.
pub(super) fn one(vm: &mut Vm<'_>, value: Value, of: One) -> R<Value> {
    let x = number(vm, value)?;
    let result = (of.function)(x.value);
    if !result.is_finite() {
        vm.trace.pin(x);
        if result.is_nan() && !x.value.is_nan() || result.is_infinite() && x.value.is_finite() && !of.overflows {
            return Err(domain(vm));
        }
        if result.is_infinite() && x.value.is_finite() {
            return Err(range(vm));
        }
        return Ok(Value::float(result));
    }
    let Some(op) = of.op else {
        vm.trace.pin(x);
        return Ok(Value::float(result));
    };
    Ok(unary(vm, op, x, result))
}

/// Records a result that is finite and must stay so: an argument for which the function raises makes it infinite or NaN.
fn unary(vm: &mut Vm<'_>, op: Op, x: Num, result: f64) -> Value {
    let handle = vm.trace.unary(op, x, result);
    if !handle.is_none() {
        vm.trace.finite(Num { value: result, handle });
    }
    Value::Float(result, handle)
}

fn binary(vm: &mut Vm<'_>, op: Op, [x, y]: [Num; 2], result: f64) -> Value {
    if !result.is_finite() {
        vm.trace.pin(x);
        vm.trace.pin(y);
        return Value::float(result);
    }
    let handle = vm.trace.binary(op, x, y, result);
    if !handle.is_none() {
        vm.trace.finite(Num { value: result, handle });
    }
    Value::Float(result, handle)
}

fn numbers_of(vm: &mut Vm<'_>, args: &Args<'_>) -> R<[Num; 2]> {
    let [x, y] = pair(args);
    Ok([number(vm, x)?, number(vm, y)?])
}

pub(super) fn atan2(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let [y, x] = numbers_of(vm, &args)?;
    Ok(binary(vm, Op::Atan2, [y, x], libm::atan2(y.value, x.value)))
}

pub(super) fn copysign(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let [x, y] = numbers_of(vm, &args)?;
    Ok(binary(vm, Op::Copysign, [x, y], x.value.copysign(y.value)))
}

pub(super) fn fmod(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let [x, y] = numbers_of(vm, &args)?;
    if y.value.is_infinite() && x.value.is_finite() {
        vm.trace.pin(y);
        return Ok(Value::Float(x.value, x.handle));
    }
    let result = libm::fmod(x.value, y.value);
    let value = binary(vm, Op::Fmod, [x, y], result);
    if result.is_nan() && !x.value.is_nan() && !y.value.is_nan() { Err(domain(vm)) } else { Ok(value) }
}

pub(super) fn pow(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let [x, y] = numbers_of(vm, &args)?;
    let result = libm::pow(x.value, y.value);
    let finite = x.value.is_finite() && y.value.is_finite();
    if finite && result.is_finite() && x.value > 0.0 {
        // Beyond this the operator `**` and `math.pow` part: the guard keeps a replay where they agree.
        vm.trace.order(x, Num::plain(0.0));
        return Ok(binary(vm, Op::Pow, [x, y], result));
    }
    vm.trace.pin(x);
    vm.trace.pin(y);
    if finite && result.is_nan() || finite && result.is_infinite() && x.value == 0.0 {
        return Err(domain(vm));
    }
    if finite && result.is_infinite() {
        return Err(range(vm));
    }
    Ok(Value::float(result))
}

pub(super) fn remainder(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let [x, y] = numbers_of(vm, &args)?;
    vm.trace.pin(x);
    vm.trace.pin(y);
    let (x, y) = (x.value, y.value);
    if x.is_nan() || y.is_nan() {
        return Ok(Value::float(f64::NAN));
    }
    if x.is_infinite() || y == 0.0 {
        return Err(domain(vm));
    }
    Ok(Value::float(if y.is_infinite() { x } else { libm::remainder(x, y) }))
}

/// `x · 180/π`
pub(super) fn degrees(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let x = number(vm, args.at(0))?;
    let result = x.value * (180.0 / std::f64::consts::PI);
    let handle = vm.trace.unary(Op::Degrees, x, result);
    Ok(Value::Float(result, handle))
}

/// `x · π/180`
pub(super) fn radians(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let x = number(vm, args.at(0))?;
    let result = x.value * (std::f64::consts::PI / 180.0);
    let handle = vm.trace.unary(Op::Radians, x, result);
    Ok(Value::Float(result, handle))
}

/// The logarithm of a positive number; ints may be larger than any float.
pub(super) fn logarithm(vm: &mut Vm<'_>, value: Value, function: fn(f64) -> f64, op: Option<Op>) -> R<Value> {
    if let Value::Big(b) = vm.plain(value) {
        let big = vm.heap[b].clone();
        if big.sign() == Sign::Minus {
            return Err(domain(vm));
        }
        let shift = big.bits().saturating_sub(1000);
        let head = (&big >> shift).to_f64().unwrap_or(f64::INFINITY);
        let (mantissa, exponent) = libm::frexp(head);
        return Ok(Value::float(function(mantissa) + function(2.0) * (exponent as f64 + shift as f64)));
    }
    one(vm, value, One { function, op, overflows: false })
}

pub(super) fn log(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    match *args.pos {
        [x] => logarithm(vm, x, libm::log, Some(Op::Log)),
        [x, base] => {
            let x = logarithm(vm, x, libm::log, Some(Op::Log))?;
            let base = logarithm(vm, base, libm::log, Some(Op::Log))?;
            vm.binary(BinaryOp::Div, x, base)
        }
        _ => Err(vm.type_error("math.log requires 1 to 2 arguments")),
    }
}

pub(super) fn gamma(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let x = number(vm, args.at(0))?;
    vm.trace.pin(x);
    let (x, result) = (x.value, libm::tgamma(x.value));
    if x == f64::NEG_INFINITY || x.is_finite() && x <= 0.0 && x == x.floor() {
        return Err(domain(vm));
    }
    if result.is_infinite() && x.is_finite() {
        return Err(range(vm));
    }
    Ok(Value::float(result))
}

pub(super) fn lgamma(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let x = number(vm, args.at(0))?;
    vm.trace.pin(x);
    let x = x.value;
    if x.is_finite() && x <= 0.0 && x == x.floor() {
        return Err(domain(vm));
    }
    let result = if x.is_infinite() { f64::INFINITY } else { libm::lgamma(x) };
    if result.is_infinite() && x.is_finite() { Err(range(vm)) } else { Ok(Value::float(result)) }
}

/// `floor` and `ceil`: of floats here, of other objects by their own method.
fn rounded(vm: &mut Vm<'_>, value: Value, method: crate::python::value::Symbol, round: fn(&mut Vm<'_>, Num) -> R<Value>) -> R<Value> {
    if let Some(int) = numbers::int_value(value) {
        return Ok(int);
    }
    if let Value::Instance(_) = value
        && let Some(method) = vm.special(value, method)
        && !vm.is_native(method)
    {
        return vm.call(method, &[]);
    }
    if let Some(int) = numbers::int_value(vm.plain(value)) {
        return Ok(int);
    }
    let x = number(vm, value)?;
    round(vm, x)
}

pub(super) fn floor(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    rounded(vm, args.at(0), sym::FLOOR, numbers::floor)
}

pub(super) fn ceil(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    rounded(vm, args.at(0), sym::CEIL, numbers::ceil)
}

pub(super) fn trunc(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    match args.at(0) {
        Value::Float(value, handle) => numbers::trunc(vm, Num { value, handle }),
        other => {
            if let Some(int) = numbers::int_value(other) {
                return Ok(int);
            }
            match vm.special(other, sym::TRUNC) {
                Some(method) => vm.call(method, &[]),
                None => {
                    let name = vm.type_name(other);
                    Err(vm.type_error(format!("type {name} doesn't define __trunc__ method")))
                }
            }
        }
    }
}

pub(super) fn frexp(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let x = number(vm, args.at(0))?;
    vm.trace.pin(x);
    let (mantissa, exponent) = if x.value.is_finite() { libm::frexp(x.value) } else { (x.value, 0) };
    Ok(vm.new_tuple([Value::float(mantissa), Value::int(exponent.into())].as_slice()))
}

pub(super) fn ldexp(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let x = number(vm, args.at(0))?;
    vm.trace.pin(x);
    let exponent = match vm.plain(args.at(1)) {
        int @ (Value::Int(..) | Value::Bool(_) | Value::Big(_)) => vm.index_big(int)?,
        _ => return Err(vm.type_error("Expected an int as second argument to ldexp.")),
    };
    let clipped = exponent.clamp(BigInt::from(-100_000), BigInt::from(100_000)).to_i32().unwrap_or(0);
    let result = libm::ldexp(x.value, clipped);
    if result.is_infinite() && x.value.is_finite() { Err(range(vm)) } else { Ok(Value::float(result)) }
}

pub(super) fn modf(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let x = number(vm, args.at(0))?;
    vm.trace.pin(x);
    let x = x.value;
    let (fraction, whole) = if x.is_infinite() { (0f64.copysign(x), x) } else { ((x - x.trunc()).copysign(x), x.trunc()) };
    Ok(vm.new_tuple([Value::float(fraction), Value::float(whole)].as_slice()))
}

pub(super) fn nextafter(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let [x, y] = numbers_of(vm, &args)?;
    vm.trace.pin(x);
    vm.trace.pin(y);
    Ok(Value::float(libm::nextafter(x.value, y.value)))
}

pub(super) fn ulp(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let x = number(vm, args.at(0))?;
    vm.trace.pin(x);
    let x = x.value.abs();
    if !x.is_finite() {
        return Ok(Value::float(x));
    }
    let next = libm::nextafter(x, f64::INFINITY);
    Ok(Value::float(if next.is_infinite() { x - libm::nextafter(x, 0.0) } else { next - x }))
}

/// `isfinite`, `isinf`, `isnan`: of a finite number all that matters is that it stays finite.
pub(super) fn classify(vm: &mut Vm<'_>, args: Args<'_>, test: fn(f64) -> bool) -> R<Value> {
    let x = number(vm, args.at(0))?;
    if x.value.is_finite() {
        vm.trace.finite(x);
    } else {
        vm.trace.pin(x);
    }
    Ok(Value::Bool(test(x.value)))
}
