//! `random`
/// The state of a generator of random numbers.
#[derive(Debug, Default)]
pub struct Generator;
