//! What can be folded away, and what grows around a selection.

use super::find::{for_each_node, nodes_at};
use super::program::View;
use crate::syntax::LineIndex;
use crate::syntax::ast::{AnyNodeRef, Ranged as _, Stmt};
use ruff_text_size::{TextRange, TextSize};

/// Why something can be folded.
#[derive(Clone, Copy, PartialEq, Eq, Debug, PartialOrd, Ord)]
pub enum FoldKind {
    /// Lines of comments.
    Comment,
    /// Lines of imports.
    Imports,
    /// A block, or what stands in brackets.
    Code,
}

/// Whole lines that can be folded into the first of them.
#[derive(Clone, Copy, PartialEq, Eq, Debug, PartialOrd, Ord)]
pub struct Fold {
    /// The line that stays, from 0.
    pub start: u32,
    /// The last line that goes.
    pub end: u32,
    /// Why.
    pub kind: FoldKind,
}

/// Everything that can be folded, by line.
pub fn folds(view: &View) -> Vec<Fold> {
    let lines = LineIndex::new(view.text());
    let mut folds = Vec::new();
    let mut add = |range: TextRange, kind: FoldKind| {
        // What ends right before a line ends on the line before.
        let last = range.end().max(range.start() + TextSize::new(1)) - TextSize::new(1);
        let fold = Fold { start: lines.line(range.start()), end: lines.line(last), kind };
        if fold.end > fold.start {
            folds.push(fold);
        }
    };
    for_each_node(view, &mut |node| match node {
        AnyNodeRef::StmtFunctionDef(def) => add(TextRange::new(def.name.range.start(), def.range.end()), FoldKind::Code),
        AnyNodeRef::StmtIf(branch) => {
            let first = branch.body.last().map_or(branch.range.end(), |last| last.range().end());
            add(TextRange::new(branch.range.start(), first), FoldKind::Code);
        }
        AnyNodeRef::StmtClassDef(_)
        | AnyNodeRef::StmtFor(_)
        | AnyNodeRef::StmtWhile(_)
        | AnyNodeRef::StmtWith(_)
        | AnyNodeRef::StmtTry(_)
        | AnyNodeRef::StmtMatch(_)
        | AnyNodeRef::ElifElseClause(_)
        | AnyNodeRef::ExceptHandlerExceptHandler(_)
        | AnyNodeRef::MatchCase(_)
        | AnyNodeRef::ExprList(_)
        | AnyNodeRef::ExprTuple(_)
        | AnyNodeRef::ExprDict(_)
        | AnyNodeRef::ExprSet(_)
        | AnyNodeRef::ExprListComp(_)
        | AnyNodeRef::ExprCall(_)
        | AnyNodeRef::ExprStringLiteral(_)
        | AnyNodeRef::Parameters(_) => add(node.range(), FoldKind::Code),
        _ => {}
    });
    for run in runs(&view.program.parsed.module.body, |stmt| matches!(stmt, Stmt::Import(_) | Stmt::ImportFrom(_))) {
        add(run, FoldKind::Imports);
    }
    comments(view.text(), &lines, &mut folds);
    folds.sort_unstable();
    folds.dedup_by_key(|fold| fold.start);
    folds
}

/// Neighbours among the statements that are of one kind.
fn runs(body: &[Stmt], is_one: impl Fn(&Stmt) -> bool) -> Vec<TextRange> {
    let mut runs: Vec<TextRange> = Vec::new();
    let mut open = false;
    for stmt in body {
        match runs.last_mut().filter(|_| open) {
            Some(run) if is_one(stmt) => *run = run.cover(stmt.range()),
            _ if is_one(stmt) => runs.push(stmt.range()),
            _ => {}
        }
        open = is_one(stmt);
    }
    runs
}

/// Lines that hold nothing but a comment, one under the other.
fn comments(text: &str, lines: &LineIndex, folds: &mut Vec<Fold>) {
    let mut start = None;
    let count = u32::try_from(lines.line_count()).unwrap_or(u32::MAX);
    for line in 0..=count {
        let range = lines.line_range(line, text);
        let content = text.get(range.start().to_usize()..range.end().to_usize()).unwrap_or_default();
        if line < count && content.trim_start().starts_with('#') {
            start.get_or_insert(line);
        } else if let Some(start) = start.take().filter(|start| line > start + 1) {
            folds.push(Fold { start, end: line - 1, kind: FoldKind::Comment });
        }
    }
}

/// What a selection at a place grows to, step by step, the smallest first.
pub fn selections(view: &View, offset: TextSize) -> Vec<TextRange> {
    let token = view.program.parsed.tokens().iter().map(|token| token.range()).find(|range| range.contains(offset));
    let nodes = nodes_at(view, offset);
    let mut around: Vec<TextRange> = nodes.iter().rev().map(|node| node.range()).chain(token).collect();
    around.push(TextRange::up_to(TextSize::of(view.text())));
    around.push(TextRange::empty(offset.min(TextSize::of(view.text()))));
    around.sort_by_key(|range| range.len());
    // Each must hold the one before.
    let mut steps: Vec<TextRange> = Vec::new();
    for range in around {
        if steps.last().is_none_or(|last| range.contains_range(*last) && range != *last) {
            steps.push(range);
        }
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::Fixture;

    #[test]
    fn blocks_brackets_comments_and_imports_fold() {
        let text =
            "import math\nimport random\n# one\n# two\nx = [\n  1,\n  2,\n]\nif x:\n    a = 1\nelse:\n    a = 2\ndef f():\n    pass\n";
        let fixture = Fixture::new(text);
        let found: Vec<_> = folds(&fixture.view()).into_iter().map(|fold| (fold.start, fold.end, fold.kind)).collect();
        let code = FoldKind::Code;
        let expected = [(0, 1, FoldKind::Imports), (2, 3, FoldKind::Comment), (4, 7, code), (8, 9, code), (10, 11, code), (12, 13, code)];
        assert_eq!(found, expected);
    }

    #[test]
    fn selections_grow_from_the_name_to_the_text() {
        let fixture = Fixture::new("for c in chairs:\n    c.mi$0n.x = 0.5\n");
        let view = fixture.view();
        let texts: Vec<&str> = selections(&view, fixture.offset).into_iter().map(|range| view.slice(range)).collect();
        let whole = fixture.text();
        assert_eq!(texts, ["", "min", "c.min", "c.min.x", "c.min.x = 0.5", &whole[..whole.len() - 1], whole]);
    }
}
