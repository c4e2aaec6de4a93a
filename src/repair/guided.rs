//! The default search: exact proposals, steepest descent, a beam where single edits stall, and other plans tried at the end.

use crate::syntax::{ConstantId, DirectionId};

use super::changes::{Change, Changes};
use super::measure::Score;
use super::problem::Problem;
use super::search::{Candidate, Search};
use super::state::State;
use super::{Effort, Settings, refine};
use rustc_hash::FxHashSet;

/// States that are followed at once where nothing else helps, and how deep.
const BEAM: usize = 6;
const DEPTH: usize = 3;

/// Candidates that are kept of one state, at most so many of one literal or direction.
const OFFSPRING: usize = 12;

/// So many of the cheapest candidates of a state are measured to the end: where one is to be followed, and where several are.
const FEW: usize = 6;
const MANY: usize = 40;

/// What the descents weigh against the loss, one after the other: an error, a mean displacement of a metre, and moving every object.
pub(super) const WEIGHTS: [[f64; 3]; 3] = [[8.0, 60.0, 200.0], [8.0, 20.0, 20.0], [0.0, 20.0, 200.0]];

/// Units of the budget that are spent on a program without errors left, to do with fewer edits and less movement.
const POLISH: usize = 5000;

/// Looks for a correction.
pub(super) fn search(problem: &Problem, settings: &Settings) -> (Changes, Effort) {
    let mut search = Search::new(problem, settings);
    let start = State::original(problem);
    search.limit = settings.budget - settings.budget / 7;
    let mut best = start.clone();
    for weights in WEIGHTS {
        search.weights = weights;
        let found = search.walk(start.clone());
        let found = refine::drop_unneeded(&mut search, found);
        if search.is_better(&found, &best) {
            best = found;
        }
    }
    search.weights = WEIGHTS[0];
    best = search.go_on_from(best);
    search.limit = settings.budget;
    let best = refine::refine(&mut search, best);
    (best.changes, search.effort)
}

/// What a change rewrites, whatever it writes there.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Site {
    Constant(ConstantId),
    Direction(DirectionId),
}

impl Change {
    pub(super) fn site(self) -> Site {
        match self {
            Change::Constant(id, _) => Site::Constant(id),
            Change::Turn(id, _) => Site::Direction(id),
        }
    }
}

impl Search<'_> {
    /// Other plans; where they find nothing more and errors are left, several edits at once.
    fn go_on_from(&mut self, mut best: State) -> State {
        loop {
            if self.targets(&best).is_empty() {
                self.limit = self.limit.min(self.spent + POLISH);
            }
            best = self.improve(best);
            if !self.goes_on() || self.targets(&best).is_empty() {
                return best;
            }
            let Some(next) = self.look_ahead(&best) else { return best };
            let next = self.walk(next);
            best = refine::drop_unneeded(self, next);
        }
    }

    /// Single changes while they are improvements.
    fn walk(&mut self, mut state: State) -> State {
        while let Some(next) = self.step(&mut state) {
            state = next;
        }
        state
    }

    /// The best single change, if it is an improvement.
    fn step(&mut self, state: &mut State) -> Option<State> {
        let errors = self.targets(state);
        if errors.is_empty() || state.changes.len() >= self.settings.max_edits {
            return None;
        }
        let found = self.expand(state, &errors, false, FEW);
        let better: Vec<Candidate> = found.into_iter().filter(|found| self.improves(&found.score, &state.score)).take(3).collect();
        better.into_iter().find_map(|found| self.follow(state, found.change))
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
                // Far from where a step was to be made, what takes a run costs more than it finds.
                self.replays_only = depth > 0;
                let found = self.expand(state, &errors, depth == 0 || state.violations.len() < 8, MANY);
                self.replays_only = false;
                next.extend(varied(found).map(|found| (parent, found)));
            }
            next.sort_by(|a, b| self.cost(&a.1.score).total_cmp(&self.cost(&b.1.score)));
            let better: Vec<_> = next.iter().filter(|(_, found)| self.improves(&found.score, &start.score)).take(3).copied().collect();
            if let Some(state) = better.into_iter().find_map(|(parent, found)| self.follow(&frontier[parent], found.change)) {
                return Some(state);
            }
            next.retain(|(_, found)| seen.insert((found.score.loss, found.score.count, found.score.work.to_bits())));
            let mut followed = Vec::new();
            for (parent, found) in next {
                let state = self.follow(&frontier[parent], found.change);
                followed.extend(state.filter(|state| state.changes.len() < self.settings.max_edits));
                if followed.len() == BEAM || !self.goes_on() {
                    break;
                }
            }
            frontier = followed;
            if !self.goes_on() {
                break;
            }
        }
        None
    }

    /// Other plans, while one of them is better.
    fn improve(&mut self, mut best: State) -> State {
        self.replays_only = true;
        while let Some(better) = self.replan(&best).or_else(|| self.kick(&best)).or_else(|| self.merge(&best)) {
            best = better;
        }
        self.replays_only = false;
        best
    }

    /// Takes out one edit and goes on from there without it.
    fn replan(&mut self, best: &State) -> Option<State> {
        let changes: Vec<Change> = best.changes.iter().collect();
        changes.into_iter().find_map(|change| {
            let without = self.go(best, best.changes.without(change))?;
            self.plan(without, change.site(), best)
        })
    }

    /// Takes out two edits and looks for one that does for both.
    fn merge(&mut self, best: &State) -> Option<State> {
        let changes: Vec<Change> = best.changes.iter().collect();
        for (at, one) in changes.iter().enumerate() {
            for other in &changes[at + 1..] {
                if !self.goes_on() {
                    return None;
                }
                let Some(mut without) = self.go(best, best.changes.without(*one).without(*other)) else { continue };
                let errors = self.targets(&without);
                let found = self.expand(&mut without, &errors, false, FEW);
                let better = found.into_iter().find(|found| found.score.is_as_clean_as(&best.score));
                let state = better.and_then(|found| self.follow(&without, found.change));
                if let Some(state) = state.filter(|state| self.is_better(state, best)) {
                    return Some(state);
                }
            }
        }
        None
    }

    /// Does one thing that clears an error whatever else it does, and goes on from there.
    fn kick(&mut self, best: &State) -> Option<State> {
        let errors = self.targets(best);
        if errors.is_empty() || best.changes.len() >= self.settings.max_edits {
            return None;
        }
        let found = self.expand(&mut best.clone(), &errors, true, MANY);
        varied(found).collect::<Vec<_>>().into_iter().find_map(|found| {
            let kicked = self.follow(best, found.change)?;
            self.plan(kicked, found.change.site(), best)
        })
    }

    /// Single changes that leave a site alone; the result, where it is better than what there is.
    fn plan(&mut self, from: State, locked: Site, best: &State) -> Option<State> {
        if !self.goes_on() {
            return None;
        }
        self.locked.push(locked);
        let found = self.walk(from);
        self.locked.clear();
        let found = if found.score.loss <= best.score.loss { refine::drop_unneeded(self, found) } else { found };
        self.is_better(&found, best).then_some(found)
    }
}

/// The first candidates, but few of each literal or direction.
fn varied(found: Vec<Candidate>) -> impl Iterator<Item = Candidate> {
    let mut seen: Vec<Site> = Vec::new();
    found
        .into_iter()
        .filter(move |found| {
            let site = found.change.site();
            seen.push(site);
            seen.iter().filter(|other| **other == site).count() <= 2
        })
        .take(OFFSPRING)
}
//
// a
