//! Methods of `dict`.

use crate::python::native::Native;

/// Methods.
pub const METHODS: &[Native] = &[];
/// Methods.
pub const PROXY: &[Native] = &[];
/// Methods.
pub const KEYS: &[Native] = &[];
/// Methods.
pub const VALUES: &[Native] = &[];
/// Methods.
pub const ITEMS: &[Native] = &[];
