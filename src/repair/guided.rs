//! The default search: exact proposals, steepest descent, a beam where single edits stall, and a tidy end.

use std::sync::atomic::Ordering;

use rustc_hash::FxHashSet;

use crate::check::Violation;
use crate::syntax::ConstantId;

use super::changes::{Change, Changes};
use super::measure::{Score, volume};
use super::problem::Problem;
use super::proposals;
use super::state::{State, score_of};
use super::{Effort, Settings, refine};

/// How many candidates a run may cost one evaluation of a replay more than.
const RUN_COST: usize = 20;

/// States that are followed at once where single edits stall, and how deep.
const BEAM: usize = 6;
const DEPTH: usize = 3;

/// Candidates that are kept of one state, at most so many of one literal or direction.
const OFFSPRING: usize = 12;

/// What the descents weigh against the loss, one after the other until one comes to its end: an error, a mean displacement of a metre,
/// and moving every object.
const WEIGHTS: [[f64; 3]; 3] = [[8.0, 20.0, 20.0], [0.0, 0.0, 0.0], [20.0, 60.0, 60.0]];

/// A search under way: the program, and what was spent on it.
pub(super) struct Search<'a> {
    pub(super) problem: &'a Problem,
    pub(super) settings: &'a Settings,
    pub(super) effort: Effort,
    spent: usize,
    volume: f64,
    weights: [f64; 3],
    /// What one replay costs in evaluations: more in scenes of thousands of objects.
    replay_cost: usize,
}

/// A change and what it gives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub(super) change: Change,
    pub(super) score: Score,
}

/// Looks for a correction.
pub(super) fn search(problem: &Problem, settings: &Settings) -> (Changes, Effort) {
    let mut search = Search::new(problem, settings);
    let Some(start) = State::run(problem, Changes::default()) else { return (Changes::default(), search.effort) };
    let mut best: Option<State> = None;
    for weights in WEIGHTS {
        search.weights = weights;
        let found = search.descend(start.clone());
        search.weights = WEIGHTS[0];
        let found = refine::refine(&mut search, found);
        let rank = |state: &State| (state.score.loss, state.changes.len());
        let better = best.as_ref().is_none_or(|best| rank(&found) < rank(best));
        best = if better { Some(found) } else { best };
        if !search.goes_on() || best.as_ref().is_some_and(|best| search.targets(best).is_empty()) {
            break;
        }
    }
    (best.map(|best| best.changes).unwrap_or_default(), search.effort)
}

impl<'a> Search<'a> {
    pub(super) fn new(problem: &'a Problem, settings: &'a Settings) -> Search<'a> {
        let objects = &problem.layout().objects;
        let volume = objects.iter().map(|object| volume(&object.body)).sum::<f64>().max(f64::MIN_POSITIVE);
        let (effort, weights) = (Effort::default(), WEIGHTS[0]);
        Search { problem, settings, effort, spent: 0, volume, weights, replay_cost: 1 + objects.len() / 500 }
    }

    /// Whether anything may still be tried.
    pub(super) fn goes_on(&self) -> bool {
        let cancelled = self.settings.watch.as_ref().is_some_and(|watch| {
            watch.spent.store(self.spent, Ordering::Relaxed);
            watch.cancelled.load(Ordering::Relaxed)
        });
        !cancelled && self.spent < self.settings.budget
    }

    /// What the search minimises step by step.
    pub(super) fn cost(&self, score: &Score) -> f64 {
        let objects = self.problem.layout().objects.len().max(1) as f64;
        let [error, way, moved] = self.weights;
        score.loss as f64 + error * score.count as f64 + way * score.work / self.volume + moved * score.moved as f64 / objects
    }

    /// The errors that are worked on.
    pub(super) fn targets(&self, state: &State) -> Vec<Violation> {
        let only = &self.settings.only;
        state.violations.iter().filter(|violation| only.is_empty() || only.contains(&violation.kind)).copied().collect()
    }

    /// What a change of a state gives: by replay if it may be, else by a run.
    pub(super) fn try_change(&mut self, state: &mut State, change: Change) -> Option<Score> {
        if !self.goes_on() {
            return None;
        }
        self.effort.evaluations += 1;
        if let Change::Constant(ConstantId(id), value) = change {
            let literal = state.literals().binary_search_by_key(&id, |slice| slice.id).ok();
            if let Some(score) = literal.and_then(|literal| state.try_literal(self.problem, literal, value)) {
                self.effort.replays += 1;
                self.spent += self.replay_cost;
                return Some(score);
            }
        }
        self.run(&state.changes.with(change, self.problem.tuning()))
    }

    /// The score of a run with changes.
    pub(super) fn run(&mut self, changes: &Changes) -> Option<Score> {
        self.effort.runs += 1;
        self.spent += RUN_COST * self.replay_cost;
        let ran = self.problem.run(changes, false)?;
        Some(score_of(self.problem, &ran.layout))
    }

    /// All that clears an error of a state, cheapest first.
    pub(super) fn expand(&mut self, state: &mut State, errors: &[Violation], wide: bool) -> Vec<Candidate> {
        let mut changes = proposals::turns(self.problem, self.settings, state, errors);
        for proposal in proposals::constants(self.problem, self.settings, state, errors, wide) {
            changes.push(Change::Constant(ConstantId(state.literals()[proposal.literal].id), proposal.value));
        }
        let mut found = Vec::new();
        for change in changes {
            if let Some(score) = self.try_change(state, change) {
                found.push(Candidate { change, score });
            }
        }
        found.sort_by(|a, b| self.cost(&a.score).total_cmp(&self.cost(&b.score)));
        found
    }

    /// From a state to the best that is found, step by step.
    fn descend(&mut self, start: State) -> State {
        let mut best = start;
        loop {
            while let Some(next) = self.step(&mut best) {
                best = next;
            }
            match self.look_ahead(&best) {
                Some(next) => best = next,
                None => return best,
            }
        }
    }

    /// The best single change, if it is an improvement.
    fn step(&mut self, state: &mut State) -> Option<State> {
        let errors = self.targets(state);
        if errors.is_empty() || state.changes.len() >= self.settings.max_edits {
            return None;
        }
        let found = self.expand(state, &errors, false);
        let better = found.into_iter().filter(|found| self.improves(&found.score, &state.score));
        better.take(3).find_map(|found| state.after(self.problem, found.change))
    }

    /// Whether a score is worth another edit.
    fn improves(&self, new: &Score, old: &Score) -> bool {
        new.loss < old.loss && new.count <= old.count.max(self.problem.verdict().counted().count())
    }

    /// Follows several states at once, better or not, until one of them is an improvement.
    fn look_ahead(&mut self, start: &State) -> Option<State> {
        let errors = self.targets(start);
        if errors.is_empty() || start.changes.len() >= self.settings.max_edits {
            return None;
        }
        let mut frontier = vec![start.clone()];
        let mut seen: FxHashSet<(u64, usize, u64)> = FxHashSet::default();
        for depth in 0..DEPTH {
            let mut next: Vec<(usize, Candidate)> = Vec::new();
            for (parent, state) in frontier.iter_mut().enumerate() {
                let errors = self.targets(state);
                let found = self.expand(state, &errors, depth == 0 || state.violations.len() < 8);
                next.extend(varied(found).map(|found| (parent, found)));
            }
            next.sort_by(|a, b| self.cost(&a.1.score).total_cmp(&self.cost(&b.1.score)));
            let better = next.iter().filter(|(_, found)| self.improves(&found.score, &start.score));
            if let Some(state) = better.take(3).find_map(|(parent, found)| frontier[*parent].after(self.problem, found.change)) {
                return Some(state);
            }
            next.retain(|(_, found)| seen.insert((found.score.loss, found.score.count, found.score.work.to_bits())));
            let room = |state: &State| state.changes.len() < self.settings.max_edits;
            frontier = next
                .iter()
                .filter_map(|(parent, found)| frontier[*parent].after(self.problem, found.change))
                .filter(room)
                .take(BEAM)
                .collect();
            if !self.goes_on() {
                break;
            }
        }
        None
    }
}

/// The first candidates, but few of each literal or direction.
fn varied(found: Vec<Candidate>) -> impl Iterator<Item = Candidate> {
    let mut seen: Vec<(bool, u32)> = Vec::new();
    let site = |change: Change| match change {
        Change::Constant(id, _) => (true, id.0),
        Change::Turn(id, _) => (false, id.0),
    };
    found
        .into_iter()
        .filter(move |found| {
            let site = site(found.change);
            seen.push(site);
            seen.iter().filter(|other| **other == site).count() <= 2
        })
        .take(OFFSPRING)
}
