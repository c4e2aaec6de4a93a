//! The search of the paper, as PSDL describes it: the best of random neighbours, again and again.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::check::Violation;
use crate::syntax::ConstantId;

use super::changes::{Change, Changes};
use super::problem::Problem;
use super::proposals::{is_allowed, turns};
use super::refine;
use super::search::Search;
use super::state::State;
use super::{Effort, Settings};

/// Values that are tried for each constant.
const VALUES: usize = 10;

/// An edit that lessens the weighted loss by no more than this is none.
const THRESHOLD: u64 = 1;

/// Looks for a correction.
pub(super) fn search(problem: &Problem, settings: &Settings) -> (Changes, Effort) {
    let mut search = Search::new(problem, settings);
    let mut rng = ChaCha8Rng::seed_from_u64(settings.seed);
    let mut state = State::original(problem);
    while search.goes_on() && state.changes.len() < settings.max_edits {
        let errors = search.targets(&state);
        let neighbours = neighbours(problem, settings, &state, &errors, &mut rng);
        let tried: Vec<_> = neighbours.into_iter().filter_map(|change| Some((change, search.try_change(&mut state, change)?))).collect();
        let best = tried.into_iter().min_by(|(_, a), (_, b)| a.loss.cmp(&b.loss).then(a.work.total_cmp(&b.work)));
        let Some((change, score)) = best else { break };
        if score.loss + THRESHOLD >= state.score.loss {
            break;
        }
        match search.follow(&state, change) {
            Some(next) => state = next,
            None => break,
        }
    }
    let changes = refine::tidy(&mut search, state.changes.clone()).unwrap_or(state.changes);
    (changes, search.effort)
}

fn neighbours(problem: &Problem, settings: &Settings, state: &State, errors: &[Violation], rng: &mut ChaCha8Rng) -> Vec<Change> {
    let mut changes = turns(problem, settings, state, errors);
    let mut literals: Vec<usize> = errors.iter().flat_map(Violation::objects).flat_map(|object| state.movers(object)).copied().collect();
    literals.sort_unstable();
    literals.dedup();
    for literal in literals {
        let id = ConstantId(state.literals()[literal].id);
        if !is_allowed(problem, settings, id) {
            continue;
        }
        for _ in 0..VALUES {
            let factor = libm::pow(4.0, rng.random_range(-1.0..=1.0));
            let sign = if rng.random::<bool>() { 1.0 } else { -1.0 };
            changes.push(Change::Constant(id, state.value(literal) * sign * factor));
        }
    }
    changes
}
