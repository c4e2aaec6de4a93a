//! Findings in the words of the protocol.

use super::client::Client;
use super::run::Text;
use crate::check::finding::{Code, Finding, Place, Severity, Source};
use crate::config::ConfigError;
use ruff_text_size::TextRange;
use serde::Serialize;
use serde_json::json;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::str::FromStr;
use tower_lsp_server::ls_types::{
    CodeDescription, Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag, Location, NumberOrString, Position,
    Range, Uri,
};

/// Ends the message of a finding of an older run.
const STALE: &str = " (stale: from the last run; the text cannot be run as it is)";

/// A diagnostic, and the finding that it came from.
#[derive(Debug)]
pub(super) struct Item {
    /// What is wrong with a configuration is no finding.
    pub finding: Option<Finding>,
    pub diagnostic: Diagnostic,
}

/// What there is to say about one document.
#[derive(Debug)]
pub(super) struct Report {
    pub text: Text,
    pub items: Vec<Item>,
    /// The diagnostics as they are sent, written once and not under the lock.
    pub json: String,
    /// Equal where the same is said.
    pub id: String,
}

impl Report {
    pub(super) fn new(text: Text, items: Vec<Item>) -> Report {
        let diagnostics: Vec<&Diagnostic> = items.iter().map(|item| &item.diagnostic).collect();
        // Diagnostics can always be written: they hold no map with keys that are no text.
        let json = serde_json::to_string(&diagnostics).unwrap_or_else(|_| "[]".into());
        let mut hasher = DefaultHasher::new();
        json.hash(&mut hasher);
        Report { text, id: format!("{:016x}", hasher.finish()), items, json }
    }

    /// The diagnostics.
    pub(super) fn diagnostics(&self) -> Vec<Diagnostic> {
        self.items.iter().map(|item| item.diagnostic.clone()).collect()
    }
}

impl Text {
    pub(super) fn range(&self, range: TextRange, client: Client) -> Range {
        let position = |offset| {
            let at = self.lines.line_column(offset, &self.text, client.encoding);
            Position::new(at.line, at.column)
        };
        Range::new(position(range.start()), position(range.end()))
    }
}

/// What a diagnostic carries for the editor to come back with.
#[derive(Serialize)]
struct Data<'a> {
    stale: bool,
    partial: bool,
    count: usize,
    metres: f64,
    objects: &'a [String],
}

/// Writes diagnostics of one program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Writer<'a> {
    pub program: &'a Text,
    pub template: Option<&'a Text>,
    pub client: Client,
}

impl Writer<'_> {
    fn text(&self, source: Source) -> &Text {
        match (source, self.template) {
            (Source::Template, Some(template)) => template,
            _ => self.program,
        }
    }

    fn location(&self, place: Place) -> Option<Location> {
        let text = self.text(place.source);
        Some(Location { uri: text.uri.clone()?, range: text.range(place.range, self.client) })
    }

    /// A finding; `objects` are the names of those that it is about, `stale` says that it is of an older run.
    pub(super) fn item(&self, finding: Finding, objects: &[String], stale: bool) -> Item {
        let mut message = finding.message.clone();
        if stale {
            message.push_str(STALE);
        }
        for note in &finding.notes {
            message.push('\n');
            message.push_str(note);
        }
        let related = finding.related.iter().filter_map(|related| {
            let location = self.location(related.place)?;
            Some(DiagnosticRelatedInformation { location, message: related.message.clone() })
        });
        let related: Vec<_> = if self.client.related_information { related.collect() } else { Vec::new() };
        let unneeded = matches!(finding.code, Code::UnusedConstant | Code::UnusedSuppression);
        let data = Data { stale, partial: finding.partial, count: finding.count, metres: finding.metres, objects };
        let diagnostic = Diagnostic {
            range: self.text(finding.place.source).range(finding.place.range, self.client),
            severity: Some(match finding.severity {
                Severity::Error => DiagnosticSeverity::ERROR,
                Severity::Warning => DiagnosticSeverity::WARNING,
                Severity::Info => DiagnosticSeverity::INFORMATION,
            }),
            code: Some(NumberOrString::String(finding.code.name().into())),
            code_description: page(finding.code).filter(|_| self.client.code_description),
            source: Some("psdl".into()),
            message,
            related_information: (!related.is_empty()).then_some(related),
            tags: (unneeded && self.client.unnecessary).then(|| vec![DiagnosticTag::UNNECESSARY]),
            data: serde_json::to_value(data).ok(),
        };
        Item { finding: Some(finding), diagnostic }
    }

    /// At the program: that its configuration cannot be used.
    pub(super) fn bad_configuration(&self, error: &ConfigError) -> Item {
        let lines = crate::syntax::LineIndex::new(&error.text);
        let first = error.problems.first();
        let line = first.map_or(0, |problem| lines.line(problem.range.start())) + 1;
        let what = first.map_or("", |problem| problem.message.as_str());
        let message = format!("{}:{line}: {what}; the defaults hold until this is mended", error.path.display());
        problem(Range::default(), message)
    }
}

/// What is wrong with a configuration, at its places.
pub(super) fn configuration(error: &ConfigError, text: &Text, client: Client) -> Vec<Item> {
    error.problems.iter().map(|found| problem(text.range(found.range, client), found.message.clone())).collect()
}

/// An error that is no finding of a program.
fn problem(range: Range, message: String) -> Item {
    let diagnostic = Diagnostic {
        range,
        severity: Some(DiagnosticSeverity::ERROR),
        code: Some(NumberOrString::String("configuration".into())),
        source: Some("psdl".into()),
        message,
        data: Some(json!({ "stale": false })),
        ..Diagnostic::default()
    };
    Item { finding: None, diagnostic }
}

/// The page that explains a code.
fn page(code: Code) -> Option<CodeDescription> {
    Uri::from_str(&code.url()).ok().map(|href| CodeDescription { href })
}
