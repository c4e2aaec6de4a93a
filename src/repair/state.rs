//! A layout under correction: the record of a run, and what of it other values of a literal would change.

use std::sync::Arc;

use smallvec::{SmallVec, smallvec};

use crate::check::measure::{Bounds, Gap};
use crate::check::{Verdict, Violation, check};
use crate::scene::{Body, Kind, Layout, Outcome, Placed, Support, Target, Told};
use crate::syntax::{ConstantId, DirectionId, Tuning};
use crate::trace::{AS_WRITTEN, Handle, LiteralSlice, Num, Replay, SITE, Slices, Trace};
use ruff_text_size::TextRange;

use super::changes::{Change, Changes};
use super::measure::{Score, step, volume};
use super::problem::{Problem, Ran};
use super::rescore::{Measure, Room};

/// What one run tells about all its neighbours.
#[derive(Debug)]
pub(super) struct Record {
    trace: Arc<Trace>,
    slices: Arc<Slices>,
    /// Per object, where it stands and how it is turned.
    poses: Vec<Pose>,
    /// Per object, what the program told it to face.
    told: Vec<Told>,
    /// Per literal, the objects that it moves or turns.
    reached: Vec<Vec<u32>>,
    /// Per object, the literals that move it.
    movers: Vec<Vec<usize>>,
    /// The doors and windows, before which there must be room.
    pub(super) keepers: Vec<usize>,
    /// Per object, those that were told to face it.
    pub(super) facers: Vec<Vec<u32>>,
    /// Per object, the directions that reach it, or stand in the statements that turned it.
    directions: Vec<Vec<DirectionId>>,
    pub(super) bounds: Bounds,
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

/// What became of a candidate.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Tried {
    /// A decision of the program comes out otherwise: only a run tells.
    Flips,
    /// It was given up.
    TooMuch,
    /// What it is worth.
    Scored(Score),
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
    pub(super) boxes: Vec<Room>,
    pub(super) violations: Vec<Violation>,
    pub(super) score: Score,
    record: Arc<Record>,
    replay: Replay,
    /// Per standing body above the ground, what carries it.
    pub(super) carriers: Vec<Option<u32>>,
    pub(super) moved: Vec<bool>,
    /// What the last replay cost, in units of the budget.
    cost: usize,
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
        let slices = Arc::new(Slices::of(&ran.trace).unwrap_or_default());
        let record = Record::of(problem.tuning(), &ran.layout, ran.trace, slices);
        State::recorded(problem, changes, &ran.layout, &verdict, record)
    }

    /// The program as it is.
    pub(super) fn original(problem: &Problem) -> State {
        let (trace, slices) = problem.record();
        let record = Record::of(problem.tuning(), problem.layout(), trace, slices);
        State::recorded(problem, Changes::default(), problem.layout(), problem.verdict(), record)
    }

    fn recorded(problem: &Problem, changes: Changes, layout: &Layout, verdict: &Verdict, record: Record) -> State {
        let score = score_with(problem, layout, verdict);
        let (bodies, record) = (layout.bodies(), Arc::new(record));
        let moved = vec![false; bodies.len()];
        let mut state = State {
            changes,
            violations: verdict.counted().copied().collect(),
            score,
            replay: Replay::new(&record.trace),
            carriers: Vec::new(),
            moved,
            record,
            boxes: bodies.iter().map(Room::of).collect(),
            cost: 0,
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
    pub(super) fn movers(&self, object: usize) -> &[usize] {
        &self.record.movers[object]
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
        match self.tried(problem, values, None, &|_| false) {
            Tried::Scored(score) => Some(score),
            _ => None,
        }
    }

    /// The same, given up as soon as what is known of the score is too much: it only grows.
    pub(super) fn try_within(&mut self, problem: &Problem, values: &[(usize, f64)], too_much: &dyn Fn(&Score) -> bool) -> Tried {
        self.tried(problem, values, None, too_much)
    }

    /// The same with the errors that there would be.
    pub(super) fn try_errors(&mut self, problem: &Problem, literal: usize, value: f64) -> Option<(Score, Vec<Violation>)> {
        let mut errors = Vec::new();
        match self.tried(problem, &[(literal, value)], Some(&mut errors), &|_| false) {
            Tried::Scored(score) => Some((score, errors)),
            _ => None,
        }
    }

    fn tried(
        &mut self,
        problem: &Problem,
        values: &[(usize, f64)],
        keep: Option<&mut Vec<Violation>>,
        too_much: &dyn Fn(&Score) -> bool,
    ) -> Tried {
        let record = Arc::clone(&self.record);
        if !self.set(&record, values) {
            self.replay.undo();
            self.cost = 1;
            return Tried::Flips;
        }
        let mut old = Vec::new();
        values.iter().for_each(|(literal, _)| self.place(&record, *literal, &mut old));
        let again = self.to_measure(&record, &old);
        let mut measure = Measure { keep, too_much, bodies: 0 };
        let score = self.rescore(problem, &record, &old, &again, &mut measure);
        let slices = values.iter().map(|(literal, _)| &self.literals()[*literal]);
        let replayed: usize = slices.map(|slice| slice.nodes.len() + slice.guards.len()).sum();
        self.cost = 1 + replayed / 64 + measure.bodies * self.bodies.len() / 512;
        for (object, body) in old {
            self.bodies[object as usize] = body;
            self.boxes[object as usize] = Room::of(&body);
            self.moved[object as usize] = false;
        }
        self.replay.undo();
        score.map_or(Tried::TooMuch, Tried::Scored)
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
                self.boxes[object as usize] = Room::of(body);
                self.moved[object as usize] = true;
            }
        }
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
        let again = next.to_measure(&record, &old);
        let mut measure = Measure { keep: Some(&mut violations), ..Measure::ALL };
        next.score = next.rescore(problem, &record, &old, &again, &mut measure)?;
        next.violations = violations;
        next.moved.fill(false);
        next.changes = changes.clone();
        for index in again.standing {
            next.carriers[index as usize] = next.carrier(problem, index as usize);
        }
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

    /// What the last replay cost, in units of the budget: more for long slices and for many objects.
    pub(super) fn replay_cost(&self) -> usize {
        self.cost
    }

    /// How many objects a literal reaches.
    pub(super) fn reach(&self, literal: usize) -> usize {
        self.record.reached[literal].len()
    }

    /// Whether a literal reaches an object.
    pub(super) fn reaches(&self, literal: usize, object: usize) -> bool {
        self.record.reached[literal].contains(&(object as u32))
    }
}

impl Record {
    fn of(tuning: &Tuning, layout: &Layout, trace: Arc<Trace>, slices: Arc<Slices>) -> Record {
        let objects = &layout.objects;
        let sliced = !slices.literals().is_empty();
        let known = |num: Num| if sliced { num } else { Num::plain(num.value) };
        let pose = |object: &Placed| Pose {
            center: object.center.map(|coordinate| known(coordinate.num)),
            settled: known(object.settled),
            instead: known(object.instead),
        };
        let poses: Vec<Pose> = objects.iter().map(pose).collect();
        let told = objects.iter().map(|object| object.body.told).collect();
        let movers = |pose: &Pose| {
            let mut movers: Vec<usize> = pose.center.iter().flat_map(|num| slices.reaching(num.handle)).collect();
            movers.sort_unstable();
            movers.dedup();
            movers
        };
        let movers = poses.iter().map(movers).collect();
        let keepers = (0..objects.len()).filter(|index| objects[*index].body.kind != Kind::Object).collect();
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
            let mut directions = turned_by(tuning, layout, object.faced.map(|faced| faced.0));
            directions.extend(sites(index));
            directions.sort_unstable();
            directions.dedup();
            directions
        };
        let directions = objects.iter().enumerate().map(turned_by).collect();
        Record { bounds: Bounds::of(&layout.scene), trace, slices, poses, told, reached, movers, keepers, facers, directions }
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
