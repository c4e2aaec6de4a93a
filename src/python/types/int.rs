//! `int` and `bool`: their constructors and methods.

use super::number::{self, INT, this};
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::Bytes;
use crate::python::native::{ANY, Args, Native};
use crate::python::numbers::{self, Number};
use crate::python::symbols::sym;
use crate::python::text;
use crate::python::value::Value;
use crate::python::vm::Vm;
use crate::trace::Num;
use num_bigint::{BigInt, Sign};
use num_traits::Signed;

/// `int(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let given = args.pos.len() + args.kw.len();
    if given > 2 {
        return Err(vm.type_error(format!("int() takes at most 2 arguments ({given} given)")));
    }
    if let Some(&(name, _)) = args.kw.iter().find(|(name, _)| *name != sym::N_BASE) {
        let message = format!("'{}' is an invalid keyword argument for int()", vm.symbols.text(name));
        return Err(vm.type_error(message));
    }
    let base = args.get(1).or(args.kw.first().map(|(_, value)| *value));
    match (args.get(0), base) {
        (None, None) => Ok(Value::int(0)),
        (None, Some(_)) => Err(vm.type_error("int() missing string argument")),
        (Some(value), None) => convert(vm, value),
        (Some(value), Some(base)) => with_base(vm, value, base),
    }
}

fn with_base(vm: &mut Vm<'_>, value: Value, base: Value) -> R<Value> {
    let base = vm.pin(base);
    let base = vm.index(base)?;
    let Some(base) = u32::try_from(base).ok().filter(|b| *b == 0 || (2..=36).contains(b)) else {
        return Err(vm.value_error("int() base must be >= 2 and <= 36, or 0"));
    };
    match parse(vm, value, base)? {
        Some(int) => Ok(int),
        None => Err(vm.type_error("int() can't convert non-string with explicit base")),
    }
}

/// The int of a string or bytes; `None` for anything else.
fn parse(vm: &mut Vm<'_>, value: Value, base: u32) -> R<Option<Value>> {
    let value = vm.plain(value);
    let text = match value {
        Value::Str(s) => vm.heap[s].text.clone(),
        Value::Bytes(b) => super::bytes::latin1(&vm.heap[b].0).into(),
        Value::ByteArray(b) => super::bytes::latin1(&vm.heap[b].0).into(),
        _ => return Ok(None),
    };
    vm.charge(text.len() as u64 * (1 + text.len() as u64 / 1024) / 8)?;
    match numbers::parse_int(&text, base) {
        Ok(int) => Ok(Some(vm.heap.big(int))),
        Err(error) => {
            let shown = match value {
                Value::Str(_) => text::repr_str(&text),
                _ => text::repr_bytes(&text.chars().map(|c| c as u8).collect::<Vec<u8>>()),
            };
            Err(numbers::parse_error(vm, error, base, &shown))
        }
    }
}

/// `int(value)`
fn convert(vm: &mut Vm<'_>, value: Value) -> R<Value> {
    if let Some(number) = Number::of(vm, value) {
        match number {
            Number::Int(v, h) => return Ok(Value::Int(v, h)),
            Number::Big(_) => return Ok(value),
            Number::Float(v, h) => return numbers::trunc(vm, Num { value: v, handle: h }),
            Number::Complex(_) => {}
        }
    }
    for name in [sym::INT, sym::INDEX] {
        if let Some(method) = vm.special(value, name) {
            let result = vm.call(method, &[])?;
            return expect_int(vm, result, if name == sym::INT { "__int__" } else { "__index__" });
        }
    }
    if let Some(method) = vm.special(value, sym::TRUNC) {
        let result = vm.call(method, &[])?;
        if let Some(int) = numbers::int_value(vm.plain(result)) {
            return Ok(int);
        }
        let Some(method) = vm.special(result, sym::INDEX) else {
            let class = vm.type_name(result);
            return Err(vm.type_error(format!("__trunc__ returned non-Integral (type {class})")));
        };
        let index = vm.call(method, &[])?;
        return expect_int(vm, index, "__index__");
    }
    match parse(vm, value, 10)? {
        Some(int) => Ok(int),
        None => {
            let class = vm.type_name(value);
            Err(vm.type_error(format!("int() argument must be a string, a bytes-like object or a real number, not '{class}'")))
        }
    }
}

fn expect_int(vm: &mut Vm<'_>, value: Value, method: &str) -> R<Value> {
    match numbers::int_value(vm.plain(value)) {
        Some(int) => Ok(int),
        None => {
            let class = vm.type_name(value);
            Err(vm.type_error(format!("{method} returned non-int (type {class})")))
        }
    }
}

/// `bool(...)`
pub fn construct_bool(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if !args.kw.is_empty() {
        return Err(vm.type_error("bool() takes no keyword arguments"));
    }
    match *args.pos {
        [] => Ok(Value::Bool(false)),
        [value] => Ok(Value::Bool(vm.truth(value)?)),
        _ => Err(vm.type_error(format!("bool expected at most 1 argument, got {}", args.pos.len()))),
    }
}

/// The receiver as a big int, without its handle.
fn big(vm: &mut Vm<'_>, args: &Args<'_>) -> R<BigInt> {
    let value = this::<INT>(vm, args)?;
    let value = vm.pin(value);
    Ok(numbers::to_big(vm, value).map(|b| b.into_owned()).unwrap_or_default())
}

fn bit_length(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::int(big(vm, &args)?.bits() as i64))
}

fn bit_count(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::int(big(vm, &args)?.magnitude().count_ones() as i64))
}

fn as_integer_ratio(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = number::same::<INT>(vm, args)?;
    Ok(vm.new_tuple([value, Value::int(1)].as_slice()))
}

fn zero(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    this::<INT>(vm, &args)?;
    Ok(Value::int(0))
}

fn one(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    this::<INT>(vm, &args)?;
    Ok(Value::int(1))
}

fn to_float(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = this::<INT>(vm, &args)?;
    super::float::of_number(vm, value)
}

/// `byteorder`: whether the highest byte comes first.
fn big_endian(vm: &mut Vm<'_>, order: Option<Value>, function: &str) -> R<bool> {
    let Some(order) = order else { return Ok(true) };
    let Value::Str(s) = vm.plain(order) else {
        let class = vm.type_name(order);
        return Err(vm.type_error(format!("{function}() argument 'byteorder' must be str, not {class}")));
    };
    match vm.text(s) {
        "big" => Ok(true),
        "little" => Ok(false),
        _ => Err(vm.value_error("byteorder must be either 'little' or 'big'")),
    }
}

fn to_bytes(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = big(vm, &args)?;
    let (arguments, signed) = without_signed(vm, args)?;
    let [length, order] = vm.bind("to_bytes", Args { pos: &args.pos[1..], kw: &arguments }, ["length", "byteorder"], 0)?;
    let length = match length {
        Some(length) => vm.index(length)?,
        None => 1,
    };
    let big_endian = big_endian(vm, order, "to_bytes")?;
    let Ok(length) = usize::try_from(length) else { return Err(vm.value_error("length argument must be non-negative")) };
    if value.is_negative() && !signed {
        return Err(vm.error(Builtin::OverflowError, "can't convert negative int to unsigned".into()));
    }
    vm.reserve(length)?;
    vm.charge(length as u64 / 64)?;
    let mut bytes = if signed { value.to_signed_bytes_le() } else { value.magnitude().to_bytes_le() };
    // Zero has no digits; neither has −1 where nothing is asked for, as in CPython.
    if value.sign() == Sign::NoSign || length == 0 && value == BigInt::from(-1) {
        bytes.clear();
    }
    if bytes.len() > length {
        return Err(vm.error(Builtin::OverflowError, "int too big to convert".into()));
    }
    bytes.resize(length, if value.is_negative() { 0xFF } else { 0 });
    if big_endian {
        bytes.reverse();
    }
    Ok(Value::Bytes(vm.heap.alloc(Bytes(bytes.into()))))
}

type Keywords = Vec<(crate::python::value::Symbol, Value)>;

/// The keywords without `signed`, and its truth.
fn without_signed(vm: &mut Vm<'_>, args: Args<'_>) -> R<(Keywords, bool)> {
    let mut others = args.kw.to_vec();
    let mut signed = false;
    if let Some(at) = others.iter().position(|(name, _)| *name == sym::N_SIGNED) {
        signed = vm.truth(others.remove(at).1)?;
    }
    Ok((others, signed))
}

fn from_bytes(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (keywords, signed) = without_signed(vm, args)?;
    let [bytes, order] = vm.bind("from_bytes", Args { pos: &args.pos[1..], kw: &keywords }, ["bytes", "byteorder"], 1)?;
    let big_endian = big_endian(vm, order, "from_bytes")?;
    let mut bytes = super::bytes::collect(vm, bytes.unwrap_or(Value::None), "bytes")?;
    vm.charge(bytes.len() as u64 / 64)?;
    if big_endian {
        bytes.reverse();
    }
    let int = if signed { BigInt::from_signed_bytes_le(&bytes) } else { BigInt::from_bytes_le(Sign::Plus, &bytes) };
    let int = vm.heap.big(int);
    if args.at(0).is(Builtin::Int.value()) { Ok(int) } else { vm.call(args.at(0), &[int]) }
}

/// Methods of `int`.
pub const METHODS: &[Native] = &[
    Native::static_method("__new__", 1, ANY, |vm, a| super::object::new_builtin(vm, a, Builtin::Int)).keywords(),
    Native::method("bit_length", 0, 0, bit_length),
    Native::method("bit_count", 0, 0, bit_count),
    Native::method("to_bytes", 0, ANY, to_bytes).keywords(),
    Native::class_method("from_bytes", 0, ANY, from_bytes).keywords(),
    Native::method("as_integer_ratio", 0, 0, as_integer_ratio),
    Native::method("conjugate", 0, 0, number::same::<INT>),
    Native::getter("real", number::same::<INT>),
    Native::getter("imag", zero),
    Native::getter("numerator", number::same::<INT>),
    Native::getter("denominator", one),
    Native::method("__int__", 0, 0, number::same::<INT>),
    Native::method("__index__", 0, 0, number::same::<INT>),
    Native::method("__trunc__", 0, 0, number::same::<INT>),
    Native::method("__floor__", 0, 0, number::same::<INT>),
    Native::method("__ceil__", 0, 0, number::same::<INT>),
    Native::method("__float__", 0, 0, to_float),
    Native::method("__round__", 0, 1, number::round::<INT>),
    Native::method("__abs__", 0, 0, number::abs::<INT>),
    Native::method("__neg__", 0, 0, number::neg::<INT>),
    Native::method("__pos__", 0, 0, number::pos::<INT>),
    Native::method("__invert__", 0, 0, number::invert::<INT>),
    Native::method("__bool__", 0, 0, number::truth::<INT>),
    Native::method("__hash__", 0, 0, number::hash::<INT>),
    Native::method("__repr__", 0, 0, number::repr::<INT>),
    Native::method("__format__", 1, 1, number::format::<INT>),
    Native::method("__getnewargs__", 0, 0, number::new_args::<INT>),
    Native::method("__lt__", 1, 1, number::lt::<INT>),
    Native::method("__le__", 1, 1, number::le::<INT>),
    Native::method("__eq__", 1, 1, number::eq::<INT>),
    Native::method("__ne__", 1, 1, number::ne::<INT>),
    Native::method("__gt__", 1, 1, number::gt::<INT>),
    Native::method("__ge__", 1, 1, number::ge::<INT>),
    Native::method("__add__", 1, 1, number::add::<INT>),
    Native::method("__radd__", 1, 1, number::radd::<INT>),
    Native::method("__sub__", 1, 1, number::sub::<INT>),
    Native::method("__rsub__", 1, 1, number::rsub::<INT>),
    Native::method("__mul__", 1, 1, number::mul::<INT>),
    Native::method("__rmul__", 1, 1, number::rmul::<INT>),
    Native::method("__truediv__", 1, 1, number::truediv::<INT>),
    Native::method("__rtruediv__", 1, 1, number::rtruediv::<INT>),
    Native::method("__floordiv__", 1, 1, number::floordiv::<INT>),
    Native::method("__rfloordiv__", 1, 1, number::rfloordiv::<INT>),
    Native::method("__mod__", 1, 1, number::modulo::<INT>),
    Native::method("__rmod__", 1, 1, number::rmod::<INT>),
    Native::method("__divmod__", 1, 1, number::divmod::<INT>),
    Native::method("__rdivmod__", 1, 1, number::rdivmod::<INT>),
    Native::method("__pow__", 1, 2, number::pow::<INT>),
    Native::method("__rpow__", 1, 2, number::rpow::<INT>),
    Native::method("__lshift__", 1, 1, number::lshift::<INT>),
    Native::method("__rlshift__", 1, 1, number::rlshift::<INT>),
    Native::method("__rshift__", 1, 1, number::rshift::<INT>),
    Native::method("__rrshift__", 1, 1, number::rrshift::<INT>),
    Native::method("__and__", 1, 1, number::and::<INT>),
    Native::method("__rand__", 1, 1, number::rand::<INT>),
    Native::method("__or__", 1, 1, number::or::<INT>),
    Native::method("__ror__", 1, 1, number::ror::<INT>),
    Native::method("__xor__", 1, 1, number::xor::<INT>),
    Native::method("__rxor__", 1, 1, number::rxor::<INT>),
];

/// Methods of `bool` beside those of `int`.
pub const BOOL: &[Native] = &[
    Native::method("__repr__", 0, 0, number::repr::<INT>),
    Native::method("__and__", 1, 1, number::and::<INT>),
    Native::method("__rand__", 1, 1, number::rand::<INT>),
    Native::method("__or__", 1, 1, number::or::<INT>),
    Native::method("__ror__", 1, 1, number::ror::<INT>),
    Native::method("__xor__", 1, 1, number::xor::<INT>),
    Native::method("__rxor__", 1, 1, number::rxor::<INT>),
];
