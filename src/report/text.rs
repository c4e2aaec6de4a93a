//! For people: each finding with its source underlined, in the manner of rustc.

use super::view::View;
use super::{FileReport, Summary};
use crate::check::finding::{Finding, Place, Severity, Source};
use annotate_snippets::{Annotation, AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet};
use std::borrow::Cow;
use std::fmt::Write as _;

/// Places further apart than this many lines are shown in two snippets.
const NEAR: u32 = 60;
/// A range of more lines than this is underlined in its first line only.
const TALL: u32 = 8;
/// Lines of more bytes than this are not shown.
const LONG: usize = 4_000;
/// Of the places that explain a finding, this many are shown.
const RELATED: usize = 6;

/// One place to underline.
struct Mark<'a> {
    place: Place,
    first: u32,
    last: u32,
    kind: AnnotationKind,
    label: Option<&'a str>,
}

/// All findings of a file.
pub(super) fn file(file: &FileReport, color: bool) -> String {
    if file.findings.is_empty() {
        return String::new();
    }
    let view = View::new(file);
    let renderer = renderer(color);
    let pieces: Vec<String> = file.findings.iter().map(|finding| renderer.render(&[group(&view, file, finding)]) + "\n").collect();
    pieces.join("\n")
}

fn renderer(color: bool) -> Renderer {
    if color { Renderer::styled() } else { Renderer::plain() }
}

fn level(severity: Severity) -> Level<'static> {
    match severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Info => Level::INFO,
    }
}

fn group<'a>(view: &View<'a>, file: &FileReport<'a>, finding: &'a Finding) -> Group<'a> {
    let title = level(finding.severity).primary_title(finding.message.as_str()).id(finding.code.name());
    let mut group = Group::with_title(title);
    for cluster in clusters(view, finding) {
        group = group.element(element(view, file, &cluster));
    }
    for note in &finding.notes {
        group = group.element(Level::NOTE.message(clean(note)));
    }
    if finding.related.len() > RELATED {
        group = group.element(Level::NOTE.message(format!("{} more places are not shown", finding.related.len() - RELATED)));
    }
    if finding.partial {
        group = group.element(Level::NOTE.message("the program did not run to its end, so this may change once it does"));
    }
    for fix in finding.fix.iter().chain(&finding.suggestion) {
        group = group.element(Level::HELP.message(clean(&fix.title)));
    }
    group
}

/// The places of a finding, those that lie close to each other together, the primary one's first.
fn clusters<'a>(view: &View<'a>, finding: &'a Finding) -> Vec<Vec<Mark<'a>>> {
    let mark = |place: Place, kind: AnnotationKind, label: Option<&'a str>| {
        let span = view.span(place);
        let last = if span.end.line - span.start.line > TALL { span.start.line } else { span.end.line };
        Mark { place, first: span.start.line, last, kind, label }
    };
    let primary = mark(finding.place, AnnotationKind::Primary, None);
    let related = finding.related.iter().take(RELATED);
    let mut rest: Vec<Mark> = related.map(|r| mark(r.place, AnnotationKind::Context, Some(r.message.as_str()))).collect();
    rest.sort_by_key(|mark| (mark.place.source, mark.first));
    let mut clusters = vec![vec![primary]];
    for mark in rest {
        let near = |other: &Mark| {
            other.place.source == mark.place.source && other.first.max(mark.first).saturating_sub(other.last.min(mark.last)) <= NEAR
        };
        match clusters.iter_mut().find(|cluster| cluster.iter().any(near)) {
            Some(cluster) => cluster.push(mark),
            None => clusters.push(vec![mark]),
        }
    }
    clusters
}

/// The lines of some places with the places underlined.
fn element<'a>(view: &View<'a>, file: &FileReport<'a>, marks: &[Mark<'a>]) -> Element<'a> {
    let source = marks[0].place.source;
    let first = marks.iter().map(|mark| mark.first).min().unwrap_or(1);
    let last = marks.iter().map(|mark| mark.last).max().unwrap_or(first);
    let here = view.span(marks[0].place);
    let slice = view.lines_range(source, first, last);
    let text = &here.text[slice];
    let template = file.template.map_or(file.path, |(path, _)| path);
    let path = clean(if source == Source::Template { template } else { file.path });
    if text.split(['\n', '\r']).any(|line| line.len() > LONG) {
        return Origin::path(path).line(here.start.line as usize).char_column(here.start.column as usize).into();
    }
    let annotations = marks.iter().map(|mark| {
        let range = mark.place.range;
        let whole = view.lines_range(source, mark.first, mark.last);
        let start = range.start().clamp(slice.start(), slice.end()) - slice.start();
        let end = range.end().clamp(range.start(), whole.end().max(range.start())).min(slice.end()).max(slice.start()) - slice.start();
        let start = text.floor_char_boundary(start.to_usize());
        let annotation = mark.kind.span(start..text.floor_char_boundary(end.to_usize()).max(start));
        annotation.label(mark.label.map(Cow::Borrowed))
    });
    // The renderer knows no line ends but these two; the other one has the same length.
    let text = if has_lone_return(text) { Cow::Owned(lone_returns_replaced(text)) } else { Cow::Borrowed(text) };
    Snippet::<Annotation>::source(text).line_start(first as usize).path(path).annotations(annotations).into()
}

/// Text that may hold several lines, without anything that a terminal would obey.
fn clean(text: &str) -> String {
    let lines: Vec<String> = text.lines().map(annotate_snippets::normalize_untrusted_str).collect();
    lines.join("\n")
}

fn has_lone_return(text: &str) -> bool {
    text.replace("\r\n", "").contains('\r')
}

fn lone_returns_replaced(text: &str) -> String {
    text.replace("\r\n", "\u{0}\n").replace('\r', "\n").replace("\u{0}\n", "\r\n")
}

/// The summary by kind.
pub(super) fn tail(summary: &Summary, color: bool, statistics: bool) -> String {
    let (bold, plain) = if color { ("\u{1b}[1m", "\u{1b}[0m") } else { ("", "") };
    let files = count(summary.files, "file");
    let mut tail = String::new();
    if summary.files == 0 {
        return "no programs found\n".into();
    }
    let said = summary.errors + summary.warnings + summary.infos;
    if said == 0 {
        let _ = writeln!(tail, "{bold}no findings{plain} in {files}");
        return tail;
    }
    let parts = [(summary.errors, "error"), (summary.warnings, "warning"), (summary.infos, "note")];
    let parts: Vec<String> = parts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| count(*n, word)).collect();
    let _ = write!(tail, "\n{bold}{}{plain} in {} of {files}", parts.join(", "), summary.failing_files);
    if summary.loss > 0 {
        let _ = write!(tail, ", weighted loss {}", summary.loss);
    }
    tail.push('\n');
    let kinds = summary.by_frequency();
    if statistics {
        let width = kinds.iter().map(|(_, n)| n.to_string().len()).max().unwrap_or(1);
        for (kind, n) in kinds {
            let _ = writeln!(tail, "{n:>width$} {kind}");
        }
    } else {
        let kinds: Vec<String> = kinds.iter().map(|(kind, n)| format!("{n} {kind}")).collect();
        let _ = writeln!(tail, "{}", kinds.join(", "));
    }
    tail
}

fn count(n: usize, word: &str) -> String {
    format!("{n} {word}{}", if n == 1 { "" } else { "s" })
}
