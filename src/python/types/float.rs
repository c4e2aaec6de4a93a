//! `float`: its constructor and methods.

use super::number::{self, FLOAT, this};
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::native::{ANY, Args, Native};
use crate::python::numbers;
use crate::python::symbols::sym;
use crate::python::text;
use crate::python::value::Value;
use crate::python::vm::Vm;
use crate::trace::Num;
use num_bigint::BigInt;

/// `float(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if !args.kw.is_empty() {
        return Err(vm.type_error("float() takes no keyword arguments"));
    }
    match *args.pos {
        [] => Ok(Value::float(0.0)),
        [value] => convert(vm, value),
        _ => Err(vm.type_error(format!("float expected at most 1 argument, got {}", args.pos.len()))),
    }
}

/// A real number as a float, with its handle.
pub(super) fn of_number(vm: &mut Vm<'_>, value: Value) -> R<Value> {
    Ok(match numbers::int_to_float(vm, value)? {
        Some(Num { value, handle }) => Value::Float(value, handle),
        None => Value::NotImplemented,
    })
}

/// A NaN that is no other NaN: identity compares bits.
fn new_nan(vm: &mut Vm<'_>) -> f64 {
    vm.nans = vm.nans.wrapping_add(1);
    f64::from_bits(f64::NAN.to_bits() | u64::from(vm.nans))
}

fn convert(vm: &mut Vm<'_>, value: Value) -> R<Value> {
    if matches!(value, Value::Int(..) | Value::Float(..) | Value::Bool(_) | Value::Big(_)) {
        return of_number(vm, value);
    }
    let plain = vm.plain(value);
    let text = match plain {
        Value::Str(s) => Some(vm.heap[s].text.to_string()),
        Value::Bytes(b) => Some(super::bytes::latin1(&vm.heap[b].0)),
        Value::ByteArray(b) => Some(super::bytes::latin1(&vm.heap[b].0)),
        _ => None,
    };
    if let Some(text) = text {
        vm.charge(text.len() as u64 / 16)?;
        return match numbers::parse_float(&text) {
            Some(float) if float.is_nan() => Ok(Value::float(new_nan(vm))),
            Some(float) => Ok(Value::float(float)),
            None => {
                let shown = vm.repr(plain)?;
                Err(vm.value_error(format!("could not convert string to float: {shown}")))
            }
        };
    }
    if let Some(float) = by_methods(vm, value)? {
        return Ok(Value::float(float));
    }
    let class = vm.type_name(value);
    Err(vm.type_error(format!("float() argument must be a string or a real number, not '{class}'")))
}

/// The float that `__float__` or `__index__` gives, if there is one of them.
pub(super) fn by_methods(vm: &mut Vm<'_>, value: Value) -> R<Option<f64>> {
    if let Some(method) = vm.special(value, sym::FLOAT) {
        let result = vm.call(method, &[])?;
        let plain = vm.plain(result);
        return match vm.pin(plain) {
            Value::Float(v, _) => Ok(Some(v)),
            _ => {
                let (owner, class) = (vm.type_name(value), vm.type_name(result));
                Err(vm.type_error(format!("{owner}.__float__ returned non-float (type {class})")))
            }
        };
    }
    if vm.special(value, sym::INDEX).is_none() {
        return Ok(None);
    }
    let index = vm.index_big(value)?;
    let index = vm.heap.big(index);
    numbers::to_float(vm, index)
}

/// The receiver, with its handle.
fn num(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Num> {
    Ok(match this::<FLOAT>(vm, args)? {
        Value::Float(value, handle) => Num { value, handle },
        _ => Num::plain(0.0),
    })
}

/// The receiver, pinned.
fn pinned(vm: &mut Vm<'_>, args: &Args<'_>) -> R<f64> {
    let num = num(vm, args)?;
    vm.trace.pin(num);
    Ok(num.value)
}

fn zero(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    this::<FLOAT>(vm, &args)?;
    Ok(Value::float(0.0))
}

fn trunc(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let num = num(vm, &args)?;
    numbers::trunc(vm, num)
}

fn floor(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let num = num(vm, &args)?;
    numbers::floor(vm, num)
}

fn ceil(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let num = num(vm, &args)?;
    numbers::ceil(vm, num)
}

fn is_integer(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let v = pinned(vm, &args)?;
    Ok(Value::Bool(v.is_finite() && v == v.floor()))
}

fn as_integer_ratio(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let v = pinned(vm, &args)?;
    if v.is_infinite() {
        return Err(vm.error(Builtin::OverflowError, "cannot convert Infinity to integer ratio".into()));
    }
    if v.is_nan() {
        return Err(vm.value_error("cannot convert NaN to integer ratio"));
    }
    let (mut mantissa, mut exponent) = libm::frexp(v);
    while mantissa != mantissa.trunc() {
        mantissa *= 2.0;
        exponent -= 1;
    }
    let numerator = BigInt::from(mantissa as i64) << exponent.max(0);
    let denominator = BigInt::from(1) << (-exponent).max(0);
    let (numerator, denominator) = (vm.heap.big(numerator), vm.heap.big(denominator));
    Ok(vm.new_tuple([numerator, denominator].as_slice()))
}

fn hex(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let v = pinned(vm, &args)?;
    let text = hex_of(v);
    Ok(vm.new_str(text))
}

fn hex_of(v: f64) -> String {
    if !v.is_finite() {
        return text::float_repr(v);
    }
    let sign = if v.is_sign_negative() { "-" } else { "" };
    let bits = v.to_bits();
    let (biased, fraction) = ((bits >> 52) & 0x7FF, bits & ((1 << 52) - 1));
    match biased {
        0 if fraction == 0 => format!("{sign}0x0.0p+0"),
        0 => format!("{sign}0x0.{fraction:013x}p-1022"),
        _ => format!("{sign}0x1.{fraction:013x}p{:+}", biased as i64 - 1023),
    }
}

fn fromhex(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Value::Str(s) = vm.plain(args.at(1)) else {
        return Err(vm.type_error("bad argument type for built-in operation"));
    };
    let text = vm.heap[s].text.clone();
    vm.charge(text.len() as u64 / 16)?;
    let value = match parse_hex(&text) {
        Some(value) if value.is_infinite() && !text.to_ascii_lowercase().contains("inf") => {
            return Err(vm.error(Builtin::OverflowError, "hexadecimal value too large to represent as a float".into()));
        }
        Some(value) => Value::float(value),
        None => return Err(vm.value_error("invalid hexadecimal floating-point string")),
    };
    if args.at(0).is(Builtin::Float.value()) { Ok(value) } else { vm.call(args.at(0), &[value]) }
}

/// A float in hexadecimal, correctly rounded; infinite where it is too large.
fn parse_hex(text: &str) -> Option<f64> {
    let text = text.trim_matches(text::unicode::is_space);
    let (sign, body) = match text.strip_prefix('-') {
        Some(body) => (-1.0, body),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    };
    let lower = body.to_ascii_lowercase();
    match lower.as_str() {
        "inf" | "infinity" => return Some(sign * f64::INFINITY),
        "nan" => return Some(f64::NAN),
        _ => {}
    }
    let digits = lower.strip_prefix("0x").unwrap_or(&lower);
    let (mantissa, exponent) = match digits.split_once('p') {
        Some((mantissa, exponent)) => {
            let unsigned = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
            if unsigned.is_empty() || !unsigned.bytes().all(|b| b.is_ascii_digit()) {
                return None;
            }
            (mantissa, exponent.parse::<i64>().unwrap_or(if exponent.starts_with('-') { i64::MIN / 4 } else { i64::MAX / 4 }))
        }
        None => (digits, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all: Vec<u8> = whole.bytes().chain(fraction.bytes()).collect();
    if all.is_empty() || !all.iter().all(u8::is_ascii_hexdigit) {
        return None;
    }
    let value = BigInt::parse_bytes(&all, 16)?;
    let scale = exponent.saturating_sub(4 * fraction.len() as i64);
    if value.magnitude().bits() == 0 {
        return Some(sign * 0.0);
    }
    // Far outside the range of floats nothing need be computed.
    let top = scale.saturating_add(value.bits() as i64);
    if top > 1024 {
        return Some(sign * f64::INFINITY);
    }
    if top < -1080 {
        return Some(sign * 0.0);
    }
    let (numerator, denominator) =
        if scale >= 0 { (value << scale as u64, BigInt::from(1)) } else { (value, BigInt::from(1) << scale.unsigned_abs()) };
    Some(sign * numbers::true_divide(&numerator, &denominator).unwrap_or(f64::INFINITY))
}

/// Methods of `float`.
pub const METHODS: &[Native] = &[
    Native::static_method("__new__", 1, ANY, |vm, a| super::object::new_builtin(vm, a, Builtin::Float)).keywords(),
    Native::method("is_integer", 0, 0, is_integer),
    Native::method("as_integer_ratio", 0, 0, as_integer_ratio),
    Native::method("hex", 0, 0, hex),
    Native::class_method("fromhex", 1, 1, fromhex),
    Native::method("conjugate", 0, 0, number::same::<FLOAT>),
    Native::getter("real", number::same::<FLOAT>),
    Native::getter("imag", zero),
    Native::method("__int__", 0, 0, trunc),
    Native::method("__trunc__", 0, 0, trunc),
    Native::method("__floor__", 0, 0, floor),
    Native::method("__ceil__", 0, 0, ceil),
    Native::method("__float__", 0, 0, number::same::<FLOAT>),
    Native::method("__round__", 0, 1, number::round::<FLOAT>),
    Native::method("__abs__", 0, 0, number::abs::<FLOAT>),
    Native::method("__neg__", 0, 0, number::neg::<FLOAT>),
    Native::method("__pos__", 0, 0, number::pos::<FLOAT>),
    Native::method("__bool__", 0, 0, number::truth::<FLOAT>),
    Native::method("__hash__", 0, 0, number::hash::<FLOAT>),
    Native::method("__repr__", 0, 0, number::repr::<FLOAT>),
    Native::method("__format__", 1, 1, number::format::<FLOAT>),
    Native::method("__getnewargs__", 0, 0, number::new_args::<FLOAT>),
    Native::method("__lt__", 1, 1, number::lt::<FLOAT>),
    Native::method("__le__", 1, 1, number::le::<FLOAT>),
    Native::method("__eq__", 1, 1, number::eq::<FLOAT>),
    Native::method("__ne__", 1, 1, number::ne::<FLOAT>),
    Native::method("__gt__", 1, 1, number::gt::<FLOAT>),
    Native::method("__ge__", 1, 1, number::ge::<FLOAT>),
    Native::method("__add__", 1, 1, number::add::<FLOAT>),
    Native::method("__radd__", 1, 1, number::radd::<FLOAT>),
    Native::method("__sub__", 1, 1, number::sub::<FLOAT>),
    Native::method("__rsub__", 1, 1, number::rsub::<FLOAT>),
    Native::method("__mul__", 1, 1, number::mul::<FLOAT>),
    Native::method("__rmul__", 1, 1, number::rmul::<FLOAT>),
    Native::method("__truediv__", 1, 1, number::truediv::<FLOAT>),
    Native::method("__rtruediv__", 1, 1, number::rtruediv::<FLOAT>),
    Native::method("__floordiv__", 1, 1, number::floordiv::<FLOAT>),
    Native::method("__rfloordiv__", 1, 1, number::rfloordiv::<FLOAT>),
    Native::method("__mod__", 1, 1, number::modulo::<FLOAT>),
    Native::method("__rmod__", 1, 1, number::rmod::<FLOAT>),
    Native::method("__divmod__", 1, 1, number::divmod::<FLOAT>),
    Native::method("__rdivmod__", 1, 1, number::rdivmod::<FLOAT>),
    Native::method("__pow__", 1, 2, number::pow::<FLOAT>),
    Native::method("__rpow__", 1, 2, number::rpow::<FLOAT>),
];

#[cfg(test)]
mod tests {
    use super::{hex_of, parse_hex};

    #[test]
    fn floats_pass_through_hexadecimal() {
        assert_eq!(hex_of(5e-324), "0x0.0000000000001p-1022");
        assert_eq!(hex_of(-0.0), "-0x0.0p+0");
        for x in [0.1, -1e300, 5e-324, 2.0, 0.0, f64::MAX, f64::INFINITY] {
            assert_eq!(parse_hex(&hex_of(x)), Some(x));
        }
        assert_eq!(parse_hex(" 0x.8p-1 "), Some(0.25));
        assert_eq!(parse_hex("0x1p-1080"), Some(0.0));
        assert_eq!(parse_hex("0x1.fffffffffffff8p1023"), Some(f64::INFINITY));
        assert_eq!(parse_hex("x"), None);
        assert_eq!(parse_hex("0x1p"), None);
    }
}
