//! The tidy end of a search: no edit that is not needed, none that goes further than it must, and numbers that a person would write.

use super::changes::{Change, Changes};
use super::search::Search;
use super::state::State;

/// Steps of bisection from a constant toward its original.
const BISECTIONS: usize = 10;

/// A shorter number may be this far from the exact one, or this part of it.
const ROUNDING: f64 = 0.02;

/// Tidies a state up. Numbers are made short even where nothing is left to spend: that takes a few replays for each.
pub(super) fn refine(search: &mut Search<'_>, state: State) -> State {
    let best = drop_unneeded(search, state);
    let best = pull_back(search, best);
    search.limit = usize::MAX;
    round(search, best)
}

/// Leaves out edits one by one while nothing gets worse; of those that may go, the one that leaves the least movement.
pub(super) fn drop_unneeded(search: &mut Search<'_>, mut best: State) -> State {
    loop {
        let changes: Vec<Change> = best.changes.iter().collect();
        let mut shorter: Vec<(f64, Changes)> = Vec::new();
        for change in changes {
            let without = best.changes.without(change);
            let Some(score) = search.try_changes(&mut best, &without) else { continue };
            if score.is_as_clean_as(&best.score) {
                shorter.push((search.cost(&score), without));
            }
        }
        let Some((_, without)) = shorter.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)) else { return best };
        match search.go(&best, without) {
            Some(state) if search.is_as_clean(&state, &best) => best = state,
            _ => return best,
        }
    }
}

/// Brings every constant as close to its original as the errors stay away.
fn pull_back(search: &mut Search<'_>, mut best: State) -> State {
    let constants: Vec<_> = best.changes.constants().collect();
    for (id, value) in constants {
        let Some(original) = search.problem.tuning().constant(id).map(|constant| constant.value) else { continue };
        let (mut near, mut far) = (0.0, 1.0);
        let mut pulled = None;
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (near + far);
            let between = original + middle * (value - original);
            match search.try_change(&mut best, Change::Constant(id, between)) {
                Some(score) if score.is_as_clean_as(&best.score) && score.work <= best.score.work => {
                    far = middle;
                    pulled = Some(between);
                }
                _ => near = middle,
            }
        }
        if let Some(state) = pulled.and_then(|value| search.follow(&best, Change::Constant(id, value))) {
            best = state;
        }
    }
    best
}

/// Gives every constant the fewest decimals that keep the errors away.
fn round(search: &mut Search<'_>, mut best: State) -> State {
    let constants: Vec<_> = best.changes.constants().collect();
    for (id, value) in constants {
        let original = search.problem.tuning().constant(id).map_or(value, |constant| constant.value);
        let short = candidates(value, original).into_iter().find(|short| {
            let score = search.try_change(&mut best, Change::Constant(id, *short));
            score.is_some_and(|score| score.is_as_clean_as(&best.score))
        });
        if let Some(state) = short.and_then(|short| search.follow(&best, Change::Constant(id, short))) {
            best = state;
        }
    }
    best
}

/// Numbers near a value, fewest decimals first, of equally many that nearest to the original first.
pub(super) fn candidates(value: f64, original: f64) -> Vec<f64> {
    let mut found = Vec::new();
    for decimals in 0..=12 {
        let unit = 10_f64.powi(decimals);
        let (low, high) = ((value * unit).floor(), (value * unit).ceil());
        let mut near = [low, high, low - 1.0, high + 1.0].map(|units| units / unit);
        near.sort_by(|a, b| (a - original).abs().total_cmp(&(b - original).abs()));
        found.extend(near.into_iter().filter(|short| (short - value).abs() <= ROUNDING.max(ROUNDING * value.abs())));
    }
    found.retain(|short| *short != original);
    found.into_iter().map(|short| if short == 0.0 { 0.0 } else { short }).collect()
}

/// The changes of a state and its score, for methods that end without a state.
pub(super) fn tidy(search: &mut Search<'_>, changes: Changes) -> Option<Changes> {
    search.limit = usize::MAX;
    Some(round(search, State::run(search.problem, changes)?).changes)
}
