//! What helps to write a program: completions and signatures.

use super::handlers::Backend;
use super::view::Wait;
use crate::ide::{self, Completion, CompletionKind as Kind};
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::{
    CompletionItem, CompletionItemKind, CompletionList, CompletionParams, CompletionResponse, CompletionTextEdit, Documentation,
    InsertTextFormat, MarkupContent, MarkupKind, ParameterInformation, ParameterLabel, Range, SignatureHelp, SignatureHelpParams,
    SignatureInformation, TextEdit,
};

/// Of several entries with the same text the best come first.
fn sort_text(rank: u8, at: usize) -> String {
    format!("{rank}{at:04}")
}

impl Backend {
    pub(super) async fn complete(&self, params: CompletionParams) -> Result<Option<CompletionResponse>> {
        let at = params.text_document_position;
        let Some(shot) = self.snapshot(&at.text_document.uri, Wait::No).await? else { return Ok(None) };
        let found = ide::completions(&shot.view(), shot.offset(at.position));
        let range = shot.range(found.replaces);
        let snippets = shot.client.snippets;
        let items = found.items.into_iter().enumerate().map(|(index, item)| entry(item, index, range, snippets)).collect();
        Ok(Some(CompletionResponse::List(CompletionList { is_incomplete: false, items })))
    }

    pub(super) fn explain(&self, mut item: CompletionItem) -> CompletionItem {
        let name = item.data.as_ref().and_then(|data| Some((data.get(0)?.as_str()?, data.get(1)?.as_str()?)));
        if let Some(doc) = name.and_then(|(owner, name)| ide::doc_of(owner, name)) {
            item.documentation = Some(Documentation::MarkupContent(markdown(doc.markdown())));
        }
        item
    }

    pub(super) async fn show_signature(&self, params: SignatureHelpParams) -> Result<Option<SignatureHelp>> {
        let at = params.text_document_position_params;
        let Some(shot) = self.snapshot(&at.text_document.uri, Wait::No).await? else { return Ok(None) };
        let Some(found) = ide::signature_help(&shot.view(), shot.offset(at.position)) else { return Ok(None) };
        // Offsets in labels are counted in UTF-16 whatever else is agreed.
        let units = |end: usize| u32::try_from(found.label[..end].encode_utf16().count()).unwrap_or(u32::MAX);
        let parameter = |(start, end): &(usize, usize)| ParameterInformation {
            label: ParameterLabel::LabelOffsets([units(*start), units(*end)]),
            documentation: None,
        };
        let active = found.active.and_then(|active| u32::try_from(active).ok());
        let signature = SignatureInformation {
            parameters: Some(found.parameters.iter().map(parameter).collect()),
            documentation: Some(Documentation::MarkupContent(markdown(found.documentation.clone()))),
            label: found.label.clone(),
            active_parameter: active,
        };
        Ok(Some(SignatureHelp { signatures: vec![signature], active_signature: Some(0), active_parameter: active }))
    }
}

fn markdown(value: String) -> MarkupContent {
    MarkupContent { kind: MarkupKind::Markdown, value }
}

fn entry(item: Completion, index: usize, range: Range, snippets: bool) -> CompletionItem {
    let is_snippet = item.is_snippet && snippets;
    let text = if item.is_snippet && !snippets { ide::plain_text(&item.insert) } else { item.insert };
    CompletionItem {
        kind: Some(match item.kind {
            Kind::Object => CompletionItemKind::STRUCT,
            Kind::Variable => CompletionItemKind::VARIABLE,
            Kind::Function => CompletionItemKind::FUNCTION,
            Kind::Method => CompletionItemKind::METHOD,
            Kind::Property => CompletionItemKind::PROPERTY,
            Kind::Class => CompletionItemKind::CLASS,
            Kind::Module => CompletionItemKind::MODULE,
            Kind::Constant => CompletionItemKind::ENUM_MEMBER,
            Kind::Keyword => CompletionItemKind::KEYWORD,
            Kind::Argument => CompletionItemKind::FIELD,
            Kind::Snippet => CompletionItemKind::SNIPPET,
        }),
        detail: Some(item.detail).filter(|detail| !detail.is_empty()),
        sort_text: Some(sort_text(item.rank, index)),
        insert_text_format: Some(if is_snippet { InsertTextFormat::SNIPPET } else { InsertTextFormat::PLAIN_TEXT }),
        text_edit: Some(CompletionTextEdit::Edit(TextEdit::new(range, text))),
        data: item.doc.map(|(owner, name)| serde_json::json!([owner, name])),
        label: item.label,
        ..CompletionItem::default()
    }
}
