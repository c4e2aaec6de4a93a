//! Comparison and hashes.

use super::{EXACT, Number, num};
use crate::python::error::R;
use crate::python::heap::Complex;
use crate::python::value::{CompareOp, Value};
use crate::python::vm::Vm;
use num_bigint::{BigInt, Sign};
use num_traits::{FromPrimitive, ToPrimitive};
use std::cmp::Ordering;

/// `a op b` of plain numbers, exact between ints and floats of any size, and guarded; `None` where the types do not take the operator.
pub fn compare(vm: &mut Vm<'_>, op: CompareOp, a: Value, b: Value) -> R<Option<bool>> {
    let (Some(x), Some(y)) = (Number::of(vm, a), Number::of(vm, b)) else { return Ok(None) };
    if let (Number::Complex(_), _) | (_, Number::Complex(_)) = (x, y) {
        return Ok(match op {
            CompareOp::Eq => Some(complex_equal(vm, x, y)),
            CompareOp::Ne => Some(!complex_equal(vm, x, y)),
            _ => None,
        });
    }
    guard(vm, x, y);
    Ok(Some(match order(vm, x, y) {
        Some(order) => op.holds(order),
        None => op == CompareOp::Ne,
    }))
}

/// Records how the two compare, as floats where these are exact; else their very values.
#[inline]
fn guard(vm: &mut Vm<'_>, x: Number, y: Number) {
    let exact = |n: Number| match n {
        Number::Int(v, h) => Some(num(v as f64, h)).filter(|n| n.value.abs() < EXACT),
        Number::Float(v, h) => Some(num(v, h)),
        _ => None,
    };
    match (exact(x), exact(y)) {
        (Some(a), Some(b)) => vm.trace.order(a, b),
        (Some(a), None) | (None, Some(a)) => vm.trace.pin(a),
        (None, None) => {}
    }
}

fn order(vm: &Vm<'_>, x: Number, y: Number) -> Option<Ordering> {
    match (x, y) {
        (Number::Int(a, _), Number::Int(b, _)) => Some(a.cmp(&b)),
        (Number::Float(a, _), Number::Float(b, _)) => a.partial_cmp(&b),
        (Number::Int(a, _), Number::Float(b, _)) => int_with_float(a, b),
        (Number::Float(a, _), Number::Int(b, _)) => int_with_float(b, a).map(Ordering::reverse),
        (Number::Big(a), Number::Big(b)) => Some(vm.heap[a].cmp(&vm.heap[b])),
        (Number::Big(a), Number::Float(b, _)) => big_with_float(&vm.heap[a], b),
        (Number::Float(a, _), Number::Big(b)) => big_with_float(&vm.heap[b], a).map(Ordering::reverse),
        // A big int is beyond every int of 64 bits.
        (Number::Big(a), Number::Int(..)) => Some(if vm.heap[a].sign() == Sign::Minus { Ordering::Less } else { Ordering::Greater }),
        (Number::Int(..), Number::Big(b)) => Some(if vm.heap[b].sign() == Sign::Minus { Ordering::Greater } else { Ordering::Less }),
        (Number::Complex(_), _) | (_, Number::Complex(_)) => None,
    }
}

fn int_with_float(a: i64, b: f64) -> Option<Ordering> {
    if a.unsigned_abs() <= EXACT as u64 {
        return (a as f64).partial_cmp(&b);
    }
    if b.is_nan() {
        None
    } else if b >= 9_223_372_036_854_775_808.0 {
        Some(Ordering::Less)
    } else if b < -9_223_372_036_854_775_808.0 {
        Some(Ordering::Greater)
    } else {
        Some(a.cmp(&(b as i64)).then_with(|| 0.0.partial_cmp(&b.fract()).unwrap_or(Ordering::Equal)))
    }
}

fn big_with_float(a: &BigInt, b: f64) -> Option<Ordering> {
    if b.is_nan() {
        return None;
    }
    // Where it is infinite, or too small to count beside a big int, its sign or the int's decides.
    Some(match BigInt::from_f64(b) {
        Some(b) => a.cmp(&b),
        None if b > 0.0 => Ordering::Less,
        None => Ordering::Greater,
    })
}

fn complex_equal(vm: &mut Vm<'_>, x: Number, y: Number) -> bool {
    let (complex, other) = match (x, y) {
        (Number::Complex(a), Number::Complex(b)) => return a.re == b.re && a.im == b.im,
        (Number::Complex(c), other) | (other, Number::Complex(c)) => (c, other),
        _ => return false,
    };
    guard(vm, Number::Float(complex.re, Default::default()), other);
    complex.im == 0.0 && order(vm, Number::Float(complex.re, Default::default()), other) == Some(Ordering::Equal)
}

const MODULUS: u64 = (1 << 61) - 1;

/// CPython's hash of a plain number; a traced one is pinned. `None` for all else.
pub fn hash_number(vm: &mut Vm<'_>, a: Value) -> Option<i64> {
    let a = vm.pin(a);
    Some(match Number::of(vm, a)? {
        Number::Int(v, _) => hash_int(v),
        Number::Big(r) => hash_big(&vm.heap[r]),
        Number::Float(v, _) => hash_float(v),
        Number::Complex(Complex { re, im }) => match hash_float(re).wrapping_add(hash_float(im).wrapping_mul(1_000_003)) {
            -1 => -2,
            hash => hash,
        },
    })
}

fn hash_int(v: i64) -> i64 {
    let hash = (v.unsigned_abs() % MODULUS) as i64;
    match if v < 0 { -hash } else { hash } {
        -1 => -2,
        hash => hash,
    }
}

/// CPython's hash of a big int.
pub fn hash_big(v: &BigInt) -> i64 {
    let hash = (v.magnitude() % MODULUS).to_i64().unwrap_or(0);
    match if v.sign() == Sign::Minus { -hash } else { hash } {
        -1 => -2,
        hash => hash,
    }
}

/// CPython's hash of a float: that of the int it equals, else one that fractions and decimals share; 0 for a NaN.
pub fn hash_float(v: f64) -> i64 {
    if v.is_infinite() {
        return if v > 0.0 { 314_159 } else { -314_159 };
    }
    if v.is_nan() {
        return 0;
    }
    let (mut mantissa, mut exponent) = libm::frexp(v.abs());
    let mut hash: u64 = 0;
    while mantissa != 0.0 {
        hash = ((hash << 28) & MODULUS) | (hash >> (61 - 28));
        mantissa *= 268_435_456.0;
        exponent -= 28;
        let part = mantissa as u64;
        mantissa -= part as f64;
        hash += part;
        if hash >= MODULUS {
            hash -= MODULUS;
        }
    }
    let turn = exponent.rem_euclid(61) as u32;
    hash = ((hash << turn) & MODULUS) | (hash >> (61 - turn));
    let hash = hash as i64;
    match if v < 0.0 { -hash } else { hash } {
        -1 => -2,
        hash => hash,
    }
}
