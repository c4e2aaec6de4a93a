//! Methods of `complex`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
