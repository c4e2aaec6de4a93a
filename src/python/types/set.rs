//! `set` and `frozenset`: constructors, operators and methods. Items keep the order in which they were added.

use super::{containers, dict};
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::native::{ANY, Args, Native};
use crate::python::table::Entry;
use crate::python::value::{BinaryOp, CompareOp, Value};
use crate::python::vm::Vm;

/// The set that a method was called on.
fn this(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Ref<Set>> {
    match vm.plain(args.at(0)) {
        Value::Set(set) | Value::FrozenSet(set) => Ok(set),
        other => {
            let name = vm.type_name(other);
            Err(vm.type_error(format!("descriptor requires a 'set' object but received a '{name}'")))
        }
    }
}

/// `set(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    made(vm, "set", args).map(Value::Set)
}

/// `frozenset(...)`
pub fn construct_frozen(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if let (&[same @ Value::FrozenSet(_)], []) = (args.pos, args.kw) {
        return Ok(same);
    }
    made(vm, "frozenset", args).map(Value::FrozenSet)
}

fn made(vm: &mut Vm<'_>, name: &str, args: Args<'_>) -> R<Ref<Set>> {
    if !args.kw.is_empty() {
        return Err(vm.type_error(format!("{name}() takes no keyword arguments")));
    }
    let set = vm.heap.alloc(Set::default());
    match *args.pos {
        [] => {}
        [iterable] => add_all(vm, set, iterable)?,
        _ => return Err(vm.type_error(format!("{name} expected at most 1 argument, got {}", args.pos.len()))),
    }
    Ok(set)
}

fn entries(vm: &mut Vm<'_>, set: Ref<Set>) -> R<Vec<Entry>> {
    let table = &vm.heap[set].0;
    let (len, bytes) = (table.len(), table.bytes());
    vm.reserve(bytes)?;
    vm.charge(len as u64)?;
    Ok(vm.heap[set].0.iter().collect())
}

/// Adds all items of an iterable.
pub fn add_all(vm: &mut Vm<'_>, set: Ref<Set>, iterable: Value) -> R<()> {
    match vm.plain(iterable) {
        Value::Set(other) | Value::FrozenSet(other) => {
            for e in entries(vm, other)? {
                vm.insert(set, e.hash as i64, e.key, Value::None)?;
            }
            Ok(())
        }
        Value::Dict(other) => {
            let entries: Vec<_> = vm.heap[other].0.iter().collect();
            for e in entries {
                vm.charge(1)?;
                vm.insert(set, e.hash as i64, e.key, Value::None)?;
            }
            Ok(())
        }
        _ => vm.for_each(iterable, |vm, item| vm.set_add(set, item).map(|()| true)),
    }
}

/// An iterable as a set: itself, or a new one.
fn as_set(vm: &mut Vm<'_>, iterable: Value) -> R<Ref<Set>> {
    match vm.plain(iterable) {
        Value::Set(set) | Value::FrozenSet(set) => Ok(set),
        Value::View(view) => dict::as_set(vm, view),
        _ => {
            let set = vm.heap.alloc(Set::default());
            add_all(vm, set, iterable)?;
            Ok(set)
        }
    }
}

fn copied(vm: &mut Vm<'_>, set: Ref<Set>) -> R<Ref<Set>> {
    vm.reserve(vm.heap[set].0.bytes())?;
    vm.charge(vm.heap[set].0.len() as u64 / 8)?;
    let copy = vm.heap[set].clone();
    Ok(vm.heap.alloc(copy))
}

/// The items of `a` that are (or are not) in `b`.
fn selected(vm: &mut Vm<'_>, a: Ref<Set>, b: Ref<Set>, inside: bool) -> R<Ref<Set>> {
    let result = vm.heap.alloc(Set::default());
    for e in entries(vm, a)? {
        if vm.position(b, e.hash as i64, e.key)?.is_some() == inside {
            vm.insert_new(result, e.hash, e.key, Value::None)?;
        }
    }
    Ok(result)
}

/// A new set: `a op b`.
fn combined(vm: &mut Vm<'_>, op: BinaryOp, a: Ref<Set>, b: Ref<Set>) -> R<Ref<Set>> {
    match op {
        BinaryOp::And => selected(vm, a, b, true),
        BinaryOp::Sub => selected(vm, a, b, false),
        BinaryOp::Or => {
            let result = copied(vm, a)?;
            add_all(vm, result, Value::Set(b))?;
            Ok(result)
        }
        _ => {
            let result = selected(vm, a, b, false)?;
            let other = selected(vm, b, a, false)?;
            add_all(vm, result, Value::Set(other))?;
            Ok(result)
        }
    }
}

/// `a op b`; `None` where a side is no set (or, beside a view of a dict, no iterable).
pub fn binary(vm: &mut Vm<'_>, op: BinaryOp, a: Value, b: Value) -> R<Option<Value>> {
    let set_like = |vm: &Vm<'_>, v: Value| match v {
        Value::Set(_) | Value::FrozenSet(_) => true,
        Value::View(view) => vm.heap[view].kind != ViewKind::Values,
        _ => false,
    };
    let view = |vm: &Vm<'_>, v: Value| matches!(v, Value::View(_)) && set_like(vm, v);
    if view(vm, a) || view(vm, b) {
        let (x, y) = (as_set(vm, a)?, as_set(vm, b)?);
        return combined(vm, op, x, y).map(|r| Some(Value::Set(r)));
    }
    let (Value::Set(x) | Value::FrozenSet(x), Value::Set(y) | Value::FrozenSet(y)) = (a, b) else { return Ok(None) };
    let result = combined(vm, op, x, y)?;
    Ok(Some(if matches!(a, Value::Set(_)) { Value::Set(result) } else { Value::FrozenSet(result) }))
}

/// `set op= other`
pub fn inplace(vm: &mut Vm<'_>, op: BinaryOp, set: Ref<Set>, other: Ref<Set>) -> R<()> {
    if op == BinaryOp::Or {
        return add_all(vm, set, Value::Set(other));
    }
    let result = combined(vm, op, set, other)?;
    replace(vm, set, result);
    Ok(())
}

fn replace(vm: &mut Vm<'_>, set: Ref<Set>, with: Ref<Set>) {
    let items = std::mem::take(&mut vm.heap[with]);
    vm.heap[set] = items;
}

fn is_subset(vm: &mut Vm<'_>, a: Ref<Set>, b: Ref<Set>) -> R<bool> {
    if vm.heap[a].0.len() > vm.heap[b].0.len() {
        return Ok(false);
    }
    for e in entries(vm, a)? {
        if vm.position(b, e.hash as i64, e.key)?.is_none() {
            return Ok(false);
        }
    }
    Ok(true)
}

/// `a op b` of sets and set-like views: equality and inclusion. `None` where a side is a view of values.
pub fn compare(vm: &mut Vm<'_>, op: CompareOp, a: Value, b: Value) -> R<Option<bool>> {
    for side in [a, b] {
        if let Value::View(v) = side
            && vm.heap[v].kind == ViewKind::Values
        {
            return Ok(None);
        }
    }
    let (x, y) = (vm.len(a)?, vm.len(b)?);
    let possible = match op {
        CompareOp::Eq | CompareOp::Ne => x == y,
        CompareOp::Lt => x < y,
        CompareOp::Le => x <= y,
        CompareOp::Gt => x > y,
        CompareOp::Ge => x >= y,
    };
    let holds = possible && {
        // Items of a view may be unhashable: they are looked up where that can be done.
        let (small, large) = if matches!(op, CompareOp::Gt | CompareOp::Ge) { (b, a) } else { (a, b) };
        match (small, large) {
            (Value::Set(s) | Value::FrozenSet(s), Value::Set(l) | Value::FrozenSet(l)) => is_subset(vm, s, l)?,
            _ => {
                let mut all = true;
                vm.for_each(small, |vm, item| {
                    all = vm.contains(large, item)?;
                    Ok(all)
                })?;
                all
            }
        }
    };
    Ok(Some(holds != (op == CompareOp::Ne)))
}

/// A value of the receiver's own type (set or frozenset).
fn like(receiver: Value, set: Ref<Set>) -> Value {
    if matches!(receiver, Value::FrozenSet(_)) { Value::FrozenSet(set) } else { Value::Set(set) }
}

/// `set.union(*others)` and its like.
fn method(vm: &mut Vm<'_>, args: Args<'_>, op: BinaryOp) -> R<Value> {
    let receiver = vm.plain(args.at(0));
    let mut result = this(vm, &args)?;
    if args.pos.len() == 1 {
        return match receiver {
            Value::FrozenSet(_) => Ok(receiver),
            _ => copied(vm, result).map(Value::Set),
        };
    }
    for &other in &args.pos[1..] {
        let other = as_set(vm, other)?;
        result = combined(vm, op, result, other)?;
    }
    Ok(like(receiver, result))
}

/// `set.update(*others)` and its like.
fn method_update(vm: &mut Vm<'_>, args: Args<'_>, op: BinaryOp) -> R<Value> {
    let set = this(vm, &args)?;
    for &other in &args.pos[1..] {
        if op == BinaryOp::Or {
            add_all(vm, set, other)?;
        } else {
            let other = as_set(vm, other)?;
            inplace(vm, op, set, other)?;
        }
    }
    Ok(Value::None)
}

fn remove(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let set = this(vm, &args)?;
    let key = vm.set_key(args.at(1));
    if vm.set_remove(set, key)? { Ok(Value::None) } else { Err(vm.key_error(args.at(1))) }
}

fn discard(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let set = this(vm, &args)?;
    let key = vm.set_key(args.at(1));
    vm.set_remove(set, key)?;
    Ok(Value::None)
}

fn pop(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let set = this(vm, &args)?;
    match vm.heap[set].0.next_from(0) {
        Some((at, _)) => Ok(vm.heap[set].0.remove(at).key),
        None => {
            let text = vm.new_str("pop from an empty set");
            Err(vm.key_error(text))
        }
    }
}

fn is_disjoint(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (a, b) = (this(vm, &args)?, as_set(vm, args.at(1))?);
    let common = selected(vm, a, b, true)?;
    Ok(Value::Bool(vm.heap[common].0.is_empty()))
}

fn inclusion(vm: &mut Vm<'_>, args: Args<'_>, op: CompareOp) -> R<Value> {
    let (a, b) = (this(vm, &args)?, as_set(vm, args.at(1))?);
    let verdict = if op == CompareOp::Le { is_subset(vm, a, b)? } else { is_subset(vm, b, a)? };
    Ok(Value::Bool(verdict))
}

/// `repr` with the name of the class, which may be a subclass.
fn shown(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (object, plain) = (args.at(0), vm.plain(args.at(0)));
    let text = containers::repr(vm, plain)?.unwrap_or_default();
    if !matches!(object, Value::Instance(_)) {
        return Ok(vm.new_str(text));
    }
    let name = vm.type_name(object);
    let text = match (plain, text.find('(')) {
        (_, Some(bracket)) if !text.starts_with('{') => format!("{name}{}", &text[bracket..]),
        _ => format!("{name}({text})"),
    };
    Ok(vm.new_str(text))
}

/// What both have.
const fn shared() -> [Native; 27] {
    [
        Native::method("union", 0, ANY, |vm, args| method(vm, args, BinaryOp::Or)),
        Native::method("intersection", 0, ANY, |vm, args| method(vm, args, BinaryOp::And)),
        Native::method("difference", 0, ANY, |vm, args| method(vm, args, BinaryOp::Sub)),
        Native::method("symmetric_difference", 1, 1, |vm, args| method(vm, args, BinaryOp::Xor)),
        Native::method("copy", 0, 0, |vm, args| method(vm, args, BinaryOp::Or)),
        Native::method("isdisjoint", 1, 1, is_disjoint),
        Native::method("issubset", 1, 1, |vm, args| inclusion(vm, args, CompareOp::Le)),
        Native::method("issuperset", 1, 1, |vm, args| inclusion(vm, args, CompareOp::Ge)),
        Native::method("__len__", 0, 0, containers::method_len),
        Native::method("__contains__", 1, 1, containers::method_contains),
        Native::method("__iter__", 0, 0, containers::method_iter),
        Native::raw("__repr__", 0, 0, shown),
        Native::method("__and__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::And, args)),
        Native::method("__rand__", 1, 1, |vm, args| containers::method_reflected(vm, BinaryOp::And, args)),
        Native::method("__or__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Or, args)),
        Native::method("__ror__", 1, 1, |vm, args| containers::method_reflected(vm, BinaryOp::Or, args)),
        Native::method("__xor__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Xor, args)),
        Native::method("__rxor__", 1, 1, |vm, args| containers::method_reflected(vm, BinaryOp::Xor, args)),
        Native::method("__sub__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Sub, args)),
        Native::method("__rsub__", 1, 1, |vm, args| containers::method_reflected(vm, BinaryOp::Sub, args)),
        Native::method("__eq__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Eq, args)),
        Native::method("__ne__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ne, args)),
        Native::method("__lt__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Lt, args)),
        Native::method("__le__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Le, args)),
        Native::method("__gt__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Gt, args)),
        Native::method("__ge__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ge, args)),
        Native::class_method("__class_getitem__", 1, 1, containers::method_class_getitem),
    ]
}

/// What a set has beyond.
const fn changing() -> [Native; 13] {
    [
        Native::method("add", 1, 1, |vm, args| {
            let set = this(vm, &args)?;
            vm.set_add(set, args.at(1))?;
            Ok(Value::None)
        }),
        Native::method("remove", 1, 1, remove),
        Native::method("discard", 1, 1, discard),
        Native::method("pop", 0, 0, pop),
        Native::method("clear", 0, 0, |vm, args| {
            let set = this(vm, &args)?;
            vm.heap[set].0.clear();
            Ok(Value::None)
        }),
        Native::method("update", 0, ANY, |vm, args| method_update(vm, args, BinaryOp::Or)),
        Native::method("intersection_update", 0, ANY, |vm, args| method_update(vm, args, BinaryOp::And)),
        Native::method("difference_update", 0, ANY, |vm, args| method_update(vm, args, BinaryOp::Sub)),
        Native::method("symmetric_difference_update", 1, 1, |vm, args| method_update(vm, args, BinaryOp::Xor)),
        Native::method("__iand__", 1, 1, |vm, args| containers::method_inplace(vm, BinaryOp::And, args)),
        Native::method("__ior__", 1, 1, |vm, args| containers::method_inplace(vm, BinaryOp::Or, args)),
        Native::method("__ixor__", 1, 1, |vm, args| containers::method_inplace(vm, BinaryOp::Xor, args)),
        Native::method("__isub__", 1, 1, |vm, args| containers::method_inplace(vm, BinaryOp::Sub, args)),
    ]
}

const SHARED: [Native; 27] = shared();
const CHANGING: [Native; 13] = changing();

const fn all() -> [Native; 41] {
    let mut table = [SHARED[0]; 41];
    let mut i = 0;
    while i < 27 {
        table[i] = SHARED[i];
        i += 1;
    }
    while i < 40 {
        table[i] = CHANGING[i - 27];
        i += 1;
    }
    table[40] = Native::method("__init__", 0, ANY, |vm, args| {
        let set = this(vm, &args)?;
        let made = made(vm, "set", Args { pos: &args.pos[1..], kw: args.kw })?;
        replace(vm, set, made);
        Ok(Value::None)
    })
    .keywords();
    table
}

const fn frozen() -> [Native; 28] {
    let mut table = [Native::method("__hash__", 0, 0, containers::method_hash); 28];
    let mut i = 0;
    while i < 27 {
        table[i] = SHARED[i];
        i += 1;
    }
    table
}

/// Methods of `set`.
pub const METHODS: &[Native] = &all();
/// Methods of `frozenset`.
pub const FROZEN: &[Native] = &frozen();
