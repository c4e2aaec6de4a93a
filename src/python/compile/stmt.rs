//! Statements: each leaves the stack as it found it.

use ruff_text_size::{Ranged, TextRange, TextSize};

use super::{Compiled, Compiler, RED_ZONE, STACK_PIECE, error};
use crate::python::code::{Const, Op, TopStatement};
use crate::syntax::ast::{self, Expr, Stmt};

/// Whether names are annotated in the namespace that a body fills, rather than in one of an inner definition.
pub(super) fn has_annotations(body: &[Stmt]) -> bool {
    body.iter().any(|stmt| match stmt {
        Stmt::AnnAssign(_) => true,
        Stmt::If(node) => has_annotations(&node.body) || node.elif_else_clauses.iter().any(|clause| has_annotations(&clause.body)),
        Stmt::For(node) => has_annotations(&node.body) || has_annotations(&node.orelse),
        Stmt::While(node) => has_annotations(&node.body) || has_annotations(&node.orelse),
        Stmt::With(node) => has_annotations(&node.body),
        Stmt::Match(node) => node.cases.iter().any(|case| has_annotations(&case.body)),
        Stmt::Try(node) => {
            let in_handler = |ast::ExceptHandler::ExceptHandler(handler): &ast::ExceptHandler| has_annotations(&handler.body);
            [&node.body, &node.orelse, &node.finalbody].into_iter().any(|body| has_annotations(body))
                || node.handlers.iter().any(in_handler)
        }
        _ => false,
    })
}

/// What of a statement a person is shown: a simple one as a whole, the header of a compound one.
fn header(stmt: &Stmt) -> TextRange {
    let end = match stmt {
        Stmt::For(node) => node.iter.end(),
        Stmt::While(node) => node.test.end(),
        Stmt::If(node) => node.test.end(),
        Stmt::With(node) => {
            node.items.last().map_or(node.start(), |item| item.optional_vars.as_deref().unwrap_or(&item.context_expr).end())
        }
        Stmt::Match(node) => node.subject.end(),
        Stmt::Try(node) => node.start() + TextSize::of("try"),
        _ => stmt.end(),
    };
    TextRange::new(stmt.start(), end.max(stmt.start()))
}

impl<'a> Compiler<'a> {
    pub(super) fn module(&mut self, module: &'a ast::ModModule) -> Compiled {
        if has_annotations(&module.body) {
            let slot = self.global("__annotations__");
            self.emit(Op::BuildDict(0), module.range);
            self.emit(Op::StoreGlobal(slot), module.range);
        }
        self.unit.doc = super::function::docstring(&module.body);
        for (i, stmt) in module.body.iter().enumerate() {
            let start = self.unit.emitter.here();
            self.unit.emitter.entry();
            self.unit.emitter.mark(header(stmt));
            self.emit(Op::Statement(super::narrow(i)), stmt.range());
            if let Some(doc) = self.unit.doc.clone().filter(|_| i == 0) {
                let slot = self.global("__doc__");
                self.constant(Const::Str(doc), stmt.range());
                self.emit(Op::StoreGlobal(slot), stmt.range());
            }
            self.statement(stmt)?;
            let end = self.unit.emitter.here();
            self.statements.push(TopStatement { start, end, range: stmt.range() });
        }
        self.unit.emitter.entry();
        let end = TextRange::empty(module.range.end());
        self.constant(Const::None, end);
        self.emit(Op::Return, end);
        Ok(())
    }

    pub(super) fn body(&mut self, body: &'a [Stmt]) -> Compiled {
        for stmt in body {
            if self.unit.emitter.is_dead() {
                break;
            }
            self.unit.emitter.mark(header(stmt));
            self.statement(stmt)?;
        }
        Ok(())
    }

    fn statement(&mut self, stmt: &'a Stmt) -> Compiled {
        self.check_length(stmt.range())?;
        let before = self.unit.emitter.depth();
        stacker::maybe_grow(RED_ZONE, STACK_PIECE, || self.plain_statement(stmt))?;
        debug_assert_eq!(self.unit.emitter.depth(), before, "a statement leaves the stack as it was");
        Ok(())
    }

    fn plain_statement(&mut self, stmt: &'a Stmt) -> Compiled {
        let range = stmt.range();
        match stmt {
            Stmt::FunctionDef(node) => self.function(node),
            Stmt::ClassDef(node) => self.class(node),
            Stmt::Return(node) => {
                self.in_function(range, "'return' outside function")?;
                match &node.value {
                    Some(value) => self.expr(value)?,
                    None => self.constant(Const::None, range),
                }
                let depth = self.unit.emitter.depth();
                self.leave_function(range)?;
                self.unit.emitter.set_depth(depth.saturating_sub(1));
                Ok(())
            }
            Stmt::Delete(node) => node.targets.iter().try_for_each(|target| self.delete(target)),
            Stmt::Assign(node) => self.assign(node),
            Stmt::AugAssign(node) => self.augmented(node),
            Stmt::AnnAssign(node) => self.annotated(node),
            Stmt::For(node) if node.is_async => error(range, "'async for' is not part of PSDL"),
            Stmt::For(node) => self.for_statement(node, header(stmt)),
            Stmt::While(node) => self.while_statement(node, header(stmt)),
            Stmt::If(node) => self.if_statement(node),
            Stmt::With(node) if node.is_async => error(range, "'async with' is not part of PSDL"),
            Stmt::With(node) => self.with_statement(node, header(stmt)),
            Stmt::Match(node) => self.match_statement(node),
            Stmt::Raise(node) => {
                let mut count = 0;
                for value in [&node.exc, &node.cause].into_iter().flatten() {
                    self.expr(value)?;
                    count += 1;
                }
                self.emit(Op::Raise(count), range);
                Ok(())
            }
            Stmt::Try(node) => self.try_statement(node, header(stmt)),
            Stmt::Assert(node) => self.assert_statement(node),
            Stmt::Import(node) => self.import(node),
            Stmt::ImportFrom(node) => self.import_from(node),
            Stmt::Expr(node) => self.expression_statement(&node.value),
            Stmt::Break(_) => self.leave_loop(true, range),
            Stmt::Continue(_) => self.leave_loop(false, range),
            Stmt::Global(_) | Stmt::Nonlocal(_) | Stmt::Pass(_) => Ok(()),
            Stmt::TypeAlias(node) => {
                if let Some(parameters) = &node.type_params {
                    return error(parameters.range, "type parameters are not part of PSDL");
                }
                self.expr(&node.value)?;
                self.store(&node.name)
            }
            Stmt::IpyEscapeCommand(_) => error(range, "shell commands are not part of PSDL"),
        }
    }

    fn expression_statement(&mut self, value: &'a Expr) -> Compiled {
        if value.is_literal_expr() {
            return Ok(());
        }
        self.expr(value)?;
        self.emit(Op::Pop, value.range());
        Ok(())
    }

    fn if_statement(&mut self, node: &'a ast::StmtIf) -> Compiled {
        let end = self.label();
        let mut next = self.label();
        self.jump_if(&node.test, false, next)?;
        self.body(&node.body)?;
        for clause in &node.elif_else_clauses {
            self.jump(Op::Jump, end, clause.range);
            self.bind(next);
            next = self.label();
            if let Some(test) = &clause.test {
                self.unit.emitter.mark(TextRange::new(clause.start(), test.end()));
                self.jump_if(test, false, next)?;
            }
            self.body(&clause.body)?;
        }
        self.bind(next);
        self.bind(end);
        Ok(())
    }

    fn assert_statement(&mut self, node: &'a ast::StmtAssert) -> Compiled {
        let end = self.label();
        self.jump_if(&node.test, true, end)?;
        self.emit(Op::AssertionError, node.range);
        if let Some(message) = &node.msg {
            self.expr(message)?;
            self.emit(Op::Call(1), node.range);
        }
        self.emit(Op::Raise(1), node.range);
        self.bind(end);
        Ok(())
    }
}
