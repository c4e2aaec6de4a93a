//! `dict.keys()`, `.values()`, `.items()`, and `mappingproxy`.

use super::reversed_iter;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::native::{Args, Native};
use crate::python::types::{containers, set};
use crate::python::value::{BinaryOp, CompareOp, Value};
use crate::python::vm::Vm;

fn this(vm: &mut Vm<'_>, args: &Args<'_>) -> R<View> {
    match args.at(0) {
        Value::View(view) => Ok(vm.heap[view]),
        other => {
            let name = vm.type_name(other);
            Err(vm.type_error(format!("descriptor requires a 'dict_keys' object but received a '{name}'")))
        }
    }
}

fn reversed(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let View { dict, kind } = this(vm, &args)?;
    Ok(reversed_iter(vm, dict, kind))
}

fn mapping(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let View { dict, .. } = this(vm, &args)?;
    Ok(Value::Proxy(vm.heap.alloc(Wrapped(Value::Dict(dict)))))
}

fn is_disjoint(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let mut disjoint = true;
    vm.for_each(args.at(1), |vm, item| {
        disjoint = !vm.contains(args.at(0), item)?;
        Ok(disjoint)
    })?;
    Ok(Value::Bool(disjoint))
}

/// `a op view` where `a` has no such operator: a list, say.
fn reflected(vm: &mut Vm<'_>, op: BinaryOp, args: Args<'_>) -> R<Value> {
    let made = vm.heap.alloc(Set::default());
    set::add_all(vm, made, args.at(1))?;
    vm.binary(op, Value::Set(made), args.at(0))
}

const fn set_like() -> [Native; 21] {
    [
        Native::method("__len__", 0, 0, containers::method_len),
        Native::method("__contains__", 1, 1, containers::method_contains),
        Native::method("__iter__", 0, 0, containers::method_iter),
        Native::method("__reversed__", 0, 0, reversed),
        Native::method("__repr__", 0, 0, containers::method_repr),
        Native::method("isdisjoint", 1, 1, is_disjoint),
        Native::getter("mapping", mapping),
        Native::method("__and__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::And, args)),
        Native::method("__or__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Or, args)),
        Native::method("__xor__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Xor, args)),
        Native::method("__sub__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Sub, args)),
        Native::method("__rand__", 1, 1, |vm, args| reflected(vm, BinaryOp::And, args)),
        Native::method("__ror__", 1, 1, |vm, args| reflected(vm, BinaryOp::Or, args)),
        Native::method("__rxor__", 1, 1, |vm, args| reflected(vm, BinaryOp::Xor, args)),
        Native::method("__rsub__", 1, 1, |vm, args| reflected(vm, BinaryOp::Sub, args)),
        Native::method("__eq__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Eq, args)),
        Native::method("__ne__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ne, args)),
        Native::method("__lt__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Lt, args)),
        Native::method("__le__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Le, args)),
        Native::method("__gt__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Gt, args)),
        Native::method("__ge__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ge, args)),
    ]
}

/// Methods of `dict_keys`.
pub const KEYS: &[Native] = &set_like();
/// Methods of `dict_items`.
pub const ITEMS: &[Native] = &set_like();
/// Methods of `dict_values`.
pub const VALUES: &[Native] = &[
    Native::method("__len__", 0, 0, containers::method_len),
    Native::method("__contains__", 1, 1, containers::method_contains),
    Native::method("__iter__", 0, 0, containers::method_iter),
    Native::method("__reversed__", 0, 0, reversed),
    Native::method("__repr__", 0, 0, containers::method_repr),
    Native::getter("mapping", mapping),
];

/// What a proxy shows, as a dict: the dict itself, or a copy of a class's namespace.
pub fn of_proxy(vm: &mut Vm<'_>, proxy: Ref<Wrapped>) -> Value {
    let Value::Class(class) = vm.heap[proxy].0 else { return vm.heap[proxy].0 };
    let attrs: Vec<_> = vm.heap[class].attrs.iter().map(|(&s, &v)| (s, v)).collect();
    let mut table = crate::python::table::Table::default();
    for (symbol, value) in attrs {
        let name = vm.heap.str(vm.symbols.text(symbol));
        let hash = vm.hash(name).unwrap_or(0);
        table.push(hash as u64, name, value);
    }
    Value::Dict(vm.heap.alloc(Dict(table)))
}

/// Calls the dict's own method for a proxy.
fn forwarded(vm: &mut Vm<'_>, args: Args<'_>, name: &str) -> R<Value> {
    let inner = match args.at(0) {
        Value::Proxy(p) => of_proxy(vm, p),
        other => other,
    };
    let name = vm.symbols.intern(name);
    vm.call_method(inner, name, args.pos.get(1..).unwrap_or(&[]))
}

/// Methods of `mappingproxy`.
pub const PROXY: &[Native] = &[
    Native::method("__len__", 0, 0, containers::method_len),
    Native::method("__contains__", 1, 1, containers::method_contains),
    Native::method("__getitem__", 1, 1, containers::method_get_item),
    Native::method("__iter__", 0, 0, containers::method_iter),
    Native::method("__repr__", 0, 0, containers::method_repr),
    Native::method("__or__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Or, args)),
    Native::method("__eq__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Eq, args)),
    Native::method("__ne__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ne, args)),
    Native::method("__reversed__", 0, 0, |vm, args| forwarded(vm, args, "__reversed__")),
    Native::method("get", 1, 2, |vm, args| forwarded(vm, args, "get")),
    Native::method("keys", 0, 0, |vm, args| forwarded(vm, args, "keys")),
    Native::method("values", 0, 0, |vm, args| forwarded(vm, args, "values")),
    Native::method("items", 0, 0, |vm, args| forwarded(vm, args, "items")),
    Native::method("copy", 0, 0, |vm, args| forwarded(vm, args, "copy")),
];

/// The items of a view as a set, for its operators.
pub fn as_set(vm: &mut Vm<'_>, view: Ref<View>) -> R<Ref<Set>> {
    let View { dict, kind } = vm.heap[view];
    let result = vm.heap.alloc(Set::default());
    if kind == ViewKind::Keys {
        let entries: Vec<_> = vm.heap[dict].0.iter().collect();
        for e in entries {
            vm.insert_new(result, e.hash, e.key, Value::None)?;
        }
    } else {
        set::add_all(vm, result, Value::View(view))?;
    }
    Ok(result)
}

/// `mappingproxy(mapping)`
pub fn construct_proxy(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    crate::python::types::iterator::positional(vm, "mappingproxy", &args, 1, 1)?;
    match vm.plain(args.at(0)) {
        Value::Proxy(inner) => {
            let same = vm.heap[inner];
            Ok(Value::Proxy(vm.heap.alloc(same)))
        }
        mapping @ Value::Dict(_) => Ok(Value::Proxy(vm.heap.alloc(Wrapped(mapping)))),
        other => {
            let name = vm.type_name(other);
            Err(vm.type_error(format!("mappingproxy() argument must be a mapping, not {name}")))
        }
    }
}
