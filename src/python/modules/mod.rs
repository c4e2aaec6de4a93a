//! Modules that programs may import.

pub mod itertools;
pub mod random;
