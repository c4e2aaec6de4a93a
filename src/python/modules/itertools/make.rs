//! How the iterators of `itertools` are made from their arguments.

use super::choose::{Choice, Kind};
use super::{Tool, tool};
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::List;
use crate::python::iter::IterState;
use crate::python::iterate::VALUE;
use crate::python::modules::Item;
use crate::python::native::{Args, Native};
use crate::python::symbols::sym;
use crate::python::types::iterator::{iterators, positional};
use crate::python::value::Value;
use crate::python::vm::Vm;

fn made(vm: &mut Vm<'_>, tool: Tool) -> Value {
    vm.new_iter(IterState::Tool(Box::new(tool)))
}

/// `chain.from_iterable(iterable)`
pub fn chain(vm: &mut Vm<'_>, iterable: Value) -> R<Value> {
    let source = vm.iter(iterable)?;
    Ok(made(vm, Tool::Chain { source, current: Value::Undefined }))
}

/// An iterator of the builtin class number `class`; `None` where that is none of `itertools`.
pub fn construct(vm: &mut Vm<'_>, class: u32, args: Args<'_>) -> R<Option<Value>> {
    type Make = fn(&mut Vm<'_>, Args<'_>) -> R<Tool>;
    const CLASSES: &[(Builtin, Make)] = &[
        (Builtin::ToolAccumulate, accumulate),
        (Builtin::ToolChain, |vm, args| {
            positional(vm, "chain", &args, 0, usize::MAX)?;
            let iterables = vm.new_tuple(args.pos);
            let source = vm.iter(iterables)?;
            Ok(Tool::Chain { source, current: Value::Undefined })
        }),
        (Builtin::ToolCombinations, |vm, args| choose(vm, "combinations", Kind::Combinations, args)),
        (Builtin::ToolCombinationsWithReplacement, |vm, args| {
            choose(vm, "combinations_with_replacement", Kind::CombinationsWithReplacement, args)
        }),
        (Builtin::ToolPermutations, |vm, args| choose(vm, "permutations", Kind::Permutations, args)),
        (Builtin::ToolProduct, product),
        (Builtin::ToolCompress, |vm, args| {
            let [data, selectors] = vm.bind("compress", args, ["data", "selectors"], 2)?;
            let data = vm.iter(data.unwrap_or(Value::None))?;
            Ok(Tool::Compress { data, selectors: vm.iter(selectors.unwrap_or(Value::None))? })
        }),
        (Builtin::ToolCount, count),
        (Builtin::ToolCycle, |vm, args| {
            positional(vm, "cycle", &args, 1, 1)?;
            Ok(Tool::Cycle { iter: vm.iter(args.at(0))?, saved: Vec::new(), index: 0, ended: false })
        }),
        (Builtin::ToolDropwhile, |vm, args| {
            let [predicate, iter] = predicate(vm, "dropwhile", args)?;
            Ok(Tool::DropWhile { predicate, iter, dropped: false })
        }),
        (Builtin::ToolTakewhile, |vm, args| {
            let [predicate, iter] = predicate(vm, "takewhile", args)?;
            Ok(Tool::TakeWhile { predicate, iter, over: false })
        }),
        (Builtin::ToolFilterfalse, |vm, args| {
            let [predicate, iter] = predicate(vm, "filterfalse", args)?;
            Ok(Tool::FilterFalse { predicate, iter })
        }),
        (Builtin::ToolStarmap, |vm, args| {
            let [function, iter] = predicate(vm, "starmap", args)?;
            Ok(Tool::StarMap { function, iter })
        }),
        (Builtin::ToolGroupby, |vm, args| {
            let [iterable, key] = vm.bind("groupby", args, ["iterable", "key"], 1)?;
            let (iter, unset) = (vm.iter(iterable.unwrap_or(Value::None))?, Value::Undefined);
            Ok(Tool::GroupBy { iter, key: key.unwrap_or(Value::None), target: unset, current_key: unset, current: unset, group: None })
        }),
        (Builtin::ToolIslice, slice),
        (Builtin::ToolPairwise, |vm, args| {
            positional(vm, "pairwise", &args, 1, 1)?;
            Ok(Tool::Pairwise { iter: vm.iter(args.at(0))?, old: Value::Undefined })
        }),
        (Builtin::ToolRepeat, |vm, args| {
            let [object, times] = vm.bind("repeat", args, ["object", "times"], 1)?;
            let left = match times {
                Some(times) => Some(vm.index(times)?.max(0) as u64),
                None => None,
            };
            Ok(Tool::Repeat { value: object.unwrap_or(Value::None), left })
        }),
        (Builtin::ToolZipLongest, zip_longest),
    ];
    match CLASSES.iter().find(|c| c.0 as u32 == class) {
        Some((_, make)) => {
            let tool = make(vm, args)?;
            Ok(Some(made(vm, tool)))
        }
        None => Ok(None),
    }
}

fn predicate(vm: &mut Vm<'_>, name: &str, args: Args<'_>) -> R<[Value; 2]> {
    positional(vm, name, &args, 2, 2)?;
    Ok([args.at(0), vm.iter(args.at(1))?])
}

fn accumulate(vm: &mut Vm<'_>, args: Args<'_>) -> R<Tool> {
    if args.pos.len() > 2 {
        return Err(vm.type_error(format!("accumulate() takes at most 2 positional arguments ({} given)", args.pos.len())));
    }
    let [iterable, function, initial] = vm.bind("accumulate", args, ["iterable", "func", "initial"], 1)?;
    let iter = vm.iter(iterable.unwrap_or(Value::None))?;
    Ok(Tool::Accumulate {
        iter,
        function: function.unwrap_or(Value::None),
        total: Value::Undefined,
        initial: initial.filter(|v| !v.is_none()),
    })
}

fn count(vm: &mut Vm<'_>, args: Args<'_>) -> R<Tool> {
    let [start, step] = vm.bind("count", args, ["start", "step"], 0)?;
    let mut number = |value: Option<Value>, default: i64| match value {
        None => Ok(Value::int(default)),
        Some(Value::Bool(b)) => Ok(Value::int(b.into())),
        Some(v @ (Value::Int(..) | Value::Float(..) | Value::Big(_) | Value::Complex(_))) => Ok(v),
        Some(v @ Value::Instance(_)) if [sym::INDEX, sym::FLOAT, sym::INT].iter().any(|&s| vm.special(v, s).is_some()) => Ok(v),
        Some(_) => Err(vm.type_error("a number is required")),
    };
    Ok(Tool::Count { next: number(start, 0)?, step: number(step, 1)? })
}

fn choose(vm: &mut Vm<'_>, name: &str, kind: Kind, args: Args<'_>) -> R<Tool> {
    let required = if kind == Kind::Permutations { 1 } else { 2 };
    let [iterable, r] = vm.bind(name, args, ["iterable", "r"], required)?;
    let pool = vm.collect(iterable.unwrap_or(Value::None))?;
    let size = match r {
        None | Some(Value::None) if kind == Kind::Permutations => pool.len() as i64,
        Some(Value::Float(..) | Value::Str(_)) if kind == Kind::Permutations => return Err(vm.type_error("Expected int as r")),
        r => vm.index(r.unwrap_or(Value::None))?,
    };
    if size < 0 {
        return Err(vm.value_error("r must be non-negative"));
    }
    if kind == Kind::CombinationsWithReplacement {
        vm.reserve((size as usize).saturating_mul(2 * VALUE))?;
    }
    Ok(Tool::Choose(Choice::new(kind, vec![pool], size as usize)))
}

fn product(vm: &mut Vm<'_>, args: Args<'_>) -> R<Tool> {
    let mut repeat = 1;
    for &(name, value) in args.kw {
        if name != sym::N_REPEAT {
            let name = vm.symbols.text(name).to_string();
            return Err(vm.type_error(format!("'{name}' is an invalid keyword argument for product()")));
        }
        repeat = vm.index(value)?;
    }
    if repeat < 0 {
        return Err(vm.value_error("repeat argument cannot be negative"));
    }
    let mut pools = Vec::new();
    for &iterable in args.pos {
        pools.push(vm.collect(iterable)?);
    }
    let size = pools.len().saturating_mul(repeat as usize);
    vm.reserve(size.saturating_mul(2 * VALUE))?;
    Ok(Tool::Choose(Choice::new(Kind::Product, pools, size)))
}

fn slice(vm: &mut Vm<'_>, args: Args<'_>) -> R<Tool> {
    positional(vm, "islice", &args, 2, 4)?;
    let mut bound = |value: Value, what: &str| -> R<Option<u64>> {
        let good = match vm.pin(value) {
            Value::None => return Ok(None),
            Value::Int(v, _) => u64::try_from(v).ok(),
            Value::Bool(b) => Some(b.into()),
            other @ Value::Instance(_) => vm.index(other).ok().and_then(|v| u64::try_from(v).ok()),
            _ => None,
        };
        match good {
            Some(v) => Ok(Some(v)),
            None => Err(vm.value_error(format!("{what} must be None or an integer: 0 <= x <= sys.maxsize."))),
        }
    };
    let (start, stop) = match *args.pos {
        [_, stop] => (0, bound(stop, "Stop argument for islice()")?),
        [_, start, stop, ..] => {
            let stop = bound(stop, "Stop argument for islice()")?;
            (bound(start, "Indices for islice()")?.unwrap_or(0), stop)
        }
        _ => (0, None),
    };
    let step = match args.get(3) {
        None | Some(Value::None) => 1,
        Some(step) => match vm.pin(step) {
            Value::Int(v, _) if v > 0 => v as u64,
            Value::Bool(true) => 1,
            _ => return Err(vm.value_error("Step for islice() must be a positive integer or None.")),
        },
    };
    Ok(Tool::Slice { iter: vm.iter(args.at(0))?, taken: 0, next: start, stop, step })
}

fn zip_longest(vm: &mut Vm<'_>, args: Args<'_>) -> R<Tool> {
    let mut fill = Value::None;
    for &(name, value) in args.kw {
        if vm.symbols.text(name) != "fillvalue" {
            return Err(vm.type_error("zip_longest() got an unexpected keyword argument"));
        }
        fill = value;
    }
    Ok(Tool::ZipLongest { iters: iterators(vm, args.pos)?, fill })
}

/// `tee(iterable, n=2)`
fn tee(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let n = match args.get(1) {
        Some(n) => vm.index(n)?,
        None => 2,
    };
    if n < 0 {
        return Err(vm.value_error("n must be >= 0"));
    }
    vm.reserve((n as usize).saturating_mul(4 * VALUE))?;
    let source = vm.iter(args.at(0))?;
    // A tee of a tee shares its buffer.
    let (source, buffer, index) = match tool(vm, source) {
        Some(Tool::Tee { source, buffer, index }) => (source, buffer, index),
        _ => (source, vm.heap.alloc(List::default()), 0),
    };
    let all: Vec<Value> = (0..n).map(|_| made(vm, Tool::Tee { source, buffer, index })).collect();
    Ok(vm.new_tuple(all))
}

static TEE: Native = Native::function("tee", 1, 2, tee);

/// What `import itertools` brings.
pub const ITEMS: &[(&str, Item)] = &[
    ("accumulate", Item::Class(Builtin::ToolAccumulate)),
    ("chain", Item::Class(Builtin::ToolChain)),
    ("combinations", Item::Class(Builtin::ToolCombinations)),
    ("combinations_with_replacement", Item::Class(Builtin::ToolCombinationsWithReplacement)),
    ("compress", Item::Class(Builtin::ToolCompress)),
    ("count", Item::Class(Builtin::ToolCount)),
    ("cycle", Item::Class(Builtin::ToolCycle)),
    ("dropwhile", Item::Class(Builtin::ToolDropwhile)),
    ("filterfalse", Item::Class(Builtin::ToolFilterfalse)),
    ("groupby", Item::Class(Builtin::ToolGroupby)),
    ("islice", Item::Class(Builtin::ToolIslice)),
    ("pairwise", Item::Class(Builtin::ToolPairwise)),
    ("permutations", Item::Class(Builtin::ToolPermutations)),
    ("product", Item::Class(Builtin::ToolProduct)),
    ("repeat", Item::Class(Builtin::ToolRepeat)),
    ("starmap", Item::Class(Builtin::ToolStarmap)),
    ("takewhile", Item::Class(Builtin::ToolTakewhile)),
    ("tee", Item::Native(&TEE)),
    ("zip_longest", Item::Class(Builtin::ToolZipLongest)),
];
