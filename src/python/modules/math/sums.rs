//! `fsum`, `hypot`, `dist`, `isclose`.

use super::float::number;
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::native::Args;
use crate::python::value::Value;
use crate::python::vm::Vm;
use crate::trace::{Arith, Num, Op, norm};

/// The exact sum, rounded once (Shewchuk's partial sums, which do not overlap).
pub(super) fn fsum(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (mut partials, mut special, mut infinities): (Vec<f64>, f64, f64) = (Vec::new(), 0.0, 0.0);
    vm.for_each(args.at(0), |vm, item| {
        let original = vm.as_float(item)?;
        let mut x = original;
        let mut kept = 0;
        for i in 0..partials.len() {
            let mut y = partials[i];
            if x.abs() < y.abs() {
                std::mem::swap(&mut x, &mut y);
            }
            let high = x + y;
            let low = y - (high - x);
            if low != 0.0 {
                partials[kept] = low;
                kept += 1;
            }
            x = high;
        }
        partials.truncate(kept);
        if x == 0.0 {
            return Ok(true);
        }
        if x.is_finite() {
            partials.push(x);
            return Ok(true);
        }
        if original.is_finite() {
            return Err(vm.error(Builtin::OverflowError, "intermediate overflow in fsum".into()));
        }
        if original.is_infinite() {
            infinities += original;
        }
        special += original;
        partials.clear();
        Ok(true)
    })?;
    if special != 0.0 {
        return if infinities.is_nan() { Err(vm.value_error("-inf + inf in fsum")) } else { Ok(Value::float(special)) };
    }
    Ok(Value::float(rounded(&partials)))
}

/// The sum of partial sums that do not overlap, in order of size, rounded half to even.
fn rounded(partials: &[f64]) -> f64 {
    let Some((&last, rest)) = partials.split_last() else { return 0.0 };
    let (mut high, mut low, mut n) = (last, 0.0, rest.len());
    while n > 0 {
        n -= 1;
        let (x, y) = (high, rest[n]);
        high = x + y;
        low = y - (high - x);
        if low != 0.0 {
            break;
        }
    }
    // Half-way cases look at the next partial.
    if n > 0 && (low < 0.0 && rest[n - 1] < 0.0 || low > 0.0 && rest[n - 1] > 0.0) {
        let y = low * 2.0;
        let x = high + y;
        if y == x - high {
            high = x;
        }
    }
    high
}

/// The length of a vector of traced numbers; the trace has it for two.
fn length(vm: &mut Vm<'_>, parts: &[Num]) -> Value {
    let values: Vec<f64> = parts.iter().map(|n| n.value).collect();
    let result = norm(&values);
    let handle = match *parts {
        [x] => vm.trace.unary(Op::Abs, x, result),
        [x, y] if result.is_finite() => vm.trace.binary(Op::Hypot, x, y, result),
        _ => {
            parts.iter().for_each(|&n| vm.trace.pin(n));
            return Value::float(result);
        }
    };
    if !handle.is_none() {
        vm.trace.finite(Num { value: result, handle });
    }
    Value::Float(result, handle)
}

pub(super) fn hypot(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let parts = args.pos.iter().map(|&v| number(vm, v)).collect::<R<Vec<Num>>>()?;
    Ok(length(vm, &parts))
}

pub(super) fn dist(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (p, q) = (vm.collect(args.at(0))?, vm.collect(args.at(1))?);
    if p.len() != q.len() {
        return Err(vm.value_error("both points must have the same number of dimensions"));
    }
    let mut parts = Vec::with_capacity(p.len());
    for (a, b) in p.into_iter().zip(q) {
        let (a, b) = (number(vm, a)?, number(vm, b)?);
        parts.push(vm.trace.sub(a, b));
    }
    Ok(length(vm, &parts))
}

pub(super) fn is_close(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if args.pos.len() > 2 {
        return Err(vm.type_error(format!("isclose() takes exactly 2 positional arguments ({} given)", args.pos.len())));
    }
    let [a, b, relative, absolute] = vm.bind("isclose", args, ["a", "b", "rel_tol", "abs_tol"], 2)?;
    let mut float = |value: Option<Value>, default: f64| value.map_or(Ok(default), |v| vm.as_float(v));
    let (a, b) = (float(a, 0.0)?, float(b, 0.0)?);
    let (relative, absolute) = (float(relative, 1e-9)?, float(absolute, 0.0)?);
    if relative < 0.0 || absolute < 0.0 {
        return Err(vm.value_error("tolerances must be non-negative"));
    }
    let gap = (b - a).abs();
    let close =
        a == b || !a.is_infinite() && !b.is_infinite() && (gap <= (relative * b).abs() || gap <= (relative * a).abs() || gap <= absolute);
    Ok(Value::Bool(close))
}
