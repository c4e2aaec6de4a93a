//! Methods of `exception`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
/// Methods.
pub const SYSTEM_EXIT: &[Native] = &[];
/// Methods.
pub const GROUP: &[Native] = &[];
/// Methods.
pub const STOP_ITERATION: &[Native] = &[];
/// Methods.
pub const ATTRIBUTE_ERROR: &[Native] = &[];
/// Methods.
pub const IMPORT_ERROR: &[Native] = &[];
/// Methods.
pub const KEY_ERROR: &[Native] = &[];
/// Methods.
pub const NAME_ERROR: &[Native] = &[];
/// Methods.
pub const OS_ERROR: &[Native] = &[];
