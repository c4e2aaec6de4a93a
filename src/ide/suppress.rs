//! A comment that hides a finding: `# psdl: ignore[overlap]`.

use crate::check::finding::{Code, Finding, Source};
use crate::syntax::{Edit, LineIndex, Parsed};
use ruff_text_size::{Ranged as _, TextRange, TextSize};

/// Beyond the comment itself.
const MARK: &str = "psdl: ignore[";

/// The edit that hides a finding at its statement; none where no comment can.
pub fn suppress(text: &str, parsed: &Parsed, finding: &Finding) -> Option<Edit> {
    let never = [Code::Unreadable, Code::SyntaxError, Code::MarkdownFence, Code::Template, Code::Limit, Code::UnusedSuppression];
    if finding.place.source != Source::Program || never.contains(&finding.code) {
        return None;
    }
    let lines = LineIndex::new(text);
    let code = finding.code.name();
    let line = lines.line(finding.place.range.start());
    let (start, end) = (lines.line_start(line, text), lines.line_range(line, text).end());
    let comment =
        parsed.tokens().iter().find(|token| token.kind().is_comment() && TextRange::new(start, end).contains_range(token.range()));
    if let Some(comment) = comment {
        let at = text.get(comment.range().start().to_usize()..comment.range().end().to_usize())?.find(MARK);
        if let Some(at) = at {
            let at = comment.range().start() + TextSize::new(u32::try_from(at + MARK.len()).ok()?);
            return Some((TextRange::empty(at), format!("{code}, ")));
        }
    }
    let content = text.get(start.to_usize()..end.to_usize())?;
    let inside = |at: TextSize| {
        parsed.tokens().iter().any(|token| !token.kind().is_any_newline() && token.range().start() < at && at < token.range().end())
    };
    if comment.is_none() && !content.trim_end().ends_with('\\') && !inside(end) && !content.trim().is_empty() {
        let at = start + TextSize::of(content.trim_end());
        return Some((TextRange::new(at, end), format!("  # {MARK}{code}]")));
    }
    let indent: String = content.chars().take_while(|c| matches!(c, ' ' | '\t')).collect();
    let newline = if text.contains("\r\n") { "\r\n" } else { "\n" };
    (!inside(start)).then(|| (TextRange::empty(start), format!("{indent}# {MARK}{code}]{newline}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Input, Options, analyse};
    use crate::syntax::parse;

    const TWO: &str = "a = Object('A', 1, 1, 1)\nb = Object('B', 1, 1, 1)\na.center = (0, 0, 0.5)\n";

    /// The program's end after its overlap was hidden; then nothing is told any more.
    fn hidden(end: &str) -> String {
        let mut text = format!("{TWO}{end}");
        let look = |text: &str| analyse(&Input { text, template: None }, &Options::default(), None).findings;
        let findings = look(&text);
        let overlap = findings.iter().find(|finding| finding.code == Code::Overlap).expect("an overlap");
        let (range, new) = suppress(&text, &parse(&text), overlap).expect("it can be hidden");
        text.replace_range(range.start().to_usize()..range.end().to_usize(), &new);
        assert_eq!(look(&text).iter().map(|finding| finding.code).collect::<Vec<_>>(), [], "{text}");
        text[TWO.len()..].to_string()
    }

    #[test]
    fn a_comment_goes_behind_the_statement() {
        assert_eq!(hidden("b.center = (0.5, 0, 0.5)\n"), "b.center = (0.5, 0, 0.5)  # psdl: ignore[overlap]\n");
        assert_eq!(hidden("b.center = (0.5, 0, 0.5)"), "b.center = (0.5, 0, 0.5)  # psdl: ignore[overlap]");
        assert_eq!(hidden("b.center = (0.5,\n  0, 0.5)"), "b.center = (0.5,  # psdl: ignore[overlap]\n  0, 0.5)");
    }

    #[test]
    fn or_above_it_where_the_line_is_taken() {
        assert_eq!(hidden("b.center = (0.5, 0, 0.5)  # here\n"), "# psdl: ignore[overlap]\nb.center = (0.5, 0, 0.5)  # here\n");
        assert_eq!(
            hidden("if True:\n  b.center = \\\n   (0.5, 0, 0.5)\n"),
            "if True:\n  # psdl: ignore[overlap]\n  b.center = \\\n   (0.5, 0, 0.5)\n"
        );
    }

    #[test]
    fn a_comment_that_is_there_hides_one_kind_more() {
        let text = format!("{TWO}b.center = (0.5, 0, 0.75)  # psdl: ignore[standing]\n");
        let findings = analyse(&Input { text: &text, template: None }, &Options::default(), None).findings;
        let (_, new) = suppress(&text, &parse(&text), &findings[0]).expect("it can be hidden");
        assert_eq!(new, "overlap, ");
    }
}
