//! Room: `report`.
