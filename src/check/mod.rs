//! What is wrong with a layout.

pub mod finding;
