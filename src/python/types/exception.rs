//! Methods of exceptions.

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::native::{ANY, Args, Native};
use crate::python::symbols::sym;
use crate::python::value::Value;
use crate::python::vm::Vm;

/// `BaseException`
pub const METHODS: &[Native] = &[
    Native::raw("__init__", 0, ANY, init).keywords(),
    Native::raw("__str__", 0, 0, str),
    Native::raw("__repr__", 0, 0, repr),
    Native::raw("with_traceback", 1, 1, |vm, a| {
        if !a.at(1).is_none() && vm.class_of(a.at(1)) != Builtin::Traceback.class() {
            return Err(vm.type_error("__traceback__ must be a traceback or None"));
        }
        if a.at(1).is_none()
            && let Some(data) = vm.heap.exception_data_mut(a.at(0))
        {
            data.traceback.clear();
        }
        Ok(a.at(0))
    }),
    Native::raw("add_note", 1, 1, add_note),
    Native::getter("args", |vm, a| Ok(vm.heap.exception_data(a.at(0)).map_or(Value::None, |d| d.args))),
    Native::getter("__cause__", |vm, a| Ok(vm.heap.exception_data(a.at(0)).map_or(Value::None, |d| d.cause))),
    Native::getter("__context__", |vm, a| Ok(vm.heap.exception_data(a.at(0)).map_or(Value::None, |d| d.context))),
    Native::getter("__suppress_context__", |vm, a| Ok(Value::Bool(vm.heap.exception_data(a.at(0)).is_some_and(|d| d.suppress)))),
    Native::getter("__traceback__", |vm, a| Ok(vm.traceback(a.at(0)))),
    Native::raw("__setstate__", 1, 1, |_, _| Ok(Value::None)),
];

/// `KeyError`: its text is the key's repr.
pub const KEY_ERROR: &[Native] = &[Native::raw("__str__", 0, 0, |vm, a| {
    let args = arguments(vm, a.at(0));
    let text = match args.as_slice() {
        [key] => vm.repr(*key)?,
        _ => return str(vm, a),
    };
    Ok(vm.new_str(text))
})];

/// `StopIteration`
pub const STOP_ITERATION: &[Native] =
    &[Native::getter("value", |vm, a| Ok(arguments(vm, a.at(0)).first().copied().unwrap_or(Value::None)))];

/// `SystemExit`
pub const SYSTEM_EXIT: &[Native] = &[Native::getter("code", |vm, a| {
    let args = arguments(vm, a.at(0));
    Ok(match args.as_slice() {
        [] => Value::None,
        [one] => *one,
        _ => vm.new_tuple(args),
    })
})];

/// `AttributeError(…, name=, obj=)`
pub const ATTRIBUTE_ERROR: &[Native] = &[Native::raw("__init__", 0, ANY, init_with_fields).keywords()];

/// `NameError(…, name=)`
pub const NAME_ERROR: &[Native] = &[Native::raw("__init__", 0, ANY, init_with_fields).keywords()];

/// `ImportError(…, name=, path=)`
pub const IMPORT_ERROR: &[Native] = &[
    Native::raw("__init__", 0, ANY, init_with_fields).keywords(),
    Native::getter("msg", |vm, a| {
        let args = arguments(vm, a.at(0));
        Ok(if args.len() == 1 { args[0] } else { Value::None })
    }),
];

/// `SyntaxError(message, (file, line, offset, text, end line, end offset))`
pub const SYNTAX_ERROR: &[Native] = &[
    Native::getter("msg", |vm, a| Ok(arguments(vm, a.at(0)).first().copied().unwrap_or(Value::None))),
    Native::getter("filename", |vm, a| Ok(syntax_part(vm, a, 0))),
    Native::getter("lineno", |vm, a| Ok(syntax_part(vm, a, 1))),
    Native::getter("offset", |vm, a| Ok(syntax_part(vm, a, 2))),
    Native::getter("text", |vm, a| Ok(syntax_part(vm, a, 3))),
    Native::getter("end_lineno", |vm, a| Ok(syntax_part(vm, a, 4))),
    Native::getter("end_offset", |vm, a| Ok(syntax_part(vm, a, 5))),
    Native::raw("__str__", 0, 0, |vm, a| {
        let message = arguments(vm, a.at(0)).first().copied();
        let mut text = match message {
            Some(message) => vm.str(message)?,
            None => vm.str(Value::None)?,
        };
        let (file, line) = (syntax_part(vm, a, 0), syntax_part(vm, a, 1));
        match (file, line) {
            (Value::Str(file), Value::Int(line, _)) => text.push_str(&format!(" ({}, line {line})", vm.heap[file].text)),
            (Value::Str(file), _) => text.push_str(&format!(" ({})", vm.heap[file].text)),
            (_, Value::Int(line, _)) => text.push_str(&format!(" (line {line})")),
            _ => {}
        }
        Ok(vm.new_str(text))
    }),
];

fn syntax_part(vm: &mut Vm<'_>, args: Args<'_>, part: usize) -> Value {
    let place = arguments(vm, args.at(0)).get(1).copied();
    match place {
        Some(Value::Tuple(t)) => vm.heap[t].0.get(part).copied().unwrap_or(Value::None),
        _ => Value::None,
    }
}

/// `OSError(errno, strerror)`
pub const OS_ERROR: &[Native] = &[
    Native::static_method("__new__", 1, ANY, new_os_error).keywords(),
    Native::getter("errno", |vm, a| Ok(os_part(vm, a, 0))),
    Native::getter("strerror", |vm, a| Ok(os_part(vm, a, 1))),
    Native::raw("__init__", 0, ANY, init_os_error),
    Native::getter("filename", |vm, a| Ok(os_file(vm, a.at(0)))),
    Native::raw("__str__", 0, 0, |vm, a| {
        let args = arguments(vm, a.at(0));
        if args.len() < 2 {
            return str(vm, a);
        }
        let mut text = format!("[Errno {}] {}", vm.str(args[0])?, vm.str(args[1])?);
        let file = os_file(vm, a.at(0));
        if !file.is_none() {
            text.push_str(&format!(": {}", vm.repr(file)?));
        }
        Ok(vm.new_str(text))
    }),
];

/// `ExceptionGroup(message, exceptions)`
pub const GROUP: &[Native] = &[
    Native::static_method("__new__", 1, 3, new_group),
    Native::raw("__init__", 0, ANY, |_, _| Ok(Value::None)),
    Native::raw("__str__", 0, 0, |vm, a| {
        let args = arguments(vm, a.at(0));
        let count = members(vm, a.at(0)).len();
        let text = format!("{} ({count} sub-exception{})", vm.str(args[0])?, if count == 1 { "" } else { "s" });
        Ok(vm.new_str(text))
    }),
    Native::getter("message", |vm, a| Ok(arguments(vm, a.at(0)).first().copied().unwrap_or(Value::None))),
    Native::getter("exceptions", |vm, a| {
        let members = members(vm, a.at(0));
        Ok(vm.new_tuple(members))
    }),
    Native::raw("derive", 1, 1, |vm, a| {
        let message = arguments(vm, a.at(0)).first().copied().unwrap_or(Value::None);
        vm.call(Builtin::BaseExceptionGroup.value(), &[message, a.at(1)])
    }),
    Native::raw("split", 1, 1, |vm, a| {
        let (matched, rest) = split(vm, a.at(0), a.at(1))?;
        Ok(vm.new_tuple([matched, rest].as_slice()))
    }),
    Native::raw("subgroup", 1, 1, |vm, a| split(vm, a.at(0), a.at(1)).map(|p| p.0)),
    Native::class_method("__class_getitem__", 1, 1, |vm, a| {
        Ok(Value::Alias(vm.heap.alloc(Alias { origin: a.at(0), args: vec![a.at(1)] })))
    }),
];

fn arguments(vm: &Vm<'_>, exception: Value) -> Vec<Value> {
    match vm.heap.exception_data(exception).map(|d| d.args) {
        Some(Value::Tuple(t)) => vm.heap[t].0.to_vec(),
        _ => Vec::new(),
    }
}

fn init(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if !args.kw.is_empty() {
        let class = vm.type_name(args.at(0));
        return Err(vm.type_error(format!("{class}() takes no keyword arguments")));
    }
    set_args(vm, args)
}

fn set_args(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let tuple = vm.new_tuple(&args.pos[1..]);
    if let Some(data) = vm.heap.exception_data_mut(args.at(0)) {
        data.args = tuple;
    }
    Ok(Value::None)
}

fn init_with_fields(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    set_args(vm, args)?;
    let is_import = vm.is_instance(args.at(0), Builtin::ImportError);
    for &(name, value) in args.kw {
        if !matches!(name, sym::N_NAME | sym::N_OBJ | sym::N_PATH) {
            let class = vm.type_name(args.at(0));
            let message = format!("'{}' is an invalid keyword argument for {class}()", vm.symbols.text(name));
            return Err(vm.type_error(message));
        }
        vm.set_own_attr(args.at(0), name, value);
    }
    for name in if is_import { [sym::N_NAME, sym::N_PATH] } else { [sym::N_NAME, sym::N_OBJ] } {
        if let Value::Instance(i) = args.at(0)
            && vm.own_attr(i, name).is_none()
        {
            vm.set_own_attr(args.at(0), name, Value::None);
        }
    }
    Ok(Value::None)
}

fn str(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let items = arguments(vm, args.at(0));
    let text = match items.as_slice() {
        [] => String::new(),
        [one] => vm.str(*one)?,
        _ => {
            let tuple = vm.new_tuple(items);
            vm.repr(tuple)?
        }
    };
    Ok(vm.new_str(text))
}

fn repr(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let items = arguments(vm, args.at(0));
    let shown = match items.as_slice() {
        [one] => format!("({})", vm.repr(*one)?),
        _ => {
            let tuple = vm.new_tuple(items);
            vm.repr(tuple)?
        }
    };
    let text = format!("{}{shown}", vm.type_name(args.at(0)));
    Ok(vm.new_str(text))
}

fn add_note(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let note = args.at(1);
    if !matches!(vm.plain(note), Value::Str(_)) {
        let message = format!("note must be a str, not '{}'", vm.type_name(note));
        return Err(vm.type_error(message));
    }
    let notes = match vm.get_attr_opt(args.at(0), sym::NOTES)? {
        Some(Value::List(l)) => l,
        _ => {
            let list = vm.heap.alloc(List::default());
            vm.set_own_attr(args.at(0), sym::NOTES, Value::List(list));
            list
        }
    };
    vm.list_push(notes, note)?;
    Ok(Value::None)
}

/// `OSError(2, …)` is a FileNotFoundError, and so on.
fn new_os_error(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Value::Class(class) = args.at(0) else { return Err(vm.type_error("the first argument must be a class")) };
    let rest = Args { pos: &args.pos[1..], kw: args.kw };
    let special = match rest.pos {
        [Value::Int(errno, _), _, ..] if class == Builtin::OSError.class() => match errno {
            1 | 13 => Some(Builtin::PermissionError),
            2 => Some(Builtin::FileNotFoundError),
            3 => Some(Builtin::ProcessLookupError),
            4 => Some(Builtin::InterruptedError),
            10 => Some(Builtin::ChildProcessError),
            11 | 114 | 115 => Some(Builtin::BlockingIOError),
            17 => Some(Builtin::FileExistsError),
            20 => Some(Builtin::NotADirectoryError),
            21 => Some(Builtin::IsADirectoryError),
            32 | 108 => Some(Builtin::BrokenPipeError),
            103 => Some(Builtin::ConnectionAbortedError),
            104 => Some(Builtin::ConnectionResetError),
            110 => Some(Builtin::TimeoutError),
            111 => Some(Builtin::ConnectionRefusedError),
            _ => None,
        },
        _ => None,
    };
    vm.default_new(special.map_or(class, Builtin::class), rest)
}

/// The file stands beside the arguments.
fn init_os_error(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let count = if args.pos.len() > 3 { 3 } else { args.pos.len() };
    init(vm, Args { pos: &args.pos[..count], kw: args.kw })?;
    if let Some(file) = args.get(3) {
        let name = vm.symbols.intern(FILE);
        vm.set_own_attr(args.at(0), name, file);
    }
    Ok(Value::None)
}

/// The file of an OSError.
fn os_file(vm: &mut Vm<'_>, exception: Value) -> Value {
    let name = vm.symbols.intern(FILE);
    match exception {
        Value::Instance(i) => vm.own_attr(i, name).unwrap_or(Value::None),
        _ => Value::None,
    }
}

/// No name that a program could write.
const FILE: &str = ".filename";

fn os_part(vm: &Vm<'_>, args: Args<'_>, part: usize) -> Value {
    let items = arguments(vm, args.at(0));
    if items.len() < 2 { Value::None } else { items.get(part).copied().unwrap_or(Value::None) }
}

/// The exceptions of a group.
pub(crate) fn members(vm: &Vm<'_>, group: Value) -> Vec<Value> {
    match arguments(vm, group).get(1) {
        Some(Value::Tuple(t)) => vm.heap[*t].0.to_vec(),
        Some(Value::List(l)) => vm.heap[*l].0.clone(),
        _ => Vec::new(),
    }
}

fn new_group(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Value::Class(class) = args.at(0) else { return Err(vm.type_error("the first argument must be a class")) };
    let name = vm.class_name(class);
    if args.pos.len() != 3 {
        return Err(vm.type_error(format!("BaseExceptionGroup.__new__() takes exactly 2 arguments ({} given)", args.pos.len() - 1)));
    }
    let (message, given) = (args.at(1), args.at(2));
    if !matches!(vm.plain(message), Value::Str(_)) {
        let message = format!("BaseExceptionGroup.__new__() argument 1 must be str, not {}", vm.type_name(message));
        return Err(vm.type_error(message));
    }
    if !matches!(vm.plain(given), Value::List(_) | Value::Tuple(_)) {
        return Err(vm.type_error("second argument (exceptions) must be a sequence"));
    }
    let items = vm.collect(given)?;
    if items.is_empty() {
        return Err(vm.value_error("second argument (exceptions) must be a non-empty sequence"));
    }
    if let Some(i) = items.iter().position(|e| !vm.is_instance(*e, Builtin::BaseException)) {
        return Err(vm.value_error(format!("Item {i} of second argument (exceptions) is not an exception")));
    }
    let all_plain = items.iter().all(|e| vm.is_instance(*e, Builtin::Exception));
    let class = match class {
        c if c == Builtin::BaseExceptionGroup.class() && all_plain => Builtin::ExceptionGroup.class(),
        c if vm.is_subclass(c, Builtin::Exception.class()) && !all_plain => {
            return Err(vm.type_error(format!("Cannot nest BaseExceptions in an {name}")));
        }
        c => c,
    };
    let args = vm.new_tuple([message, given].as_slice());
    Ok(vm.heap.exception(class, args))
}

/// Whether a leaf matches a condition: a class, a tuple of classes, or a function.
fn fits(vm: &mut Vm<'_>, exception: Value, condition: Value) -> R<bool> {
    match condition {
        Value::Class(_) | Value::Tuple(_) => vm.exception_matches(exception, condition),
        function
            if vm.special(function, sym::CALL).is_none()
                && !matches!(function, Value::Function(_) | Value::Native(_) | Value::Method(_)) =>
        {
            Err(vm.type_error("expected a function, exception type or tuple of exception types"))
        }
        function => {
            let said = vm.call(function, &[exception])?;
            vm.truth(said)
        }
    }
}

/// What of a group fits a condition, and what does not; None for an empty part.
fn split(vm: &mut Vm<'_>, group: Value, condition: Value) -> R<(Value, Value)> {
    if fits(vm, group, condition)? {
        return Ok((group, Value::None));
    }
    let (mut yes, mut no) = (Vec::new(), Vec::new());
    for member in members(vm, group) {
        if vm.is_instance(member, Builtin::BaseExceptionGroup) {
            let (a, b) = vm.nested("", |vm| split(vm, member, condition))?;
            yes.extend(Some(a).filter(|v| !v.is_none()));
            no.extend(Some(b).filter(|v| !v.is_none()));
        } else if fits(vm, member, condition)? {
            yes.push(member);
        } else {
            no.push(member);
        }
    }
    let yes = derived(vm, group, yes)?;
    let no = derived(vm, group, no)?;
    Ok((yes, no))
}

/// A group like this one around other members.
fn derived(vm: &mut Vm<'_>, group: Value, members: Vec<Value>) -> R<Value> {
    if members.is_empty() {
        return Ok(Value::None);
    }
    let list = vm.new_list(members);
    let derive = vm.symbols.intern("derive");
    let made = vm.call_method(group, derive, &[list])?;
    let old = vm.heap.exception_data(group).cloned();
    let notes = vm.get_attr_opt(group, sym::NOTES)?;
    if let (Some(old), Some(data)) = (old, vm.heap.exception_data_mut(made)) {
        data.cause = old.cause;
        data.context = old.context;
        data.suppress = old.suppress;
        data.traceback = old.traceback;
    }
    if let Some(notes) = notes {
        let copy = vm.collect(notes)?;
        let copy = vm.new_list(copy);
        vm.set_own_attr(made, sym::NOTES, copy);
    }
    Ok(made)
}

/// A group like this one with only these leaves.
pub(crate) fn project(vm: &mut Vm<'_>, group: Value, leaves: &[Value]) -> R<Value> {
    let mut kept = Vec::new();
    for member in members(vm, group) {
        if vm.is_instance(member, Builtin::BaseExceptionGroup) {
            let inner = vm.nested("", |vm| project(vm, member, leaves))?;
            kept.extend(Some(inner).filter(|v| !v.is_none()));
        } else if leaves.iter().any(|l| l.is(member)) {
            kept.push(member);
        }
    }
    if kept.len() == members(vm, group).len() && kept.iter().zip(members(vm, group)).all(|(a, b)| a.is(b)) {
        return Ok(group);
    }
    derived(vm, group, kept)
}
