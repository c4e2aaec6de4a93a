//! The last room of the pure core: findings and the texts they are about → what a person or a machine reads.
//!
//! One renderer a format. A run over thousands of files must not hold them all, so a report is made in pieces: a
//! [`Printer`] gives the head, one piece for each file (in any order, on any thread), what stands between two pieces,
//! and the tail. A piece that is empty is left out, together with what would have stood before it.
//!
//! Invariants:
//! - Plain functions of their arguments: the same findings give the same bytes.
//! - Whatever the names, messages and sources contain, a report stays well-formed and sends no control character to a
//!   terminal.
//!
//! It knows nothing of how findings came about, and writes to nothing.

mod fingerprint;
mod github;
mod gitlab;
mod json;
mod junit;
mod sarif;
mod summary;
mod text;
mod view;

pub use fingerprint::fingerprints;
pub use summary::Summary;

use crate::check::finding::Finding;

/// What the findings of one file are about.
#[derive(Clone, Copy, Debug)]
pub struct FileReport<'a> {
    /// The path as it should be shown, with forward slashes.
    pub path: &'a str,
    /// The program.
    pub text: &'a str,
    /// Path and text of its sidecar template.
    pub template: Option<(&'a str, &'a str)>,
    /// What was found, in the order in which it should be shown.
    pub findings: &'a [Finding],
    /// The names of the objects that [`Finding::objects`] counts.
    pub objects: &'a [String],
}

/// How a report is written.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Format {
    /// For people: the source underlined.
    #[default]
    Text,
    /// One JSON document.
    Json,
    /// One JSON object a line.
    Jsonl,
    /// SARIF 2.1.0, for code scanning.
    Sarif,
    /// Workflow commands that annotate a pull request on GitHub.
    Github,
    /// A Code Quality report of GitLab.
    Gitlab,
    /// JUnit XML, for test reports.
    Junit,
}

impl Format {
    /// All formats with their names.
    pub const ALL: [(Format, &'static str); 7] = [
        (Format::Text, "text"),
        (Format::Json, "json"),
        (Format::Jsonl, "jsonl"),
        (Format::Sarif, "sarif"),
        (Format::Github, "github"),
        (Format::Gitlab, "gitlab"),
        (Format::Junit, "junit"),
    ];
}

/// A format and how it is dressed.
#[derive(Clone, Copy, Debug, Default)]
pub struct Printer {
    /// The format.
    pub format: Format,
    /// Whether the text format uses colours.
    pub color: bool,
    /// Whether the text format ends with a table of how often each kind was found.
    pub statistics: bool,
}

impl Printer {
    /// What stands before the first piece.
    pub fn head(&self) -> String {
        match self.format {
            Format::Text | Format::Jsonl | Format::Github => String::new(),
            Format::Json => json::head(),
            Format::Sarif => sarif::head(),
            Format::Gitlab => gitlab::HEAD.to_string(),
            Format::Junit => junit::HEAD.to_string(),
        }
    }

    /// The piece about one file; empty where nothing is to be said.
    pub fn file(&self, file: &FileReport) -> String {
        match self.format {
            Format::Text => text::file(file, self.color),
            Format::Json => json::file(file),
            Format::Jsonl => json::lines(file),
            Format::Sarif => sarif::file(file),
            Format::Github => github::file(file),
            Format::Gitlab => gitlab::file(file),
            Format::Junit => junit::file(file),
        }
    }

    /// What stands between two pieces.
    pub fn between(&self) -> &'static str {
        match self.format {
            Format::Text => "\n",
            Format::Jsonl | Format::Github | Format::Junit => "",
            Format::Json | Format::Sarif | Format::Gitlab => ",\n",
        }
    }

    /// What stands after the last piece.
    pub fn tail(&self, summary: &Summary) -> String {
        match self.format {
            Format::Text => text::tail(summary, self.color, self.statistics),
            Format::Json => json::tail(summary),
            Format::Jsonl => json::last_line(summary),
            Format::Sarif => sarif::tail(),
            Format::Github => String::new(),
            Format::Gitlab => gitlab::TAIL.to_string(),
            Format::Junit => junit::TAIL.to_string(),
        }
    }

    /// A whole report at once.
    pub fn all(&self, files: &[FileReport]) -> String {
        let mut summary = Summary::default();
        let mut report = self.head();
        let mut first = true;
        for file in files {
            summary.add(file.findings);
            let piece = self.file(file);
            if piece.is_empty() {
                continue;
            }
            if !std::mem::take(&mut first) {
                report.push_str(self.between());
            }
            report.push_str(&piece);
        }
        report.push_str(&self.tail(&summary));
        report
    }
}

/// The name of an object of a finding; one that the report was not given is shown by its number.
fn object_name(file: &FileReport, index: usize) -> String {
    file.objects.get(index).cloned().unwrap_or_else(|| format!("object {index}"))
}

/// Plain data of ours always serializes: its keys are strings, and numbers that JSON lacks become null.
fn to_json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}
