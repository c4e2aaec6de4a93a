//! What an editor can ask about an analysed program: one file a feature, plain functions over plain data.
//!
//! Invariants:
//! - Places are bytes of the program's text. Lines, columns and documents are the business of the caller.
//! - No I/O, no clock, no threads, no types of a protocol: a test is a text with a place in it.

mod fixes;

pub use fixes::{QuickFix, quick_fixes};
