//! JUnit XML: a test suite a file, a test case a finding; a file without findings is one test that passed.

use super::FileReport;
use super::view::View;
use crate::check::finding::{Finding, Severity};
use crate::markup::xml;
use std::fmt::Write as _;

pub(super) const HEAD: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"psdl\">\n";
pub(super) const TAIL: &str = "</testsuites>\n";

pub(super) fn file(file: &FileReport) -> String {
    let failures = file.findings.iter().filter(|f| f.severity.fails() && f.code.is_layout()).count();
    let errors = file.findings.iter().filter(|f| f.severity.fails() && !f.code.is_layout()).count();
    let path = xml(file.path);
    let tests = file.findings.len().max(1);
    let mut suite = format!("  <testsuite name=\"{path}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\">\n");
    if file.findings.is_empty() {
        let _ = writeln!(suite, "    <testcase name=\"no findings\" classname=\"{path}\"/>");
    }
    let view = View::new(file);
    for finding in file.findings {
        case(&mut suite, &view, &path, finding);
    }
    suite.push_str("  </testsuite>\n");
    suite
}

fn case(suite: &mut String, view: &View, path: &str, finding: &Finding) {
    let span = view.span(finding.place);
    let code = finding.code.name();
    let message = xml(&finding.message);
    let (line, column) = (span.start.line, span.start.column);
    let _ = writeln!(suite, "    <testcase name=\"{code} at {line}:{column}\" classname=\"{path}\">");
    let mut body = format!("{}:{line}:{column}: {}", span.path, finding.message);
    for note in &finding.notes {
        let _ = write!(body, "\n{note}");
    }
    let body = xml(&body);
    let _ = match (finding.severity, finding.code.is_layout()) {
        (Severity::Info, _) => writeln!(suite, "      <system-out>{body}</system-out>"),
        (_, true) => writeln!(suite, "      <failure type=\"{code}\" message=\"{message}\">{body}</failure>"),
        (_, false) => writeln!(suite, "      <error type=\"{code}\" message=\"{message}\">{body}</error>"),
    };
    suite.push_str("    </testcase>\n");
}
