//! What `ide` offers to change, as code actions.

use super::client::Client;
use super::diagnostics::Report;
use crate::check::finding::Finding;
use crate::ide;
use crate::syntax::LineColumn;
use ruff_text_size::TextRange;
use std::collections::HashMap;
use tower_lsp_server::ls_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, Diagnostic, DocumentChanges, OneOf,
    OptionalVersionedTextDocumentIdentifier, Position, TextDocumentEdit, TextEdit, WorkspaceEdit,
};

/// The fixes that the findings under a range carry.
pub(super) fn quick_fixes(report: &Report, params: &CodeActionParams, client: Client) -> Vec<CodeActionOrCommand> {
    if !asked_for(&CodeActionKind::QUICKFIX, params.context.only.as_deref()) {
        return Vec::new();
    }
    let (findings, diagnostics): (Vec<&Finding>, Vec<&Diagnostic>) =
        report.items.iter().filter_map(|item| Some((item.finding.as_ref()?, &item.diagnostic))).unzip();
    let offset = |position: Position| {
        let place = LineColumn { line: position.line, column: position.character };
        report.text.lines.offset(place, &report.text.text, client.encoding)
    };
    let (start, end) = (offset(params.range.start), offset(params.range.end));
    let range = TextRange::new(start.min(end), start.max(end));
    let action = |fix: ide::QuickFix| {
        let edits = fix.edits.iter().map(|(range, text)| TextEdit::new(report.text.range(*range, client), text.clone())).collect();
        CodeActionOrCommand::CodeAction(CodeAction {
            title: fix.title.to_string(),
            kind: Some(CodeActionKind::QUICKFIX),
            diagnostics: Some(fix.resolves.iter().map(|index| diagnostics[*index].clone()).collect()),
            edit: Some(edit(report, edits, client)),
            is_preferred: Some(true),
            ..CodeAction::default()
        })
    };
    ide::quick_fixes(findings, range).into_iter().map(action).collect()
}

/// Whether a kind of action is among those that the client wants to see.
fn asked_for(kind: &CodeActionKind, only: Option<&[CodeActionKind]>) -> bool {
    let inside = |wanted: &CodeActionKind| {
        let rest = kind.as_str().strip_prefix(wanted.as_str());
        wanted.as_str().is_empty() || rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    only.is_none_or(|only| only.iter().any(inside))
}

/// Edits of the text that the report is about, and of no other version of it where the client can tell.
fn edit(report: &Report, edits: Vec<TextEdit>, client: Client) -> WorkspaceEdit {
    let Some(uri) = report.text.uri.clone() else { return WorkspaceEdit::default() };
    if !client.document_changes {
        return WorkspaceEdit { changes: Some(HashMap::from([(uri, edits)])), ..WorkspaceEdit::default() };
    }
    let text_document = OptionalVersionedTextDocumentIdentifier { uri, version: report.text.version };
    let edits = edits.into_iter().map(OneOf::Left).collect();
    let document_changes = Some(DocumentChanges::Edits(vec![TextDocumentEdit { text_document, edits }]));
    WorkspaceEdit { document_changes, ..WorkspaceEdit::default() }
}
