//! `try` and `with`.
//!
//! A handler is entered with the exception on the stack. Handlers that are done with it say `PopExc`; those that an exception leaves
//! need not: the machine cuts what is being handled to what the next region says.

use ruff_text_size::{Ranged, TextRange};

use super::blocks::BlockKind;
use super::{Compiled, Compiler, Label, error};
use crate::python::code::Op;
use crate::syntax::ast::{self, ExceptHandler, ExceptHandlerExceptHandler, Expr, Stmt};

fn clause_header(handler: &ExceptHandlerExceptHandler) -> TextRange {
    let keyword = handler.range.start() + ruff_text_size::TextSize::of("except");
    let end = handler.name.as_ref().map(Ranged::end).or_else(|| handler.type_.as_ref().map(|kind| kind.end()));
    TextRange::new(handler.range.start(), end.unwrap_or(keyword))
}

impl<'a> Compiler<'a> {
    /// Enters a region whose operands are those below the topmost `above`.
    fn push_handled(&mut self, kind: BlockKind<'a>, target: Label, above: u32, range: TextRange) -> Compiled {
        let (depth, handling) = (self.unit.emitter.depth().saturating_sub(above), self.unit.handling);
        self.push_region(kind, target, depth, handling, range)
    }

    pub(super) fn try_statement(&mut self, node: &'a ast::StmtTry, header: TextRange) -> Compiled {
        if node.finalbody.is_empty() {
            return self.try_except(node, header);
        }
        let (failed, end) = (self.label(), self.label());
        self.push_handled(BlockKind::Finally(&node.finalbody), failed, 0, header)?;
        if node.handlers.is_empty() {
            self.body(&node.body)?;
            self.body(&node.orelse)?;
        } else {
            self.try_except(node, header)?;
        }
        self.pop_block();
        self.body(&node.finalbody)?;
        self.jump(Op::Jump, end, header);
        self.bind(failed);
        self.begin_handling(header);
        self.push_block(BlockKind::FinallyEnd, header)?;
        self.body(&node.finalbody)?;
        self.pop_block();
        self.unit.handling -= 1;
        self.emit(Op::Reraise, header);
        self.bind(end);
        Ok(())
    }

    fn try_except(&mut self, node: &'a ast::StmtTry, header: TextRange) -> Compiled {
        let (failed, end) = (self.label(), self.label());
        self.push_handled(BlockKind::Try, failed, 0, header)?;
        self.body(&node.body)?;
        self.pop_block();
        self.body(&node.orelse)?;
        self.jump(Op::Jump, end, header);
        self.bind(failed);
        self.begin_handling(header);
        if node.is_star {
            self.star_clauses(&node.handlers, header, end)?;
        } else {
            self.clauses(&node.handlers, header, end)?;
        }
        self.unit.handling -= 1;
        self.bind(end);
        Ok(())
    }

    /// exception →, through the clause that takes it to `end`.
    fn clauses(&mut self, handlers: &'a [ExceptHandler], header: TextRange, end: Label) -> Compiled {
        for ExceptHandler::ExceptHandler(handler) in handlers {
            let range = clause_header(handler);
            let next = self.label();
            self.unit.emitter.mark(range);
            if let Some(kind) = &handler.type_ {
                self.expr(kind)?;
                self.emit(Op::ExcMatch, kind.range());
                self.jump(Op::PopJumpIfFalse, next, kind.range());
            }
            self.bind_exception(handler, range);
            self.clause_body(handler, range)?;
            self.jump(Op::Jump, end, range);
            self.unit.handling += 1;
            if handler.type_.is_none() {
                return Ok(());
            }
            self.bind(next);
        }
        self.emit(Op::Reraise, header);
        Ok(())
    }

    fn bind_exception(&mut self, handler: &'a ExceptHandlerExceptHandler, range: TextRange) {
        match &handler.name {
            Some(name) => self.store_name(name, name.range),
            None => self.emit(Op::Pop, range),
        }
    }

    /// The body of a clause, after which the exception is done with and its name forgotten. If it raises, only the latter.
    fn clause_body(&mut self, handler: &'a ExceptHandlerExceptHandler, range: TextRange) -> Compiled {
        let Some(name) = &handler.name else {
            self.push_block(BlockKind::Except(None), range)?;
            self.body(&handler.body)?;
            self.pop_block();
            self.end_handling(range);
            return Ok(());
        };
        let (raised, done) = (self.label(), self.label());
        let (depth, handling) = (self.unit.emitter.depth(), self.unit.handling.saturating_sub(1));
        self.push_region(BlockKind::Except(Some(name)), raised, depth, handling, range)?;
        self.body(&handler.body)?;
        self.pop_block();
        self.end_handling(range);
        self.forget(Some(name));
        self.jump(Op::Jump, done, range);
        self.bind(raised);
        self.forget(Some(name));
        self.emit(Op::Reraise, range);
        self.bind(done);
        Ok(())
    }

    /// exception →. The stack is: the exception, a list of what must be raised in the end, what no clause has taken yet.
    fn star_clauses(&mut self, handlers: &'a [ExceptHandler], header: TextRange, end: Label) -> Compiled {
        self.emit(Op::Dup, header);
        self.emit(Op::BuildList(0), header);
        self.emit(Op::Swap, header);
        for ExceptHandler::ExceptHandler(handler) in handlers {
            self.star_clause(handler)?;
        }
        self.emit(Op::ListAppend(0), header);
        self.emit(Op::ExcGroupFinish, header);
        let done = self.label();
        self.emit(Op::Dup, header);
        self.jump(Op::PopJumpIfNone, done, header);
        self.emit(Op::PopExc, header);
        self.emit(Op::Reraise, header);
        self.bind(done);
        self.emit(Op::Pop, header);
        self.emit(Op::PopExc, header);
        self.jump(Op::Jump, end, header);
        Ok(())
    }

    fn star_clause(&mut self, handler: &'a ExceptHandlerExceptHandler) -> Compiled {
        let range = clause_header(handler);
        let Some(kind) = &handler.type_ else { return error(range, "expected one or more exception types") };
        let (untouched, raised, next) = (self.label(), self.label(), self.label());
        self.unit.emitter.mark(range);
        self.expr(kind)?;
        self.emit(Op::ExcGroupMatch, kind.range());
        self.emit(Op::Dup, range);
        self.jump(Op::PopJumpIfNone, untouched, range);
        self.begin_handling(range);
        self.bind_exception(handler, range);
        let (depth, handling) = (self.unit.emitter.depth(), self.unit.handling.saturating_sub(1));
        self.push_region(BlockKind::ExceptStar, raised, depth, handling, range)?;
        self.body(&handler.body)?;
        self.pop_block();
        self.end_handling(range);
        self.forget(handler.name.as_ref());
        self.jump(Op::Jump, next, range);
        self.bind(raised);
        self.forget(handler.name.as_ref());
        self.emit(Op::ListAppend(1), range);
        self.jump(Op::Jump, next, range);
        self.bind(untouched);
        self.emit(Op::Pop, range);
        self.bind(next);
        Ok(())
    }

    pub(super) fn with_statement(&mut self, node: &'a ast::StmtWith, header: TextRange) -> Compiled {
        self.with_items(&node.items, &node.body, header)
    }

    fn with_items(&mut self, items: &'a [ast::WithItem], body: &'a [Stmt], header: TextRange) -> Compiled {
        let Some((item, rest)) = items.split_first() else { return self.body(body) };
        let (failed, suppressed, end) = (self.label(), self.label(), self.label());
        let manager: &'a Expr = &item.context_expr;
        self.expr(manager)?;
        self.emit(Op::BeforeWith, manager.range());
        self.push_handled(BlockKind::With(manager.range()), failed, 1, header)?;
        match item.optional_vars.as_deref() {
            Some(target) => self.store(target)?,
            None => self.emit(Op::Pop, manager.range()),
        }
        self.with_items(rest, body, header)?;
        self.pop_block();
        self.exit_manager(manager.range());
        self.jump(Op::Jump, end, header);
        self.bind(failed);
        self.unit.emitter.mark(header);
        self.emit(Op::PushExc, header);
        self.emit(Op::WithExcept, manager.range());
        self.jump(Op::PopJumpIfTrue, suppressed, manager.range());
        self.emit(Op::Reraise, header);
        self.bind(suppressed);
        self.emit(Op::Pop, header);
        self.emit(Op::PopExc, header);
        self.emit(Op::Pop, header);
        self.bind(end);
        Ok(())
    }
}
