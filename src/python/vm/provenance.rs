//! Which statement is running, inside which calls and iterations.

use super::{HostCx, Linked, Vm};
use crate::python::code::Slot;
use crate::python::frame::Frame;
use crate::python::heap::Heap;
use crate::python::value::Value;
use ruff_text_size::TextRange;
use std::rc::Rc;

/// A call or an iteration around what is running.
#[derive(Clone, Copy, Debug)]
pub enum PathStep<'a> {
    /// An iteration of a loop or comprehension.
    Loop {
        /// The loop's header.
        range: TextRange,
        /// From 0.
        iteration: u32,
        /// The loop variable; empty where no name stands for it.
        variable: &'a str,
        /// Its value.
        value: Value,
    },
    /// A call of a function of the program.
    Call {
        /// The call expression.
        range: TextRange,
        /// The function.
        function: &'a str,
    },
}

/// A place of the program with the calls that led to it, outermost first.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CallChain {
    /// Function and range of each level; the last is where it happened.
    pub levels: Vec<(String, TextRange)>,
}

/// The frames of a machine, outermost first.
pub(super) struct Stack<'a> {
    pub heap: &'a Heap,
    pub frames: &'a [Frame],
    pub frame: &'a Frame,
    pub codes: &'a [Rc<Linked>],
    pub stack: &'a [Value],
}

impl<'a> Stack<'a> {
    /// Visits the calls and iterations around what is running, outermost first; answers the innermost statement of the program.
    pub fn walk(&self, visit: &mut dyn FnMut(PathStep<'_>)) -> TextRange {
        let mut statement = TextRange::default();
        let levels = self.frames.iter().skip(1).chain([self.frame]);
        let mut call: Option<TextRange> = None;
        for frame in levels {
            let linked = &self.codes[frame.code.0 as usize];
            if linked.first != 0 {
                continue; // a module that comes with psdl: what it does counts for its caller
            }
            let code = linked.code();
            let at = frame.pc.saturating_sub(1);
            if let Some(range) = call
                && !matches!(code.kind, crate::python::code::CodeKind::Comprehension | crate::python::code::CodeKind::Class)
            {
                visit(PathStep::Call { range, function: &code.name });
            }
            if !code.loops.is_empty() {
                self.loops(frame, linked, at, visit);
            }
            let next = code.statements.partition_point(|s| s.0 <= at);
            let own = if next > 0 { Some(code.statements[next - 1].1) } else { None };
            statement = own.unwrap_or(statement);
            call = code.ranges.get(at as usize).copied().or(own);
        }
        statement
    }

    fn loops(&self, frame: &Frame, linked: &Linked, at: u32, visit: &mut dyn FnMut(PathStep<'_>)) {
        let code = linked.code();
        let operands = frame.base as usize + linked.slots;
        // Inner loops come first; one loop may have several pieces, of which at most one holds the instruction.
        for l in code.loops.iter().rev().filter(|l| l.start <= at && at < l.end) {
            let counter = self.stack.get(operands + l.depth as usize + 1);
            let Some(Value::Int(n, _)) = counter else { continue };
            let (variable, value) = match &l.variable {
                Some((name, slot)) => (&**name, self.variable(frame, *slot)),
                None => ("", Value::Undefined),
            };
            visit(PathStep::Loop { range: l.range, iteration: (*n - 1).max(0) as u32, variable, value });
        }
    }

    fn variable(&self, frame: &Frame, slot: Slot) -> Value {
        match slot {
            Slot::Fast(n) => self.stack.get(frame.base as usize + usize::from(n)).copied().unwrap_or(Value::Undefined),
            Slot::Deref(n) => match self.stack.get(frame.base as usize + usize::from(n)) {
                Some(Value::Cell(cell)) => self.heap[*cell].0,
                _ => Value::Undefined,
            },
            Slot::Global(n) => self.heap[frame.module].slots.get(n as usize).copied().unwrap_or(Value::Undefined),
        }
    }
}

impl HostCx<'_> {
    /// Visits the calls and iterations around what is running, outermost first; answers the innermost statement of the program.
    pub fn walk(&self, visit: &mut dyn FnMut(PathStep<'_>)) -> TextRange {
        Stack { heap: self.heap, frames: self.frames, frame: self.frame, codes: self.codes, stack: self.stack }.walk(visit)
    }

    /// A loop variable's value, shown shortly; empty for what has no short text.
    pub fn show(&self, value: Value) -> String {
        match value {
            Value::Int(v, _) => v.to_string(),
            Value::Float(v, _) => crate::python::text::float_repr(v),
            Value::Bool(b) => if b { "True" } else { "False" }.to_string(),
            Value::Str(s) if self.heap[s].chars <= 40 => crate::python::text::repr_str(&self.heap[s].text),
            _ => String::new(),
        }
    }
}

impl Vm<'_> {
    /// Where the program stands, with the calls that led there.
    pub(super) fn capture_path(&self) -> CallChain {
        let mut levels = Vec::new();
        for frame in self.frames.iter().skip(1).chain([&self.frame]) {
            let linked = &self.codes[frame.code.0 as usize];
            if linked.first != 0 {
                continue;
            }
            let code = linked.code();
            let at = frame.pc.saturating_sub(1) as usize;
            levels.push((code.name.to_string(), code.ranges.get(at).copied().unwrap_or_default()));
        }
        // An endless recursion is said once, not a thousand times.
        if levels.len() > 24 {
            levels.drain(12..levels.len() - 12);
        }
        CallChain { levels }
    }
}
