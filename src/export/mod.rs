//! Other programs' formats: a layout → the bytes of a file, and files of layouts → a flat program.
//!
//! Invariants:
//! - Pure: the same layout gives the same bytes on every platform; nothing here reads or writes files.
//! - Lengths are metres in every format. Each format's own axes and rotations stand in its file, and in `docs/export.md`.
//! - Names are untrusted. Each writer escapes them for its format, or makes an identifier of them where the format asks for one.
//! - Formats that draw show the objects of `Pieces`: those that were placed, with a finite box of a size that the formats can hold.
//!   What is left out is listed in the file.
//! - What [`import`] gives is a program whose layout was computed before it is handed out: each box of the file is where the file has it.
//!
//! Knows `scene`, findings as `check` gives them, and the colours of `render`. Knows nothing of files, terminals, editors, or how programs are run.

mod colour;
mod gltf;
mod html;
pub mod import;
mod mjcf;
mod obj;
mod pieces;
mod table;
mod urdf;
mod usd;
mod visualizer;
mod words;

use crate::check::Verdict;
use crate::check::finding::Finding;
use crate::scene::{JsonViolation, Layout, OriginId, Placed, Source, layout_json};
use pieces::Pieces;
use ruff_text_size::TextSize;

/// What to write.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// glTF 2.0 in one binary file.
    Glb,
    /// Universal Scene Description, as text.
    Usda,
    /// Wavefront OBJ, with its materials beside it.
    Obj,
    /// A table, one row an object.
    Csv,
    /// Layout JSON.
    Layout,
    /// The JSON of the SceneVisualizer.
    Visualizer,
    /// A page that shows the scene.
    Html,
    /// A model for MuJoCo.
    Mjcf,
    /// A robot description of fixed links.
    Urdf,
}

impl Format {
    /// All of them, with their names and what they are.
    pub const ALL: [(Format, &'static str, &'static str); 9] = [
        (Format::Glb, "glb", "glTF 2.0, binary: one node an object"),
        (Format::Usda, "usda", "Universal Scene Description, text"),
        (Format::Obj, "obj", "Wavefront OBJ, its materials in an .mtl file beside it"),
        (Format::Csv, "csv", "A table, one row an object"),
        (Format::Layout, "layout", "Layout JSON: boxes, facings, anchors and errors"),
        (Format::Visualizer, "visualizer", "The JSON of the SceneVisualizer"),
        (Format::Html, "html", "One page that shows the scene in 3D and lists its errors"),
        (Format::Mjcf, "mjcf", "Static boxes for MuJoCo"),
        (Format::Urdf, "urdf", "Static boxes as fixed links of a URDF"),
    ];

    /// Whether the file is no text.
    pub fn is_binary(self) -> bool {
        self == Format::Glb
    }
}

/// What is exported, and what is known of it.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// Where everything is.
    pub layout: &'a Layout,
    /// The errors of the layout.
    pub verdict: &'a Verdict,
    /// The same for people, and what else is to be said about the program.
    pub findings: &'a [Finding],
    /// How many float constants of the program may be tuned.
    pub constants: usize,
    /// The line, from 1, of an offset of the program.
    pub line_of: &'a dyn Fn(TextSize) -> usize,
}

impl Subject<'_> {
    fn line(&self, origin: OriginId) -> Option<usize> {
        let origin = self.layout.origins.get(origin);
        (origin.source == Source::Program).then(|| (self.line_of)(origin.range.start()))
    }

    /// The line that declares an object, else the first that places it (a sidecar template declares on no line of the program).
    fn line_of_object(&self, object: &Placed) -> Option<usize> {
        self.line(object.declared).or_else(|| self.layout.placing_lines(object, self.line_of).first().copied())
    }
}

/// A file that belongs to another and is named in it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Companion {
    /// The name, without a folder.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

/// What an export gave.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Exported {
    /// The file.
    pub bytes: Vec<u8>,
    /// A second file that goes beside it.
    pub companion: Option<Companion>,
}

/// Writes a layout. `stem` is the file's name without its ending, where it has one: only then can a second file stand beside it.
pub fn export(format: Format, subject: &Subject, stem: Option<&str>) -> Exported {
    let pieces = Pieces::of(subject.layout);
    let text = |text: String| Exported { bytes: text.into_bytes(), companion: None };
    match format {
        Format::Glb => Exported { bytes: gltf::glb(subject, &pieces), companion: None },
        Format::Usda => text(usd::usda(subject, &pieces)),
        Format::Obj => obj::obj(&pieces, stem),
        Format::Csv => text(table::csv(subject)),
        Format::Layout => text(layout(subject)),
        Format::Visualizer => text(visualizer::visualizer(subject)),
        Format::Html => text(html::page(subject, &pieces)),
        Format::Mjcf => text(mjcf::mjcf(subject, &pieces)),
        Format::Urdf => text(urdf::urdf(subject, &pieces)),
    }
}

fn layout(subject: &Subject) -> String {
    let objects: Vec<Vec<usize>> = subject.verdict.counted().map(|violation| violation.objects().collect()).collect();
    let counted = subject.verdict.counted().zip(&objects);
    let violations: Vec<JsonViolation> =
        counted.map(|(violation, objects)| JsonViolation { kind: violation.kind.name(), objects, loss: violation.loss }).collect();
    layout_json(subject.layout, &violations, subject.line_of)
}
