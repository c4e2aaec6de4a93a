//! The machine: runs compiled code over a heap and a host, within limits.

mod contract;
mod limits;

pub use limits::Limits;

use super::code::{Code, Program};
use super::frame::Frame;
use super::heap::{Heap, Module, Ref};
use super::host::Host;
use super::symbols::Interner;
use super::value::{Symbol, Value};
use crate::trace::Trace;
use rustc_hash::FxHashMap;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A code object made ready for a run: its names interned, its constants in the heap.
#[derive(Debug)]
pub struct Linked {
    /// The compiled module it belongs to.
    pub program: Arc<Program>,
    /// Its number there.
    pub number: u32,
    /// The code objects of its program begin here.
    pub first: u32,
    /// Constants.
    pub consts: Vec<Value>,
    /// Names.
    pub names: Vec<Symbol>,
    /// Names of the parameters.
    pub params: Vec<Symbol>,
}

impl Linked {
    /// The code itself.
    #[inline(always)]
    pub fn code(&self) -> &Code {
        &self.program.codes[self.number as usize]
    }
}

/// What a host may use of the machine while it is called.
pub struct HostCx<'a> {
    /// The heap.
    pub heap: &'a mut Heap,
    /// The names.
    pub symbols: &'a mut Interner,
    /// The record of the run.
    pub trace: &'a mut Trace,
    pub(super) frames: &'a [Frame],
    pub(super) codes: &'a [Rc<Linked>],
    pub(super) stack: &'a [Value],
}

/// The machine.
pub struct Vm<'h> {
    /// The objects.
    pub heap: Heap,
    /// The names.
    pub symbols: Interner,
    /// The record of the run.
    pub trace: Trace,
    pub(super) host: &'h mut dyn Host,
    pub(super) output: &'h mut dyn FnMut(&str),
    pub(super) limits: Limits,
    pub(super) cancel: Option<&'h AtomicBool>,
    pub(super) stack: Vec<Value>,
    pub(super) frames: Vec<Frame>,
    pub(super) codes: Vec<Rc<Linked>>,
    /// Exceptions being handled, innermost last.
    pub(super) handling: Vec<Value>,
    pub(super) modules: FxHashMap<Symbol, Ref<Module>>,
    /// Names of builtin functions that programs see, by symbol.
    pub(super) builtins: FxHashMap<Symbol, Value>,
    /// Steps left until the next look at the limits…
    pub(super) countdown: i64,
    /// …and those left after it.
    pub(super) steps_left: u64,
    pub(super) output_left: u64,
    /// Heap size at which the collector runs next.
    pub(super) collect_at: usize,
    /// How many native functions stand between the outermost loop and here.
    pub(super) native_depth: u32,
    /// The generator of `random`'s module functions.
    pub random: super::modules::random::Generator,
    /// Instances of `random.Random`, by number.
    pub randoms: Vec<super::modules::random::Generator>,
    /// repr() of containers under way, to show `[...]`.
    pub(super) repr_stack: Vec<Value>,
    /// Set by a metaclass-free `object` subclass with `__eq__` and such; bumped whenever a class changes.
    pub(super) class_version: u32,
    pub(super) main: Option<Ref<Module>>,
}
