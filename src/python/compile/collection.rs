//! Displays of lists, tuples, sets and dicts.

use ruff_text_size::{Ranged, TextRange};

use super::emit::narrow;
use super::{Compiled, Compiler};
use crate::python::code::{Const, Op};
use crate::syntax::ast::{self, Expr};

/// How many items wait on the stack before they go into a container.
const BATCH: usize = 64;

/// What is built from a sequence of items.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Sequence {
    List,
    Tuple,
    Set,
}

impl<'a> Compiler<'a> {
    /// Builds a container from `waiting` items on the stack and those of the list, some of which may be starred.
    pub(super) fn sequence(&mut self, kind: Sequence, waiting: u32, items: &'a [Expr], range: TextRange) -> Compiled {
        if kind == Sequence::Tuple
            && waiting == 0
            && let Some(constants) = self.constants_of(items)
        {
            self.constant(Const::Tuple(constants), range);
            return Ok(());
        }
        let plain = items.iter().take_while(|item| !item.is_starred_expr()).take(BATCH).count();
        let (first, rest) = items.split_at(plain);
        for item in first {
            self.expr(item)?;
        }
        let count = waiting.saturating_add(narrow(plain));
        match kind {
            Sequence::Tuple if rest.is_empty() => self.emit(Op::BuildTuple(count), range),
            Sequence::Set => self.emit(Op::BuildSet(count), range),
            Sequence::List | Sequence::Tuple => self.emit(Op::BuildList(count), range),
        }
        if rest.is_empty() {
            return Ok(());
        }
        for item in rest {
            let op = if let Expr::Starred(starred) = item {
                self.expr(&starred.value)?;
                if kind == Sequence::Set { Op::SetUpdate } else { Op::ListExtend }
            } else {
                self.expr(item)?;
                if kind == Sequence::Set { Op::SetAdd(0) } else { Op::ListAppend(0) }
            };
            self.emit(op, item.range());
        }
        if kind == Sequence::Tuple {
            self.emit(Op::ListToTuple, range);
        }
        Ok(())
    }

    pub(super) fn dict(&mut self, node: &'a ast::ExprDict) -> Compiled {
        let mut begun = false;
        let mut items = node.items.as_slice();
        while !items.is_empty() || !begun {
            let pairs = items.iter().take_while(|item| item.key.is_some()).take(BATCH).count();
            let (batch, rest) = items.split_at(pairs);
            for item in batch {
                if let Some(key) = &item.key {
                    self.expr(key)?;
                }
                self.expr(&item.value)?;
            }
            if !begun || pairs > 0 {
                self.emit(Op::BuildDict(narrow(pairs)), node.range);
                if begun {
                    self.emit(Op::DictUpdate, node.range);
                }
                begun = true;
            }
            items = rest;
            if let Some((item, rest)) = items.split_first()
                && item.key.is_none()
            {
                self.expr(&item.value)?;
                self.emit(Op::DictUpdate, item.value.range());
                items = rest;
            }
        }
        Ok(())
    }
}
