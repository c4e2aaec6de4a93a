//! Methods of `bytes`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
/// Methods.
pub const ARRAY: &[Native] = &[];
