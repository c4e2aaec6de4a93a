//! `getattr`, `dir`, `vars`, `issubclass`, `callable` and their like.

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::native::Args;
use crate::python::symbols::sym;
use crate::python::value::{Symbol, Value};
use crate::python::vm::Vm;

fn attribute_name(vm: &mut Vm<'_>, value: Value) -> R<Symbol> {
    match vm.plain(value) {
        Value::Str(s) => Ok(vm.symbols.intern(&vm.heap[s].text)),
        other => {
            let name = vm.type_name(other);
            Err(vm.type_error(format!("attribute name must be string, not '{name}'")))
        }
    }
}

/// `getattr(o, name[, default])`
pub fn get_attr(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let name = attribute_name(vm, args.at(1))?;
    match args.get(2) {
        None => vm.get_attr(args.at(0), name),
        Some(default) => Ok(vm.get_attr_opt(args.at(0), name)?.unwrap_or(default)),
    }
}

/// `hasattr(o, name)`
pub fn has_attr(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let name = attribute_name(vm, args.at(1))?;
    Ok(Value::Bool(vm.get_attr_opt(args.at(0), name)?.is_some()))
}

/// `setattr(o, name, value)`
pub fn set_attr(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let name = attribute_name(vm, args.at(1))?;
    vm.set_attr(args.at(0), name, args.at(2))?;
    Ok(Value::None)
}

/// `delattr(o, name)`
pub fn del_attr(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let name = attribute_name(vm, args.at(1))?;
    vm.del_attr(args.at(0), name)?;
    Ok(Value::None)
}

/// Whether a value can be called.
pub fn is_callable(vm: &mut Vm<'_>, value: Value) -> bool {
    match value {
        Value::Function(_) | Value::Native(_) | Value::Method(_) | Value::Class(_) | Value::StaticMethod(_) => true,
        Value::Alias(a) => !vm.heap[a].origin.is_none(),
        Value::Instance(_) => vm.special(value, sym::CALL).is_some(),
        Value::Host(_) => {
            let name = vm.type_name(value);
            name == "type" || name.contains("function") || name.contains("method")
        }
        _ => false,
    }
}

/// `callable(o)`
pub fn callable(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::Bool(is_callable(vm, args.at(0))))
}

/// `dir([o])`
pub fn dir(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let names = match args.get(0) {
        None => Value::Dict(vm.locals_dict()),
        Some(object @ Value::Instance(_)) => match vm.special(object, sym::DIR) {
            Some(method) => vm.call(method, &[])?,
            None => return names_of(vm, object),
        },
        Some(object) => return names_of(vm, object),
    };
    let names = vm.collect(names)?;
    let names = crate::python::types::list::sort_values(vm, names)?;
    Ok(vm.new_list(names))
}

fn names_of(vm: &mut Vm<'_>, object: Value) -> R<Value> {
    let names = vm.dir_names(object)?;
    let names = names.into_iter().map(|n| vm.new_str(n)).collect();
    Ok(vm.new_list(names))
}

/// `vars([o])`
pub fn vars(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some(object) = args.get(0) else { return Ok(Value::Dict(vm.locals_dict())) };
    match vm.get_attr_opt(object, sym::DICT)? {
        Some(dict) => Ok(dict),
        None => Err(vm.type_error("vars() argument must have __dict__ attribute")),
    }
}

/// `issubclass(class, of)`: tuples, unions and `__subclasscheck__` included.
pub fn is_subclass(vm: &mut Vm<'_>, class: Value, of: Value) -> R<bool> {
    match of {
        Value::Tuple(t) => {
            for item in vm.heap[t].0.clone() {
                if vm.nested("", |vm| is_subclass(vm, class, item))? {
                    return Ok(true);
                }
            }
            Ok(false)
        }
        Value::Alias(a) if vm.heap[a].origin.is_none() => {
            for item in vm.heap[a].args.clone() {
                if is_subclass(vm, class, item)? {
                    return Ok(true);
                }
            }
            Ok(false)
        }
        Value::Alias(_) => Err(vm.type_error("issubclass() argument 2 cannot be a parameterized generic")),
        Value::Class(parent) if vm.heap[parent].meta == Builtin::Type.class() => match class {
            Value::Class(child) => Ok(vm.heap[child].mro.contains(&parent)),
            _ => Err(vm.type_error("issubclass() arg 1 must be a class")),
        },
        Value::Class(_) | Value::Instance(_) => match vm.special(of, sym::SUBCLASSCHECK) {
            Some(method) => {
                let verdict = vm.call(method, &[class])?;
                vm.truth(verdict)
            }
            None => Err(vm.type_error("issubclass() arg 2 must be a class, a tuple of classes, or a union")),
        },
        _ if !matches!(class, Value::Class(_)) => Err(vm.type_error("issubclass() arg 1 must be a class")),
        _ => Err(vm.type_error("issubclass() arg 2 must be a class, a tuple of classes, or a union")),
    }
}
