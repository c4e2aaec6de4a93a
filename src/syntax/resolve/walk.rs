//! The walk itself: each node to what it means for names.

use ruff_python_ast::name::Name;
use ruff_python_ast::visitor::{Visitor, walk_expr, walk_interpolated_string_element, walk_pattern, walk_stmt};
use ruff_python_ast::{self as ast, Expr, ExprContext, Pattern, Stmt};
use ruff_text_size::Ranged;

use super::{MAX_INT_DIGITS, Resolver, Uses};
use crate::syntax::scope::{Role, ScopeId, ScopeKind};

impl<'a> Visitor<'a> for Resolver<'a> {
    fn visit_stmt(&mut self, stmt: &'a Stmt) {
        if self.is_checkable(stmt) {
            self.checker.visit_stmt(stmt, &self.checks);
        }
        self.stars(stmt);
        self.jumps(stmt);
        match stmt {
            Stmt::FunctionDef(node) => self.function(node),
            Stmt::ClassDef(node) => self.class(node),
            Stmt::Global(node) => self.declare(&node.names, Uses::GLOBAL, "global"),
            Stmt::Nonlocal(node) if self.current == ScopeId::MODULE => {
                self.report(node.range, "nonlocal declaration not allowed at module level".to_string());
            }
            Stmt::Nonlocal(node) => self.declare(&node.names, Uses::NONLOCAL, "nonlocal"),
            Stmt::For(node) => {
                if node.is_async {
                    self.left_out(Self::keyword(node.range, "async"), "'async for' is");
                }
                self.visit_expr(&node.iter);
                self.visit_expr(&node.target);
                self.looped(&node.body, &node.orelse);
            }
            Stmt::While(node) => {
                self.visit_expr(&node.test);
                self.looped(&node.body, &node.orelse);
            }
            Stmt::With(node) => {
                if node.is_async {
                    self.left_out(Self::keyword(node.range, "async"), "'async with' is");
                }
                walk_stmt(self, stmt);
            }
            Stmt::Try(node) => self.attempt(node),
            Stmt::AnnAssign(node) => self.annotated(node),
            Stmt::Import(node) => {
                if node.is_lazy {
                    self.left_out(Self::keyword(node.range, "lazy"), "'lazy' imports are");
                }
                self.import(&node.names, false);
            }
            Stmt::ImportFrom(node) => {
                if node.is_lazy {
                    self.left_out(Self::keyword(node.range, "lazy"), "'lazy' imports are");
                }
                if node.level == 0 && node.module.as_deref() == Some("__future__") {
                    self.left_out(node.range, "'from __future__ import' is");
                }
                self.import(&node.names, true);
            }
            Stmt::TypeAlias(node) => {
                self.bind_type_params(node.type_params.as_deref());
                self.visit_expr(&node.value);
                self.visit_expr(&node.name);
            }
            _ => walk_stmt(self, stmt),
        }
    }

    fn visit_expr(&mut self, expr: &'a Expr) {
        self.checker.visit_expr(expr, &self.checks);
        match expr {
            Expr::Name(node) => {
                let (role, uses) = match node.ctx {
                    ExprContext::Store => (Role::Bind, Uses::BOUND),
                    ExprContext::Del => (Role::Delete, Uses::BOUND),
                    ExprContext::Load | ExprContext::Invalid => (Role::Load, Uses::READ),
                };
                self.note(&node.id, node.range, role, uses);
                if role == Role::Load && node.id == "super" && self.checks.place.kind.is_function_like() {
                    let class = self.intern(&Name::new_static("__class__"));
                    let scope = self.current;
                    self.entry(scope, class).uses.add(Uses::IMPLICIT);
                }
            }
            Expr::Lambda(node) => self.lambda(node),
            Expr::ListComp(node) => self.comprehension(ScopeKind::ListComp, node.range, &node.generators, [Some(&node.elt), None]),
            Expr::SetComp(node) => self.comprehension(ScopeKind::SetComp, node.range, &node.generators, [Some(&node.elt), None]),
            Expr::DictComp(node) => {
                self.comprehension(ScopeKind::DictComp, node.range, &node.generators, [node.key.as_deref(), Some(&node.value)]);
            }
            Expr::Generator(node) => self.comprehension(ScopeKind::Generator, node.range, &node.generators, [Some(&node.elt), None]),
            Expr::Named(node) => self.walrus(node),
            Expr::Yield(node) => {
                self.yields(node.range);
                walk_expr(self, expr);
            }
            Expr::YieldFrom(node) => {
                self.yields(node.range);
                walk_expr(self, expr);
            }
            Expr::Await(node) => {
                self.left_out(Self::keyword(node.range, "await"), "'await' is");
                walk_expr(self, expr);
            }
            Expr::TString(node) => {
                self.left_out(node.range, "template strings (t\"…\") are");
                walk_expr(self, expr);
            }
            Expr::NumberLiteral(node) if node.range.len().to_usize() > MAX_INT_DIGITS => self.integer(node.range),
            _ => walk_expr(self, expr),
        }
    }

    fn visit_interpolated_string_element(&mut self, element: &'a ast::InterpolatedStringElement) {
        if let ast::InterpolatedStringElement::Interpolation(field) = element
            && field.expression.is_starred_expr()
        {
            self.report(field.expression.range(), "f-string: cannot use starred expression here".to_string());
        }
        walk_interpolated_string_element(self, element);
    }

    fn visit_pattern(&mut self, pattern: &'a Pattern) {
        if let Pattern::MatchValue(node) = pattern
            && matches!(node.value.as_ref(), Expr::FString(_) | Expr::TString(_))
        {
            self.report(node.range, "patterns may only match literals and attribute lookups".to_string());
        }
        walk_pattern(self, pattern);
        let name = match pattern {
            Pattern::MatchStar(node) => &node.name,
            Pattern::MatchAs(node) => &node.name,
            Pattern::MatchMapping(node) => &node.rest,
            _ => &None,
        };
        if let Some(name) = name {
            self.bind(name);
        }
    }
}
