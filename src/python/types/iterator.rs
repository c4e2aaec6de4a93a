//! Methods of `iterator`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
/// Methods.
pub const CHAIN: &[Native] = &[];
