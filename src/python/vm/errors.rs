//! Raising from native code.

use super::{HostCx, Vm};
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::native::Args;
use crate::python::value::Value;

impl Heap {
    /// A new exception of a class, with its `args`.
    pub fn exception(&mut self, class: Ref<Class>, args: Value) -> Value {
        let data = ExceptionData { args, cause: Value::None, context: Value::None, suppress: false, traceback: Vec::new() };
        Value::Instance(self.alloc(Instance { class, attrs: Attrs::default(), base: Base::Exception(Box::new(data)) }))
    }

    /// What a raised exception knows; `None` for anything else.
    pub fn exception_data(&self, value: Value) -> Option<&ExceptionData> {
        match value {
            Value::Instance(i) => match &self[i].base {
                Base::Exception(data) => Some(data),
                _ => None,
            },
            _ => None,
        }
    }

    /// The same, to change.
    pub fn exception_data_mut(&mut self, value: Value) -> Option<&mut ExceptionData> {
        match value {
            Value::Instance(i) => match &mut self[i].base {
                Base::Exception(data) => Some(data),
                _ => None,
            },
            _ => None,
        }
    }
}

impl HostCx<'_> {
    /// An exception of a builtin class with a message.
    pub fn error(&mut self, class: Builtin, message: impl Into<String>) -> Raise {
        let text = self.heap.str(message.into());
        let args = self.heap.tuple([text].as_slice());
        Raise::Exception(self.heap.exception(class.class(), args))
    }
}

impl Vm<'_> {
    /// An exception of a builtin class with a message.
    pub fn error(&mut self, class: Builtin, message: String) -> Raise {
        let text = self.heap.str(message);
        self.error_with(class, text)
    }

    /// An exception of a builtin class with one argument.
    pub fn error_with(&mut self, class: Builtin, argument: Value) -> Raise {
        let args = self.heap.tuple([argument].as_slice());
        Raise::Exception(self.heap.exception(class.class(), args))
    }

    /// TypeError
    pub fn type_error(&mut self, message: impl Into<String>) -> Raise {
        self.error(Builtin::TypeError, message.into())
    }

    /// ValueError
    pub fn value_error(&mut self, message: impl Into<String>) -> Raise {
        self.error(Builtin::ValueError, message.into())
    }

    /// KeyError, whose argument is the key itself.
    pub fn key_error(&mut self, key: Value) -> Raise {
        self.error_with(Builtin::KeyError, key)
    }

    /// StopIteration without a value.
    pub fn stop_iteration(&mut self) -> Raise {
        let args = self.heap.tuple([].as_slice());
        Raise::Exception(self.heap.exception(Builtin::StopIteration.class(), args))
    }

    /// Whether what was raised is an exception of this class.
    pub fn raised(&self, raise: &Raise, class: Builtin) -> bool {
        matches!(raise, Raise::Exception(e) if self.is_instance(*e, class))
    }

    /// Positional and keyword arguments by parameter name; the first `required` must be there. Messages are CPython's.
    pub fn bind<const N: usize>(
        &mut self,
        function: &str,
        args: Args<'_>,
        names: [&'static str; N],
        required: usize,
    ) -> R<[Option<Value>; N]> {
        let mut out = [None; N];
        if args.pos.len() + args.kw.len() > N && args.pos.len() > N {
            let most = if required == N { "exactly" } else { "at most" };
            let s = if N == 1 { "" } else { "s" };
            return Err(self.type_error(format!("{function}() takes {most} {N} argument{s} ({} given)", args.pos.len() + args.kw.len())));
        }
        for (slot, value) in out.iter_mut().zip(args.pos) {
            *slot = Some(*value);
        }
        for &(name, value) in args.kw {
            let text = self.symbols.text(name).to_string();
            match names.iter().position(|n| *n == text) {
                Some(i) if out[i].is_some() => {
                    return Err(self.type_error(format!("argument for {function}() given by name ('{text}') and position ({})", i + 1)));
                }
                Some(i) => out[i] = Some(value),
                None => return Err(self.type_error(format!("'{text}' is an invalid keyword argument for {function}()"))),
            }
        }
        if let Some(i) = (0..required).find(|&i| out[i].is_none()) {
            return Err(self.type_error(format!("{function}() missing required argument '{}' (pos {})", names[i], i + 1)));
        }
        Ok(out)
    }
}
