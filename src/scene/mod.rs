//! The scene: objects, frames, deferred anchors and facings, and the layout that follows from them.
//!
//! A [`World`] takes the calls of a running program (declare, write an anchor, set a facing, change the frame,
//! read a coordinate) and gives a [`Layout`]: boxes, each tied to the statements that placed it.
//!
//! Invariants:
//! - The order of float operations is part of the language. `center = anchor ± 0.5 × extent`,
//!   `min = center − 0.5 × extent`, `max = center + 0.5 × extent`, to the last bit.
//! - Every operation on a coordinate goes through [`crate::trace::Arith`], and every settling is one guard, so that a
//!   run can be replayed with another literal.
//! - Sizes are set in stone: they are plain numbers once an object exists.
//!
//! Knows `trace`; [`host`] alone knows Python. Knows nothing of layout errors, editors or files.

mod error;
mod frame;
pub mod host;
mod json;
mod layout;
pub mod names;
mod origin;
mod settle;
pub mod template;
mod terms;
mod thing;
mod world;

pub use error::SceneError;
pub use frame::Frame;
pub use json::{JsonViolation, layout_json};
pub use layout::{Body, Layout, Placed, PlacedAnchor, Told, Warning, WarningKind};
pub use origin::{Origin, OriginId, Origins, Source, Step, StepId, StepKind};
pub use settle::{Aim, Outcome, Question, decide, extents, toward};
pub use terms::{Anchor, Axis, Cardinal, Given, Kind, ObjectId, Scalar, Support, Target, category_of};
pub use world::{FacingSpec, MAX_OBJECTS, NewObject, SceneInfo, Surface, World};

#[cfg(test)]
mod tests;
