//! psdl: run, check and repair PSDL scene programs.
//!
//! Data flows one way, `syntax` → `trace`/`python` → `scene` → `check` → `report`, with the faces
//! (`cli`) at the end. A module knows only the modules above it in this list. See `ARCHITECTURE.md`.

pub mod analysis;
pub mod check;
pub mod cli;
pub mod config;
pub mod export;
pub mod ide;
mod markup;
pub mod python;
pub mod render;
pub mod repair;
pub mod report;
pub mod scene;
pub mod server;
pub mod syntax;
pub mod trace;
