//! Slices of a record: what of it depends on which literal.

use std::cell::RefCell;

use smallvec::SmallVec;

use super::{Guard, Handle, Node, Num, Trace};

/// A record whose table of dependencies would have more words than this is not sliced.
const MAX_WORDS: usize = 8_000_000;

/// All that one literal reaches, in the order of the record.
#[derive(Clone, Debug, PartialEq)]
pub struct LiteralSlice {
    /// The number of the literal in the program; of a direction, with [`SITE`](super::SITE).
    pub id: u32,
    /// Its value in the recorded run.
    pub value: f64,
    /// The nodes that stand for it; a literal of a duplicated block has several.
    pub roots: Vec<u32>,
    /// The nodes that are computed from it.
    pub nodes: Vec<u32>,
    /// The guards that read it.
    pub guards: Vec<u32>,
    /// The decisions that read it.
    pub decisions: Vec<u32>,
}

/// The slices of all literals of a record, forward and backward.
#[derive(Clone, Debug, Default)]
pub struct Slices {
    literals: Vec<LiteralSlice>,
    words: usize,
    /// For each node the set of its literals, `words` words each.
    sets: Vec<u64>,
}

impl Slices {
    /// Slices a record. `None` where it is full or too large to be of use.
    pub fn of(trace: &Trace) -> Option<Slices> {
        if trace.is_full() {
            return None;
        }
        let mut ids: Vec<(u32, f64)> =
            trace.nodes().iter().filter_map(|node| if let Node::Literal(id, value) = node { Some((*id, *value)) } else { None }).collect();
        ids.sort_by_key(|literal| literal.0);
        ids.dedup_by_key(|literal| literal.0);
        let words = ids.len().div_ceil(64);
        if words.saturating_mul(trace.nodes().len()) > MAX_WORDS {
            return None;
        }
        let empty =
            |(id, value)| LiteralSlice { id, value, roots: Vec::new(), nodes: Vec::new(), guards: Vec::new(), decisions: Vec::new() };
        let mut slices = Slices { literals: ids.into_iter().map(empty).collect(), words, sets: vec![0; words * trace.nodes().len()] };
        slices.follow_nodes(trace);
        slices.follow_guards(trace);
        Some(slices)
    }

    fn follow_nodes(&mut self, trace: &Trace) {
        for (at, node) in trace.nodes().iter().enumerate() {
            match *node {
                Node::Literal(id, _) => {
                    if let Some(literal) = self.index(id) {
                        self.sets[at * self.words + literal / 64] |= 1 << (literal % 64);
                        self.literals[literal].roots.push(at as u32);
                    }
                }
                Node::Unary(_, a, _) | Node::Choice(a, ..) => self.join(at, &[a]),
                Node::Binary(_, a, b, _) => self.join(at, &[a, b]),
                Node::Derived(..) => {
                    let mut operands: SmallVec<[Num; 8]> = SmallVec::new();
                    trace.operands(node, &mut |num| operands.push(num));
                    self.join(at, &operands);
                }
            }
        }
    }

    fn join(&mut self, at: usize, operands: &[Num]) {
        for operand in operands.iter().filter(|operand| !operand.handle.is_none()) {
            let from = (operand.handle.0 as usize - 1) * self.words;
            for word in 0..self.words {
                self.sets[at * self.words + word] |= self.sets[from + word];
            }
        }
        for literal in members(&self.sets[at * self.words..(at + 1) * self.words]) {
            self.literals[literal].nodes.push(at as u32);
        }
    }

    fn follow_guards(&mut self, trace: &Trace) {
        for (at, guard) in trace.guards().iter().enumerate() {
            let handles = match guard {
                Guard::Equals(a) | Guard::Zero(a, _) | Guard::Finite(a, _) => [a.handle, Handle::NONE],
                Guard::Order(a, b, _) => [a.handle, b.handle],
            };
            for literal in self.reaching_any(&handles) {
                self.literals[literal].guards.push(at as u32);
            }
        }
        for (at, decision) in trace.decisions().iter().enumerate() {
            // A decision says what it reads by reading it.
            let read = RefCell::new(Vec::new());
            decision.holds(&|num| {
                read.borrow_mut().push(num.handle);
                num.value
            });
            for literal in self.reaching_any(&read.into_inner()) {
                self.literals[literal].decisions.push(at as u32);
            }
        }
    }

    fn reaching_any(&self, handles: &[Handle]) -> Vec<usize> {
        let mut set = vec![0; self.words];
        for handle in handles.iter().filter(|handle| !handle.is_none()) {
            let from = (handle.0 as usize - 1) * self.words;
            for (word, more) in set.iter_mut().zip(&self.sets[from..from + self.words]) {
                *word |= more;
            }
        }
        members(&set).collect()
    }

    /// All slices, by the number of the literal.
    pub fn literals(&self) -> &[LiteralSlice] {
        &self.literals
    }

    /// The place among [`literals`](Slices::literals) of a literal of the program.
    pub fn index(&self, id: u32) -> Option<usize> {
        self.literals.binary_search_by_key(&id, |literal| literal.id).ok()
    }

    /// The literals that reach a number, as places among [`literals`](Slices::literals).
    pub fn reaching(&self, handle: Handle) -> impl Iterator<Item = usize> + '_ {
        let from = if handle.is_none() { None } else { Some((handle.0 as usize - 1) * self.words) };
        from.into_iter().flat_map(|from| members(&self.sets[from..from + self.words]))
    }
}

/// The members of a bit set.
fn members(set: &[u64]) -> impl Iterator<Item = usize> + use<> {
    let set: SmallVec<[u64; 8]> = set.into();
    let (mut at, mut word) = (0, set.first().copied().unwrap_or_default());
    std::iter::from_fn(move || {
        while word == 0 {
            at += 1;
            word = *set.get(at)?;
        }
        let bit = word.trailing_zeros() as usize;
        word &= word - 1;
        Some(at * 64 + bit)
    })
}
