//! `encode`, `format`, `translate`.

use super::{text_arg, this};
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::Bytes;
use crate::python::native::Args;
use crate::python::numbers;
use crate::python::text;
use crate::python::types::bytes;
use crate::python::value::Value;
use crate::python::vm::Vm;

pub(super) fn encode(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let [encoding, errors] = vm.bind("encode", Args { pos: &args.pos[1..], kw: args.kw }, ["encoding", "errors"], 0)?;
    let made = bytes::encode_with(vm, text, encoding, errors, "encode")?;
    Ok(Value::Bytes(vm.heap.alloc(Bytes(made.into()))))
}

pub(super) fn format(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let template = vm.heap[text].text.clone();
    let made = text::str_format(vm, &template, Args { pos: &args.pos[1..], kw: args.kw })?;
    Ok(vm.new_str(made))
}

pub(super) fn format_map(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let template = vm.heap[text].text.clone();
    let made = text::format_map(vm, &template, args.at(1))?;
    Ok(vm.new_str(made))
}

pub(super) fn translate(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let text = this(vm, &args)?;
    let table = args.at(1);
    let source = vm.heap[text].text.clone();
    let mut out = String::with_capacity(source.len());
    for c in source.chars() {
        vm.charge(1)?;
        let code = Value::int(c as i64);
        let found = match table {
            Value::Dict(dict) => vm.dict_get(dict, code)?,
            _ => match vm.get_item(table, code) {
                Ok(value) => Some(value),
                Err(Raise::Exception(e)) if vm.is_instance(e, Builtin::LookupError) => None,
                Err(raise) => return Err(raise),
            },
        };
        let Some(found) = found else {
            out.push(c);
            continue;
        };
        let found = vm.plain(found);
        match found {
            Value::None => {}
            Value::Str(s) => out.push_str(vm.text(s)),
            _ if numbers::int_value(found).is_some() => {
                let code = vm.index_big(found)?;
                match u32::try_from(&code).ok().filter(|c| *c < 0x110000) {
                    Some(code) => out.push(char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER)),
                    None => return Err(vm.value_error("character mapping must be in range(0x110000)")),
                }
            }
            _ => return Err(vm.type_error("character mapping must return integer, None or str")),
        }
        if out.len() > 1 << 16 {
            vm.reserve(out.len() * 2)?;
        }
    }
    Ok(vm.new_str(out))
}

/// `str.maketrans(...)`: static, so that no receiver stands before its arguments.
pub(super) fn maketrans(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let table = vm.heap.dict();
    let Some(second) = args.get(1) else {
        let Value::Dict(given) = vm.plain(args.at(0)) else {
            return Err(vm.type_error("if you give only one argument to maketrans it must be a dict"));
        };
        let entries: Vec<(Value, Value)> = vm.heap[given].0.iter().map(|e| (e.key, e.value)).collect();
        for (key, value) in entries {
            vm.charge(1)?;
            let key = match vm.plain(key) {
                Value::Str(s) => {
                    let mut chars = vm.text(s).chars();
                    match (chars.next(), chars.next()) {
                        (Some(c), None) => Value::int(c as i64),
                        _ => return Err(vm.value_error("string keys in translate table must be of length 1")),
                    }
                }
                other if numbers::int_value(other).is_some() => other,
                _ => return Err(vm.type_error("keys in translate table must be strings or integers")),
            };
            vm.dict_set(table, key, value)?;
        }
        return Ok(Value::Dict(table));
    };
    let second = text_arg(vm, second, "maketrans() argument 2 must be str")?;
    let third = match args.get(2) {
        Some(third) => Some(text_arg(vm, third, "maketrans() argument 3 must be str")?),
        None => None,
    };
    let Value::Str(first) = vm.plain(args.at(0)) else {
        return Err(vm.type_error("first maketrans argument must be a string if there is a second argument"));
    };
    if vm.heap[first].chars != vm.heap[second].chars {
        return Err(vm.value_error("the first two maketrans arguments must have equal length"));
    }
    let pairs: Vec<(char, char)> = vm.text(first).chars().zip(vm.text(second).chars()).collect();
    for (from, to) in pairs {
        vm.charge(1)?;
        vm.dict_set(table, Value::int(from as i64), Value::int(to as i64))?;
    }
    let gone: Vec<char> = third.map(|third| vm.text(third).chars().collect()).unwrap_or_default();
    for c in gone {
        vm.charge(1)?;
        vm.dict_set(table, Value::int(c as i64), Value::None)?;
    }
    Ok(Value::Dict(table))
}
