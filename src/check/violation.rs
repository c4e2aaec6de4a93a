//! A layout error as the search counts it: a kind, one or two objects, a length and a weighted loss.

use super::finding::Code;

/// The kinds of layout errors, in the order in which the errors of one object are told.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum ErrorKind {
    /// A box sticks out of the scene.
    OutOfBounds,
    /// Two boxes share volume.
    Overlap,
    /// A standing object floats or sinks.
    Standing,
    /// A mounted object hangs off the wall.
    Mounted,
    /// An object does not face what it was told to face.
    Facing,
    /// Something stands in the way of a door or window.
    Clearance,
    /// An object faces the wall it stands against.
    FacingWall,
    /// An object stands with its short side to the wall.
    ShortSide,
    /// x or y of an object was never written; reported only.
    Unplaced,
}

impl ErrorKind {
    /// All kinds.
    pub const ALL: [ErrorKind; 9] = [
        ErrorKind::OutOfBounds,
        ErrorKind::Overlap,
        ErrorKind::Standing,
        ErrorKind::Mounted,
        ErrorKind::Facing,
        ErrorKind::Clearance,
        ErrorKind::FacingWall,
        ErrorKind::ShortSide,
        ErrorKind::Unplaced,
    ];

    /// The kind of finding that tells it.
    pub const fn code(self) -> Code {
        match self {
            ErrorKind::OutOfBounds => Code::OutOfBounds,
            ErrorKind::Overlap => Code::Overlap,
            ErrorKind::Standing => Code::Standing,
            ErrorKind::Mounted => Code::Mounted,
            ErrorKind::Facing => Code::Facing,
            ErrorKind::Clearance => Code::Clearance,
            ErrorKind::FacingWall => Code::FacingWall,
            ErrorKind::ShortSide => Code::ShortSide,
            ErrorKind::Unplaced => Code::Unplaced,
        }
    }

    /// As layout JSON writes it: `out-of-bounds`.
    pub fn name(self) -> &'static str {
        self.code().name()
    }
}

/// One layout error.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Violation {
    /// What is wrong.
    pub kind: ErrorKind,
    /// The object that is wrong, as an index of the layout; of a clearance, the door or window.
    pub culprit: u32,
    /// The other object that takes part.
    pub other: Option<u32>,
    /// The loss in metres; 0 where the error has no length.
    pub metres: f64,
    /// int(weight × metres), or the weight itself; what the search minimises.
    pub loss: u64,
    /// Of `standing`: the object whose top is nearest; the ground where there is none.
    pub support: Option<u32>,
}

impl Violation {
    /// The objects, culprit first.
    pub fn objects(&self) -> impl Iterator<Item = usize> + Clone + use<> {
        [Some(self.culprit), self.other].into_iter().flatten().map(|index| index as usize)
    }
}

/// The errors of a layout.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Verdict {
    /// By culprit, kind and other object.
    pub violations: Vec<Violation>,
    /// Whether a limit of the rules ended the search for more of some kind.
    pub truncated: bool,
}

impl Verdict {
    /// The errors that count: all but `unplaced`.
    pub fn counted(&self) -> impl Iterator<Item = &Violation> {
        self.violations.iter().filter(|violation| violation.kind != ErrorKind::Unplaced)
    }

    /// The sum of the losses.
    pub fn loss(&self) -> u64 {
        self.counted().fold(0, |sum, violation| sum.saturating_add(violation.loss))
    }
}
