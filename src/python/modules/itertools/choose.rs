//! `product`, `permutations`, `combinations`, `combinations_with_replacement`: all in lexicographic order of positions.

use crate::python::classes::Builtin;
use crate::python::value::Value;
use smallvec::SmallVec;
use std::mem::size_of;

/// Which selections are made.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Kind {
    Product,
    Permutations,
    Combinations,
    CombinationsWithReplacement,
}

/// Where such an iterator stands.
#[derive(Clone, Debug)]
pub struct Choice {
    kind: Kind,
    /// What is chosen from: one pool, or for a product one for each place (taken in turn where it is repeated).
    pools: Vec<Vec<Value>>,
    /// The positions that were chosen last; for permutations all of them, in their present order.
    indices: Vec<usize>,
    /// Permutations: how many choices each place has left.
    cycles: Vec<usize>,
    /// How many are chosen.
    size: usize,
    begun: bool,
    over: bool,
}

impl Choice {
    /// Selections of `size` from the pools.
    pub fn new(kind: Kind, pools: Vec<Vec<Value>>, size: usize) -> Choice {
        let n = pools.first().map_or(0, Vec::len);
        let (mut indices, mut cycles) = (Vec::new(), Vec::new());
        let over = match kind {
            Kind::Product => pools.iter().any(Vec::is_empty) && size > 0,
            Kind::Permutations | Kind::Combinations => size > n,
            Kind::CombinationsWithReplacement => n == 0 && size > 0,
        };
        if !over {
            indices = match kind {
                Kind::Product | Kind::CombinationsWithReplacement => vec![0; size],
                Kind::Combinations => (0..size).collect(),
                Kind::Permutations => (0..n).collect(),
            };
            if kind == Kind::Permutations {
                cycles = (0..size).map(|i| n - i).collect();
            }
        }
        Choice { kind, pools, indices, cycles, size, begun: false, over }
    }

    /// Bytes beyond its own size.
    pub fn extra(&self) -> usize {
        let values: usize = self.pools.iter().map(Vec::capacity).sum();
        values * size_of::<Value>() + (self.indices.capacity() + self.cycles.capacity()) * size_of::<usize>()
    }

    /// The values it holds.
    pub fn children(&self, out: &mut Vec<Value>) {
        self.pools.iter().for_each(|pool| out.extend_from_slice(pool));
    }

    /// Its class.
    pub fn class(&self) -> Builtin {
        match self.kind {
            Kind::Product => Builtin::ToolProduct,
            Kind::Permutations => Builtin::ToolPermutations,
            Kind::Combinations => Builtin::ToolCombinations,
            Kind::CombinationsWithReplacement => Builtin::ToolCombinationsWithReplacement,
        }
    }

    /// The next selection.
    pub fn advance(&mut self) -> Option<SmallVec<[Value; 3]>> {
        if self.over {
            return None;
        }
        if self.begun && !self.step() {
            self.over = true;
            return None;
        }
        self.begun = true;
        let pools = self.pools.len().max(1);
        Some(self.indices[..self.size].iter().enumerate().map(|(place, &i)| self.pools[place % pools][i]).collect())
    }

    fn step(&mut self) -> bool {
        let (size, n) = (self.size, self.pools.first().map_or(0, Vec::len));
        let indices = &mut self.indices;
        match self.kind {
            Kind::Product => {
                for place in (0..size).rev() {
                    indices[place] += 1;
                    if indices[place] < self.pools[place % self.pools.len()].len() {
                        return true;
                    }
                    indices[place] = 0;
                }
                false
            }
            Kind::Combinations => {
                let Some(place) = (0..size).rev().find(|&i| indices[i] != i + n - size) else { return false };
                let first = indices[place] + 1;
                for (offset, index) in indices[place..].iter_mut().enumerate() {
                    *index = first + offset;
                }
                true
            }
            Kind::CombinationsWithReplacement => {
                let Some(place) = (0..size).rev().find(|&i| indices[i] + 1 != n) else { return false };
                let value = indices[place] + 1;
                indices[place..].fill(value);
                true
            }
            Kind::Permutations => {
                for place in (0..size).rev() {
                    self.cycles[place] -= 1;
                    if self.cycles[place] == 0 {
                        indices[place..].rotate_left(1);
                        self.cycles[place] = n - place;
                    } else {
                        let other = n - self.cycles[place];
                        indices.swap(place, other);
                        return true;
                    }
                }
                false
            }
        }
    }
}
