//! Comments that hide findings: `# psdl: ignore[overlap]` at a statement or on the line above it, `# psdl: ignore-file` for the whole text.
//!
//! A comment that hides nothing is a finding itself, with the change that removes it.

use crate::check::codes::UnknownCode;
use crate::check::finding::{Code, Finding, Fix, Place, Source};
use crate::syntax::ast::statement_visitor::{StatementVisitor, walk_stmt};
use crate::syntax::ast::{Ranged as _, Stmt};
use crate::syntax::{LineIndex, Parsed};
use ruff_text_size::{TextRange, TextSize};

/// How the comments begin, after the `#`.
const MARK: &str = "psdl:";

/// A comment.
struct Comment {
    /// The comment, from its `#`.
    range: TextRange,
    /// Its line, from 0.
    line: u32,
    /// Nothing else stands on its line.
    alone: bool,
    /// It holds for the whole text.
    whole_file: bool,
    /// What it hides, each with its place; nothing stands for everything.
    codes: Vec<(Code, TextRange)>,
    /// Which of the codes hid something (the first stands for everything where there are none).
    used: Vec<bool>,
}

/// Takes away the findings that comments hide, and adds those about the comments. `complete` says that all findings are
/// there, so that a comment which hides none is of no use.
pub(super) fn apply(findings: &mut Vec<Finding>, parsed: &Parsed, text: &str, complete: bool) {
    let (mut comments, mut about) = read(parsed, text);
    if comments.is_empty() {
        findings.append(&mut about);
        return;
    }
    let lines = LineIndex::new(text);
    let mut statements = Statements(Vec::new());
    parsed.with_stack(|| parsed.module.body.iter().for_each(|stmt| statements.visit_stmt(stmt)));
    findings.retain(|finding| !hidden(finding, &mut comments, &statements.0, &lines, text));
    if complete {
        about.extend(comments.iter().flat_map(|comment| unused(comment, &lines, text)));
    }
    findings.append(&mut about);
}

/// The simple statements, and the headers of the others.
struct Statements(Vec<TextRange>);

impl StatementVisitor<'_> for Statements {
    fn visit_stmt(&mut self, stmt: &Stmt) {
        let body = match stmt {
            Stmt::For(s) => s.body.first(),
            Stmt::While(s) => s.body.first(),
            Stmt::If(s) => s.body.first(),
            Stmt::With(s) => s.body.first(),
            Stmt::Try(s) => s.body.first(),
            Stmt::FunctionDef(s) => s.body.first(),
            Stmt::ClassDef(s) => s.body.first(),
            _ => None,
        };
        let end = body.map_or(stmt.end(), |first| first.start().max(stmt.start()));
        self.0.push(TextRange::new(stmt.start(), end));
        walk_stmt(self, stmt);
    }
}

/// What a comment can hide: what a person may decide to live with.
fn can_be_hidden(finding: &Finding) -> bool {
    let never = [Code::Unreadable, Code::SyntaxError, Code::MarkdownFence, Code::Template, Code::Limit, Code::UnusedSuppression];
    finding.place.source == Source::Program && !never.contains(&finding.code)
}

fn hidden(finding: &Finding, comments: &mut [Comment], statements: &[TextRange], lines: &LineIndex, text: &str) -> bool {
    if !can_be_hidden(finding) {
        return false;
    }
    let place = finding.place.range;
    let around = statements.iter().filter(|range| range.contains(place.start())).min_by_key(|range| range.len());
    let range = around.copied().unwrap_or(place);
    // The first statement of a block begins on a line of its own, so the header ends on the line before.
    let (first, mut last) = (lines.line(range.start()), lines.line(range.end()));
    if last > first && text[lines.line_start(last, text).to_usize()..range.end().to_usize()].trim().is_empty() {
        last -= 1;
    }
    let mut hides = false;
    for comment in comments {
        let here = comment.whole_file || (first..=last).contains(&comment.line) || (comment.alone && comment.line + 1 == first);
        if !here {
            continue;
        }
        match comment.codes.iter().position(|(code, _)| *code == finding.code) {
            Some(at) => comment.used[at] = true,
            None if comment.codes.is_empty() => comment.used[0] = true,
            None => continue,
        }
        hides = true;
    }
    hides
}

/// All comments of this kind, and what is wrong with them.
fn read(parsed: &Parsed, text: &str) -> (Vec<Comment>, Vec<Finding>) {
    let (mut comments, mut about) = (Vec::new(), Vec::new());
    if !text.contains(MARK) {
        return (comments, about);
    }
    let lines = LineIndex::new(text);
    for token in parsed.tokens().iter().filter(|token| token.kind().is_comment()) {
        let range = token.range();
        let Some(rest) = text[range].trim_start_matches('#').trim_start().strip_prefix(MARK) else { continue };
        match directive(rest, range.end() - TextSize::of(rest), &mut about) {
            Some((whole_file, codes)) => {
                let line = lines.line(range.start());
                let alone = text[lines.line_start(line, text).to_usize()..range.start().to_usize()].trim().is_empty();
                let used = vec![false; codes.len().max(1)];
                comments.push(Comment { range, line, alone, whole_file, codes, used });
            }
            None => about.push(remark(range, "a comment for psdl is `# psdl: ignore[KIND]` or `# psdl: ignore-file`".into())),
        }
    }
    (comments, about)
}

type Directive = (bool, Vec<(Code, TextRange)>);

/// Reads ` ignore[overlap, standing]`, which begins at `start`.
fn directive(rest: &str, start: TextSize, about: &mut Vec<Finding>) -> Option<Directive> {
    let word = rest.trim_start();
    let (whole_file, after) = match word.strip_prefix("ignore-file") {
        Some(after) => (true, after),
        None => (false, word.strip_prefix("ignore")?),
    };
    let Some(list) = after.trim_start().strip_prefix('[') else {
        let ends = after.chars().next().is_none_or(|next| next.is_whitespace());
        return ends.then_some((whole_file, Vec::new()));
    };
    let (list, _) = list.split_once(']')?;
    let mut at = start + TextSize::of(rest) - TextSize::of(after.trim_start()) + TextSize::new(1);
    let mut codes = Vec::new();
    for part in list.split(',') {
        let range = TextRange::at(at + TextSize::of(part) - TextSize::of(part.trim_start()), TextSize::of(part.trim()));
        at += TextSize::of(part) + TextSize::new(1);
        match part.parse::<Code>() {
            Ok(code) => codes.push((code, range)),
            Err(error) => about.push(unknown(range, &error)),
        }
    }
    // A list without a known kind hides nothing, rather than everything.
    (!codes.is_empty()).then_some((whole_file, codes)).or(Some((whole_file, vec![(Code::UnusedSuppression, TextRange::empty(at))])))
}

fn remark(range: TextRange, message: String) -> Finding {
    Finding::new(Code::UnusedSuppression, Place::program(range), message)
}

fn unknown(range: TextRange, error: &UnknownCode) -> Finding {
    let mut finding = remark(range, error.to_string());
    if let Some(nearest) = error.nearest {
        finding.fix = Some(Fix { title: format!("write {nearest}"), edits: vec![(range, nearest.name().into())] });
    }
    finding
}

/// What a comment says in vain.
fn unused(comment: &Comment, lines: &LineIndex, text: &str) -> Vec<Finding> {
    let idle: Vec<usize> = (0..comment.used.len()).filter(|at| !comment.used[*at]).collect();
    let said = |at: &usize| comment.codes.get(*at).filter(|(code, _)| *code != Code::UnusedSuppression);
    if idle.is_empty() || (!comment.codes.is_empty() && idle.iter().all(|at| said(at).is_none())) {
        return Vec::new();
    }
    if idle.len() == comment.used.len() {
        let where_ = if comment.whole_file { "in this file" } else { "here" };
        let names: Vec<&str> = idle.iter().filter_map(said).map(|(code, _)| code.name()).collect();
        let what = if names.is_empty() { "nothing".into() } else { format!("no {}", names.join(" and no ")) };
        let mut finding = remark(comment.range, format!("there is {what} to ignore {where_}"));
        finding.fix = Some(Fix { title: "remove the comment".into(), edits: vec![(removal(comment, lines, text), String::new())] });
        return vec![finding];
    }
    let kept: Vec<&str> = comment.codes.iter().zip(&comment.used).filter(|(_, used)| **used).map(|((code, _), _)| code.name()).collect();
    let first = comment.codes[0].1.start();
    let last = comment.codes[comment.codes.len() - 1].1.end();
    let findings = idle.iter().filter_map(said).map(|(code, range)| {
        let mut finding = remark(*range, format!("there is no {code} to ignore here"));
        finding.fix = Some(Fix { title: "ignore only what is there".into(), edits: vec![(TextRange::new(first, last), kept.join(", "))] });
        finding
    });
    findings.collect()
}

/// The comment with the blanks before it; with its line, where nothing else stands there.
fn removal(comment: &Comment, lines: &LineIndex, text: &str) -> TextRange {
    let start = lines.line_start(comment.line, text);
    if comment.alone {
        return TextRange::new(start, lines.line_start(comment.line + 1, text));
    }
    let before = &text[start.to_usize()..comment.range.start().to_usize()];
    TextRange::new(start + TextSize::of(before.trim_end()), comment.range.end())
}

#[cfg(test)]
mod tests {
    use crate::analysis::{Input, Options, analyse};

    const TWO: &str = "a = Object('A', 1, 1, 1)\nb = Object('B', 1, 1, 1)\na.center = (0, 0, 0.5)\n";

    /// The findings of a program that goes on like this: kind, what is underlined, message; and the text after all fixes.
    fn check(end: &str) -> (Vec<(String, String)>, String) {
        let text = format!("{TWO}{end}");
        let analysis = analyse(&Input { text: &text, template: None }, &Options::default(), None);
        let told = analysis.findings.iter().map(|f| (f.code.name().to_string(), text[f.place.range].to_string()));
        let mut fixed = text.clone();
        let mut edits: Vec<_> = analysis.findings.iter().filter_map(|f| f.fix.clone()).flat_map(|fix| fix.edits).collect();
        edits.sort_by_key(|(range, _)| range.start());
        edits.dedup();
        for (range, new) in edits.into_iter().rev() {
            fixed.replace_range(range.start().to_usize()..range.end().to_usize(), &new);
        }
        (told.collect(), fixed[TWO.len()..].to_string())
    }

    #[test]
    fn a_comment_hides_what_it_names_at_its_statement() {
        for end in [
            "b.center = (0.5, 0, 0.5)  # psdl: ignore[overlap]",
            "b.center = (0.5, 0, 0.5)  #psdl:ignore",
            "# psdl: ignore[overlap] it is meant so\nb.center = (0.5, 0, 0.5)",
            "b.center = (0.5,  # psdl: ignore[overlap]\n    0, 0.5)",
            "# psdl: ignore-file[overlap]\nb.center = (0.5, 0, 0.5)",
            "b.center = (0.5, 0, 0.5)\n# psdl: ignore-file",
            "for _ in range(1):\n    b.center = (0.5, 0, 0.5)  # psdl: ignore[overlap]",
        ] {
            assert_eq!(check(end).0, [], "{end}");
        }
    }

    #[test]
    fn a_comment_elsewhere_or_for_something_else_hides_nothing() {
        let (told, fixed) = check("b.center = (0.5, 0, 0.5)  # psdl: ignore[standing]\n");
        assert_eq!(told[0], ("overlap".into(), "b.center = (0.5, 0, 0.5)".into()));
        assert_eq!(told[1], ("unused-suppression".into(), "# psdl: ignore[standing]".into()));
        assert_eq!(fixed, "b.center = (0.5, 0, 0.5)\n");
        let (told, fixed) = check("# psdl: ignore\n\nb.center = (0.5, 0, 0.5)");
        assert_eq!(told.len(), 2);
        assert_eq!(fixed, "\nb.center = (0.5, 0, 0.5)");
    }

    #[test]
    fn the_part_of_a_comment_that_hides_nothing_is_told() {
        let (told, fixed) = check("b.center = (0.5, 0, 0.5)  # psdl: ignore[overlap, standing]\n");
        assert_eq!(told, [("unused-suppression".to_string(), "standing".to_string())]);
        assert_eq!(fixed, "b.center = (0.5, 0, 0.5)  # psdl: ignore[overlap]\n");
    }

    #[test]
    fn a_slip_in_the_comment_is_told() {
        let (told, fixed) = check("b.center = (0.5, 0, 0.5)  # psdl: ignore[overlpa]\n");
        assert_eq!(told[1], ("unused-suppression".into(), "overlpa".into()));
        assert_eq!(fixed, "b.center = (0.5, 0, 0.5)  # psdl: ignore[overlap]\n");
        assert_eq!(check("b.center = (2.0, 0, 0.5)  # psdl: ignroe\n").0[0].0, "unused-suppression");
        assert_eq!(check("b.center = (2.0, 0, 0.5)  # psdl: ignore[\n").0[0].0, "unused-suppression");
        assert_eq!(check("b.center = (2.0, 0, 0.5)\nprint('# psdl: ignore')").0, []);
    }

    #[test]
    fn what_keeps_a_program_from_running_is_not_hidden() {
        assert_eq!(check("b.center = (0.5, 0  # psdl: ignore\n").0[0].0, "syntax-error");
    }
}
