//! The compiler: tree → code.
