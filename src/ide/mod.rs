//! What an editor can ask about an analysed program: one file a feature, plain functions over plain data.
//!
//! A feature takes a [`View`] (a [`Program`] as its text stands and the [`Scene`] of the last run that came to something, which
//! may be that of an older text) and a place, and works on a text that does not parse as well as it can.
//!
//! Invariants:
//! - Places are bytes of the program's text. Lines, columns and documents are the business of the caller.
//! - No I/O, no clock, no threads, no types of a protocol: a test is a text with a place in it.
//! - No text and no place makes a feature panic.

mod docs;
mod find;
mod fixes;
mod hover;
mod lab;
mod layout;
mod program;
mod refactor;
pub mod search;
mod suppress;
mod values;
mod words;

pub use docs::Doc;
pub use fixes::{QuickFix, quick_fixes, touches};
pub use hover::{Hover, hover};
pub use lab::{Lab, Offer};
pub use layout::{Places, layout_text, places};
pub use program::{Deed, Mark, Program, Scene, View};
pub use refactor::{Ground, Refactoring, RefactoringKind, Sidecar, refactorings};
pub use search::Search;
pub use suppress::suppress;

#[cfg(test)]
mod tests;
