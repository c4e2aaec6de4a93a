//! Activations of code.

use super::code::CodeId;
use super::heap::{Generator, Module, Ref};
use super::value::Value;

/// What becomes of a frame's result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Return {
    /// It is pushed on the caller's stack.
    Push,
    /// It ends the machine's inner loop: native code called.
    Native,
    /// It must be None; the instance below stays (`__init__`).
    Instance,
}

/// A running activation. Its slots (locals, cells, captured variables) and operands stand on the machine's stack from `base` on.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// The code.
    pub code: CodeId,
    /// The next instruction.
    pub pc: u32,
    /// The first slot on the stack.
    pub base: u32,
    /// The stack's height once the frame is gone, before its result is pushed.
    pub floor: u32,
    /// The module whose globals it sees.
    pub module: Ref<Module>,
    /// The namespace of a class body, else `Undefined`.
    pub namespace: Value,
    /// What becomes of the result.
    pub ret: Return,
    /// How many exceptions were being handled when it began.
    pub handling: u32,
    /// The generator it belongs to.
    pub generator: Option<Ref<Generator>>,
}

/// A suspended activation.
#[derive(Clone, Debug)]
pub struct SavedFrame {
    /// The code.
    pub code: CodeId,
    /// The next instruction.
    pub pc: u32,
    /// The module whose globals it sees.
    pub module: Ref<Module>,
    /// Slots and operands.
    pub stack: Vec<Value>,
    /// The exceptions being handled within it.
    pub handling: Vec<Value>,
}

impl SavedFrame {
    /// The values it holds.
    pub fn children(&self, out: &mut Vec<Value>) {
        out.push(Value::Module(self.module));
        out.extend_from_slice(&self.stack);
        out.extend_from_slice(&self.handling);
    }
}
