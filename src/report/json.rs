//! JSON and JSON lines. The shape is described in `docs/json.md`; a change that breaks readers raises [`VERSION`].

use super::fingerprint::fingerprints;
use super::view::{Point, View};
use super::{FileReport, Summary, object_name, to_json};
use crate::check::finding::{self, Finding, Place};
use ruff_text_size::TextRange;
use serde::Serialize;
use std::fmt::Write as _;

/// The version of the format.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Head<'a> {
    version: u32,
    psdl: &'a str,
}

#[derive(Serialize)]
struct File<'a> {
    path: &'a str,
    findings: Vec<One<'a>>,
}

#[derive(Serialize)]
struct One<'a> {
    code: &'a str,
    severity: &'a str,
    message: &'a str,
    url: String,
    location: Location<'a>,
    related: Vec<Related<'a>>,
    notes: &'a [String],
    objects: Vec<String>,
    count: usize,
    metres: f64,
    loss: u64,
    fix: Option<Fix<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    suggestion: Option<Fix<'a>>,
    partial: bool,
    fingerprint: String,
}

#[derive(Serialize)]
struct Location<'a> {
    path: &'a str,
    start: Point,
    end: Point,
}

#[derive(Serialize)]
struct Related<'a> {
    message: &'a str,
    location: Location<'a>,
}

#[derive(Serialize)]
struct Fix<'a> {
    title: &'a str,
    edits: Vec<Edit<'a>>,
}

#[derive(Serialize)]
struct Edit<'a> {
    start: Point,
    end: Point,
    text: &'a str,
}

#[derive(Serialize)]
#[serde(tag = "type", rename_all = "lowercase")]
enum Line<'a> {
    Finding {
        path: &'a str,
        #[serde(flatten)]
        finding: Box<One<'a>>,
    },
    Summary {
        #[serde(flatten)]
        head: Head<'a>,
        #[serde(flatten)]
        summary: &'a Summary,
    },
}

const HEAD: Head = Head { version: VERSION, psdl: env!("CARGO_PKG_VERSION") };

pub(super) fn head() -> String {
    format!("{{\"version\":{},\"psdl\":{},\"files\":[\n", HEAD.version, to_json(&HEAD.psdl))
}

pub(super) fn tail(summary: &Summary) -> String {
    format!("\n],\"summary\":{}}}\n", to_json(summary))
}

pub(super) fn file(file: &FileReport) -> String {
    if file.findings.is_empty() {
        return String::new();
    }
    to_json(&File { path: file.path, findings: findings(file) })
}

pub(super) fn lines(file: &FileReport) -> String {
    findings(file).into_iter().fold(String::new(), |mut lines, finding| {
        let _ = writeln!(lines, "{}", to_json(&Line::Finding { path: file.path, finding: Box::new(finding) }));
        lines
    })
}

pub(super) fn last_line(summary: &Summary) -> String {
    to_json(&Line::Summary { head: HEAD, summary }) + "\n"
}

fn findings<'a>(file: &FileReport<'a>) -> Vec<One<'a>> {
    let view = View::new(file);
    file.findings.iter().zip(fingerprints(file)).map(|(finding, fingerprint)| one(file, &view, finding, fingerprint)).collect()
}

fn one<'a>(file: &FileReport<'a>, view: &View<'a>, finding: &'a Finding, fingerprint: String) -> One<'a> {
    One {
        code: finding.code.name(),
        severity: finding.severity.name(),
        message: &finding.message,
        url: finding.code.url(),
        location: location(view, finding.place),
        related: finding.related.iter().map(|r| Related { message: &r.message, location: location(view, r.place) }).collect(),
        notes: &finding.notes,
        objects: finding.objects.iter().map(|index| object_name(file, *index)).collect(),
        count: finding.count,
        metres: finding.metres,
        loss: finding.loss,
        fix: finding.fix.as_ref().map(|fix| change(view, fix)),
        suggestion: finding.suggestion.as_ref().map(|fix| change(view, fix)),
        partial: finding.partial,
        fingerprint,
    }
}

fn change<'a>(view: &View<'a>, fix: &'a finding::Fix) -> Fix<'a> {
    let edit = |(range, text): &'a (TextRange, String)| {
        let span = view.span(Place::program(*range));
        Edit { start: span.start, end: span.end, text }
    };
    Fix { title: &fix.title, edits: fix.edits.iter().map(edit).collect() }
}

fn location<'a>(view: &View<'a>, place: Place) -> Location<'a> {
    let span = view.span(place);
    Location { path: span.path, start: span.start, end: span.end }
}
