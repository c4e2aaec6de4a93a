//! The walk that finds constants and directions.

use ruff_python_ast::visitor::{Visitor, walk_expr, walk_stmt};
use ruff_python_ast::{self as ast, Expr, ExprContext, Number, Operator, Stmt, UnaryOp};
use ruff_text_size::{Ranged, TextRange};

use super::{Cardinal, Constant, Direction, DirectionKind, Excluded, Integer, Spelling, Tuning, is_word, key, neighbours};
use crate::syntax::parse::Parsed;
use crate::syntax::scope::Role;

/// The calls whose arguments are never rewritten.
const TEMPLATE: [&str; 7] = ["Object", "Door", "Window", "set_size", "set_title", "set_floor_asset", "set_wall_asset"];

struct Finder<'a> {
    program: &'a str,
    tuning: Tuning,
    in_template: bool,
    /// Names of directions, and `Facing`, that the program uses for something of its own.
    rebound: Vec<&'a str>,
    /// How often each spelling occurs.
    spelled: [u32; 5],
}

pub(super) fn find(parsed: &Parsed, program: &str) -> Tuning {
    let scopes = &parsed.scopes;
    let is_ours = |name: &str| name == "Facing" || Cardinal::from_name(name).is_some();
    let bound = scopes.occurrences().iter().filter(|occurrence| occurrence.role == Role::Bind);
    let rebound = bound.map(|occurrence| scopes.name(occurrence.name).as_str()).filter(|name| is_ours(name)).collect();
    let mut finder = Finder { program, tuning: Tuning::default(), in_template: false, rebound, spelled: [0; 5] };
    finder.visit_body(&parsed.module.body);
    finder.finish()
}

impl<'a> Finder<'a> {
    fn finish(mut self) -> Tuning {
        let tuning = &mut self.tuning;
        tuning.constants.sort_unstable_by_key(|constant| key(constant.range));
        tuning.directions.sort_unstable_by_key(|direction| key(direction.range));
        tuning.directions.dedup_by_key(|direction| direction.range);
        let mut integers = std::mem::take(&mut tuning.integers);
        integers.sort_unstable_by_key(|integer| key(integer.range));
        integers.retain(|integer| tuning.direction_at(integer.range).is_none());
        tuning.integers = integers;
        self.tuning.spelling = self.spelling();
        self.tuning
    }

    /// The most frequent spelling among those whose names still mean what PSDL means.
    fn spelling(&self) -> Spelling {
        let all = [Spelling::Max, Spelling::Pos, Spelling::FacingMax, Spelling::FacingPos, Spelling::Number];
        let usable = |spelling: &Spelling| {
            Cardinal::ALL.iter().all(|cardinal| {
                let text = spelling.spell(*cardinal);
                !self.rebound.contains(&text.split('.').next().unwrap_or(text))
            })
        };
        let best = all.into_iter().filter(usable).max_by_key(|spelling| (self.spelled[*spelling as usize], std::cmp::Reverse(*spelling)));
        best.unwrap_or(Spelling::Number)
    }

    fn number(&mut self, node: &ast::ExprNumberLiteral, sign: Option<(TextRange, f64)>, tight: bool) {
        let (range, sign) = sign.unwrap_or((node.range, 1.0));
        let (before, after) = neighbours(self.program, range);
        match node.value {
            Number::Float(value) => {
                let text = self.program.get(node.range.start().to_usize()..node.range.end().to_usize()).unwrap_or_default();
                let excluded = match () {
                    () if self.in_template => Some(Excluded::Template),
                    () if text.starts_with("3.14") => Some(Excluded::Pi),
                    () if value.is_infinite() => Some(Excluded::Infinite),
                    () => None,
                };
                let needs_parens = tight && !after.trim_start().starts_with(')');
                self.tuning.constants.push(Constant {
                    range,
                    value: sign * value,
                    needs_parens,
                    glued: before.ends_with(is_word),
                    excluded,
                });
            }
            Number::Int(_) => self.tuning.integers.push(Integer { range, in_template: self.in_template }),
            Number::Complex { .. } => {}
        }
    }

    /// An operand that binds tighter than a sign: what is a bare number there needs parentheses when negative.
    fn tight(&mut self, expr: &'a Expr) {
        match expr {
            Expr::NumberLiteral(node) => self.number(node, None, true),
            _ => self.visit_expr(expr),
        }
    }

    fn signed(&mut self, node: &'a ast::ExprUnaryOp) {
        if let (Expr::NumberLiteral(number), UnaryOp::USub | UnaryOp::UAdd) = (node.operand.as_ref(), node.op) {
            let between = self.program.get(node.range.start().to_usize() + 1..number.range.start().to_usize()).unwrap_or_default();
            if !between.contains('(') {
                let sign = if node.op == UnaryOp::USub { -1.0 } else { 1.0 };
                self.number(number, Some((node.range, sign)), false);
                return;
            }
        }
        self.visit_expr(&node.operand);
    }

    fn direction(&mut self, range: TextRange, kind: DirectionKind, spelling: Option<Spelling>) {
        if self.in_template {
            return;
        }
        if let Some(spelling) = spelling {
            self.spelled[spelling as usize] += 1;
        }
        let glued = neighbours(self.program, range).1.starts_with(is_word);
        self.tuning.directions.push(Direction { range, kind, glued });
    }

    /// A name of a cardinal, or a member of `Facing`, with its spelling (none for the names of walls).
    fn named(&self, expr: &Expr) -> Option<(Cardinal, Option<Spelling>)> {
        let (name, [max, pos]) = match expr {
            Expr::Name(node) if node.ctx == ExprContext::Load && !self.rebound.contains(&node.id.as_str()) => {
                (node.id.as_str(), [Spelling::Max, Spelling::Pos])
            }
            Expr::Attribute(node) => match node.value.as_ref() {
                Expr::Name(class) if class.id == "Facing" && !self.rebound.contains(&"Facing") && !node.attr.id.ends_with("WALL") => {
                    (node.attr.id.as_str(), [Spelling::FacingMax, Spelling::FacingPos])
                }
                _ => return None,
            },
            _ => return None,
        };
        let spelling = match name.get(2..) {
            Some("MAX" | "MIN") => Some(max),
            Some("POS" | "NEG") => Some(pos),
            _ => None,
        };
        Some((Cardinal::from_name(name)?, spelling))
    }

    /// Whether the expression is a literal for a cardinal where a direction is expected.
    fn is_literal(&self, expr: &Expr) -> bool {
        small_int(expr).is_some() || self.named(expr).is_some()
    }

    /// An expression whose value is used as a direction: the integers that can be that value are
    /// directions. Names of cardinals are found wherever they stand.
    fn expected(&mut self, expr: &Expr) {
        if let Some(cardinal) = small_int(expr) {
            self.direction(expr.range(), DirectionKind::Literal(cardinal), Some(Spelling::Number));
            return;
        }
        match expr {
            Expr::If(node) => {
                self.expected(&node.body);
                self.expected(&node.orelse);
            }
            Expr::Subscript(node) => self.expected_inside(&node.value),
            _ => {}
        }
    }

    /// A collection of directions.
    fn expected_inside(&mut self, expr: &Expr) {
        match expr {
            Expr::List(node) => node.elts.iter().for_each(|element| self.expected(element)),
            Expr::Tuple(node) => node.elts.iter().for_each(|element| self.expected(element)),
            Expr::Dict(node) => node.items.iter().for_each(|item| self.expected(&item.value)),
            _ => {}
        }
    }

    fn assigned(&mut self, target: &Expr, value: &Expr) {
        match (target, value) {
            (Expr::Tuple(ast::ExprTuple { elts: targets, .. }), Expr::Tuple(ast::ExprTuple { elts: values, .. }))
                if targets.len() == values.len() =>
            {
                for (target, value) in targets.iter().zip(values) {
                    self.assigned(target, value);
                }
            }
            (Expr::Attribute(node), _) if node.attr.id == "facing" => {
                if !self.is_literal(value) {
                    self.direction(value.range(), DirectionKind::Rhs, None);
                }
                self.expected(value);
            }
            (Expr::Name(node), _) if node.id.ends_with("facing") => self.expected(value),
            (Expr::Name(node), _) if node.id.ends_with("facings") => self.expected_inside(value),
            _ => {}
        }
    }
}

/// What is called `facing` or `direction` takes a direction.
fn names_direction(name: &str) -> bool {
    matches!(name, "facing" | "direction")
}

fn small_int(expr: &Expr) -> Option<Cardinal> {
    match expr {
        Expr::NumberLiteral(node) => match &node.value {
            Number::Int(int) => Cardinal::ALL.get(int.as_usize()?).copied(),
            _ => None,
        },
        _ => None,
    }
}

impl<'a> Visitor<'a> for Finder<'a> {
    fn visit_stmt(&mut self, stmt: &'a Stmt) {
        match stmt {
            Stmt::Assign(node) => node.targets.iter().for_each(|target| self.assigned(target, &node.value)),
            Stmt::AnnAssign(ast::StmtAnnAssign { target, value: Some(value), .. }) => self.assigned(target, value),
            _ => {}
        }
        walk_stmt(self, stmt);
    }

    fn visit_parameters(&mut self, parameters: &'a ast::Parameters) {
        for parameter in parameters.iter_non_variadic_params() {
            if let Some(default) = parameter.default.as_deref().filter(|_| names_direction(&parameter.parameter.name.id)) {
                self.expected(default);
            }
        }
        ast::visitor::walk_parameters(self, parameters);
    }

    fn visit_keyword(&mut self, keyword: &'a ast::Keyword) {
        if keyword.arg.as_ref().is_some_and(|name| names_direction(&name.id)) {
            self.expected(&keyword.value);
        }
        self.visit_expr(&keyword.value);
    }

    fn visit_expr(&mut self, expr: &'a Expr) {
        if let Some((cardinal, spelling)) = self.named(expr) {
            self.direction(expr.range(), DirectionKind::Literal(cardinal), spelling);
            return;
        }
        match expr {
            Expr::NumberLiteral(node) => self.number(node, None, false),
            Expr::UnaryOp(node) => self.signed(node),
            Expr::BinOp(node) if node.op == Operator::Pow => {
                self.tight(&node.left);
                self.visit_expr(&node.right);
            }
            Expr::Attribute(node) => self.tight(&node.value),
            Expr::Subscript(node) => {
                self.tight(&node.value);
                self.visit_expr(&node.slice);
            }
            Expr::Call(node) => {
                self.tight(&node.func);
                let outer = self.in_template;
                if let Expr::Name(function) = node.func.as_ref() {
                    self.in_template |= TEMPLATE.contains(&function.id.as_str());
                    if function.id == "opposite" {
                        node.arguments.args.iter().for_each(|argument| self.expected(argument));
                    }
                }
                self.visit_arguments(&node.arguments);
                self.in_template = outer;
            }
            Expr::Dict(node) => {
                for item in &node.items {
                    let key = item.key.as_ref().and_then(Expr::as_string_literal_expr);
                    if key.is_some_and(|key| names_direction(key.value.to_str())) {
                        self.expected(&item.value);
                    }
                }
                walk_expr(self, expr);
            }
            _ => walk_expr(self, expr),
        }
    }
}
