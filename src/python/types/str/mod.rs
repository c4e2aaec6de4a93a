//! `str`: its constructor, operators and methods. Indices are code points; texts that are ASCII are indexed at once.

mod case;
mod convert;
mod layout;
mod search;
mod split;

pub(super) use layout::{centered, expand};

use super::containers;
use super::number::spec_of;
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::{Ref, Str};
use crate::python::native::{ANY, Args, Native};
use crate::python::text;
use crate::python::value::{CompareOp, Value};
use crate::python::vm::Vm;

/// `str(...)`
pub fn construct(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let given = args.pos.len() + args.kw.len();
    if given > 3 {
        return Err(vm.type_error(format!("str() takes at most 3 arguments ({given} given)")));
    }
    let [object, encoding, errors] = vm.bind("str", args, ["object", "encoding", "errors"], 0)?;
    let Some(object) = object else { return Ok(vm.new_str("")) };
    if encoding.is_none() && errors.is_none() {
        if let Value::Str(_) = object {
            return Ok(object);
        }
        let text = vm.str(object)?;
        return Ok(vm.new_str(text));
    }
    match vm.plain(object) {
        Value::Bytes(_) | Value::ByteArray(_) => super::bytes::decode_with(vm, object, encoding, errors, "str"),
        Value::Str(_) => Err(vm.type_error("decoding str is not supported")),
        _ => {
            let class = vm.type_name(object);
            Err(vm.type_error(format!("decoding to str: need a bytes-like object, {class} found")))
        }
    }
}

/// The text that a method was called on.
fn this(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Ref<Str>> {
    match vm.plain(args.at(0)) {
        Value::Str(s) => Ok(s),
        other => {
            let class = vm.type_name(other);
            Err(vm.type_error(format!("descriptor requires a 'str' object but received a '{class}'")))
        }
    }
}

/// A text among the arguments; `wanted` begins the message where it is none.
fn text_arg(vm: &mut Vm<'_>, value: Value, wanted: &str) -> R<Ref<Str>> {
    match vm.plain(value) {
        Value::Str(s) => Ok(s),
        _ => {
            let class = vm.type_name(value);
            Err(vm.type_error(format!("{wanted}, not {class}")))
        }
    }
}

/// `a + b`
pub fn concat(vm: &mut Vm<'_>, a: Ref<Str>, b: Ref<Str>) -> R<Value> {
    let size = vm.heap[a].text.len() + vm.heap[b].text.len();
    vm.reserve(size)?;
    vm.charge(size as u64 / 64)?;
    let joined = [vm.text(a), vm.text(b)].concat();
    Ok(vm.new_str(joined))
}

/// `text * count`
pub fn repeat(vm: &mut Vm<'_>, text: Ref<Str>, count: Value) -> R<Value> {
    let count = containers::repeat_count(vm, count)?.max(0) as usize;
    if count == 1 {
        return Ok(Value::Str(text));
    }
    let size = vm.heap[text].text.len().saturating_mul(count);
    vm.reserve(size)?;
    vm.charge(size as u64 / 64)?;
    let repeated = if size == 0 { String::new() } else { vm.text(text).repeat(count) };
    Ok(vm.new_str(repeated))
}

/// How two texts compare: by code points.
pub fn compare(vm: &Vm<'_>, op: CompareOp, a: Ref<Str>, b: Ref<Str>) -> bool {
    op.holds(vm.text(a).cmp(vm.text(b)))
}

fn add(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    match vm.plain(args.at(1)) {
        Value::Str(other) => concat(vm, text, other),
        _ => {
            let class = vm.type_name(args.at(1));
            Err(vm.type_error(format!("can only concatenate str (not \"{class}\") to str")))
        }
    }
}

fn mul(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    repeat(vm, text, args.at(1))
}

fn modulo(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let template = vm.heap[text].text.clone();
    let made = text::percent(vm, &template, args.at(1))?;
    Ok(vm.new_str(made))
}

fn rmod(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let Value::Str(template) = vm.plain(args.at(1)) else { return Ok(Value::NotImplemented) };
    let template = vm.heap[template].text.clone();
    let made = text::percent(vm, &template, Value::Str(text))?;
    Ok(vm.new_str(made))
}

fn compare_method(vm: &mut Vm<'_>, op: CompareOp, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    match vm.plain(args.at(1)) {
        Value::Str(other) => {
            vm.charge(vm.heap[text].text.len().min(vm.heap[other].text.len()) as u64 / 64)?;
            Ok(Value::Bool(compare(vm, op, text, other)))
        }
        _ => Ok(Value::NotImplemented),
    }
}

fn itself(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::Str(this(vm, &args)?))
}

fn repr(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let size = vm.heap[text].text.len();
    vm.charge(size as u64 / 16)?;
    vm.reserve(size * 2)?;
    let shown = text::repr_str(vm.text(text));
    Ok(vm.new_str(shown))
}

fn format_dunder(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let spec = spec_of(vm, args.at(1))?;
    let made = text::format_value(vm, Value::Str(text), &spec)?;
    Ok(vm.new_str(made))
}

fn new_args(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    Ok(vm.new_tuple([Value::Str(text)].as_slice()))
}

/// Methods of `str`.
pub const METHODS: &[Native] = &[
    Native::static_method("__new__", 1, ANY, |vm, a| super::object::new_builtin(vm, a, Builtin::Str)).keywords(),
    Native::method("capitalize", 0, 0, case::capitalize),
    Native::method("casefold", 0, 0, case::casefold),
    Native::method("center", 1, 2, layout::center),
    Native::method("count", 1, 3, search::count),
    Native::method("encode", 0, ANY, convert::encode).keywords(),
    Native::method("endswith", 1, 3, search::endswith),
    Native::method("expandtabs", 0, ANY, layout::expandtabs).keywords(),
    Native::method("find", 1, 3, search::find),
    Native::method("format", 0, ANY, convert::format).keywords(),
    Native::method("format_map", 1, 1, convert::format_map),
    Native::method("index", 1, 3, search::index),
    Native::method("isalnum", 0, 0, case::isalnum),
    Native::method("isalpha", 0, 0, case::isalpha),
    Native::method("isascii", 0, 0, case::isascii),
    Native::method("isdecimal", 0, 0, case::isdecimal),
    Native::method("isdigit", 0, 0, case::isdigit),
    Native::method("isidentifier", 0, 0, case::isidentifier),
    Native::method("islower", 0, 0, case::islower),
    Native::method("isnumeric", 0, 0, case::isnumeric),
    Native::method("isprintable", 0, 0, case::isprintable),
    Native::method("isspace", 0, 0, case::isspace),
    Native::method("istitle", 0, 0, case::istitle),
    Native::method("isupper", 0, 0, case::isupper),
    Native::method("join", 1, 1, split::join),
    Native::method("ljust", 1, 2, layout::ljust),
    Native::method("lower", 0, 0, case::lower),
    Native::method("lstrip", 0, 1, split::lstrip),
    Native::static_method("maketrans", 1, 3, convert::maketrans),
    Native::method("partition", 1, 1, split::partition),
    Native::method("removeprefix", 1, 1, split::removeprefix),
    Native::method("removesuffix", 1, 1, split::removesuffix),
    Native::method("replace", 2, 3, search::replace),
    Native::method("rfind", 1, 3, search::rfind),
    Native::method("rindex", 1, 3, search::rindex),
    Native::method("rjust", 1, 2, layout::rjust),
    Native::method("rpartition", 1, 1, split::rpartition),
    Native::method("rsplit", 0, ANY, split::rsplit).keywords(),
    Native::method("rstrip", 0, 1, split::rstrip),
    Native::method("split", 0, ANY, split::split).keywords(),
    Native::method("splitlines", 0, ANY, split::splitlines).keywords(),
    Native::method("startswith", 1, 3, search::startswith),
    Native::method("strip", 0, 1, split::strip),
    Native::method("swapcase", 0, 0, case::swapcase),
    Native::method("title", 0, 0, case::title),
    Native::method("translate", 1, 1, convert::translate),
    Native::method("upper", 0, 0, case::upper),
    Native::method("zfill", 1, 1, layout::zfill),
    Native::method("__add__", 1, 1, add),
    Native::method("__mul__", 1, 1, mul),
    Native::method("__rmul__", 1, 1, mul),
    Native::method("__mod__", 1, 1, modulo),
    Native::method("__rmod__", 1, 1, rmod),
    Native::method("__len__", 0, 0, containers::method_len),
    Native::method("__contains__", 1, 1, containers::method_contains),
    Native::method("__getitem__", 1, 1, containers::method_get_item),
    Native::method("__iter__", 0, 0, containers::method_iter),
    Native::method("__hash__", 0, 0, containers::method_hash),
    Native::method("__str__", 0, 0, itself),
    Native::method("__repr__", 0, 0, repr),
    Native::method("__format__", 1, 1, format_dunder),
    Native::method("__getnewargs__", 0, 0, new_args),
    Native::method("__lt__", 1, 1, |vm, args| compare_method(vm, CompareOp::Lt, args)),
    Native::method("__le__", 1, 1, |vm, args| compare_method(vm, CompareOp::Le, args)),
    Native::method("__eq__", 1, 1, |vm, args| compare_method(vm, CompareOp::Eq, args)),
    Native::method("__ne__", 1, 1, |vm, args| compare_method(vm, CompareOp::Ne, args)),
    Native::method("__gt__", 1, 1, |vm, args| compare_method(vm, CompareOp::Gt, args)),
    Native::method("__ge__", 1, 1, |vm, args| compare_method(vm, CompareOp::Ge, args)),
];
