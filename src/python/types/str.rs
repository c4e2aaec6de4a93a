//! Methods of `str`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
