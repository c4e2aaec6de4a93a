//! What changes a `bytearray`.

use super::{byte, cannot_concat, content, make, repeated};
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::{ByteArray, Ref};
use crate::python::native::Args;
use crate::python::types::{containers, slice};
use crate::python::value::Value;
use crate::python::vm::Vm;

fn this(vm: &mut Vm<'_>, args: &Args<'_>) -> R<Ref<ByteArray>> {
    match vm.plain(args.at(0)) {
        Value::ByteArray(r) => Ok(r),
        _ => {
            let class = vm.type_name(args.at(0));
            Err(vm.type_error(format!("descriptor requires a 'bytearray' object but received a '{class}'")))
        }
    }
}

/// `bytearray.__init__(self, ...)`: replaces what it holds.
pub(super) fn init(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    if let Value::ByteArray(made) = super::construct_array(vm, Args { pos: &args.pos[1..], kw: args.kw })? {
        vm.heap[array].0 = std::mem::take(&mut vm.heap[made].0);
    }
    Ok(Value::None)
}

/// Puts bytes in the place of a range, and counts the growth.
fn splice(vm: &mut Vm<'_>, array: Ref<ByteArray>, start: usize, end: usize, with: &[u8]) -> R<()> {
    let len = vm.heap[array].0.len();
    vm.charge(1 + (len - start) as u64 / 64)?;
    vm.reserve(with.len())?;
    let data = &mut vm.heap[array].0;
    let before = data.capacity();
    data.splice(start..end, with.iter().copied());
    let grown = data.capacity().saturating_sub(before);
    vm.heap.bytes += grown;
    Ok(())
}

/// `array[index] = value`
pub fn set_item(vm: &mut Vm<'_>, array: Ref<ByteArray>, index: Value, value: Value) -> R<()> {
    let len = vm.heap[array].0.len();
    let Value::Slice(s) = index else {
        let place = vm.place_in("bytearray", "bytearray index out of range", index, len)?;
        let byte = byte(vm, value, "byte")?;
        vm.heap[array].0[place] = byte;
        return Ok(());
    };
    let plain = vm.plain(value);
    let items = match content(vm, plain) {
        Some(data) => data.to_vec(),
        None => {
            let iterable = !matches!(plain, Value::Str(_) | Value::Int(..) | Value::Bool(_) | Value::Float(..) | Value::None);
            let Some(items) = (if iterable { containers::try_collect(vm, value)? } else { None }) else {
                return Err(vm.type_error("can assign only bytes, buffers, or iterables of ints in range(0, 256)"));
            };
            items.into_iter().map(|item| byte(vm, item, "byte")).collect::<R<Vec<u8>>>()?
        }
    };
    let span = slice::span(vm, s, vm.heap[array].0.len())?;
    if span.step == 1 {
        let start = span.start as usize;
        return splice(vm, array, start, start + span.len, &items);
    }
    if items.len() != span.len {
        return Err(vm.value_error(format!("attempt to assign bytes of size {} to extended slice of size {}", items.len(), span.len)));
    }
    vm.charge(span.len as u64 / 16)?;
    for (place, byte) in span.indices().zip(items) {
        vm.heap[array].0[place] = byte;
    }
    Ok(())
}

/// `del array[index]`
pub fn del_item(vm: &mut Vm<'_>, array: Ref<ByteArray>, index: Value) -> R<()> {
    let len = vm.heap[array].0.len();
    vm.charge(1 + len as u64 / 64)?;
    let Value::Slice(s) = index else {
        let place = vm.place_in("bytearray", "bytearray index out of range", index, len)?;
        vm.heap[array].0.remove(place);
        return Ok(());
    };
    let span = slice::span(vm, s, len)?;
    if span.step == 1 {
        let start = span.start as usize;
        return splice(vm, array, start, start + span.len, &[]);
    }
    let mut gone = vec![false; len];
    span.indices().for_each(|i| gone[i] = true);
    let mut gone = gone.into_iter();
    vm.heap[array].0.retain(|_| !gone.next().unwrap_or(false));
    Ok(())
}

pub(super) fn append(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    let byte = byte(vm, args.at(1), "byte")?;
    let end = vm.heap[array].0.len();
    splice(vm, array, end, end, &[byte])?;
    Ok(Value::None)
}

pub(super) fn extend(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    let plain = vm.plain(args.at(1));
    let items = match content(vm, plain) {
        Some(data) => data.to_vec(),
        None => {
            let Some(items) = containers::try_collect(vm, args.at(1))? else {
                let class = vm.type_name(args.at(1));
                return Err(vm.type_error(format!("can't extend bytearray with {class}")));
            };
            items.into_iter().map(|item| byte(vm, item, "byte")).collect::<R<Vec<u8>>>()?
        }
    };
    let end = vm.heap[array].0.len();
    splice(vm, array, end, end, &items)?;
    Ok(Value::None)
}

pub(super) fn insert(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    let index = vm.pin(args.at(1));
    let index = vm.index(index)?;
    let byte = byte(vm, args.at(2), "byte")?;
    let len = vm.heap[array].0.len();
    let place = if index < 0 { index.saturating_add(len as i64).max(0) as usize } else { (index as usize).min(len) };
    splice(vm, array, place, place, &[byte])?;
    Ok(Value::None)
}

pub(super) fn pop(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    let index = match args.get(1) {
        Some(index) => {
            let index = vm.pin(index);
            vm.index(index)?
        }
        None => -1,
    };
    let len = vm.heap[array].0.len();
    if len == 0 {
        return Err(vm.error(Builtin::IndexError, "pop from empty bytearray".into()));
    }
    let place = if index < 0 { index.saturating_add(len as i64) } else { index };
    match usize::try_from(place).ok().filter(|p| *p < len) {
        Some(place) => {
            vm.charge((len - place) as u64 / 64)?;
            Ok(Value::int(i64::from(vm.heap[array].0.remove(place))))
        }
        None => Err(vm.error(Builtin::IndexError, "pop index out of range".into())),
    }
}

pub(super) fn remove(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    let byte = byte(vm, args.at(1), "byte")?;
    vm.charge(vm.heap[array].0.len() as u64 / 64)?;
    match vm.heap[array].0.iter().position(|b| *b == byte) {
        Some(place) => {
            vm.heap[array].0.remove(place);
            Ok(Value::None)
        }
        None => Err(vm.value_error("value not found in bytearray")),
    }
}

pub(super) fn reverse(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    vm.charge(vm.heap[array].0.len() as u64 / 64)?;
    vm.heap[array].0.reverse();
    Ok(Value::None)
}

pub(super) fn clear(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    vm.heap[array].0.clear();
    Ok(Value::None)
}

pub(super) fn copy(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    let len = vm.heap[array].0.len();
    vm.charge(len as u64 / 64)?;
    vm.reserve(len)?;
    let data = vm.heap[array].0.clone();
    Ok(make(vm, data, true))
}

pub(super) fn iadd(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    let plain = vm.plain(args.at(1));
    let Some(other) = content(vm, plain).map(<[u8]>::to_vec) else { return Err(cannot_concat(vm, args.at(1), true)) };
    let end = vm.heap[array].0.len();
    splice(vm, array, end, end, &other)?;
    Ok(args.at(0))
}

pub(super) fn imul(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let array = this(vm, &args)?;
    let data = vm.heap[array].0.clone();
    let repeated = repeated(vm, &data, args.at(1))?;
    splice(vm, array, 0, data.len(), &repeated)?;
    Ok(args.at(0))
}
