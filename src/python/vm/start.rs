//! The beginning and the end of a run.

use super::attr::Cache;
use super::except::Failure;
use super::limits::FIRST_COLLECTION;
use super::provenance::CallChain;
use super::{Linked, Vm};
use crate::python::classes;
use crate::python::code::{Code, CodeId, Const, ConstantId, DirectionId, Op, Program};
use crate::python::error::{R, Raise, Stop};
use crate::python::frame::{Frame, Return};
use crate::python::heap::*;
use crate::python::host::Host;
use crate::python::symbols::Interner;
use crate::python::value::{Symbol, Value};
use crate::python::vm::limits::Limits;
use crate::trace::Trace;
use rustc_hash::FxHashMap;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// How a program is run.
#[derive(Default)]
pub struct Options<'h> {
    /// Its budget.
    pub limits: Limits,
    /// Set from outside to end the run.
    pub cancel: Option<&'h AtomicBool>,
    /// Go on with the next statement of the module after one that raised.
    pub lenient: bool,
    /// Where to record; off unless asked for.
    pub trace: Trace,
    /// Other values for tunable literals.
    pub constants: FxHashMap<ConstantId, f64>,
    /// Other turns (0 to 3) for direction sites.
    pub directions: FxHashMap<DirectionId, u8>,
}

/// How a run ended.
#[derive(Debug)]
pub struct Outcome {
    /// What was raised: several in a lenient run.
    pub exceptions: Vec<Uncaught>,
    /// Why it was stopped, and where it stood then.
    pub stop: Option<(Stop, CallChain)>,
    /// Steps that were left.
    pub steps_left: u64,
}

/// An exception that nobody caught, with its chain as CPython prints it: causes and contexts first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Uncaught {
    /// The statement of the module, as an index of [`Program::statements`].
    pub statement: Option<u32>,
    /// The exceptions, first cause first.
    pub chain: Vec<Shown>,
}

/// One exception of a chain.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// `ValueError`
    pub class: String,
    /// `ValueError: text`, as CPython's last line.
    pub line: String,
    /// Its notes, and what it is made of where it is a group.
    pub notes: Vec<String>,
    /// Function and range of each level, outermost first.
    pub calls: CallChain,
    /// How it is tied to the one after it in the chain: `true` for `raise … from …`.
    pub direct: bool,
    /// The name that a NameError or AttributeError is about.
    pub name: Option<String>,
    /// The exit status of a SystemExit.
    pub exit: Option<i32>,
}

impl<'h> Vm<'h> {
    /// A machine that has run nothing yet.
    pub fn new(host: &'h mut dyn Host, output: &'h mut dyn FnMut(&str), options: Options<'h>) -> Vm<'h> {
        let mut heap = Heap::default();
        let symbols = Interner::new();
        classes::install(&mut heap);
        let name = heap.str("__main__");
        let module = heap.alloc(Module { name, slots: Vec::new(), names: Vec::new(), index: FxHashMap::default(), dict: None });
        let Options { limits, cancel, lenient, trace, constants, directions } = options;
        let host_names = host.type_names();
        let mut vm = Vm {
            first_classes: heap.class_count(),
            heap,
            symbols,
            trace,
            host,
            output,
            limits,
            cancel,
            lenient,
            constants,
            directions,
            stack: Vec::with_capacity(256),
            frames: Vec::with_capacity(16),
            frame: Frame {
                code: CodeId(0),
                pc: 0,
                base: 0,
                floor: 0,
                module,
                namespace: Value::Undefined,
                ret: Return::Native,
                handling: 0,
                generator: None,
            },
            codes: Vec::new(),
            handling: Vec::new(),
            modules: FxHashMap::default(),
            attr_cache: Cache::new(),
            builtins: FxHashMap::default(),
            countdown: 0,
            steps_left: limits.steps,
            output_left: limits.output,
            collect_at: FIRST_COLLECTION,
            native_depth: 0,
            random: Default::default(),
            randoms: Vec::new(),
            nans: 0,
            repr_stack: Vec::new(),
            symbol_texts: Vec::new(),
            host_classes: Vec::new(),
            failures: Vec::new(),
            stopped_at: None,
            yielded: false,
            reraising: false,
            main: None,
        };
        for name in host_names {
            let class = vm.sealed_class(name);
            vm.host_classes.push((name, class));
        }
        vm.first_classes = vm.heap.class_count();
        vm
    }

    /// A class that stands for a type of the host.
    fn sealed_class(&mut self, name: &'static str) -> Ref<Class> {
        let text = self.heap.str(name);
        let object = classes::Builtin::Object.class();
        let class = self.heap.alloc(Class {
            name: text,
            qualname: text,
            bases: [object].into_iter().collect(),
            mro: Vec::new(),
            attrs: Default::default(),
            meta: classes::Builtin::Type.class(),
            layout: Layout::Sealed,
            natives: &[],
            builtin: true,
            slots: None,
            hooked: false,
            subclasses: Vec::new(),
        });
        self.heap[class].mro = vec![class, object];
        class
    }

    /// Makes compiled code ready for this run.
    pub(super) fn link(&mut self, program: Arc<Program>) -> CodeId {
        let first = self.codes.len() as u32;
        for number in 0..program.codes.len() as u32 {
            let code = &program.codes[number as usize];
            let consts = code.consts.iter().map(|c| self.constant(c, first == 0)).collect();
            let names = code.names.iter().map(|n| self.symbols.intern(n)).collect();
            let parameters = usize::from(code.params.positional)
                + usize::from(code.params.keyword_only)
                + usize::from(code.params.varargs)
                + usize::from(code.params.varkw);
            let params: Vec<Symbol> = code.locals.iter().take(parameters).map(|n| self.symbols.intern(n)).collect();
            let simple = params.len() == usize::from(code.params.positional);
            let has_cells = !(code.cells.is_empty() && code.frees.is_empty());
            let linked = Linked {
                keywords: self.keyword_names(code),
                plain: simple && !has_cells && !code.generator,
                ops: code.ops.as_slice().into(),
                number,
                first,
                consts,
                names,
                simple,
                positional: usize::from(code.params.positional),
                slots: code.locals.len() + code.cells.len() + code.frees.len(),
                has_cells,
                generator: code.generator,
                cost: code.ops.len() as u64,
                name: self.heap.str(&*code.name),
                qualname: self.heap.str(&*code.qualname),
                doc: match &code.doc {
                    Some(doc) => self.heap.str(&**doc),
                    None => Value::None,
                },
                params,
                program: Arc::clone(&program),
            };
            self.codes.push(Rc::new(linked));
        }
        CodeId(first)
    }

    /// The names of the keywords that calls pass, by the constant that lists them.
    fn keyword_names(&mut self, code: &Code) -> Vec<Box<[Symbol]>> {
        let mut names: Vec<Box<[Symbol]>> = Vec::new();
        for op in &code.ops {
            let (Op::CallKw { names: at, .. } | Op::CallMethodKw { names: at, .. }) = *op else { continue };
            let Some(Const::Tuple(texts)) = code.consts.get(at as usize) else { continue };
            if names.len() <= at as usize {
                names.resize(at as usize + 1, Box::default());
            }
            let texts = texts.iter().filter_map(|text| if let Const::Str(text) = text { Some(&**text) } else { None });
            names[at as usize] = texts.map(|text| self.symbols.intern(text)).collect();
        }
        names
    }

    fn constant(&mut self, constant: &Const, own: bool) -> Value {
        match constant {
            Const::None => Value::None,
            Const::Ellipsis => Value::Ellipsis,
            Const::Bool(b) => Value::Bool(*b),
            Const::Int(i) => Value::int(*i),
            Const::Big(b) => self.heap.big(b.clone()),
            Const::Float(v, Some(id)) if own => {
                let v = self.constants.get(id).copied().unwrap_or(*v);
                Value::Float(v, self.trace.literal(id.0, v))
            }
            Const::Float(v, _) => Value::float(*v),
            Const::Complex(re, im) => Value::Complex(self.heap.alloc(Complex { re: *re, im: *im })),
            Const::Str(s) => self.heap.str(&**s),
            Const::Bytes(b) => Value::Bytes(self.heap.alloc(Bytes(b.clone()))),
            Const::Tuple(items) => {
                let items: Vec<Value> = items.iter().map(|c| self.constant(c, own)).collect();
                self.heap.tuple(items)
            }
            Const::FrozenSet(items) => {
                let set = self.heap.alloc(Set::default());
                for item in items {
                    let item = self.constant(item, own);
                    // Constants hash without running code.
                    let _ = self.set_add(set, item);
                }
                Value::FrozenSet(set)
            }
        }
    }

    /// A module object with a slot for each global of a program.
    pub(super) fn new_module(&mut self, name: &str, main: CodeId) -> Ref<Module> {
        let program = Arc::clone(&self.codes[main.0 as usize].program);
        let names: Vec<Symbol> = program.globals.iter().map(|n| self.symbols.intern(n)).collect();
        let index = names.iter().enumerate().map(|(i, n)| (*n, i as u32)).collect();
        let name = self.heap.str(name);
        let module = self.heap.alloc(Module { name, slots: vec![Value::Undefined; names.len()], names, index, dict: None });
        self.module_set(module, crate::python::symbols::sym::NAME, name);
        self.module_set(module, crate::python::symbols::sym::DOC, Value::None);
        module
    }

    /// Runs the code of a module.
    pub(super) fn run_module(&mut self, main: CodeId, module: Ref<Module>) -> R<()> {
        self.push_module(main, module);
        self.run_nested().map(|_| ())
    }

    fn push_module(&mut self, main: CodeId, module: Ref<Module>) {
        let base = self.stack.len();
        let slots = self.codes[main.0 as usize].slots;
        self.stack.resize(base + slots, Value::Undefined);
        let linked = Rc::clone(&self.codes[main.0 as usize]);
        let locals = linked.code().locals.len();
        for i in 0..linked.code().cells.len() {
            self.stack[base + locals + i] = Value::Cell(self.heap.alloc(Cell(Value::Undefined)));
        }
        let frame = Frame {
            code: main,
            pc: 0,
            base: base as u32,
            floor: base as u32,
            module,
            namespace: Value::Undefined,
            ret: Return::Native,
            handling: self.handling.len() as u32,
            generator: None,
        };
        self.frames.push(std::mem::replace(&mut self.frame, frame));
    }

    /// Runs a program from its beginning to its end.
    pub fn run_program(&mut self, program: Arc<Program>) -> Outcome {
        let main = self.link(program);
        let module = self.new_module("__main__", main);
        self.main = Some(module);
        let name = self.symbols.intern("__main__");
        self.modules.insert(name, module);
        self.push_module(main, module);
        let result = self.run(0);
        let mut raised: Vec<(Option<u32>, Value)> = self.failures.iter().map(|f| (Some(f.statement), f.exception)).collect();
        let mut stop = None;
        match result {
            Ok(_) => {}
            Err(Raise::Exception(e)) => raised.push((None, e)),
            Err(Raise::Stop(s)) => stop = Some((s, self.stopped_at.take().unwrap_or_default())),
        }
        // What is left of the budget is for showing what was raised, which may run the program's own `__str__`.
        let steps_left = self.steps_left;
        let exceptions = raised.into_iter().map(|(statement, e)| Uncaught { statement, chain: self.show_chain(e) }).collect();
        Outcome { exceptions, stop, steps_left }
    }

    /// The statements that raised in a lenient run.
    pub fn failures(&self) -> &[Failure] {
        &self.failures
    }

    /// The globals of the program in the order in which they were first named, with their values.
    pub fn globals(&self) -> Vec<(&str, Value)> {
        let Some(main) = self.main else { return Vec::new() };
        let module = &self.heap[main];
        module.names.iter().zip(&module.slots).filter(|p| !p.1.is_undefined()).map(|(n, v)| (self.symbols.text(*n), *v)).collect()
    }
}
