//! Where findings of an older text are in a newer one.

use crate::check::finding::{Finding, Place, Source};
use ruff_text_size::{TextRange, TextSize};

/// The bytes from `start` to `end` gave way to `length` others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct TextChange {
    pub start: usize,
    pub end: usize,
    pub length: usize,
}

impl TextChange {
    /// Where a range is after the change; `None` if all of it is gone.
    fn moved(&self, range: TextRange) -> Option<TextRange> {
        let after = self.start + self.length;
        let (from, to) = (range.start().to_usize(), range.end().to_usize());
        let behind = |at: usize| at - self.end + after;
        let start = match from {
            at if at >= self.end => behind(at),
            at if at <= self.start => at,
            _ => after,
        };
        let end = match to {
            at if at <= self.start => at,
            at if at >= self.end => behind(at),
            _ => self.start,
        };
        let size = |at: usize| TextSize::new(u32::try_from(at).unwrap_or(u32::MAX));
        let gone = from < to && (start >= end || (self.start <= from && to <= self.end && self.start < self.end));
        (!gone).then(|| TextRange::new(size(start), size(end.max(start))))
    }

    fn place(&self, source: Source, place: Place) -> Option<Place> {
        if place.source != source {
            return Some(place);
        }
        self.moved(place.range).map(|range| Place { source, range })
    }

    /// Moves a finding with the text; false if its place is gone. Its fix was for the older text and is dropped.
    pub(super) fn carry(&self, source: Source, finding: &mut Finding) -> bool {
        finding.fix = None;
        finding.suggestion = None;
        finding.related.retain_mut(|related| match self.place(source, related.place) {
            Some(place) => {
                related.place = place;
                true
            }
            None => false,
        });
        match self.place(source, finding.place) {
            Some(place) => {
                finding.place = place;
                true
            }
            None => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Replaces what stands between `<` and `>`; the range is between `[` and `]` before and after.
    fn check(before: &str, new: &str, after: Option<&str>) {
        let mut text = String::new();
        let mut marks = std::collections::BTreeMap::new();
        for ch in before.chars() {
            if "<>[]".contains(ch) {
                marks.insert(ch, text.len());
            } else {
                text.push(ch);
            }
        }
        let range = TextRange::new((marks[&'['] as u32).into(), (marks[&']'] as u32).into());
        let change = TextChange { start: marks[&'<'], end: marks[&'>'], length: new.len() };
        text.replace_range(change.start..change.end, new);
        let found = change.moved(range).map(|range| {
            text.insert(range.end().to_usize(), ']');
            text.insert(range.start().to_usize(), '[');
            text
        });
        assert_eq!(found.as_deref(), after, "{before}");
    }

    #[test]
    fn what_is_changed_elsewhere_moves_it() {
        check("<x>a[bc]d", "12", Some("12a[bc]d"));
        check("a[bc]d<x>", "12", Some("a[bc]d12"));
        check("a<>[bc]d", "12", Some("a12[bc]d"));
        check("a[bc]<>d", "12", Some("a[bc]12d"));
    }

    #[test]
    fn what_is_changed_inside_stretches_it() {
        check("[b<>c]", "12", Some("[b12c]"));
        check("[a<bc>d]", "", Some("[ad]"));
        check("[<a>b]", "12", Some("[12b]"));
    }

    #[test]
    fn what_is_left_of_it_stays() {
        check("<a[b>c]", "12", Some("12[c]"));
        check("[a<b]c>", "12", Some("[a]12"));
    }

    #[test]
    fn what_is_gone_is_gone() {
        check("a<[bc]>d", "12", None);
        check("<a[bc]d>", "", None);
    }

    #[test]
    fn a_place_without_width_is_kept() {
        check("a<>[]b", "12", Some("a12[]b"));
        check("a[]<b>", "12", Some("a[]12"));
    }
}
