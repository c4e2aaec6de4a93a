//! The machine: runs compiled code over a heap and a host, within limits.
//!
//! Invariants: frames of Python functions use no Rust stack; native code that calls back into Python grows the Rust stack where it must;
//! the collector runs only in the outermost loop; a stop (limits, cancellation) passes every handler of the program.

mod advance;
mod assign;
mod attr;
mod call;
mod class;
mod default_repr;
mod errors;
mod except;
mod fast;
mod generator;
mod import;
mod inspect;
mod limits;
mod matching;
mod operate;
mod protocol;
mod provenance;
mod rare;
mod run;
mod show;
mod start;

pub use except::Failure;
pub use limits::Limits;
pub use provenance::{CallChain, PathStep};
pub use start::{Options, Outcome, Shown, Uncaught};

use super::code::{Code, ConstantId, DirectionId, Op, Program};
use super::frame::Frame;
use super::heap::{Class, Heap, Module, Ref};
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
    program: Arc<Program>,
    /// Its number there.
    number: u32,
    /// Its instructions, near at hand for the main loop.
    ops: Box<[Op]>,
    /// The code objects of its program begin here; the program that is run has 0, modules that come with psdl follow.
    first: u32,
    consts: Vec<Value>,
    names: Vec<Symbol>,
    /// Names of the parameters, in the order of the locals.
    params: Vec<Symbol>,
    /// For each constant that names the keywords of a call, those names.
    keywords: Vec<Box<[Symbol]>>,
    /// Only positional parameters.
    simple: bool,
    /// Simple, and neither a generator nor with variables in cells: its frame is made of its arguments as they stand.
    plain: bool,
    positional: usize,
    /// Locals, cells and captured variables.
    slots: usize,
    has_cells: bool,
    generator: bool,
    /// Steps that a call counts for.
    cost: u64,
    name: Value,
    qualname: Value,
    doc: Value,
}

impl Linked {
    /// The code itself.
    #[inline(always)]
    fn code(&self) -> &Code {
        &self.program.codes[self.number as usize]
    }

    /// The names that a constant lists for a call.
    #[inline(always)]
    fn keywords(&self, constant: u32) -> &[Symbol] {
        self.keywords.get(constant as usize).map_or(&[], |names| names)
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
    frame: &'a Frame,
    frames: &'a [Frame],
    codes: &'a [Rc<Linked>],
    stack: &'a [Value],
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
    output: &'h mut dyn FnMut(&str),
    pub(super) limits: Limits,
    cancel: Option<&'h AtomicBool>,
    /// Whether the run goes on with the next statement of the module after one that raised.
    lenient: bool,
    constants: FxHashMap<ConstantId, f64>,
    directions: FxHashMap<DirectionId, u8>,
    stack: Vec<Value>,
    /// The callers of the current frame.
    pub(super) frames: Vec<Frame>,
    /// The current frame.
    frame: Frame,
    codes: Vec<Rc<Linked>>,
    /// Exceptions being handled, innermost last.
    handling: Vec<Value>,
    modules: FxHashMap<Symbol, Ref<Module>>,
    attr_cache: attr::Cache,
    /// Names that are Python's or the host's own, as far as they were asked for.
    builtins: FxHashMap<Symbol, Value>,
    /// Steps left until the next look at the limits…
    countdown: i64,
    /// …and those left after it.
    steps_left: u64,
    output_left: u64,
    /// Heap size at which the collector runs next.
    collect_at: usize,
    /// How many native functions stand between the outermost loop and here.
    pub(super) native_depth: u32,
    /// The generator of `random`'s module functions.
    pub random: Option<Box<super::modules::random::Generator>>,
    /// Instances of `random.Random`, by number.
    pub randoms: Vec<super::modules::random::Generator>,
    /// How many NaNs were made from text: each is an object of its own, told apart by its payload.
    pub(super) nans: u32,
    /// Containers whose repr is under way, to show `[...]`.
    pub(super) repr_stack: Vec<Value>,
    /// The `str` of each symbol, as far as it was asked for.
    symbol_texts: Vec<Value>,
    /// Classes that stand for the types of the host.
    host_classes: Vec<(&'static str, Ref<Class>)>,
    /// The classes that are there from the beginning.
    first_classes: u32,
    failures: Vec<Failure>,
    /// Where the program stood when it was stopped.
    stopped_at: Option<CallChain>,
    /// The frame that was left last is a generator that yielded.
    yielded: bool,
    /// What is raised next has its traceback already.
    reraising: bool,
    main: Option<Ref<Module>>,
}
