//! Methods of `object`.

use crate::python::native::Native;

/// Methods.
pub const OBJECT: &[Native] = &[];
/// Methods.
pub const TYPE: &[Native] = &[];
/// Methods.
pub const ALIAS: &[Native] = &[];
