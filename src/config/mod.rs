//! `psdl.toml`: text → what holds for a program, and where each value came from.
//!
//! There is one table of settings ([`settings::all`]); reading, defaults, the JSON schema and `psdl config` are made from it.
//! There is one [`Resolver`]; the command line and the editor ask it.
//!
//! Invariants:
//! - A key that is no setting, or a value that cannot be, is an error at its place in the TOML, never a silent default.
//! - Files are read through a function that the caller gives, so that an editor can answer with what is not yet saved.
//!
//! It knows the rules of `check` and the limits of `python`, and nothing of protocols or terminals.

mod parse;
mod resolve;
mod schema;
pub mod settings;
mod show;

pub use resolve::{ConfigError, FILE_NAME, Resolved, Resolver};
pub use schema::schema;
pub use show::{Origin, show};
