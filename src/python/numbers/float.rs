//! Floats.

use super::{num, out_of_range, zero_division};
use crate::python::error::R;
use crate::python::heap::Complex;
use crate::python::value::{BinaryOp, Value};
use crate::python::vm::Vm;
use crate::trace::{Num, Op as TraceOp};
pub use crate::trace::{float_divmod, float_floor_div, float_mod};

/// Whether floats take the operator.
pub(super) fn takes(op: BinaryOp) -> bool {
    use BinaryOp::*;
    matches!(op, Add | Sub | Mul | Div | FloorDiv | Mod | Pow)
}

/// `a op b`
#[inline]
pub(super) fn binary(vm: &mut Vm<'_>, op: BinaryOp, a: Num, b: Num) -> R<Option<Value>> {
    let (x, y) = (a.value, b.value);
    let (op, result) = match op {
        BinaryOp::Add => (TraceOp::Add, x + y),
        BinaryOp::Sub => (TraceOp::Sub, x - y),
        BinaryOp::Mul => (TraceOp::Mul, x * y),
        BinaryOp::Div | BinaryOp::FloorDiv | BinaryOp::Mod => {
            vm.trace.zero(b);
            if y == 0.0 {
                return Err(zero_division(
                    vm,
                    match op {
                        BinaryOp::Div => "float division by zero",
                        BinaryOp::FloorDiv => "float floor division by zero",
                        _ => "float modulo",
                    },
                ));
            }
            match op {
                BinaryOp::Div => (TraceOp::Div, x / y),
                BinaryOp::FloorDiv => (TraceOp::FloorDiv, float_floor_div(x, y)),
                _ => (TraceOp::Mod, float_mod(x, y)),
            }
        }
        BinaryOp::Pow => return power(vm, a, b).map(Some),
        _ => return Ok(None),
    };
    let handle = vm.trace.binary(op, a, b, result);
    Ok(Some(Value::Float(result, handle)))
}

/// `a ** b`, with the guards that keep a replay within this branch.
pub(super) fn power(vm: &mut Vm<'_>, a: Num, b: Num) -> R<Value> {
    let (x, y) = (a.value, b.value);
    let traced = !(a.handle.is_none() && b.handle.is_none());
    if traced {
        vm.trace.order(a, Num::plain(0.0));
        if x == 0.0 {
            vm.trace.order(b, Num::plain(0.0));
        } else if x < 0.0 {
            vm.trace.pin(b);
        }
    }
    if x == 0.0 && y < 0.0 {
        return Err(zero_division(vm, "0.0 cannot be raised to a negative power"));
    }
    if x < 0.0 && x.is_finite() && y.is_finite() && y != y.floor() {
        vm.trace.pin(a);
        let (base, exponent) = (Complex { re: x, im: 0.0 }, Complex { re: y, im: 0.0 });
        return Ok(super::complex::binary(vm, BinaryOp::Pow, base, exponent)?.unwrap_or(Value::NotImplemented));
    }
    let result = libm::pow(x, y);
    let overflows = result.is_infinite() && x.is_finite() && y.is_finite();
    if overflows {
        vm.trace.pin(a);
        vm.trace.pin(b);
        return Err(out_of_range(vm));
    }
    let handle = vm.trace.binary(TraceOp::Pow, a, b, result);
    if traced {
        let magnitude = vm.trace.unary(TraceOp::Abs, num(result, handle), result.abs());
        vm.trace.order(num(result.abs(), magnitude), Num::plain(f64::INFINITY));
    }
    Ok(Value::Float(result, handle))
}
