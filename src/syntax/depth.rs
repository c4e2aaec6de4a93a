//! How deep a tree nests, measured without going deeper than the limit.

use ruff_python_ast::visitor::{Visitor, walk_expr, walk_pattern, walk_stmt};
use ruff_python_ast::{Expr, Pattern, Stmt};
use ruff_text_size::{Ranged, TextRange};

/// Walks one statement; stops descending at the limit.
struct Depth {
    now: usize,
    limit: usize,
    deepest: usize,
    beyond: Option<TextRange>,
}

impl Depth {
    fn step(&mut self, range: TextRange) -> bool {
        self.deepest = self.deepest.max(self.now + 1);
        if self.now >= self.limit {
            self.beyond.get_or_insert(range);
        }
        self.beyond.is_none()
    }
}

impl<'a> Visitor<'a> for Depth {
    fn visit_stmt(&mut self, stmt: &'a Stmt) {
        if self.step(stmt.range()) {
            self.now += 1;
            walk_stmt(self, stmt);
            self.now -= 1;
        }
    }
    fn visit_expr(&mut self, expr: &'a Expr) {
        if self.step(expr.range()) {
            self.now += 1;
            walk_expr(self, expr);
            self.now -= 1;
        }
    }
    fn visit_pattern(&mut self, pattern: &'a Pattern) {
        if self.step(pattern.range()) {
            self.now += 1;
            walk_pattern(self, pattern);
            self.now -= 1;
        }
    }
}

/// How many statements, expressions and patterns stand inside each other at most; or, where that is
/// more than the limit, the range of the first that is too deep.
pub(super) fn measure(stmt: &Stmt, limit: usize) -> Result<usize, TextRange> {
    let mut depth = Depth { now: 0, limit, deepest: 0, beyond: None };
    depth.visit_stmt(stmt);
    depth.beyond.map_or(Ok(depth.deepest), Err)
}
