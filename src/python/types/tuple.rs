//! `tuple`: its constructor, operators and methods.

use super::containers;
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::iterate::VALUE;
use crate::python::native::{ANY, Args, Native};
use crate::python::value::{BinaryOp, CompareOp, Value};
use crate::python::vm::Vm;

fn items(vm: &mut Vm<'_>, args: &Args<'_>) -> R<smallvec::SmallVec<[Value; 3]>> {
    match vm.plain(args.at(0)) {
        Value::Tuple(tuple) => Ok(vm.heap[tuple].0.clone()),
        other => {
            let name = vm.type_name(other);
            Err(vm.type_error(format!("descriptor requires a 'tuple' object but received a '{name}'")))
        }
    }
}

/// `tuple(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if !args.kw.is_empty() {
        return Err(vm.type_error("tuple() takes no keyword arguments"));
    }
    match *args.pos {
        [] => Ok(vm.new_tuple([].as_slice())),
        [same @ Value::Tuple(_)] => Ok(same),
        [iterable] => {
            let items = vm.collect(iterable)?;
            Ok(vm.new_tuple(items))
        }
        _ => Err(vm.type_error(format!("tuple expected at most 1 argument, got {}", args.pos.len()))),
    }
}

/// `a + b`
pub fn concat(vm: &mut Vm<'_>, a: Ref<Tuple>, b: Ref<Tuple>) -> R<Value> {
    let (x, y) = (&vm.heap[a].0, &vm.heap[b].0);
    if x.is_empty() {
        return Ok(Value::Tuple(b));
    }
    if y.is_empty() {
        return Ok(Value::Tuple(a));
    }
    let len = x.len() + y.len();
    vm.reserve(len * VALUE)?;
    vm.charge(len as u64 / 16)?;
    let items = [vm.heap[a].0.as_slice(), vm.heap[b].0.as_slice()].concat();
    Ok(vm.new_tuple(items))
}

fn index(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let items = items(vm, &args)?;
    let (start, stop) = containers::search_range(vm, &args, items.len())?;
    for (i, &item) in items.iter().enumerate().take(stop).skip(start) {
        vm.charge(1)?;
        if vm.eq(item, args.at(1))? {
            return Ok(Value::int(i as i64));
        }
    }
    Err(vm.value_error("tuple.index(x): x not in tuple"))
}

fn count(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let mut n = 0;
    for item in items(vm, &args)? {
        vm.charge(1)?;
        n += i64::from(vm.eq(item, args.at(1))?);
    }
    Ok(Value::int(n))
}

/// Methods of `tuple`.
pub const METHODS: &[Native] = &[
    Native::static_method("__new__", 1, ANY, |vm, a| super::object::new_builtin(vm, a, Builtin::Tuple)).keywords(),
    Native::method("index", 1, 3, index),
    Native::method("count", 1, 1, count),
    Native::method("__len__", 0, 0, containers::method_len),
    Native::method("__contains__", 1, 1, containers::method_contains),
    Native::method("__getitem__", 1, 1, containers::method_get_item),
    Native::method("__iter__", 0, 0, containers::method_iter),
    Native::method("__repr__", 0, 0, containers::method_repr),
    Native::method("__hash__", 0, 0, containers::method_hash),
    Native::method("__getnewargs__", 0, 0, |vm, args| Ok(vm.new_tuple([args.at(0)].as_slice()))),
    Native::method("__add__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Add, args)),
    Native::method("__mul__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Mul, args)),
    Native::method("__rmul__", 1, 1, |vm, args| containers::method_binary(vm, BinaryOp::Mul, args)),
    Native::method("__eq__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Eq, args)),
    Native::method("__ne__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ne, args)),
    Native::method("__lt__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Lt, args)),
    Native::method("__le__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Le, args)),
    Native::method("__gt__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Gt, args)),
    Native::method("__ge__", 1, 1, |vm, args| containers::method_compare(vm, CompareOp::Ge, args)),
    Native::class_method("__class_getitem__", 1, 1, containers::method_class_getitem),
];
