//! The builtin functions: `len`, `print`, `sorted` … Classes (`int`, `enumerate`) are in `types`.
//!
//! Functions that take numbers keep the handles of traced ones where the trace has an operation for what they do.

mod inspect;
mod numeric;

pub use numeric::abs;

use super::classes::Builtin;
use super::error::R;
use super::iter::IterState;
use super::native::{ANY, Args, Native};
use super::numbers;
use super::symbols::sym;
use super::types::list;
use super::value::{BinaryOp, CompareOp, Value};
use super::vm::Vm;
use crate::trace::{Op as TraceOp, apply};

/// All builtin functions.
pub static FUNCTIONS: &[Native] = &[
    Native::function("abs", 1, 1, numeric::abs),
    Native::function("all", 1, 1, |vm, args| quantify(vm, args.at(0), false)),
    Native::function("any", 1, 1, |vm, args| quantify(vm, args.at(0), true)),
    Native::function("ascii", 1, 1, |vm, args| {
        let text = vm.ascii(args.at(0))?;
        Ok(vm.new_str(text))
    }),
    Native::function("bin", 1, 1, |vm, args| numeric::in_radix(vm, args.at(0), "0b", 2)),
    Native::function("callable", 1, 1, inspect::callable),
    Native::function("chr", 1, 1, chr),
    Native::function("delattr", 2, 2, inspect::del_attr),
    Native::function("dir", 0, 1, inspect::dir),
    Native::function("divmod", 2, 2, numeric::divmod),
    Native::function("format", 1, 2, format),
    Native::function("getattr", 2, 3, inspect::get_attr),
    Native::function("globals", 0, 0, |vm, _| Ok(Value::Dict(vm.globals_dict()))),
    Native::function("hasattr", 2, 2, inspect::has_attr),
    Native::function("hash", 1, 1, |vm, args| Ok(Value::int(vm.hash(args.at(0))?))),
    Native::function("hex", 1, 1, |vm, args| numeric::in_radix(vm, args.at(0), "0x", 16)),
    Native::function("id", 1, 1, |vm, args| {
        let value = vm.pin(args.at(0));
        Ok(Value::int(vm.identity(value)))
    }),
    Native::function("isinstance", 2, 2, |vm, args| Ok(Value::Bool(vm.isinstance(args.at(0), args.at(1))?))),
    Native::function("issubclass", 2, 2, |vm, args| Ok(Value::Bool(inspect::is_subclass(vm, args.at(0), args.at(1))?))),
    Native::function("iter", 1, 2, iter),
    Native::function("len", 1, 1, |vm, args| Ok(Value::int(vm.len(args.at(0))? as i64))),
    Native::function("locals", 0, 0, |vm, _| Ok(Value::Dict(vm.locals_dict()))),
    Native::function("max", 1, ANY, |vm, args| extreme(vm, args, "max", CompareOp::Gt)).keywords(),
    Native::function("min", 1, ANY, |vm, args| extreme(vm, args, "min", CompareOp::Lt)).keywords(),
    Native::function("next", 1, 2, next),
    Native::function("oct", 1, 1, |vm, args| numeric::in_radix(vm, args.at(0), "0o", 8)),
    Native::function("ord", 1, 1, ord),
    Native::function("pow", 0, ANY, numeric::pow).keywords(),
    Native::function("print", 0, ANY, print).keywords(),
    Native::function("repr", 1, 1, |vm, args| {
        let text = vm.repr(args.at(0))?;
        Ok(vm.new_str(text))
    }),
    Native::function("round", 0, ANY, numeric::round).keywords(),
    Native::function("setattr", 3, 3, inspect::set_attr),
    Native::function("sorted", 0, ANY, list::sorted).keywords(),
    Native::function("sum", 0, ANY, sum).keywords(),
    Native::function("vars", 0, 1, inspect::vars),
];

/// Why a name of CPython's builtins is not there.
pub fn left_out(name: &str) -> Option<&'static str> {
    Some(match name {
        "open" => "PSDL programs cannot read or write files",
        "input" => "PSDL programs cannot ask for input",
        "exec" | "eval" | "compile" => "PSDL programs cannot run text as code",
        "breakpoint" => "PSDL programs cannot be stopped in a debugger",
        "exit" | "quit" => "a PSDL program ends where its text ends",
        "help" | "copyright" | "credits" | "license" => "it belongs to CPython's interactive session",
        "memoryview" => "PSDL programs have no memory views",
        "aiter" | "anext" => "PSDL leaves out async",
        _ => return None,
    })
}

/// `any` (`verdict` true) and `all` (`verdict` false): the truth that decides.
fn quantify(vm: &mut Vm<'_>, iterable: Value, verdict: bool) -> R<Value> {
    let mut decided = false;
    vm.for_each(iterable, |vm, item| {
        decided = vm.truth(item)? == verdict;
        Ok(!decided)
    })?;
    Ok(Value::Bool(decided == verdict))
}

fn chr(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let code = vm.index_big(args.at(0))?;
    let Ok(code) = i32::try_from(&code) else {
        return Err(vm.error(Builtin::OverflowError, "Python int too large to convert to C int".into()));
    };
    match u32::try_from(code).ok().filter(|&c| c <= 0x10_ffff) {
        None => Err(vm.value_error("chr() arg not in range(0x110000)")),
        Some(code) => match char::from_u32(code) {
            Some(c) => Ok(vm.new_str(c.to_string())),
            None => Err(vm.value_error("chr() arg is half of a surrogate pair: PSDL texts hold whole characters")),
        },
    }
}

fn ord(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (len, code) = match vm.plain(args.at(0)) {
        Value::Str(s) => (vm.heap[s].chars, vm.heap[s].text.chars().next().map_or(0, u32::from)),
        Value::Bytes(b) => (vm.heap[b].0.len(), vm.heap[b].0.first().copied().unwrap_or(0).into()),
        Value::ByteArray(b) => (vm.heap[b].0.len(), vm.heap[b].0.first().copied().unwrap_or(0).into()),
        other => {
            let name = vm.type_name(other);
            return Err(vm.type_error(format!("ord() expected string of length 1, but {name} found")));
        }
    };
    if len == 1 {
        Ok(Value::int(code.into()))
    } else {
        Err(vm.type_error(format!("ord() expected a character, but string of length {len} found")))
    }
}

fn format(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let spec = match args.get(1).map(|v| vm.plain(v)) {
        None => Box::default(),
        Some(Value::Str(s)) => vm.heap[s].text.clone(),
        Some(other) => {
            let name = vm.type_name(other);
            return Err(vm.type_error(format!("format() argument 2 must be str, not {name}")));
        }
    };
    let text = vm.format(args.at(0), &spec)?;
    Ok(vm.new_str(text))
}

fn iter(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some(sentinel) = args.get(1) else { return vm.iter(args.at(0)) };
    let function = args.at(0);
    if !inspect::is_callable(vm, function) {
        return Err(vm.type_error("iter(v, w): v must be callable"));
    }
    Ok(vm.new_iter(IterState::Call { function, sentinel }))
}

fn next(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    // The StopIteration of a generator or of `__next__` carries a value: it goes on as it is where there is no default.
    if args.get(1).is_none()
        && let Value::Instance(_) | Value::Generator(_) = args.at(0)
        && vm.special(args.at(0), sym::NEXT).is_some()
    {
        return vm.call_method(args.at(0), sym::NEXT, &[]);
    }
    match (vm.next(args.at(0))?, args.get(1)) {
        (Some(item), _) | (None, Some(item)) => Ok(item),
        (None, None) => Err(vm.stop_iteration()),
    }
}

/// `max` and `min`: the first item that no later one beats. The item keeps its handle; what was compared is guarded.
fn extreme(vm: &mut Vm<'_>, args: Args<'_>, name: &str, beats: CompareOp) -> R<Value> {
    let (mut key, mut default) = (None, None);
    for &(keyword, value) in args.kw {
        match keyword {
            sym::N_KEY => key = (!value.is_none()).then_some(value),
            sym::N_DEFAULT => default = Some(value),
            _ => {
                let keyword = vm.symbols.text(keyword).to_string();
                return Err(vm.type_error(format!("'{keyword}' is an invalid keyword argument for {name}()")));
            }
        }
    }
    let iterable = match *args.pos {
        [iterable] => iterable,
        [] => return Err(vm.type_error(format!("{name} expected at least 1 argument, got 0"))),
        _ if default.is_some() => {
            return Err(vm.type_error(format!("Cannot specify a default for {name}() with multiple positional arguments")));
        }
        _ => vm.new_tuple(args.pos),
    };
    let mut best: Option<(Value, Value)> = None;
    vm.for_each(iterable, |vm, item| {
        if let (None, Some((old, _))) = (key, best)
            && let Some(better) = traced_extreme(vm, beats, old, item)
        {
            best = Some((better, better));
            return Ok(true);
        }
        let rank = match key {
            Some(function) => vm.call(function, &[item])?,
            None => item,
        };
        let better = match best {
            None => true,
            Some((_, old)) => {
                let verdict = vm.compare(beats, rank, old)?;
                vm.truth(verdict)?
            }
        };
        if better {
            best = Some((item, rank));
        }
        Ok(true)
    })?;
    match best.map(|b| b.0).or(default) {
        Some(value) => Ok(value),
        None => Err(vm.value_error(format!("{name}() arg is an empty sequence"))),
    }
}

/// The greater or smaller of two numbers of one type as an operation of the record, where one of them is traced.
fn traced_extreme(vm: &mut Vm<'_>, beats: CompareOp, old: Value, item: Value) -> Option<Value> {
    if old.handle().is_none() && item.handle().is_none() {
        return None;
    }
    let op = if beats == CompareOp::Gt { TraceOp::Max } else { TraceOp::Min };
    match (old, item) {
        (Value::Float(a, h), Value::Float(b, k)) => {
            let value = apply(op, a, b);
            Some(Value::Float(value, vm.trace.binary(op, numbers::num(a, h), numbers::num(b, k), value)))
        }
        (Value::Int(a, h), Value::Int(b, k)) if a.unsigned_abs().max(b.unsigned_abs()) < 1 << 53 => {
            let (x, y) = (numbers::num(a as f64, h), numbers::num(b as f64, k));
            let value = apply(op, x.value, y.value);
            Some(Value::Int(value as i64, vm.trace.binary(op, x, y, value)))
        }
        _ => None,
    }
}

fn sum(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let given = args.pos.len() + args.kw.len();
    if args.pos.is_empty() {
        return Err(vm.type_error("sum() takes at least 1 positional argument (0 given)"));
    }
    if given > 2 {
        return Err(vm.type_error(format!("sum() takes at most 2 arguments ({given} given)")));
    }
    let [iterable, start] = vm.bind("sum", args, ["", "start"], 1)?;
    let mut total = start.unwrap_or(Value::int(0));
    let refused = match vm.plain(total) {
        Value::Str(_) => "sum() can't sum strings [use ''.join(seq) instead]",
        Value::Bytes(_) => "sum() can't sum bytes [use b''.join(seq) instead]",
        Value::ByteArray(_) => "sum() can't sum bytearray [use b''.join(seq) instead]",
        _ => "",
    };
    if !refused.is_empty() {
        return Err(vm.type_error(refused));
    }
    vm.for_each(iterable.unwrap_or(Value::None), |vm, item| {
        total = match (total, item) {
            (Value::Int(a, h), Value::Int(b, k)) if h.is_none() && k.is_none() && a.checked_add(b).is_some() => Value::int(a + b),
            (Value::Float(a, h), Value::Float(b, k)) if h.is_none() && k.is_none() => Value::float(a + b),
            _ => vm.binary(BinaryOp::Add, total, item)?,
        };
        Ok(true)
    })?;
    Ok(total)
}

fn print(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (mut sep, mut end, mut file) = (None, None, None);
    for &(name, value) in args.kw {
        let which = match name {
            sym::N_SEP => &mut sep,
            sym::N_END => &mut end,
            sym::N_FILE => &mut file,
            sym::N_FLUSH => continue,
            _ => {
                let name = vm.symbols.text(name).to_string();
                return Err(vm.type_error(format!("'{name}' is an invalid keyword argument for print()")));
            }
        };
        *which = (!value.is_none()).then_some(value);
    }
    let mut separator = |name: &str, value: Option<Value>, default: &str| match value.map(|v| vm.plain(v)) {
        None => Ok(Box::from(default)),
        Some(Value::Str(s)) => Ok(vm.heap[s].text.clone()),
        Some(other) => {
            let other = vm.type_name(other);
            Err(vm.type_error(format!("{name} must be None or a string, not {other}")))
        }
    };
    let (sep, end) = (separator("sep", sep, " ")?, separator("end", end, "\n")?);
    let mut line = String::new();
    for (i, &value) in args.pos.iter().enumerate() {
        if i > 0 {
            line += &sep;
        }
        line += &vm.str(value)?;
    }
    line += &end;
    vm.charge(line.len() as u64 / 16)?;
    match file {
        None => vm.write_output(&line)?,
        Some(file) => {
            let name = vm.symbols.intern("write");
            let line = vm.new_str(line);
            vm.call_method(file, name, &[line])?;
        }
    }
    Ok(Value::None)
}
