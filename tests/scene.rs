//! The scene and its errors against the specification: recorded layouts, random ones, and the reference in Python.

#[path = "scene/generated.rs"]
mod generated;
#[path = "scene/layouts.rs"]
mod layouts;
#[path = "scene/oracle.rs"]
mod oracle;
#[path = "scene/programs.rs"]
mod programs;
#[path = "scene/random.rs"]
mod random;
#[path = "scene/read.rs"]
mod read;
