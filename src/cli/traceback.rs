//! A traceback in CPython's words, with the source underlined.

use crate::python::vm::{CallChain, Shown, Uncaught};
use crate::syntax::{Encoding, LineIndex};
use std::fmt::Write as _;

/// The whole text for an exception that nobody caught, causes first.
pub(super) fn traceback(path: &str, text: &str, uncaught: &Uncaught) -> String {
    let lines = LineIndex::new(text);
    let mut out = String::new();
    for (at, shown) in uncaught.chain.iter().enumerate() {
        out.push_str("Traceback (most recent call last):\n");
        for level in levels(&shown.calls) {
            frame(&mut out, path, text, &lines, level);
        }
        ending(&mut out, shown);
        if at + 1 < uncaught.chain.len() {
            let how = if shown.direct {
                "The above exception was the direct cause of the following exception:"
            } else {
                "During handling of the above exception, another exception occurred:"
            };
            let _ = writeln!(out, "\n{how}\n");
        }
    }
    out
}

type Level = (String, ruff_text_size::TextRange);

fn levels(calls: &CallChain) -> impl Iterator<Item = &Level> {
    calls.levels.iter()
}

fn frame(out: &mut String, path: &str, text: &str, lines: &LineIndex, (function, range): &Level) {
    let start = lines.line_column(range.start(), text, Encoding::Utf32);
    let path = annotate_snippets::normalize_untrusted_str(path);
    let _ = writeln!(out, "  File \"{path}\", line {}, in {function}", start.line + 1);
    let line = lines.line_range(start.line, text);
    let (source, shift) = (&text[line], text[line].len() - text[line].trim_start().len());
    let _ = writeln!(out, "    {}", annotate_snippets::normalize_untrusted_str(source.trim()));
    let inside = range.intersect(line).unwrap_or_default();
    let from = inside.start().checked_sub(line.start()).map_or(0, |at| at.to_usize()).max(shift);
    let to = inside.end().checked_sub(line.start()).map_or(0, |at| at.to_usize()).min(source.trim_end().len());
    // Underlining the whole line says nothing more than showing it.
    if from < to && (from, to) != (shift, source.trim_end().len()) {
        let (before, under) = (source[shift..from].chars().count(), source[from..to].chars().count());
        let _ = writeln!(out, "    {}{}", " ".repeat(before), "^".repeat(under));
    }
}

fn ending(out: &mut String, shown: &Shown) {
    for text in std::iter::once(&shown.line).chain(&shown.notes) {
        for line in text.split('\n') {
            let _ = writeln!(out, "{}", annotate_snippets::normalize_untrusted_str(line));
        }
    }
}
