//! A coordinate that stands as a number is taken from the object that it touches.

use super::{Ground, Refactoring, RefactoringKind};
use crate::scene::{Axis, Body, Layout, Source};
use crate::syntax::ast::statement_visitor::{StatementVisitor, walk_stmt};
use crate::syntax::ast::{Expr, Number, Ranged as _, Stmt, UnaryOp};
use ruff_text_size::TextRange;

/// What is further away is no neighbour. Metres.
const NEAR: f64 = 1.0;
/// Boxes that come so close meet. Metres.
const TOUCH: f64 = 0.01;
/// So many ways are tried by a run.
const TRIED: usize = 8;

/// The ways to write the coordinate that the statement at a place sets, the most direct first.
pub(super) fn relative(ground: &Ground, range: TextRange) -> Vec<Refactoring> {
    let parsed = ground.problem.parsed();
    let mut finder = Finder { range, found: None };
    parsed.with_stack(|| finder.visit_body(&parsed.module.body));
    let Some((statement, target, value)) = finder.found.and_then(assignment) else { return Vec::new() };
    let layout = ground.problem.layout();
    let Some((object, axis, coordinate)) = anchored(layout, statement) else { return Vec::new() };
    let mut found: Vec<(f64, String, String)> = Vec::new();
    let mut add = |name: &str, min: f64, center: f64, max: f64| {
        for (edge, at) in [("max", max), ("min", min), ("center", center)] {
            let offset = ((coordinate - at) * 1e9).round() / 1e9;
            if offset.abs() <= NEAR && (edge != "center" || offset == 0.0) {
                let from = format!("{name}.{edge}.{target}");
                let text = match offset {
                    0.0 => from,
                    _ if offset > 0.0 => format!("{from} + {offset:?}"),
                    _ => format!("{from} - {:?}", -offset),
                };
                found.push((offset.abs(), name.to_string(), text));
            }
        }
    };
    let own = &layout.objects[object].body;
    let k = axis.index();
    for (index, other) in layout.objects.iter().enumerate() {
        if index != object && other.body.is_placed() && beside(own, &other.body, k) {
            add(&other.path, other.body.min[k], other.body.center[k], other.body.max[k]);
        }
    }
    let [width, depth, height] = layout.scene.size();
    match axis {
        Axis::X => add("scene", -0.5 * width, 0.0, 0.5 * width),
        Axis::Y => add("scene", -0.5 * depth, 0.0, 0.5 * depth),
        Axis::Z => add("scene", 0.0, 0.5 * height, height),
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let rewriting = |(_, name, text): (f64, String, String)| Refactoring {
        title: format!("Take the coordinate from {name}: {text}"),
        kind: RefactoringKind::Relative,
        edits: vec![(value, text)],
        sidecar: None,
    };
    found.into_iter().take(TRIED).map(rewriting).collect()
}

/// Whether boxes meet along the other axes.
fn beside(a: &Body, b: &Body, k: usize) -> bool {
    (0..3).filter(|other| *other != k).all(|other| a.min[other] <= b.max[other] + TOUCH && b.min[other] <= a.max[other] + TOUCH)
}

/// The object and the axis that one statement anchored; `None` where it anchored none or several.
fn anchored(layout: &Layout, statement: TextRange) -> Option<(usize, Axis, f64)> {
    let all = layout.objects.iter().enumerate().flat_map(|(index, object)| object.anchors.iter().map(move |anchor| (index, anchor)));
    let mut here = all.filter(|(_, anchor)| {
        let origin = layout.origins.get(anchor.origin);
        origin.source == Source::Program && origin.range == statement
    });
    let (index, anchor) = here.next()?;
    here.next().is_none().then(|| (index, anchor.axis, anchor.value.value()))
}

/// An assignment of a number to a coordinate: its range, the name of the axis, the place of the number.
fn assignment(stmt: &Stmt) -> Option<(TextRange, &str, TextRange)> {
    let Stmt::Assign(node) = stmt else { return None };
    let [Expr::Attribute(target)] = node.targets.as_slice() else { return None };
    let axis = Some(target.attr.id.as_str()).filter(|name| matches!(*name, "x" | "y" | "z"))?;
    let part = matches!(&*target.value, Expr::Attribute(part) if matches!(part.attr.id.as_str(), "min" | "max" | "center"));
    (part && is_number(&node.value)).then(|| (node.range, axis, node.value.range()))
}

fn is_number(expr: &Expr) -> bool {
    match expr {
        Expr::NumberLiteral(node) => !matches!(node.value, Number::Complex { .. }),
        Expr::UnaryOp(node) => matches!(node.op, UnaryOp::USub | UnaryOp::UAdd) && is_number(&node.operand),
        _ => false,
    }
}

/// The innermost statement around a place.
struct Finder<'a> {
    range: TextRange,
    found: Option<&'a Stmt>,
}

impl<'a> StatementVisitor<'a> for Finder<'a> {
    fn visit_stmt(&mut self, stmt: &'a Stmt) {
        if stmt.range().contains_range(self.range) {
            self.found = Some(stmt);
            walk_stmt(self, stmt);
        }
    }
}
