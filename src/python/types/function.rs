//! Functions, methods, generators, properties, class and static methods, `super`.

use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::native::{Args, Native};
use crate::python::symbols::sym;
use crate::python::value::Value;
use crate::python::vm::Vm;

/// `types.FunctionType`
pub const FUNCTION: &[Native] = &[
    Native::raw("__call__", 0, crate::python::native::ANY, call).keywords(),
    Native::raw("__get__", 1, 2, get),
    Native::getter("__code__", |vm, a| vm.code_object(a.at(0))),
];

/// Functions and methods written in Rust.
pub const NATIVE: &[Native] = &[
    Native::raw("__call__", 0, crate::python::native::ANY, call).keywords(),
    Native::raw("__get__", 1, 2, get),
    Native::getter("__self__", |vm, a| {
        Ok(match a.at(0) {
            Value::Method(m) => vm.heap[m].receiver,
            _ => Value::None,
        })
    }),
];

/// Bound methods.
pub const METHOD: &[Native] = &[
    Native::raw("__call__", 0, crate::python::native::ANY, call).keywords(),
    Native::raw("__eq__", 1, 1, |vm, a| {
        let (Value::Method(x), Value::Method(y)) = (a.at(0), a.at(1)) else { return Ok(Value::NotImplemented) };
        let (x, y) = (vm.heap[x], vm.heap[y]);
        Ok(Value::Bool(x.callee.is(y.callee) && x.receiver.is(y.receiver)))
    }),
    Native::raw("__hash__", 0, 0, |vm, a| {
        let Value::Method(m) = a.at(0) else { return Ok(Value::int(0)) };
        let Method { callee, receiver } = vm.heap[m];
        Ok(Value::int(vm.identity(callee) ^ vm.identity(receiver).rotate_left(7)))
    }),
];

/// Generators.
pub const GENERATOR: &[Native] = &[
    Native::raw("__iter__", 0, 0, |_, a| Ok(a.at(0))),
    Native::raw("__next__", 0, 0, |vm, a| vm.generator_send(a.at(0), Value::None)),
    Native::raw("send", 1, 1, |vm, a| vm.generator_send(a.at(0), a.at(1))),
    Native::raw("throw", 1, 3, |vm, a| vm.generator_throw(a)),
    Native::raw("close", 0, 0, |vm, a| vm.generator_close(a.at(0))),
    Native::getter("gi_code", |vm, a| vm.code_object(a.at(0))),
    Native::getter("gi_suspended", |vm, a| {
        Ok(Value::Bool(match a.at(0) {
            Value::Generator(g) => vm.heap[g].frame.is_some() && vm.heap[g].started && !vm.heap[g].running,
            _ => false,
        }))
    }),
    Native::getter("gi_yieldfrom", |vm, a| Ok(vm.generator_waits_for(a.at(0)))),
    Native::getter("gi_running", |vm, a| {
        Ok(Value::Bool(match a.at(0) {
            Value::Generator(g) => vm.heap[g].running,
            _ => false,
        }))
    }),
    Native::getter("gi_frame", |vm, a| {
        Ok(match a.at(0) {
            Value::Generator(g) if vm.heap[g].frame.is_some() || vm.heap[g].running => Value::Ellipsis,
            _ => Value::None,
        })
    }),
];

/// `property`
pub const PROPERTY: &[Native] = &[
    Native::method("getter", 1, 1, |vm, a| with_part(vm, a, |p, f| p.get = f)),
    Native::method("setter", 1, 1, |vm, a| with_part(vm, a, |p, f| p.set = f)),
    Native::method("deleter", 1, 1, |vm, a| with_part(vm, a, |p, f| p.delete = f)),
    Native::getter("fget", |vm, a| Ok(part(vm, a).get)),
    Native::getter("fset", |vm, a| Ok(part(vm, a).set)),
    Native::getter("fdel", |vm, a| Ok(part(vm, a).delete)),
    Native::getter("__doc__", |vm, a| Ok(part(vm, a).doc)),
    Native::getter("__isabstractmethod__", is_abstract),
    Native::method("__delete__", 1, 1, |vm, a| {
        let delete = part(vm, a).delete;
        if delete.is_none() {
            return Err(vm.error(Builtin::AttributeError, "property has no deleter".to_string()));
        }
        vm.call(delete, &[a.at(1)])
    }),
    Native::method("__get__", 1, 2, |vm, a| {
        let object = a.at(1);
        if object.is_none() {
            return Ok(a.at(0));
        }
        let class = vm.class_of(object);
        vm.bind_value(a.at(0), object, class)
    }),
    Native::method("__set__", 2, 2, |vm, a| {
        let set = part(vm, a).set;
        if set.is_none() {
            return Err(vm.error(Builtin::AttributeError, "property has no setter".to_string()));
        }
        vm.call(set, &[a.at(1), a.at(2)])
    }),
];

/// `classmethod`
pub const CLASS_METHOD: &[Native] = &[
    Native::getter("__func__", wrapped),
    Native::getter("__wrapped__", wrapped),
    Native::raw("__get__", 1, 2, get),
    Native::getter("__name__", |vm, a| of_wrapped(vm, a, sym::NAME)),
    Native::getter("__qualname__", |vm, a| of_wrapped(vm, a, sym::QUALNAME)),
    Native::getter("__module__", |vm, a| of_wrapped(vm, a, sym::MODULE)),
    Native::getter("__doc__", |vm, a| of_wrapped(vm, a, sym::DOC)),
    Native::getter("__isabstractmethod__", is_abstract),
];

/// `staticmethod`
pub const STATIC_METHOD: &[Native] = &[
    Native::getter("__func__", wrapped),
    Native::getter("__wrapped__", wrapped),
    Native::raw("__get__", 1, 2, get),
    Native::raw("__call__", 0, crate::python::native::ANY, call).keywords(),
    Native::getter("__name__", |vm, a| of_wrapped(vm, a, sym::NAME)),
    Native::getter("__qualname__", |vm, a| of_wrapped(vm, a, sym::QUALNAME)),
    Native::getter("__module__", |vm, a| of_wrapped(vm, a, sym::MODULE)),
    Native::getter("__doc__", |vm, a| of_wrapped(vm, a, sym::DOC)),
    Native::getter("__isabstractmethod__", is_abstract),
];

/// Computed attributes of builtin types (`int.real`).
pub const GETSET: &[Native] = &[Native::raw("__get__", 1, 2, get)];

/// The cells of `f.__closure__`.
pub const CELL: &[Native] = &[Native::getter("cell_contents", |vm, a| match a.at(0) {
    Value::Cell(c) if !vm.heap[c].0.is_undefined() => Ok(vm.heap[c].0),
    _ => Err(vm.value_error("Cell is empty")),
})];

fn call(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    vm.call_with(args.at(0), Args { pos: &args.pos[1..], kw: args.kw })
}

/// `f.__get__(object, class)`
fn get(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let object = args.at(1);
    match (args.at(0), object, args.get(2)) {
        (function, Value::None, Some(Value::Class(c))) => match function {
            Value::ClassMethod(_) => vm.bind_value(function, object, c),
            Value::StaticMethod(w) => Ok(vm.heap[w].0),
            _ => Ok(function),
        },
        (function, _, owner) => {
            let class = match owner {
                Some(Value::Class(c)) => c,
                _ => vm.class_of(object),
            };
            vm.bind_value(function, object, class)
        }
    }
}

fn wrapped(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(match args.at(0) {
        Value::ClassMethod(w) | Value::StaticMethod(w) => vm.heap[w].0,
        _ => Value::None,
    })
}

/// An attribute of the function that a class method or static method is around.
fn of_wrapped(vm: &mut Vm<'_>, args: Args<'_>, name: crate::python::value::Symbol) -> R<Value> {
    let inner = wrapped(vm, args)?;
    vm.nested("", |vm| vm.get_attr(inner, name))
}

fn is_abstract(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let inner = match args.at(0) {
        Value::Property(p) => vm.heap[p].get,
        _ => wrapped(vm, args)?,
    };
    let name = vm.symbols.intern("__isabstractmethod__");
    let said = vm.nested("", |vm| vm.get_attr_opt(inner, name))?.unwrap_or(Value::Bool(false));
    vm.truth(said).map(Value::Bool)
}

fn part(vm: &Vm<'_>, args: Args<'_>) -> Property {
    match args.at(0) {
        Value::Property(p) => vm.heap[p],
        _ => Property { get: Value::None, set: Value::None, delete: Value::None, doc: Value::None },
    }
}

fn with_part(vm: &mut Vm<'_>, args: Args<'_>, change: impl FnOnce(&mut Property, Value)) -> R<Value> {
    let mut property = part(vm, args);
    change(&mut property, args.at(1));
    Ok(Value::Property(vm.heap.alloc(property)))
}

/// `property(fget, fset, fdel, doc)`
pub fn construct_property(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let [get, set, delete, doc] = vm.bind("property", args, ["fget", "fset", "fdel", "doc"], 0)?;
    let get = get.unwrap_or(Value::None);
    let doc = match doc {
        Some(doc) => doc,
        None if get.is_none() => Value::None,
        None => vm.get_attr_opt(get, sym::DOC)?.unwrap_or(Value::None),
    };
    let property = Property { get, set: set.unwrap_or(Value::None), delete: delete.unwrap_or(Value::None), doc };
    Ok(Value::Property(vm.heap.alloc(property)))
}

/// The one argument of a constructor.
fn only(vm: &mut Vm<'_>, class: &str, args: Args<'_>) -> R<Value> {
    match (args.pos, args.kw) {
        (&[function], []) => Ok(function),
        (_, [_, ..]) => Err(vm.type_error(format!("{class}() takes no keyword arguments"))),
        _ => Err(vm.type_error(format!("{class} expected 1 argument, got {}", args.pos.len()))),
    }
}

/// `classmethod(f)`
pub fn construct_class_method(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let function = only(vm, "classmethod", args)?;
    Ok(Value::ClassMethod(vm.heap.alloc(Wrapped(function))))
}

/// `staticmethod(f)`
pub fn construct_static_method(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let function = only(vm, "staticmethod", args)?;
    Ok(Value::StaticMethod(vm.heap.alloc(Wrapped(function))))
}

/// `types.MethodType(function, object)`
pub fn construct_method(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    Ok(Value::Method(vm.heap.alloc(Method { callee: args.at(0), receiver: args.at(1) })))
}

/// `super()`, `super(class, object)`
pub fn construct_super(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let (class, object) = match args.pos.len() {
        0 => vm.super_arguments()?,
        _ => (args.at(0), args.at(1)),
    };
    let Value::Class(class) = class else {
        let message = format!("super() argument 1 must be a type, not {}", vm.type_name(class));
        return Err(vm.type_error(message));
    };
    if args.pos.len() == 1 {
        return Ok(Value::Super(vm.heap.alloc(Super { class, object: Value::Undefined, object_class: class })));
    }
    let own = vm.class_of(object);
    let object_class = match object {
        Value::Class(c) if vm.is_subclass(c, class) => c,
        _ if vm.is_subclass(own, class) => own,
        _ => return Err(vm.type_error("super(type, obj): obj must be an instance or subtype of type")),
    };
    Ok(Value::Super(vm.heap.alloc(Super { class, object, object_class })))
}
