//! The searches that can be offered: for the whole program, for a selection, for all errors of one kind.

use crate::check::ErrorKind;
use crate::check::finding::{Finding, Source};
use ruff_text_size::TextRange;

/// A search for corrections that can be offered.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Search {
    /// What it is for. It does not say how much will be found.
    pub title: String,
    /// The kinds of errors to work on; all where empty.
    pub kinds: Vec<ErrorKind>,
    /// Only what lies inside is rewritten.
    pub within: Option<TextRange>,
}

/// The kind of layout error that a finding is about; none where it has no loss to lessen.
pub fn kind_of(finding: &Finding) -> Option<ErrorKind> {
    let kind = ErrorKind::ALL.into_iter().find(|kind| kind.code() == finding.code)?;
    (kind != ErrorKind::Unplaced && finding.place.source == Source::Program).then_some(kind)
}

/// The search for all errors, if there are any.
pub fn whole<'a>(findings: impl IntoIterator<Item = &'a Finding>) -> Option<Search> {
    let any = findings.into_iter().any(|finding| kind_of(finding).is_some());
    any.then(|| Search { title: "Fix all layout errors that can be fixed".into(), kinds: Vec::new(), within: None })
}

/// The searches for what is selected: the selection, where errors lie in it, and each kind that it touches and that is elsewhere too.
pub fn around<'a>(findings: impl IntoIterator<Item = &'a Finding> + Clone, range: TextRange) -> Vec<Search> {
    let all = || findings.clone().into_iter().filter_map(|finding| Some((finding, kind_of(finding)?)));
    let touched: Vec<(&Finding, ErrorKind)> = all().filter(|(finding, _)| finding.place.range.intersect(range).is_some()).collect();
    let mut searches = Vec::new();
    if !range.is_empty() && !touched.is_empty() {
        searches.push(Search { title: "Fix what can be fixed in the selection".into(), kinds: Vec::new(), within: Some(range) });
    }
    for kind in ErrorKind::ALL {
        let count: usize = all().filter(|(_, other)| *other == kind).map(|(finding, _)| finding.count).sum();
        if count > 1 && touched.iter().any(|(_, other)| *other == kind) {
            let title = format!("Fix all {count} {} errors that can be fixed", kind.name());
            searches.push(Search { title, kinds: vec![kind], within: None });
        }
    }
    searches
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Input, Options, analyse};

    const TEXT: &str = "a = [Object('A', 1, 1, 1) for _ in range(3)]
a[0].center = (0, 0, 0.5)
a[1].center = (0.5, 0, 0.5)
a[2].center = (-0.5, 0, 0.75)
";

    fn titles(part: &str, length: usize) -> Vec<String> {
        let findings = analyse(&Input { text: TEXT, template: None }, &Options::default(), None).findings;
        let start = u32::try_from(TEXT.find(part).unwrap()).unwrap();
        let range = TextRange::at(start.into(), u32::try_from(length).unwrap().into());
        around(&findings, range).into_iter().map(|search| search.title).collect()
    }

    #[test]
    fn a_cursor_at_an_error_offers_its_kind() {
        assert_eq!(titles("a[1].center", 0), ["Fix all 2 overlap errors that can be fixed"]);
        assert!(titles("Object", 0).is_empty());
    }

    #[test]
    fn a_selection_is_a_place_to_rewrite() {
        assert_eq!(titles("a[2].center", 8), ["Fix what can be fixed in the selection", "Fix all 2 overlap errors that can be fixed"]);
    }

    #[test]
    fn a_program_without_errors_offers_no_search() {
        assert_eq!(whole(&analyse(&Input { text: "x = 1\n", template: None }, &Options::default(), None).findings), None);
    }
}
