//! `for` and `while`.

use ruff_text_size::{Ranged, TextRange};

use super::blocks::{BlockKind, LoopPiece};
use super::{Compiled, Compiler};
use crate::python::code::{Op, Slot};
use crate::syntax::ast::{self, Expr};

/// The name that a person would use for a loop: the first in its target.
fn first_name(target: &Expr) -> Option<&str> {
    match target {
        Expr::Name(node) => Some(&node.id),
        Expr::Starred(node) => first_name(&node.value),
        Expr::Tuple(node) => node.elts.iter().find_map(first_name),
        Expr::List(node) => node.elts.iter().find_map(first_name),
        _ => None,
    }
}

/// A test that needs no code.
fn is_always_true(test: &Expr) -> bool {
    match test {
        Expr::BooleanLiteral(node) => node.value,
        Expr::NumberLiteral(node) => matches!(&node.value, ast::Number::Int(value) if *value != 0),
        _ => false,
    }
}

impl<'a> Compiler<'a> {
    pub(super) fn loop_variable(&mut self, target: &'a Expr) -> Option<(Box<str>, Slot)> {
        first_name(target).and_then(|name| self.variable(name))
    }

    pub(super) fn for_statement(&mut self, node: &'a ast::StmtFor, header: TextRange) -> Compiled {
        let (next, done, end) = (self.label(), self.label(), self.label());
        let depth = self.unit.emitter.depth();
        let variable = self.loop_variable(&node.target);
        self.expr(&node.iter)?;
        self.emit(Op::StartLoop, node.iter.range());
        self.bind(next);
        let piece = LoopPiece { start: self.unit.emitter.here(), depth, range: header, variable };
        self.push_block(BlockKind::For { next, end, piece }, header)?;
        self.jump(Op::ForIter, done, node.iter.range());
        self.store(&node.target)?;
        self.body(&node.body)?;
        self.jump(Op::JumpBack, next, header);
        let after = self.unit.emitter.here();
        if let Some(BlockKind::For { piece, .. }) = self.pop_block().map(|block| block.kind) {
            self.unit.emitter.add_loop(piece.until(after));
        }
        self.bind(done);
        self.body(&node.orelse)?;
        self.bind(end);
        Ok(())
    }

    pub(super) fn while_statement(&mut self, node: &'a ast::StmtWhile, header: TextRange) -> Compiled {
        let (next, done, end) = (self.label(), self.label(), self.label());
        self.bind(next);
        self.push_block(BlockKind::While { next, end }, header)?;
        self.unit.emitter.mark(header);
        if !is_always_true(&node.test) {
            self.jump_if(&node.test, false, done)?;
        }
        self.body(&node.body)?;
        self.jump(Op::JumpBack, next, header);
        self.pop_block();
        self.bind(done);
        self.body(&node.orelse)?;
        self.bind(end);
        Ok(())
    }
}
