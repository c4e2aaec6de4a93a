//! `_operator`: the operators as functions. What `operator` has beyond (`itemgetter` and its like) is in `lib/operator.py`.

use super::Item;
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::native::{Args, Native};
use crate::python::symbols::sym;
use crate::python::types::iterator::length_hint as hint_of;
use crate::python::value::{BinaryOp, CompareOp, UnaryOp, Value};
use crate::python::vm::Vm;

macro_rules! operators {
    ($($name:literal, $arity:literal, $body:expr;)*) => {
        /// What `import _operator` brings.
        pub const ITEMS: &[(&str, Item)] = &[$(($name, {
            static NATIVE: Native = Native::function($name, $arity, $arity, $body).of("_operator");
            Item::Native(&NATIVE)
        }),)* ("length_hint", Item::Native(&LENGTH_HINT)), ("call", Item::Native(&CALL))];
    };
}

static LENGTH_HINT: Native = Native::function("length_hint", 1, 2, length_hint);
static CALL: Native =
    Native::function("call", 1, crate::python::native::ANY, |vm, args| vm.call_with(args.at(0), Args { pos: &args.pos[1..], kw: args.kw }))
        .keywords();

macro_rules! binary {
    ($op:ident) => {
        |vm, args| vm.binary(BinaryOp::$op, args.at(0), args.at(1))
    };
}
macro_rules! inplace {
    ($op:ident) => {
        |vm, args| vm.inplace(BinaryOp::$op, args.at(0), args.at(1))
    };
}
macro_rules! compare {
    ($op:ident) => {
        |vm, args| vm.compare(CompareOp::$op, args.at(0), args.at(1))
    };
}
macro_rules! unary {
    ($op:ident) => {
        |vm, args| vm.unary(UnaryOp::$op, args.at(0))
    };
}

operators! {
    "abs", 1, crate::python::builtins::abs;
    "add", 2, binary!(Add);
    "and_", 2, binary!(And);
    "concat", 2, |vm, args| concat(vm, args, false);
    "contains", 2, |vm, args| Ok(Value::Bool(vm.contains(args.at(0), args.at(1))?));
    "countOf", 2, count_of;
    "delitem", 2, |vm, args| vm.del_item(args.at(0), args.at(1)).map(|()| Value::None);
    "eq", 2, compare!(Eq);
    "floordiv", 2, binary!(FloorDiv);
    "ge", 2, compare!(Ge);
    "getitem", 2, |vm, args| vm.get_item(args.at(0), args.at(1));
    "gt", 2, compare!(Gt);
    "iadd", 2, inplace!(Add);
    "iand", 2, inplace!(And);
    "iconcat", 2, |vm, args| concat(vm, args, true);
    "ifloordiv", 2, inplace!(FloorDiv);
    "ilshift", 2, inplace!(LShift);
    "imatmul", 2, inplace!(MatMul);
    "imod", 2, inplace!(Mod);
    "imul", 2, inplace!(Mul);
    "index", 1, |vm, args| vm.index_value(args.at(0));
    "indexOf", 2, index_of;
    "inv", 1, unary!(Invert);
    "invert", 1, unary!(Invert);
    "ior", 2, inplace!(Or);
    "ipow", 2, inplace!(Pow);
    "irshift", 2, inplace!(RShift);
    "is_", 2, |vm, args| Ok(Value::Bool(vm.pin(args.at(0)).is(vm.pin(args.at(1)))));
    "is_not", 2, |vm, args| Ok(Value::Bool(!vm.pin(args.at(0)).is(vm.pin(args.at(1)))));
    "isub", 2, inplace!(Sub);
    "itruediv", 2, inplace!(Div);
    "ixor", 2, inplace!(Xor);
    "le", 2, compare!(Le);
    "lshift", 2, binary!(LShift);
    "lt", 2, compare!(Lt);
    "matmul", 2, binary!(MatMul);
    "mod", 2, binary!(Mod);
    "mul", 2, binary!(Mul);
    "ne", 2, compare!(Ne);
    "neg", 1, unary!(Neg);
    "not_", 1, |vm, args| Ok(Value::Bool(!vm.truth(args.at(0))?));
    "or_", 2, binary!(Or);
    "pos", 1, unary!(Pos);
    "pow", 2, binary!(Pow);
    "rshift", 2, binary!(RShift);
    "setitem", 3, |vm, args| vm.set_item(args.at(0), args.at(1), args.at(2)).map(|()| Value::None);
    "sub", 2, binary!(Sub);
    "truediv", 2, binary!(Div);
    "truth", 1, |vm, args| Ok(Value::Bool(vm.truth(args.at(0))?));
    "xor", 2, binary!(Xor);
}

/// `a + b` of sequences.
fn concat(vm: &mut Vm<'_>, args: Args<'_>, inplace: bool) -> R<Value> {
    let (a, b) = (args.at(0), args.at(1));
    let sequence = matches!(vm.plain(a), Value::List(_) | Value::Tuple(_) | Value::Str(_) | Value::Bytes(_) | Value::ByteArray(_));
    if !sequence && vm.special(a, sym::GETITEM).is_none() {
        let name = vm.type_name(a);
        return Err(vm.type_error(format!("'{name}' object can't be concatenated")));
    }
    if inplace { vm.inplace(BinaryOp::Add, a, b) } else { vm.binary(BinaryOp::Add, a, b) }
}

/// An iterator over what is searched.
fn searched(vm: &mut Vm<'_>, object: Value) -> R<Value> {
    match vm.iter(object) {
        Err(raise) if vm.raised(&raise, Builtin::TypeError) => {
            let name = vm.type_name(object);
            Err(vm.type_error(format!("argument of type '{name}' is not iterable")))
        }
        other => other,
    }
}

fn count_of(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let mut n = 0;
    let iter = searched(vm, args.at(0))?;
    vm.for_each(iter, |vm, item| {
        n += i64::from(vm.eq(item, args.at(1))?);
        Ok(true)
    })?;
    Ok(Value::int(n))
}

fn index_of(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (mut at, mut found) = (0, false);
    let iter = searched(vm, args.at(0))?;
    vm.for_each(iter, |vm, item| {
        found = vm.eq(item, args.at(1))?;
        at += i64::from(!found);
        Ok(!found)
    })?;
    if found { Ok(Value::int(at)) } else { Err(vm.value_error("sequence.index(x): x not in sequence")) }
}

/// `length_hint(o, default=0)`
fn length_hint(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let object = args.at(0);
    let default = match args.get(1) {
        None => Value::int(0),
        Some(Value::Bool(b)) => Value::int(b.into()),
        Some(int @ (Value::Int(..) | Value::Big(_))) => int,
        Some(other) => {
            let name = vm.type_name(other);
            return Err(vm.type_error(format!("'{name}' object cannot be interpreted as an integer")));
        }
    };
    if let Value::Iter(_) = object {
        return Ok(hint_of(vm, object).map_or(default, |n| vm.heap.big(n.into())));
    }
    if vm.special(object, sym::LEN).is_some() {
        return Ok(Value::int(vm.len(object)? as i64));
    }
    let Some(method) = vm.special(object, sym::LENGTH_HINT) else { return Ok(default) };
    match vm.call(method, &[])? {
        Value::NotImplemented => Ok(default),
        hint @ (Value::Int(..) | Value::Bool(_)) => {
            if vm.index(hint)? < 0 {
                return Err(vm.value_error("__length_hint__() should return >= 0"));
            }
            Ok(hint)
        }
        other => {
            let name = vm.type_name(other);
            Err(vm.type_error(format!("__length_hint__ must be an integer, not {name}")))
        }
    }
}
