//! The tunable constants of a program as people see them: what they are called, what they move, and where no errors are.

use std::sync::atomic::{AtomicBool, Ordering};

use ruff_text_size::{Ranged as _, TextRange};
use rustc_hash::{FxHashMap, FxHashSet};

use crate::check::{ErrorKind, Violation, check};
use crate::syntax::ast::visitor::{self, Visitor};
use crate::syntax::ast::{self, Expr, Stmt};
use crate::syntax::{ConstantId, Parsed};

use super::changes::{Change, Changes};
use super::problem::Problem;
use super::state::State;

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

/// A tunable constant as people see it.
#[derive(Clone, PartialEq, Debug)]
pub struct Tunable {
    /// Which.
    pub id: ConstantId,
    /// What it is called.
    pub name: Option<String>,
    /// The intervals around its value, or nearest to it, in which it causes no errors; `None` is an open end.
    pub good: Vec<(Option<f64>, Option<f64>)>,
    /// Whether the ends of the intervals were found; otherwise they may reach farther, or there may be others.
    pub is_complete: bool,
    /// The objects that it moves, as indices of the layout, and how far each unit more moves them along each axis. Metres.
    pub moves: Vec<(usize, [f64; 3])>,
    /// Errors now among the objects that it moves.
    pub errors: usize,
}

/// So many objects of a constant are asked for the values at which they meet others.
const ASKED: usize = 24;
/// So many such values are looked at on each side.
const STOPS: usize = 40;
/// So many values on each side are looked at where a constant causes errors as it is.
const SEARCHED: usize = 24;
/// So many runs of the program are made for one constant.
const RUNS: usize = 12;
/// How closely the end of an interval is found: steps of bisection.
const BISECTIONS: usize = 14;
/// A value so far beyond the last meeting stands for all that lie further. In the units of the constant.
const FAR: f64 = 1e3;
/// Of an open interval so much is looked at once more, at so many values. In the units of the constant.
const OPEN: f64 = 8.0;
const BETWEEN: u32 = 16;

/// All constants that may be rewritten, in the order of the text. Ends early where it is cancelled.
pub fn tunables(problem: &Problem, names: &Names, cancel: Option<&AtomicBool>) -> Vec<Tunable> {
    let mut tuner = Tuner::new(problem);
    let ids = (0..problem.tuning().constants.len()).map(|at| ConstantId(u32::try_from(at).unwrap_or(u32::MAX)));
    let going = |_: &ConstantId| !cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed));
    ids.take_while(going).filter_map(|id| tuner.tunable(problem, names, id, usize::MAX)).collect()
}

/// Tries the constants of one program, one at a time.
#[derive(Debug)]
pub struct Tuner {
    base: State,
    known: FxHashSet<Key>,
}

impl Tuner {
    /// Begins with what the record of the program tells.
    pub fn new(problem: &Problem) -> Tuner {
        let base = State::original(problem);
        let known = base.violations.iter().map(key).collect();
        Tuner { base, known }
    }

    /// What there is to say about a constant; `None` where it may not be rewritten. What is tried may cost so much, in units of the budget
    /// of a search: half of it below the value of the constant, half above.
    pub fn tunable(&mut self, problem: &Problem, names: &Names, id: ConstantId, budget: usize) -> Option<Tunable> {
        if !problem.is_free(id) {
            return None;
        }
        let name = names.get(problem, id).map(str::to_string);
        Some(match self.base.literals().binary_search_by_key(&id.0, |slice| slice.id) {
            Ok(literal) => self.tried(problem, id, literal, name, budget),
            Err(_) => Tunable { id, name, good: vec![(None, None)], is_complete: true, moves: Vec::new(), errors: 0 },
        })
    }

    fn tried(&mut self, problem: &Problem, id: ConstantId, literal: usize, name: Option<String>, budget: usize) -> Tunable {
        let slopes = self.base.slopes(literal);
        let moves: Vec<(usize, [f64; 3])> = slopes.iter().map(|(object, slope)| (*object as usize, *slope)).collect();
        let reached: FxHashSet<u32> = slopes.iter().map(|(object, _)| *object).collect();
        let takes_part = |error: &Violation| {
            let objects = [Some(error.culprit), error.other, error.support];
            objects.into_iter().flatten().any(|object| reached.contains(&object))
        };
        let errors = self.base.violations.iter().filter(|error| takes_part(error)).count();
        let value = self.base.value(literal);
        let stops = stops(&self.base, &moves, value);
        let known = &self.known;
        let (mut runs, mut left, mut asked_too_much) = (RUNS, budget, false);
        let good = |base: &mut State, at: f64, reserve: bool| {
            let causes = |errors: &[Violation]| errors.iter().any(|error| takes_part(error) || !known.contains(&key(error)));
            if left <= if reserve { budget / 2 } else { 0 } {
                asked_too_much = true;
                return false;
            }
            let tried = base.try_errors(problem, literal, at);
            left = left.saturating_sub(base.replay_cost());
            if let Some((_, errors)) = tried {
                return !causes(&errors);
            }
            let Some(fewer) = runs.checked_sub(1) else { return false };
            (runs, left) = (fewer, left.saturating_sub(problem.run_cost()));
            let changes = Changes::default().with(Change::Constant(id, at), problem.tuning());
            let Some(ran) = problem.run(&changes, false) else { return false };
            let verdict = check(&ran.layout, &problem.options().rules);
            !causes(&verdict.counted().copied().collect::<Vec<_>>())
        };
        let good = Intervals { value, stops, base: &mut self.base, good }.find();
        Tunable { id, name, good, is_complete: !asked_too_much, moves, errors }
    }
}

/// The values at which an object that moves meets another, a wall or the ground.
fn stops(base: &State, moves: &[(usize, [f64; 3])], value: f64) -> Vec<f64> {
    let stride = moves.len().div_ceil(ASKED).max(1);
    let slope_of = |object: usize| moves.binary_search_by_key(&object, |(moved, _)| *moved).map_or([0.0; 3], |at| moves[at].1);
    let bounds = base.bounds();
    let mut stops = Vec::new();
    for (object, slope) in moves.iter().step_by(stride) {
        let body = &base.bodies[*object];
        for k in 0..3 {
            let mut stop = |shift: f64, slope: f64| {
                let at = value + shift / slope;
                if at.is_finite() && (at - value).abs() < FAR && at != value {
                    stops.push(at);
                }
            };
            stop(bounds.min[k] - body.min[k], slope[k]);
            stop(bounds.max[k] - body.max[k], slope[k]);
            for (other, second) in base.bodies.iter().enumerate().filter(|(other, second)| other != object && second.is_placed()) {
                let relative = slope[k] - slope_of(other)[k];
                if relative != 0.0 {
                    stop(second.max[k] - body.min[k], relative);
                    stop(second.min[k] - body.max[k], relative);
                }
            }
        }
    }
    stops.sort_by(f64::total_cmp);
    stops.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    stops
}

/// The search for the values without errors.
struct Intervals<'a, G> {
    value: f64,
    stops: Vec<f64>,
    base: &'a mut State,
    good: G,
}

impl<G: FnMut(&mut State, f64, bool) -> bool> Intervals<'_, G> {
    /// What lies below is looked at first and leaves something for what lies above.
    fn is_good(&mut self, at: f64) -> bool {
        (self.good)(self.base, at, at < self.value)
    }

    fn find(mut self) -> Vec<(Option<f64>, Option<f64>)> {
        let value = self.value;
        if self.is_good(value) {
            return vec![(self.end(value, -1.0), self.end(value, 1.0))];
        }
        let below = self.nearest(-1.0).map(|(bad, good)| (self.end(good, -1.0), Some(self.edge(good, bad))));
        let above = self.nearest(1.0).map(|(bad, good)| (Some(self.edge(good, bad)), self.end(good, 1.0)));
        below.into_iter().chain(above).collect()
    }

    /// The values to look at from a place on: each stop, and between them.
    fn samples(&self, from: f64, side: f64, count: usize) -> Vec<f64> {
        let mut stops: Vec<f64> = self.stops.iter().copied().filter(|stop| (stop - from) * side > 1e-9).collect();
        stops.sort_by(|a, b| (a * side).total_cmp(&(b * side)));
        let all = stops.len() <= count;
        stops.truncate(count);
        let mut samples = Vec::new();
        let mut last = from;
        for stop in stops {
            samples.extend([0.5 * (last + stop), stop]);
            last = stop;
        }
        if all {
            samples.extend([last + 0.05 * side, last + FAR * side]);
        }
        samples
    }

    /// How far no errors go from a good value; open where they go on for ever. What the meetings do not tell (a decision of the program
    /// between two of them) is looked for at some values in between.
    fn end(&mut self, from: f64, side: f64) -> Option<f64> {
        let end = self.straight_end(from, side);
        let far = end.unwrap_or(from + OPEN * side);
        let mut last = from;
        for part in 1..BETWEEN {
            let between = from + (far - from) * f64::from(part) / f64::from(BETWEEN);
            if !self.is_good(between) {
                return Some(self.edge(last, between));
            }
            last = between;
        }
        end
    }

    fn straight_end(&mut self, from: f64, side: f64) -> Option<f64> {
        let mut last = from;
        for sample in self.samples(from, side, STOPS) {
            if !self.is_good(sample) {
                return Some(self.edge(last, sample));
            }
            last = sample;
        }
        ((last - from).abs() < FAR).then_some(last)
    }

    /// The last bad and the first good value on a side.
    fn nearest(&mut self, side: f64) -> Option<(f64, f64)> {
        let mut last = self.value;
        for sample in self.samples(self.value, side, SEARCHED) {
            if self.is_good(sample) {
                return Some((last, sample));
            }
            last = sample;
        }
        None
    }

    /// The good value next to a bad one.
    fn edge(&mut self, mut good: f64, mut bad: f64) -> f64 {
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (good + bad);
            if self.is_good(middle) {
                good = middle;
            } else {
                bad = middle;
            }
        }
        good
    }
}

type Key = (ErrorKind, u32, Option<u32>);

fn key(error: &Violation) -> Key {
    (error.kind, error.culprit, error.other)
}
