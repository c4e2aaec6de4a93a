//! A layout under correction: the record of a run, and what of it other values of a literal would change.

use std::sync::Arc;

use smallvec::SmallVec;

use crate::check::measure::{self as terms, Bounds, Gap};
use crate::check::{Checker, ErrorKind, Violation, check};
use crate::scene::{Body, Layout, Support, Target, Told};
use crate::syntax::{ConstantId, DirectionId, Tuning};
use crate::trace::{LiteralSlice, Num, Replay, Slices, Trace};
use ruff_text_size::TextRange;

use super::changes::{Change, Changes};
use super::measure::{Score, step, volume};
use super::problem::{Problem, Ran};

/// What one run tells about all its neighbours.
#[derive(Debug)]
struct Record {
    trace: Trace,
    slices: Slices,
    /// Per object, its center.
    centers: Vec<[Num; 3]>,
    /// Per literal, the objects that it moves.
    reached: Vec<Vec<u32>>,
    /// Per object, those that were told to face it.
    facers: Vec<Vec<u32>>,
    /// Per object, the directions in the statements that turned it.
    directions: Vec<Vec<DirectionId>>,
    bounds: Bounds,
}

/// The derivative of the centers of objects by a literal.
pub(super) type Slopes = SmallVec<[(u32, [f64; 3]); 8]>;

/// A candidate that was run or replayed.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub(super) changes: Changes,
    pub(super) bodies: Vec<Body>,
    pub(super) violations: Vec<Violation>,
    pub(super) score: Score,
    record: Arc<Record>,
    replay: Replay,
    /// Per standing body above the ground, what carries it.
    carriers: Vec<Option<u32>>,
    moved: Vec<bool>,
}

/// The score of a run.
pub(super) fn score_of(problem: &Problem, layout: &Layout) -> Score {
    let verdict = check(layout, &problem.options().rules);
    let mut score = Score { loss: verdict.loss(), count: verdict.counted().count(), moved: 0, work: 0.0 };
    for (before, after) in problem.layout().objects.iter().zip(&layout.objects) {
        let (distance, moved) = step(&before.body, &after.body);
        score.moved += usize::from(moved);
        score.work += volume(&before.body) * distance;
    }
    score
}

impl State {
    /// The state after a recorded run.
    pub(super) fn of(problem: &Problem, changes: Changes, ran: Ran) -> State {
        let score = score_of(problem, &ran.layout);
        let verdict = check(&ran.layout, &problem.options().rules);
        let (bodies, record) = (ran.layout.bodies(), Arc::new(Record::of(problem.tuning(), ran)));
        let moved = vec![false; bodies.len()];
        let mut state = State {
            changes,
            violations: verdict.counted().copied().collect(),
            score,
            replay: Replay::new(&record.trace),
            carriers: Vec::new(),
            moved,
            record,
            bodies,
        };
        state.carriers = (0..state.bodies.len()).map(|index| state.carrier(problem, index)).collect();
        state
    }

    /// The state after a run with changes.
    pub(super) fn run(problem: &Problem, changes: Changes) -> Option<State> {
        let ran = problem.run(&changes, true)?;
        Some(State::of(problem, changes, ran))
    }

    fn carrier(&self, problem: &Problem, index: usize) -> Option<u32> {
        let body = &self.bodies[index];
        let lifted = body.is_placed() && body.support == Support::Standing && body.min[2].abs() >= problem.options().rules.tolerance;
        let others = self.bodies.iter().enumerate().filter(|(other, body)| *other != index && body.is_placed());
        let gap = lifted.then(|| others.fold(Gap::to_ground(body), |gap, (other, support)| gap.or(body, other, support)))?;
        gap.support.map(|support| support as u32)
    }

    /// The box of the scene.
    pub(super) fn bounds(&self) -> &Bounds {
        &self.record.bounds
    }

    /// The literals of the record, free or not.
    pub(super) fn literals(&self) -> &[LiteralSlice] {
        self.record.slices.literals()
    }

    /// The literals that move an object, as places among [`literals`](State::literals).
    pub(super) fn movers(&self, object: usize) -> impl Iterator<Item = usize> + '_ {
        self.record.centers[object].iter().flat_map(|num| self.record.slices.reaching(num.handle))
    }

    /// The directions in the statements that turned an object.
    pub(super) fn directions(&self, object: usize) -> &[DirectionId] {
        &self.record.directions[object]
    }

    /// The present value of a literal.
    pub(super) fn value(&self, literal: usize) -> f64 {
        self.replay.literal(&self.literals()[literal])
    }

    /// How the objects that a literal reaches move with it, near its present value.
    pub(super) fn slopes(&mut self, literal: usize) -> Slopes {
        const NEAR: f64 = 1.0 / 1024.0;
        let record = Arc::clone(&self.record);
        let slice = &record.slices.literals()[literal];
        self.replay.set(&record.trace, slice, self.replay.literal(slice) + NEAR);
        let slope = |object: &u32| {
            let (now, then) = (record.centers[*object as usize], self.bodies[*object as usize].center);
            (*object, [0, 1, 2].map(|k| (self.replay.now(now[k]) - then[k]) / NEAR))
        };
        let slopes = record.reached[literal].iter().map(slope).collect();
        self.replay.undo();
        slopes
    }

    /// What another value of a literal would give, by replay; `None` where a decision of the program comes out otherwise.
    pub(super) fn try_literal(&mut self, problem: &Problem, literal: usize, value: f64) -> Option<Score> {
        self.tried(problem, literal, value, None)
    }

    /// The same with the errors that there would be.
    pub(super) fn try_errors(&mut self, problem: &Problem, literal: usize, value: f64) -> Option<(Score, Vec<Violation>)> {
        let mut errors = Vec::new();
        let score = self.tried(problem, literal, value, Some(&mut errors))?;
        Some((score, errors))
    }

    fn tried(&mut self, problem: &Problem, literal: usize, value: f64, keep: Option<&mut Vec<Violation>>) -> Option<Score> {
        let record = Arc::clone(&self.record);
        let slice = &record.slices.literals()[literal];
        self.replay.set(&record.trace, slice, value);
        if !self.replay.holds(&record.trace, slice) {
            self.replay.undo();
            return None;
        }
        let old = self.place(&record, literal);
        let score = self.rescore(problem, &record, &old, keep);
        for (object, body) in old {
            self.bodies[object as usize] = body;
            self.moved[object as usize] = false;
        }
        self.replay.undo();
        Some(score)
    }

    /// Moves the bodies that a literal reaches to where the replay has them; answers those that were elsewhere before.
    fn place(&mut self, record: &Record, literal: usize) -> Vec<(u32, Body)> {
        let mut old = Vec::new();
        for &object in &record.reached[literal] {
            let body = &mut self.bodies[object as usize];
            let center = record.centers[object as usize].map(|num| self.replay.now(num));
            if center != body.center {
                old.push((object, *body));
                *body = body.at(center);
                self.moved[object as usize] = true;
            }
        }
        old
    }

    /// The score after some bodies were moved: only the terms that read them are measured again. `keep` gets the errors.
    fn rescore(&self, problem: &Problem, record: &Record, old: &[(u32, Body)], mut keep: Option<&mut Vec<Violation>>) -> Score {
        let checker = Checker { rules: &problem.options().rules, bounds: record.bounds, bodies: &self.bodies };
        let mut score = self.score;
        for (object, before) in old {
            let original = &problem.layout().objects[*object as usize].body;
            let ((was, far), (is, further)) = (step(original, before), step(original, &self.bodies[*object as usize]));
            score.work += volume(original) * (is - was);
            score.moved = score.moved + usize::from(further) - usize::from(far);
        }
        let again = self.to_measure(record, old);
        for violation in &self.violations {
            let dropped = match violation.kind {
                ErrorKind::Standing => again.standing.contains(&violation.culprit),
                _ => violation.objects().any(|object| self.moved[object]),
            };
            if dropped {
                score.loss -= violation.loss;
                score.count -= 1;
            } else if let Some(kept) = &mut keep {
                kept.push(*violation);
            }
        }
        let mut add = |violation: Violation| {
            if violation.kind != ErrorKind::Unplaced {
                score.loss += violation.loss;
                score.count += 1;
                keep.iter_mut().for_each(|kept| kept.push(violation));
            }
        };
        again.standing.iter().filter_map(|object| checker.standing_of(*object as usize)).for_each(&mut add);
        for object in &again.facers {
            checker.alone(*object as usize).filter(|violation| violation.kind == ErrorKind::Facing).for_each(&mut add);
        }
        for (object, _) in old {
            let object = *object as usize;
            checker.alone(object).for_each(&mut add);
            if self.bodies[object].is_placed() {
                self.pairs(&checker, object, &mut add);
            }
        }
        score
    }

    /// The errors of a moved body with each other body; of two that moved, told by the first.
    fn pairs(&self, checker: &Checker<'_>, object: usize, add: &mut impl FnMut(Violation)) {
        let keeps_clear = |index: usize| terms::clearance_box(checker.rules, &self.bodies[index]);
        let (body, own) = (&self.bodies[object], keeps_clear(object));
        for (other, second) in self.bodies.iter().enumerate() {
            if other == object || !second.is_placed() || self.moved[other] && other < object {
                continue;
            }
            if meet(body.min, body.max, second) {
                checker.overlap(object, other).into_iter().for_each(&mut *add);
            }
            if own.is_some_and(|(min, max)| meet(min, max, second)) {
                checker.clearance(object, other).into_iter().for_each(&mut *add);
            }
            if keeps_clear(other).is_some_and(|(min, max)| meet(min, max, body)) {
                checker.clearance(other, object).into_iter().for_each(&mut *add);
            }
        }
    }

    /// What reads the moved bodies besides themselves.
    fn to_measure(&self, record: &Record, old: &[(u32, Body)]) -> Again {
        let mut again = Again::default();
        for (index, body) in self.bodies.iter().enumerate() {
            let carrier_moved = self.carriers[index].is_some_and(|carrier| self.moved[carrier as usize]);
            if body.is_placed() && body.support == Support::Standing && (self.moved[index] || carrier_moved) {
                again.standing.push(index as u32);
            }
        }
        let floating = self.violations.iter().filter(|violation| violation.kind == ErrorKind::Standing);
        let floating = floating.map(|violation| violation.culprit).filter(|culprit| !self.moved[*culprit as usize]);
        let floating: SmallVec<[u32; 8]> = floating.filter(|culprit| !again.standing.contains(culprit)).collect();
        again.standing.extend(floating);
        let facers = old.iter().flat_map(|(object, _)| &record.facers[*object as usize]);
        again.facers = facers.copied().filter(|facer| !self.moved[*facer as usize]).collect();
        again
    }

    /// The state after one more change.
    pub(super) fn after(&self, problem: &Problem, change: Change) -> Option<State> {
        let changes = self.changes.with(change, problem.tuning());
        if changes == self.changes {
            return None;
        }
        if let Change::Constant(ConstantId(id), value) = change
            && let Some(literal) = self.record.slices.index(id)
            && changes.len() >= self.changes.len()
        {
            let mut next = self.clone();
            let record = Arc::clone(&self.record);
            let slice = &record.slices.literals()[literal];
            next.replay.set(&record.trace, slice, value);
            if next.replay.holds(&record.trace, slice) {
                let old = next.place(&record, literal);
                let mut violations = Vec::new();
                next.score = next.rescore(problem, &record, &old, Some(&mut violations));
                next.violations = violations;
                next.moved.fill(false);
                next.changes = changes;
                next.carriers = (0..next.bodies.len()).map(|index| next.carrier(problem, index)).collect();
                return Some(next);
            }
        }
        State::run(problem, changes)
    }
}

/// Errors to measure again because of bodies that moved.
#[derive(Default)]
struct Again {
    standing: SmallVec<[u32; 16]>,
    facers: SmallVec<[u32; 16]>,
}

/// Whether two boxes share a point.
fn meet(min: [f64; 3], max: [f64; 3], other: &Body) -> bool {
    (0..3).all(|k| min[k] < other.max[k] && other.min[k] < max[k])
}

impl Record {
    fn of(tuning: &Tuning, ran: Ran) -> Record {
        let slices = Slices::of(&ran.trace).unwrap_or_default();
        let objects = &ran.layout.objects;
        let sliced = !slices.literals().is_empty();
        let centers: Vec<[Num; 3]> = objects
            .iter()
            .map(|object| object.center.map(|coordinate| if sliced { coordinate.num } else { Num::plain(coordinate.value()) }))
            .collect();
        let mut reached = vec![Vec::new(); slices.literals().len()];
        let mut facers = vec![Vec::new(); objects.len()];
        for (index, object) in objects.iter().enumerate() {
            for literal in centers[index].iter().flat_map(|num| slices.reaching(num.handle)) {
                let objects: &mut Vec<u32> = &mut reached[literal];
                if objects.last() != Some(&(index as u32)) {
                    objects.push(index as u32);
                }
            }
            if let Told::Toward(Target::Object(target)) = object.body.told {
                facers[target.index()].push(index as u32);
            }
        }
        let directions = objects.iter().map(|object| turned_by(tuning, &ran.layout, object.faced.map(|faced| faced.0))).collect();
        Record { bounds: Bounds::of(&ran.layout.scene), trace: ran.trace, slices, centers, reached, facers, directions }
    }
}

/// The directions in the statement that turned something and in the calls around it.
fn turned_by(tuning: &Tuning, layout: &Layout, origin: Option<crate::scene::OriginId>) -> Vec<DirectionId> {
    let Some(origin) = origin else { return Vec::new() };
    let calls = layout.origins.steps_around(origin).filter(|step| matches!(step.kind, crate::scene::StepKind::Call { .. }));
    let ranges: Vec<TextRange> = calls.map(|step| step.range).chain([layout.origins.get(origin).range]).collect();
    let inside = |range: TextRange| ranges.iter().any(|statement| statement.contains_range(range));
    let found = tuning.directions.iter().enumerate().filter(|(_, direction)| inside(direction.range));
    found.filter_map(|(at, _)| u32::try_from(at).ok()).map(DirectionId).collect()
}
