//! Constants that become variables, and integers that become constants.

use super::{Ground, Refactoring, RefactoringKind};
use crate::syntax::Edit;
use crate::syntax::ast::Ranged as _;
use ruff_text_size::{TextRange, TextSize};

fn is_word(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}

/// A constant that stands in several places becomes a variable before the first of them.
pub(super) fn extract(ground: &Ground, range: TextRange) -> Option<Refactoring> {
    let tuning = ground.problem.tuning();
    let free = || tuning.constants.iter().filter(|constant| constant.excluded.is_none());
    let chosen = free().find(|constant| constant.range.contains_range(range))?;
    let same: Vec<TextRange> = free()
        .filter(|constant| constant.value.abs().to_bits() == chosen.value.abs().to_bits())
        .map(|constant| digits(ground, constant.range))
        .collect();
    let glued = |place: &TextRange| {
        let before = ground.text()[..place.start().to_usize()].chars().next_back();
        let after = ground.text()[place.end().to_usize()..].chars().next();
        before.is_some_and(is_word) || after.is_some_and(is_word)
    };
    if same.len() < 2 || same.iter().any(glued) {
        return None;
    }
    let name = fresh_name(ground, chosen.range);
    let parsed = ground.problem.parsed();
    let first = parsed.module.body.iter().find(|stmt| same.iter().any(|place| stmt.range().contains_range(*place)))?;
    let before = &ground.text()[..first.start().to_usize()];
    let line = TextSize::of(&before[..before.rfind('\n').map_or(0, |at| at + 1)]);
    let literal = ground.slice(digits(ground, chosen.range));
    let newline = if ground.text().contains("\r\n") { "\r\n" } else { "\n" };
    let title = format!("Extract {literal}, which stands here {} times, into the variable {name}", same.len());
    let mut edits: Vec<Edit> = vec![(TextRange::empty(line), format!("{name} = {literal}{newline}"))];
    edits.extend(same.into_iter().map(|place| (place, name.clone())));
    Some(Refactoring { title, kind: RefactoringKind::ExtractConstant, edits, sidecar: None })
}

/// A constant without its sign.
fn digits(ground: &Ground, constant: TextRange) -> TextRange {
    let text = ground.slice(constant);
    let number = text.trim_start_matches(|c: char| !c.is_ascii_digit() && c != '.');
    TextRange::new(constant.end() - TextSize::of(number), constant.end())
}

/// A name that nobody uses, after what the constant does.
fn fresh_name(ground: &Ground, constant: TextRange) -> String {
    let before = ground.text()[..constant.start().to_usize()].trim_end();
    let base = match before.chars().next_back() {
        Some('+' | '-') => "gap",
        Some('*' | '/') => "factor",
        _ => "distance",
    };
    let taken = |name: &str| ground.text().split(|c: char| !is_word(c)).any(|word| word == name);
    let numbered = (2..).map(|number| format!("{base}_{number}"));
    std::iter::once(base.to_string()).chain(numbered).find(|name| !taken(name)).unwrap_or_default()
}

/// An integer becomes a float of the same value.
pub(super) fn tunable(ground: &Ground, range: TextRange) -> Option<Refactoring> {
    let integers = ground.problem.tuning().integers.iter().filter(|integer| !integer.in_template);
    let integer = integers.into_iter().find(|integer| integer.range.contains_range(range))?;
    let place = digits(ground, integer.range);
    let literal = ground.slice(place);
    if !literal.chars().all(|c| c.is_ascii_digit() || c == '_') {
        return None;
    }
    let title = format!("Make {literal} tunable: {literal}.0");
    let edits = vec![(TextRange::empty(place.end()), ".0".to_string())];
    Some(Refactoring { title, kind: RefactoringKind::Tunable, edits, sidecar: None })
}
