//! `random`
/// The state of a generator of random numbers.
#[derive(Debug)]
pub struct Generator;
