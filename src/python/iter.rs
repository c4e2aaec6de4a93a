//! Native iterators: what `iter()` of a builtin type makes, and what `zip`, `map`, `enumerate` and `itertools` return.

use super::classes::Builtin;
use super::heap::*;
use super::modules::itertools::Tool;
use super::value::Value;
use std::mem::size_of;

/// Where a native iterator stands.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum IterState {
    /// Nothing is left; of an iterator of this class.
    Done(Builtin),
    List {
        list: Ref<List>,
        index: usize,
    },
    /// Backwards: `left` items are still to come.
    ListReversed {
        list: Ref<List>,
        left: usize,
    },
    Tuple {
        tuple: Ref<Tuple>,
        index: usize,
    },
    /// Items that were taken beforehand (a host object's, `reversed` of a tuple or string).
    Items {
        items: Box<[Value]>,
        index: usize,
    },
    /// A range within 64 bits.
    Range {
        next: i64,
        step: i64,
        left: u64,
    },
    /// Any other range.
    BigRange {
        range: Range,
        next: u128,
    },
    /// The byte at which the next character starts.
    Str {
        str: Ref<Str>,
        offset: usize,
    },
    Bytes {
        bytes: Ref<Bytes>,
        index: usize,
    },
    ByteArray {
        bytes: Ref<ByteArray>,
        index: usize,
    },
    /// Over a dict; `len` is its size at the start: a change is a RuntimeError.
    Dict {
        dict: Ref<Dict>,
        kind: ViewKind,
        position: usize,
        len: usize,
    },
    DictReversed {
        dict: Ref<Dict>,
        kind: ViewKind,
        position: usize,
        len: usize,
    },
    Set {
        set: Ref<Set>,
        position: usize,
        len: usize,
    },
    Enumerate {
        iter: Value,
        count: Value,
    },
    Zip {
        iters: Vec<Value>,
        strict: bool,
    },
    Map {
        function: Value,
        iters: Vec<Value>,
    },
    Filter {
        function: Value,
        iter: Value,
    },
    /// `iter(callable, sentinel)`
    Call {
        function: Value,
        sentinel: Value,
    },
    /// The old sequence protocol: `o[0]`, `o[1]`… until IndexError.
    Sequence {
        object: Value,
        index: i64,
    },
    SequenceReversed {
        object: Value,
        left: i64,
    },
    /// An iterator of `itertools`.
    Tool(Box<Tool>),
}

impl IterState {
    /// Whether it asks another iterator, or calls something, for its items.
    #[inline]
    pub fn is_composed(&self) -> bool {
        use IterState::*;
        matches!(self, Enumerate { .. } | Zip { .. } | Map { .. } | Filter { .. } | Call { .. } | Sequence { .. } | Tool(_))
    }

    /// Lets go of everything: there is no next item any more.
    pub fn finish(&mut self) {
        *self = IterState::Done(self.class());
    }

    /// Bytes beyond its own size.
    pub fn extra(&self) -> usize {
        match self {
            IterState::Items { items, .. } => items.len() * size_of::<Value>(),
            IterState::Zip { iters, .. } | IterState::Map { iters, .. } => iters.capacity() * size_of::<Value>(),
            IterState::Tool(tool) => size_of::<Tool>() + tool.extra(),
            _ => 0,
        }
    }

    /// The values it holds.
    pub fn children(&self, out: &mut Vec<Value>) {
        match self {
            IterState::Done(_) | IterState::Range { .. } | IterState::BigRange { .. } => {}
            IterState::List { list, .. } | IterState::ListReversed { list, .. } => out.push(Value::List(*list)),
            IterState::Tuple { tuple, .. } => out.push(Value::Tuple(*tuple)),
            IterState::Items { items, .. } => out.extend_from_slice(items),
            IterState::Str { str, .. } => out.push(Value::Str(*str)),
            IterState::Bytes { bytes, .. } => out.push(Value::Bytes(*bytes)),
            IterState::ByteArray { bytes, .. } => out.push(Value::ByteArray(*bytes)),
            IterState::Dict { dict, .. } | IterState::DictReversed { dict, .. } => out.push(Value::Dict(*dict)),
            IterState::Set { set, .. } => out.push(Value::Set(*set)),
            IterState::Enumerate { iter, count } => out.extend([*iter, *count]),
            IterState::Zip { iters, .. } => out.extend_from_slice(iters),
            IterState::Map { function, iters } => {
                out.push(*function);
                out.extend_from_slice(iters);
            }
            IterState::Filter { function, iter } => out.extend([*function, *iter]),
            IterState::Call { function, sentinel } => out.extend([*function, *sentinel]),
            IterState::Sequence { object, .. } | IterState::SequenceReversed { object, .. } => out.push(*object),
            IterState::Tool(tool) => tool.children(out),
        }
    }
}
