//! Methods of `int`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
/// Methods.
pub const BOOL: &[Native] = &[];
