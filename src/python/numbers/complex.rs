//! Complex numbers: the algorithms of CPython's `complexobject.c`. What enters one loses its handle.

use super::{Number, big_to_float, zero_division};
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::Complex;
use crate::python::value::{BinaryOp, Value};
use crate::python::vm::Vm;

/// The complex number of any number; a traced one is pinned.
pub fn complex_of(vm: &mut Vm<'_>, a: Number) -> R<Complex> {
    let re = match a {
        Number::Complex(c) => return Ok(c),
        Number::Int(v, h) => {
            vm.pin(Value::Int(v, h));
            v as f64
        }
        Number::Float(v, h) => {
            vm.pin(Value::Float(v, h));
            v
        }
        Number::Big(r) => big_to_float(vm, r)?,
    };
    Ok(Complex { re, im: 0.0 })
}

/// `a op b`
pub(super) fn binary(vm: &mut Vm<'_>, op: BinaryOp, a: Complex, b: Complex) -> R<Option<Value>> {
    let result = match op {
        BinaryOp::Add => Complex { re: a.re + b.re, im: a.im + b.im },
        BinaryOp::Sub => Complex { re: a.re - b.re, im: a.im - b.im },
        BinaryOp::Mul => multiply(a, b),
        BinaryOp::Div => match divide(a, b) {
            Some(result) => result,
            None => return Err(zero_division(vm, "complex division by zero")),
        },
        BinaryOp::Pow => {
            if a.re == 0.0 && a.im == 0.0 && (b.re < 0.0 || b.im != 0.0) {
                return Err(zero_division(vm, "0.0 to a negative or complex power"));
            }
            let result = if b.im == 0.0 && b.re == b.re.floor() && b.re.abs() <= 100.0 { integer_power(a, b.re as i64) } else { pow(a, b) };
            match result {
                Some(r) if r.re.is_infinite() || r.im.is_infinite() => {
                    return Err(vm.error(Builtin::OverflowError, "complex exponentiation".into()));
                }
                Some(r) => r,
                None => return Err(zero_division(vm, "0.0 to a negative or complex power")),
            }
        }
        _ => return Ok(None),
    };
    Ok(Some(Value::Complex(vm.heap.alloc(result))))
}

fn multiply(a: Complex, b: Complex) -> Complex {
    Complex { re: a.re * b.re - a.im * b.im, im: a.re * b.im + a.im * b.re }
}

fn divide(a: Complex, b: Complex) -> Option<Complex> {
    if b.re.abs() >= b.im.abs() {
        if b.re == 0.0 {
            return None;
        }
        let ratio = b.im / b.re;
        let denominator = b.re + b.im * ratio;
        Some(Complex { re: (a.re + a.im * ratio) / denominator, im: (a.im - a.re * ratio) / denominator })
    } else if b.im.abs() >= b.re.abs() {
        let ratio = b.re / b.im;
        let denominator = b.re * ratio + b.im;
        Some(Complex { re: (a.re * ratio + a.im) / denominator, im: (a.im * ratio - a.re) / denominator })
    } else {
        Some(Complex { re: f64::NAN, im: f64::NAN })
    }
}

fn integer_power(a: Complex, exponent: i64) -> Option<Complex> {
    let one = Complex { re: 1.0, im: 0.0 };
    let (mut result, mut power) = (one, a);
    let n = exponent.unsigned_abs();
    let mut mask = 1u64;
    while mask <= n {
        if n & mask != 0 {
            result = multiply(result, power);
        }
        mask <<= 1;
        power = multiply(power, power);
    }
    if exponent > 0 { Some(result) } else { divide(one, result) }
}

/// `a ** b` for a ≠ 0, by polar coordinates; `None` where the angle is infinite.
fn pow(a: Complex, b: Complex) -> Option<Complex> {
    if b.re == 0.0 && b.im == 0.0 {
        return Some(Complex { re: 1.0, im: 0.0 });
    }
    if a.re == 0.0 && a.im == 0.0 {
        return Some(Complex { re: 0.0, im: 0.0 });
    }
    let length = libm::hypot(a.re, a.im);
    let angle = libm::atan2(a.im, a.re);
    let (mut size, mut phase) = (libm::pow(length, b.re), angle * b.re);
    if b.im != 0.0 {
        size *= libm::exp(-angle * b.im);
        phase += b.im * libm::log(length);
    }
    (!phase.is_infinite()).then(|| Complex { re: size * libm::cos(phase), im: size * libm::sin(phase) })
}

/// `abs(c)`
pub fn complex_abs(vm: &mut Vm<'_>, c: Complex) -> R<f64> {
    let result = libm::hypot(c.re, c.im);
    if result.is_infinite() && c.re.is_finite() && c.im.is_finite() {
        return Err(vm.error(Builtin::OverflowError, "absolute value too large".into()));
    }
    Ok(result)
}
