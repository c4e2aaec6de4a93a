//! Programs with a place in them, for the tests of the features.

use super::{Program, Scene, View};
use crate::analysis::{Input, Options, analyse};
use ruff_text_size::TextSize;

/// The scene of a program that runs.
pub fn scene_of(text: &str, template: Option<&str>) -> Option<Scene> {
    let analysis = analyse(&Input { text, template }, &Options::default(), None);
    let (layout, verdict) = (analysis.layout?, analysis.verdict);
    Some(Scene { text: text.into(), layout, verdict, template: analysis.prepared.template, partial: analysis.partial })
}

/// A program with a place, and its scene.
pub struct Fixture {
    pub program: Program,
    pub scene: Option<Scene>,
    pub offset: TextSize,
}

impl Fixture {
    /// The place is at the `$0`.
    pub fn new(marked: &str) -> Fixture {
        Fixture::with_template(marked, None)
    }

    pub fn with_template(marked: &str, template: Option<&str>) -> Fixture {
        let at = marked.find("$0").unwrap_or(marked.len());
        let text = marked.replacen("$0", "", 1);
        let scene = scene_of(&text, template);
        Fixture { program: Program::read(text.into()), scene, offset: TextSize::new(u32::try_from(at).unwrap()) }
    }

    /// What was typed since the program ran: the text with the place, beside the scene of another.
    pub fn stale(ran: &str, marked: &str) -> Fixture {
        Fixture { scene: scene_of(ran, None), ..Fixture::new(marked) }
    }

    pub fn view(&self) -> View<'_> {
        View::new(&self.program, self.scene.as_ref())
    }

    pub fn text(&self) -> &str {
        &self.program.text
    }
}
