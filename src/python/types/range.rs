//! Methods of `range`.

use crate::python::native::Native;

/// Methods.
pub const SLICE: &[Native] = &[];
/// Methods.
pub const METHODS: &[Native] = &[];
