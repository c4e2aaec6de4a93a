//! Colours, as the program gives them, else from a palette.

use crate::scene::Placed;

/// Red, green, blue as a screen shows them.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub(super) struct Rgb(pub(super) [u8; 3]);

/// Okabe and Ito's colours, without black.
const PALETTE: [[u8; 3]; 7] = [[230, 159, 0], [86, 180, 233], [0, 158, 115], [240, 228, 66], [0, 114, 178], [213, 94, 0], [204, 121, 167]];

/// A floor without a colour.
pub(super) const FLOOR: Rgb = Rgb([0xD8, 0xD2, 0xC8]);
/// A wall without a colour.
pub(super) const WALL: Rgb = Rgb([0xE8, 0xE4, 0xDC]);

impl Rgb {
    /// RRGGBB.
    pub(super) fn parse(text: &str) -> Option<Rgb> {
        let byte = |at: usize| u8::from_str_radix(text.get(at..at + 2)?, 16).ok();
        Some(Rgb([byte(0)?, byte(2)?, byte(4)?]))
    }

    /// The colour of a surface that may have none.
    pub(super) fn or(text: Option<&str>, other: Rgb) -> Rgb {
        text.and_then(Rgb::parse).unwrap_or(other)
    }

    /// RRGGBB
    pub(super) fn hex(self) -> String {
        let [r, g, b] = self.0;
        format!("{r:02X}{g:02X}{b:02X}")
    }

    /// From 0 to 1, as a screen shows them.
    pub(super) fn fractions(self) -> [f64; 3] {
        self.0.map(|value| f64::from(value) / 255.0)
    }

    /// From 0 to 1, in proportion to light: what renderers compute with.
    pub(super) fn linear(self) -> [f64; 3] {
        self.fractions().map(|c| if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) })
    }
}

/// The colour of an object; one without gets that of its category.
pub(super) fn of_object(object: &Placed) -> Rgb {
    let sum = object.name.bytes().fold(0_usize, |sum, byte| sum.wrapping_mul(31).wrapping_add(usize::from(byte)));
    Rgb::or(object.color.as_deref(), Rgb(PALETTE[sum % PALETTE.len()]))
}
