//! Colours: those of the program, a palette for what has none, and how they change with light and theme.
//!
//! The palette is that of Okabe and Ito with lighter and darker kin, so that neighbours stay distinct for people who do not see red or green.

use crate::scene::{Kind, Layout, SceneInfo};
use rustc_hash::FxHashMap;

use super::Theme;

/// A colour in sRGB.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Rgb(pub u8, pub u8, pub u8);

/// For objects without a colour, a category each.
pub const PALETTE: [Rgb; 16] = [
    Rgb(0x56, 0xb4, 0xe9),
    Rgb(0xe6, 0x9f, 0x00),
    Rgb(0x00, 0x9e, 0x73),
    Rgb(0xcc, 0x79, 0xa7),
    Rgb(0xf0, 0xe4, 0x42),
    Rgb(0x00, 0x72, 0xb2),
    Rgb(0xd5, 0x5e, 0x00),
    Rgb(0x99, 0x99, 0x99),
    Rgb(0xa6, 0xd8, 0xf2),
    Rgb(0x7a, 0x53, 0x00),
    Rgb(0x8f, 0xd9, 0xc2),
    Rgb(0x8a, 0x2f, 0x5c),
    Rgb(0xf9, 0xd4, 0x8a),
    Rgb(0x14, 0x2d, 0x86),
    Rgb(0xf2, 0xb7, 0xd5),
    Rgb(0x4d, 0x4d, 0x4d),
];

/// What a door or window without a colour has.
const DOOR: Rgb = Rgb(0x9c, 0x6b, 0x3f);
const WINDOW: Rgb = Rgb(0xa9, 0xd3, 0xe8);

impl Rgb {
    /// Black.
    pub const BLACK: Rgb = Rgb(0, 0, 0);
    /// White.
    pub const WHITE: Rgb = Rgb(255, 255, 255);

    /// From RRGGBB, as programs give it.
    pub fn parse(text: &str) -> Option<Rgb> {
        let part = |at: usize| text.get(at..at + 2).and_then(|digits| u8::from_str_radix(digits, 16).ok());
        if text.len() != 6 || !text.bytes().all(|byte| byte.is_ascii_hexdigit()) {
            return None;
        }
        Some(Rgb(part(0)?, part(2)?, part(4)?))
    }

    /// As CSS and SVG write it: `#rrggbb`.
    pub fn hex(self) -> String {
        format!("#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }

    /// A part of the way to another colour; 0 stays, 1 arrives.
    pub fn mix(self, other: Rgb, part: f64) -> Rgb {
        let between = |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * part.clamp(0.0, 1.0)).round() as u8;
        Rgb(between(self.0, other.0), between(self.1, other.1), between(self.2, other.2))
    }

    /// Under less or more light: 1 stays, 0 is black.
    pub fn lit(self, light: f64) -> Rgb {
        if light <= 1.0 { self.mix(Rgb::BLACK, 1.0 - light) } else { self.mix(Rgb::WHITE, light - 1.0) }
    }

    /// How bright it looks, from 0 to 1.
    pub fn luminance(self) -> f64 {
        (0.299 * f64::from(self.0) + 0.587 * f64::from(self.1) + 0.114 * f64::from(self.2)) / 255.0
    }

    /// Black or white, whichever can be read on it.
    pub fn ink(self) -> Rgb {
        if self.luminance() > 0.52 { Rgb(0x1a, 0x1a, 0x1a) } else { Rgb::WHITE }
    }

    /// The grey that is as bright.
    pub fn grey(self) -> Rgb {
        let level = (self.luminance() * 255.0).round() as u8;
        Rgb(level, level, level)
    }
}

/// The colour of each object: what the program says, else one of the palette by category, in order of first appearance.
pub fn objects(layout: &Layout) -> Vec<Rgb> {
    let mut by_category: FxHashMap<&str, usize> = FxHashMap::default();
    let colour = |object: &'_ crate::scene::Placed, next: usize| match object.body.kind {
        Kind::Door => DOOR,
        Kind::Window => WINDOW,
        Kind::Object => PALETTE[next % PALETTE.len()],
    };
    let mut colours = Vec::with_capacity(layout.objects.len());
    for object in &layout.objects {
        let given = object.color.as_deref().and_then(Rgb::parse);
        colours.push(given.unwrap_or_else(|| {
            let known = by_category.len();
            colour(object, *by_category.entry(&object.name).or_insert(known))
        }));
    }
    colours
}

/// The colour of the floor.
pub fn floor(scene: &SceneInfo) -> Rgb {
    let given = scene.floor.as_ref().and_then(|floor| floor.color.as_deref()).and_then(Rgb::parse);
    given.unwrap_or(if scene.interior { Rgb(0xd9, 0xcd, 0xbb) } else { Rgb(0xb9, 0xc7, 0xa1) })
}

/// The colour of the walls.
pub fn wall(scene: &SceneInfo) -> Rgb {
    let given = scene.wall.as_ref().and_then(|wall| wall.color.as_deref()).and_then(Rgb::parse);
    given.unwrap_or(Rgb(0xe6, 0xe2, 0xda))
}

/// What a theme paints with.
#[derive(Clone, Copy, Debug)]
pub struct Ink {
    /// Behind everything.
    pub paper: Rgb,
    /// Text.
    pub text: Rgb,
    /// Text of less weight, scale and frames.
    pub faint: Rgb,
    /// Lines that separate.
    pub rule: Rgb,
    /// Layout errors.
    pub error: Rgb,
    /// Errors that weigh little.
    pub mild: Rgb,
    /// What is pointed out.
    pub accent: Rgb,
    /// What is new and better.
    pub good: Rgb,
}

impl Theme {
    /// Its colours.
    pub fn ink(self) -> Ink {
        match self {
            Theme::Light => Ink {
                paper: Rgb::WHITE,
                text: Rgb(0x1f, 0x23, 0x28),
                faint: Rgb(0x65, 0x6d, 0x76),
                rule: Rgb(0xd0, 0xd7, 0xde),
                error: Rgb(0xd1, 0x1a, 0x2a),
                mild: Rgb(0xb8, 0x5c, 0x00),
                accent: Rgb(0x09, 0x69, 0xda),
                good: Rgb(0x1a, 0x7f, 0x37),
            },
            Theme::Dark => Ink {
                paper: Rgb(0x1b, 0x1e, 0x24),
                text: Rgb(0xe6, 0xe9, 0xee),
                faint: Rgb(0x9a, 0xa4, 0xb0),
                rule: Rgb(0x3b, 0x42, 0x4c),
                error: Rgb(0xff, 0x5c, 0x5c),
                mild: Rgb(0xff, 0xa9, 0x4d),
                accent: Rgb(0x58, 0xa6, 0xff),
                good: Rgb(0x3f, 0xb9, 0x50),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_is_six_hexadecimal_digits() {
        assert_eq!(Rgb::parse("4169E1"), Some(Rgb(0x41, 0x69, 0xe1)));
        assert!(["", "4169E", "#4169E1", "4169E1FF", "+12345", "é1234"].iter().all(|text| Rgb::parse(text).is_none()));
        assert_eq!(Rgb(0, 15, 255).hex(), "#000fff");
    }

    #[test]
    fn the_palette_stays_distinct_without_red_and_green() {
        // What is left to people without the red or the green receptor: brightness of what they see, and blue.
        let seen = |colour: Rgb| {
            let [r, g, b] = [colour.0, colour.1, colour.2].map(f64::from);
            [[0.15 * r + 0.85 * g, b], [0.55 * r + 0.45 * g, b]]
        };
        for (i, a) in PALETTE.iter().enumerate() {
            for b in &PALETTE[..i] {
                for (one, other) in seen(*a).iter().zip(seen(*b)) {
                    let apart = (one[0] - other[0]).hypot(one[1] - other[1]);
                    assert!(apart > 14.0, "{} and {} are {apart:.1} apart", a.hex(), b.hex());
                }
            }
        }
    }

    #[test]
    fn text_can_be_read_on_every_colour_of_the_palette() {
        for colour in PALETTE {
            assert!((colour.luminance() - colour.ink().luminance()).abs() > 0.35, "{}", colour.hex());
        }
    }
}
