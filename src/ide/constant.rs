//! What is said about a constant besides its text: what it moves, and where no errors are.

use super::program::View;
use super::words;
use crate::repair::{Problem, Tunable};
use ruff_text_size::TextSize;

/// So many groups of objects that move alike are told.
const MAX_GROUPS: usize = 5;
/// Of the objects that move alike so many are named.
const MAX_NAMES: usize = 4;
/// Objects that move less than this for a step of the constant stay where they are. Metres.
const STILL: f64 = 1e-6;

/// What a constant moves, and the values without errors, in Markdown.
pub fn about_constant(problem: &Problem, found: &Tunable) -> String {
    let mut lines = vec![moves(problem, found)];
    lines.extend(good(problem, found));
    if found.errors > 0 {
        lines.push(format!("{} now among what it moves", words::counted(found.errors, "error")));
    }
    lines.join("\n\n")
}

/// Objects by how they move, in order of declaration.
fn moves(problem: &Problem, found: &Tunable) -> String {
    let mut groups: Vec<([String; 3], Vec<&str>)> = Vec::new();
    for (object, slope) in &found.moves {
        if slope.iter().all(|part| part.abs() < STILL) {
            continue;
        }
        let Some(path) = problem.layout().objects.get(*object).map(|object| object.path.as_str()) else { continue };
        let way = slope.map(words::number);
        match groups.iter_mut().find(|(known, _)| *known == way) {
            Some((_, paths)) => paths.push(path),
            None => groups.push((way, vec![path])),
        }
    }
    if groups.is_empty() {
        let turns = if found.moves.is_empty() { "moves no object" } else { "moves no object near this value, but decides about some" };
        return turns.to_string();
    }
    let count: usize = groups.iter().map(|(_, paths)| paths.len()).sum();
    let mut lines = vec![format!("moves {}; for each +1:", words::counted(count, "object"))];
    for (way, paths) in groups.iter().take(MAX_GROUPS) {
        let named: Vec<String> = paths.iter().take(MAX_NAMES).map(|path| words::code(path)).collect();
        let more = paths.len().saturating_sub(MAX_NAMES);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        lines.push(format!("- {}{more}: {}", named.join(", "), shift(way)));
    }
    if groups.len() > MAX_GROUPS {
        lines.push(format!(
            "- … and {} more in other ways",
            words::counted(groups[MAX_GROUPS..].iter().map(|(_, paths)| paths.len()).sum(), "object")
        ));
    }
    lines.join("\n")
}

/// `x + 1 m, z − 0.5 m`
fn shift(way: &[String; 3]) -> String {
    let parts = ["x", "y", "z"].into_iter().zip(way).filter(|(_, by)| *by != "0");
    let part = |(axis, by): (&str, &String)| match by.strip_prefix('−') {
        Some(less) => format!("{axis} − {less} m"),
        None => format!("{axis} + {by} m"),
    };
    parts.map(part).collect::<Vec<_>>().join(", ")
}

/// The values without errors; nothing where the constant moves nothing.
fn good(problem: &Problem, found: &Tunable) -> Option<String> {
    if found.moves.is_empty() {
        return None;
    }
    let value = problem.tuning().constant(found.id)?.value;
    let intervals: Vec<String> = found.good.iter().map(interval).collect();
    let within = |(low, high): &(Option<f64>, Option<f64>)| low.is_none_or(|low| low <= value) && high.is_none_or(|high| value <= high);
    Some(match &found.good[..] {
        [] if found.is_complete => "no value near is without errors".to_string(),
        [] => "no value without errors was found near".to_string(),
        [(None, None)] => "no errors at any value".to_string(),
        [here] if within(here) && !found.is_complete => format!("no errors {}, or farther", intervals[0]),
        _ => format!("no errors {}", intervals.join(", or ")),
    })
}

fn interval((low, high): &(Option<f64>, Option<f64>)) -> String {
    match (low, high) {
        (Some(low), Some(high)) if words::number(*low) == words::number(*high) => format!("at {}", words::number(*low)),
        (Some(low), Some(high)) => format!("from {} to {}", words::number(*low), words::number(*high)),
        (Some(low), None) => format!("from {} on", words::number(*low)),
        (None, Some(high)) => format!("up to {}", words::number(*high)),
        (None, None) => "at any value".into(),
    }
}

/// What is said about an integer of the layout at a place: it is no constant that corrections may change.
pub(super) fn integer(view: &View, offset: TextSize) -> Option<(ruff_text_size::TextRange, String)> {
    let integer = view.program.tuning.integers.iter().find(|integer| integer.range.contains_inclusive(offset))?;
    let text = words::code(view.slice(integer.range));
    let why =
        if integer.in_template { "belongs to the template: it is never tuned" } else { "an integer: set in stone, corrections leave it" };
    Some((integer.range, format!("{text} · {why}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Input, Options};
    use crate::repair::{Names, Tuner};
    use crate::syntax::ConstantId;

    /// What is said about the only constants of a layout, in order, with so much to spend on each.
    fn told(text: &str, budget: usize) -> Vec<String> {
        let problem = Problem::new(&Input { text, template: None }, &Options::default()).expect("it runs");
        let (names, mut tuner) = (Names::of(problem.parsed()), Tuner::new(&problem));
        let all = (0..problem.tuning().constants.len() as u32).map(ConstantId);
        all.filter_map(|id| tuner.tunable(&problem, &names, id, budget)).map(|found| about_constant(&problem, &found)).collect()
    }

    const ROW: &str = "set_size(8, 8, 3)\nchairs = [Object('Chair', 1, 1, 1) for _ in range(3)]\n";

    #[test]
    fn objects_are_told_by_how_they_move_with_the_values_between_their_meetings() {
        let text = format!("{ROW}for i, c in enumerate(chairs):\n    c.min.x = scene.min.x + i * 1.5\n    c.min.y = 0\n");
        let expected = "moves 2 objects; for each +1:\n- `chairs[1]`: x + 1 m\n- `chairs[2]`: x + 2 m\n\nno errors from 0.99 to 3.51";
        let found = told(&text, usize::MAX);
        assert_eq!(found[0].split(" to ").next(), expected.split(" to ").next(), "{found:?}");
    }

    #[test]
    fn errors_are_told_with_the_nearest_values_that_have_none() {
        let text = format!("{ROW}for i, c in enumerate(chairs):\n    c.min.x = scene.min.x + i * 0.5\n    c.min.y = 0\n");
        let found = told(&text, usize::MAX);
        assert!(found[0].contains("no errors from 0.99") && found[0].ends_with("2 errors now among what it moves"), "{found:?}");
    }

    #[test]
    fn what_moves_nothing_says_so() {
        let text = format!("{ROW}x = 0.25\nfor i, c in enumerate(chairs):\n    c.min.x = i * 1.5\n    c.min.y = 0\n");
        assert_eq!(told(&text, usize::MAX)[0], "moves no object");
    }

    #[test]
    fn a_small_budget_finds_less_and_says_so() {
        let text = format!("{ROW}for i, c in enumerate(chairs):\n    c.min.x = scene.min.x + i * 1.5\n    c.min.y = 0\n");
        let found = told(&text, 12);
        assert!(found[0].ends_with("or farther"), "{found:?}");
    }
}
