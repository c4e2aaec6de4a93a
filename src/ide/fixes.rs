//! Changes of the text that resolve a finding by themselves, as the finding carries them.

use crate::check::finding::{Finding, Source};
use ruff_text_size::TextRange;

/// A change that can be offered.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct QuickFix<'a> {
    /// What it does.
    pub title: &'a str,
    /// Byte ranges of the program and what replaces them; disjoint, in ascending order.
    pub edits: &'a [(TextRange, String)],
    /// The findings that it resolves, as indices.
    pub resolves: Vec<usize>,
}

/// The changes for the findings that a range of the program touches, each once.
pub fn quick_fixes<'a>(findings: impl IntoIterator<Item = &'a Finding>, range: TextRange) -> Vec<QuickFix<'a>> {
    let mut fixes: Vec<QuickFix> = Vec::new();
    for (index, finding) in findings.into_iter().enumerate() {
        let Some(fix) = finding.fix.as_ref().filter(|_| touches(finding, range)) else { continue };
        match fixes.iter_mut().find(|known| known.title == fix.title && known.edits == fix.edits) {
            Some(known) => known.resolves.push(index),
            None => fixes.push(QuickFix { title: &fix.title, edits: &fix.edits, resolves: vec![index] }),
        }
    }
    fixes
}

/// Whether they share a byte, or meet: a cursor at the end of what is underlined means it.
pub fn touches(finding: &Finding, range: TextRange) -> bool {
    finding.place.source == Source::Program && finding.place.range.intersect(range).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Input, Options, analyse};

    /// The titles offered at the `|`, and the text after the first of them.
    fn at_cursor(marked: &str) -> (Vec<String>, Option<String>) {
        let at = marked.find('|').unwrap();
        let mut text = marked.replacen('|', "", 1);
        let findings = analyse(&Input { text: &text, template: None }, &Options::default(), None).findings;
        let fixes = quick_fixes(&findings, TextRange::empty(u32::try_from(at).unwrap().into()));
        let titles = fixes.iter().map(|fix| fix.title.to_string()).collect();
        let first = fixes.first().map(|fix| {
            for (range, new) in fix.edits.iter().rev() {
                text.replace_range(range.start().to_usize()..range.end().to_usize(), new);
            }
            text
        });
        (titles, first)
    }

    #[test]
    fn markdown_fences_go_together() {
        let (titles, fixed) = at_cursor("```py|thon\nset_size(5, 6, 3)\n```\n");
        assert_eq!(titles.len(), 1, "{titles:?}");
        assert_eq!(fixed.as_deref(), Some("set_size(5, 6, 3)\n"));
    }

    #[test]
    fn a_cursor_at_the_end_of_the_place_means_it_and_one_elsewhere_does_not() {
        assert_eq!(at_cursor("set_size(5, 6, 3)\nx = centre|(scene)\n").0, ["replace 'centre' by 'center'"]);
        assert!(at_cursor("set_si|ze(5, 6, 3)\nx = centre(scene)\n").0.is_empty());
    }
}
