//! Methods of `float`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
