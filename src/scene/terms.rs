//! The words of the language: axes, anchors, cardinals, supports, and numbers as a program gives them.

use crate::trace::Num;

/// An axis of the scene or of a frame: x right, y away, z up.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Axis {
    /// Right.
    X,
    /// Away.
    Y,
    /// Up; the same in every frame.
    Z,
}

impl Axis {
    /// All three, in order.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    /// 0, 1, 2.
    pub const fn index(self) -> usize {
        self as usize
    }

    /// As programs write it.
    pub const fn name(self) -> &'static str {
        ["x", "y", "z"][self as usize]
    }

    /// From a component's name.
    pub fn from_name(name: &str) -> Option<Axis> {
        Axis::ALL.into_iter().find(|axis| axis.name() == name)
    }
}

/// The part of a box that a coordinate belongs to.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Anchor {
    /// The smallest coordinate.
    Min,
    /// The middle.
    Center,
    /// The largest coordinate.
    Max,
}

impl Anchor {
    /// All three.
    pub const ALL: [Anchor; 3] = [Anchor::Min, Anchor::Center, Anchor::Max];

    /// The same part of the box, seen along the axis reversed.
    pub const fn flipped(self) -> Anchor {
        match self {
            Anchor::Min => Anchor::Max,
            Anchor::Center => Anchor::Center,
            Anchor::Max => Anchor::Min,
        }
    }

    /// As programs write it.
    pub const fn name(self) -> &'static str {
        ["min", "center", "max"][self as usize]
    }

    /// From an attribute's name.
    pub fn from_name(name: &str) -> Option<Anchor> {
        Anchor::ALL.into_iter().find(|anchor| anchor.name() == name)
    }
}

/// A direction of the world, numbered by quarter turns as in programs: `X_MAX = 0`, `Y_MAX = 1`, `X_MIN = 2`, `Y_MIN = 3`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Cardinal {
    /// Toward the right wall.
    XMax,
    /// Toward the top wall; what an object that nothing turns faces.
    YMax,
    /// Toward the left wall.
    XMin,
    /// Toward the bottom wall.
    YMin,
}

impl Cardinal {
    /// All four, by number.
    pub const ALL: [Cardinal; 4] = [Cardinal::XMax, Cardinal::YMax, Cardinal::XMin, Cardinal::YMin];

    /// The number that programs use.
    pub const fn index(self) -> usize {
        self as usize
    }

    /// The direction after a number of quarter turns, any integer.
    pub const fn from_turns(turns: i64) -> Cardinal {
        Cardinal::ALL[turns.rem_euclid(4) as usize]
    }

    /// What a number means as a facing: truncated; below 10 quarter turns, from 10 on degrees. `None` for NaN and infinity.
    pub fn from_number(value: f64) -> Option<Cardinal> {
        let turns = if value < 10.0 { value.trunc() } else { (value / 90.0).trunc() };
        turns.is_finite().then(|| Cardinal::from_turns((turns % 4.0) as i64))
    }

    /// From a number that [`index`](Cardinal::index) gave.
    pub(super) fn of_turn(turn: Num) -> Cardinal {
        Cardinal::from_turns(turn.value as i64)
    }

    /// The other way.
    pub const fn opposite(self) -> Cardinal {
        Cardinal::ALL[(self as usize + 2) % 4]
    }

    /// The horizontal axis that it lies along.
    pub const fn axis(self) -> Axis {
        match self {
            Cardinal::XMax | Cardinal::XMin => Axis::X,
            Cardinal::YMax | Cardinal::YMin => Axis::Y,
        }
    }

    /// The name programs use: `X_MAX`.
    pub const fn name(self) -> &'static str {
        ["X_MAX", "Y_MAX", "X_MIN", "Y_MIN"][self as usize]
    }

    /// The name in layout JSON: `X+`.
    pub const fn short_name(self) -> &'static str {
        ["X+", "Y+", "X-", "Y-"][self as usize]
    }
}

/// What holds an object up.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Support {
    /// The ground or the top of another object.
    Standing,
    /// A wall.
    Mounted,
    /// Nothing.
    Floating,
}

impl Support {
    /// All three, by the number programs use.
    pub const ALL: [Support; 3] = [Support::Standing, Support::Mounted, Support::Floating];

    /// From the number programs use.
    pub fn from_number(value: f64) -> Option<Support> {
        Support::ALL.into_iter().find(|support| *support as u8 as f64 == value)
    }

    /// As programs and layout JSON write it.
    pub const fn name(self) -> &'static str {
        ["STANDING", "MOUNTED", "FLOATING"][self as usize]
    }

    /// From the name; `WALL_MOUNTED` is another name of `MOUNTED`.
    pub fn from_name(name: &str) -> Option<Support> {
        if name == "WALL_MOUNTED" {
            return Some(Support::Mounted);
        }
        Support::ALL.into_iter().find(|support| support.name() == name)
    }
}

/// What an object is: doors and windows keep a clearance and are always mounted.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Kind {
    /// Anything.
    Object,
    /// A door.
    Door,
    /// A window.
    Window,
}

impl Kind {
    /// As layout JSON writes it.
    pub const fn name(self) -> &'static str {
        ["OBJECT", "DOOR", "WINDOW"][self as usize]
    }
}

/// An object of a world or layout, numbered in order of declaration.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct ObjectId(pub u32);

impl ObjectId {
    /// The place among the objects of the layout.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// Something that has a box: an object, or the scene itself.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Target {
    /// The scene.
    Scene,
    /// An object.
    Object(ObjectId),
}

/// A number as a program gave it: Python tells `3` from `3.0`, and so do what is read back and the layout JSON.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Scalar {
    /// The number.
    pub num: Num,
    /// Whether it is an integer of the program.
    pub int: bool,
}

impl Scalar {
    /// A float that no literal reaches.
    pub const fn float(value: f64) -> Scalar {
        Scalar { num: Num::plain(value), int: false }
    }

    /// An integer that no literal reaches.
    pub const fn int(value: i64) -> Scalar {
        Scalar { num: Num::plain(value as f64), int: true }
    }

    /// The value.
    pub const fn value(self) -> f64 {
        self.num.value
    }

    /// As Python's `repr` shows it.
    pub fn shown(self) -> String {
        let value = self.num.value;
        if self.int {
            return format!("{value:.0}");
        }
        if !value.is_finite() {
            return if value.is_nan() { "nan".into() } else { format!("{value}") };
        }
        let text = format!("{value:?}");
        match text.split_once('e') {
            None => text,
            Some((mantissa, exponent)) => {
                let (sign, digits) = exponent.strip_prefix('-').map_or(('+', exponent), |digits| ('-', digits));
                format!("{}e{sign}{digits:0>2}", mantissa.strip_suffix(".0").unwrap_or(mantissa))
            }
        }
    }
}

impl From<Num> for Scalar {
    fn from(num: Num) -> Scalar {
        Scalar { num, int: false }
    }
}

/// A value that a program handed over where a number is wanted.
#[derive(Clone, PartialEq, Debug)]
pub enum Given {
    /// A number.
    Number(Scalar),
    /// Anything else (a `bool` too), by what error messages need of it.
    Other {
        /// `type(value).__name__`
        type_name: String,
        /// `repr(value)`
        repr: String,
    },
}

impl Given {
    /// The value as Python's `repr` shows it.
    pub fn shown(&self) -> String {
        match self {
            Given::Number(scalar) => scalar.shown(),
            Given::Other { repr, .. } => repr.clone(),
        }
    }
}

impl From<Scalar> for Given {
    fn from(scalar: Scalar) -> Given {
        Given::Number(scalar)
    }
}

impl From<f64> for Given {
    fn from(value: f64) -> Given {
        Given::Number(Scalar::float(value))
    }
}

/// The category of an object: its name without a trailing number ("Chair 3" is a "Chair").
pub fn category_of(name: &str) -> &str {
    let body = name.strip_suffix('\n').unwrap_or(name);
    let head = body.trim_end_matches(|c: char| c.is_ascii_digit() || !c.is_ascii() && c.is_numeric());
    let category = head.trim_end_matches(|c: char| c.is_whitespace() || ('\x1c'..='\x1f').contains(&c));
    if head.len() == body.len() || category.len() == head.len() { name } else { category }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_facing_number_is_truncated_and_counts_turns_or_degrees() {
        let turns = |value| Cardinal::from_number(value).map(Cardinal::index);
        assert_eq!([0.0, 1.9, -0.5, -1.0, 9.9].map(turns), [0, 1, 0, 3, 1].map(Some));
        assert_eq!([10.0, 90.0, 180.0, 359.0, 360.0, 450.0].map(turns), [0, 1, 2, 3, 0, 1].map(Some));
        assert_eq!([f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(turns), [None; 3]);
        assert_eq!(turns(1e300), Some(0));
    }

    #[test]
    fn a_trailing_number_is_no_part_of_the_category() {
        assert_eq!(
            ["Chair 3", "Chair", "Chair3", "Chair  12", "3", " 3", "Box 1 2", "كرسي ٣"].map(category_of),
            ["Chair", "Chair", "Chair3", "Chair", "3", "", "Box 1", "كرسي"]
        );
    }

    #[test]
    fn numbers_show_as_python_shows_them() {
        let shown = [Scalar::int(-3), Scalar::float(-3.0), Scalar::float(1e-7), Scalar::float(1.5e16), Scalar::float(f64::NAN)];
        assert_eq!(shown.map(Scalar::shown), ["-3", "-3.0", "1e-07", "1.5e+16", "nan"]);
        assert_eq!(Scalar::float(f64::NEG_INFINITY).shown(), "-inf");
    }
}
