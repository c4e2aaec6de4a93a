//! Remarks about constants: floats that move nothing, integers that could have been floats.

use super::run::{Execution, Prepared};
use crate::check::finding::{Code, Finding, Fix, Place};
use crate::syntax::ast::{self, Expr, Ranged as _, Stmt, StmtAssign, StmtAugAssign};
use crate::syntax::{Parsed, Tuning};
use crate::trace::{Guard, Handle, Node, Num, Trace};
use ruff_text_size::TextRange;
use std::cell::RefCell;

/// The remarks about a run that came to its end.
pub(super) fn findings(prepared: &Prepared, run: &Execution, text: &str) -> Vec<Finding> {
    let mut findings = unused(&prepared.tuning, run, text);
    findings.extend(prepared.parsed.with_stack(|| integers(&prepared.parsed, text)));
    findings
}

/// Constants whose value reaches no box and no decision.
fn unused(tuning: &Tuning, run: &Execution, text: &str) -> Vec<Finding> {
    if !run.trace.is_on() || run.trace.is_full() {
        return Vec::new();
    }
    let used = used_literals(run, tuning.constants.len());
    let constants = tuning.constants.iter().zip(used).filter(|(constant, used)| constant.excluded.is_none() && !used);
    let message = |range: TextRange| format!("{} moves no object", &text[range]);
    constants.map(|(constant, _)| Finding::new(Code::UnusedConstant, Place::program(constant.range), message(constant.range))).collect()
}

/// By constant, whether a box, a size or a decision of the run rests on it.
fn used_literals(run: &Execution, count: usize) -> Vec<bool> {
    let trace = &run.trace;
    let nodes = trace.nodes();
    let mut reached = vec![false; nodes.len()];
    let reach = |reached: &mut Vec<bool>, handle: Handle| {
        if let Some(slot) = (handle.0 as usize).checked_sub(1).and_then(|at| reached.get_mut(at)) {
            *slot = true;
        }
    };
    for object in &run.layout.objects {
        let anchors = object.anchors.iter().map(|anchor| anchor.value.num.handle);
        anchors.chain(object.handles()).chain([object.settled.handle]).for_each(|handle| reach(&mut reached, handle));
    }
    for guard in trace.guards() {
        match guard {
            Guard::Equals(a) | Guard::Zero(a, _) | Guard::Finite(a, _) => reach(&mut reached, a.handle),
            Guard::Order(a, b, _) => [a, b].into_iter().for_each(|num| reach(&mut reached, num.handle)),
        }
    }
    trace.stone().iter().for_each(|handle| reach(&mut reached, *handle));
    let asked = RefCell::new(Vec::new());
    for decision in trace.decisions() {
        let _ = decision.holds(&|num: Num| {
            asked.borrow_mut().push(num.handle);
            num.value
        });
    }
    asked.into_inner().into_iter().for_each(|handle| reach(&mut reached, handle));
    let mut used = vec![false; count];
    // An operation comes after its operands.
    for at in (0..nodes.len()).rev().filter(|at| reached[*at]).collect::<Vec<usize>>() {
        mark(trace, at, &mut reached, &mut used);
    }
    used
}

/// Marks what a reached number was made of, down to the literals.
fn mark(trace: &Trace, at: usize, reached: &mut [bool], used: &mut [bool]) {
    let nodes = trace.nodes();
    let mut todo = vec![at];
    while let Some(at) = todo.pop() {
        if let Node::Literal(id, _) = nodes[at]
            && let Some(slot) = used.get_mut(id as usize)
        {
            *slot = true;
        }
        trace.operands(&nodes[at], &mut |operand| {
            let Some(below) = (operand.handle.0 as usize).checked_sub(1) else { return };
            if matches!(nodes.get(below), Some(Node::Literal(..))) || !std::mem::replace(&mut reached[below], true) {
                todo.push(below);
            }
        });
    }
}

/// Integers that are a whole term of a coordinate: `o.min.x = scene.min.x + 2`.
fn integers(parsed: &Parsed, text: &str) -> Vec<Finding> {
    let mut finder = Integers { text, findings: Vec::new() };
    ast::visitor::Visitor::visit_body(&mut finder, &parsed.module.body);
    finder.findings
}

struct Integers<'a> {
    text: &'a str,
    findings: Vec<Finding>,
}

impl<'a> ast::visitor::Visitor<'a> for Integers<'a> {
    fn visit_stmt(&mut self, stmt: &'a Stmt) {
        match stmt {
            Stmt::Assign(StmtAssign { targets, value, .. }) if targets.iter().any(is_coordinate) => self.terms(value),
            Stmt::AugAssign(StmtAugAssign { target, value, op: ast::Operator::Add | ast::Operator::Sub, .. }) if is_coordinate(target) => {
                self.terms(value);
            }
            _ => ast::visitor::walk_stmt(self, stmt),
        }
    }
}

impl Integers<'_> {
    /// The integers that are added or subtracted here, but for zero.
    fn terms(&mut self, value: &Expr) {
        match value {
            Expr::BinOp(ast::ExprBinOp { left, right, op: ast::Operator::Add | ast::Operator::Sub, .. }) => {
                self.terms(left);
                self.terms(right);
            }
            Expr::UnaryOp(ast::ExprUnaryOp { operand, op: ast::UnaryOp::USub | ast::UnaryOp::UAdd, .. }) => self.terms(operand),
            Expr::If(ast::ExprIf { body, orelse, .. }) => {
                self.terms(body);
                self.terms(orelse);
            }
            Expr::NumberLiteral(ast::ExprNumberLiteral { value: ast::Number::Int(int), .. }) if *int != ast::Int::ZERO => {
                let range = value.range();
                let literal = &self.text[range];
                let mut finding =
                    Finding::new(Code::IntegerConstant, Place::program(range), format!("the integer {literal} cannot be tuned"));
                if literal.bytes().all(|byte| byte.is_ascii_digit() || byte == b'_') {
                    finding.fix = Some(Fix { title: format!("write {literal}.0"), edits: vec![(range, format!("{literal}.0"))] });
                }
                self.findings.push(finding);
            }
            _ => {}
        }
    }
}

/// `o.min.x`, `o.center.y`, `o.max.z`
fn is_coordinate(target: &Expr) -> bool {
    let Expr::Attribute(axis) = target else { return false };
    let Expr::Attribute(anchor) = axis.value.as_ref() else { return false };
    matches!(axis.attr.as_str(), "x" | "y" | "z") && matches!(anchor.attr.as_str(), "min" | "center" | "max")
}
