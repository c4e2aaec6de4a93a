//! `bytes` and `bytearray`: their constructors, operators and methods. They share all methods that do not change them; a method of one
//! gives a value of the same type.

mod array;
mod construct;
mod methods;
mod split;

pub use array::{del_item, set_item};
pub use construct::{collect, construct, construct_array, decode_with, encode_with};

use super::containers;
use super::slice;
use crate::python::error::{R, Raise};
use crate::python::heap::{ByteArray, Bytes};
use crate::python::native::{ANY, Args, Native};
use crate::python::text;
use crate::python::value::{CompareOp, Value};
use crate::python::vm::Vm;

/// Bytes as the text with a character for each.
pub fn latin1(bytes: &[u8]) -> String {
    bytes.iter().map(|b| char::from(*b)).collect()
}

/// What a method was called on: a copy of the bytes, and whether they are a bytearray's.
struct Receiver {
    data: Vec<u8>,
    array: bool,
}

fn this(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Receiver> {
    let plain = vm.plain(args.at(0));
    match content(vm, plain) {
        Some(data) => {
            let data = data.to_vec();
            vm.charge(data.len() as u64 / 32)?;
            Ok(Receiver { data, array: matches!(plain, Value::ByteArray(_)) })
        }
        None => {
            let class = vm.type_name(args.at(0));
            Err(vm.type_error(format!("descriptor requires a 'bytes' object but received a '{class}'")))
        }
    }
}

impl Receiver {
    /// A new value of the receiver's type.
    fn make(&self, vm: &mut Vm<'_>, data: Vec<u8>) -> R<Value> {
        vm.reserve(data.len())?;
        Ok(make(vm, data, self.array))
    }
}

fn make(vm: &mut Vm<'_>, data: Vec<u8>, array: bool) -> Value {
    if array { Value::ByteArray(vm.heap.alloc(ByteArray(data))) } else { Value::Bytes(vm.heap.alloc(Bytes(data.into()))) }
}

/// The bytes of a plain bytes-like value.
fn content<'a>(vm: &'a Vm<'_>, value: Value) -> Option<&'a [u8]> {
    match value {
        Value::Bytes(r) => Some(&vm.heap[r].0),
        Value::ByteArray(r) => Some(&vm.heap[r].0),
        _ => None,
    }
}

/// A bytes-like argument.
fn buffer(vm: &mut Vm<'_>, value: Value) -> R<Vec<u8>> {
    let plain = vm.plain(value);
    match content(vm, plain) {
        Some(data) => Ok(data.to_vec()),
        None => {
            let class = vm.type_name(value);
            Err(vm.type_error(format!("a bytes-like object is required, not '{class}'")))
        }
    }
}

/// A byte from an int; `what` is "byte" or "bytes", as the message has it.
fn byte(vm: &mut Vm<'_>, value: Value, what: &str) -> R<u8> {
    let value = vm.pin(value);
    let out_of_range = |vm: &mut Vm<'_>| vm.value_error(format!("{what} must be in range(0, 256)"));
    match value {
        Value::Int(v, _) => u8::try_from(v).map_err(|_| out_of_range(vm)),
        Value::Big(_) => Err(out_of_range(vm)),
        _ => {
            let big = vm.index_big(value)?;
            u8::try_from(&big).map_err(|_| out_of_range(vm))
        }
    }
}

/// `bytes[index]`
pub fn get_item(vm: &mut Vm<'_>, object: Value, index: Value) -> R<Value> {
    let array = matches!(object, Value::ByteArray(_));
    let len = content(vm, object).map_or(0, <[u8]>::len);
    if let Value::Slice(s) = index {
        let span = slice::span(vm, s, len)?;
        vm.charge(span.len as u64 / 32)?;
        vm.reserve(span.len)?;
        let part = content(vm, object).map(|data| span.of(data)).unwrap_or_default();
        return Ok(make(vm, part, array));
    }
    let (what, outside) = if array { ("bytearray", "bytearray index out of range") } else { ("bytes", "index out of range") };
    let place = vm.place_in(what, outside, index, len)?;
    Ok(Value::int(content(vm, object).map_or(0, |data| i64::from(data[place]))))
}

/// `item in bytes`
pub fn contains(vm: &mut Vm<'_>, object: Value, item: Value) -> R<bool> {
    let plain = vm.plain(item);
    let len = content(vm, object).map_or(0, <[u8]>::len);
    vm.charge(len as u64 / 64)?;
    if let (Some(data), Some(piece)) = (content(vm, object), content(vm, plain)) {
        return Ok(super::search::find(data, piece, false).is_some());
    }
    if crate::python::numbers::int_value(plain).is_some() {
        let byte = byte(vm, plain, "byte")?;
        return Ok(content(vm, object).is_some_and(|data| data.contains(&byte)));
    }
    let class = vm.type_name(item);
    Err(vm.type_error(format!("a bytes-like object is required, not '{class}'")))
}

fn add(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let plain = vm.plain(args.at(1));
    let Some(other) = content(vm, plain) else { return Err(cannot_concat(vm, args.at(1), receiver.array)) };
    let joined = [&receiver.data, other].concat();
    receiver.make(vm, joined)
}

fn cannot_concat(vm: &mut Vm<'_>, other: Value, array: bool) -> Raise {
    let class = vm.type_name(other);
    vm.type_error(format!("can't concat {class} to {}", if array { "bytearray" } else { "bytes" }))
}

fn mul(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let data = repeated(vm, &receiver.data, args.at(1))?;
    receiver.make(vm, data)
}

fn repeated(vm: &mut Vm<'_>, data: &[u8], count: Value) -> R<Vec<u8>> {
    let count = containers::repeat_count(vm, count)?.max(0) as usize;
    let size = data.len().saturating_mul(count);
    vm.reserve(size)?;
    vm.charge(size as u64 / 64)?;
    Ok(if size == 0 { Vec::new() } else { data.repeat(count) })
}

fn modulo(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let data = text::percent_bytes(vm, &receiver.data, args.at(1))?;
    receiver.make(vm, data)
}

fn rmod(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let plain = vm.plain(args.at(1));
    let Some(template) = content(vm, plain).map(<[u8]>::to_vec) else { return Ok(Value::NotImplemented) };
    let data = text::percent_bytes(vm, &template, args.at(0))?;
    receiver.make(vm, data)
}

fn compare(vm: &mut Vm<'_>, op: CompareOp, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    let plain = vm.plain(args.at(1));
    let Some(other) = content(vm, plain) else { return Ok(Value::NotImplemented) };
    Ok(Value::Bool(op.holds(receiver.data.as_slice().cmp(other))))
}

fn repr(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    vm.reserve(receiver.data.len() * 4)?;
    let shown = text::repr_bytes(&receiver.data);
    // A subclass of bytearray shows its own name.
    Ok(vm.new_str(if receiver.array { format!("{}({shown})", vm.type_name(args.at(0))) } else { shown }))
}

fn itself(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let receiver = this(vm, &args)?;
    Ok(make(vm, receiver.data, false))
}

fn new_args(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = itself(vm, args)?;
    Ok(vm.new_tuple([value].as_slice()))
}

macro_rules! with_shared {
    ($($own:expr,)*) => {
        &[
            Native::method("capitalize", 0, 0, methods::capitalize),
            Native::method("center", 1, 2, methods::center),
            Native::method("count", 1, 3, methods::count),
            Native::method("decode", 0, ANY, construct::decode).keywords(),
            Native::method("endswith", 1, 3, methods::endswith),
            Native::method("expandtabs", 0, ANY, methods::expandtabs).keywords(),
            Native::method("find", 1, 3, methods::find),
            Native::class_method("fromhex", 1, 1, construct::fromhex),
            Native::method("hex", 0, ANY, construct::hex).keywords(),
            Native::method("index", 1, 3, methods::index),
            Native::method("isalnum", 0, 0, methods::isalnum),
            Native::method("isalpha", 0, 0, methods::isalpha),
            Native::method("isascii", 0, 0, methods::isascii),
            Native::method("isdigit", 0, 0, methods::isdigit),
            Native::method("islower", 0, 0, methods::islower),
            Native::method("isspace", 0, 0, methods::isspace),
            Native::method("istitle", 0, 0, methods::istitle),
            Native::method("isupper", 0, 0, methods::isupper),
            Native::method("join", 1, 1, split::join),
            Native::method("ljust", 1, 2, methods::ljust),
            Native::method("lower", 0, 0, methods::lower),
            Native::method("lstrip", 0, 1, split::lstrip),
            Native::static_method("maketrans", 2, 2, methods::maketrans),
            Native::method("partition", 1, 1, split::partition),
            Native::method("removeprefix", 1, 1, split::removeprefix),
            Native::method("removesuffix", 1, 1, split::removesuffix),
            Native::method("replace", 2, 3, methods::replace),
            Native::method("rfind", 1, 3, methods::rfind),
            Native::method("rindex", 1, 3, methods::rindex),
            Native::method("rjust", 1, 2, methods::rjust),
            Native::method("rpartition", 1, 1, split::rpartition),
            Native::method("rsplit", 0, ANY, split::rsplit).keywords(),
            Native::method("rstrip", 0, 1, split::rstrip),
            Native::method("split", 0, ANY, split::split).keywords(),
            Native::method("splitlines", 0, ANY, split::splitlines).keywords(),
            Native::method("startswith", 1, 3, methods::startswith),
            Native::method("strip", 0, 1, split::strip),
            Native::method("swapcase", 0, 0, methods::swapcase),
            Native::method("title", 0, 0, methods::title),
            Native::method("translate", 1, ANY, methods::translate).keywords(),
            Native::method("upper", 0, 0, methods::upper),
            Native::method("zfill", 1, 1, methods::zfill),
            Native::method("__add__", 1, 1, add),
            Native::method("__mul__", 1, 1, mul),
            Native::method("__rmul__", 1, 1, mul),
            Native::method("__mod__", 1, 1, modulo),
            Native::method("__rmod__", 1, 1, rmod),
            Native::method("__len__", 0, 0, containers::method_len),
            Native::method("__contains__", 1, 1, containers::method_contains),
            Native::method("__getitem__", 1, 1, containers::method_get_item),
            Native::method("__iter__", 0, 0, containers::method_iter),
            Native::raw("__repr__", 0, 0, repr),
            Native::method("__lt__", 1, 1, |vm, args| compare(vm, CompareOp::Lt, args)),
            Native::method("__le__", 1, 1, |vm, args| compare(vm, CompareOp::Le, args)),
            Native::method("__eq__", 1, 1, |vm, args| compare(vm, CompareOp::Eq, args)),
            Native::method("__ne__", 1, 1, |vm, args| compare(vm, CompareOp::Ne, args)),
            Native::method("__gt__", 1, 1, |vm, args| compare(vm, CompareOp::Gt, args)),
            Native::method("__ge__", 1, 1, |vm, args| compare(vm, CompareOp::Ge, args)),
            Native::static_method("__new__", 1, ANY, super::object::new).keywords(),
            $($own,)*
        ]
    };
}

/// Methods of `bytes`.
pub const METHODS: &[Native] = with_shared![
    Native::method("__bytes__", 0, 0, itself),
    Native::method("__hash__", 0, 0, containers::method_hash),
    Native::method("__getnewargs__", 0, 0, new_args),
];

/// Methods of `bytearray`.
pub const ARRAY: &[Native] = with_shared![
    Native::method("__init__", 0, ANY, array::init).keywords(),
    Native::method("append", 1, 1, array::append),
    Native::method("clear", 0, 0, array::clear),
    Native::method("copy", 0, 0, array::copy),
    Native::method("extend", 1, 1, array::extend),
    Native::method("insert", 2, 2, array::insert),
    Native::method("pop", 0, 1, array::pop),
    Native::method("remove", 1, 1, array::remove),
    Native::method("reverse", 0, 0, array::reverse),
    Native::method("__setitem__", 2, 2, containers::method_set_item),
    Native::method("__delitem__", 1, 1, containers::method_del_item),
    Native::method("__iadd__", 1, 1, array::iadd),
    Native::method("__imul__", 1, 1, array::imul),
];
