//! Colours as the formats count them; which colours, `render` says.

use crate::render::colour;
use crate::scene::{Layout, SceneInfo};

/// Red, green, blue as a screen shows them.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub(super) struct Rgb([u8; 3]);

impl From<colour::Rgb> for Rgb {
    fn from(colour::Rgb(r, g, b): colour::Rgb) -> Rgb {
        Rgb([r, g, b])
    }
}

impl Rgb {
    /// RRGGBB
    pub(super) fn hex(self) -> String {
        let [r, g, b] = self.0;
        format!("{r:02X}{g:02X}{b:02X}")
    }

    /// From 0 to 1, as a screen shows them; six decimals are more than eight bits need.
    pub(super) fn fractions(self) -> [f64; 3] {
        self.0.map(|value| libm::round(f64::from(value) / 255.0 * 1e6) / 1e6)
    }

    /// From 0 to 1, in proportion to light: what renderers compute with.
    pub(super) fn linear(self) -> [f64; 3] {
        let linear = |c: f64| if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) };
        self.0.map(|value| libm::round(linear(f64::from(value) / 255.0) * 1e6) / 1e6)
    }
}

/// The colour of each object.
pub(super) fn objects(layout: &Layout) -> Vec<Rgb> {
    colour::objects(layout).into_iter().map(Rgb::from).collect()
}

/// The colours of the floor and the walls.
pub(super) fn surfaces(scene: &SceneInfo) -> [Rgb; 2] {
    [colour::floor(scene), colour::wall(scene)].map(Rgb::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_is_not_what_a_screen_counts() {
        let grey = Rgb([255, 128, 0]);
        assert_eq!((grey.hex().as_str(), grey.fractions(), grey.linear()), ("FF8000", [1.0, 0.501961, 0.0], [1.0, 0.215861, 0.0]));
    }
}
