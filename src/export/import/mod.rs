//! Files of other programs → a flat program: a template, then one placement an axis and a facing for each object.
//!
//! Invariants:
//! - A file that lacks what a scene needs (a size, a place) is refused, with every such place; nothing is made up for it.
//! - What was taken where the file says nothing (a room's height, what holds an object up) is said in comments of the program.
//! - The program's layout is computed before it is handed out, so that every object stands and faces as the file has it.

mod flat;
mod holodeck;
mod json;
mod layout;
mod layoutgpt;
mod naming;
mod visualizer;
mod write;

use jsonc_parser::ast::Value;
use std::ops::Range;

/// A format that can be read.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Source {
    /// Layout JSON.
    Layout,
    /// The JSON of the SceneVisualizer.
    Visualizer,
    /// A scene of AI2's Holodeck.
    Holodeck,
    /// LayoutGPT's lines of boxes.
    LayoutGpt,
}

impl Source {
    /// All of them, with their names and what they are.
    pub const ALL: [(Source, &'static str, &'static str); 4] = [
        (Source::Layout, "layout", "Layout JSON"),
        (Source::Visualizer, "visualizer", "The JSON of the SceneVisualizer"),
        (Source::Holodeck, "holodeck", "A scene of AI2's Holodeck, with sizes"),
        (Source::LayoutGpt, "layoutgpt", "LayoutGPT's lines of boxes, 3D"),
    ];
}

/// Something wrong at a place of the file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ImportError {
    /// Where, in bytes.
    pub range: Range<usize>,
    /// What.
    pub message: String,
}

impl ImportError {
    fn new(range: Range<usize>, message: impl Into<String>) -> ImportError {
        ImportError { range, message: message.into() }
    }
}

/// The format of a file, from what is in it.
pub fn detect(text: &str) -> Option<Source> {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    if !text.starts_with(['{', '[']) {
        return (text.contains('{') && text.contains(':')).then_some(Source::LayoutGpt);
    }
    let Ok(Value::Object(root)) = json::parse(text) else { return None };
    let has = |key: &str| root.get(key).is_some();
    let first = root.get_array("objects").and_then(|objects| objects.elements.first()).and_then(|object| object.as_object());
    if root.get_object("scene").is_some() {
        Some(Source::Layout)
    } else if has("relations") || has("number_of_constants") || first.is_some_and(|object| object.get_array("position").is_some()) {
        Some(Source::Visualizer)
    } else if has("rooms") || has("proceduralParameters") || first.is_some_and(|object| object.get("assetId").is_some()) {
        Some(Source::Holodeck)
    } else {
        None
    }
}

/// Reads a file, and gives a program with the same scene.
pub fn import(text: &str, source: Source) -> Result<String, Vec<ImportError>> {
    let marked = text.strip_prefix('\u{feff}');
    let (mark, text) = marked.map_or((0, text), |rest| (text.len() - rest.len(), rest));
    let scene = match source {
        Source::Layout => layout::read(text),
        Source::Visualizer => visualizer::read(text),
        Source::Holodeck => holodeck::read(text),
        Source::LayoutGpt => layoutgpt::read(text),
    };
    let scene = scene.map_err(|mut errors| {
        errors.iter_mut().for_each(|error| error.range = error.range.start + mark..error.range.end + mark);
        errors
    })?;
    let scene = scene.settled().map_err(|message| vec![ImportError::new(0..0, message)])?;
    Ok(write::program(&scene))
}

#[cfg(test)]
mod tests;
