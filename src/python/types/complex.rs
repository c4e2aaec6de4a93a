//! `complex`: its constructor and methods.

use super::number::{self, COMPLEX, this};
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::Complex;
use crate::python::native::{ANY, Args, Native};
use crate::python::numbers::{self, Number};
use crate::python::symbols::sym;
use crate::python::value::Value;
use crate::python::vm::Vm;

/// `complex(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let given = args.pos.len() + args.kw.len();
    if given > 2 {
        return Err(vm.type_error(format!("complex() takes at most 2 arguments ({given} given)")));
    }
    if let Some(&(name, _)) = args.kw.iter().find(|(name, _)| ![sym::N_REAL, sym::N_IMAG].contains(name)) {
        let message = format!("'{}' is an invalid keyword argument for complex()", vm.symbols.text(name));
        return Err(vm.type_error(message));
    }
    let [real, imag] = vm.bind("complex", args, ["real", "imag"], 0)?;
    let value = match (real, imag) {
        (None, None) => Complex { re: 0.0, im: 0.0 },
        (Some(real), imag) => {
            if let Value::Str(s) = vm.plain(real) {
                if imag.is_some() {
                    return Err(vm.type_error("complex() can't take second arg if first is a string"));
                }
                let text = vm.heap[s].text.clone();
                vm.charge(text.len() as u64 / 16)?;
                match numbers::parse_complex(&text) {
                    Some(value) => return Ok(Value::Complex(vm.heap.alloc(value))),
                    None if numbers::misplaces_underscores(&text) => {
                        let shown = vm.repr(Value::Str(s))?;
                        return Err(vm.value_error(format!("could not convert string to complex: {shown}")));
                    }
                    None => return Err(vm.value_error("complex() arg is a malformed string")),
                }
            }
            if imag.is_none() && matches!(real, Value::Complex(_)) {
                return Ok(real);
            }
            with_parts(vm, Some(real), imag)?
        }
        (None, imag) => with_parts(vm, None, imag)?,
    };
    Ok(Value::Complex(vm.heap.alloc(value)))
}

/// `real + imag × 1j`, of which each may be complex itself.
fn with_parts(vm: &mut Vm<'_>, real: Option<Value>, imag: Option<Value>) -> R<Complex> {
    if let Some(imag) = imag
        && let Value::Str(_) = vm.plain(imag)
    {
        return Err(vm.type_error("complex() second arg can't be a string"));
    }
    let zero = (Complex { re: 0.0, im: 0.0 }, false);
    let (a, a_complex) = match real {
        Some(value) => part(vm, value, true, "complex() first argument must be a string or a number")?,
        None => zero,
    };
    let Some(imag) = imag else { return Ok(a) };
    let (b, b_complex) = part(vm, imag, false, "complex() second argument must be a number")?;
    let re = if b_complex { a.re - b.im } else { a.re };
    let im = if a_complex { b.re + a.im } else { b.re };
    Ok(Complex { re, im })
}

/// An argument, and whether it is complex.
fn part(vm: &mut Vm<'_>, value: Value, methods: bool, message: &str) -> R<(Complex, bool)> {
    if methods
        && matches!(value, Value::Instance(_))
        && let Some(method) = vm.special(value, sym::COMPLEX)
    {
        let result = vm.call(method, &[])?;
        return match vm.plain(result) {
            Value::Complex(c) => Ok((vm.heap[c], true)),
            _ => {
                let class = vm.type_name(result);
                Err(vm.type_error(format!("__complex__ returned non-complex (type {class})")))
            }
        };
    }
    let plain = vm.plain(value);
    match Number::of(vm, plain) {
        Some(Number::Complex(c)) => Ok((c, true)),
        Some(number) => Ok((numbers::complex_of(vm, number)?, false)),
        None => match super::float::by_methods(vm, value)? {
            Some(re) => Ok((Complex { re, im: 0.0 }, false)),
            None => {
                let class = vm.type_name(value);
                Err(vm.type_error(format!("{message}, not '{class}'")))
            }
        },
    }
}

fn parts(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Complex> {
    Ok(match this::<COMPLEX>(vm, args)? {
        Value::Complex(c) => vm.heap[c],
        _ => Complex { re: 0.0, im: 0.0 },
    })
}

fn real(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::float(parts(vm, &args)?.re))
}

fn imag(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::float(parts(vm, &args)?.im))
}

fn conjugate(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Complex { re, im } = parts(vm, &args)?;
    Ok(Value::Complex(vm.heap.alloc(Complex { re, im: -im })))
}

/// Methods of `complex`.
pub const METHODS: &[Native] = &[
    Native::static_method("__new__", 1, ANY, |vm, a| super::object::new_builtin(vm, a, Builtin::Complex)).keywords(),
    Native::getter("real", real),
    Native::getter("imag", imag),
    Native::method("conjugate", 0, 0, conjugate),
    Native::method("__complex__", 0, 0, number::same::<COMPLEX>),
    Native::method("__abs__", 0, 0, number::abs::<COMPLEX>),
    Native::method("__neg__", 0, 0, number::neg::<COMPLEX>),
    Native::method("__pos__", 0, 0, number::pos::<COMPLEX>),
    Native::method("__bool__", 0, 0, number::truth::<COMPLEX>),
    Native::method("__hash__", 0, 0, number::hash::<COMPLEX>),
    Native::method("__repr__", 0, 0, number::repr::<COMPLEX>),
    Native::method("__format__", 1, 1, number::format::<COMPLEX>),
    Native::method("__getnewargs__", 0, 0, number::new_args::<COMPLEX>),
    Native::method("__lt__", 1, 1, number::lt::<COMPLEX>),
    Native::method("__le__", 1, 1, number::le::<COMPLEX>),
    Native::method("__eq__", 1, 1, number::eq::<COMPLEX>),
    Native::method("__ne__", 1, 1, number::ne::<COMPLEX>),
    Native::method("__gt__", 1, 1, number::gt::<COMPLEX>),
    Native::method("__ge__", 1, 1, number::ge::<COMPLEX>),
    Native::method("__add__", 1, 1, number::add::<COMPLEX>),
    Native::method("__radd__", 1, 1, number::radd::<COMPLEX>),
    Native::method("__sub__", 1, 1, number::sub::<COMPLEX>),
    Native::method("__rsub__", 1, 1, number::rsub::<COMPLEX>),
    Native::method("__mul__", 1, 1, number::mul::<COMPLEX>),
    Native::method("__rmul__", 1, 1, number::rmul::<COMPLEX>),
    Native::method("__truediv__", 1, 1, number::truediv::<COMPLEX>),
    Native::method("__rtruediv__", 1, 1, number::rtruediv::<COMPLEX>),
    Native::method("__pow__", 1, 2, number::pow::<COMPLEX>),
    Native::method("__rpow__", 1, 2, number::rpow::<COMPLEX>),
];
