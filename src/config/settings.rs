//! The settings: their names, what they mean, which values they take, and which part of the options they are.

use crate::analysis::Options;
use crate::check::codes;
use crate::check::finding::{Code, Severity};

/// A value of a setting.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Value {
    /// A length, a part or a weight.
    Number(f64),
    /// A number of things.
    Count(u64),
    /// What a kind of finding weighs; nothing turns it off.
    Severity(Option<Severity>),
}

/// Which values a setting takes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Range {
    /// A finite number from the first to the second.
    Number(f64, f64),
    /// An integer from the first to the second.
    Count(u64, u64),
    /// `error`, `warning`, `info` or `off`.
    Severity,
}

/// The part of the options that a setting stands for.
#[derive(Clone, Copy, Debug)]
enum Part {
    Number(fn(&mut Options) -> &mut f64),
    Count(fn(&mut Options) -> &mut u64),
    Size(fn(&mut Options) -> &mut usize),
    Severity(Code),
}

/// A setting.
#[derive(Clone, Debug)]
pub struct Setting {
    /// Its place: `check.weights.overlap`.
    pub key: String,
    /// What it means, in one sentence.
    pub doc: String,
    /// Which values it takes.
    pub range: Range,
    part: Part,
}

/// A row of the table below.
type Row = (&'static str, &'static str, Range, Part);

const METRES: Range = Range::Number(0.0, 1_000.0);
const SHARE: Range = Range::Number(0.0, 10.0);
const WEIGHT: Range = Range::Number(0.0, 1e9);

/// All settings but the severities, of which there is one for each kind of finding.
const ROWS: &[Row] = &[
    (
        "check.tolerance",
        "Boxes that can be parted by moving one less than this touch and do not overlap; metres.",
        METRES,
        Part::Number(|o| &mut o.rules.tolerance),
    ),
    (
        "check.wall-tolerance",
        "A box whose anchor lies closer than this to a wall stands against it; metres.",
        METRES,
        Part::Number(|o| &mut o.rules.wall_tolerance),
    ),
    (
        "check.rug.ratio",
        "The height of a rug at most, as a part of its width and of its depth.",
        SHARE,
        Part::Number(|o| &mut o.rules.rug.ratio),
    ),
    ("check.rug.height", "The height of a rug stays below this; metres.", METRES, Part::Number(|o| &mut o.rules.rug.height)),
    (
        "check.clearance.door",
        "How far a door keeps free the room to both sides, as a part of its width.",
        SHARE,
        Part::Number(|o| &mut o.rules.clearance.door),
    ),
    (
        "check.clearance.window",
        "How far a window keeps free the room to both sides, as a part of its width.",
        SHARE,
        Part::Number(|o| &mut o.rules.clearance.window),
    ),
    ("check.clearance.window-most", "And at most so far; metres.", METRES, Part::Number(|o| &mut o.rules.clearance.window_most)),
    (
        "check.weights.out-of-bounds",
        "The weight of a metre out of the scene.",
        WEIGHT,
        Part::Number(|o| &mut o.rules.weights.out_of_bounds),
    ),
    (
        "check.weights.overlap",
        "The weight of a metre of overlap (the cube root of the shared volume).",
        WEIGHT,
        Part::Number(|o| &mut o.rules.weights.overlap),
    ),
    (
        "check.weights.standing",
        "The weight of a metre between an object and its support.",
        WEIGHT,
        Part::Number(|o| &mut o.rules.weights.standing),
    ),
    (
        "check.weights.mounted",
        "The weight of a metre between a mounted object and its wall.",
        WEIGHT,
        Part::Number(|o| &mut o.rules.weights.mounted),
    ),
    ("check.weights.clearance", "The weight of a metre in a clearance.", WEIGHT, Part::Number(|o| &mut o.rules.weights.clearance)),
    ("check.weights.facing", "The weight of a wrong facing.", WEIGHT, Part::Number(|o| &mut o.rules.weights.facing)),
    ("check.weights.facing-wall", "The weight of facing a wall.", WEIGHT, Part::Number(|o| &mut o.rules.weights.facing_wall)),
    (
        "check.weights.short-side",
        "The weight of a metre of what has its short side to the wall.",
        WEIGHT,
        Part::Number(|o| &mut o.rules.weights.short_side),
    ),
    (
        "check.weights.short-side-mounted",
        "The same for what is mounted.",
        WEIGHT,
        Part::Number(|o| &mut o.rules.weights.short_side_mounted),
    ),
    (
        "limits.steps",
        "A run ends after about so many instructions.",
        Range::Count(1_000, 1_000_000_000_000),
        Part::Count(|o| &mut o.limits.steps),
    ),
    ("limits.memory", "A run may use so many bytes.", Range::Count(1 << 20, 1 << 36), Part::Size(|o| &mut o.limits.memory)),
    ("limits.recursion", "Functions may call each other so deep.", Range::Count(10, 10_000), Part::Size(|o| &mut o.limits.recursion)),
    ("limits.output", "A run may print so many bytes.", Range::Count(0, 1 << 32), Part::Count(|o| &mut o.limits.output)),
];

/// All settings, in the order in which they are shown.
pub fn all() -> Vec<Setting> {
    let rows = ROWS.iter().map(|(key, doc, range, part)| Setting { key: (*key).into(), doc: (*doc).into(), range: *range, part: *part });
    let severities = codes::all().map(|info| Setting {
        key: format!("severity.{}", info.name),
        doc: info.summary.into(),
        range: Range::Severity,
        part: Part::Severity(info.code),
    });
    rows.chain(severities).collect()
}

impl Setting {
    /// Sets it.
    pub fn set(&self, options: &mut Options, value: Value) {
        match (self.part, value) {
            (Part::Number(part), Value::Number(number)) => *part(options) = number,
            (Part::Count(part), Value::Count(count)) => *part(options) = count,
            (Part::Size(part), Value::Count(count)) => *part(options) = usize::try_from(count).unwrap_or(usize::MAX),
            (Part::Severity(code), Value::Severity(severity)) => options.severities.set(code, severity),
            // Values are made for the range of the setting, which goes with its part.
            _ => {}
        }
    }

    /// What it is set to.
    pub fn get(&self, options: &Options) -> Value {
        // The parts are reached for writing; reading does so in a copy.
        let mut options = options.clone();
        match self.part {
            Part::Number(part) => Value::Number(*part(&mut options)),
            Part::Count(part) => Value::Count(*part(&mut options)),
            Part::Size(part) => Value::Count(*part(&mut options) as u64),
            Part::Severity(code) => Value::Severity(options.severities.of(code)),
        }
    }
}

impl Value {
    /// As TOML writes it.
    pub fn to_toml(self) -> String {
        match self {
            Value::Number(number) => format!("{number:?}"),
            Value::Count(count) => count.to_string(),
            Value::Severity(severity) => format!("\"{}\"", severity.map_or("off", Severity::name)),
        }
    }
}

impl Range {
    /// What a value must be, for messages: "a number from 0 to 10".
    pub fn describe(self) -> String {
        match self {
            Range::Number(from, to) => format!("a number from {from} to {to}"),
            Range::Count(from, to) => format!("an integer from {from} to {to}"),
            Range::Severity => "\"error\", \"warning\", \"info\" or \"off\"".into(),
        }
    }
}
