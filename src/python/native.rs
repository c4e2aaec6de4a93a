//! Functions written in Rust: their type, their arguments, and the tables in which a type lists its methods.

use super::error::R;
use super::value::{Symbol, Value};
use super::vm::Vm;

/// The body of a native function. A method finds its receiver in `args.pos[0]`.
pub type NativeFn = fn(&mut Vm<'_>, Args<'_>) -> R<Value>;

/// How a native function behaves as an attribute of a class.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NativeKind {
    /// A plain function (`len`): not bound by attribute access.
    Function,
    /// A method: bound to the instance.
    Method,
    /// A method that wants its receiver as it is, not the builtin value that an instance of a subclass holds.
    Raw,
    /// `dict.fromkeys`: bound to the class.
    ClassMethod,
    /// `str.maketrans`: not bound.
    StaticMethod,
    /// A computed attribute: called with the receiver at once (`int.real`).
    Getter,
}

/// A function written in Rust. All of them are statics.
#[derive(Clone, Copy, Debug)]
pub struct Native {
    /// Its name in Python.
    pub name: &'static str,
    /// Its body.
    pub body: NativeFn,
    /// How it binds.
    pub kind: NativeKind,
    /// The least and the largest number of positional arguments, the receiver not counted; checked before the body runs.
    pub arity: (u8, u8),
    /// Whether it takes keywords; where not, one is a TypeError before the body runs.
    pub keywords: bool,
    /// The module it belongs to, as messages name it; empty for builtins.
    pub module: &'static str,
}

/// As many positional arguments as are given.
pub const ANY: u8 = u8::MAX;

impl Native {
    /// A plain function.
    pub const fn function(name: &'static str, min: u8, max: u8, body: NativeFn) -> Native {
        Native { name, body, kind: NativeKind::Function, arity: (min, max), keywords: false, module: "" }
    }

    /// A method; its receiver does not count as an argument.
    pub const fn method(name: &'static str, min: u8, max: u8, body: NativeFn) -> Native {
        Native { name, body, kind: NativeKind::Method, arity: (min, max), keywords: false, module: "" }
    }

    /// A method that gets its receiver as it is (`object.__setattr__`).
    pub const fn raw(name: &'static str, min: u8, max: u8, body: NativeFn) -> Native {
        Native { name, body, kind: NativeKind::Raw, arity: (min, max), keywords: false, module: "" }
    }

    /// A class method; `args.pos[0]` is the class.
    pub const fn class_method(name: &'static str, min: u8, max: u8, body: NativeFn) -> Native {
        Native { name, body, kind: NativeKind::ClassMethod, arity: (min, max), keywords: false, module: "" }
    }

    /// A static method.
    pub const fn static_method(name: &'static str, min: u8, max: u8, body: NativeFn) -> Native {
        Native { name, body, kind: NativeKind::StaticMethod, arity: (min, max), keywords: false, module: "" }
    }

    /// A computed attribute.
    pub const fn getter(name: &'static str, body: NativeFn) -> Native {
        Native { name, body, kind: NativeKind::Getter, arity: (0, 0), keywords: false, module: "" }
    }

    /// The same, as a function of a module.
    pub const fn of(self, module: &'static str) -> Native {
        Native { module, ..self }
    }

    /// The same, taking keywords.
    pub const fn keywords(self) -> Native {
        Native { keywords: true, ..self }
    }
}

/// The arguments of a native call.
#[derive(Clone, Copy)]
pub struct Args<'a> {
    /// By position; a method's receiver comes first.
    pub pos: &'a [Value],
    /// By keyword.
    pub kw: &'a [(Symbol, Value)],
}

impl<'a> Args<'a> {
    /// Positional arguments alone.
    pub fn new(pos: &'a [Value]) -> Args<'a> {
        Args { pos, kw: &[] }
    }

    /// The argument at `i` (the receiver is 0 in a method), if it was given.
    #[inline]
    pub fn get(&self, i: usize) -> Option<Value> {
        self.pos.get(i).copied()
    }

    /// The argument at `i`; arity was checked before.
    #[inline]
    pub fn at(&self, i: usize) -> Value {
        self.pos.get(i).copied().unwrap_or(Value::None)
    }
}
