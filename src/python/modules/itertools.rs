//! `itertools`
use crate::python::value::Value;
/// Where an iterator of `itertools` stands.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum Tool {
    Chain(Vec<Value>),
}
impl Tool {
    /// Bytes beyond its own size.
    pub fn extra(&self) -> usize {
        0
    }
    /// The values it holds.
    pub fn children(&self, _out: &mut Vec<Value>) {}
}
