//! `UnicodeEncodeError`, `UnicodeDecodeError` and `UnicodeTranslateError`: their attributes are their arguments.

use crate::python::error::R;
use crate::python::native::{ANY, Args, Native};
use crate::python::text::codec::{decode_message, encode_message};
use crate::python::value::Value;
use crate::python::vm::Vm;

/// Argument `place` of an exception; `None` where there are not that many.
fn part(vm: &Vm<'_>, args: &Args<'_>, place: usize) -> Option<Value> {
    match vm.heap.exception_data(args.at(0))?.args {
        Value::Tuple(items) => vm.heap[items].0.get(place).copied(),
        _ => None,
    }
}

fn set_parts<const N: usize>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let given = args.pos.len() - 1;
    if given != N {
        return Err(vm.type_error(format!("function takes exactly {N} arguments ({given} given)")));
    }
    let parts = vm.new_tuple(&args.pos[1..]);
    if let Some(data) = vm.heap.exception_data_mut(args.at(0)) {
        data.args = parts;
    }
    Ok(Value::None)
}

/// The text and the bounds that a message is about; `first` is the number of the argument that holds the text.
fn bounds(vm: &mut Vm<'_>, args: &Args<'_>, first: usize) -> R<Option<(Value, i64, i64, String)>> {
    let (Some(object), Some(start), Some(end), Some(reason)) =
        (part(vm, args, first), part(vm, args, first + 1), part(vm, args, first + 2), part(vm, args, first + 3))
    else {
        return Ok(None);
    };
    Ok(Some((vm.plain(object), vm.index(start)?, vm.index(end)?, vm.str(reason)?)))
}

fn character(vm: &Vm<'_>, text: Value, at: i64) -> Option<char> {
    match text {
        Value::Str(s) => vm.text(s).chars().nth(usize::try_from(at).ok()?),
        _ => None,
    }
}

fn encode_text(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some((text, start, end, reason)) = bounds(vm, &args, 1)? else { return Ok(vm.new_str("")) };
    let codec = codec(vm, &args)?;
    let first = character(vm, text, start);
    Ok(vm.new_str(encode_message(&codec, first, start, end, &reason)))
}

fn decode_text(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some((object, start, end, reason)) = bounds(vm, &args, 1)? else { return Ok(vm.new_str("")) };
    let codec = codec(vm, &args)?;
    let data: &[u8] = match object {
        Value::Bytes(r) => &vm.heap[r].0,
        Value::ByteArray(r) => &vm.heap[r].0,
        _ => &[],
    };
    let first = usize::try_from(start).ok().and_then(|at| data.get(at)).copied();
    Ok(vm.new_str(decode_message(&codec, first, start, end, &reason)))
}

fn translate_text(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some((text, start, end, reason)) = bounds(vm, &args, 0)? else { return Ok(vm.new_str("")) };
    let first = character(vm, text, start);
    let message = encode_message("", first, start, end, &reason).replacen("'' codec can't encode", "can't translate", 1);
    Ok(vm.new_str(message))
}

fn codec(vm: &mut Vm<'_>, args: &Args<'_>) -> R<String> {
    let codec = part(vm, args, 0).unwrap_or(Value::None);
    vm.str(codec)
}

fn get<const PLACE: usize>(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(part(vm, &args, PLACE).unwrap_or(Value::None))
}

/// `UnicodeEncodeError`
pub const ENCODE: &[Native] = &[
    Native::raw("__init__", 0, ANY, set_parts::<5>),
    Native::raw("__str__", 0, 0, encode_text),
    Native::getter("encoding", get::<0>),
    Native::getter("object", get::<1>),
    Native::getter("start", get::<2>),
    Native::getter("end", get::<3>),
    Native::getter("reason", get::<4>),
];

/// `UnicodeDecodeError`
pub const DECODE: &[Native] = &[
    Native::raw("__init__", 0, ANY, set_parts::<5>),
    Native::raw("__str__", 0, 0, decode_text),
    Native::getter("encoding", get::<0>),
    Native::getter("object", get::<1>),
    Native::getter("start", get::<2>),
    Native::getter("end", get::<3>),
    Native::getter("reason", get::<4>),
];

/// `UnicodeTranslateError`
pub const TRANSLATE: &[Native] = &[
    Native::raw("__init__", 0, ANY, set_parts::<4>),
    Native::raw("__str__", 0, 0, translate_text),
    Native::getter("object", get::<0>),
    Native::getter("start", get::<1>),
    Native::getter("end", get::<2>),
    Native::getter("reason", get::<3>),
];
