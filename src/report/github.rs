//! Workflow commands: GitHub turns these lines of a job's log into annotations of the pull request.

use super::FileReport;
use super::view::View;
use crate::check::finding::Severity;
use std::fmt::Write as _;

pub(super) fn file(file: &FileReport) -> String {
    let view = View::new(file);
    let mut lines = String::new();
    for finding in file.findings {
        let command = match finding.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Info => "notice",
        };
        let span = view.span(finding.place);
        let _ = write!(lines, "::{command} file={},line={}", property(span.path), span.start.line);
        // Columns are refused for a range of several lines.
        if span.end.line == span.start.line {
            let _ = write!(lines, ",col={},endColumn={}", span.start.column, span.end.column);
        }
        let message = finding.notes.iter().fold(finding.message.clone(), |message, note| message + "\n" + note);
        let title = format!("psdl {}", finding.code.name());
        let _ = writeln!(lines, ",endLine={},title={}::{}", span.end.line, property(&title), data(&message));
    }
    lines
}

/// The text after the second `::`.
fn data(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for ch in text.chars() {
        match ch {
            '%' => out.push_str("%25"),
            '\r' => out.push_str("%0D"),
            '\n' => out.push_str("%0A"),
            '\t' => out.push(ch),
            _ if ch.is_control() => out.push(char::REPLACEMENT_CHARACTER),
            _ => out.push(ch),
        }
    }
    out
}

/// The value of a property before it.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
