//! A layout under correction: the record of a run, and what of it other values of a literal would change.

use std::sync::Arc;

use smallvec::{SmallVec, smallvec};

use crate::check::measure::{self as terms, Bounds, Gap};
use crate::check::{Checker, ErrorKind, Verdict, Violation, check};
use crate::scene::{Body, Layout, Outcome, Placed, Support, Target, Told};
use crate::syntax::{ConstantId, DirectionId, Tuning};
use crate::trace::{AS_WRITTEN, Handle, LiteralSlice, Num, Replay, SITE, Slices, Trace};
use ruff_text_size::TextRange;

use super::changes::{Change, Changes};
use super::measure::{Score, step, volume};
use super::problem::{Problem, Ran};

/// What one run tells about all its neighbours.
#[derive(Debug)]
struct Record {
    trace: Trace,
    slices: Slices,
    /// Per object, where it stands and how it is turned.
    poses: Vec<Pose>,
    /// Per object, what the program told it to face.
    told: Vec<Told>,
    /// Per literal, the objects that it moves or turns.
    reached: Vec<Vec<u32>>,
    /// Per object, those that were told to face it.
    facers: Vec<Vec<u32>>,
    /// Per object, the directions that reach it, or stand in the statements that turned it.
    directions: Vec<Vec<DirectionId>>,
    bounds: Bounds,
}

/// The numbers of a body.
#[derive(Clone, Copy, Debug)]
struct Pose {
    center: [Num; 3],
    settled: Num,
    instead: Num,
}

impl Pose {
    fn handles(&self) -> impl Iterator<Item = Handle> + use<> {
        [self.center[0], self.center[1], self.center[2], self.settled, self.instead].into_iter().map(|num| num.handle)
    }
}

/// New values for literals of a record.
pub(super) type Values = SmallVec<[(usize, f64); 2]>;

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
    score_with(problem, layout, &check(layout, &problem.options().rules))
}

fn score_with(problem: &Problem, layout: &Layout, verdict: &Verdict) -> Score {
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
        let verdict = check(&ran.layout, &problem.options().rules);
        let score = score_with(problem, &ran.layout, &verdict);
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
        self.record.poses[object].center.iter().flat_map(|num| self.record.slices.reaching(num.handle))
    }

    /// The directions that reach an object, or stand in the statements that turned it.
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
            let (now, then) = (record.poses[*object as usize].center, self.bodies[*object as usize].center);
            (*object, [0, 1, 2].map(|k| (self.replay.now(now[k]) - then[k]) / NEAR))
        };
        let slopes = record.reached[literal].iter().map(slope).collect();
        self.replay.undo();
        slopes
    }

    /// The literal of the record that a change gives a value, where there is one.
    pub(super) fn replays(&self, change: Change) -> Option<(usize, f64)> {
        match change {
            Change::Constant(ConstantId(id), value) => Some((self.record.slices.index(id)?, value)),
            Change::Turn(DirectionId(id), cardinal) => Some((self.record.slices.index(id | SITE)?, f64::from(cardinal as u8))),
        }
    }

    /// What other values of literals would give, by replay; `None` where a decision of the program comes out otherwise.
    pub(super) fn try_values(&mut self, problem: &Problem, values: &[(usize, f64)]) -> Option<Score> {
        self.tried(problem, values, None)
    }

    /// The same with the errors that there would be.
    pub(super) fn try_errors(&mut self, problem: &Problem, literal: usize, value: f64) -> Option<(Score, Vec<Violation>)> {
        let mut errors = Vec::new();
        let score = self.tried(problem, &[(literal, value)], Some(&mut errors))?;
        Some((score, errors))
    }

    fn tried(&mut self, problem: &Problem, values: &[(usize, f64)], keep: Option<&mut Vec<Violation>>) -> Option<Score> {
        let record = Arc::clone(&self.record);
        if !self.set(&record, values) {
            self.replay.undo();
            return None;
        }
        let mut old = Vec::new();
        values.iter().for_each(|(literal, _)| self.place(&record, *literal, &mut old));
        let score = self.rescore(problem, &record, &old, keep);
        for (object, body) in old {
            self.bodies[object as usize] = body;
            self.moved[object as usize] = false;
        }
        self.replay.undo();
        Some(score)
    }

    /// Replays some values; false where a decision of the program comes out otherwise.
    fn set(&mut self, record: &Record, values: &[(usize, f64)]) -> bool {
        let slices = record.slices.literals();
        for (at, (literal, value)) in values.iter().enumerate() {
            match at {
                0 => self.replay.set(&record.trace, &slices[*literal], *value),
                _ => self.replay.set_too(&record.trace, &slices[*literal], *value),
            }
        }
        values.iter().all(|(literal, _)| self.replay.holds(&record.trace, &slices[*literal]))
    }

    /// Moves the bodies that a literal reaches to where the replay has them; `old` gets those that were elsewhere before.
    fn place(&mut self, record: &Record, literal: usize, old: &mut Vec<(u32, Body)>) {
        for &object in &record.reached[literal] {
            let (body, pose) = (&mut self.bodies[object as usize], &record.poses[object as usize]);
            let center = pose.center.map(|num| self.replay.now(num));
            let outcome = Outcome::from_code(self.replay.now(pose.settled));
            let told = if self.replay.now(pose.instead) >= 0.0 { Told::Direction } else { record.told[object as usize] };
            let turned = outcome.turn != body.turn || outcome.directed != body.directed || told != body.told;
            if turned || center != body.center {
                old.push((object, *body));
                *body = Body { turn: outcome.turn, directed: outcome.directed, told, ..*body }.at(center);
                self.moved[object as usize] = true;
            }
        }
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
        if changes == self.changes { None } else { self.to(problem, changes) }
    }

    /// The state with other changes: by replay if it may be, else by a run.
    pub(super) fn to(&self, problem: &Problem, changes: Changes) -> Option<State> {
        self.replayed(problem, &changes).or_else(|| State::run(problem, changes))
    }

    /// The state with other changes by replay; `None` where a decision of the program comes out otherwise.
    pub(super) fn replayed(&self, problem: &Problem, changes: &Changes) -> Option<State> {
        let values = self.values_to(problem, changes)?;
        let record = Arc::clone(&self.record);
        let mut next = self.clone();
        if !next.set(&record, &values) {
            return None;
        }
        let (mut old, mut violations) = (Vec::new(), Vec::new());
        values.iter().for_each(|(literal, _)| next.place(&record, *literal, &mut old));
        next.score = next.rescore(problem, &record, &old, Some(&mut violations));
        next.violations = violations;
        next.moved.fill(false);
        next.changes = changes.clone();
        next.carriers = (0..next.bodies.len()).map(|index| next.carrier(problem, index)).collect();
        Some(next)
    }

    /// The values by which the record gets to other changes; `None` where one is not in it.
    pub(super) fn values_to(&self, problem: &Problem, changes: &Changes) -> Option<Values> {
        let mut values: Values = smallvec![];
        let literals = self.record.slices.literals();
        for (id, _) in self.changes.constants().filter(|(id, _)| changes.constant(*id).is_none()) {
            values.push((self.record.slices.index(id.0)?, problem.tuning().constant(id)?.value));
        }
        for (id, _) in self.changes.turns().filter(|(id, _)| changes.turn(*id).is_none()) {
            let literal = self.record.slices.index(id.0 | SITE)?;
            // A run that put a turn in the place of a direction has not recorded what is written there.
            if literals[literal].value != AS_WRITTEN {
                return None;
            }
            values.push((literal, AS_WRITTEN));
        }
        for change in changes.iter() {
            if self.changes.iter().all(|own| own != change) {
                values.push(self.replays(change)?);
            }
        }
        Some(values)
    }

    /// What one replay of a literal costs, in units of the budget: more for long slices and for many objects.
    pub(super) fn replay_cost(&self, values: &[(usize, f64)]) -> usize {
        let of = |literal: usize| {
            let (slice, reached) = (&self.literals()[literal], self.record.reached[literal].len());
            (slice.nodes.len() + slice.guards.len()) / 64 + reached * self.bodies.len() / 512
        };
        1 + values.iter().map(|(literal, _)| of(*literal)).sum::<usize>()
    }

    /// Whether a literal reaches an object.
    pub(super) fn reaches(&self, literal: usize, object: usize) -> bool {
        self.record.reached[literal].contains(&(object as u32))
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
        let known = |num: Num| if sliced { num } else { Num::plain(num.value) };
        let pose = |object: &Placed| Pose {
            center: object.center.map(|coordinate| known(coordinate.num)),
            settled: known(object.settled),
            instead: known(object.instead),
        };
        let poses: Vec<Pose> = objects.iter().map(pose).collect();
        let told = objects.iter().map(|object| object.body.told).collect();
        let mut reached = vec![Vec::new(); slices.literals().len()];
        let mut facers = vec![Vec::new(); objects.len()];
        for (index, object) in objects.iter().enumerate() {
            for literal in poses[index].handles().flat_map(|handle| slices.reaching(handle)) {
                let objects: &mut Vec<u32> = &mut reached[literal];
                if objects.last() != Some(&(index as u32)) {
                    objects.push(index as u32);
                }
            }
            if let Told::Toward(Target::Object(target)) = object.body.told {
                facers[target.index()].push(index as u32);
            }
        }
        let sites = |index: usize| {
            let literals = poses[index].handles().flat_map(|handle| slices.reaching(handle)).map(|literal| slices.literals()[literal].id);
            literals.filter(|id| *id >= SITE).map(|id| DirectionId(id - SITE))
        };
        let turned_by = |(index, object): (usize, &Placed)| {
            let mut directions = turned_by(tuning, &ran.layout, object.faced.map(|faced| faced.0));
            directions.extend(sites(index));
            directions.sort_unstable();
            directions.dedup();
            directions
        };
        let directions = objects.iter().enumerate().map(turned_by).collect();
        Record { bounds: Bounds::of(&ran.layout.scene), trace: ran.trace, slices, poses, told, reached, facers, directions }
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
