//! Room: `cli`.
