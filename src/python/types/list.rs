//! Methods of `list`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
