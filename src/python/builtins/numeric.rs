//! `abs`, `round`, `divmod`, `pow`, `bin` and their like.

use crate::python::error::R;
use crate::python::native::Args;
use crate::python::numbers;
use crate::python::symbols::sym;
use crate::python::types::iterator::positional;
use crate::python::value::{BinaryOp, Value};
use crate::python::vm::Vm;
use num_bigint::Sign;

/// `abs(x)`
pub fn abs(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let x = args.at(0);
    if let Some(value) = numbers::absolute(vm, x)? {
        return Ok(value);
    }
    if let Some(method) = vm.special(x, sym::ABS) {
        return vm.call(method, &[]);
    }
    let plain = vm.plain(x);
    match numbers::absolute(vm, plain)? {
        Some(value) => Ok(value),
        None => {
            let name = vm.type_name(x);
            Err(vm.type_error(format!("bad operand type for abs(): '{name}'")))
        }
    }
}

/// `bin(x)`, `oct(x)`, `hex(x)`
pub fn in_radix(vm: &mut Vm<'_>, value: Value, prefix: &str, radix: u32) -> R<Value> {
    let big = vm.index_big(value)?;
    vm.charge(big.bits() / 8)?;
    let sign = if big.sign() == Sign::Minus { "-" } else { "" };
    let digits = big.magnitude().to_str_radix(radix);
    Ok(vm.new_str(format!("{sign}{prefix}{digits}")))
}

/// `divmod(a, b)`
pub fn divmod(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (a, b) = (args.at(0), args.at(1));
    if let Some(pair) = numbers::divmod(vm, a, b)? {
        return Ok(pair);
    }
    for (receiver, name, other) in [(a, sym::DIVMOD, b), (b, sym::RDIVMOD, a)] {
        if let Value::Instance(_) = receiver
            && let Some(method) = vm.special(receiver, name)
        {
            let result = vm.call(method, &[other])?;
            if !matches!(result, Value::NotImplemented) {
                return Ok(result);
            }
        }
    }
    let (p, q) = (vm.plain(a), vm.plain(b));
    match numbers::divmod(vm, p, q)? {
        Some(pair) => Ok(pair),
        None => {
            let (a, b) = (vm.type_name(a), vm.type_name(b));
            Err(vm.type_error(format!("unsupported operand type(s) for divmod(): '{a}' and '{b}'")))
        }
    }
}

/// `pow(base, exp, mod=None)`
pub fn pow(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let [base, exp, modulus] = vm.bind("pow", args, ["base", "exp", "mod"], 2)?;
    let (base, exp) = (base.unwrap_or(Value::None), exp.unwrap_or(Value::None));
    let modulus = match modulus {
        None | Some(Value::None) => return vm.binary(BinaryOp::Pow, base, exp),
        Some(modulus) => modulus,
    };
    if let Value::Instance(_) = base
        && let Some(method) = vm.special(base, sym::POW)
        && !vm.is_native(method)
    {
        let result = vm.call(method, &[exp, modulus])?;
        if !matches!(result, Value::NotImplemented) {
            return Ok(result);
        }
    }
    let (p, q, m) = (vm.plain(base), vm.plain(exp), vm.plain(modulus));
    if let Some(result) = numbers::pow_mod(vm, p, q, m)? {
        return Ok(result);
    }
    let number = |v: Value| matches!(v, Value::Int(..) | Value::Bool(_) | Value::Big(_) | Value::Float(..));
    if matches!((p, q), (Value::Complex(_), _) | (_, Value::Complex(_))) && number(m) {
        return Err(vm.value_error("complex modulo"));
    }
    if number(p) && number(q) && number(m) {
        return Err(vm.type_error("pow() 3rd argument not allowed unless all arguments are integers"));
    }
    let (base, exp, modulus) = (vm.type_name(base), vm.type_name(exp), vm.type_name(modulus));
    Err(vm.type_error(format!("unsupported operand type(s) for ** or pow(): '{base}', '{exp}', '{modulus}'")))
}

/// `round(number, ndigits=None)`
pub fn round(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if args.kw.is_empty() && args.pos.len() > 2 {
        positional(vm, "round", &args, 1, 2)?;
    }
    let [number, ndigits] = vm.bind("round", args, ["number", "ndigits"], 1)?;
    let number = number.unwrap_or(Value::None);
    if let Some(rounded) = numbers::round(vm, number, ndigits)? {
        return Ok(rounded);
    }
    if let Some(method) = vm.special(number, sym::ROUND) {
        return match ndigits.filter(|n| !n.is_none()) {
            Some(n) => vm.call(method, &[n]),
            None => vm.call(method, &[]),
        };
    }
    let plain = vm.plain(number);
    match numbers::round(vm, plain, ndigits)? {
        Some(rounded) => Ok(rounded),
        None => {
            let name = vm.type_name(number);
            Err(vm.type_error(format!("type {name} doesn't define __round__ method")))
        }
    }
}
