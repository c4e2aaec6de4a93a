//! What a run may use, and the points at which it is held to that.

use super::Vm;
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise, Stop};
use crate::python::value::Value;
use std::sync::atomic::Ordering;

/// The budget of a run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Instructions, roughly; native loops count per item.
    pub steps: u64,
    /// Bytes of live objects.
    pub memory: usize,
    /// Activations of Python functions.
    pub recursion: usize,
    /// Bytes of printed text.
    pub output: u64,
}

impl Default for Limits {
    /// More than any scene needs, less than a person waits for: a loop without end meets the step limit in about 150 ms.
    fn default() -> Limits {
        Limits { steps: 40_000_000, memory: 256 << 20, recursion: 1000, output: 1 << 20 }
    }
}

/// Steps between two looks at the cancel flag and at memory.
const CHUNK: u64 = 4096;
/// From here on memory comes from the system.
const FRESH: usize = 128 << 10;
/// The collector does not run before the heap has this many bytes.
pub(super) const FIRST_COLLECTION: usize = 16 << 20;

impl Vm<'_> {
    /// Counts work; in every native loop over data, per item or in batches.
    #[inline(always)]
    pub fn charge(&mut self, steps: u64) -> R<()> {
        self.countdown = self.countdown.saturating_sub(steps.min(i64::MAX as u64) as i64);
        if self.countdown < 0 { self.checkpoint() } else { Ok(()) }
    }

    /// The slow part of [`charge`](Vm::charge): cancellation, the step limit, memory.
    #[cold]
    pub(super) fn checkpoint(&mut self) -> R<()> {
        let over = self.countdown.unsigned_abs();
        if self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
            return Err(Raise::Stop(Stop::Cancelled));
        }
        if over >= self.steps_left {
            self.steps_left = 0;
            return Err(Raise::Stop(Stop::Steps));
        }
        self.steps_left -= over;
        let chunk = self.steps_left.min(CHUNK);
        self.steps_left -= chunk;
        self.countdown = chunk as i64;
        if self.heap.bytes > self.limits.memory && self.native_depth > 0 {
            return Err(self.memory_error());
        }
        Ok(())
    }

    /// Asks for memory before something of a size that the program chose is built.
    pub fn reserve(&mut self, bytes: usize) -> R<()> {
        if bytes > self.limits.memory || self.heap.bytes.saturating_add(bytes) > self.limits.memory.saturating_mul(2) {
            return Err(self.memory_error());
        }
        // Fresh memory is paid for page by page; small pieces come from what is there.
        self.charge((bytes / if bytes < FRESH { 256 } else { 24 }) as u64)
    }

    fn memory_error(&mut self) -> Raise {
        let args = self.heap.tuple([].as_slice());
        Raise::Exception(self.heap.exception(Builtin::MemoryError.class(), args))
    }

    /// A safe point of the outermost loop: frees what cannot be reached once enough has piled up.
    #[cold]
    pub(super) fn collect_garbage(&mut self) -> R<()> {
        let mut roots: Vec<Value> = self.stack.clone();
        for frame in self.frames.iter().chain([&self.frame]) {
            roots.push(Value::Module(frame.module));
            roots.push(frame.namespace);
            roots.extend(frame.generator.map(Value::Generator));
        }
        roots.extend(self.handling.iter().chain(&self.repr_stack).chain(&self.symbol_texts));
        roots.extend(self.modules.values().map(|m| Value::Module(*m)));
        roots.extend(self.codes.iter().flat_map(|c| c.consts.iter().copied()));
        roots.extend((0..self.first_classes).map(|i| Value::Class(crate::python::heap::Ref::new(i))));
        roots.extend(self.heap.empty_tuple.map(Value::Tuple));
        roots.extend(self.builtins.values());
        roots.extend(self.codes.iter().flat_map(|c| [c.name, c.qualname, c.doc]));
        roots.extend(self.failures.iter().map(|f| f.exception));
        self.attr_cache.clear();
        self.heap.collect(roots);
        self.collect_at = (self.heap.bytes * 2).max(FIRST_COLLECTION);
        if self.heap.bytes > self.limits.memory { Err(self.memory_error()) } else { Ok(()) }
    }

    pub(super) fn recursion_error(&mut self) -> Raise {
        self.error(Builtin::RecursionError, "maximum recursion depth exceeded".to_string())
    }

    /// Prints: to the run's output, within its limit.
    pub fn write_output(&mut self, text: &str) -> R<()> {
        let bytes = text.len() as u64;
        if bytes > self.output_left {
            self.output_left = 0;
            return Err(Raise::Stop(Stop::Output));
        }
        self.output_left -= bytes;
        (self.output)(text);
        Ok(())
    }
}
