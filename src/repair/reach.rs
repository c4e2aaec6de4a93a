//! Moving and turning an object by hand: the edits of the program that put it where it is wanted, each tried by a run of the text.
//!
//! Constants come first. Where none moves an object as it is wanted, the statement that placed it gets an offset, and an object that
//! was never told where to face gets a statement that does.

use std::sync::atomic::{AtomicBool, Ordering};

use ruff_text_size::{Ranged as _, TextRange, TextSize};

use crate::scene::{Axis, Cardinal, Layout, Source};
use crate::syntax::ast::statement_visitor::{StatementVisitor, walk_stmt};
use crate::syntax::ast::{Expr, ExprCall, Number, Operator, Stmt, UnaryOp};
use crate::syntax::tune::{self, format_constant};
use crate::syntax::{ConstantId, DirectionId, Edit, LineIndex};

use super::changes::{Change, Changes};
use super::constants::Names;
use super::measure::{Score, step};
use super::problem::Problem;
use super::proposals::all_turns;
use super::state::{State, score_of};
use super::words::{change_words, objects};

/// An object that comes so near to a place is there. Metres.
pub const NEAR: f64 = 1e-3;
/// So many constants are tried for each axis.
const PER_AXIS: usize = 3;
/// So many runs are made for one answer.
const RUNS: usize = 60;
/// How often a value is corrected where the way is no straight one.
const CORRECTIONS: usize = 2;

/// Edits that move or turn an object, and what a run of the edited text gave.
#[derive(Clone, PartialEq, Debug)]
pub struct Reach {
    /// What they do.
    pub title: String,
    /// The edits of the text, by place.
    pub edits: Vec<Edit>,
    /// Where its center is then. World coordinates, metres.
    pub reached: [f64; 3],
    /// Where it faces then.
    pub facing: Cardinal,
    /// Whether it is where it was wanted.
    pub exact: bool,
    /// How many errors there are then.
    pub errors: usize,
    /// How many objects stand or face elsewhere, with itself.
    pub moves: usize,
}

/// A place in the text that takes an offset along an axis.
struct Slot {
    range: TextRange,
    /// The text up to the offset, or the number that it is added to.
    value: SlotValue,
    line: u32,
}

enum SlotValue {
    Number(f64),
    Text(String),
}

/// One way to move along an axis.
#[derive(Clone)]
enum Handle {
    /// A literal, by its place in the record, with how the object moves with it.
    Literal(usize, [f64; 3]),
    /// A place that takes an offset: metres of it for each metre of the way.
    Offset(std::rc::Rc<Slot>, f64, usize),
}

struct Reacher<'a> {
    problem: &'a Problem,
    names: &'a Names,
    base: State,
    object: usize,
    lines: LineIndex,
    runs: usize,
    cancel: Option<&'a AtomicBool>,
}

/// The edits that put the center of an object at a place, best first: those that get there, with the fewest errors, that move the
/// fewest other objects; else the nearest. A coordinate that is not given shall stay.
pub fn move_to(problem: &Problem, names: &Names, object: usize, to: [Option<f64>; 3], cancel: Option<&AtomicBool>) -> Vec<Reach> {
    let given = to.iter().flatten().all(|value| value.is_finite());
    let Some(mut reacher) = Reacher::new(problem, names, object, cancel).filter(|_| given) else { return Vec::new() };
    let from = reacher.base.bodies[object].center;
    let target = [0, 1, 2].map(|k| to[k].unwrap_or(from[k]));
    let mut found = reacher.moves(from, target);
    let distance = |reach: &Reach| (0..3).map(|k| (reach.reached[k] - target[k]).powi(2)).sum::<f64>().sqrt();
    for reach in &mut found {
        reach.exact = (0..3).all(|k| to[k].is_none_or(|wanted| (reach.reached[k] - wanted).abs() <= NEAR));
    }
    let before = (0..3).map(|k| (from[k] - target[k]).powi(2)).sum::<f64>().sqrt();
    found.retain(|reach| distance(reach) < before);
    found.sort_by(|a, b| {
        let far = |reach: &Reach| if distance(reach) > 2.0 * NEAR { distance(reach) } else { 0.0 };
        far(a).total_cmp(&far(b)).then_with(|| (a.errors, a.moves, a.edits.len()).cmp(&(b.errors, b.moves, b.edits.len())))
    });
    found.dedup_by(|a, b| a.edits == b.edits);
    found
}

/// The edits that turn an object, best first: those with the fewest errors that move and turn the fewest other objects.
pub fn turn_to(problem: &Problem, names: &Names, object: usize, facing: Cardinal, cancel: Option<&AtomicBool>) -> Vec<Reach> {
    let Some(mut reacher) = Reacher::new(problem, names, object, cancel) else { return Vec::new() };
    let mut directions: Vec<DirectionId> = reacher.base.directions(object).to_vec();
    directions.sort_unstable();
    directions.dedup();
    let near = |id: &DirectionId| tune::Cardinal::ALL.map(|cardinal| Change::Turn(*id, cardinal));
    let mut found = reacher.turns(facing, directions.iter().flat_map(near));
    if found.is_empty() {
        found = reacher.turns(facing, all_turns(problem));
    }
    if found.is_empty() {
        found.extend(reacher.new_facing(facing));
    }
    found.sort_by_key(|reach| (reach.errors, reach.moves, reach.edits.first().map(|edit| edit.0.start())));
    found.dedup_by(|a, b| a.edits == b.edits);
    found
}

impl<'a> Reacher<'a> {
    fn new(problem: &'a Problem, names: &'a Names, object: usize, cancel: Option<&'a AtomicBool>) -> Option<Reacher<'a>> {
        problem.layout().objects.get(object)?;
        let base = State::original(problem);
        Some(Reacher { problem, names, base, object, lines: LineIndex::new(problem.text()), runs: RUNS, cancel })
    }

    /// Runs the text after some edits.
    fn run(&mut self, edits: &[Edit]) -> Option<(Layout, Score)> {
        if self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
            return None;
        }
        self.runs = self.runs.checked_sub(1)?;
        let mut text = self.problem.text().to_string();
        for (range, new) in edits.iter().rev() {
            let range = range.start().to_usize()..range.end().to_usize();
            text.get(range.clone())?;
            text.replace_range(range, new);
        }
        let (layout, _) = self.problem.judge_text(&text)?;
        let score = score_of(self.problem, &layout);
        Some((layout, score))
    }

    fn reach(&self, what: &str, edits: Vec<Edit>, layout: &Layout, score: &Score) -> Reach {
        let pairs = self.problem.layout().objects.iter().zip(&layout.objects).enumerate();
        let elsewhere = pairs.filter(|(_, (a, b))| step(&a.body, &b.body).1 || a.body.turn != b.body.turn);
        let moved: Vec<usize> = elsewhere.map(|(index, _)| index).collect();
        let mut title = what.to_string();
        if moved.iter().any(|index| *index != self.object) {
            title.push_str(&format!(", moves {}", objects(self.problem, &moved)));
        }
        let body = &layout.objects[self.object].body;
        Reach { title, edits, reached: body.center, facing: body.turn, exact: true, errors: score.count, moves: moved.len() }
    }

    fn moves(&mut self, from: [f64; 3], target: [f64; 3]) -> Vec<Reach> {
        let way = [0, 1, 2].map(|k| target[k] - from[k]);
        let wanted: Vec<usize> = (0..3).filter(|k| way[*k].abs() > 1e-9).collect();
        let literals = self.literals();
        let mut plans: Vec<Vec<Handle>> = literals.iter().map(|(literal, slope)| vec![Handle::Literal(*literal, *slope)]).collect();
        plans.truncate(3 * PER_AXIS);
        let mut choices: Vec<Vec<Handle>> = Vec::new();
        for &k in &wanted {
            let straight = |slope: &[f64; 3]| (0..3).all(|other| other == k || slope[other].abs() < 1e-9) && slope[k].abs() > 1e-6;
            let own = literals.iter().filter(|(_, slope)| straight(slope)).take(PER_AXIS);
            let mut handles: Vec<Handle> = own.map(|(literal, slope)| Handle::Literal(*literal, *slope)).collect();
            handles.extend(self.offset(k, way[k]));
            choices.push(handles);
        }
        plans.extend(products(&choices));
        let mut found = Vec::new();
        for plan in plans {
            found.extend(self.follow(&plan, from, target));
        }
        found
    }

    /// The literals that move the object, those that move the fewest others first.
    fn literals(&mut self) -> Vec<(usize, [f64; 3])> {
        let mut movers: Vec<usize> = self.base.movers(self.object).to_vec();
        movers.sort_unstable();
        movers.dedup();
        movers.retain(|literal| self.problem.is_free(ConstantId(self.base.literals()[*literal].id)));
        let mut found: Vec<(usize, usize, [f64; 3])> = Vec::new();
        for literal in movers {
            let slopes = self.base.slopes(literal);
            let own = slopes.iter().find(|(object, _)| *object as usize == self.object).map(|(_, slope)| *slope);
            if let Some(slope) = own.filter(|slope| slope.iter().any(|part| part.abs() > 1e-6)) {
                found.push((slopes.len(), literal, slope));
            }
        }
        found.sort_by_key(|(reached, literal, _)| (*reached, *literal));
        found.into_iter().map(|(_, literal, slope)| (literal, slope)).collect()
    }

    /// Finds the values for a plan, writes them shortly, and runs the text.
    fn follow(&mut self, plan: &[Handle], from: [f64; 3], target: [f64; 3]) -> Option<Reach> {
        let slopes: Vec<[f64; 3]> = plan.iter().map(Handle::slope).collect();
        let mut steps = vec![0.0; plan.len()];
        let mut aim = [0, 1, 2].map(|k| target[k] - from[k]);
        let mut best: Option<(f64, Reach)> = None;
        for _ in 0..=CORRECTIONS {
            solve(&slopes, aim, &mut steps);
            if steps.iter().any(|step| !step.is_finite() || step.abs() > 1e6) {
                break;
            }
            let edits = self.edits(plan, &steps)?;
            let Some((layout, score)) = self.run(&edits) else { break };
            let reached = layout.objects[self.object].body.center;
            let left = [0, 1, 2].map(|k| target[k] - reached[k]);
            let distance = left.iter().map(|part| part * part).sum::<f64>().sqrt();
            if best.as_ref().is_none_or(|(nearest, _)| distance < *nearest) {
                let what = self.words(plan, &steps);
                best = Some((distance, self.reach(&what, edits, &layout, &score)));
            }
            // Where more of the same does not help, the way is at its end.
            let reachable = (0..3).any(|k| left[k].abs() > NEAR && slopes.iter().any(|slope| slope[k].abs() > 1e-6));
            if distance <= 2.0 * NEAR || !reachable {
                break;
            }
            for k in 0..3 {
                aim[k] += left[k];
            }
        }
        best.map(|(_, reach)| reach)
    }

    fn edits(&self, plan: &[Handle], steps: &[f64]) -> Option<Vec<Edit>> {
        let mut edits = Vec::new();
        for (handle, step) in plan.iter().zip(steps) {
            edits.push(match handle {
                Handle::Literal(literal, slope) => {
                    let id = ConstantId(self.base.literals()[*literal].id);
                    let value = short(self.base.value(*literal) + step, steepness(slope));
                    self.problem.tuning().constant(id)?.edit(value)
                }
                Handle::Offset(slot, per_metre, _) => slot.edit(short(step * per_metre, 1.0)),
            });
        }
        edits.sort_by_key(|(range, _)| (range.start(), range.end()));
        let apart = edits.windows(2).all(|pair| pair[0].0.end() <= pair[1].0.start());
        apart.then_some(edits)
    }

    fn words(&self, plan: &[Handle], steps: &[f64]) -> String {
        let part = |(handle, step): (&Handle, &f64)| match handle {
            Handle::Literal(literal, slope) => {
                let id = ConstantId(self.base.literals()[*literal].id);
                let value = short(self.base.value(*literal) + step, steepness(slope));
                change_words(self.problem, self.names, Change::Constant(id, value), &self.lines)
            }
            Handle::Offset(slot, per_metre, _) => {
                let (_, new) = slot.edit(short(step * per_metre, 1.0));
                format!("write {} on line {}", super::words::shown(&new), slot.line + 1)
            }
        };
        let parts: Vec<String> = plan.iter().zip(steps).map(part).collect();
        super::words::capitalised(&parts.join(" and "))
    }

    /// The place in the statement that anchored an axis which takes an offset, as a run shows.
    fn offset(&mut self, k: usize, way: f64) -> Option<Handle> {
        let axis = [Axis::X, Axis::Y, Axis::Z][k];
        let origin = self.problem.layout().objects[self.object].anchor(axis)?.origin;
        let origin = self.problem.layout().origins.get(origin);
        if origin.source != Source::Program {
            return None;
        }
        let before = self.base.bodies[self.object].center;
        for slot in self.slots(origin.range, k) {
            let slot = std::rc::Rc::new(slot);
            for sign in [1.0, -1.0] {
                let Some((layout, _)) = self.run(&[slot.edit(sign * way)]) else { continue };
                let after = layout.objects[self.object].body.center;
                let still = (0..3).all(|other| other == k || (after[other] - before[other]).abs() < 1e-6);
                if still && (after[k] - before[k] - way).abs() < NEAR {
                    return Some(Handle::Offset(slot, sign, k));
                }
            }
        }
        None
    }

    /// The values of an assignment that may take an offset, the likeliest first.
    fn slots(&self, statement: TextRange, k: usize) -> Vec<Slot> {
        let parsed = self.problem.parsed();
        let mut finder = Finder { range: statement, found: None };
        parsed.with_stack(|| finder.visit_body(&parsed.module.body));
        let value = match finder.found {
            Some(Stmt::Assign(node)) => &*node.value,
            Some(Stmt::AugAssign(node)) if matches!(node.op, Operator::Add | Operator::Sub) => &*node.value,
            _ => return Vec::new(),
        };
        let parts: Option<&[Expr]> = match value {
            Expr::Tuple(node) => Some(&node.elts),
            Expr::List(node) => Some(&node.elts),
            Expr::Call(ExprCall { func, arguments, .. }) if matches!(&**func, Expr::Name(name) if name.id == "Vec") => {
                Some(&arguments.args)
            }
            _ => None,
        };
        let exprs: Vec<&Expr> = match parts {
            Some(parts) if parts.len() == 3 && k == 2 => vec![&parts[2]],
            Some(parts) if parts.len() == 3 => vec![&parts[k], &parts[1 - k]],
            Some(_) => Vec::new(),
            None => vec![value],
        };
        exprs.into_iter().filter_map(|expr| self.slot(expr)).collect()
    }

    fn slot(&self, expr: &Expr) -> Option<Slot> {
        let range = expr.range();
        let text = self.problem.text().get(range.start().to_usize()..range.end().to_usize())?;
        let value = match (whole_number(expr), expr) {
            (Some(number), _) => SlotValue::Number(number),
            (None, Expr::Starred(_) | Expr::Yield(_) | Expr::YieldFrom(_)) => return None,
            (None, expr) if binds_tightly(expr) => SlotValue::Text(text.to_string()),
            _ => SlotValue::Text(format!("({text})")),
        };
        Some(Slot { range, value, line: self.lines.line(range.start()) })
    }

    fn turns(&mut self, facing: Cardinal, changes: impl Iterator<Item = Change>) -> Vec<Reach> {
        let mut found = Vec::new();
        for change in changes {
            let changes = Changes::default().with(change, self.problem.tuning());
            let Some((_, edits)) = self.problem.rewrite(&changes) else { continue };
            let Some((layout, score)) = self.run(&edits) else { continue };
            if layout.objects[self.object].body.turn == facing {
                let words = change_words(self.problem, self.names, change, &self.lines);
                found.push(self.reach(&super::words::capitalised(&words), edits, &layout, &score));
            }
        }
        found
    }

    /// A new statement that turns the object, behind the last one that placed it.
    fn new_facing(&mut self, facing: Cardinal) -> Option<Reach> {
        let (layout, text) = (self.problem.layout(), self.problem.text());
        let object = &layout.objects[self.object];
        let callable = object.path.starts_with(|first: char| first == '_' || first.is_alphabetic()) && !object.path.contains(['#', '\n']);
        let placed = object.anchors.iter().max_by_key(|anchor| anchor.when).map_or(object.declared, |anchor| anchor.origin);
        let origin = layout.origins.get(placed);
        let ranges: Vec<TextRange> = layout.origins.steps_around(placed).map(|step| step.range).chain([origin.range]).collect();
        let inside = |stmt: &&Stmt| ranges.iter().any(|range| stmt.range().contains_range(*range));
        let statement = self.problem.parsed().module.body.iter().rfind(inside);
        let line = statement.filter(|_| callable && origin.source == Source::Program).map(|stmt| self.lines.line(stmt.end()));
        let spelled = self.problem.tuning().spelling.spell(tune::Cardinal::ALL[facing as usize]);
        let statement = format!("{}.facing = {spelled}", object.path);
        let newline = if text.contains("\r\n") { "\r\n" } else { "\n" };
        let end = TextSize::of(text);
        let places = line.map(|line| self.lines.line_range(line, text).end()).into_iter().chain([end]);
        let words = format!("Add {}", super::words::shown(&statement));
        for at in places {
            let edit = (TextRange::empty(at), format!("{newline}{statement}"));
            let edits = vec![edit];
            if let Some((layout, score)) = self.run(&edits)
                && layout.objects[self.object].body.turn == facing
            {
                return Some(self.reach(&words, edits, &layout, &score));
            }
        }
        None
    }
}

impl Handle {
    fn slope(&self) -> [f64; 3] {
        match self {
            Handle::Literal(_, slope) => *slope,
            Handle::Offset(_, _, k) => [0, 1, 2].map(|other| if other == *k { 1.0 } else { 0.0 }),
        }
    }
}

impl Slot {
    /// The edit that adds an offset, in metres of the frame.
    fn edit(&self, offset: f64) -> Edit {
        let new = match &self.value {
            SlotValue::Number(number) => format_constant(short(number + offset, 1.0), false),
            SlotValue::Text(text) if offset < 0.0 => format!("{text} - {}", format_constant(-offset, false)),
            SlotValue::Text(text) => format!("{text} + {}", format_constant(offset, false)),
        };
        (self.range, new)
    }
}

/// How far the object goes for each unit of a literal.
fn steepness(slope: &[f64; 3]) -> f64 {
    slope.iter().map(|part| part * part).sum::<f64>().sqrt()
}

/// The number with the fewest decimals that leads to the same place within half of what counts as there.
fn short(value: f64, steepness: f64) -> f64 {
    let rounded = (0..=9).map(|decimals| {
        let unit = 10_f64.powi(decimals);
        (value * unit).round() / unit
    });
    let near = |short: &f64| (short - value).abs() * steepness.max(1e-9) <= 0.5 * NEAR;
    let found = rounded.into_iter().find(near).unwrap_or(value);
    if found == 0.0 { 0.0 } else { found }
}

/// Steps of several handles that together go a way as well as they can: least squares, one after the other.
fn solve(slopes: &[[f64; 3]], way: [f64; 3], steps: &mut [f64]) {
    for _ in 0..24 {
        for at in 0..slopes.len() {
            let mut left = way;
            for (other, slope) in slopes.iter().enumerate().filter(|(other, _)| *other != at) {
                (0..3).for_each(|k| left[k] -= slope[k] * steps[other]);
            }
            let (along, square) =
                (0..3).fold((0.0, 0.0), |(along, square), k| (along + slopes[at][k] * left[k], square + slopes[at][k] * slopes[at][k]));
            steps[at] = along / square;
        }
    }
}

/// All ways to choose one handle for each axis, as long as they are few and no literal is chosen twice.
fn products(choices: &[Vec<Handle>]) -> Vec<Vec<Handle>> {
    let mut plans: Vec<Vec<Handle>> = vec![Vec::new()];
    for handles in choices.iter().filter(|handles| !handles.is_empty()) {
        let longer = plans.iter().flat_map(|plan| handles.iter().map(move |handle| plan.iter().cloned().chain([handle.clone()]).collect()));
        plans = longer.take(16).collect();
    }
    plans.retain(|plan| {
        let literals: Vec<usize> =
            plan.iter().filter_map(|handle| if let Handle::Literal(at, _) = handle { Some(*at) } else { None }).collect();
        !plan.is_empty() && literals.iter().enumerate().all(|(at, literal)| !literals[..at].contains(literal))
    });
    plans
}

/// The value of an integer literal with its sign.
fn whole_number(expr: &Expr) -> Option<f64> {
    match expr {
        Expr::NumberLiteral(node) => match &node.value {
            Number::Int(int) => int.as_i64().map(|int| int as f64),
            _ => None,
        },
        Expr::UnaryOp(node) if node.op == UnaryOp::USub => whole_number(&node.operand).map(|number| -number),
        _ => None,
    }
}

/// Whether something may be added behind an expression without parentheses around it.
fn binds_tightly(expr: &Expr) -> bool {
    match expr {
        Expr::BinOp(node) => {
            use Operator::{Add, Div, FloorDiv, Mod, Mult, Pow, Sub};
            matches!(node.op, Add | Sub | Mult | Div | FloorDiv | Mod | Pow)
        }
        Expr::UnaryOp(node) => node.op != UnaryOp::Not,
        Expr::Name(_) | Expr::Attribute(_) | Expr::Subscript(_) | Expr::Call(_) | Expr::NumberLiteral(_) => true,
        _ => false,
    }
}

struct Finder<'a> {
    range: TextRange,
    found: Option<&'a Stmt>,
}

impl<'a> StatementVisitor<'a> for Finder<'a> {
    fn visit_stmt(&mut self, stmt: &'a Stmt) {
        if stmt.range() == self.range {
            self.found = Some(stmt);
        } else if stmt.range().contains_range(self.range) {
            walk_stmt(self, stmt);
        }
    }
}
