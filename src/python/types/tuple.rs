//! Methods of `tuple`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
