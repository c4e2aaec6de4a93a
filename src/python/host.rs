//! What a program can reach beside Python: the door through which the scene comes in. Knows nothing of scenes.
//!
//! Host objects are [`Value::Host`] (a kind and a number) and [`Value::Record`] (a small immutable value). The machine asks the host
//! whenever it meets one of them; what the host does not know, it answers with `None`, and Python's own error follows.

use super::code::Program;
use super::error::R;
use super::heap::Heap;
use super::native::Args;
use super::value::{BinaryOp, UnaryOp, Value};
use super::vm::HostCx;
use smallvec::SmallVec;
use std::sync::Arc;

/// What a name of the host stands for.
#[derive(Clone, Copy, Debug)]
pub enum HostName {
    /// A value.
    Value(Value),
    /// An attribute of an embedded module, imported when first used.
    Import(&'static str, &'static str),
}

/// The world that a program acts on.
pub trait Host {
    /// The value of a name that neither the program nor Python binds.
    fn lookup(&mut self, cx: &mut HostCx<'_>, name: &str) -> Option<HostName>;

    /// The names that [`lookup`](Host::lookup) knows, for "did you mean" and `dir()`.
    fn names(&self) -> Vec<&'static str>;

    /// The module in Python that an [`Import`](HostName::Import) names, where it is one of the host's own.
    fn module(&self, _name: &str) -> Option<Arc<Program>> {
        None
    }

    /// The name of the type, as `type(o).__name__` and error messages say it.
    fn type_name(&self, heap: &Heap, object: Value) -> &'static str;

    /// All that [`type_name`](Host::type_name) may answer: each is a class of its own.
    fn type_names(&self) -> &'static [&'static str];

    /// `o.name`; `None` for an AttributeError in Python's words.
    fn get_attr(&mut self, cx: &mut HostCx<'_>, object: Value, name: &str) -> R<Option<Value>>;

    /// `o.name = value`.
    fn set_attr(&mut self, cx: &mut HostCx<'_>, object: Value, name: &str, value: Value) -> R<()>;

    /// True where `o.name = value` wants `value` as a sequence: the machine then turns any other iterable but host objects into a tuple first.
    fn wants_sequence(&self, object: Value, name: &str) -> bool;

    /// `o(...)`; `None` where it cannot be called.
    fn call(&mut self, cx: &mut HostCx<'_>, object: Value, args: Args<'_>) -> R<Option<Value>>;

    /// `a op b` where one side is the host's; `None` for NotImplemented.
    fn binary(&mut self, cx: &mut HostCx<'_>, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>>;

    /// `op a`.
    fn unary(&mut self, cx: &mut HostCx<'_>, op: UnaryOp, a: Value) -> R<Option<Value>>;

    /// The object as a sequence: what iteration, unpacking, `len` and indexing see; `None` where it is none.
    fn items(&mut self, cx: &mut HostCx<'_>, object: Value) -> R<Option<SmallVec<[Value; 4]>>>;

    /// `a == b` where one side is the host's; `None` for NotImplemented (then identity decides).
    fn equals(&mut self, cx: &mut HostCx<'_>, a: Value, b: Value) -> R<Option<bool>>;

    /// False where objects of this kind are unhashable. Host objects hash by identity, records by their items.
    fn hashable(&self, heap: &Heap, object: Value) -> bool;

    /// `repr(o)`.
    fn repr(&mut self, cx: &mut HostCx<'_>, object: Value) -> R<String>;

    /// `isinstance(object, class)` where `class` is the host's; `None` where `class` is none.
    fn is_instance(&mut self, cx: &mut HostCx<'_>, object: Value, class: Value) -> Option<bool>;

    /// A statement at the top level is about to run.
    fn statement_begins(&mut self);

    /// The statement that began last raised; the host undoes what must not leak into the next.
    fn statement_failed(&mut self);
}

/// A host that offers nothing: plain Python.
#[derive(Clone, Copy, Debug, Default)]
pub struct Nothing;

impl Host for Nothing {
    fn lookup(&mut self, _: &mut HostCx<'_>, _: &str) -> Option<HostName> {
        None
    }
    fn names(&self) -> Vec<&'static str> {
        Vec::new()
    }
    fn type_name(&self, _: &Heap, _: Value) -> &'static str {
        "object"
    }
    fn type_names(&self) -> &'static [&'static str] {
        &[]
    }
    fn get_attr(&mut self, _: &mut HostCx<'_>, _: Value, _: &str) -> R<Option<Value>> {
        Ok(None)
    }
    fn set_attr(&mut self, cx: &mut HostCx<'_>, _: Value, name: &str, _: Value) -> R<()> {
        Err(cx.error(crate::python::classes::Builtin::AttributeError, format!("'object' object has no attribute '{name}'")))
    }
    fn wants_sequence(&self, _: Value, _: &str) -> bool {
        false
    }
    fn call(&mut self, _: &mut HostCx<'_>, _: Value, _: Args<'_>) -> R<Option<Value>> {
        Ok(None)
    }
    fn binary(&mut self, _: &mut HostCx<'_>, _: BinaryOp, _: Value, _: Value) -> R<Option<Value>> {
        Ok(None)
    }
    fn unary(&mut self, _: &mut HostCx<'_>, _: UnaryOp, _: Value) -> R<Option<Value>> {
        Ok(None)
    }
    fn items(&mut self, _: &mut HostCx<'_>, _: Value) -> R<Option<SmallVec<[Value; 4]>>> {
        Ok(None)
    }
    fn equals(&mut self, _: &mut HostCx<'_>, _: Value, _: Value) -> R<Option<bool>> {
        Ok(None)
    }
    fn hashable(&self, _: &Heap, _: Value) -> bool {
        true
    }
    fn repr(&mut self, _: &mut HostCx<'_>, _: Value) -> R<String> {
        Ok("<object>".to_string())
    }
    fn is_instance(&mut self, _: &mut HostCx<'_>, _: Value, _: Value) -> Option<bool> {
        None
    }
    fn statement_begins(&mut self) {}
    fn statement_failed(&mut self) {}
}
