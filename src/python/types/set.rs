//! Methods of `set`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
/// Methods.
pub const FROZEN: &[Native] = &[];
