//! Markdown around a program: models that write programs like to add it.

use ruff_text_size::{TextRange, TextSize};

use super::error::{Edit, ErrorKind, Fix, SyntaxError};

/// The program without its fences: every byte of them (and of the prose around) is a blank, so all
/// ranges still hold; and an error for each fence, whose fix removes them all.
pub(super) fn without(text: &str, fences: &[TextRange], is_program: impl Fn(&str) -> bool) -> (String, Vec<SyntaxError>) {
    let edits: Vec<Edit> = removed(text, fences, is_program).into_iter().map(|range| (range, String::new())).collect();
    let mut bytes = text.as_bytes().to_vec();
    for (range, _) in &edits {
        for byte in &mut bytes[range.start().to_usize()..range.end().to_usize()] {
            if !matches!(byte, b'\n' | b'\r') {
                *byte = b' ';
            }
        }
    }
    let errors = fences.iter().map(|range| SyntaxError {
        kind: ErrorKind::Fence,
        range: *range,
        message: "Markdown fence: a program holds nothing but Python".to_string(),
        fix: Some(Fix { title: "Remove the Markdown around the program".to_string(), edits: edits.clone() }),
    });
    (String::from_utf8(bytes).unwrap_or_default(), errors.take(MAX_FENCES).collect())
}

/// Each error carries the whole fix, so there are not many.
const MAX_FENCES: usize = 8;

/// What goes: the fences' lines, and the text outside fenced blocks where it is no program.
fn removed(text: &str, fences: &[TextRange], is_program: impl Fn(&str) -> bool) -> Vec<TextRange> {
    let mut ranges: Vec<TextRange> = Vec::new();
    let mut at = TextSize::new(0);
    let mut outside = true;
    let prose = |range: TextRange, ranges: &mut Vec<TextRange>| {
        let part = &text[range];
        if !part.trim().is_empty() && !is_program(part) {
            ranges.push(range);
        }
    };
    for fence in fences {
        let line = whole_line(text, *fence);
        if outside {
            prose(TextRange::new(at, line.start().max(at)), &mut ranges);
        }
        ranges.push(line);
        at = line.end();
        outside = !outside;
    }
    if outside {
        prose(TextRange::new(at, TextSize::of(text)), &mut ranges);
    }
    ranges
}

/// A line with its indentation and its end.
fn whole_line(text: &str, range: TextRange) -> TextRange {
    let before = &text[..range.start().to_usize()];
    let indent = before.len() - before.trim_end_matches([' ', '\t']).len();
    let after = &text[range.end().to_usize()..];
    let ending = if after.starts_with("\r\n") { 2 } else { usize::from(after.starts_with(['\n', '\r'])) };
    let size = |length: usize| TextSize::new(u32::try_from(length).unwrap_or(0));
    TextRange::new(range.start() - size(indent), range.end() + size(ending))
}
