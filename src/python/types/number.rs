//! What int, float and complex have in common: their arithmetic as methods. A method of a type takes operands of its own type and of
//! the narrower ones: its number says how wide it is.

use crate::python::error::R;
use crate::python::heap::Complex;
use crate::python::native::Args;
use crate::python::numbers::{self, Number};
use crate::python::text;
use crate::python::value::{BinaryOp, CompareOp, UnaryOp, Value};
use crate::python::vm::Vm;

/// `int`, as the parameter of the methods here.
pub(super) const INT: u8 = 0;
/// `float`
pub(super) const FLOAT: u8 = 1;
/// `complex`
pub(super) const COMPLEX: u8 = 2;

fn width(value: Value) -> Option<u8> {
    match value {
        Value::Int(..) | Value::Bool(_) | Value::Big(_) => Some(INT),
        Value::Float(..) => Some(FLOAT),
        Value::Complex(_) => Some(COMPLEX),
        _ => None,
    }
}

/// The receiver of a method of the type.
pub(super) fn this<const T: u8>(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Value> {
    let value = vm.plain(args.at(0));
    if width(value) == Some(T) {
        return Ok(value);
    }
    let (wanted, found) = (["int", "float", "complex"][T as usize], vm.type_name(args.at(0)));
    Err(vm.type_error(format!("descriptor requires a '{wanted}' object but received a '{found}'")))
}

/// Receiver and operand, if the type takes that operand.
fn operands<const T: u8>(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Option<(Value, Value)>> {
    let value = this::<T>(vm, args)?;
    let other = vm.plain(args.at(1));
    Ok(width(other).filter(|w| *w <= T).map(|_| (value, other)))
}

fn or_not_implemented(value: Option<Value>) -> Value {
    value.unwrap_or(Value::NotImplemented)
}

fn arithmetic<const T: u8>(vm: &mut Vm<'_>, op: BinaryOp, args: Args<'_>, reflected: bool) -> R<Value> {
    let Some((a, b)) = operands::<T>(vm, &args)? else { return Ok(Value::NotImplemented) };
    let (a, b) = if reflected { (b, a) } else { (a, b) };
    // The width of the method decides, not that of the operands: `1.0 .__radd__(2)` is one of floats.
    Ok(or_not_implemented(numbers::binary(vm, op, a, b)?))
}

macro_rules! arithmetic {
    ($($name:ident $reflected:ident $op:ident;)*) => { $(
        #[doc = concat!("`__", stringify!($name), "__`")]
        pub(super) fn $name<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
            arithmetic::<T>(vm, BinaryOp::$op, args, false)
        }
        #[doc = concat!("`__", stringify!($reflected), "__`")]
        pub(super) fn $reflected<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
            arithmetic::<T>(vm, BinaryOp::$op, args, true)
        }
    )* };
}

arithmetic! {
    add radd Add;
    sub rsub Sub;
    mul rmul Mul;
    truediv rtruediv Div;
    floordiv rfloordiv FloorDiv;
    modulo rmod Mod;
    lshift rlshift LShift;
    rshift rrshift RShift;
    and rand And;
    or ror Or;
    xor rxor Xor;
}

macro_rules! comparisons {
    ($($name:ident $op:ident;)*) => { $(
        #[doc = concat!("`__", stringify!($name), "__`")]
        pub(super) fn $name<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
            let Some((a, b)) = operands::<T>(vm, &args)? else { return Ok(Value::NotImplemented) };
            Ok(numbers::compare(vm, CompareOp::$op, a, b)?.map_or(Value::NotImplemented, Value::Bool))
        }
    )* };
}

comparisons! { lt Lt; le Le; eq Eq; ne Ne; gt Gt; ge Ge; }

macro_rules! unary {
    ($($name:ident $op:ident;)*) => { $(
        #[doc = concat!("`__", stringify!($name), "__`")]
        pub(super) fn $name<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
            let value = this::<T>(vm, &args)?;
            Ok(or_not_implemented(numbers::unary(vm, UnaryOp::$op, value)?))
        }
    )* };
}

unary! { neg Neg; pos Pos; invert Invert; }

/// `__pow__`
pub(super) fn pow<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some((base, exponent)) = operands::<T>(vm, &args)? else { return Ok(Value::NotImplemented) };
    let modulus = args.get(2).filter(|m| !m.is_none()).map(|m| vm.plain(m));
    power(vm, base, exponent, modulus).map(or_not_implemented)
}

/// `__rpow__`
pub(super) fn rpow<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some((exponent, base)) = operands::<T>(vm, &args)? else { return Ok(Value::NotImplemented) };
    let modulus = args.get(2).filter(|m| !m.is_none()).map(|m| vm.plain(m));
    power(vm, base, exponent, modulus).map(or_not_implemented)
}

/// `pow(base, exponent, modulus)` of plain values; `None` where they are no numbers.
pub fn power(vm: &mut Vm<'_>, base: Value, exponent: Value, modulus: Option<Value>) -> R<Option<Value>> {
    let Some(modulus) = modulus else { return numbers::binary(vm, BinaryOp::Pow, base, exponent) };
    match (width(base), width(exponent), width(modulus)) {
        (Some(INT), Some(INT), Some(INT)) => numbers::pow_mod(vm, base, exponent, modulus),
        (Some(a), Some(b), Some(_)) if a.max(b) == COMPLEX => Err(vm.value_error("complex modulo")),
        (Some(_), Some(_), Some(_)) => Err(vm.type_error("pow() 3rd argument not allowed unless all arguments are integers")),
        _ => Ok(None),
    }
}

/// `__divmod__`
pub(super) fn divmod<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some((a, b)) = operands::<T>(vm, &args)? else { return Ok(Value::NotImplemented) };
    Ok(or_not_implemented(numbers::divmod(vm, a, b)?))
}

/// `__rdivmod__`
pub(super) fn rdivmod<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some((a, b)) = operands::<T>(vm, &args)? else { return Ok(Value::NotImplemented) };
    Ok(or_not_implemented(numbers::divmod(vm, b, a)?))
}

/// `__abs__`
pub(super) fn abs<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = this::<T>(vm, &args)?;
    Ok(or_not_implemented(numbers::absolute(vm, value)?))
}

/// `__bool__`
pub(super) fn truth<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = this::<T>(vm, &args)?;
    Ok(Value::Bool(numbers::truth(vm, value).unwrap_or(true)))
}

/// `__hash__`
pub(super) fn hash<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = this::<T>(vm, &args)?;
    Ok(Value::int(numbers::hash_number(vm, value).unwrap_or(0)))
}

/// `__repr__`
pub(super) fn repr<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = this::<T>(vm, &args)?;
    let text = show(vm, value)?;
    Ok(vm.new_str(text))
}

/// `repr(value)` of a plain number; a traced one is pinned.
pub fn show(vm: &mut Vm<'_>, value: Value) -> R<String> {
    let value = vm.pin(value);
    match Number::of(vm, value) {
        Some(Number::Int(..)) => vm.repr(value),
        Some(Number::Float(v, _)) => Ok(text::float_repr(v)),
        Some(Number::Complex(c)) => Ok(text::complex_repr(c)),
        Some(Number::Big(r)) => {
            vm.charge(vm.heap[r].bits() / 8)?;
            numbers::int_to_string(&vm.heap[r]).map_err(|e| e.raise(vm))
        }
        None => Ok(String::new()),
    }
}

/// `__format__`
pub(super) fn format<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = this::<T>(vm, &args)?;
    let spec = spec_of(vm, args.at(1))?;
    let text = text::format_value(vm, value, &spec)?;
    Ok(vm.new_str(text))
}

/// The argument of `__format__`.
pub(super) fn spec_of(vm: &mut Vm<'_>, spec: Value) -> R<String> {
    match vm.plain(spec) {
        Value::Str(s) => Ok(vm.text(s).to_string()),
        other => {
            let class = vm.type_name(other);
            Err(vm.type_error(format!("__format__() argument must be str, not {class}")))
        }
    }
}

/// `__getnewargs__`
pub(super) fn new_args<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = this::<T>(vm, &args)?;
    if let Value::Complex(c) = value {
        let Complex { re, im } = vm.heap[c];
        return Ok(vm.new_tuple([Value::float(re), Value::float(im)].as_slice()));
    }
    Ok(vm.new_tuple([value].as_slice()))
}

/// The number itself: `conjugate` and `real` of an int or a float.
pub(super) fn same<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = this::<T>(vm, &args)?;
    Ok(numbers::int_value(value).unwrap_or(value))
}

/// `__round__`
pub(super) fn round<const T: u8>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = this::<T>(vm, &args)?;
    Ok(or_not_implemented(numbers::round(vm, value, args.get(1))?))
}
