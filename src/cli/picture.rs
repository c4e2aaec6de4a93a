//! `psdl check --picture`: a small picture of each scene in the terminal, as well as the terminal can show it.

use crate::analysis::{Analysis, Options};
use crate::render::{self, Labels, Picture, Protocol, Theme, View, draw};
use clap::ValueEnum;
use std::io::IsTerminal as _;

/// When and how `psdl check` shows pictures.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub enum PictureChoice {
    /// On a terminal, as well as it can.
    Auto,
    /// Also where standard output is no terminal.
    Always,
    /// With kitty's protocol.
    Kitty,
    /// With the protocol of iTerm2.
    Iterm,
    /// As sixels.
    Sixel,
    /// As block characters.
    Blocks,
    /// Never.
    Never,
}

/// A terminal that shows pictures.
#[derive(Clone, Copy, Debug)]
pub(super) struct Screen {
    protocol: Protocol,
    columns: usize,
}

impl Screen {
    /// What standard output can show, if it is to show anything.
    pub(super) fn of(choice: PictureChoice) -> Option<Screen> {
        let terminal = std::io::stdout().is_terminal();
        if choice == PictureChoice::Never || (choice == PictureChoice::Auto && !terminal) {
            return None;
        }
        let variable = |name: &str| std::env::var(name).ok().filter(|value| !value.is_empty());
        let blocks = if has_full_colour(&variable) { Protocol::Blocks } else { Protocol::Blocks256 };
        let protocol = match choice {
            PictureChoice::Kitty => Protocol::Kitty,
            PictureChoice::Iterm => Protocol::Iterm,
            PictureChoice::Sixel => Protocol::Sixel,
            PictureChoice::Blocks => blocks,
            _ if !terminal => blocks,
            _ => graphics(&variable).unwrap_or(blocks),
        };
        let width = terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
        let columns = width.or_else(|| variable("COLUMNS")?.parse().ok()).unwrap_or(80);
        Some(Screen { protocol, columns })
    }

    /// What the terminal is sent to show a scene; nothing where there is none.
    pub(super) fn show(&self, analysis: &Analysis, options: &Options) -> String {
        let Some(layout) = &analysis.layout else { return String::new() };
        let coarse = matches!(self.protocol, Protocol::Blocks | Protocol::Blocks256);
        let options_of = render::Options {
            view: if coarse { View::Perspective } else { View::Both },
            size: self.protocol.size(self.columns),
            theme: Theme::Dark,
            labels: if coarse { Labels::None } else { Labels::Some },
            errors: true,
            captions: !coarse,
            highlight: None,
        };
        let picture = Picture { layout, verdict: &analysis.verdict, rules: &options.rules };
        self.protocol.show(&draw(&picture, &options_of), self.columns)
    }
}

/// The graphics that a terminal is known for, by what it says of itself in the environment.
fn graphics(variable: &dyn Fn(&str) -> Option<String>) -> Option<Protocol> {
    let term = variable("TERM").unwrap_or_default();
    let program = variable("TERM_PROGRAM").unwrap_or_default();
    // A multiplexer between us and the terminal would not pass pictures on.
    if variable("TMUX").is_some() || variable("STY").is_some() || term.starts_with("screen") || term.starts_with("tmux") {
        return None;
    }
    if variable("KITTY_WINDOW_ID").is_some() || term.contains("kitty") || term.contains("ghostty") || program == "ghostty" {
        return Some(Protocol::Kitty);
    }
    let iterm = ["iTerm.app", "WezTerm", "mintty", "rio"].contains(&program.as_str());
    if iterm || variable("LC_TERMINAL").is_some_and(|terminal| terminal == "iTerm2") || variable("WEZTERM_PANE").is_some() {
        return Some(Protocol::Iterm);
    }
    let sixel = ["foot", "mlterm", "contour", "yaft"].iter().any(|name| term.starts_with(name));
    (sixel || variable("KONSOLE_VERSION").is_some() || term.contains("sixel")).then_some(Protocol::Sixel)
}

fn has_full_colour(variable: &dyn Fn(&str) -> Option<String>) -> bool {
    variable("COLORTERM").is_some_and(|value| value == "truecolor" || value == "24bit")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(variables: &[(&str, &str)]) -> Option<Protocol> {
        graphics(&|name| variables.iter().find(|(known, _)| *known == name).map(|(_, value)| value.to_string()))
    }

    #[test]
    fn terminals_are_known_by_their_environment() {
        assert_eq!(seen(&[("TERM", "xterm-kitty")]), Some(Protocol::Kitty));
        assert_eq!(seen(&[("TERM", "xterm-256color"), ("KITTY_WINDOW_ID", "1")]), Some(Protocol::Kitty));
        assert_eq!(seen(&[("TERM", "xterm-256color"), ("TERM_PROGRAM", "iTerm.app")]), Some(Protocol::Iterm));
        assert_eq!(seen(&[("TERM", "foot-extra")]), Some(Protocol::Sixel));
        assert_eq!(seen(&[("TERM", "xterm-256color")]), None);
        assert_eq!(seen(&[("TERM", "tmux-256color"), ("TMUX", "/tmp/x"), ("KITTY_WINDOW_ID", "1")]), None);
    }
}
