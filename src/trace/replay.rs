//! Replay: what the numbers of a recorded run become when a literal gets another value.

use super::{Guard, LiteralSlice, Node, Num, Op, Trace, float_floor_div, float_mod, norm};

/// What each operation computes; `b` means nothing to those of one number.
pub type Table = fn(Op, f64, f64) -> f64;

/// The replay table: the very operations that the interpreter and the scene do.
pub fn apply(op: Op, a: f64, b: f64) -> f64 {
    match op {
        Op::Add => a + b,
        Op::Sub => a - b,
        Op::Mul => a * b,
        Op::Div => a / b,
        Op::FloorDiv => float_floor_div(a, b),
        Op::Mod => float_mod(a, b),
        Op::Pow => libm::pow(a, b),
        Op::Neg => -a,
        Op::Abs => a.abs(),
        Op::Min => {
            if b < a {
                b
            } else {
                a
            }
        }
        Op::Max => {
            if b > a {
                b
            } else {
                a
            }
        }
        Op::Override => {
            if a >= 0.0 {
                a
            } else {
                b
            }
        }
        Op::Sqrt => a.sqrt(),
        Op::Sin => libm::sin(a),
        Op::Cos => libm::cos(a),
        Op::Tan => libm::tan(a),
        Op::Asin => libm::asin(a),
        Op::Acos => libm::acos(a),
        Op::Atan => libm::atan(a),
        Op::Atan2 => libm::atan2(a, b),
        Op::Sinh => libm::sinh(a),
        Op::Cosh => libm::cosh(a),
        Op::Tanh => libm::tanh(a),
        Op::Exp => libm::exp(a),
        Op::Log => libm::log(a),
        Op::Hypot => norm(&[a, b]),
        Op::Radians => a * (std::f64::consts::PI / 180.0),
        Op::Degrees => a * (180.0 / std::f64::consts::PI),
        Op::Floor => a.floor(),
        Op::Ceil => a.ceil(),
        Op::Trunc => a.trunc(),
        Op::Round => a.round_ties_even(),
        Op::Fmod => libm::fmod(a, b),
        Op::Copysign => a.copysign(b),
        Op::Same => a,
    }
}

/// The first of two numbers for an even turn, the second for an odd one.
pub(super) fn choice(by: f64, of: [f64; 2]) -> f64 {
    of[usize::from(by % 2.0 != 0.0)]
}

/// The present values of the numbers of a record.
///
/// While every guard holds, they are those of a fresh run with the same literals, bit for bit.
#[derive(Clone, Debug)]
pub struct Replay {
    values: Vec<f64>,
    undo: Vec<(u32, f64)>,
    table: Table,
}

impl Replay {
    /// The values of the recorded run.
    pub fn new(trace: &Trace) -> Replay {
        Replay::with_table(trace, apply)
    }

    /// The same with other meanings of the operations, so that tests can show that they would notice.
    pub fn with_table(trace: &Trace, table: Table) -> Replay {
        Replay { values: trace.nodes().iter().map(Node::value).collect(), undo: Vec::new(), table }
    }

    /// The present value of a number.
    #[inline]
    pub fn now(&self, num: Num) -> f64 {
        if num.handle.is_none() { num.value } else { self.values[num.handle.0 as usize - 1] }
    }

    /// The present value of a literal.
    pub fn literal(&self, slice: &LiteralSlice) -> f64 {
        slice.roots.first().map_or(slice.value, |root| self.values[*root as usize])
    }

    /// Gives a literal another value and computes again what depends on it. [`undo`](Replay::undo) takes it back.
    pub fn set(&mut self, trace: &Trace, slice: &LiteralSlice, value: f64) {
        self.undo.clear();
        self.set_too(trace, slice, value);
    }

    /// The same with one more literal; [`undo`](Replay::undo) takes both back.
    pub fn set_too(&mut self, trace: &Trace, slice: &LiteralSlice, value: f64) {
        for root in &slice.roots {
            self.put(*root, value);
        }
        for &at in &slice.nodes {
            let now = match trace.nodes()[at as usize] {
                Node::Literal(..) => continue,
                Node::Unary(op, a, _) => (self.table)(op, self.now(a), 0.0),
                Node::Binary(op, a, b, _) => (self.table)(op, self.now(a), self.now(b)),
                Node::Choice(by, of, _) => choice(self.now(by), of),
                Node::Derived(at, _) => trace.derivations[at as usize].value(&|num| self.now(num)),
            };
            self.put(at, now);
        }
    }

    #[inline]
    fn put(&mut self, at: u32, value: f64) {
        let old = std::mem::replace(&mut self.values[at as usize], value);
        self.undo.push((at, old));
    }

    /// Takes the last [`set`](Replay::set) and what was set too back.
    pub fn undo(&mut self) {
        for (at, old) in self.undo.drain(..).rev() {
            self.values[at as usize] = old;
        }
    }

    /// Whether every decision that the literal takes part in comes out as in the recorded run.
    pub fn holds(&self, trace: &Trace, slice: &LiteralSlice) -> bool {
        let guard = |at: &u32| match trace.guards()[*at as usize] {
            Guard::Equals(a) => self.now(a).to_bits() == a.value.to_bits(),
            Guard::Order(a, b, order) => self.now(a).partial_cmp(&self.now(b)) == order,
            Guard::Zero(a, zero) => (self.now(a) == 0.0) == zero,
            Guard::Finite(a, finite) => self.now(a).is_finite() == finite,
        };
        let decision = |at: &u32| trace.decisions()[*at as usize].holds(&|num| self.now(num));
        slice.guards.iter().all(guard) && slice.decisions.iter().all(decision)
    }
}
