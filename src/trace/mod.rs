//! Where numbers come from: the record of the float operations of a run.
//!
//! A number that a literal of the program reaches carries a [`Handle`]; a number that none reaches carries [`Handle::NONE`] and costs
//! nothing. Each operation on such a number is a [`Node`], each decision taken on one is a [`Guard`]. Sound by default-deny: whoever
//! does anything to a traced number that is not in [`Op`] pins its value first. Knows nothing of Python or of scenes.

mod arith;
mod divide;
mod norm;
mod op;
mod replay;
mod slices;

use std::cell::RefCell;
use std::sync::Arc;

pub use arith::{Arith, Decision, Derivation, Plain};
pub use divide::{float_divmod, float_floor_div, float_mod};
pub use norm::norm;
pub use op::Op;
pub use replay::{Replay, Table, apply};
pub use slices::{LiteralSlice, Slices};

/// The numbers of directions among the literals of a record begin here.
pub const SITE: u32 = 1 << 31;

/// The value of a direction in place of which nothing stands.
pub const AS_WRITTEN: f64 = -1.0;

/// The place of a number in the record of a run; [`Handle::NONE`] for a number that no tunable literal reaches.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash, PartialOrd, Ord)]
pub struct Handle(pub u32);

impl Handle {
    /// No literal reaches this number.
    pub const NONE: Handle = Handle(0);

    /// True where no literal reaches the number.
    #[inline(always)]
    pub fn is_none(self) -> bool {
        self.0 == 0
    }
}

/// A float together with its place in the record. Units are those of the caller (metres in scenes).
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Num {
    /// The number itself.
    pub value: f64,
    /// Where it came from.
    pub handle: Handle,
}

impl Num {
    /// A number that no literal reaches.
    pub const fn plain(value: f64) -> Num {
        Num { value, handle: Handle::NONE }
    }
}

/// One traced number: how it was made.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Node {
    /// The value of a tunable literal, by its number in the program.
    Literal(u32, f64),
    /// `op a`
    Unary(Op, Num, f64),
    /// `a op b`
    Binary(Op, Num, Num, f64),
    /// One of two numbers, by a turn: the first where it is even.
    Choice(Num, [f64; 2], f64),
    /// Something that is more than an operation, by its place among the derivations.
    Derived(u32, f64),
}

impl Node {
    /// The number as it was in the recorded run.
    pub fn value(&self) -> f64 {
        match *self {
            Node::Literal(_, v) | Node::Unary(_, _, v) | Node::Binary(_, _, _, v) | Node::Choice(_, _, v) | Node::Derived(_, v) => v,
        }
    }
}

/// A decision of the recorded run that rests on traced numbers. Replay holds only while all guards do.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Guard {
    /// The number is this one, to the bit.
    Equals(Num),
    /// `a` compares with `b` in this way (`None`: unordered).
    Order(Num, Num, Option<std::cmp::Ordering>),
    /// The number is zero, or is not.
    Zero(Num, bool),
    /// The number is finite, or is not.
    Finite(Num, bool),
}

/// The record of a run. Off unless asked for: then literals carry no handles and nothing is ever recorded.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    nodes: Vec<Node>,
    guards: Vec<Guard>,
    decisions: Vec<Arc<dyn Decision>>,
    derivations: Vec<Arc<dyn Derivation>>,
    stone: Vec<Handle>,
    on: bool,
    turns: bool,
    limit: usize,
    full: bool,
}

impl Trace {
    /// A trace that records up to `limit` nodes and guards; past that, [`is_full`](Trace::is_full) says that it is of no use.
    pub fn recording(limit: usize) -> Trace {
        Trace { on: true, limit, ..Trace::default() }
    }

    /// The same trace, with directions among the literals.
    pub fn with_turns(self) -> Trace {
        Trace { turns: self.on, ..self }
    }

    /// Whether directions are among the literals.
    pub fn has_turns(&self) -> bool {
        self.turns
    }

    /// Whether anything is recorded.
    pub fn is_on(&self) -> bool {
        self.on
    }

    /// Whether the record had to be cut off.
    pub fn is_full(&self) -> bool {
        self.full
    }

    /// All traced numbers; handle `n` stands at `n - 1`.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// All decisions.
    pub fn guards(&self) -> &[Guard] {
        &self.guards
    }

    /// All decisions that are more than a comparison: replay holds only while they all do.
    pub fn decisions(&self) -> &[Arc<dyn Decision>] {
        &self.decisions
    }

    /// The numbers that became sizes: what reaches them must not be tuned.
    pub fn stone(&self) -> &[Handle] {
        &self.stone
    }

    /// The handle of a tunable literal.
    pub fn literal(&mut self, id: u32, value: f64) -> Handle {
        if self.on { self.push(Node::Literal(id, value)) } else { Handle::NONE }
    }

    /// The handle of what stands in place of a direction, [`AS_WRITTEN`] where nothing does.
    pub fn site(&mut self, direction: u32, value: f64) -> Handle {
        if self.turns { self.push(Node::Literal(direction | SITE, value)) } else { Handle::NONE }
    }

    /// Visits the numbers that a node was made of.
    pub fn operands(&self, node: &Node, visit: &mut dyn FnMut(Num)) {
        match *node {
            Node::Literal(..) => {}
            Node::Unary(_, a, _) | Node::Choice(a, ..) => visit(a),
            Node::Binary(_, a, b, _) => [a, b].into_iter().for_each(visit),
            Node::Derived(at, _) => {
                // A derivation says what it reads by reading it.
                let read = RefCell::new(Vec::new());
                self.derivations[at as usize].value(&|num| {
                    read.borrow_mut().push(num);
                    num.value
                });
                read.into_inner().into_iter().for_each(visit);
            }
        }
    }

    /// Records `op a = result`.
    #[inline]
    pub fn unary(&mut self, op: Op, a: Num, result: f64) -> Handle {
        if a.handle.is_none() { Handle::NONE } else { self.push(Node::Unary(op, a, result)) }
    }

    /// Records `a op b = result`.
    #[inline]
    pub fn binary(&mut self, op: Op, a: Num, b: Num, result: f64) -> Handle {
        if a.handle.0 | b.handle.0 == 0 { Handle::NONE } else { self.push(Node::Binary(op, a, b, result)) }
    }

    /// Records that the run depends on this very value.
    #[inline]
    pub fn pin(&mut self, a: Num) {
        if !a.handle.is_none() {
            self.guard(Guard::Equals(a));
        }
    }

    /// Records that the run depends on how the two compare.
    #[inline]
    pub fn order(&mut self, a: Num, b: Num) {
        if a.handle.0 | b.handle.0 != 0 {
            self.guard(Guard::Order(a, b, a.value.partial_cmp(&b.value)));
        }
    }

    /// Records that the run depends on whether the number is zero.
    #[inline]
    pub fn zero(&mut self, a: Num) {
        if !a.handle.is_none() {
            self.guard(Guard::Zero(a, a.value == 0.0));
        }
    }

    #[cold]
    fn push(&mut self, node: Node) -> Handle {
        if self.nodes.len() >= self.limit {
            self.full = true;
            return Handle::NONE;
        }
        self.nodes.push(node);
        Handle(self.nodes.len() as u32)
    }

    /// Whether a list of so many entries may grow; past the limit the record is of no use.
    fn has_room(&mut self, entries: usize) -> bool {
        self.full |= entries >= self.limit;
        entries < self.limit
    }

    #[cold]
    fn guard(&mut self, guard: Guard) {
        if self.has_room(self.guards.len()) {
            self.guards.push(guard);
        }
    }
}
