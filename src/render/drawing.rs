//! The drawing list: what SVG and PNG are made from. Pixels, x right, y down.

use super::colour::Rgb;
use super::font::Face;

/// A point, in pixels.
pub type Point = [f32; 2];

/// A picture as a list of what is painted, first things first.
#[derive(Clone, PartialEq, Debug)]
pub struct Drawing {
    /// In pixels.
    pub width: u32,
    /// In pixels.
    pub height: u32,
    /// What it is called.
    pub title: String,
    /// Behind everything.
    pub paper: Rgb,
    /// What is painted.
    pub items: Vec<Item>,
    /// The names of the objects, by index.
    pub names: Vec<String>,
}

/// A colour and how much of it covers what is below, from 0 to 1.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Paint {
    /// The colour.
    pub colour: Rgb,
    /// 1 covers.
    pub opacity: f32,
}

impl From<Rgb> for Paint {
    fn from(colour: Rgb) -> Paint {
        Paint { colour, opacity: 1.0 }
    }
}

impl Rgb {
    /// This colour, letting what is below shine through.
    pub fn over(self, opacity: f32) -> Paint {
        Paint { colour: self, opacity }
    }
}

/// A line along a contour.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stroke {
    /// Its colour.
    pub paint: Paint,
    /// In pixels.
    pub width: f32,
    /// Lengths of dash and gap, in pixels.
    pub dash: Option<[f32; 2]>,
}

impl Stroke {
    /// A line without gaps.
    pub fn solid(paint: impl Into<Paint>, width: f32) -> Stroke {
        Stroke { paint: paint.into(), width, dash: None }
    }

    /// A dashed line.
    pub fn dashed(paint: impl Into<Paint>, width: f32, dash: f32) -> Stroke {
        Stroke { paint: paint.into(), width, dash: Some([dash, dash * 0.75]) }
    }
}

/// A line of points.
#[derive(Clone, PartialEq, Debug)]
pub struct Contour {
    /// Its corners.
    pub points: Vec<Point>,
    /// Whether it ends where it began.
    pub closed: bool,
}

/// Where a text stands relative to its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Align {
    /// It begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

/// A line of text.
#[derive(Clone, PartialEq, Debug)]
pub struct Text {
    /// A point of the baseline.
    pub at: Point,
    /// Where the text is relative to it.
    pub align: Align,
    /// The letters; harmless.
    pub text: String,
    /// In pixels.
    pub size: f32,
    /// The font.
    pub face: Face,
    /// The colour of the letters.
    pub colour: Rgb,
    /// A line around the letters that keeps them apart from what is below: colour and width.
    pub halo: Option<(Paint, f32)>,
}

/// What is painted at once.
#[derive(Clone, PartialEq, Debug)]
pub enum Shape {
    /// Areas and lines. Where contours overlap the area is filled once, if they run the same way round.
    Path {
        /// The contours.
        contours: Vec<Contour>,
        /// What fills them.
        fill: Option<Paint>,
        /// What runs along them.
        stroke: Option<Stroke>,
    },
    /// A disc.
    Disc {
        /// Its middle.
        at: Point,
        /// Its radius in pixels.
        radius: f32,
        /// What fills it.
        fill: Paint,
        /// What runs around it.
        stroke: Option<Stroke>,
    },
    /// A line of text.
    Text(Text),
}

/// What a shape is part of.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Part {
    /// The stage, labels, scales, lists.
    #[default]
    Page,
    /// The body of an object: what the mask shows.
    Body(u32),
    /// What is drawn on an object: shadows, arrows.
    On(u32),
    /// Errors drawn where they are.
    Mark,
}

/// A shape and what it is part of.
#[derive(Clone, PartialEq, Debug)]
pub struct Item {
    /// What is painted.
    pub shape: Shape,
    /// What it is part of.
    pub part: Part,
}

impl Drawing {
    /// An empty picture.
    pub fn new(width: u32, height: u32, paper: Rgb) -> Drawing {
        Drawing { width, height, title: String::new(), paper, items: Vec::new(), names: Vec::new() }
    }

    /// Adds a shape.
    pub fn add(&mut self, part: Part, shape: Shape) {
        self.items.push(Item { shape, part });
    }

    /// Fills a polygon.
    pub fn fill(&mut self, part: Part, points: Vec<Point>, paint: impl Into<Paint>) {
        self.area(part, points, Some(paint.into()), None);
    }

    /// Fills a polygon and draws around it.
    pub fn area(&mut self, part: Part, points: Vec<Point>, fill: Option<Paint>, stroke: Option<Stroke>) {
        self.add(part, Shape::Path { contours: vec![Contour { points, closed: true }], fill, stroke });
    }

    /// Draws a line.
    pub fn line(&mut self, part: Part, points: Vec<Point>, stroke: Stroke) {
        self.add(part, Shape::Path { contours: vec![Contour { points, closed: false }], fill: None, stroke: Some(stroke) });
    }

    /// Draws many lines at once.
    pub fn lines(&mut self, part: Part, lines: impl IntoIterator<Item = Vec<Point>>, stroke: Stroke) {
        let contours: Vec<Contour> = lines.into_iter().map(|points| Contour { points, closed: false }).collect();
        if !contours.is_empty() {
            self.add(part, Shape::Path { contours, fill: None, stroke: Some(stroke) });
        }
    }

    /// Writes a line of text.
    pub fn text(&mut self, part: Part, text: Text) {
        self.add(part, Shape::Text(text));
    }
}
