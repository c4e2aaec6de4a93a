//! Error correction: a few constants and directions rewritten, so that layout errors vanish and the program keeps its meaning.
//!
//! A [`Problem`] is a program that can be run again with other values; [`fix`] looks for [`Changes`] and answers with a [`Fix`].
//!
//! Invariants:
//! - Only literals and directions that [`tune`](mod@crate::syntax::tune) offers are rewritten, and no constant that reaches a size.
//! - A fix never leaves more errors than it found, adds an exception or changes which objects there are; the text that it gives was
//!   run before it is offered.
//! - Budgets count evaluations, never time: the same input gives the same output everywhere.
//!
//! Knows the rooms that run and check a program. Knows nothing of files and protocols.

mod changes;
mod constants;
mod guided;
mod measure;
mod neighbourhood;
mod paper;
mod problem;
mod proposals;
mod reach;
mod refine;
mod rescore;
mod search;
mod state;
mod suggest;
mod transport;
mod words;

pub use changes::{Change, Changes};
pub use constants::{Names, Tunable, Tuner, tunables};
pub use measure::Score;
pub use neighbourhood::Neighbourhood;
pub use problem::{Problem, Ran, Unfit};
pub use reach::{NEAR, Reach, move_to, turn_to};
pub use suggest::{Suggester, Suggestion, Tally, add_suggestions};
pub use transport::transport;
pub use words::{edit_titles, title};

use crate::check::{ErrorKind, Verdict};
use crate::syntax::Edit;
use ruff_text_size::TextRange;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize};

/// How to look for a fix.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Method {
    /// Exact proposals from the record of the run.
    #[default]
    Guided,
    /// The search of the paper: random values for constants, all cardinals for directions.
    Paper,
}

/// What a fix may do.
#[derive(Clone, Debug)]
pub struct Settings {
    /// How to look for it.
    pub method: Method,
    /// For what is random.
    pub seed: u64,
    /// At most so many constants and directions are rewritten.
    pub max_edits: usize,
    /// How many layouts may be tried.
    pub budget: usize,
    /// Only errors of these kinds are worked on; all where empty.
    pub only: Vec<ErrorKind>,
    /// Only what lies inside is rewritten.
    pub within: Option<TextRange>,
    /// Where the search can be followed and ended.
    pub watch: Option<Arc<Watch>>,
}

/// A search under way as others see it.
#[derive(Debug, Default)]
pub struct Watch {
    /// Set by whoever wants no result any more; the search then ends with what it has.
    pub cancelled: AtomicBool,
    /// How much of the budget is spent.
    pub spent: AtomicUsize,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { method: Method::Guided, seed: 0, max_edits: 40, budget: 20_000, only: Vec::new(), within: None, watch: None }
    }
}

/// How much work a search was.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Effort {
    /// Layouts that were looked at.
    pub evaluations: usize,
    /// Those that were replayed from a record.
    pub replays: usize,
    /// Those that took a run of the program.
    pub runs: usize,
}

/// What a search found.
#[derive(Debug)]
pub struct Fix {
    /// The values to write.
    pub changes: Changes,
    /// The edits of the text, by place.
    pub edits: Vec<Edit>,
    /// The text after the edits.
    pub text: String,
    /// The errors before.
    pub before: Verdict,
    /// The errors after, of a run of the new text.
    pub after: Verdict,
    /// How many objects moved by more than a micrometre.
    pub moved: usize,
    /// Σ volume × distance over the best matching within categories. m⁴.
    pub transport: f64,
    /// Σ volume × distance / Σ volume, each object compared with itself. Metres.
    pub displacement: f64,
    /// The work.
    pub effort: Effort,
}

impl Fix {
    /// How many errors there were.
    pub fn errors_before(&self) -> usize {
        self.before.counted().count()
    }

    /// How many errors are left.
    pub fn errors_after(&self) -> usize {
        self.after.counted().count()
    }
}

/// Looks for a fix of a program.
pub fn fix(problem: &Problem, settings: &Settings) -> Fix {
    let (changes, effort) = match settings.method {
        Method::Guided => guided::search(problem, settings),
        Method::Paper => paper::search(problem, settings),
    };
    finish(problem, changes, effort)
}

/// Runs the new text; where it does not keep what the search promised, the program stays as it is.
fn finish(problem: &Problem, changes: Changes, effort: Effort) -> Fix {
    let tried = problem.rewrite(&changes);
    let before = problem.verdict().clone();
    let fresh = tried.as_ref().and_then(|(text, _)| problem.judge_text(text));
    let kept = fresh.filter(|(_, after)| {
        let worse = after.counted().count() > before.counted().count() || after.loss() > before.loss();
        !changes.is_empty() && !worse
    });
    let (Some((text, edits)), Some((layout, after))) = (tried, kept) else {
        let text = problem.text().to_string();
        let (changes, after) = (Changes::default(), before.clone());
        return Fix { changes, edits: Vec::new(), text, before, after, moved: 0, transport: 0.0, displacement: 0.0, effort };
    };
    let original = problem.layout().bodies();
    let (moved, displacement) = measure::displacement(&original, &layout.bodies());
    let transport = transport(problem.layout(), &layout);
    Fix { changes, edits, text, before, after, moved, transport, displacement, effort }
}

/// What one edit does, given all the others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Effect {
    /// How many errors there are more without it.
    pub clears: usize,
    /// How many objects stand elsewhere without it.
    pub moves: usize,
}

/// What each edit of a fix does, in the order of its edits.
pub fn effects(problem: &Problem, fix: &Fix) -> Vec<Effect> {
    let mut effects: Vec<(TextRange, Effect)> = Vec::new();
    let Some(with) = problem.run(&fix.changes, false) else { return Vec::new() };
    for change in fix.changes.iter() {
        let range = match change {
            Change::Constant(id, _) => problem.tuning().constant(id).map(|constant| constant.range),
            Change::Turn(id, _) => problem.tuning().direction(id).map(|direction| direction.range),
        };
        let without = problem.run(&fix.changes.without(change), false);
        let effect = without.map_or(Effect { clears: 0, moves: 0 }, |without| {
            let errors = state::score_of(problem, &without.layout).count;
            let (moves, _) = measure::displacement(&without.layout.bodies(), &with.layout.bodies());
            Effect { clears: errors.saturating_sub(fix.errors_after()), moves }
        });
        effects.push((range.unwrap_or_default(), effect));
    }
    effects.sort_by_key(|(range, _)| (range.start(), range.end()));
    effects.into_iter().map(|(_, effect)| effect).collect()
}
