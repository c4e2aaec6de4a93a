//! What counts as an error, and how much.

/// Tolerances, sizes and weights of the layout errors. The default is the specification.
#[derive(Clone, PartialEq, Debug)]
pub struct Rules {
    /// Boxes that can be parted by less than this touch; a gap below it is none. Metres, not negative.
    pub tolerance: f64,
    /// A box whose anchor lies closer than this to a wall stands against it. Metres.
    pub wall_tolerance: f64,
    /// Things that one may stand on and in.
    pub rug: Rug,
    /// What doors and windows keep free.
    pub clearance: Clearance,
    /// How much a metre of each error weighs; 0 turns it off.
    pub weights: Weights,
    /// How far a check of a hopeless scene goes.
    pub limits: Limits,
}

/// What is flat enough to overlap nothing.
#[derive(Clone, PartialEq, Debug)]
pub struct Rug {
    /// Its height at most, as a part of its width and of its depth.
    pub ratio: f64,
    /// Its height stays below this. Metres.
    pub height: f64,
}

/// How far the clearance of a door or window reaches to both sides.
#[derive(Clone, PartialEq, Debug)]
pub struct Clearance {
    /// As a part of a door's width.
    pub door: f64,
    /// As a part of a window's width.
    pub window: f64,
    /// At most so far for a window. Metres.
    pub window_most: f64,
}

/// Weights by kind: of a metre, or of the error itself where it has no length.
#[derive(Clone, PartialEq, Debug)]
#[allow(missing_docs)]
pub struct Weights {
    pub out_of_bounds: f64,
    pub overlap: f64,
    pub standing: f64,
    pub mounted: f64,
    pub clearance: f64,
    /// Of the error itself.
    pub facing: f64,
    /// Of the error itself.
    pub facing_wall: f64,
    /// Of a metre of the longest extent of what is not mounted.
    pub short_side: f64,
    /// Of a metre of the longest extent of what is mounted.
    pub short_side_mounted: f64,
}

/// Bounds of time and memory for scenes of thousands of boxes in one place. A check that meets one says so.
#[derive(Clone, PartialEq, Debug)]
pub struct Limits {
    /// At most so many violations of a kind are told.
    pub violations: usize,
    /// At most so many pairs of boxes are compared for each kind.
    pub pairs: usize,
}

impl Default for Rules {
    fn default() -> Rules {
        Rules {
            tolerance: 0.01,
            wall_tolerance: 0.05,
            rug: Rug { ratio: 0.1, height: 0.2 },
            clearance: Clearance { door: 0.5, window: 0.25, window_most: 0.4 },
            weights: Weights::default(),
            limits: Limits::default(),
        }
    }
}

impl Default for Weights {
    fn default() -> Weights {
        Weights {
            out_of_bounds: 250.0,
            overlap: 100.0,
            standing: 100.0,
            mounted: 100.0,
            clearance: 50.0,
            facing: 1.0,
            facing_wall: 1.0,
            short_side: 10.0,
            short_side_mounted: 100.0,
        }
    }
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { violations: 200_000, pairs: 50_000_000 }
    }
}
