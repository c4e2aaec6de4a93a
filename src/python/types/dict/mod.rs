//! `dict`: its constructor, operators and methods; its views in `views.rs`.

mod views;

pub use views::{ITEMS, KEYS, PROXY, VALUES, as_set, construct_proxy, of_proxy};

use super::containers;
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::iter::IterState;
use crate::python::native::{ANY, Args, Native};
use crate::python::symbols::sym;
use crate::python::value::{BinaryOp, CompareOp, Value};
use crate::python::vm::Vm;

/// The dict that a method was called on.
#[inline]
fn this(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Ref<Dict>> {
    if let Some(&Value::Dict(dict)) = args.pos.first() {
        return Ok(dict);
    }
    match vm.plain(args.at(0)) {
        Value::Dict(dict) => Ok(dict),
        other => {
            let name = vm.type_name(other);
            Err(vm.type_error(format!("descriptor requires a 'dict' object but received a '{name}'")))
        }
    }
}

/// `dict(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let dict = vm.heap.dict();
    update(vm, dict, "dict", args)?;
    Ok(Value::Dict(dict))
}

/// `dict.update(self, source, **more)`, and what `dict(...)` does; the receiver is not among the arguments.
pub fn update(vm: &mut Vm<'_>, dict: Ref<Dict>, function: &str, args: Args<'_>) -> R<()> {
    match *args.pos {
        [] => {}
        [source] => update_from(vm, dict, source)?,
        _ => return Err(vm.type_error(format!("{function} expected at most 1 argument, got {}", args.pos.len()))),
    }
    for &(name, value) in args.kw {
        let name = vm.heap.str(vm.symbols.text(name));
        vm.dict_set(dict, name, value)?;
    }
    Ok(())
}

/// Copies the entries of a mapping, or of an iterable of pairs, into a dict.
pub fn update_from(vm: &mut Vm<'_>, dict: Ref<Dict>, source: Value) -> R<()> {
    if let Some(from) = vm.plain_dict(source) {
        return merge(vm, dict, from);
    }
    if let Value::Proxy(p) = source {
        let Value::Dict(from) = of_proxy(vm, p) else { return Ok(()) };
        return merge(vm, dict, from);
    }
    if let Some(keys) = vm.get_attr_opt(source, sym::N_KEYS)? {
        let keys = vm.call(keys, &[])?;
        return vm.for_each(keys, |vm, key| {
            let value = vm.get_item(source, key)?;
            vm.dict_set(dict, key, value)?;
            Ok(true)
        });
    }
    let mut i = 0;
    vm.for_each(source, |vm, element| {
        let Some(pair) = containers::try_collect(vm, element)? else {
            return Err(vm.type_error(format!("cannot convert dictionary update sequence element #{i} to a sequence")));
        };
        let &[key, value] = pair.as_slice() else {
            return Err(vm.value_error(format!("dictionary update sequence element #{i} has length {}; 2 is required", pair.len())));
        };
        vm.dict_set(dict, key, value)?;
        i += 1;
        Ok(true)
    })
}

fn merge(vm: &mut Vm<'_>, dict: Ref<Dict>, from: Ref<Dict>) -> R<()> {
    if dict == from {
        return Ok(());
    }
    let len = vm.heap[from].0.len();
    let fresh = vm.heap[dict].0.is_empty();
    let mut position = 0;
    while let Some((at, entry)) = vm.heap[from].0.next_from(position) {
        vm.charge(1)?;
        position = at + 1;
        if fresh {
            vm.insert_new(dict, entry.hash, entry.key, entry.value)?;
        } else {
            vm.insert(dict, entry.hash as i64, entry.key, entry.value)?;
        }
        if vm.heap[from].0.len() != len {
            return Err(vm.error(Builtin::RuntimeError, "dict mutated during update".into()));
        }
    }
    Ok(())
}

/// A copy of a dict.
pub fn copied(vm: &mut Vm<'_>, dict: Ref<Dict>) -> R<Ref<Dict>> {
    let len = vm.heap[dict].0.len();
    vm.reserve(vm.heap[dict].0.bytes())?;
    vm.charge(len as u64)?;
    let copy = vm.heap[dict].clone();
    Ok(vm.heap.alloc(copy))
}

/// `a | b`
pub fn union(vm: &mut Vm<'_>, a: Value, b: Value) -> R<Option<Value>> {
    let as_dict = |vm: &mut Vm<'_>, v| match v {
        Value::Proxy(p) => of_proxy(vm, p),
        other => other,
    };
    let (Value::Dict(x), Value::Dict(y)) = (as_dict(vm, a), as_dict(vm, b)) else { return Ok(None) };
    let result = copied(vm, x)?;
    merge(vm, result, y)?;
    Ok(Some(Value::Dict(result)))
}

/// `a == b`
pub fn equal(vm: &mut Vm<'_>, a: Ref<Dict>, b: Ref<Dict>) -> R<bool> {
    if vm.heap[a].0.len() != vm.heap[b].0.len() {
        return Ok(false);
    }
    let mut position = 0;
    while let Some((at, entry)) = vm.heap[a].0.next_from(position) {
        vm.charge(1)?;
        position = at + 1;
        let Some(found) = vm.position(b, entry.hash as i64, entry.key)?.and_then(|p| vm.heap[b].0.at(p)) else { return Ok(false) };
        if !vm.eq(entry.value, found.value)? {
            return Ok(false);
        }
    }
    Ok(true)
}

fn from_keys(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (class, value) = (args.at(0), args.at(2));
    let dict = if class.is(Builtin::Dict.value()) { Value::Dict(vm.heap.dict()) } else { vm.call(class, &[])? };
    vm.for_each(args.at(1), |vm, key| vm.set_item(dict, key, value).map(|()| true))?;
    Ok(dict)
}

fn get(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let dict = this(vm, &args)?;
    if let Value::Str(key) = args.at(1)
        && let Some(value) = vm.heap.value_of(dict, key)
    {
        return Ok(*value);
    }
    Ok(vm.dict_get(dict, args.at(1))?.unwrap_or(args.at(2)))
}

fn set_default(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (dict, key) = (this(vm, &args)?, args.at(1));
    let hash = vm.hash(key)?;
    if let Some(entry) = vm.position(dict, hash, key)?.and_then(|p| vm.heap[dict].0.at(p)) {
        return Ok(entry.value);
    }
    vm.insert_new(dict, hash as u64, key, args.at(2))?;
    Ok(args.at(2))
}

fn pop(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let dict = this(vm, &args)?;
    // An empty dict does not even ask whether the key can be hashed.
    let found = if vm.heap[dict].0.is_empty() { None } else { vm.dict_remove(dict, args.at(1))? };
    match (found, args.get(2)) {
        (Some(value), _) | (None, Some(value)) => Ok(value),
        (None, None) => Err(vm.key_error(args.at(1))),
    }
}

/// KeyError with a text for its argument.
fn key_error_text(vm: &mut Vm<'_>, text: &str) -> Raise {
    let text = vm.new_str(text);
    vm.key_error(text)
}

fn pop_item(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let dict = this(vm, &args)?;
    let table = &mut vm.heap[dict].0;
    match table.last_before(table.positions()) {
        Some((at, entry)) => {
            table.remove(at);
            Ok(vm.new_tuple([entry.key, entry.value].as_slice()))
        }
        None => Err(key_error_text(vm, "popitem(): dictionary is empty")),
    }
}

fn view(vm: &mut Vm<'_>, args: Args<'_>, kind: ViewKind) -> R<Value> {
    let dict = this(vm, &args)?;
    Ok(Value::View(vm.heap.alloc(View { kind, dict })))
}

fn reversed(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let dict = this(vm, &args)?;
    Ok(reversed_iter(vm, dict, ViewKind::Keys))
}

/// `reversed(dict.items())` and its like.
pub fn reversed_iter(vm: &mut Vm<'_>, dict: Ref<Dict>, kind: ViewKind) -> Value {
    let table = &vm.heap[dict].0;
    let (position, len) = (table.positions(), table.len());
    vm.new_iter(IterState::DictReversed { dict, kind, position, len })
}

/// Methods of `dict`.
pub const METHODS: &[Native] = &[
    Native::static_method("__new__", 1, ANY, |vm, a| super::object::new_builtin(vm, a, Builtin::Dict)).keywords(),
    Native::method("get", 1, 2, get),
    Native::method("setdefault", 1, 2, set_default),
    Native::method("pop", 1, 2, pop),
    Native::method("popitem", 0, 0, pop_item),
    Native::method("keys", 0, 0, |vm, args| view(vm, args, ViewKind::Keys)),
    Native::method("values", 0, 0, |vm, args| view(vm, args, ViewKind::Values)),
    Native::method("items", 0, 0, |vm, args| view(vm, args, ViewKind::Items)),
    Native::method("update", 0, ANY, |vm, args| {
        let dict = this(vm, &args)?;
        update(vm, dict, "update", Args { pos: &args.pos[1..], kw: args.kw })?;
        Ok(Value::None)
    })
    .keywords(),
    Native::method("__init__", 0, ANY, |vm, args| {
        let dict = this(vm, &args)?;
        update(vm, dict, "dict", Args { pos: &args.pos[1..], kw: args.kw })?;
        Ok(Value::None)
    })
    .keywords(),
    Native::method("copy", 0, 0, |vm, args| {
        let dict = this(vm, &args)?;
        copied(vm, dict).map(Value::Dict)
    }),
    Native::method("clear", 0, 0, |vm, args| {
        let dict = this(vm, &args)?;
        vm.heap[dict].0.clear();
        Ok(Value::None)
    }),
    Native::class_method("fromkeys", 1, 2, from_keys),
    Native::method("__len__", 0, 0, containers::method_len),
    Native::method("__contains__", 1, 1, containers::method_contains),
    Native::method("__getitem__", 1, 1, containers::method_get_item),
    Native::method("__setitem__", 2, 2, containers::method_set_item),
    Native::method("__delitem__", 1, 1, containers::method_del_item),
    Native::method("__iter__", 0, 0, containers::method_iter),
    Native::method("__reversed__", 0, 0, reversed),
    Native::method("__repr__", 0, 0, containers::method_repr),
    Native::method("__or__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Or, args)),
    Native::method("__ror__", 1, 1, |vm, args| containers::method_reflected(vm, BinaryOp::Or, args)),
    Native::method("__ior__", 1, 1, |vm, args| containers::method_inplace(vm, BinaryOp::Or, args)),
    Native::method("__eq__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Eq, args)),
    Native::method("__ne__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ne, args)),
    Native::class_method("__class_getitem__", 1, 1, containers::method_class_getitem),
];
