//! Where numbers come from: the record of the float operations of a run.
//!
//! A number that a literal of the program reaches carries a [`Handle`]; a number that none reaches
//! carries [`Handle::NONE`] and costs nothing. Knows nothing of Python or of scenes.

/// The place of a number in the record of a run; [`Handle::NONE`] for a number that no tunable literal reaches.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash, PartialOrd, Ord)]
pub struct Handle(pub u32);

impl Handle {
    /// No literal reaches this number.
    pub const NONE: Handle = Handle(0);

    /// True where no literal reaches the number.
    #[inline(always)]
    pub fn is_none(self) -> bool {
        self.0 == 0
    }
}

/// A float together with its place in the record. Units are those of the caller (metres in scenes).
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Num {
    /// The number itself.
    pub value: f64,
    /// Where it came from.
    pub handle: Handle,
}

impl Num {
    /// A number that no literal reaches.
    pub const fn plain(value: f64) -> Num {
        Num { value, handle: Handle::NONE }
    }
}
