//! Setting and deleting attributes, and the attributes of functions.

use super::Vm;
use super::attr::Found;
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::native::{Native, NativeKind};
use crate::python::symbols::sym;
use crate::python::value::{Symbol, Value};

/// Whether a hook is the one that every object has: `dict.__setitem__` as a class's `__setattr__` is not.
pub(super) fn is_default(hook: Value, name: &str) -> bool {
    matches!(hook, Value::Native(native) if native.name == name)
}

/// Whether a method of a builtin type fills a slot of it in CPython: such methods call themselves slot wrappers.
pub(super) fn is_slot(name: &str) -> bool {
    const METHODS: &[&str] = &[
        "__format__",
        "__reversed__",
        "__sizeof__",
        "__dir__",
        "__round__",
        "__trunc__",
        "__floor__",
        "__ceil__",
        "__getnewargs__",
        "__length_hint__",
        "__subclasses__",
        "__instancecheck__",
        "__subclasscheck__",
        "__prepare__",
        "__complex__",
        "__bytes__",
        "__class_getitem__",
        "__mro_entries__",
        "__setstate__",
        "__reduce__",
        "__reduce_ex__",
        "__getstate__",
        "__copy__",
        "__missing__",
    ];
    name.starts_with("__") && !METHODS.contains(&name)
}

impl Vm<'_> {
    /// `o.name = value`
    pub fn set_attr(&mut self, object: Value, name: Symbol, value: Value) -> R<()> {
        match object {
            Value::Instance(i) => {
                let class = self.heap[i].class;
                if let Some(hook) = self.class_attr(class, sym::SETATTR)
                    && !is_default(hook, "__setattr__")
                {
                    let text = self.symbol_text(name);
                    return self.call_unbound(hook, object, &[text, value]).map(|_| ());
                }
                self.set_instance_attr(object, i, name, value)
            }
            Value::Class(c) => {
                let meta = self.heap[c].meta;
                if let Some(hook) = self.class_attr(meta, sym::SETATTR)
                    && !is_default(hook, "__setattr__")
                {
                    let text = self.symbol_text(name);
                    return self.call_unbound(hook, object, &[text, value]).map(|_| ());
                }
                if let Some(Value::Property(p)) = self.class_attr(meta, name) {
                    return self.set_property(p, object, name, value);
                }
                self.set_type_attr(c, name, value)
            }
            Value::Module(m) => {
                self.module_set(m, name, value);
                Ok(())
            }
            Value::Host(_) | Value::Record(_) => self.set_host_attr(object, name, value),
            Value::Function(f) => self.set_function_attr(f, name, value),
            _ => Err(self.cannot_set(object, name)),
        }
    }

    fn cannot_set(&mut self, object: Value, name: Symbol) -> Raise {
        let class = self.class_of(object);
        let text = self.symbols.text(name).to_string();
        let type_name = self.type_name(object);
        let message = match self.class_attr(class, name) {
            Some(Value::Native(n))
                if n.kind == NativeKind::Getter && matches!(object, Value::Slice(_) | Value::Range(_) | Value::Complex(_)) =>
            {
                "readonly attribute".to_string()
            }
            Some(Value::Native(n)) if n.kind == NativeKind::Getter => {
                format!("attribute '{text}' of '{type_name}' objects is not writable")
            }
            Some(_) => format!("'{type_name}' object attribute '{text}' is read-only"),
            None => format!("'{type_name}' object has no attribute '{text}'"),
        };
        self.error(Builtin::AttributeError, message)
    }

    /// What `object.__setattr__` does.
    pub(super) fn set_instance_attr(&mut self, object: Value, i: Ref<Instance>, name: Symbol, value: Value) -> R<()> {
        let class = self.heap[i].class;
        if let Some(on_class) = self.class_attr(class, name) {
            match on_class {
                Value::Property(p) => return self.set_property(p, object, name, value),
                Value::Native(n) if n.kind == NativeKind::Getter => {
                    if self.set_exception_field(object, name, value)? {
                        return Ok(());
                    }
                    let message = format!("attribute '{}' of '{}' objects is not writable", n.name, self.class_name(class));
                    return Err(self.error(Builtin::AttributeError, message));
                }
                Value::Instance(d) => {
                    let owner = self.heap[d].class;
                    let set = self.class_attr(owner, sym::SET);
                    if let Base::Value(Value::Property(p)) = self.heap[d].base
                        && !matches!(set, Some(Value::Function(_)))
                    {
                        return self.set_property(p, object, name, value);
                    }
                    if let Some(set) = set {
                        return self.call_unbound(set, on_class, &[object, value]).map(|_| ());
                    }
                }
                _ => {}
            }
        }
        match name {
            sym::CLASS => return self.set_class(i, value),
            sym::DICT => {
                let Value::Dict(d) = self.plain(value) else {
                    let message = format!("__dict__ must be set to a dictionary, not a '{}'", self.type_name(value));
                    return Err(self.type_error(message));
                };
                self.heap[i].attrs = Attrs::Dict(d);
                return Ok(());
            }
            _ => {}
        }
        if let Some(slots) = &self.heap[class].slots
            && !slots.contains(&name)
        {
            return Err(self.cannot_set(object, name));
        }
        if self.heap[class].builtin && self.heap[class].layout == Layout::Object {
            return Err(self.cannot_set(object, name));
        }
        self.store_own(i, name, value)
    }

    #[inline]
    pub(crate) fn store_own(&mut self, i: Ref<Instance>, name: Symbol, value: Value) -> R<()> {
        match &mut self.heap[i].attrs {
            Attrs::Inline(items) => {
                if let Some(pair) = items.iter_mut().find(|p| p.0 == name) {
                    pair.1 = value;
                    return Ok(());
                }
                items.push((name, value));
                if items.len() <= super::attr::INLINE {
                    return Ok(());
                }
                self.instance_dict(i);
                Ok(())
            }
            Attrs::Dict(dict) => {
                let dict = *dict;
                let key = self.symbol_text(name);
                self.dict_set(dict, key, value)
            }
        }
    }

    fn set_class(&mut self, i: Ref<Instance>, value: Value) -> R<()> {
        match value {
            Value::Class(c) if self.heap[c].layout == self.heap[self.heap[i].class].layout && !self.heap[c].builtin => {
                self.heap[i].class = c;
                Ok(())
            }
            Value::Class(c) if !self.heap[c].builtin => {
                let (new, old) = (self.class_name(c), self.class_name(self.heap[i].class));
                Err(self.type_error(format!("__class__ assignment: '{new}' object layout differs from '{old}'")))
            }
            Value::Class(_) => Err(self.type_error("__class__ assignment only supported for mutable types or ModuleType subclasses")),
            _ => {
                let message = format!("__class__ must be set to a class, not '{}' object", self.type_name(value));
                Err(self.type_error(message))
            }
        }
    }

    fn set_property(&mut self, p: Ref<Property>, object: Value, name: Symbol, value: Value) -> R<()> {
        let set = self.heap[p].set;
        if set.is_none() {
            let message = format!("property '{}' of '{}' object has no setter", self.symbols.text(name), self.type_name(object));
            return Err(self.error(Builtin::AttributeError, message));
        }
        self.call(set, &[object, value]).map(|_| ())
    }

    /// The fields of an exception that a program may write.
    fn set_exception_field(&mut self, object: Value, name: Symbol, value: Value) -> R<bool> {
        if self.heap.exception_data(object).is_none() {
            return Ok(false);
        }
        if matches!(name, sym::CAUSE | sym::CONTEXT) && !value.is_none() && !self.is_instance(value, Builtin::BaseException) {
            let what = if name == sym::CAUSE { "cause" } else { "context" };
            return Err(self.type_error(format!("exception {what} must be None or derive from BaseException")));
        }
        if name == sym::TRACEBACK && !value.is_none() && self.class_of(value) != Builtin::Traceback.class() {
            return Err(self.type_error("__traceback__ must be a traceback or None"));
        }
        let args = if self.symbols.text(name) == "args" {
            let items = self.collect(value)?;
            Some(self.heap.tuple(items))
        } else {
            None
        };
        let suppress = if name == sym::SUPPRESS_CONTEXT { Some(self.truth(value)?) } else { None };
        let Some(data) = self.heap.exception_data_mut(object) else { return Ok(false) };
        match name {
            sym::CAUSE => {
                data.cause = value;
                data.suppress = true;
            }
            sym::CONTEXT => data.context = value,
            sym::SUPPRESS_CONTEXT => data.suppress = suppress.unwrap_or(false),
            sym::TRACEBACK if value.is_none() => data.traceback.clear(),
            sym::TRACEBACK => {}
            _ => match args {
                Some(args) => data.args = args,
                None => return Ok(false),
            },
        }
        Ok(true)
    }

    fn set_host_attr(&mut self, object: Value, name: Symbol, value: Value) -> R<()> {
        let text = self.symbols.text(name).to_string();
        let value = if self.host.wants_sequence(object, &text)
            && !matches!(value, Value::Host(_) | Value::Record(_) | Value::Tuple(_) | Value::List(_))
        {
            let items = self.collect(value)?;
            self.heap.tuple(items)
        } else {
            self.plain(value)
        };
        let (host, mut cx) = self.host_cx();
        host.set_attr(&mut cx, object, &text, value)
    }

    /// `del o.name`
    pub fn del_attr(&mut self, object: Value, name: Symbol) -> R<()> {
        match object {
            Value::Instance(i) => {
                let class = self.heap[i].class;
                if let Some(hook) = self.class_attr(class, sym::DELATTR)
                    && !is_default(hook, "__delattr__")
                {
                    let text = self.symbol_text(name);
                    return self.call_unbound(hook, object, &[text]).map(|_| ());
                }
                self.del_instance_attr(object, i, name)
            }
            Value::Class(c) if !self.heap[c].builtin => {
                let meta = self.heap[c].meta;
                if let Some(hook) = self.class_attr(meta, sym::DELATTR)
                    && !is_default(hook, "__delattr__")
                {
                    let text = self.symbol_text(name);
                    return self.call_unbound(hook, object, &[text]).map(|_| ());
                }
                self.del_type_attr(c, name)
            }
            Value::Module(m) => match self.heap[m].index.get(&name).copied() {
                Some(slot) if !self.heap[m].slots[slot as usize].is_undefined() => {
                    self.heap[m].slots[slot as usize] = Value::Undefined;
                    Ok(())
                }
                _ => Err(self.no_attribute(object, name)),
            },
            Value::Function(f) => {
                let position = match &self.heap[f].attrs {
                    Attrs::Inline(items) => items.iter().position(|p| p.0 == name),
                    Attrs::Dict(_) => None,
                };
                match (position, &mut self.heap[f].attrs) {
                    (Some(p), Attrs::Inline(items)) => {
                        items.remove(p);
                        Ok(())
                    }
                    _ => Err(self.no_attribute(object, name)),
                }
            }
            Value::Host(_) | Value::Record(_) => Err(self.no_attribute(object, name)),
            _ => Err(self.cannot_set(object, name)),
        }
    }

    /// What `type.__delattr__` does.
    pub(super) fn del_type_attr(&mut self, c: Ref<Class>, name: Symbol) -> R<()> {
        if matches!(name, sym::NAME | sym::QUALNAME | sym::BASES) {
            let message = format!("cannot delete '{}' attribute of immutable type '{}'", self.symbols.text(name), self.class_name(c));
            return Err(self.type_error(message));
        }
        let removed = self.heap[c].attrs.shift_remove(&name);
        self.attr_cache.clear();
        if matches!(name, sym::GETATTRIBUTE | sym::GETATTR) {
            self.rehook(c);
        }
        match removed {
            Some(_) => Ok(()),
            None => Err(self.no_attribute(Value::Class(c), name)),
        }
    }

    /// What `object.__delattr__` does.
    pub(super) fn del_instance_attr(&mut self, object: Value, i: Ref<Instance>, name: Symbol) -> R<()> {
        let class = self.heap[i].class;
        if let Some(on_class) = self.class_attr(class, name) {
            match on_class {
                Value::Property(p) => {
                    let delete = self.heap[p].delete;
                    if delete.is_none() {
                        let message =
                            format!("property '{}' of '{}' object has no deleter", self.symbols.text(name), self.type_name(object));
                        return Err(self.error(Builtin::AttributeError, message));
                    }
                    return self.call(delete, &[object]).map(|_| ());
                }
                Value::Instance(d) => {
                    let owner = self.heap[d].class;
                    if let Some(hook) = self.class_attr(owner, sym::DELETE) {
                        return self.call_unbound(hook, on_class, &[object]).map(|_| ());
                    }
                    if self.class_attr(owner, sym::SET).is_some() {
                        return Err(self.error(Builtin::AttributeError, "__delete__".to_string()));
                    }
                }
                _ => {}
            }
        }
        match self.remove_own(i, name)? {
            Some(_) => Ok(()),
            None => Err(self.no_attribute(object, name)),
        }
    }

    /// Takes away an instance's own attribute.
    pub(crate) fn remove_own(&mut self, i: Ref<Instance>, name: Symbol) -> R<Option<Value>> {
        match &mut self.heap[i].attrs {
            Attrs::Inline(items) => Ok(items.iter().position(|p| p.0 == name).map(|p| items.remove(p).1)),
            Attrs::Dict(dict) => {
                let dict = *dict;
                let key = self.symbol_text(name);
                self.dict_remove(dict, key)
            }
        }
    }

    /// Sets a global of a module.
    pub fn module_set(&mut self, m: Ref<Module>, name: Symbol, value: Value) {
        let module = &mut self.heap[m];
        match module.index.get(&name) {
            Some(&slot) => module.slots[slot as usize] = value,
            None => {
                module.index.insert(name, module.slots.len() as u32);
                module.slots.push(value);
                module.names.push(name);
            }
        }
    }

    pub(super) fn find_function_attr(&mut self, object: Value, f: Ref<Function>, name: Symbol) -> R<Option<Found>> {
        let function = &self.heap[f];
        let value = match name {
            sym::NAME => function.name,
            sym::QUALNAME => function.qualname,
            sym::DOC => function.doc,
            sym::MODULE => function.module_name,
            sym::DEFAULTS => {
                if function.defaults.is_empty() {
                    Value::None
                } else {
                    let defaults: Vec<Value> = function.defaults.to_vec();
                    self.heap.tuple(defaults)
                }
            }
            sym::KWDEFAULTS => {
                if function.kwdefaults.is_empty() {
                    Value::None
                } else {
                    let items = function.kwdefaults.to_vec();
                    Value::Dict(self.symbols_dict(items))
                }
            }
            sym::CLOSURE => {
                if function.closure.is_empty() {
                    Value::None
                } else {
                    let cells: Vec<Value> = function.closure.iter().map(|c| Value::Cell(*c)).collect();
                    self.heap.tuple(cells)
                }
            }
            sym::ANNOTATIONS => {
                if function.annotations.is_none() {
                    let dict = Value::Dict(self.heap.dict());
                    self.heap[f].annotations = dict;
                }
                self.heap[f].annotations
            }
            sym::GLOBALS => {
                let module = function.module;
                Value::Dict(self.module_dict(module))
            }
            sym::DICT => {
                let items = match &mut self.heap[f].attrs {
                    Attrs::Dict(dict) => return Ok(Some(Found::Value(Value::Dict(*dict)))),
                    Attrs::Inline(items) => std::mem::take(items),
                };
                let dict = self.symbols_dict(items);
                self.heap[f].attrs = Attrs::Dict(dict);
                Value::Dict(dict)
            }
            _ => {
                let own = match &function.attrs {
                    Attrs::Inline(items) => items.iter().find(|p| p.0 == name).map(|p| p.1),
                    Attrs::Dict(dict) => {
                        let dict = *dict;
                        self.dict_get_symbol(dict, name)
                    }
                };
                match own {
                    Some(v) => v,
                    None => return self.find_builtin_attr(object, name),
                }
            }
        };
        Ok(Some(Found::Value(value)))
    }

    fn set_function_attr(&mut self, f: Ref<Function>, name: Symbol, value: Value) -> R<()> {
        match name {
            sym::NAME | sym::QUALNAME => {
                if !matches!(value, Value::Str(_)) {
                    let message = format!("{} must be set to a string object", self.symbols.text(name));
                    return Err(self.type_error(message));
                }
                let function = &mut self.heap[f];
                if name == sym::NAME {
                    function.name = value;
                } else {
                    function.qualname = value;
                }
            }
            sym::DICT => match value {
                Value::Dict(d) => self.heap[f].attrs = Attrs::Dict(d),
                _ => {
                    let message = format!("__dict__ must be set to a dictionary, not a '{}'", self.type_name(value));
                    return Err(self.type_error(message));
                }
            },
            sym::DOC => self.heap[f].doc = value,
            sym::MODULE => self.heap[f].module_name = value,
            sym::ANNOTATIONS => self.heap[f].annotations = value,
            sym::DEFAULTS => {
                if !value.is_none() && !matches!(value, Value::Tuple(_)) {
                    return Err(self.type_error("__defaults__ must be set to a tuple object"));
                }
                let items = if value.is_none() { Vec::new() } else { self.collect(value)? };
                self.heap[f].defaults = items.into();
            }
            sym::KWDEFAULTS => {
                let mut out = smallvec::SmallVec::new();
                if let Value::Dict(d) = value {
                    let items: Vec<(Value, Value)> = self.heap[d].0.iter().map(|e| (e.key, e.value)).collect();
                    for (key, value) in items {
                        if let Value::Str(s) = key {
                            let text = self.heap[s].text.clone();
                            out.push((self.symbols.intern(&text), value));
                        }
                    }
                }
                self.heap[f].kwdefaults = out;
            }
            _ => match &mut self.heap[f].attrs {
                Attrs::Inline(items) => match items.iter_mut().find(|p| p.0 == name) {
                    Some(pair) => pair.1 = value,
                    None => items.push((name, value)),
                },
                Attrs::Dict(dict) => {
                    let dict = *dict;
                    let key = self.symbol_text(name);
                    self.dict_set(dict, key, value)?;
                }
            },
        }
        Ok(())
    }

    /// Whether a native is a method in the sense of `type(x).__name__`.
    pub(super) fn native_class(native: &Native) -> Builtin {
        match native.kind {
            NativeKind::Getter => Builtin::GetSet,
            NativeKind::Method | NativeKind::Raw if is_slot(native.name) => Builtin::SlotWrapper,
            NativeKind::Method | NativeKind::Raw => Builtin::NativeMethod,
            _ => Builtin::NativeFunction,
        }
    }
}
