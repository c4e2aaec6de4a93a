//! Numbers, objects and errors in the few words that an editor has room for.

use super::program::Scene;
use crate::check::{ErrorKind, Violation};
use crate::scene::{Kind, Placed, Support, Target, Told};

/// Metres to the millimetre, without zeros that say nothing.
pub(super) fn number(value: f64) -> String {
    if !value.is_finite() || value.abs() >= 1e9 {
        return format!("{value:e}");
    }
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.replace('-', "−") }
}

pub(super) fn vector(values: [f64; 3]) -> String {
    format!("({})", values.map(number).join(", "))
}

/// `1.6 × 2 × 0.6 m`
pub(super) fn size(object: &Placed) -> String {
    format!("{} m", object.body.dims.map(number).join(" × "))
}

/// `3 errors`
pub(super) fn counted(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}

/// Text of the user in Markdown: as it is, on one line, cut where it is long.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for ch in text.chars().take(200) {
        match ch {
            '\n' | '\r' | '\t' => out.push(' '),
            ch if ch.is_control() => out.push('\u{fffd}'),
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '(' | ')' | '#' | '+' | '-' | '.' | '!' | '|' | '<' | '>' | '&' | '~'
            | '$' => {
                out.push('\\');
                out.push(ch);
            }
            ch => out.push(ch),
        }
    }
    out
}

/// Code of the user in Markdown.
pub(super) fn code(text: &str) -> String {
    let line: String = text.chars().take(200).map(|ch| if ch.is_control() { ' ' } else { ch }).collect();
    if line.contains('`') { format!("`` {line} ``") } else { format!("`{line}`") }
}

/// Text of the user on one line, cut where it is long.
pub(super) fn plain_line(text: &str) -> String {
    let line: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if line.chars().count() > 80 { line.chars().take(79).chain(['…']).collect() } else { line }
}

pub(super) fn kind(object: &Placed) -> &'static str {
    match (object.body.kind, object.body.support) {
        (Kind::Door, _) => "door",
        (Kind::Window, _) => "window",
        (_, Support::Standing) => "standing",
        (_, Support::Mounted) => "mounted",
        (_, Support::Floating) => "floating",
    }
}

/// Where it looks, and why, in Markdown.
pub(super) fn facing(object: &Placed, scene: &Scene) -> String {
    let turn = object.body.turn.name();
    match object.body.told {
        Told::Toward(Target::Object(id)) => {
            let target = scene.object(id.index()).map_or_else(String::new, |target| code(&target.path));
            format!("faces {target}: `{turn}`")
        }
        Told::Toward(Target::Scene) => format!("faces the scene: `{turn}`"),
        Told::Point => format!("faces a point: `{turn}`"),
        Told::Direction => format!("faces `{turn}`"),
        Told::Never if object.body.directed => format!("faces `{turn}`, as its walls or its category have it"),
        Told::Never => format!("faces `{turn}`; nothing turns it"),
    }
}

/// An error of an object, from its side, in Markdown.
pub(super) fn error(violation: &Violation, object: usize, scene: &Scene) -> String {
    let other = violation.objects().find(|index| *index != object).and_then(|index| scene.object(index));
    let other = other.map_or_else(|| "the scene".to_string(), |other| code(&other.path));
    let by = match violation.metres {
        metres if metres > 0.0 => format!(" by {} m", number(metres)),
        _ => String::new(),
    };
    match violation.kind {
        ErrorKind::OutOfBounds => format!("sticks out of the scene{by}"),
        ErrorKind::Overlap => format!("overlaps {other}{by}"),
        ErrorKind::Standing => format!("floats or sinks{by}"),
        ErrorKind::Mounted => format!("hangs off the wall{by}"),
        ErrorKind::Facing => "does not face what it was told to".into(),
        ErrorKind::Clearance if violation.culprit as usize == object => format!("is blocked by {other}{by}"),
        ErrorKind::Clearance => format!("stands in the way of {other}{by}"),
        ErrorKind::FacingWall => "faces the wall that it is placed against".into(),
        ErrorKind::ShortSide => "has its short side to the wall".into(),
        ErrorKind::Unplaced => "was never placed: x or y is missing".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!([1.0, -0.25, 0.1 + 0.2, -1e-9, 12345.6789].map(number), ["1", "−0.25", "0.3", "0", "12345.679"]);
        assert_eq!(number(f64::INFINITY), "inf");
    }

    #[test]
    fn names_cannot_become_markup() {
        assert_eq!(escaped("a*b\n<img src=x>"), "a\\*b \\<img src=x\\>");
        assert_eq!(code("a`b"), "`` a`b ``");
    }
}
