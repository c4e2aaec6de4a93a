//! Methods of `object` and `type`, and of the aliases `list[int]` and `int | str`.

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::native::{ANY, Args, Native};
use crate::python::symbols::sym;
use crate::python::value::Value;
use crate::python::vm::Vm;

/// Methods that every object has.
pub const OBJECT: &[Native] = &[
    Native::static_method("__new__", 0, ANY, new).keywords(),
    Native::raw("__init__", 0, ANY, init).keywords(),
    Native::raw("__repr__", 0, 0, |vm, a| {
        let text = vm.default_repr(a.at(0));
        Ok(vm.new_str(text))
    }),
    Native::raw("__str__", 0, 0, |vm, a| {
        let text = vm.repr(a.at(0))?;
        Ok(vm.new_str(text))
    }),
    Native::raw("__format__", 1, 1, format),
    Native::raw("__eq__", 1, 1, |_, a| Ok(if a.at(0).is(a.at(1)) { Value::Bool(true) } else { Value::NotImplemented })),
    Native::raw("__ne__", 1, 1, not_equal),
    Native::raw("__lt__", 1, 1, not_implemented),
    Native::raw("__le__", 1, 1, not_implemented),
    Native::raw("__gt__", 1, 1, not_implemented),
    Native::raw("__ge__", 1, 1, not_implemented),
    Native::raw("__hash__", 0, 0, |vm, a| Ok(Value::int(vm.identity(a.at(0))))),
    Native::raw("__getattribute__", 1, 1, get_attribute),
    Native::raw("__setattr__", 2, 2, set_attribute),
    Native::raw("__delattr__", 1, 1, delete_attribute),
    Native::raw("__dir__", 0, 0, |vm, a| {
        let names = vm.dir_names(a.at(0))?;
        let values = names.into_iter().map(|n| vm.new_str(n)).collect();
        Ok(vm.new_list(values))
    }),
    Native::raw("__sizeof__", 0, 0, |_, _| Ok(Value::int(16))),
    Native::class_method("__init_subclass__", 0, 0, init_subclass).keywords(),
    Native::class_method("__subclasshook__", 1, 1, |_, _| Ok(Value::NotImplemented)),
];

/// Methods of classes.
pub const TYPE: &[Native] = &[
    Native::static_method("__new__", 1, ANY, new_type).keywords(),
    Native::raw("__init__", 0, ANY, |_, _| Ok(Value::None)).keywords(),
    Native::raw("__call__", 0, ANY, |vm, a| match a.at(0) {
        Value::Class(c) => vm.make_instance(c, Args { pos: &a.pos[1..], kw: a.kw }),
        _ => Err(vm.type_error("descriptor '__call__' requires a 'type' object")),
    })
    .keywords(),
    Native::class_method("__prepare__", 0, ANY, |vm, _| Ok(Value::Dict(vm.heap.dict()))).keywords(),
    Native::raw("__repr__", 0, 0, |vm, a| {
        let text = vm.default_repr(a.at(0));
        Ok(vm.new_str(text))
    }),
    Native::raw("__instancecheck__", 1, 1, |vm, a| vm.plain_isinstance(a.at(1), a.at(0)).map(Value::Bool)),
    Native::raw("__subclasscheck__", 1, 1, |vm, a| {
        Ok(Value::Bool(match (a.at(1), a.at(0)) {
            (Value::Class(c), Value::Class(of)) => vm.is_subclass(c, of),
            _ => return Err(vm.type_error("issubclass() arg 1 must be a class")),
        }))
    }),
    Native::raw("__subclasses__", 0, 0, |vm, a| {
        let Value::Class(c) = a.at(0) else { return Ok(Value::None) };
        let items = vm.heap[c].subclasses.iter().map(|s| Value::Class(*s)).collect();
        Ok(vm.new_list(items))
    }),
    Native::raw("mro", 0, 0, |vm, a| {
        let Value::Class(c) = a.at(0) else { return Ok(Value::None) };
        let items = vm.heap[c].mro.iter().map(|s| Value::Class(*s)).collect();
        Ok(vm.new_list(items))
    }),
    Native::raw("__or__", 1, 1, |vm, a| union(vm, a.at(0), a.at(1))),
    Native::raw("__ror__", 1, 1, |vm, a| union(vm, a.at(1), a.at(0))),
    Native::raw("__setattr__", 2, 2, set_attribute),
    Native::raw("__getattribute__", 1, 1, get_attribute),
    Native::raw("__dir__", 0, 0, |vm, a| {
        let names = vm.dir_names(a.at(0))?;
        let values = names.into_iter().map(|n| vm.new_str(n)).collect();
        Ok(vm.new_list(values))
    }),
];

/// Methods of `list[int]` and `int | str`.
pub const ALIAS: &[Native] = &[
    Native::raw("__or__", 1, 1, |vm, a| union(vm, a.at(0), a.at(1))),
    Native::raw("__ror__", 1, 1, |vm, a| union(vm, a.at(1), a.at(0))),
    Native::raw("__eq__", 1, 1, alias_equal),
    Native::raw("__hash__", 0, 0, |vm, a| {
        let text = vm.default_repr(a.at(0));
        let text = vm.new_str(text);
        vm.hash(text).map(Value::int)
    }),
    Native::raw("__repr__", 0, 0, |vm, a| {
        let text = vm.default_repr(a.at(0));
        Ok(vm.new_str(text))
    }),
    Native::raw("__instancecheck__", 1, 1, |vm, a| vm.isinstance(a.at(1), a.at(0)).map(Value::Bool)),
    Native::raw("__mro_entries__", 1, 1, |vm, a| {
        let Value::Alias(alias) = a.at(0) else { return Ok(Value::None) };
        let origin = vm.heap[alias].origin;
        Ok(vm.new_tuple([origin].as_slice()))
    }),
];

/// `Class.__new__(cls, ...)` of the builtin types; each that holds a value lists it as its own.
pub(super) fn new(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Some(first) = args.get(0) else { return Err(vm.type_error("object.__new__(): not enough arguments")) };
    let Value::Class(class) = first else {
        let message = format!("object.__new__(X): X is not a type object ({})", vm.type_name(first));
        return Err(vm.type_error(message));
    };
    let layout = vm.heap[class].layout;
    if matches!(layout, Layout::Int | Layout::Float | Layout::Complex | Layout::Str | Layout::Tuple | Layout::List | Layout::Dict) {
        let builtin = vm.heap[class].mro.iter().copied().find(|c| vm.heap[*c].builtin).unwrap_or(class);
        let (name, wanted) = (vm.class_name(class), vm.class_name(builtin));
        return Err(vm.type_error(format!("object.__new__({name}) is not safe, use {wanted}.__new__()")));
    }
    vm.default_new(class, Args { pos: &args.pos[1..], kw: args.kw })
}

/// `int.__new__(cls, ...)` and its like.
pub(super) fn new_builtin(vm: &mut Vm<'_>, args: Args<'_>, owner: Builtin) -> R<Value> {
    let name = owner.name();
    let Some(first) = args.get(0) else { return Err(vm.type_error(format!("{name}.__new__(): not enough arguments"))) };
    let Value::Class(class) = first else {
        let message = format!("{name}.__new__(X): X is not a type object ({})", vm.type_name(first));
        return Err(vm.type_error(message));
    };
    if !vm.is_subclass(class, owner.class()) {
        let given = vm.class_name(class);
        return Err(vm.type_error(format!("{name}.__new__({given}): {given} is not a subtype of {name}")));
    }
    vm.default_new(class, Args { pos: &args.pos[1..], kw: args.kw })
}

fn new_type(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let Value::Class(meta) = args.at(0) else { return Err(vm.type_error("type.__new__(X): X is not a type object")) };
    if args.pos.len() == 2 {
        return Ok(Value::Class(vm.class_of(args.at(1))));
    }
    if args.pos.len() == 4 && !matches!(vm.plain(args.at(2)), Value::Tuple(_)) {
        let message = format!("type.__new__() argument 2 must be tuple, not {}", vm.type_name(args.at(2)));
        return Err(vm.type_error(message));
    }
    if args.pos.len() != 4 {
        return Err(vm.type_error("type.__new__() takes exactly 3 arguments"));
    }
    vm.new_class(meta, args.at(1), args.at(2), args.at(3), args.kw)
}

/// `type(x)`, `type(name, bases, namespace)`
pub fn construct_type(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    match args.pos.len() {
        1 if args.kw.is_empty() => Ok(Value::Class(vm.class_of(args.at(0)))),
        3 if !matches!(vm.plain(args.at(1)), Value::Tuple(_)) => {
            let message = format!("type.__new__() argument 2 must be tuple, not {}", vm.type_name(args.at(1)));
            Err(vm.type_error(message))
        }
        3 => vm.new_class(Builtin::Type.class(), args.at(0), args.at(1), args.at(2), args.kw),
        _ => Err(vm.type_error("type() takes 1 or 3 arguments")),
    }
}

/// `types.GenericAlias(origin, args)`
pub fn construct_alias(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let args_value = args.at(1);
    let items = match args_value {
        Value::Tuple(t) => vm.heap[t].0.to_vec(),
        one => vec![one],
    };
    Ok(Value::Alias(vm.heap.alloc(Alias { origin: args.at(0), args: items })))
}

fn init(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    if args.pos.len() > 1 || !args.kw.is_empty() {
        let class = vm.class_of(args.at(0));
        let own_init = !matches!(vm.class_attr(class, sym::INIT), Some(Value::Native(_)));
        let own_new = !matches!(vm.class_attr(class, sym::NEW), Some(Value::Native(_)));
        if own_init {
            return Err(vm.type_error("object.__init__() takes exactly one argument (the instance to initialize)"));
        }
        if !own_new && vm.heap[class].layout == Layout::Object {
            let message = format!("{}.__init__() takes exactly one argument (the instance to initialize)", vm.class_name(class));
            return Err(vm.type_error(message));
        }
    }
    Ok(Value::None)
}

fn init_subclass(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    match args.kw {
        [] => Ok(Value::None),
        _ => {
            let name = match args.at(0) {
                Value::Class(c) => vm.qualified_name(c),
                _ => String::new(),
            };
            Err(vm.type_error(format!("{name}.__init_subclass__() takes no keyword arguments")))
        }
    }
}

fn format(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let spec = vm.str(args.at(1))?;
    if !spec.is_empty() {
        let message = format!("unsupported format string passed to {}.__format__", vm.type_name(args.at(0)));
        return Err(vm.type_error(message));
    }
    let text = vm.str(args.at(0))?;
    Ok(vm.new_str(text))
}

fn not_equal(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    match vm.call_special(args.at(0), sym::EQ, &[args.at(1)])? {
        Some(Value::NotImplemented) | None => Ok(Value::NotImplemented),
        Some(equal) => vm.truth(equal).map(|b| Value::Bool(!b)),
    }
}

fn not_implemented(_: &mut Vm<'_>, _: Args<'_>) -> R<Value> {
    Ok(Value::NotImplemented)
}

fn attribute_name(vm: &mut Vm<'_>, name: Value) -> R<crate::python::value::Symbol> {
    match vm.plain(name) {
        Value::Str(_) => Ok(vm.intern_value(name)),
        _ => {
            let message = format!("attribute name must be string, not '{}'", vm.type_name(name));
            Err(vm.type_error(message))
        }
    }
}

fn get_attribute(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let name = attribute_name(vm, args.at(1))?;
    vm.get_attr_without_hooks(args.at(0), name)
}

fn set_attribute(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let name = attribute_name(vm, args.at(1))?;
    vm.set_attr_without_hooks(args.at(0), name, args.at(2))?;
    Ok(Value::None)
}

fn delete_attribute(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let name = attribute_name(vm, args.at(1))?;
    vm.del_attr_without_hooks(args.at(0), name)?;
    Ok(Value::None)
}

/// `int | str`
fn union(vm: &mut Vm<'_>, a: Value, b: Value) -> R<Value> {
    let mut members = Vec::new();
    for side in [a, b] {
        match side {
            Value::None => members.push(Builtin::NoneType.value()),
            Value::Class(_) => members.push(side),
            Value::Alias(alias) if vm.heap[alias].origin.is_none() => members.extend(vm.heap[alias].args.clone()),
            Value::Alias(_) => members.push(side),
            _ => return Ok(Value::NotImplemented),
        }
    }
    let mut unique: Vec<Value> = Vec::new();
    for member in members {
        let mut known = false;
        for other in &unique {
            known = known || vm.eq(*other, member)?;
        }
        if !known {
            unique.push(member);
        }
    }
    if unique.len() == 1 {
        return Ok(unique[0]);
    }
    Ok(Value::Alias(vm.heap.alloc(Alias { origin: Value::None, args: unique })))
}

fn alias_equal(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (Value::Alias(a), Value::Alias(b)) = (args.at(0), args.at(1)) else { return Ok(Value::NotImplemented) };
    let (a, b) = (vm.heap[a].clone(), vm.heap[b].clone());
    if !vm.eq(a.origin, b.origin)? || a.args.len() != b.args.len() {
        return Ok(Value::Bool(false));
    }
    if a.origin.is_none() {
        for x in &a.args {
            let mut found = false;
            for y in &b.args {
                found = found || vm.eq(*x, *y)?;
            }
            if !found {
                return Ok(Value::Bool(false));
            }
        }
        return Ok(Value::Bool(true));
    }
    for (x, y) in a.args.iter().zip(&b.args) {
        if !vm.eq(*x, *y)? {
            return Ok(Value::Bool(false));
        }
    }
    Ok(Value::Bool(true))
}
