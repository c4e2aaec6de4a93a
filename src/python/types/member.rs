//! `member_descriptor`: what a class holds for each name of its `__slots__`. The values themselves stand among the instance's own
//! attributes.

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::native::{Args, Native};
use crate::python::symbols::sym;
use crate::python::value::{Symbol, Value};
use crate::python::vm::Vm;

/// Methods of `member_descriptor`.
pub const METHODS: &[Native] = &[
    Native::raw("__get__", 1, 2, |vm, a| {
        if a.at(1).is_none() {
            return Ok(a.at(0));
        }
        let (i, name) = place(vm, a)?;
        match vm.own_attr(i, name) {
            Some(value) => Ok(value),
            None => Err(vm.no_attribute(a.at(1), name)),
        }
    }),
    Native::raw("__set__", 2, 2, |vm, a| {
        let (i, name) = place(vm, a)?;
        vm.store_own(i, name, a.at(2))?;
        Ok(Value::None)
    }),
    Native::raw("__delete__", 1, 1, |vm, a| {
        let (i, name) = place(vm, a)?;
        match vm.remove_own(i, name)? {
            Some(_) => Ok(Value::None),
            None => {
                let text = vm.symbols.text(name).to_string();
                Err(vm.error(Builtin::AttributeError, text))
            }
        }
    }),
    Native::raw("__repr__", 0, 0, |vm, a| {
        let (owner, name) = parts(vm, a.at(0));
        let owner = owner.map_or_else(|| "?".to_string(), |c| vm.class_name(c));
        let text = format!("<member '{}' of '{owner}' objects>", vm.symbols.text(name));
        Ok(vm.new_str(text))
    }),
];

/// The descriptor of one slot of a class.
pub(crate) fn new(vm: &mut Vm<'_>, class: Ref<Class>, name: Symbol, doc: Value) -> Value {
    let text = vm.symbol_text(name);
    let owner = vm.symbols.intern(OWNER);
    let attrs = vec![(sym::NAME, text), (owner, Value::Class(class)), (sym::DOC, doc)];
    let class = Builtin::MemberDescriptor.class();
    Value::Instance(vm.heap.alloc(Instance { class, attrs: Attrs::Inline(attrs), base: Base::None }))
}

const OWNER: &str = "__objclass__";

/// The class that a descriptor is of, and the name of its slot.
fn parts(vm: &mut Vm<'_>, member: Value) -> (Option<Ref<Class>>, Symbol) {
    let Value::Instance(m) = member else { return (None, sym::NAME) };
    let owner = vm.symbols.intern(OWNER);
    let owner = match vm.own_attr(m, owner) {
        Some(Value::Class(c)) => Some(c),
        _ => None,
    };
    let name = vm.own_attr(m, sym::NAME).unwrap_or(Value::None);
    (owner, vm.intern_value(name))
}

/// The instance that a descriptor is asked about, and the name of its slot.
fn place(vm: &mut Vm<'_>, args: Args<'_>) -> R<(Ref<Instance>, Symbol)> {
    let (owner, name) = parts(vm, args.at(0));
    if let (Value::Instance(i), Some(owner)) = (args.at(1), owner)
        && vm.is_subclass(vm.heap[i].class, owner)
    {
        return Ok((i, name));
    }
    let owner = owner.map_or_else(|| "?".to_string(), |c| vm.class_name(c));
    let found = vm.type_name(args.at(1));
    let message = format!("descriptor '{}' for '{owner}' objects doesn't apply to a '{found}' object", vm.symbols.text(name));
    Err(vm.type_error(message))
}
