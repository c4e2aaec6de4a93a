//! What a call on the scene raises.

use std::fmt;

use super::terms::{Anchor, Axis, Given};

/// An exception for the program: the class that Python would raise, and the message.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SceneError {
    /// The name of a builtin exception class.
    pub exception: &'static str,
    /// What `str(exception)` gives.
    pub message: String,
}

impl SceneError {
    /// A `TypeError`.
    pub fn type_error(message: impl Into<String>) -> SceneError {
        SceneError { exception: "TypeError", message: message.into() }
    }

    /// A `ValueError`.
    pub fn value(message: impl Into<String>) -> SceneError {
        SceneError { exception: "ValueError", message: message.into() }
    }

    /// An `AttributeError`.
    pub fn attribute(message: impl Into<String>) -> SceneError {
        SceneError { exception: "AttributeError", message: message.into() }
    }

    pub(super) fn too_many(limit: usize) -> SceneError {
        SceneError { exception: "MemoryError", message: format!("a scene holds at most {limit} objects") }
    }

    pub(super) fn no_size(name: &str, label: &str, given: &Given) -> SceneError {
        SceneError::value(format!("{name}: {label} must be a positive number, not {}", given.shown()))
    }

    pub(super) fn no_number(name: &str, anchor: Anchor, axis: Axis, type_name: &str) -> SceneError {
        SceneError::type_error(format!("{name}.{}.{} takes a number, not {type_name}", anchor.name(), axis.name()))
    }

    pub(super) fn not_finite(name: &str, anchor: Anchor, axis: Axis, shown: &str) -> SceneError {
        SceneError::value(format!("{name}.{}.{} must be finite, not {shown}", anchor.name(), axis.name()))
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.exception, self.message)
    }
}

impl std::error::Error for SceneError {}
