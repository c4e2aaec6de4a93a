//! The compiler: tree → code. CPython 3.11's semantics, for the machine in [`super::vm`].
//!
//! Invariants: what it emits leaves the operand stack as high on every way to an instruction; between the statements of the module
//! the stack is empty; the code is at most [`MAX_OPS`] instructions long, though `finally` bodies are copied to every way out.
//! Each tunable literal is a constant of its own and no arithmetic is folded, so that a run can trace what becomes of it.
//! Must not know: how the machine does it, what a scene is.

mod blocks;
mod call;
mod class;
mod collection;
mod comprehension;
mod constant;
mod disassemble;
mod effect;
mod emit;
mod exception;
mod expr;
mod fstring;
mod function;
mod import;
mod loops;
mod name;
mod pattern;
mod stmt;
mod target;
#[cfg(test)]
mod tests;

use ruff_text_size::TextRange;
use rustc_hash::FxHashMap;

use super::code::{Code, CodeKind, Const, Op, Params, Program, TopStatement};
use crate::syntax::{ScopeId, Scopes, Tuning, ast};
use blocks::Block;
use emit::{Emitter, Frame, Label, narrow};

/// More instructions than any program that a person or a model writes.
pub const MAX_OPS: usize = 1_000_000;

/// The most locals, cells and captured variables of one function.
const MAX_SLOTS: usize = 30_000;

/// Stack that must be left before a node is entered, and by how much it grows otherwise.
const RED_ZONE: usize = 128 << 10;
const STACK_PIECE: usize = 1 << 20;

/// What keeps a program from being compiled.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CompileError {
    /// Where.
    pub range: TextRange,
    /// One sentence without a full stop.
    pub message: String,
}

type Compiled = Result<(), CompileError>;

fn error<T>(range: TextRange, message: impl Into<String>) -> Result<T, CompileError> {
    Err(CompileError { range, message: message.into() })
}

/// Compiles a program whose names are resolved. The constants and directions of `tuning` get their numbers in the code; constants that
/// are left alone whatever they do get none.
///
/// # Errors
/// What is not part of the language (`async`), what CPython refuses though its grammar allows it and `syntax` let it pass, and
/// programs that are too long.
pub fn compile(module: &ast::ModModule, text: &str, scopes: &Scopes, tuning: &Tuning) -> Result<Program, CompileError> {
    let globals: Vec<Box<str>> = scopes.globals().map(|name| Box::from(name.as_str())).collect();
    let mut compiler = Compiler {
        text,
        scopes,
        tuning,
        global_index: globals.iter().cloned().zip(0..).collect(),
        globals,
        codes: vec![None],
        statements: Vec::new(),
        work: 0,
        unit: Unit::new(ScopeId::MODULE, CodeKind::Module, 0),
    };
    compiler.module(module)?;
    let unit = std::mem::replace(&mut compiler.unit, Unit::new(ScopeId::MODULE, CodeKind::Module, 0));
    compiler.finish(unit, "<module>".into(), "<module>".into());
    let codes = compiler.codes.into_iter().flatten().collect();
    let lines = crate::syntax::LineIndex::new(text);
    Ok(Program { codes, globals: compiler.globals, statements: compiler.statements, lines })
}

/// A code object under construction, and what surrounds the place where the compiler is.
struct Unit<'a> {
    scope: ScopeId,
    kind: CodeKind,
    /// Its place among the program's code objects.
    number: usize,
    emitter: Emitter,
    params: Params,
    doc: Option<Box<str>>,
    children: Vec<u32>,
    /// The statements that must do something when they are left early, outermost first.
    blocks: Vec<Block<'a>>,
    /// How many exceptions are being handled here.
    handling: u32,
    /// The most hidden locals that were needed at once.
    hidden: usize,
}

impl Unit<'_> {
    fn new(scope: ScopeId, kind: CodeKind, number: usize) -> Self {
        let (emitter, params) = (Emitter::default(), Params::default());
        Unit { scope, kind, number, emitter, params, doc: None, children: Vec::new(), blocks: Vec::new(), handling: 0, hidden: 0 }
    }
}

struct Compiler<'a> {
    text: &'a str,
    scopes: &'a Scopes,
    tuning: &'a Tuning,
    globals: Vec<Box<str>>,
    global_index: FxHashMap<Box<str>, u32>,
    codes: Vec<Option<Code>>,
    statements: Vec<TopStatement>,
    /// Instructions and statements so far, those that are not emitted included.
    work: usize,
    unit: Unit<'a>,
}

impl<'a> Compiler<'a> {
    fn emit(&mut self, op: Op, range: TextRange) {
        self.work += 1;
        self.unit.emitter.emit(op, range);
    }

    fn label(&mut self) -> Label {
        self.unit.emitter.label()
    }

    fn bind(&mut self, label: Label) {
        self.unit.emitter.bind(label);
    }

    fn jump(&mut self, make: fn(u32) -> Op, label: Label, range: TextRange) {
        self.unit.emitter.jump(make, label, range);
    }

    fn constant(&mut self, value: Const, range: TextRange) {
        let at = self.unit.emitter.constant(value);
        self.emit(Op::Const(at), range);
    }

    /// Opens the code object of an inner scope; [`close`](Self::close) takes what it returns.
    fn open(&mut self, node: TextRange, kind: CodeKind) -> Result<Unit<'a>, CompileError> {
        let Some(scope) = self.scopes.of(node) else { return error(node, "the names of this definition are not resolved") };
        let number = self.codes.len();
        self.codes.push(None);
        self.unit.children.push(narrow(number));
        let layout = self.scopes.get(scope);
        if layout.locals.len() + layout.cells.len() + layout.frees.len() > MAX_SLOTS {
            return error(node, "too many variables in one function");
        }
        Ok(std::mem::replace(&mut self.unit, Unit::new(scope, kind, number)))
    }

    /// Finishes the inner code object and returns to the outer one, where a function of it is made. `flags` tells which of defaults,
    /// keyword defaults and annotations are on the stack.
    fn close(&mut self, outer: Unit<'a>, flags: u8, range: TextRange) {
        let inner = std::mem::replace(&mut self.unit, outer);
        let scope = self.scopes.get(inner.scope);
        let qualname = self.scopes.qualified_name(inner.scope);
        self.finish(inner, scope.name.as_str().into(), qualname.into());
        for free in &scope.frees {
            let slot = self.captured_slot(free.from);
            self.emit(Op::LoadClosure(slot), range);
        }
        let mut flags = flags;
        if !scope.frees.is_empty() {
            self.emit(Op::BuildTuple(narrow(scope.frees.len())), range);
            flags |= 8;
        }
        let child = narrow(self.unit.children.len().saturating_sub(1));
        self.emit(Op::MakeFunction { child, flags }, range);
    }

    fn finish(&mut self, unit: Unit<'a>, name: Box<str>, qualname: Box<str>) {
        let scope = self.scopes.get(unit.scope);
        let hidden = (0..unit.hidden).map(|n| format!(".match{n}").into_boxed_str());
        let parameter = |cell: &crate::syntax::scope::Cell| cell.parameter.and_then(|local| u16::try_from(local).ok());
        let frame = Frame {
            name,
            qualname,
            kind: unit.kind,
            generator: scope.is_generator,
            params: unit.params,
            locals: scope.locals.iter().map(|name| Box::from(name.as_str())).chain(hidden).collect(),
            cells: scope.cells.iter().map(|cell| (cell.name.as_str().into(), parameter(cell))).collect(),
            frees: scope.frees.iter().map(|free| free.name.as_str().into()).collect(),
            children: unit.children,
            doc: unit.doc,
        };
        if let Some(place) = self.codes.get_mut(unit.number) {
            *place = Some(unit.emitter.finish(frame));
        }
    }
}
