//! `itertools`
use crate::python::error::R;
use crate::python::heap::{Iter, Ref};
use crate::python::value::Value;
use crate::python::vm::Vm;
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
/// The next item.
pub fn next(_vm: &mut Vm<'_>, _iter: Ref<Iter>) -> R<Option<Value>> {
    Ok(None)
}
