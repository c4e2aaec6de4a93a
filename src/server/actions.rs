//! What `ide` offers to change, as code actions: titles at once, edits when one is chosen.

use super::client::Client;
use super::diagnostics::Report;
use super::document;
use super::run::Text;
use super::study::Study;
use crate::check::finding::{Code, Finding, Place};
use crate::ide::{self, Ground, Offer, RefactoringKind, Search, Sidecar};
use crate::repair::Watch;
use crate::syntax::{Edit, LineColumn};
use ruff_text_size::{TextRange, TextSize};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use tower_lsp_server::ls_types::{
    AnnotatedTextEdit, ChangeAnnotation, CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, Command, CreateFile,
    DeleteFile, Diagnostic, DocumentChangeOperation, DocumentChanges, OneOf, OptionalVersionedTextDocumentIdentifier, Position, Range,
    ResourceOp, TextDocumentEdit, TextEdit, Uri, WorkspaceEdit,
};

/// Edits that move more objects than this are shown before they are made, where the client can.
const MANY: usize = 10;

/// The kind of the search for the whole program.
pub(super) const FIX_ALL: CodeActionKind = CodeActionKind::new("source.fixAll.psdl");

/// What an action carries until it is chosen.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub(super) struct Data {
    pub uri: Uri,
    pub version: Option<i32>,
    #[serde(flatten)]
    what: What,
}

/// What an action does. Places are bytes.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
enum What {
    /// One of the offers for a finding.
    Offer { code: String, start: u32, end: u32, index: usize },
    /// A search.
    Search { kinds: Vec<String>, within: Option<(u32, u32)> },
}

/// The edits of an action that was chosen.
pub(super) struct Resolved {
    pub edits: Vec<Edit>,
    pub moves: usize,
}

/// A request for actions with its place in bytes.
struct Asked<'a> {
    study: &'a Study,
    params: &'a CodeActionParams,
    client: Client,
    range: TextRange,
}

/// The actions for a range of a program.
pub(super) fn list(study: &Study, params: &CodeActionParams, client: Client, watch: &Watch) -> Vec<CodeActionOrCommand> {
    let range = study.outcome.main.text.bytes(params.range, client);
    let asked = Asked { study, params, client, range };
    let mut actions = Vec::new();
    if asked.wants(&CodeActionKind::QUICKFIX) {
        actions.extend(asked.quick_fixes());
        actions.extend(asked.offers(watch));
        actions.extend(asked.searches());
        actions.extend(asked.suppressions(watch));
    }
    if asked.wants(&FIX_ALL) {
        let search = ide::search::whole(asked.fresh().map(|(finding, _)| finding));
        actions.extend(search.map(|search| asked.search(&search, FIX_ALL)));
    }
    actions.extend(asked.refactorings(watch));
    actions.into_iter().map(CodeActionOrCommand::CodeAction).collect()
}

/// The kinds of actions that are offered.
pub(super) fn action_kinds() -> Vec<CodeActionKind> {
    let rewritings = RefactoringKind::ALL.map(|kind| CodeActionKind::new(kind.name()));
    [CodeActionKind::QUICKFIX, FIX_ALL].into_iter().chain(rewritings).collect()
}

impl Asked<'_> {
    fn report(&self) -> &Report {
        &self.study.outcome.main
    }

    /// Whether a kind of action is among those that the client wants to see.
    fn wants(&self, kind: &CodeActionKind) -> bool {
        let inside = |wanted: &CodeActionKind| {
            let rest = kind.as_str().strip_prefix(wanted.as_str());
            wanted.as_str().is_empty() || rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        self.params.context.only.as_deref().is_none_or(|only| only.iter().any(inside))
    }

    /// The findings about the text as it is.
    fn fresh(&self) -> impl Iterator<Item = (&Finding, &Diagnostic)> + Clone {
        let fresh = |diagnostic: &Diagnostic| diagnostic.data.as_ref().is_none_or(|data| data["stale"] != true);
        let items = self.report().items.iter().filter(move |item| fresh(&item.diagnostic));
        items.filter_map(|item| Some((item.finding.as_ref()?, &item.diagnostic)))
    }

    fn touched(&self) -> impl Iterator<Item = (&Finding, &Diagnostic)> {
        self.fresh().filter(|(finding, _)| ide::touches(finding, self.range))
    }

    /// The changes that findings carry.
    fn quick_fixes(&self) -> Vec<CodeAction> {
        let (findings, diagnostics): (Vec<&Finding>, Vec<&Diagnostic>) = self.fresh().unzip();
        let action = |fix: ide::QuickFix| CodeAction {
            title: fix.title.to_string(),
            kind: Some(CodeActionKind::QUICKFIX),
            diagnostics: Some(fix.resolves.iter().map(|index| diagnostics[*index].clone()).collect()),
            edit: Some(workspace_edit(&self.report().text, fix.edits, self.client)),
            is_preferred: Some(true),
            ..CodeAction::default()
        };
        ide::quick_fixes(findings, self.range).into_iter().map(action).collect()
    }

    /// The best edits for the layout errors.
    fn offers(&self, watch: &Watch) -> Vec<CodeAction> {
        let mut actions = Vec::new();
        for (finding, diagnostic) in self.touched().filter(|(finding, _)| ide::search::kind_of(finding).is_some()) {
            if watch.cancelled.load(Ordering::Relaxed) {
                break;
            }
            let offers = self.study.with_lab(watch, |lab| lab.offers(finding, Some(&watch.cancelled)).to_vec());
            for (index, offer) in offers.into_iter().flatten().enumerate() {
                let Place { range, .. } = finding.place;
                let (start, end) = (range.start().to_u32(), range.end().to_u32());
                let what = What::Offer { code: finding.code.name().into(), start, end, index };
                let mut action = self.action(offer.title.clone(), CodeActionKind::QUICKFIX, what);
                action.diagnostics = Some(vec![diagnostic.clone()]);
                action.is_preferred = Some(index == 0);
                if !self.client.resolves_edits {
                    action.data = None;
                    action.edit = Some(self.edit(&offer));
                }
                actions.push(action);
            }
        }
        actions
    }

    fn edit(&self, offer: &Offer) -> WorkspaceEdit {
        annotated_edit(&self.report().text, &offer.edits, &offer.title, offer.moves, self.client)
    }

    fn searches(&self) -> Vec<CodeAction> {
        let findings: Vec<&Finding> = self.fresh().map(|(finding, _)| finding).collect();
        let searches = ide::search::around(findings, self.range);
        searches.iter().map(|search| self.search(search, CodeActionKind::QUICKFIX)).collect()
    }

    fn search(&self, search: &Search, kind: CodeActionKind) -> CodeAction {
        let kinds: Vec<String> = search.kinds.iter().map(|kind| kind.name().to_string()).collect();
        let within = search.within.map(|range| (range.start().to_u32(), range.end().to_u32()));
        let mut action = self.action(search.title.clone(), kind, What::Search { kinds: kinds.clone(), within });
        if !self.client.resolves_edits {
            action.data = None;
            let text = &self.report().text;
            let range = search.within.map(|range| text.range(range, self.client));
            let arguments = [serde_json::to_value(&text.uri), serde_json::to_value(range), serde_json::to_value(kinds)];
            action.command = Some(Command {
                title: search.title.clone(),
                command: "psdl.server.fixRange".into(),
                arguments: Some(arguments.into_iter().filter_map(Result::ok).collect()),
            });
        }
        action
    }

    /// Comments that hide what is touched.
    fn suppressions(&self, watch: &Watch) -> Vec<CodeAction> {
        let mut actions: Vec<CodeAction> = Vec::new();
        for (finding, diagnostic) in self.touched() {
            let title = format!("Ignore {} here", finding.code.name());
            if let Some(known) = actions.iter_mut().find(|known| known.title == title) {
                known.diagnostics.iter_mut().for_each(|known| known.push(diagnostic.clone()));
                continue;
            }
            let text = &self.report().text;
            let edit = self.study.with_lab(watch, |lab| ide::suppress(&text.text, lab.problem.parsed(), finding)).flatten();
            if let Some(edit) = edit {
                actions.push(CodeAction {
                    title,
                    kind: Some(CodeActionKind::QUICKFIX),
                    diagnostics: Some(vec![diagnostic.clone()]),
                    edit: Some(workspace_edit(text, &[edit], self.client)),
                    ..CodeAction::default()
                });
            }
        }
        actions
    }

    /// Rewritings that keep the scene.
    fn refactorings(&self, watch: &Watch) -> Vec<CodeAction> {
        let wanted = |kind: RefactoringKind| self.wants(&CodeActionKind::new(kind.name()));
        if !RefactoringKind::ALL.into_iter().any(wanted) {
            return Vec::new();
        }
        let Some(problem) = self.study.with_lab(watch, |lab| lab.problem.clone()) else { return Vec::new() };
        let has_place = self.client.makes_files && self.client.document_changes && self.sidecar().is_some();
        let ground = Ground { problem: &problem, template: self.study.input().template, has_place };
        let action = |found: ide::Refactoring| CodeAction {
            kind: Some(CodeActionKind::new(found.kind.name())),
            edit: Some(self.with_sidecar(workspace_edit(&self.report().text, &found.edits, self.client), found.sidecar)),
            title: found.title,
            ..CodeAction::default()
        };
        ide::refactorings(&ground, self.range, &wanted).into_iter().map(action).collect()
    }

    /// Where the template of the program stands, or would.
    fn sidecar(&self) -> Option<Uri> {
        let path = document::file_path(self.report().text.uri.as_ref()?)?;
        Uri::from_file_path(document::template_of(&path))
    }

    fn with_sidecar(&self, edit: WorkspaceEdit, change: Option<Sidecar>) -> WorkspaceEdit {
        let (Some(change), Some(uri)) = (change, self.sidecar()) else { return edit };
        let Some(DocumentChanges::Edits(edits)) = edit.document_changes else { return edit };
        let mut operations: Vec<DocumentChangeOperation> = edits.into_iter().map(DocumentChangeOperation::Edit).collect();
        match change {
            Sidecar::Deleted => {
                let delete = DeleteFile { uri, options: None, annotation_id: None };
                operations.push(DocumentChangeOperation::Op(ResourceOp::Delete(delete)));
            }
            Sidecar::Created(text) => {
                let create = CreateFile { uri: uri.clone(), options: None, annotation_id: None };
                operations.push(DocumentChangeOperation::Op(ResourceOp::Create(create)));
                let text_document = OptionalVersionedTextDocumentIdentifier { uri, version: None };
                let edits = vec![OneOf::Left(TextEdit::new(Range::default(), text))];
                operations.push(DocumentChangeOperation::Edit(TextDocumentEdit { text_document, edits }));
            }
        }
        WorkspaceEdit { document_changes: Some(DocumentChanges::Operations(operations)), ..edit }
    }

    fn action(&self, title: String, kind: CodeActionKind, what: What) -> CodeAction {
        let text = &self.report().text;
        let data = text.uri.clone().map(|uri| Data { uri, version: text.version, what });
        CodeAction { title, kind: Some(kind), data: data.and_then(|data| serde_json::to_value(data).ok()), ..CodeAction::default() }
    }
}

/// Reads the data of an action.
pub(super) fn data(action: &CodeAction) -> Option<Data> {
    action.data.as_ref().and_then(|data| serde_json::from_value(data.clone()).ok())
}

/// The edits of an action; `None` where there are none (any more).
pub(super) fn resolve(study: &Study, data: &Data, watch: &Arc<Watch>) -> Option<Resolved> {
    let range = |start: u32, end: u32| TextRange::new(start.min(end).into(), end.into());
    match &data.what {
        What::Offer { code, start, end, index } => {
            let (code, place) = (code.parse::<Code>().ok()?, Place::program(range(*start, *end)));
            let offer = study.with_lab(watch, |lab| lab.offers_at(code, place, Some(&watch.cancelled)).get(*index).cloned())??;
            Some(Resolved { edits: offer.edits, moves: offer.moves })
        }
        What::Search { kinds, within } => {
            let kinds = kinds_named(kinds)?;
            let search = Search { title: String::new(), kinds, within: within.map(|(start, end)| range(start, end)) };
            let fix = study.fix(&search, watch)?;
            Some(Resolved { edits: fix.edits.clone(), moves: fix.moved })
        }
    }
}

/// The kinds of errors with these names; `None` where one is no such name.
pub(super) fn kinds_named(names: &[String]) -> Option<Vec<crate::check::ErrorKind>> {
    let kind = |name: &String| crate::check::ErrorKind::ALL.into_iter().find(|kind| kind.name() == name);
    names.iter().map(kind).collect()
}

impl Text {
    /// A range of the text in bytes.
    pub(super) fn bytes(&self, range: Range, client: Client) -> TextRange {
        let offset = |position: Position| -> TextSize {
            let place = LineColumn { line: position.line, column: position.character };
            self.lines.offset(place, &self.text, client.encoding)
        };
        let (start, end) = (offset(range.start), offset(range.end));
        TextRange::new(start.min(end), start.max(end))
    }

    /// Edits in the words of the protocol.
    pub(super) fn text_edits(&self, edits: &[Edit], client: Client) -> Vec<TextEdit> {
        edits.iter().map(|(range, new)| TextEdit::new(self.range(*range, client), new.clone())).collect()
    }
}

/// Edits of this version of a text, and of no other where the client can tell.
pub(super) fn workspace_edit(text: &Text, edits: &[Edit], client: Client) -> WorkspaceEdit {
    let Some(uri) = text.uri.clone() else { return WorkspaceEdit::default() };
    let edits = text.text_edits(edits, client);
    if !client.document_changes {
        return WorkspaceEdit { changes: Some(HashMap::from([(uri, edits)])), ..WorkspaceEdit::default() };
    }
    document_edit(text, edits.into_iter().map(OneOf::Left).collect())
}

/// The same, to be looked at before it is made where it moves many objects.
pub(super) fn annotated_edit(text: &Text, edits: &[Edit], label: &str, moves: usize, client: Client) -> WorkspaceEdit {
    if moves <= MANY || !client.document_changes || !client.annotates {
        return workspace_edit(text, edits, client);
    }
    let id = "psdl".to_string();
    let annotated = |text_edit| OneOf::Right(AnnotatedTextEdit { text_edit, annotation_id: id.clone() });
    let annotation =
        ChangeAnnotation { label: label.to_string(), needs_confirmation: Some(true), description: Some(format!("moves {moves} objects")) };
    let edit = document_edit(text, text.text_edits(edits, client).into_iter().map(annotated).collect());
    WorkspaceEdit { change_annotations: Some(HashMap::from([(id.clone(), annotation)])), ..edit }
}

fn document_edit(text: &Text, edits: Vec<OneOf<TextEdit, AnnotatedTextEdit>>) -> WorkspaceEdit {
    let Some(uri) = text.uri.clone() else { return WorkspaceEdit::default() };
    let text_document = OptionalVersionedTextDocumentIdentifier { uri, version: text.version };
    let document_changes = Some(DocumentChanges::Edits(vec![TextDocumentEdit { text_document, edits }]));
    WorkspaceEdit { document_changes, ..WorkspaceEdit::default() }
}
