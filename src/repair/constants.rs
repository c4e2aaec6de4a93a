//! The tunable constants of a program as people see them: what they are called, what they move, and where no errors are.

use ruff_text_size::{Ranged as _, TextRange};
use rustc_hash::FxHashMap;

use crate::syntax::ast::visitor::{self, Visitor};
use crate::syntax::ast::{self, Expr, Stmt};
use crate::syntax::{ConstantId, Parsed};

use super::problem::Problem;

/// What the constants of a program are called: the variable, parameter, keyword or key that one is given to as it is.
#[derive(Clone, Debug, Default)]
pub struct Names(FxHashMap<TextRange, String>);

impl Names {
    /// Reads the names off the text.
    pub fn of(parsed: &Parsed) -> Names {
        let mut finder = Finder(FxHashMap::default());
        parsed.with_stack(|| finder.visit_body(&parsed.module.body));
        Names(finder.0)
    }

    /// The name of a constant.
    pub fn get(&self, problem: &Problem, id: ConstantId) -> Option<&str> {
        self.0.get(&problem.tuning().constant(id)?.range).map(String::as_str)
    }
}

struct Finder(FxHashMap<TextRange, String>);

impl Finder {
    /// A value that is given to something; only numbers matter later.
    fn given(&mut self, name: &str, value: &Expr) {
        if matches!(value, Expr::NumberLiteral(_) | Expr::UnaryOp(_)) {
            self.0.insert(value.range(), name.to_string());
        }
    }

    fn assigned(&mut self, target: &Expr, value: &Expr) {
        match (target, value) {
            (Expr::Name(name), _) => self.given(&name.id, value),
            (Expr::Tuple(ast::ExprTuple { elts: targets, .. }), Expr::Tuple(ast::ExprTuple { elts: values, .. }))
                if targets.len() == values.len() =>
            {
                targets.iter().zip(values).for_each(|(target, value)| self.assigned(target, value));
            }
            _ => {}
        }
    }
}

impl<'a> Visitor<'a> for Finder {
    fn visit_stmt(&mut self, stmt: &'a Stmt) {
        match stmt {
            Stmt::Assign(node) => node.targets.iter().for_each(|target| self.assigned(target, &node.value)),
            Stmt::AnnAssign(ast::StmtAnnAssign { target, value: Some(value), .. }) => self.assigned(target, value),
            _ => {}
        }
        visitor::walk_stmt(self, stmt);
    }

    fn visit_parameters(&mut self, parameters: &'a ast::Parameters) {
        for parameter in parameters.iter_non_variadic_params() {
            if let Some(default) = parameter.default.as_deref() {
                self.given(&parameter.parameter.name.id, default);
            }
        }
        visitor::walk_parameters(self, parameters);
    }

    fn visit_keyword(&mut self, keyword: &'a ast::Keyword) {
        if let Some(name) = &keyword.arg {
            self.given(&name.id, &keyword.value);
        }
        visitor::walk_keyword(self, keyword);
    }

    fn visit_expr(&mut self, expr: &'a Expr) {
        match expr {
            Expr::Named(node) => self.assigned(&node.target, &node.value),
            Expr::Dict(node) => {
                for item in &node.items {
                    if let Some(key) = item.key.as_ref().and_then(Expr::as_string_literal_expr) {
                        let key = key.value.to_str();
                        if key.len() <= 40 && key.chars().all(|c| c == '_' || c.is_alphanumeric()) {
                            self.given(key, &item.value);
                        }
                    }
                }
            }
            _ => {}
        }
        visitor::walk_expr(self, expr);
    }
}
