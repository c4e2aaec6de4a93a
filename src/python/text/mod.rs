//! Text of values: number formatting, format specs, `%`, `str.format`, reprs of strings, encodings.
//!
//! Invariants: what is written is CPython's, to the last character; a width or precision that the program chooses is asked of the
//! machine (`Vm::reserve`) before anything of that size is built. A string holds no lone surrogates: Rust's cannot, so what would make one
//! is an error or U+FFFD. Must not know: the scene; the trace beyond pinning a number whose text is asked for.

pub mod codec;
mod float;
mod number;
mod percent;
mod quote;
mod spec;
mod str_format;
#[cfg(test)]
mod tests;
pub mod unicode;

pub use float::{complex_repr, float_repr};
pub use number::{format_big, format_complex, format_float, format_int};
pub use percent::{percent, percent_bytes};
pub use quote::{ascii, repr_bytes, repr_str};
pub use spec::{Spec, format_str};
pub use str_format::{format_map, str_format};

use super::error::{R, Raise};
use super::numbers::{self, Number};
use super::value::Value;
use super::vm::Vm;
use crate::python::classes::Builtin;

/// Why a value cannot be formatted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FormatError {
    /// A ValueError, with its message.
    Value(String),
    /// An OverflowError, with its message.
    Overflow(&'static str),
}

impl FormatError {
    /// The exception.
    pub fn raise(self, vm: &mut Vm<'_>) -> Raise {
        match self {
            FormatError::Value(message) => vm.value_error(message),
            FormatError::Overflow(message) => vm.error(Builtin::OverflowError, message.into()),
        }
    }
}

impl From<numbers::TooManyDigits> for FormatError {
    fn from(_: numbers::TooManyDigits) -> Self {
        FormatError::Value(numbers::TooManyDigits::MESSAGE.into())
    }
}

/// `format(value, spec)` of a plain value of a builtin type, as its own `__format__` does it. A traced number is pinned.
pub fn format_value(vm: &mut Vm<'_>, value: Value, spec: &str) -> R<String> {
    let value = vm.pin(value);
    if spec.is_empty() {
        return vm.str(value);
    }
    let class = vm.type_name(value);
    if let Value::Str(r) = value {
        let spec = Spec::parse(spec, &class, 's', '<').map_err(|e| e.raise(vm))?;
        reserve(vm, &spec, vm.heap[r].text.len())?;
        let text = &vm.heap[r].text;
        return format_str(text, &spec).map_err(|e| e.raise(vm));
    }
    let Some(number) = Number::of(vm, value) else {
        return Err(vm.type_error(format!("unsupported format string passed to {class}.__format__")));
    };
    let default = if matches!(number, Number::Int(..) | Number::Big(_)) { 'd' } else { '\0' };
    let spec = Spec::parse(spec, &class, default, '>').map_err(|e| e.raise(vm))?;
    reserve(vm, &spec, 0)?;
    let result = match number {
        Number::Int(v, _) => format_int(v, &spec, &class),
        Number::Big(r) => {
            vm.charge(vm.heap[r].bits() / 8)?;
            vm.reserve(vm.heap[r].bits() as usize)?;
            format_big(&vm.heap[r], &spec, &class)
        }
        Number::Float(v, _) => format_float(v, &spec, &class),
        Number::Complex(c) => format_complex(c, &spec),
    };
    result.map_err(|e| e.raise(vm))
}

/// Asks for the memory of a text of this spec, and for the time to write it.
fn reserve(vm: &mut Vm<'_>, spec: &Spec, length: usize) -> R<()> {
    let size = spec.size().saturating_add(length);
    if size > 4096 {
        vm.reserve(size.saturating_mul(2))?;
        vm.charge(size as u64 / 64)?;
    }
    Ok(())
}
