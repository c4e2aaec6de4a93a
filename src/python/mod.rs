//! Room: `python`.
