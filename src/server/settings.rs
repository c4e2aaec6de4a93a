//! What the user set in the editor: the section `psdl` of its settings. What concerns the program itself is in `psdl.toml`.

use super::handlers::Backend;
use super::watch::Ask;
use serde_json::Value;
use std::time::Duration;
use tower_lsp_server::ls_types::{ConfigurationItem, Registration};

/// The section.
const SECTION: &str = "psdl";
/// A client that does not answer for so long will not.
const PATIENCE: Duration = Duration::from_secs(10);

/// Which hints stand between the words of a program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct InlayHints {
    /// Where objects are in the end.
    pub coordinates: bool,
    /// Where objects look.
    pub facings: bool,
    /// The names of parameters.
    pub parameters: bool,
    /// What loops placed, and how many errors that has.
    pub loops: bool,
}

/// What the user wants to see.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Settings {
    pub inlay_hints: InlayHints,
    /// A hover over an object has a picture.
    pub hover_picture: bool,
    pub code_lens: bool,
    /// Programs that are not open are looked at too. Unset: where the client asks for that.
    pub workspace_diagnostics: Option<bool>,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            inlay_hints: InlayHints { coordinates: true, facings: true, parameters: false, loops: true },
            hover_picture: true,
            code_lens: true,
            workspace_diagnostics: None,
        }
    }
}

impl Settings {
    /// Reads the section, or an object that holds it. What is missing, or no truth value, is as if it were not set.
    pub(super) fn read(value: &Value) -> Settings {
        let section = value.get(SECTION).unwrap_or(value);
        let set = |path: &str| section.pointer(path).and_then(Value::as_bool);
        let Settings { inlay_hints: hints, hover_picture, code_lens, .. } = Settings::default();
        Settings {
            inlay_hints: InlayHints {
                coordinates: set("/inlayHints/coordinates").unwrap_or(hints.coordinates),
                facings: set("/inlayHints/facings").unwrap_or(hints.facings),
                parameters: set("/inlayHints/parameters").unwrap_or(hints.parameters),
                loops: set("/inlayHints/loops").unwrap_or(hints.loops),
            },
            hover_picture: set("/hover/picture").unwrap_or(hover_picture),
            code_lens: set("/codeLens").unwrap_or(code_lens),
            workspace_diagnostics: set("/workspaceDiagnostics"),
        }
    }
}

/// That the client tells when the section changes.
pub(super) fn registration() -> Registration {
    let options = serde_json::json!({ "section": SECTION });
    Registration { id: "psdl-settings".into(), method: "workspace/didChangeConfiguration".into(), register_options: Some(options) }
}

impl Backend {
    /// Takes settings that came with a message, or asks for them where the client is one that is asked.
    pub(super) fn take_settings(&self, sent: &Value) {
        if !self.shared.state().client.has_settings {
            self.set(Settings::read(sent));
            return;
        }
        let backend = self.clone();
        tokio::spawn(async move {
            let item = ConfigurationItem { scope_uri: None, section: Some(SECTION.into()) };
            match tokio::time::timeout(PATIENCE, backend.client.configuration(vec![item])).await {
                Ok(Ok(answers)) => match answers.first() {
                    Some(Value::Null) | None => {}
                    Some(section) => backend.set(Settings::read(section)),
                },
                Ok(Err(error)) => tracing::warn!("the client does not tell its settings: {}", error.code),
                Err(_) => tracing::warn!("the client does not tell its settings"),
            }
        });
    }

    fn set(&self, settings: Settings) {
        let mut state = self.shared.state();
        let before = std::mem::replace(&mut state.settings, settings);
        let client = state.client;
        drop(state);
        if before.inlay_hints != settings.inlay_hints && client.refreshes_hints {
            self.refresh.ask(&self.client, Ask::Hints);
        }
        if before.code_lens != settings.code_lens && client.refreshes_lenses {
            self.refresh.ask(&self.client, Ask::Lenses);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_is_not_set_is_as_usual() {
        assert_eq!(Settings::read(&Value::Null), Settings::default());
        let settings = Settings::read(&json!({"psdl": {"inlayHints": {"loops": false, "parameters": true}, "codeLens": false}}));
        let hints = InlayHints { coordinates: true, facings: true, parameters: true, loops: false };
        assert_eq!((settings.inlay_hints, settings.code_lens, settings.hover_picture), (hints, false, true));
    }

    #[test]
    fn the_section_stands_by_itself_too_and_nonsense_is_no_setting() {
        let settings = Settings::read(&json!({"hover": {"picture": false}, "codeLens": "yes", "workspaceDiagnostics": true}));
        assert_eq!((settings.hover_picture, settings.code_lens, settings.workspace_diagnostics), (false, true, Some(true)));
        assert_eq!(Settings::read(&json!({"inlayHints": 3, "hover": []})), Settings::default());
    }
}
