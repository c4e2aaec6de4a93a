//! What is wrong with a layout.

pub mod codes;
pub mod finding;
