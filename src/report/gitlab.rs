//! GitLab's Code Quality report.

use super::fingerprint::{fingerprints, in_file};
use super::view::View;
use super::{FileReport, to_json};
use crate::check::finding::Severity;
use serde::Serialize;

pub(super) const HEAD: &str = "[\n";
pub(super) const TAIL: &str = "\n]\n";

#[derive(Serialize)]
struct Issue<'a> {
    description: &'a str,
    check_name: &'a str,
    fingerprint: String,
    severity: &'a str,
    location: Location<'a>,
}

#[derive(Serialize)]
struct Location<'a> {
    path: &'a str,
    lines: Lines,
}

#[derive(Serialize)]
struct Lines {
    begin: u32,
    end: u32,
}

pub(super) fn file(file: &FileReport) -> String {
    let view = View::new(file);
    let issues: Vec<String> = file
        .findings
        .iter()
        .zip(fingerprints(file))
        .map(|(finding, fingerprint)| {
            let span = view.span(finding.place);
            to_json(&Issue {
                description: &finding.message,
                check_name: finding.code.name(),
                fingerprint: in_file(file.path, &fingerprint),
                severity: match finding.severity {
                    Severity::Error => "major",
                    Severity::Warning => "minor",
                    Severity::Info => "info",
                },
                location: Location {
                    path: span.path.strip_prefix("./").unwrap_or(span.path),
                    lines: Lines { begin: span.start.line, end: span.end.line },
                },
            })
        })
        .collect();
    issues.join(",\n")
}
