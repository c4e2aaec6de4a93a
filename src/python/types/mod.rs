//! The builtin types: their methods.

pub mod bytes;
pub mod complex;
pub mod containers;
pub mod dict;
pub mod exception;
pub mod float;
pub mod function;
pub mod int;
pub mod iterator;
pub mod list;
pub mod member;
pub mod number;
pub mod object;
pub mod range;
mod search;
pub mod set;
pub mod slice;
pub mod str;
pub mod tuple;
pub mod unicode_error;
