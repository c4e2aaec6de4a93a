//! Letters as outlines, from fonts that are part of the program.

use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, GlyphId, MetadataProvider};
use std::sync::OnceLock;

/// One of the fonts that are part of the program.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Face {
    /// Names and numbers.
    Sans,
    /// Headings; Latin letters only.
    Bold,
    /// Lines of programs.
    Mono,
}

/// A step of an outline, in parts of the size, y up.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Segment {
    /// A new contour.
    Move([f32; 2]),
    /// A straight line.
    Line([f32; 2]),
    /// A quadratic curve: control point, end.
    Quad([f32; 2], [f32; 2]),
    /// The contour ends where it began.
    Close,
}

/// A letter: its outline, and how far it is to the next.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Glyph {
    /// The outline.
    pub outline: Vec<Segment>,
    /// In parts of the size.
    pub advance: f32,
}

/// The height of capital letters and of the line above the baseline, in parts of the size.
pub const CAPITALS: f32 = 0.729;

/// Letters below this are found by number.
const LATIN: usize = 0x180;

struct Loaded {
    font: FontRef<'static>,
    latin: Vec<Option<Glyph>>,
}

impl Face {
    fn bytes(self) -> &'static [u8] {
        match self {
            Face::Sans => include_bytes!("fonts/DejaVuSans.ttf"),
            Face::Bold => include_bytes!("fonts/DejaVuSans-Bold.ttf"),
            Face::Mono => include_bytes!("fonts/DejaVuSansMono.ttf"),
        }
    }

    /// The names that CSS knows it and its like by.
    pub fn family(self) -> &'static str {
        match self {
            Face::Sans | Face::Bold => "DejaVu Sans, Verdana, sans-serif",
            Face::Mono => "DejaVu Sans Mono, Menlo, Consolas, monospace",
        }
    }

    /// The font, read once. What is kept follows from the embedded bytes alone.
    fn loaded(self) -> Option<&'static Loaded> {
        static FACES: [OnceLock<Option<Loaded>>; 3] = [OnceLock::new(), OnceLock::new(), OnceLock::new()];
        let load = || {
            let font = FontRef::new(self.bytes()).ok()?;
            let latin = (0..LATIN).map(|code| glyph(&font, char::from_u32(code as u32)?)).collect();
            Some(Loaded { font, latin })
        };
        FACES[self as usize].get_or_init(load).as_ref()
    }

    /// A letter; a box where the font has none.
    pub fn glyph(self, c: char) -> Glyph {
        self.known(c, Glyph::clone).unwrap_or_else(missing)
    }

    fn known<T>(self, c: char, take: impl FnOnce(&Glyph) -> T) -> Option<T> {
        let loaded = self.loaded()?;
        match loaded.latin.get(c as usize) {
            Some(glyph) => glyph.as_ref().map(take),
            None => glyph(&loaded.font, c).as_ref().map(take),
        }
    }

    /// How far it is from a letter to the next, in pixels, at a size in pixels.
    pub fn advance(self, c: char, size: f32) -> f32 {
        size * self.known(c, |glyph| glyph.advance).unwrap_or(MISSING)
    }

    /// How wide a text is, in pixels.
    pub fn width(self, text: &str, size: f32) -> f32 {
        text.chars().map(|c| self.advance(c, size)).sum()
    }
}

fn glyph(font: &FontRef<'static>, c: char) -> Option<Glyph> {
    let id = font.charmap().map(c).filter(|id| *id != GlyphId::NOTDEF)?;
    let advance = font.glyph_metrics(Size::new(1.0), LocationRef::default()).advance_width(id)?;
    let mut pen = Pen::default();
    font.outline_glyphs().get(id)?.draw(DrawSettings::unhinted(Size::new(1.0), LocationRef::default()), &mut pen).ok()?;
    Some(Glyph { outline: pen.0, advance })
}

/// The width of the box that stands for a letter that the font has not.
const MISSING: f32 = 0.6;

fn missing() -> Glyph {
    let frame = |near: f32, far: f32, low: f32, high: f32| {
        [Segment::Move([near, low]), Segment::Line([far, low]), Segment::Line([far, high]), Segment::Line([near, high]), Segment::Close]
    };
    // The inner frame runs the other way round, and so is a hole.
    let outline = frame(0.06, 0.54, 0.0, 0.72).into_iter().chain(frame(0.48, 0.12, 0.06, 0.66)).collect();
    Glyph { outline, advance: MISSING }
}

#[derive(Default)]
struct Pen(Vec<Segment>);

impl OutlinePen for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.push(Segment::Move([x, y]));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.push(Segment::Line([x, y]));
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        self.0.push(Segment::Quad([cx, cy], [x, y]));
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        // TrueType outlines are quadratic; a cubic one would keep its middle.
        self.0.push(Segment::Quad([(3.0 * (ax + bx) - x) / 4.0, (3.0 * (ay + by) - y) / 4.0], [x, y]));
    }

    fn close(&mut self) {
        self.0.push(Segment::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_have_outlines_and_what_is_missing_is_a_box() {
        for face in [Face::Sans, Face::Bold, Face::Mono] {
            assert!(!face.glyph('A').outline.is_empty(), "{face:?}");
            assert!(face.glyph('…').advance > 0.0);
            assert_eq!(face.glyph('😀'), missing());
            assert_eq!(face.glyph('\u{5d0}'), missing());
        }
        assert!(Face::Sans.glyph(' ').outline.is_empty());
        assert_ne!(Face::Sans.glyph('ж'), missing());
    }

    #[test]
    fn widths_add_up() {
        let one = Face::Mono.width("x", 10.0);
        assert!((Face::Mono.width("xxxx", 10.0) - 4.0 * one).abs() < 1e-3);
        assert!(Face::Bold.width("chairs[3]", 12.0) > Face::Sans.width("chairs[3]", 12.0));
    }
}
