//! The next item of a loop, with the common iterators at once and without a tuple for what is taken apart right away.

use super::Vm;
use super::fast::{push_copy, set};
use crate::python::code::Op;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::iter::IterState;
use crate::python::value::Value;
use smallvec::SmallVec;

/// What became of the next item of a loop.
pub(super) enum Next {
    /// It is on the stack.
    Item,
    /// The instruction that follows is done as well.
    Stored,
    /// There is none.
    Over,
}

impl Vm<'_> {
    /// The next item of an iterator: pushed, or where `then` says what becomes of it and that is simple, stored there.
    #[inline(always)]
    pub(super) fn quick_next(&mut self, iter: Value, then: Option<&Op>, base: usize) -> R<Next> {
        let Value::Iter(r) = iter else { return self.next_pushed(iter) };
        match &mut self.heap[r].0 {
            IterState::Range { next, step, left } => {
                if *left == 0 {
                    return Ok(Next::Over);
                }
                *left -= 1;
                let value = *next;
                *next = value.wrapping_add(*step);
                match then {
                    Some(&Op::StoreFast(slot)) => self.stack[base + usize::from(slot)] = Value::int(value),
                    Some(&Op::StoreGlobal(slot)) => self.heap[self.frame.module].slots[slot as usize] = Value::int(value),
                    _ => {
                        self.stack.push(Value::int(value));
                        return Ok(Next::Item);
                    }
                }
                Ok(Next::Stored)
            }
            IterState::List { list, index } => {
                let (list, at) = (*list, *index);
                *index += 1;
                let Some(item) = self.heap[list].0.get(at) else {
                    self.heap[r].0.finish();
                    return Ok(Next::Over);
                };
                match then {
                    Some(&Op::StoreFast(slot)) => set(&mut self.stack[base + usize::from(slot)], item),
                    Some(&Op::StoreGlobal(slot)) => {
                        let item = *item;
                        self.heap[self.frame.module].slots[slot as usize] = item;
                    }
                    _ => {
                        push_copy(&mut self.stack, item);
                        return Ok(Next::Item);
                    }
                }
                Ok(Next::Stored)
            }
            IterState::Enumerate { .. } | IterState::Zip { .. } | IterState::Dict { kind: ViewKind::Items, .. } => match then {
                Some(&Op::Unpack(n)) if self.next_parts(r, n as usize)? => Ok(Next::Stored),
                _ => self.next_pushed(iter),
            },
            _ => self.next_pushed(iter),
        }
    }

    #[inline(never)]
    fn next_pushed(&mut self, iter: Value) -> R<Next> {
        Ok(match self.next(iter)? {
            Some(item) => {
                self.stack.push(item);
                Next::Item
            }
            None => Next::Over,
        })
    }

    /// The next row of `enumerate`, `zip` or `dict.items()` without a tuple around it: its items are pushed, the first on top. `false`,
    /// and nothing was done, where the row has another length, or there is none or may be none.
    #[inline(never)]
    fn next_parts(&mut self, r: Ref<Iter>, count: usize) -> R<bool> {
        match &self.heap[r].0 {
            IterState::Enumerate { iter, count: Value::Int(n, h) } if count == 2 && h.is_none() && *n < i64::MAX => {
                let (iter, n) = (*iter, *n);
                let Some(item) = self.next_of_list(iter) else { return Ok(false) };
                if let IterState::Enumerate { count, .. } = &mut self.heap[r].0 {
                    *count = Value::int(n + 1);
                }
                push_copy(&mut self.stack, &item);
                self.stack.push(Value::int(n));
            }
            IterState::Zip { iters, .. } if iters.len() == count && count <= 4 => {
                let iters: SmallVec<[Value; 4]> = SmallVec::from_slice(iters);
                if !iters.iter().all(|iter| self.list_has_next(*iter)) {
                    return Ok(false);
                }
                let mut row = SmallVec::<[Value; 4]>::new();
                row.extend(iters.iter().filter_map(|iter| self.next_of_list(*iter)));
                for item in row.iter().rev() {
                    push_copy(&mut self.stack, item);
                }
            }
            &IterState::Dict { dict, kind: ViewKind::Items, position, len } if count == 2 && self.heap[dict].0.len() == len => {
                let Some((at, entry)) = self.heap[dict].0.next_from(position) else { return Ok(false) };
                self.charge((at - position) as u64 / 16)?;
                if let IterState::Dict { position, .. } = &mut self.heap[r].0 {
                    *position = at + 1;
                }
                push_copy(&mut self.stack, &entry.value);
                push_copy(&mut self.stack, &entry.key);
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Whether this is an iterator over a list, tuple or range that has not come to its end.
    fn list_has_next(&self, iter: Value) -> bool {
        let Value::Iter(r) = iter else { return false };
        match &self.heap[r].0 {
            IterState::List { list, index } => *index < self.heap[*list].0.len(),
            IterState::Tuple { tuple, index } => *index < self.heap[*tuple].0.len(),
            IterState::Range { left, .. } => *left > 0,
            _ => false,
        }
    }

    /// The next item of an iterator over a list, tuple or range; `None` at its end, where it stays as it is, and for other iterators.
    fn next_of_list(&mut self, iter: Value) -> Option<Value> {
        let Value::Iter(r) = iter else { return None };
        match &mut self.heap[r].0 {
            IterState::List { list, index } => {
                let (list, at) = (*list, *index);
                let item = self.heap[list].0.get(at).copied()?;
                if let IterState::List { index, .. } = &mut self.heap[r].0 {
                    *index += 1;
                }
                Some(item)
            }
            IterState::Tuple { tuple, index } => {
                let (tuple, at) = (*tuple, *index);
                let item = self.heap[tuple].0.get(at).copied()?;
                if let IterState::Tuple { index, .. } = &mut self.heap[r].0 {
                    *index += 1;
                }
                Some(item)
            }
            IterState::Range { next, step, left } if *left > 0 => {
                *left -= 1;
                let value = *next;
                *next = value.wrapping_add(*step);
                Some(Value::int(value))
            }
            _ => None,
        }
    }
}
