//! What helps to read a program: hovers, hints between the words, lenses over the lines, colours of the words.

use super::handlers::Backend;
use super::shared::Latest;
use super::view::{Snapshot, Wait};
use crate::ide::{self, HintKind, LensKind, Token, TokenKind, Wanted};
use crate::repair::Watch;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ruff_text_size::TextRange;
use serde_json::json;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::{
    CodeLens, CodeLensParams, Command, Hover, HoverContents, HoverParams, InlayHint, InlayHintKind, InlayHintLabel, InlayHintParams,
    InlayHintTooltip, MarkupContent, MarkupKind, SemanticToken, SemanticTokenModifier, SemanticTokenType, SemanticTokens,
    SemanticTokensDelta, SemanticTokensDeltaParams, SemanticTokensEdit, SemanticTokensFullDeltaResult, SemanticTokensLegend,
    SemanticTokensParams, SemanticTokensRangeParams, SemanticTokensRangeResult, SemanticTokensResult, Uri,
};

/// The tokens that a client has, and what it calls them.
#[derive(Clone, Debug)]
pub(super) struct Painted {
    pub id: String,
    pub tokens: Vec<SemanticToken>,
}

/// What the numbers in semantic tokens mean.
pub(super) fn legend() -> SemanticTokensLegend {
    SemanticTokensLegend {
        token_types: TokenKind::ALL.map(|kind| SemanticTokenType::new(kind.name())).to_vec(),
        token_modifiers: vec![SemanticTokenModifier::DECLARATION, SemanticTokenModifier::DEFAULT_LIBRARY],
    }
}

impl Backend {
    pub(super) async fn show_hover(&self, params: HoverParams) -> Result<Option<Hover>> {
        let at = params.text_document_position_params;
        let Some(shot) = self.snapshot(&at.text_document.uri, Wait::Shortly).await? else { return Ok(None) };
        let Some(mut hover) = ide::hover(&shot.view(), shot.offset(at.position)) else { return Ok(None) };
        if let Some(about) = self.about_constant(&shot, &hover).await {
            hover.markdown.push_str("\n\n");
            hover.markdown.push_str(&about);
        }
        let contents = if shot.client.hover_markdown {
            let pictured = picture(&shot, &hover).await;
            MarkupContent { kind: MarkupKind::Markdown, value: format!("{}{pictured}", hover.markdown) }
        } else {
            MarkupContent { kind: MarkupKind::PlainText, value: plain(&hover.markdown) }
        };
        Ok(Some(Hover { contents: HoverContents::Markup(contents), range: Some(shot.range(hover.range)) }))
    }

    /// What a constant moves and where it has no errors; nothing about a text that is no more, or that cannot be run.
    async fn about_constant(&self, shot: &Snapshot, hover: &ide::Hover) -> Option<String> {
        let id = hover.constant?;
        let (Latest::Now(outcome), _) = self.shared.latest(&shot.uri)? else { return None };
        if !outcome.ran || *outcome.main.text.text != *shot.program.text {
            return None;
        }
        let study = self.shared.study(&outcome);
        let work = move |watch: &Watch| study.with_lab(watch, |lab| lab.about_constant(id).map(str::to_string)).flatten();
        self.thought(self.shared.watch(&shot.uri), work).await.ok()?
    }

    pub(super) async fn show_hints(&self, params: InlayHintParams) -> Result<Option<Vec<InlayHint>>> {
        let Some(shot) = self.snapshot(&params.text_document.uri, Wait::Until).await? else { return Ok(None) };
        let set = shot.settings.inlay_hints;
        let wanted = Wanted { coordinates: set.coordinates, facings: set.facings, parameters: set.parameters, loops: set.loops };
        let hint = |hint: ide::Hint| InlayHint {
            position: shot.position(hint.at),
            label: InlayHintLabel::String(hint.label),
            kind: (hint.kind == HintKind::Parameter).then_some(InlayHintKind::PARAMETER),
            text_edits: None,
            tooltip: Some(hint.tooltip).filter(|tooltip| !tooltip.is_empty()).map(InlayHintTooltip::String),
            padding_left: Some(hint.kind == HintKind::Result),
            padding_right: Some(hint.kind == HintKind::Parameter),
            data: None,
        };
        Ok(Some(ide::hints(&shot.view(), shot.bytes(params.range), wanted).into_iter().map(hint).collect()))
    }

    pub(super) async fn show_lenses(&self, params: CodeLensParams) -> Result<Option<Vec<CodeLens>>> {
        let Some(shot) = self.snapshot(&params.text_document.uri, Wait::Until).await? else { return Ok(None) };
        if !shot.settings.code_lens {
            return Ok(Some(Vec::new()));
        }
        let lens = |lens: ide::Lens| {
            let (command, arguments) = match lens.kind {
                LensKind::Tell => ("", None),
                LensKind::FixAll => ("psdl.server.fixAll", Some(vec![json!(shot.uri)])),
            };
            let command = Some(Command { title: lens.title, command: command.into(), arguments });
            CodeLens { range: shot.range(lens.range), command, data: None }
        };
        Ok(Some(ide::lenses(&shot.view()).into_iter().map(lens).collect()))
    }

    pub(super) async fn paint(&self, params: SemanticTokensParams) -> Result<Option<SemanticTokensResult>> {
        let Some(shot) = self.snapshot(&params.text_document.uri, Wait::Shortly).await? else { return Ok(None) };
        let tokens = encode(&shot, &ide::tokens(&shot.view()));
        let (_, painted) = self.remember(&shot.uri, tokens);
        Ok(Some(SemanticTokens { result_id: Some(painted.id), data: painted.tokens }.into()))
    }

    pub(super) async fn repaint(&self, params: SemanticTokensDeltaParams) -> Result<Option<SemanticTokensFullDeltaResult>> {
        let Some(shot) = self.snapshot(&params.text_document.uri, Wait::Shortly).await? else { return Ok(None) };
        let tokens = encode(&shot, &ide::tokens(&shot.view()));
        let (before, painted) = self.remember(&shot.uri, tokens);
        Ok(Some(match before.filter(|before| before.id == params.previous_result_id) {
            Some(before) => SemanticTokensDelta { result_id: Some(painted.id), edits: difference(&before.tokens, &painted.tokens) }.into(),
            None => SemanticTokens { result_id: Some(painted.id), data: painted.tokens }.into(),
        }))
    }

    pub(super) async fn paint_range(&self, params: SemanticTokensRangeParams) -> Result<Option<SemanticTokensRangeResult>> {
        let Some(shot) = self.snapshot(&params.text_document.uri, Wait::Shortly).await? else { return Ok(None) };
        let range = shot.bytes(params.range);
        let mut tokens = ide::tokens(&shot.view());
        tokens.retain(|token| range.intersect(token.range).is_some());
        Ok(Some(SemanticTokens { result_id: None, data: encode(&shot, &tokens) }.into()))
    }

    /// Keeps the tokens of a document, and gives those that were kept before.
    fn remember(&self, uri: &Uri, tokens: Vec<SemanticToken>) -> (Option<Painted>, Painted) {
        let mut state = self.shared.state();
        let painted = Painted { id: state.number().to_string(), tokens };
        let Some(document) = state.documents.get_mut(uri) else { return (None, painted) };
        (document.painted.replace(painted.clone()), painted)
    }
}

/// The picture for a hover, as Markdown, where the client can show one and the user wants it.
async fn picture(shot: &Snapshot, hover: &ide::Hover) -> String {
    let Some(scene) = shot.scene.clone().filter(|_| shot.client.hover_pictures && shot.settings.hover_picture) else {
        return String::new();
    };
    let objects = hover.objects.clone();
    // Drawing is no work for the thread that answers.
    let drawn = tokio::task::spawn_blocking(move || ide::picture(&scene, &objects)).await;
    drawn.ok().flatten().map_or_else(String::new, |png| format!("\n\n![](data:image/png;base64,{})", STANDARD.encode(png)))
}

/// Tokens as the protocol counts them: each from the one before.
fn encode(shot: &Snapshot, tokens: &[Token]) -> Vec<SemanticToken> {
    let mut last = shot.position(TextRange::default().start());
    let encode = |token: &Token| {
        let range = shot.range(token.range);
        let (line, column) = (range.start.line, range.start.character);
        let delta_line = line - last.line;
        let delta_start = if delta_line == 0 { column - last.character } else { column };
        last = range.start;
        let kind = TokenKind::ALL.iter().position(|kind| *kind == token.kind).unwrap_or_default();
        SemanticToken {
            delta_line,
            delta_start,
            length: range.end.character.saturating_sub(column),
            token_type: u32::try_from(kind).unwrap_or_default(),
            token_modifiers_bitset: u32::from(token.declares) | u32::from(token.library) << 1,
        }
    };
    tokens.iter().map(encode).collect()
}

/// What lies between the first and the last difference; the protocol counts in numbers, five a token.
fn difference(before: &[SemanticToken], after: &[SemanticToken]) -> Vec<SemanticTokensEdit> {
    let start = before.iter().zip(after).take_while(|(a, b)| a == b).count();
    let room = before.len().min(after.len()) - start;
    let same = before.iter().rev().zip(after.iter().rev()).take(room).take_while(|(a, b)| a == b).count();
    let (gone, new) = (before.len() - start - same, &after[start..after.len() - same]);
    if gone == 0 && new.is_empty() {
        return Vec::new();
    }
    let number = |count: usize| u32::try_from(count * 5).unwrap_or(u32::MAX);
    vec![SemanticTokensEdit { start: number(start), delete_count: number(gone), data: (!new.is_empty()).then(|| new.to_vec()) }]
}

/// Markdown without its marks, for clients that show none.
fn plain(markdown: &str) -> String {
    let lines = markdown.lines().filter(|line| !line.starts_with("```") && !line.starts_with("| ---"));
    let text: Vec<String> = lines.map(|line| line.replace("**", "").replace(['`', '\\'], "")).collect();
    text.join("\n")
}
