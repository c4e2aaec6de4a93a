//! Pictures of layouts: a drawing list that becomes SVG, PNG, a mask of objects, or pixels for a terminal.
//!
//! [`draw`] makes a [`Drawing`] of a [`Picture`], seen from above, in perspective, or both, with the errors where they are and in a list.
//!
//! Invariants:
//! - One list is behind all formats, in the order of painting: what is near hides what is far, also where boxes share volume.
//! - The same layout and options give the same list, and the same bytes, on every run.
//! - Names are shown as text only: cut short, and without what would act on a terminal, a reader of XML, or the direction of writing.
//! - Work and memory are bounded whatever the layout holds: huge, tiny and countless boxes.
//!
//! Knows layouts and their errors. Knows nothing of files, programs' texts and terminals' abilities.

mod camera;
pub mod colour;
mod drawing;
pub mod film;
pub mod font;
mod labels;
mod marks;
mod order;
mod page;
mod paint;
mod panel;
mod raster;
pub mod reel;
mod shadow;
mod solid;
mod stage;
mod svg;
mod terminal;
pub mod text;

pub use drawing::{Align, Contour, Drawing, Item, Paint, Part, Point, Shape, Stroke, Text};
pub use page::draw;
pub use raster::Pixels;
pub use terminal::Protocol;

use crate::check::{Rules, Verdict};
use crate::scene::{Layout, ObjectId};

/// What a picture is of.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// The layout.
    pub layout: &'a Layout,
    /// Its errors.
    pub verdict: &'a Verdict,
    /// What counts as an error.
    pub rules: &'a Rules,
}

/// From where a scene is seen.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum View {
    /// From above: a plan.
    Top,
    /// In perspective from the front right.
    Perspective,
    /// Both, side by side or one over the other.
    #[default]
    Both,
}

/// Which objects are named.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Labels {
    /// None.
    None,
    /// Those with room for their name, and those with errors.
    #[default]
    Some,
    /// All that find a place for their name, beside them if need be.
    All,
}

/// The colours of the page.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Theme {
    /// Dark on white.
    #[default]
    Light,
    /// Light on near black.
    Dark,
}

/// How a picture is made.
#[derive(Clone, Debug)]
pub struct Options {
    /// From where.
    pub view: View,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// The colours of the page.
    pub theme: Theme,
    /// Which objects are named.
    pub labels: Labels,
    /// Whether errors are drawn.
    pub errors: bool,
    /// Whether there is a title and, if errors are drawn, a list of them. Pictures too small for it go without.
    pub captions: bool,
    /// An object that is pointed out; the others fade.
    pub highlight: Option<ObjectId>,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            view: View::Both,
            size: (1600, 1000),
            theme: Theme::Light,
            labels: Labels::Some,
            errors: true,
            captions: true,
            highlight: None,
        }
    }
}

/// Width and height of a picture lie between these. Pixels.
pub const SIZES: std::ops::RangeInclusive<u32> = 16..=8192;
