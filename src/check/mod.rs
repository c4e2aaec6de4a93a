//! What is wrong with a layout.
//!
//! A [`Layout`](crate::scene::Layout) goes in; out come [`Violation`]s, as the search counts them, and [`finding::Finding`]s, as people
//! read them: at the statement to blame, in plain words.
//!
//! Invariants:
//! - A spatial index chooses which pairs are measured. It changes no result: every pair that the rules call an error is found, up to
//!   the documented [limits](rules::Limits), and the verdict says when one was met.
//! - Each error is measured by one function in [`measure`], of the bodies that take part and nothing else, so that a search can
//!   measure again just the objects that it moved.
//!
//! Knows `scene`. Knows nothing of how errors are fixed or shown.

mod blame;
mod checker;
pub mod codes;
pub mod finding;
mod findings;
mod index;
pub mod measure;
pub mod rules;
mod violation;
mod words;

pub use checker::{Checker, check};
pub use findings::{errors_by_place, findings};
pub use rules::Rules;
pub use violation::{ErrorKind, Verdict, Violation};

#[cfg(test)]
mod tests;
