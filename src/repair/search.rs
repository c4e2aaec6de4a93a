//! A search under way: what it may spend, what it compares, and the changes that it tries.

use std::sync::atomic::Ordering;

use crate::check::Violation;
use crate::syntax::ConstantId;

use rustc_hash::{FxHashMap, FxHashSet};
use smallvec::SmallVec;

use crate::trace::SITE;

use super::changes::{Change, Changes};
use super::guided::{Site, WEIGHTS};
use super::measure::{Score, volume};
use super::problem::Problem;
use super::proposals;
use super::state::{State, Tried, score_of};
use super::{Effort, Method, Settings};

/// Of the best candidates so many are looked at again: where they run into something else, the same literal may go elsewhere.
const CHAINED: usize = 4;

/// So many of the errors that a candidate runs into are looked at.
const ERRORS_ON_THE_WAY: usize = 4;

/// A search under way.
pub(super) struct Search<'a> {
    pub(super) problem: &'a Problem,
    pub(super) settings: &'a Settings,
    pub(super) effort: Effort,
    /// How much of the budget may be spent by now.
    pub(super) limit: usize,
    pub(super) spent: usize,
    /// What an error, a mean displacement of a metre, and moving every object weigh against the loss.
    pub(super) weights: [f64; 3],
    /// What is left alone for now.
    pub(super) locked: SmallVec<[Site; 2]>,
    /// Nothing is tried that takes a run.
    pub(super) replays_only: bool,
    /// What runs gave.
    known: FxHashMap<Key, Option<Score>>,
    /// Changes whose runs did no good.
    hopeless: FxHashSet<(u32, u64)>,
    volume: f64,
}

/// A change and what it gives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub(super) change: Change,
    pub(super) score: Score,
}

/// Changes in a form that can be looked up: for each, what it rewrites and the bits that it writes.
type Key = SmallVec<[(u32, u64); 8]>;

fn key_of(change: Change) -> (u32, u64) {
    match change {
        Change::Constant(id, value) => (id.0, value.to_bits()),
        Change::Turn(id, cardinal) => (id.0 | SITE, cardinal as u64),
    }
}

impl<'a> Search<'a> {
    pub(super) fn new(problem: &'a Problem, settings: &'a Settings) -> Search<'a> {
        let objects = &problem.layout().objects;
        let volume = objects.iter().map(|object| volume(&object.body)).sum::<f64>().max(f64::MIN_POSITIVE);
        let (effort, limit) = (Effort::default(), settings.budget);
        Search {
            problem,
            settings,
            effort,
            limit,
            spent: 0,
            weights: WEIGHTS[0],
            locked: SmallVec::new(),
            replays_only: false,
            known: FxHashMap::default(),
            hopeless: FxHashSet::default(),
            volume,
        }
    }

    /// Whether anything may still be tried.
    pub(super) fn goes_on(&self) -> bool {
        let cancelled = self.settings.watch.as_ref().is_some_and(|watch| {
            watch.spent.store(self.spent, Ordering::Relaxed);
            watch.cancelled.load(Ordering::Relaxed)
        });
        !cancelled && self.spent < self.limit
    }

    /// What the search minimises step by step.
    pub(super) fn cost(&self, score: &Score) -> f64 {
        let [error, way, moved] = self.weights;
        score.loss as f64 + error * score.count as f64 + self.movement(score, way, moved)
    }

    fn movement(&self, score: &Score, way: f64, moved: f64) -> f64 {
        let objects = self.problem.layout().objects.len().max(1) as f64;
        way * score.work / self.volume + moved * score.moved as f64 / objects
    }

    /// Fewer weighted errors first, then fewer edits, then less movement.
    pub(super) fn is_better(&self, new: &State, old: &State) -> bool {
        let rank = |state: &State| (self.loss_worked_on(state), state.changes.len());
        let movement = |state: &State| self.movement(&state.score, 1.0, 1.0);
        match rank(new).cmp(&rank(old)) {
            std::cmp::Ordering::Less => new.score.count <= self.problem.verdict().counted().count(),
            std::cmp::Ordering::Equal => new.score.count <= old.score.count && movement(new) < movement(old) - 1e-4,
            std::cmp::Ordering::Greater => false,
        }
    }

    /// The loss of the errors that are worked on: an edit that only clears others is not asked for.
    fn loss_worked_on(&self, state: &State) -> u64 {
        match self.settings.only.as_slice() {
            [] => state.score.loss,
            _ => self.targets(state).iter().map(|violation| violation.loss).sum(),
        }
    }

    /// Whether nothing gets worse, neither in all nor in what is worked on.
    pub(super) fn is_as_clean(&self, new: &State, old: &State) -> bool {
        new.score.is_as_clean_as(&old.score) && self.loss_worked_on(new) <= self.loss_worked_on(old)
    }

    /// The errors that are worked on.
    pub(super) fn targets(&self, state: &State) -> Vec<Violation> {
        state.violations.iter().filter(|violation| self.is_target(violation)).copied().collect()
    }

    fn is_target(&self, violation: &Violation) -> bool {
        let only = &self.settings.only;
        only.is_empty() || only.contains(&violation.kind)
    }

    /// What a change of a state gives: by replay if it may be, else by a run.
    pub(super) fn try_change(&mut self, state: &mut State, change: Change) -> Option<Score> {
        self.try_within(state, change, f64::INFINITY)
    }

    /// What a change of a state gives, unless it costs more than `most`.
    fn try_within(&mut self, state: &mut State, change: Change, most: f64) -> Option<Score> {
        if !self.goes_on() {
            return None;
        }
        let Some(value) = state.replays(change) else { return self.run_from(state, change) };
        match self.replay(state, &[value], most) {
            Tried::Scored(score) => Some(score),
            Tried::TooMuch => None,
            Tried::Flips => {
                self.spent += 1;
                self.run_from(state, change)
            }
        }
    }

    /// Replays values, and counts that where it tells something.
    fn replay(&mut self, state: &mut State, values: &[(usize, f64)], most: f64) -> Tried {
        let tried = state.try_within(self.problem, values, &|score| self.cost(score) > most);
        if tried != Tried::Flips {
            self.effort.evaluations += 1;
            self.effort.replays += 1;
            self.spent += state.replay_cost();
        }
        tried
    }

    /// What a run with one more change gives, unless such a run did no good before: the paper's search knows no such rule.
    fn run_from(&mut self, state: &State, change: Change) -> Option<Score> {
        if self.settings.method == Method::Guided && self.hopeless.contains(&key_of(change)) {
            return None;
        }
        let score = self.run(&state.changes.with(change, self.problem.tuning()));
        if !self.replays_only && score.is_none_or(|score| score.loss >= state.score.loss) {
            self.hopeless.insert(key_of(change));
        }
        score
    }

    /// What other changes than those of a state give.
    pub(super) fn try_changes(&mut self, state: &mut State, changes: &Changes) -> Option<Score> {
        if !self.goes_on() {
            return None;
        }
        let Some(values) = state.values_to(self.problem, changes) else { return self.run(changes) };
        match self.replay(state, &values, f64::INFINITY) {
            Tried::Scored(score) => Some(score),
            Tried::TooMuch | Tried::Flips => self.run(changes),
        }
    }

    /// The score of a run with changes; each is run once.
    fn run(&mut self, changes: &Changes) -> Option<Score> {
        let key: Key = changes.iter().map(key_of).collect();
        if let Some(known) = self.known.get(&key) {
            self.spent += 1;
            return *known;
        }
        if self.replays_only {
            self.spent += 1;
            return None;
        }
        self.effort.evaluations += 1;
        self.count_run();
        let ran = self.problem.run(changes, false);
        let score = ran.map(|ran| score_of(self.problem, &ran.layout));
        self.known.insert(key, score);
        score
    }

    fn count_run(&mut self) {
        self.effort.runs += 1;
        self.spent += self.problem.run_cost();
    }

    /// The state with other changes.
    pub(super) fn go(&mut self, state: &State, changes: Changes) -> Option<State> {
        if let Some(next) = state.replayed(self.problem, &changes) {
            self.effort.replays += 1;
            self.spent += 2 + self.problem.layout().objects.len() / 8;
            return Some(next);
        }
        if self.replays_only {
            return None;
        }
        self.count_run();
        State::run(self.problem, changes)
    }

    /// The state after one more change, unless that changes nothing.
    pub(super) fn follow(&mut self, state: &State, change: Change) -> Option<State> {
        let changes = state.changes.with(change, self.problem.tuning());
        if changes == state.changes { None } else { self.go(state, changes) }
    }

    /// What clears an error of a state, cheapest first: at least the `enough` cheapest.
    pub(super) fn expand(&mut self, state: &mut State, errors: &[Violation], wide: bool, enough: usize) -> Vec<Candidate> {
        let mut changes = proposals::turns(self.problem, self.settings, state, errors);
        for proposal in proposals::constants(self.problem, self.settings, state, errors, wide) {
            changes.push(Change::Constant(ConstantId(state.literals()[proposal.literal].id), proposal.value));
        }
        // What moves little is measured first: the rest is then given up sooner.
        changes.sort_by_key(|change| state.replays(*change).map_or(usize::MAX, |(literal, _)| state.reach(literal)));
        let mut found = Vec::new();
        self.try_all(state, changes, &mut found, enough);
        self.chain(state, &mut found, enough);
        found
    }

    /// Tries changes and sorts all that was found by cost.
    fn try_all(&mut self, state: &mut State, changes: Vec<Change>, found: &mut Vec<Candidate>, enough: usize) {
        let mut best: SmallVec<[f64; 64]> = found.iter().map(|found| self.cost(&found.score)).take(enough).collect();
        for change in changes {
            if self.locked.contains(&change.site()) {
                continue;
            }
            let most = if best.len() < enough { f64::INFINITY } else { best[enough - 1] };
            let Some(score) = self.try_within(state, change, most) else { continue };
            let cost = self.cost(&score);
            if cost <= most {
                best.insert(best.partition_point(|known| *known <= cost), cost);
                best.truncate(enough);
            }
            found.push(Candidate { change, score });
        }
        found.sort_by(|a, b| self.cost(&a.score).total_cmp(&self.cost(&b.score)));
    }

    /// Where the best candidates run into something else: the values of the same literals that clear that too.
    fn chain(&mut self, state: &mut State, found: &mut Vec<Candidate>, enough: usize) {
        let mut more = Vec::new();
        let constants = found.iter().filter(|found| matches!(found.change, Change::Constant(..)) && found.score.count > 0);
        for change in constants.take(CHAINED).map(|found| found.change).collect::<Vec<_>>() {
            let Some((literal, value)) = state.replays(change) else { continue };
            let changes = state.changes.with(change, self.problem.tuning());
            let Some(mut there) = state.replayed(self.problem, &changes) else { continue };
            self.spent += 2;
            let in_the_way = |violation: &&Violation| violation.objects().any(|object| there.reaches(literal, object));
            let errors: Vec<Violation> = there.violations.iter().filter(in_the_way).take(ERRORS_ON_THE_WAY).copied().collect();
            for found in proposals::of_literal(self.problem, &mut there, &errors, literal) {
                if (found - value).abs() > 1e-6 {
                    more.push(Change::Constant(ConstantId(state.literals()[literal].id), found));
                }
            }
        }
        self.try_all(state, more, found, enough);
    }
}
