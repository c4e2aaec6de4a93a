//! Places of a file as lines and columns that people and tools count in.

use super::FileReport;
use crate::check::finding::{Place, Source};
use crate::syntax::{Encoding, LineIndex};
use ruff_text_size::{TextRange, TextSize};
use serde::Serialize;

/// A point in a text. Lines and columns are counted from 1, columns in characters.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub(super) struct Point {
    pub line: u32,
    pub column: u32,
    /// Bytes from the start of the text.
    pub offset: u32,
}

/// A range in one of the texts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Span<'a> {
    pub path: &'a str,
    pub text: &'a str,
    pub start: Point,
    pub end: Point,
}

/// A file with its lines counted.
pub(super) struct View<'a> {
    program: Lines<'a>,
    template: Option<Lines<'a>>,
}

struct Lines<'a> {
    path: &'a str,
    text: &'a str,
    index: LineIndex,
}

impl<'a> Lines<'a> {
    fn new(path: &'a str, text: &'a str) -> Lines<'a> {
        Lines { path, text, index: LineIndex::new(text) }
    }

    fn point(&self, offset: TextSize) -> Point {
        let at = self.index.line_column(offset, self.text, Encoding::Utf32);
        let offset = offset.to_u32().min(u32::try_from(self.text.len()).unwrap_or(u32::MAX));
        Point { line: at.line.saturating_add(1), column: at.column.saturating_add(1), offset }
    }
}

impl<'a> View<'a> {
    pub(super) fn new(file: &FileReport<'a>) -> View<'a> {
        View { program: Lines::new(file.path, file.text), template: file.template.map(|(path, text)| Lines::new(path, text)) }
    }

    fn lines(&self, source: Source) -> &Lines<'a> {
        match (source, &self.template) {
            (Source::Template, Some(template)) => template,
            _ => &self.program,
        }
    }

    pub(super) fn span(&self, place: Place) -> Span<'a> {
        let lines = self.lines(place.source);
        Span { path: lines.path, text: lines.text, start: lines.point(place.range.start()), end: lines.point(place.range.end()) }
    }

    /// The text of a line (counted from 1), without its end.
    pub(super) fn line_text(&self, source: Source, line: u32) -> &'a str {
        let lines = self.lines(source);
        &lines.text[lines.index.line_range(line.saturating_sub(1), lines.text)]
    }

    /// The bytes of the lines from `first` to `last` (counted from 1).
    pub(super) fn lines_range(&self, source: Source, first: u32, last: u32) -> TextRange {
        let lines = self.lines(source);
        let start = lines.index.line_start(first.saturating_sub(1), lines.text);
        TextRange::new(start, lines.index.line_range(last.saturating_sub(1), lines.text).end().max(start))
    }
}
