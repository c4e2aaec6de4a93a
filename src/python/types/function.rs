//! Methods of `function`.

use crate::python::native::Native;

/// Methods.
pub const FUNCTION: &[Native] = &[];
/// Methods.
pub const NATIVE: &[Native] = &[];
/// Methods.
pub const METHOD: &[Native] = &[];
/// Methods.
pub const GENERATOR: &[Native] = &[];
/// Methods.
pub const PROPERTY: &[Native] = &[];
/// Methods.
pub const CLASS_METHOD: &[Native] = &[];
/// Methods.
pub const STATIC_METHOD: &[Native] = &[];
