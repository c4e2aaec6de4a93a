//! The few float operations that rooms below use on numbers that may have to be replayed.

use std::fmt::Debug;
use std::sync::Arc;

use super::replay::choice;
use super::{Guard, Handle, Node, Num, Op, Trace, apply};

/// A decision taken on recorded numbers, in a form that can be asked again with other numbers.
pub trait Decision: Debug + Send + Sync {
    /// True where the decision comes out as it did. `now` gives the present value of a number that took part.
    fn holds(&self, now: &dyn Fn(Num) -> f64) -> bool;
}

/// A number that follows from others in a way that is no operation of the table.
pub trait Derivation: Debug + Send + Sync {
    /// The number. `now` gives the present value of a number that it follows from; which are asked does not depend on their values.
    fn value(&self, now: &dyn Fn(Num) -> f64) -> f64;
}

/// Does float arithmetic and, where a record is kept, remembers it.
///
/// Results are those of IEEE 754 doubles, operation by operation, whether or not a record is kept.
/// A result has a handle only if one of the operands has.
pub trait Arith {
    /// `a + b`
    fn add(&mut self, a: Num, b: Num) -> Num;
    /// `a - b`
    fn sub(&mut self, a: Num, b: Num) -> Num;
    /// `-a`
    fn neg(&mut self, a: Num) -> Num;
    /// `a op b`, as the replay table has it.
    fn compute(&mut self, op: Op, a: Num, b: Num) -> Num;
    /// The first of two numbers for an even turn, the second for an odd one.
    fn choose(&mut self, turn: Num, of: [f64; 2]) -> Num;
    /// The run depends on this very value.
    fn pin(&mut self, a: Num);
    /// `value` follows from `inputs`. `make` is called only where a record is kept and an input has a handle.
    fn derived(&mut self, inputs: &[Num], value: f64, make: &mut dyn FnMut() -> Box<dyn Derivation>) -> Num;
    /// Whether `a` is finite; the answer is a decision of the run.
    fn finite(&mut self, a: Num) -> bool;
    /// The number became the size of something: no literal that reaches it may be tuned.
    fn set_in_stone(&mut self, a: Num);
    /// A decision was taken on `inputs`. `make` is called only where a record is kept and an input has a handle.
    fn decided(&mut self, inputs: &[Num], make: &mut dyn FnMut() -> Box<dyn Decision>);
}

/// Arithmetic without a record.
#[derive(Clone, Copy, Debug, Default)]
pub struct Plain;

impl Arith for Plain {
    #[inline]
    fn add(&mut self, a: Num, b: Num) -> Num {
        Num::plain(a.value + b.value)
    }

    #[inline]
    fn sub(&mut self, a: Num, b: Num) -> Num {
        Num::plain(a.value - b.value)
    }

    #[inline]
    fn neg(&mut self, a: Num) -> Num {
        Num::plain(-a.value)
    }

    #[inline]
    fn compute(&mut self, op: Op, a: Num, b: Num) -> Num {
        Num::plain(apply(op, a.value, b.value))
    }

    #[inline]
    fn choose(&mut self, turn: Num, of: [f64; 2]) -> Num {
        Num::plain(choice(turn.value, of))
    }

    #[inline]
    fn pin(&mut self, _: Num) {}

    #[inline]
    fn derived(&mut self, _: &[Num], value: f64, _: &mut dyn FnMut() -> Box<dyn Derivation>) -> Num {
        Num::plain(value)
    }

    #[inline]
    fn finite(&mut self, a: Num) -> bool {
        a.value.is_finite()
    }

    #[inline]
    fn set_in_stone(&mut self, _: Num) {}

    #[inline]
    fn decided(&mut self, _: &[Num], _: &mut dyn FnMut() -> Box<dyn Decision>) {}
}

impl Arith for Trace {
    #[inline]
    fn add(&mut self, a: Num, b: Num) -> Num {
        let value = a.value + b.value;
        Num { value, handle: self.binary(Op::Add, a, b, value) }
    }

    #[inline]
    fn sub(&mut self, a: Num, b: Num) -> Num {
        let value = a.value - b.value;
        Num { value, handle: self.binary(Op::Sub, a, b, value) }
    }

    #[inline]
    fn neg(&mut self, a: Num) -> Num {
        Num { value: -a.value, handle: self.unary(Op::Neg, a, -a.value) }
    }

    fn finite(&mut self, a: Num) -> bool {
        let answer = a.value.is_finite();
        if !a.handle.is_none() {
            self.guard(Guard::Finite(a, answer));
        }
        answer
    }

    fn compute(&mut self, op: Op, a: Num, b: Num) -> Num {
        let value = apply(op, a.value, b.value);
        Num { value, handle: self.binary(op, a, b, value) }
    }

    fn choose(&mut self, turn: Num, of: [f64; 2]) -> Num {
        let value = choice(turn.value, of);
        let handle = if turn.handle.is_none() { Handle::NONE } else { self.push(Node::Choice(turn, of, value)) };
        Num { value, handle }
    }

    fn pin(&mut self, a: Num) {
        Trace::pin(self, a);
    }

    fn derived(&mut self, inputs: &[Num], value: f64, make: &mut dyn FnMut() -> Box<dyn Derivation>) -> Num {
        if inputs.iter().all(|input| input.handle.is_none()) || !self.has_room(self.derivations.len()) {
            return Num::plain(value);
        }
        let handle = self.push(Node::Derived(self.derivations.len() as u32, value));
        self.derivations.push(Arc::from(make()));
        Num { value, handle }
    }

    fn set_in_stone(&mut self, a: Num) {
        if !a.handle.is_none() && self.has_room(self.stone.len()) {
            self.stone.push(a.handle);
        }
    }

    fn decided(&mut self, inputs: &[Num], make: &mut dyn FnMut() -> Box<dyn Decision>) {
        if inputs.iter().any(|input| !input.handle.is_none()) && self.has_room(self.decisions.len()) {
            self.decisions.push(Arc::from(make()));
        }
    }
}
