//! The few float operations that rooms below use on numbers that may have to be replayed.

use std::fmt::Debug;
use std::sync::Arc;

use super::{Num, Op, Trace};

/// A decision taken on recorded numbers, in a form that can be asked again with other numbers.
pub trait Decision: Debug + Send + Sync {
    /// True where the decision comes out as it did. `now` gives the present value of a number that took part.
    fn holds(&self, now: &dyn Fn(Num) -> f64) -> bool;
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
    fn finite(&mut self, a: Num) -> bool {
        a.value.is_finite()
    }

    #[inline]
    fn set_in_stone(&mut self, _: Num) {}

    #[inline]
    fn decided(&mut self, _: &[Num], _: &mut dyn FnMut() -> Box<dyn Decision>) {}
}

/// A number must stay finite.
#[derive(Debug)]
struct Finite(Num, bool);

impl Decision for Finite {
    fn holds(&self, now: &dyn Fn(Num) -> f64) -> bool {
        now(self.0).is_finite() == self.1
    }
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
        self.decided(&[a], &mut || Box::new(Finite(a, answer)));
        answer
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
