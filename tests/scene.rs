//! The scene and its errors against the specification: recorded layouts, random ones, and the reference in Python.

#[path = "scene/layouts.rs"]
mod layouts;
#[path = "scene/oracle.rs"]
mod oracle;
#[path = "scene/random.rs"]
mod random;
#[path = "scene/read.rs"]
mod read;
