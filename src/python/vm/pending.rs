//! Doors that the native types will open: each function here goes when its type brings it (`types::str::construct` and so on).

use super::Vm;
use crate::python::error::R;
use crate::python::heap::Class;
use crate::python::heap::Ref;
use crate::python::native::Args;
use crate::python::value::Value;

/// Builtin types without a constructor of their own yet.
pub(super) fn construct(vm: &mut Vm<'_>, class: Ref<Class>, _: Args<'_>) -> R<Value> {
    let message = format!("cannot create '{}' instances", vm.class_name(class));
    Err(vm.type_error(message))
}
