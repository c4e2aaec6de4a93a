//! The default search: exact proposals, steepest descent, a beam where single edits stall, and other plans tried at the end.

use crate::syntax::{ConstantId, DirectionId};

use super::changes::{Change, Changes};
use super::measure::Score;
use super::problem::Problem;
use super::search::{Candidate, Search};
use super::state::State;
use super::{Effort, Settings, refine};
use rustc_hash::FxHashSet;

/// States that are followed at once where single edits stall, and how deep.
const BEAM: usize = 6;
const DEPTH: usize = 3;

/// Candidates that are kept of one state, at most so many of one literal or direction.
const OFFSPRING: usize = 12;

/// What the descents weigh against the loss, one after the other until one comes to its end: an error, a mean displacement of a metre,
/// and moving every object.
pub(super) const WEIGHTS: [[f64; 3]; 3] = [[8.0, 60.0, 200.0], [8.0, 20.0, 20.0], [0.0, 0.0, 0.0]];

/// Where the first descent clears everything within so many units of the budget, the others are made too.
const AGAIN: usize = 2000;

/// Units of the budget that are spent on a program without errors left, to do with fewer edits and less movement.
const POLISH: usize = 2500;

/// Looks for a correction.
pub(super) fn search(problem: &Problem, settings: &Settings) -> (Changes, Effort) {
    let mut search = Search::new(problem, settings);
    let budget = settings.budget;
    let Some(start) = State::run(problem, Changes::default()) else { return (Changes::default(), search.effort) };
    search.limit = budget / 10 * 6 + budget % 10;
    let mut best = start.clone();
    for weights in WEIGHTS {
        search.weights = weights;
        let found = search.descend(start.clone());
        let found = refine::drop_unneeded(&mut search, found);
        if search.is_better(&found, &best) {
            best = found;
        }
        if !search.goes_on() || search.targets(&best).is_empty() && search.spent > AGAIN {
            break;
        }
    }
    search.weights = WEIGHTS[0];
    search.limit = budget / 10 * 8 + budget % 10;
    if search.targets(&best).is_empty() {
        search.limit = search.limit.min(search.spent + POLISH);
    }
    best = search.improve(best);
    search.limit = budget;
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
    /// From a state to the best that is found, step by step.
    fn descend(&mut self, start: State) -> State {
        let mut best = start;
        loop {
            best = self.walk(best);
            match self.look_ahead(&best) {
                Some(next) => best = next,
                None => return best,
            }
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
        let found = self.expand(state, &errors, false);
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
                let found = self.expand(state, &errors, depth == 0 || state.violations.len() < 8);
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
        while let Some(better) = self.replan(&best).or_else(|| self.kick(&best)) {
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

    /// Does one thing that clears an error whatever else it does, and goes on from there.
    fn kick(&mut self, best: &State) -> Option<State> {
        let errors = self.targets(best);
        if errors.is_empty() || best.changes.len() >= self.settings.max_edits {
            return None;
        }
        let found = self.expand(&mut best.clone(), &errors, true);
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
        self.locked = Some(locked);
        let found = self.walk(from);
        self.locked = None;
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
