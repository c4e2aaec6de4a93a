//! What a layout is worth.

use crate::scene::Body;

/// Objects that moved by less than this did not move. Metres.
const STILL: f64 = 1e-6;

/// What the search compares: errors, and how far things went from where the program had them.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Score {
    /// The sum of the weighted losses.
    pub loss: u64,
    /// How many errors.
    pub count: usize,
    /// How many objects moved.
    pub moved: usize,
    /// Σ volume × distance, each object compared with itself. m⁴.
    pub work: f64,
}

impl Score {
    /// No more errors and no more loss than another.
    pub fn is_as_clean_as(&self, other: &Score) -> bool {
        self.loss <= other.loss && self.count <= other.count
    }
}

/// The volume of a body. m³.
pub(super) fn volume(body: &Body) -> f64 {
    body.dims.iter().product()
}

/// How far a body went, and whether that counts as moved.
pub(super) fn step(before: &Body, after: &Body) -> (f64, bool) {
    let distance = [0, 1, 2].map(|k| (after.center[k] - before.center[k]).powi(2)).iter().sum::<f64>().sqrt();
    (distance, distance > STILL)
}

/// How many objects moved, and the mean of their ways weighted by volume. Metres.
pub(super) fn displacement(before: &[Body], after: &[Body]) -> (usize, f64) {
    let steps = || before.iter().zip(after).map(|(a, b)| (volume(a), step(a, b)));
    let total: f64 = before.iter().map(volume).sum();
    let way: f64 = steps().map(|(volume, (distance, _))| volume * distance).sum();
    (steps().filter(|(_, (_, moved))| *moved).count(), if total > 0.0 { way / total } else { 0.0 })
}
