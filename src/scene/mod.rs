//! Room: `scene`.
