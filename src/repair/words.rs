//! Suggestions in words: ``Change gap 0.1 → 0.35: clears 4 overlaps, moves 12 chairs``.

use crate::check::ErrorKind;
use crate::syntax::{Edit, LineIndex};
use ruff_text_size::TextRange;

use super::changes::Change;
use super::constants::Names;
use super::problem::Problem;
use super::suggest::{Suggestion, Tally};
use super::{Effect, Fix, effects};

/// Texts of a program of more characters than this are cut short.
const LONG: usize = 24;

/// What a suggestion does, as a title. `beside` is the place where it is offered: what is edited on other lines is told with the line.
pub fn title(problem: &Problem, names: &Names, suggestion: &Suggestion, beside: TextRange) -> String {
    let lines = LineIndex::new(problem.text());
    let here = lines.line(beside.start())..=lines.line(beside.end());
    let mut parts = Vec::new();
    for change in suggestion.changes.iter() {
        let Some((range, new)) = edit_of(problem, change) else { continue };
        let old = shown(problem.text().get(range.start().to_usize()..range.end().to_usize()).unwrap_or_default());
        let line = lines.line(range.start());
        let place = if here.contains(&line) { String::new() } else { format!(" on line {}", line + 1) };
        parts.push(match change {
            Change::Turn(..) if !suggestion.turned.is_empty() => format!("turn {} to {}", objects(problem, &suggestion.turned), new.trim()),
            _ => rewriting(problem, names, change, &old, &new, &place),
        });
    }
    let mut title = format!("{}: clears {}", capitalised(&parts.join(" and ")), counted(&suggestion.clears));
    if !suggestion.adds.is_empty() {
        title.push_str(&format!(", adds {}", counted(&suggestion.adds)));
    }
    let only_turns =
        suggestion.changes.constants().next().is_none() && suggestion.moved.iter().all(|object| suggestion.turned.contains(object));
    if !suggestion.moved.is_empty() && !only_turns {
        title.push_str(&format!(", moves {}", objects(problem, &suggestion.moved)));
    }
    title
}

/// What a change rewrites, with its line.
pub(super) fn change_words(problem: &Problem, names: &Names, change: Change, lines: &LineIndex) -> String {
    let Some((range, new)) = edit_of(problem, change) else { return String::new() };
    let old = shown(problem.text().get(range.start().to_usize()..range.end().to_usize()).unwrap_or_default());
    rewriting(problem, names, change, &old, &new, &format!(" on line {}", lines.line(range.start()) + 1))
}

fn rewriting(problem: &Problem, names: &Names, change: Change, old: &str, new: &str, place: &str) -> String {
    let new = new.trim();
    match change {
        Change::Constant(id, _) => match names.get(problem, id) {
            Some(name) => format!("change {} {old} → {new}", shown(name)),
            None => format!("change {old}{place} → {new}"),
        },
        Change::Turn(..) => format!("write {new} for {old}{place}"),
    }
}

/// What each edit of a fix does, given the others, in the order of its edits.
pub fn edit_titles(problem: &Problem, fix: &Fix) -> Vec<String> {
    let names = Names::of(problem.parsed());
    let effects = effects(problem, fix);
    let described = fix.edits.iter().zip(effects).map(|((range, new), effect)| {
        let old = shown(problem.text().get(range.start().to_usize()..range.end().to_usize()).unwrap_or_default());
        let constant = problem.tuning().constant_at(*range);
        let name = constant.and_then(|id| names.get(problem, id)).map_or_else(String::new, |name| format!("{} ", shown(name)));
        let plural = |count: usize| if count == 1 { "" } else { "s" };
        let Effect { clears, moves } = effect;
        let new = new.trim();
        format!("Change {name}{old} → {new}: clears {clears} error{}, moves {moves} object{}", plural(clears), plural(moves))
    });
    described.collect()
}

fn edit_of(problem: &Problem, change: Change) -> Option<Edit> {
    let tuning = problem.tuning();
    match change {
        Change::Constant(id, value) => Some(tuning.constant(id)?.edit(value)),
        Change::Turn(id, cardinal) => Some(tuning.turn(tuning.direction(id)?, cardinal)),
    }
}

/// Some objects in short: the only one by its path, several of one list by the name of the list.
pub fn objects(problem: &Problem, indices: &[usize]) -> String {
    let paths = || indices.iter().filter_map(|index| problem.layout().objects.get(*index)).map(|object| object.path.as_str());
    let list = |path: &str| path.split_once('[').map(|(list, _)| list.to_string());
    if let [_] = indices {
        return paths().next().map(shown).unwrap_or_default();
    }
    let first = paths().next().and_then(list);
    match first {
        Some(first) if first.ends_with('s') && paths().all(|path| list(path).as_deref() == Some(first.as_str())) => {
            format!("{} {}", indices.len(), shown(&first))
        }
        _ => format!("{} objects", indices.len()),
    }
}

/// Errors by kind; where there are many kinds, their number only.
pub fn counted(tally: &Tally) -> String {
    let total: usize = tally.iter().map(|(_, count)| count).sum();
    let one = |(kind, count): &(ErrorKind, usize)| format!("{count} {}{}", noun(*kind), if *count == 1 { "" } else { "s" });
    match tally.as_slice() {
        [only] => one(only),
        [first, second] => format!("{} and {}", one(first), one(second)),
        _ => format!("{total} error{}", if total == 1 { "" } else { "s" }),
    }
}

fn noun(kind: ErrorKind) -> &'static str {
    match kind {
        ErrorKind::OutOfBounds => "out-of-bounds error",
        ErrorKind::Overlap => "overlap",
        ErrorKind::Standing => "standing error",
        ErrorKind::Mounted => "mounted error",
        ErrorKind::Facing => "facing error",
        ErrorKind::Clearance => "clearance error",
        ErrorKind::FacingWall => "facing-wall error",
        ErrorKind::ShortSide => "short-side error",
        ErrorKind::Unplaced => "unplaced object",
    }
}

/// A text of the program on one line, cut short.
pub(super) fn shown(text: &str) -> String {
    let line: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
    match line.char_indices().nth(LONG) {
        Some((at, _)) => format!("{}…", &line[..at]),
        None => line,
    }
}

pub(super) fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or(String::new(), |first| first.to_uppercase().chain(chars).collect())
}
