//! The native iterators as objects: `enumerate`, `zip`, `map`, `filter`, `reversed`, and the methods that all iterators have.

use super::dict;
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::iter::IterState;
use crate::python::iterate;
use crate::python::modules::itertools;
use crate::python::native::{ANY, Args, Native};
use crate::python::symbols::sym;
use crate::python::value::Value;
use crate::python::vm::Vm;

/// Checks that `min..=max` arguments were given, by position only.
pub fn positional(vm: &mut Vm<'_>, name: &str, args: &Args<'_>, min: usize, max: usize) -> R<()> {
    if !args.kw.is_empty() {
        return Err(vm.type_error(format!("{name}() takes no keyword arguments")));
    }
    let given = args.pos.len();
    if given < min || given > max {
        let bound = if min == max {
            ""
        } else if given < min {
            "at least "
        } else {
            "at most "
        };
        let wanted = if given < min { min } else { max };
        let plural = if wanted == 1 { "" } else { "s" };
        return Err(vm.type_error(format!("{name} expected {bound}{wanted} argument{plural}, got {given}")));
    }
    Ok(())
}

/// Iterators over all of the iterables.
pub fn iterators(vm: &mut Vm<'_>, iterables: &[Value]) -> R<Vec<Value>> {
    iterables.iter().map(|&iterable| vm.iter(iterable)).collect()
}

/// An int with its handle, from anything that has `__index__`.
pub fn int_with_handle(vm: &mut Vm<'_>, value: Value) -> R<Value> {
    match vm.plain(value) {
        int @ (Value::Int(..) | Value::Big(_)) => Ok(int),
        other => {
            let big = vm.index_big(other)?;
            Ok(vm.heap.big(big))
        }
    }
}

/// `enumerate(iterable, start=0)`
pub fn construct_enumerate(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let given = args.pos.len() + args.kw.len();
    if given > 2 {
        return Err(vm.type_error(format!("enumerate() takes at most 2 arguments ({given} given)")));
    }
    let [iterable, start] = vm.bind("enumerate", args, ["iterable", "start"], 0)?;
    let Some(iterable) = iterable else { return Err(vm.type_error("enumerate() missing required argument 'iterable'")) };
    let count = match start {
        Some(start) => int_with_handle(vm, start)?,
        None => Value::int(0),
    };
    let iter = vm.iter(iterable)?;
    Ok(vm.new_iter(IterState::Enumerate { iter, count }))
}

/// `zip(*iterables, strict=False)`
pub fn construct_zip(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if args.kw.len() > 1 {
        return Err(vm.type_error(format!("zip() takes at most 1 keyword argument ({} given)", args.kw.len())));
    }
    let mut strict = false;
    for &(name, value) in args.kw {
        if name != sym::N_STRICT {
            let name = vm.symbols.text(name).to_string();
            return Err(vm.type_error(format!("'{name}' is an invalid keyword argument for zip()")));
        }
        strict = vm.truth(value)?;
    }
    let iters = iterators(vm, args.pos)?;
    Ok(vm.new_iter(IterState::Zip { iters, strict }))
}

/// `map(function, *iterables)`
pub fn construct_map(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if !args.kw.is_empty() {
        return Err(vm.type_error("map() takes no keyword arguments"));
    }
    if args.pos.len() < 2 {
        return Err(vm.type_error("map() must have at least two arguments."));
    }
    let iters = iterators(vm, &args.pos[1..])?;
    Ok(vm.new_iter(IterState::Map { function: args.at(0), iters }))
}

/// `filter(function, iterable)`
pub fn construct_filter(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    positional(vm, "filter", &args, 2, 2)?;
    let iter = vm.iter(args.at(1))?;
    Ok(vm.new_iter(IterState::Filter { function: args.at(0), iter }))
}

/// `reversed(sequence)`
pub fn construct_reversed(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    positional(vm, "reversed", &args, 1, 1)?;
    reversed(vm, args.at(0))
}

fn reversed(vm: &mut Vm<'_>, object: Value) -> R<Value> {
    let state = match object {
        Value::List(list) => IterState::ListReversed { list, left: vm.heap[list].0.len() },
        Value::Range(range) => iterate::range_reversed(vm.heap[range]),
        Value::Dict(d) => return Ok(dict::reversed_iter(vm, d, ViewKind::Keys)),
        Value::View(view) => {
            let View { kind, dict } = vm.heap[view];
            return Ok(dict::reversed_iter(vm, dict, kind));
        }
        Value::Proxy(p) => {
            let inner = dict::of_proxy(vm, p);
            return reversed(vm, inner);
        }
        Value::Tuple(_) | Value::Str(_) | Value::Bytes(_) | Value::ByteArray(_) => {
            IterState::SequenceReversed { object, left: vm.len(object)? as i64 }
        }
        Value::Host(_) | Value::Record(_) => match vm.host_items(object)? {
            Some(items) => {
                let object = vm.new_tuple(items.as_slice());
                IterState::SequenceReversed { object, left: items.len() as i64 }
            }
            None => return not_reversible(vm, object),
        },
        Value::Instance(_) | Value::Class(_) => {
            if vm.refuses(object, sym::REVERSED) {
                return not_reversible(vm, object);
            }
            if let Some(method) = vm.special(object, sym::REVERSED) {
                return vm.call(method, &[]);
            }
            if vm.special(object, sym::GETITEM).is_none() || matches!(vm.plain(object), Value::Set(_) | Value::FrozenSet(_)) {
                return not_reversible(vm, object);
            }
            IterState::SequenceReversed { object, left: vm.len(object)? as i64 }
        }
        _ => return not_reversible(vm, object),
    };
    Ok(vm.new_iter(state))
}

fn not_reversible(vm: &mut Vm<'_>, object: Value) -> R<Value> {
    let name = vm.type_name(object);
    Err(vm.type_error(format!("'{name}' object is not reversible")))
}

fn next(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    match vm.next(args.at(0))? {
        Some(value) => Ok(value),
        None => Err(vm.stop_iteration()),
    }
}

/// How many items an iterator says it has left; `None` where it cannot tell.
pub fn length_hint(vm: &mut Vm<'_>, iter: Value) -> Option<u64> {
    let Value::Iter(r) = iter else { return None };
    let heap = &vm.heap;
    Some(match &heap[r].0 {
        IterState::Done(_) => 0,
        IterState::List { list, index } => heap[*list].0.len().saturating_sub(*index) as u64,
        IterState::ListReversed { left, .. } => *left as u64,
        IterState::Tuple { tuple, index } => heap[*tuple].0.len().saturating_sub(*index) as u64,
        IterState::Items { items, index } => items.len().saturating_sub(*index) as u64,
        IterState::Range { left, .. } => *left,
        IterState::BigRange { range, next } => u64::try_from(range.len() - next).unwrap_or(u64::MAX),
        IterState::Str { str, offset } => heap[*str].text.get(*offset..).map_or(0, |t| t.chars().count() as u64),
        IterState::Bytes { bytes, index } => heap[*bytes].0.len().saturating_sub(*index) as u64,
        IterState::ByteArray { bytes, index } => heap[*bytes].0.len().saturating_sub(*index) as u64,
        IterState::Dict { dict, position, .. } => remaining(&heap[*dict].0, *position),
        IterState::DictReversed { dict, position, .. } => heap[*dict].0.len() as u64 - remaining(&heap[*dict].0, *position),
        IterState::Set { set, position, .. } => remaining(&heap[*set].0, *position),
        IterState::SequenceReversed { left, .. } => *left as u64,
        IterState::Tool(tool) => tool.length_hint()?,
        _ => return None,
    })
}

fn remaining(table: &crate::python::table::Table, position: usize) -> u64 {
    (position..table.positions()).filter(|&p| table.at(p).is_some()).count() as u64
}

impl IterState {
    /// Its class.
    pub fn class(&self) -> Builtin {
        match self {
            IterState::Done(class) => *class,
            IterState::List { .. } => Builtin::ListIterator,
            IterState::ListReversed { .. } => Builtin::ListReverseIterator,
            IterState::Tuple { .. } | IterState::Items { .. } => Builtin::TupleIterator,
            IterState::Range { .. } => Builtin::RangeIterator,
            IterState::BigRange { .. } => Builtin::LongRangeIterator,
            IterState::Str { .. } => Builtin::StrIterator,
            IterState::Bytes { .. } => Builtin::BytesIterator,
            IterState::ByteArray { .. } => Builtin::ByteArrayIterator,
            IterState::Dict { kind: ViewKind::Keys, .. } => Builtin::DictKeyIterator,
            IterState::Dict { kind: ViewKind::Values, .. } => Builtin::DictValueIterator,
            IterState::Dict { kind: ViewKind::Items, .. } => Builtin::DictItemIterator,
            IterState::DictReversed { .. } => Builtin::DictReverseKeyIterator,
            IterState::Set { .. } => Builtin::SetIterator,
            IterState::Enumerate { .. } => Builtin::Enumerate,
            IterState::Zip { .. } => Builtin::Zip,
            IterState::Map { .. } => Builtin::Map,
            IterState::Filter { .. } => Builtin::Filter,
            IterState::Call { .. } => Builtin::CallableIterator,
            IterState::Sequence { .. } => Builtin::SequenceIterator,
            IterState::SequenceReversed { .. } => Builtin::Reversed,
            IterState::Tool(tool) => tool.class(),
        }
    }
}

const ITER: Native = Native::method("__iter__", 0, 0, |_, args| Ok(args.at(0)));
const NEXT: Native = Native::method("__next__", 0, 0, next);
const LENGTH_HINT: Native = Native::method("__length_hint__", 0, 0, |vm, args| match length_hint(vm, args.at(0)) {
    Some(n) => Ok(vm.heap.big(n.into())),
    None => Ok(Value::NotImplemented),
});

/// Methods of all native iterators.
pub const METHODS: &[Native] = &[ITER, NEXT, LENGTH_HINT];
/// Methods of `itertools.chain`.
pub const CHAIN: &[Native] = &[
    ITER,
    NEXT,
    Native::class_method("from_iterable", 1, 1, |vm, args| itertools::chain(vm, args.at(1))),
    Native::class_method("__class_getitem__", 1, ANY, |vm, args| Ok(vm.alias(args.at(0), args.at(1)))),
];
/// Methods of `itertools.count` and `itertools.repeat`, which show what they repeat.
pub const SHOWN: &[Native] = &[
    ITER,
    NEXT,
    LENGTH_HINT,
    Native::method("__repr__", 0, 0, |vm, args| {
        let text = itertools::repr(vm, args.at(0))?;
        Ok(vm.new_str(text))
    }),
];
