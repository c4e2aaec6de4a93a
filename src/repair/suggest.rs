//! The best few edits for some errors: what is offered beside a finding.
//!
//! Candidates are the exact proposals of the search; each is judged by what it does to the whole scene, and what is offered was run as
//! a text before. One edit is looked for first; two only where no single one clears most of the errors.

use std::sync::atomic::{AtomicBool, Ordering};

use rustc_hash::FxHashSet;

use crate::analysis::{Input, Options};
use crate::check::finding::{Finding, Fix};
use crate::check::{ErrorKind, Verdict, Violation, check, errors_by_place};
use crate::scene::{Layout, Placed};
use crate::syntax::{ConstantId, Edit};

use super::changes::{Change, Changes};
use super::constants::Names;
use super::measure::{Score, step};
use super::problem::Problem;
use super::proposals;
use super::refine::candidates;
use super::state::{State, score_of};
use super::words::title;
use super::{Settings, transport};

/// Of the errors of a finding, so many are asked for ways out.
const ASKED: usize = 12;
/// So many values of one literal are tried.
const VALUES: usize = 10;
/// So many layouts are replayed, and so many runs are made, for one finding.
const REPLAYS: usize = 500;
const RUNS: usize = 16;
/// So many more where nothing was found.
const LAST_RUNS: usize = 90;
/// All of them together cost no more than this, in units of the budget of a search: in a large scene fewer are tried.
const UNITS: usize = 10_000;
/// So many first edits are followed by a second.
const FIRST: usize = 6;

/// Some errors, by how often each kind occurs.
pub type Tally = Vec<(ErrorKind, usize)>;

/// One edit, or two that go together, and what comes of a run of the edited text.
#[derive(Clone, PartialEq, Debug)]
pub struct Suggestion {
    /// The values to write.
    pub changes: Changes,
    /// The edits of the text, by place.
    pub edits: Vec<Edit>,
    /// Whether none of the errors in question is left.
    pub complete: bool,
    /// The errors of the scene that are gone.
    pub clears: Tally,
    /// The errors of the scene that are new.
    pub adds: Tally,
    /// The objects that stand elsewhere, as indices of the layout.
    pub moved: Vec<usize>,
    /// The objects that face elsewhere, as indices of the layout.
    pub turned: Vec<usize>,
    /// Σ volume × distance over the best matching within categories. m⁴.
    pub transport: f64,
}

/// How good a candidate is; the least is the best.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Tier {
    /// Clears all that was asked for and adds nothing.
    All,
    /// Clears at least half of it and adds nothing.
    Most,
    /// Clears some of it and adds nothing.
    Some,
    /// Clears more than it adds.
    Traded,
}

/// A candidate that was tried.
#[derive(Clone, Debug)]
struct Tried {
    changes: Changes,
    score: Score,
    tier: Option<Tier>,
    /// A direction was written, but all face where they faced: errors may go, but what is to be seen stays.
    idle: bool,
}

type Key = (ErrorKind, u32, Option<u32>);

fn key(violation: &Violation) -> Key {
    (violation.kind, violation.culprit, violation.other)
}

/// What is to be cleared, and what there is.
struct Aim {
    asked: FxHashSet<Key>,
    known: FxHashSet<Key>,
    score: Score,
}

impl Aim {
    fn tier<'v>(&self, score: &Score, errors: impl Iterator<Item = &'v Violation>) -> Option<Tier> {
        let (mut left, mut added) = (0, 0);
        for error in errors {
            let key = key(error);
            left += usize::from(self.asked.contains(&key));
            added += usize::from(!self.known.contains(&key));
        }
        let cleared = self.asked.len() - left;
        if cleared == 0 || score.loss >= self.score.loss {
            return None;
        }
        match added {
            0 if left == 0 => Some(Tier::All),
            0 if left <= cleared => Some(Tier::Most),
            0 => Some(Tier::Some),
            _ if score.count < self.score.count => Some(Tier::Traded),
            _ => None,
        }
    }
}

/// Looks for suggestions in one program; what it learns about the program serves all of them.
#[derive(Debug)]
pub struct Suggester {
    base: State,
    settings: Settings,
}

/// What may still be spent on one question.
struct Purse<'a> {
    replays: usize,
    runs: usize,
    units: usize,
    cancel: Option<&'a AtomicBool>,
}

impl Purse<'_> {
    fn is_open(&self) -> bool {
        self.replays > 0 && self.units > 0 && !self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed))
    }
}

/// Gives each finding about layout errors the best suggestion for it.
pub fn add_suggestions(input: &Input, options: &Options, findings: &mut [Finding]) {
    let Ok(problem) = Problem::new(input, options) else { return };
    let mut suggester = Suggester::new(&problem);
    let names = Names::of(problem.parsed());
    for (kind, place, errors) in errors_by_place(problem.layout(), problem.verdict(), &options.rules) {
        let Some(finding) = findings.iter_mut().find(|finding| finding.code == kind.code() && finding.place == place) else { continue };
        let best = suggester.suggest(&problem, &errors, 1, None).into_iter().next();
        finding.suggestion = best.map(|best| Fix { title: title(&problem, &names, &best, place.range), edits: best.edits });
    }
}

impl Suggester {
    /// Begins with what the record of the program tells.
    pub fn new(problem: &Problem) -> Suggester {
        Suggester { base: State::original(problem), settings: Settings::default() }
    }

    /// The best edits for some errors of the program (the worst first), best first, no more than `wanted`.
    pub fn suggest(&mut self, problem: &Problem, errors: &[Violation], wanted: usize, cancel: Option<&AtomicBool>) -> Vec<Suggestion> {
        let aim = Aim {
            asked: errors.iter().filter(|error| error.kind != ErrorKind::Unplaced).map(key).collect(),
            known: self.base.violations.iter().map(key).collect(),
            score: self.base.score,
        };
        let mut purse = Purse { replays: REPLAYS, runs: RUNS, units: UNITS, cancel };
        let asked = spread(errors, ASKED);
        if aim.asked.is_empty() {
            return Vec::new();
        }
        let mut tried = self.singles(problem, &aim, &asked, &mut purse);
        let best = |tried: &[Tried]| tried.iter().filter_map(|tried| tried.tier).min();
        if best(&tried).is_none_or(|tier| tier > Tier::Most) {
            let pairs = self.pairs(problem, &aim, &tried, errors, &mut purse);
            tried.extend(pairs);
        }
        let clean = best(&tried).is_some_and(|tier| tier <= Tier::Some);
        tried.retain(|tried| tried.tier.is_some_and(|tier| !clean || tier <= Tier::Some));
        rank(&mut tried);
        self.offer(problem, &aim, tried, wanted, &purse)
    }

    /// All single edits that may clear an error.
    fn singles(&mut self, problem: &Problem, aim: &Aim, asked: &[Violation], purse: &mut Purse) -> Vec<Tried> {
        let mut tried = Vec::new();
        for wide in [false, true] {
            let proposals = proposals::constants(problem, &self.settings, &mut self.base, asked, wide);
            let values = proposals.iter().map(|found| (self.base.literals()[found.literal].id, found.value)).collect();
            for (id, value) in thinned(values) {
                let change = Change::Constant(ConstantId(id), value);
                tried.extend(try_change(problem, aim, &mut self.base, change, purse));
            }
            if !wide {
                let turnable = asked.iter().filter(|error| depends_on_turns(&self.base, error)).copied().collect::<Vec<_>>();
                for change in proposals::turns(problem, &self.settings, &self.base, &turnable) {
                    tried.extend(try_change(problem, aim, &mut self.base, change, purse));
                }
            }
            if tried.iter().any(|tried| tried.tier.is_some_and(|tier| tier <= Tier::Most)) {
                break;
            }
        }
        if tried.iter().all(|tried| tried.tier.is_none()) {
            // What stands beside an object moves when that turns.
            purse.runs += LAST_RUNS;
            for change in proposals::all_turns(problem) {
                tried.extend(try_change(problem, aim, &mut self.base, change, purse));
            }
        }
        tried
    }

    /// Pairs of edits that clear everything: the second clears what the first left or added.
    fn pairs(&mut self, problem: &Problem, aim: &Aim, tried: &[Tried], errors: &[Violation], purse: &mut Purse) -> Vec<Tried> {
        purse.replays += REPLAYS;
        let mut first: Vec<&Tried> = tried.iter().collect();
        first.sort_by_key(|tried| (tried.score.loss, tried.score.count));
        first.dedup_by(|a, b| a.score == b.score);
        let mut found = Vec::new();
        for first in first.into_iter().take(FIRST) {
            let Some(change) = first.changes.iter().next() else { continue };
            let Some(mut state) = self.base.after(problem, change) else { continue };
            let wrong = |error: &&Violation| aim.asked.contains(&key(error)) || !aim.known.contains(&key(error));
            let left: Vec<Violation> = state.violations.iter().filter(wrong).copied().collect();
            if left.len() > errors.len().max(ASKED) {
                continue;
            }
            let proposals = proposals::constants(problem, &self.settings, &mut state, &spread(&left, ASKED), false);
            let values = proposals.iter().map(|found| (state.literals()[found.literal].id, found.value)).collect();
            for (id, value) in thinned(values) {
                found.extend(try_change(problem, aim, &mut state, Change::Constant(ConstantId(id), value), purse));
            }
        }
        found.retain(|tried| tried.changes.len() == 2 && tried.tier.is_some_and(|tier| tier <= Tier::Most));
        found
    }

    /// Gives the best candidates short numbers and runs them as texts.
    fn offer(&mut self, problem: &Problem, aim: &Aim, tried: Vec<Tried>, wanted: usize, purse: &Purse) -> Vec<Suggestion> {
        let mut offered: Vec<(Tier, Score, Suggestion)> = Vec::new();
        let mut sites: Vec<Vec<Change>> = Vec::new();
        let cancelled = || purse.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed));
        for tried in tried {
            if offered.len() == wanted || cancelled() {
                break;
            }
            let site: Vec<Change> = tried.changes.iter().map(place_of).collect();
            if sites.iter().filter(|known| **known == site).count() == 2 {
                continue;
            }
            let short = self.shortened(problem, aim, &tried);
            if offered.iter().any(|(.., known)| known.changes == short.changes) {
                continue;
            }
            if let Some(found) = proven(problem, aim, &short.changes) {
                sites.push(site);
                offered.push(found);
            }
        }
        offered.sort_by(|(tier, score, found), (other_tier, other_score, other)| {
            let key =
                |tier: &Tier, score: &Score, found: &Suggestion| (*tier, score.count, found.moved.is_empty() && found.turned.is_empty());
            key(tier, score, found).cmp(&key(other_tier, other_score, other)).then(found.transport.total_cmp(&other.transport))
        });
        offered.into_iter().map(|(.., suggestion)| suggestion).collect()
    }

    /// The same edits with the fewest decimals that do the same.
    fn shortened(&mut self, problem: &Problem, aim: &Aim, tried: &Tried) -> Tried {
        let mut best = tried.clone();
        for (id, value) in tried.changes.constants() {
            let original = problem.tuning().constant(id).map_or(value, |constant| constant.value);
            let change = Change::Constant(id, value);
            let rest = best.changes.without(change);
            let other = match rest.iter().next() {
                Some(other) => self.base.after(problem, other),
                None => None,
            };
            let mut held = other;
            let state = held.as_mut().unwrap_or(&mut self.base);
            let mut purse = Purse { replays: 40, runs: 3, units: UNITS, cancel: None };
            let short = candidates(value, original).into_iter().find_map(|short| {
                let found = try_change(problem, aim, state, Change::Constant(id, short), &mut purse)?;
                (found.tier.is_some() && found.tier <= best.tier && found.score.is_as_clean_as(&best.score)).then_some(found)
            });
            best = short.unwrap_or(best);
        }
        best
    }
}

/// The change without its value: what is rewritten.
fn place_of(change: Change) -> Change {
    match change {
        Change::Constant(id, _) => Change::Constant(id, 0.0),
        turn @ Change::Turn(..) => turn,
    }
}

fn rank(tried: &mut [Tried]) {
    tried.sort_by(|a, b| {
        let key = |tried: &Tried| (tried.tier, tried.changes.len(), tried.score.count, tried.idle);
        key(a).cmp(&key(b)).then(a.score.work.total_cmp(&b.score.work))
    });
}

/// What a change of a state gives, by replay if it may be, else by a run.
fn try_change(problem: &Problem, aim: &Aim, state: &mut State, change: Change, purse: &mut Purse) -> Option<Tried> {
    if !purse.is_open() {
        return None;
    }
    purse.replays -= 1;
    let changes = state.changes.with(change, problem.tuning());
    if changes.len() <= state.changes.len() {
        return None;
    }
    if let Change::Constant(..) = change {
        let found = state.replays(change).and_then(|(literal, value)| state.try_errors(problem, literal, value));
        purse.units = purse.units.saturating_sub(state.replay_cost());
        if let Some((score, errors)) = found {
            return Some(Tried { changes, score, tier: aim.tier(&score, errors.iter()), idle: false });
        }
    }
    purse.runs = purse.runs.checked_sub(1)?;
    purse.units = purse.units.saturating_sub(problem.run_cost());
    let ran = problem.run(&changes, false)?;
    let score = score_of(problem, &ran.layout);
    let verdict = check(&ran.layout, &problem.options().rules);
    let turns = |(before, after): (&Placed, &Placed)| before.body.turn != after.body.turn;
    let idle = matches!(change, Change::Turn(..)) && !problem.layout().objects.iter().zip(&ran.layout.objects).any(turns);
    Some(Tried { changes, score, tier: aim.tier(&score, verdict.counted()), idle })
}

/// Whether turning an object may clear an error of it.
fn depends_on_turns(state: &State, error: &Violation) -> bool {
    let long = |object: usize| state.bodies[object].dims[0] != state.bodies[object].dims[1];
    match error.kind {
        ErrorKind::Facing | ErrorKind::FacingWall | ErrorKind::ShortSide | ErrorKind::Mounted => true,
        ErrorKind::OutOfBounds | ErrorKind::Overlap | ErrorKind::Clearance => error.objects().any(long),
        ErrorKind::Standing | ErrorKind::Unplaced => false,
    }
}

/// The first few, and some of the rest.
fn spread(errors: &[Violation], count: usize) -> Vec<Violation> {
    let first = errors.len().min(count / 2);
    let rest = &errors[first..];
    let stride = rest.len().div_ceil(count - first).max(1);
    errors[..first].iter().chain(rest.iter().step_by(stride)).copied().collect()
}

/// Of the values of each literal the outermost and some between them, a literal after the other.
fn thinned(mut values: Vec<(u32, f64)>) -> Vec<(u32, f64)> {
    values.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut kept = Vec::new();
    for group in values.chunk_by(|a, b| a.0 == b.0) {
        let last = group.len() - 1;
        let count = group.len().min(VALUES);
        let pick = |at: usize| if count > 1 { group[at * last / (count - 1)] } else { group[0] };
        kept.extend((0..count).map(pick));
    }
    kept
}

/// Runs the edited text; what it does then is what is offered.
fn proven(problem: &Problem, aim: &Aim, changes: &Changes) -> Option<(Tier, Score, Suggestion)> {
    let (text, edits) = problem.rewrite(changes)?;
    let (layout, verdict) = problem.judge_text(&text)?;
    let score = score_of(problem, &layout);
    let tier = aim.tier(&score, verdict.counted())?;
    let suggestion = suggestion(problem, changes.clone(), edits, &layout, &verdict);
    let complete = tier == Tier::All || verdict.counted().all(|error| !aim.asked.contains(&key(error)));
    Some((tier, score, Suggestion { complete, ..suggestion }))
}

fn suggestion(problem: &Problem, changes: Changes, edits: Vec<Edit>, layout: &Layout, verdict: &Verdict) -> Suggestion {
    let before: FxHashSet<Key> = problem.verdict().counted().map(key).collect();
    let after: FxHashSet<Key> = verdict.counted().map(key).collect();
    let pairs = || problem.layout().objects.iter().zip(&layout.objects).enumerate();
    let moved = pairs().filter(|(_, (a, b))| step(&a.body, &b.body).1).map(|(index, _)| index).collect();
    let turned = pairs().filter(|(_, (a, b))| a.body.turn != b.body.turn).map(|(index, _)| index).collect();
    Suggestion {
        changes,
        edits,
        complete: false,
        clears: tally(before.difference(&after)),
        adds: tally(after.difference(&before)),
        moved,
        turned,
        transport: transport(problem.layout(), layout),
    }
}

fn tally<'k>(keys: impl Iterator<Item = &'k Key>) -> Tally {
    let mut counts = [0; ErrorKind::ALL.len()];
    keys.for_each(|key| counts[key.0 as usize] += 1);
    ErrorKind::ALL.into_iter().zip(counts).filter(|(_, count)| *count > 0).collect()
}
