//! Room: `syntax`.
