//! Functions of ints, of any size; and `prod`.

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::native::Args;
use crate::python::numbers;
use crate::python::value::{BinaryOp, Value};
use crate::python::vm::Vm;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// Asks for the steps and the memory that a product of so many bits takes.
fn afford(vm: &mut Vm<'_>, bits: f64) -> R<()> {
    vm.reserve((bits / 8.0) as usize)?;
    let limbs = bits / 64.0;
    vm.charge((limbs * limbs / 64.0) as u64)
}

/// `low · (low + 1) · … · high`, halved again and again so that the factors stay of one size.
fn product(low: u64, high: u64) -> BigInt {
    if low > high {
        return BigInt::one();
    }
    if high - low < 16 {
        return (low..=high).fold(BigInt::one(), |acc, n| acc * n);
    }
    let middle = low + (high - low) / 2;
    product(low, middle) * product(middle + 1, high)
}

pub(super) fn factorial(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let n = vm.index_big(args.at(0))?;
    factorial_of(vm, &n)
}

fn factorial_of(vm: &mut Vm<'_>, n: &BigInt) -> R<Value> {
    if n.is_negative() {
        return Err(vm.value_error("factorial() not defined for negative values"));
    }
    let Some(n) = n.to_i64() else {
        return Err(vm.error(Builtin::OverflowError, format!("factorial() argument should not exceed {}", i64::MAX)));
    };
    afford(vm, n as f64 * (n.max(2) as f64).log2())?;
    let result = product(2, n as u64);
    Ok(vm.heap.big(result))
}

fn not_negative(vm: &mut Vm<'_>, value: Value, name: &str) -> R<BigInt> {
    let value = vm.index_big(value)?;
    if value.is_negative() { Err(vm.value_error(format!("{name} must be a non-negative integer"))) } else { Ok(value) }
}

/// `n · (n − 1) · …`, `k` factors; and, for `comb`, divided by k! on the way.
fn falling(vm: &mut Vm<'_>, n: &BigInt, k: u64, divide: bool) -> R<BigInt> {
    let mut result = BigInt::one();
    for i in 0..k {
        vm.charge(1 + result.bits() / 256)?;
        if i % 64 == 0 {
            vm.reserve((result.bits() / 8) as usize)?;
        }
        result *= n - i;
        if divide {
            result /= i + 1;
        }
    }
    Ok(result)
}

pub(super) fn comb(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (n, k) = (vm.index_big(args.at(0))?, vm.index_big(args.at(1))?);
    for (value, name) in [(&n, "n"), (&k, "k")] {
        if value.is_negative() {
            return Err(vm.value_error(format!("{name} must be a non-negative integer")));
        }
    }
    if k > n {
        return Ok(Value::int(0));
    }
    let k = k.clone().min(&n - k);
    let Some(k) = k.to_i64() else {
        return Err(vm.error(Builtin::OverflowError, format!("min(n - k, k) must not exceed {}", i64::MAX)));
    };
    let result = falling(vm, &n, k as u64, true)?;
    Ok(vm.heap.big(result))
}

pub(super) fn perm(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some(k) = args.get(1).filter(|k| !k.is_none()) else { return factorial(vm, args) };
    let n = not_negative(vm, args.at(0), "n")?;
    let k = not_negative(vm, k, "k")?;
    if k > n {
        return Ok(Value::int(0));
    }
    let Some(k) = k.to_i64() else {
        return Err(vm.error(Builtin::OverflowError, format!("k must not exceed {}", i64::MAX)));
    };
    let result = falling(vm, &n, k as u64, false)?;
    Ok(vm.heap.big(result))
}

fn folded(vm: &mut Vm<'_>, args: Args<'_>, start: i64, f: fn(&BigInt, &BigInt) -> BigInt) -> R<Value> {
    let mut result = BigInt::from(start);
    for &value in args.pos {
        let value = vm.index_big(value)?;
        let limbs = (result.bits().max(value.bits()) / 64) + 1;
        vm.charge(limbs.saturating_mul(limbs).saturating_mul(4) + 8)?;
        result = f(&result, &value);
    }
    Ok(vm.heap.big(result))
}

pub(super) fn gcd(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    folded(vm, args, 0, |a, b| a.gcd(b))
}

pub(super) fn lcm(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    folded(vm, args, 1, |a, b| if a.is_zero() || b.is_zero() { BigInt::zero() } else { a.lcm(b).abs() })
}

pub(super) fn isqrt(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let n = vm.index_big(args.at(0))?;
    if n.is_negative() {
        return Err(vm.value_error("isqrt() argument must be nonnegative"));
    }
    let root = numbers::isqrt(vm, &n)?;
    Ok(vm.heap.big(root))
}

/// `prod(iterable, *, start=1)`
pub(super) fn prod(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if args.pos.len() > 1 {
        return Err(vm.type_error(format!("prod() takes exactly 1 positional argument ({} given)", args.pos.len())));
    }
    let [iterable, start] = vm.bind("prod", args, ["", "start"], 1)?;
    let mut total = start.unwrap_or(Value::int(1));
    vm.for_each(iterable.unwrap_or(Value::None), |vm, item| {
        total = vm.binary(BinaryOp::Mul, total, item)?;
        Ok(true)
    })?;
    Ok(total)
}
