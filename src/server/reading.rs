//! What helps to read a program: hovers.

use super::handlers::Backend;
use super::view::Wait;
use crate::ide;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::{Hover, HoverContents, HoverParams, MarkupContent, MarkupKind};

impl Backend {
    pub(super) async fn show_hover(&self, params: HoverParams) -> Result<Option<Hover>> {
        let at = params.text_document_position_params;
        let Some(shot) = self.snapshot(&at.text_document.uri, Wait::Shortly).await? else { return Ok(None) };
        let Some(hover) = ide::hover(&shot.view(), shot.offset(at.position)) else { return Ok(None) };
        let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value: hover.markdown });
        Ok(Some(Hover { contents, range: Some(shot.range(hover.range)) }))
    }
}
