//! Attributes: look-up along classes, descriptors, the hooks of programs.

use super::Vm;
use super::fast::set;
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::native::{Args, Native, NativeKind};
use crate::python::symbols::sym;
use crate::python::value::{Symbol, Value};

const CACHE: usize = 1024;
/// An instance with more attributes keeps them in a dict.
pub(super) const INLINE: usize = 64;

/// What classes answered lately. Cleared whenever any class changes.
pub struct Cache {
    entries: Box<[Entry; CACHE]>,
}

#[derive(Clone, Copy)]
struct Entry {
    class: u32,
    name: Symbol,
    found: Value,
    kind: Kind,
    /// An instance takes this attribute without asking anyone.
    stores: bool,
}

/// What the class's attribute means to an instance.
#[derive(Clone, Copy)]
enum Kind {
    /// The instance's own attribute comes first, then this value, if there is one.
    Plain,
    /// The instance's own attribute comes first, then this method.
    Method,
    /// The instance's own attribute, or none: a name of `__slots__`.
    Slot,
    /// A property with this getter.
    Property(Ref<Function>),
    /// Anything else.
    Other,
}

const NOTHING: Entry = Entry { class: u32::MAX, name: Symbol(0), found: Value::Undefined, kind: Kind::Other, stores: false };

impl Cache {
    pub(super) fn new() -> Cache {
        Cache { entries: Box::new([NOTHING; CACHE]) }
    }

    pub(super) fn clear(&mut self) {
        self.entries.fill(NOTHING);
    }

    #[inline(always)]
    fn place(class: Ref<Class>, name: Symbol) -> usize {
        (class.index().wrapping_mul(31).wrapping_add(name.0)) as usize % CACHE
    }

    #[inline(always)]
    fn get(&self, class: Ref<Class>, name: Symbol) -> Option<&Entry> {
        Some(&self.entries[Cache::place(class, name)]).filter(|e| e.class == class.index() && e.name == name)
    }
}

/// What attribute access found without running code or making anything.
pub(super) enum QuickAttr<'a> {
    Value(&'a Value),
    /// A callable that wants the object as its first argument.
    Method(Value),
    /// A property's getter, written in Python.
    Property(Ref<Function>),
    No,
}

/// What attribute access found, before a method is bound: calls need no bound method.
pub enum Found {
    /// The attribute.
    Value(Value),
    /// A callable that wants the object as its first argument.
    Method(Value),
}

impl Vm<'_> {
    /// The attribute that a class or its bases hold, as it stands there.
    #[inline]
    pub fn class_attr(&mut self, class: Ref<Class>, name: Symbol) -> Option<Value> {
        let value = match self.attr_cache.get(class, name) {
            Some(entry) => entry.found,
            None => self.class_attr_slow(class, name),
        };
        if value.is_undefined() { None } else { Some(value) }
    }

    #[inline(never)]
    fn class_attr_slow(&mut self, class: Ref<Class>, name: Symbol) -> Value {
        let mut found = Value::Undefined;
        for i in 0..self.heap[class].mro.len() {
            let base = self.heap[class].mro[i];
            if !self.heap[base].natives.is_empty() {
                self.load_natives(base);
            }
            if let Some(v) = self.heap[base].attrs.get(&name) {
                found = *v;
                break;
            }
        }
        let kind = match found {
            _ if self.heap[class].hooked => Kind::Other,
            Value::Undefined | Value::Int(..) | Value::Float(..) | Value::Str(_) | Value::None | Value::Bool(_) => Kind::Plain,
            Value::Function(_) => Kind::Method,
            Value::Native(n) if matches!(n.kind, NativeKind::Method | NativeKind::Raw) => Kind::Method,
            Value::Property(p) => match self.heap[p].get {
                Value::Function(getter) => Kind::Property(getter),
                _ => Kind::Other,
            },
            Value::Instance(i) if self.heap[i].class == Builtin::MemberDescriptor.class() => Kind::Slot,
            _ => Kind::Other,
        };
        let open = self.heap[class].slots.is_none();
        let stores = matches!(kind, Kind::Slot) | (open && matches!(kind, Kind::Plain | Kind::Method))
            && !matches!(name, sym::SETATTR | sym::CLASS | sym::DICT)
            && !self.heap[class].builtin
            && self.class_attr(class, sym::SETATTR).is_none_or(|hook| super::assign::is_default(hook, "__setattr__"));
        self.attr_cache.entries[Cache::place(class, name)] = Entry { class: class.index(), name, found, kind, stores };
        found
    }

    /// Puts the methods written in Rust into their class's namespace.
    pub(super) fn load_natives(&mut self, class: Ref<Class>) {
        let natives = std::mem::take(&mut self.heap[class].natives);
        for native in natives {
            let name = self.symbols.intern(native.name);
            self.heap[class].attrs.entry(name).or_insert(Value::Native(native));
        }
        let unhashable = [Builtin::List, Builtin::Dict, Builtin::Set, Builtin::ByteArray, Builtin::DictKeys, Builtin::DictItems];
        if unhashable.iter().any(|b| b.class() == class) {
            self.heap[class].attrs.insert(sym::HASH, Value::None);
        }
    }

    /// `o.name`
    pub fn get_attr(&mut self, object: Value, name: Symbol) -> R<Value> {
        match self.find_attr(object, name)? {
            Some(Found::Value(v)) => Ok(v),
            Some(Found::Method(callee)) => Ok(self.bind_method(callee, object)),
            None => Err(self.no_attribute(object, name)),
        }
    }

    /// `o.name`, `None` where there is none.
    pub fn get_attr_opt(&mut self, object: Value, name: Symbol) -> R<Option<Value>> {
        match self.find_attr(object, name) {
            Ok(Some(Found::Value(v))) => Ok(Some(v)),
            Ok(Some(Found::Method(callee))) => Ok(Some(self.bind_method(callee, object))),
            Ok(None) => Ok(None),
            Err(raise) if self.raised(&raise, Builtin::AttributeError) => Ok(None),
            Err(raise) => Err(raise),
        }
    }

    pub(super) fn bind_method(&mut self, callee: Value, receiver: Value) -> Value {
        Value::Method(self.heap.alloc(Method { callee, receiver }))
    }

    /// `AttributeError`, in CPython's words.
    pub(crate) fn no_attribute(&mut self, object: Value, name: Symbol) -> Raise {
        let name_text = self.symbols.text(name).to_string();
        let message = match object {
            Value::Class(c) => format!("type object '{}' has no attribute '{name_text}'", self.class_name(c)),
            Value::Module(m) => format!("module '{}' has no attribute '{name_text}'", self.display(self.heap[m].name)),
            _ => format!("'{}' object has no attribute '{name_text}'", self.type_name(object)),
        };
        let raise = self.error(Builtin::AttributeError, message);
        if let Raise::Exception(e @ Value::Instance(_)) = raise {
            let text = self.symbol_text(name);
            self.set_own_attr(e, sym::N_NAME, text);
            self.set_own_attr(e, sym::N_OBJ, object);
        }
        raise
    }

    /// Puts an attribute straight into an instance's own attributes.
    pub(crate) fn set_own_attr(&mut self, object: Value, name: Symbol, value: Value) {
        if let Value::Instance(i) = object {
            // A text hashes without running code: nothing can be raised but for want of steps.
            let _ = self.store_own(i, name, value);
        }
    }

    /// The common cases: an instance's own attribute, a method or property of its class, a method of a builtin value, a variable of a
    /// module.
    #[inline(always)]
    pub(super) fn quick_attr<'a>(heap: &'a Heap, cache: &'a Cache, object: &Value, name: Symbol) -> QuickAttr<'a> {
        let (class, own) = match *object {
            Value::Instance(i) => {
                let instance = &heap[i];
                match &instance.attrs {
                    Attrs::Inline(items) => (instance.class, items.as_slice()),
                    Attrs::Dict(_) => return QuickAttr::No,
                }
            }
            Value::Module(m) => {
                let module = &heap[m];
                return match module.index.get(&name).and_then(|slot| module.slots.get(*slot as usize)) {
                    Some(value) if !value.is_undefined() => QuickAttr::Value(value),
                    _ => QuickAttr::No,
                };
            }
            Value::List(_) => (Builtin::List.class(), &[][..]),
            Value::Dict(_) => (Builtin::Dict.class(), &[][..]),
            Value::Str(_) => (Builtin::Str.class(), &[][..]),
            _ => return QuickAttr::No,
        };
        let Some(entry) = cache.get(class, name) else { return QuickAttr::No };
        let found = match entry.kind {
            Kind::Property(getter) => return QuickAttr::Property(getter),
            Kind::Other => return QuickAttr::No,
            Kind::Slot => QuickAttr::No,
            Kind::Plain if entry.found.is_undefined() => QuickAttr::No,
            Kind::Plain => QuickAttr::Value(&entry.found),
            Kind::Method => QuickAttr::Method(entry.found),
        };
        match own.iter().find(|p| p.0 == name) {
            Some(pair) => QuickAttr::Value(&pair.1),
            None => found,
        }
    }

    /// `o.name = value` of the two on top of the stack, where nobody needs to be asked: they are taken off. Else nothing is done.
    #[inline(always)]
    pub(super) fn quick_store(&mut self, name: Symbol) -> bool {
        let top = self.stack.len() - 1;
        let Value::Instance(i) = self.stack[top] else { return false };
        let instance = &mut self.heap[i];
        if !self.attr_cache.get(instance.class, name).is_some_and(|entry| entry.stores) {
            return false;
        }
        let Attrs::Inline(items) = &mut instance.attrs else { return false };
        match items.iter().position(|p| p.0 == name) {
            Some(at) => set(&mut items[at].1, &self.stack[top - 1]),
            None if items.len() < INLINE => {
                let before = items.capacity();
                items.push((name, self.stack[top - 1]));
                let grown = items.capacity() - before;
                self.heap.bytes += grown * std::mem::size_of::<(Symbol, Value)>();
            }
            None => return false,
        }
        self.stack.truncate(top - 1);
        true
    }

    /// Attribute access without binding methods.
    #[inline]
    pub(crate) fn find_attr(&mut self, object: Value, name: Symbol) -> R<Option<Found>> {
        match Vm::quick_attr(&self.heap, &self.attr_cache, &object, name) {
            QuickAttr::Value(value) => return Ok(Some(Found::Value(*value))),
            QuickAttr::Method(callee) => return Ok(Some(Found::Method(callee))),
            QuickAttr::Property(_) | QuickAttr::No => {}
        }
        match object {
            Value::Instance(i) => self.find_instance_attr(object, i, name),
            Value::Class(c) => self.find_type_attr(c, name),
            Value::Module(m) => self.find_module_attr(m, name),
            Value::Host(_) | Value::Record(_) => self.find_host_attr(object, name),
            Value::Super(s) => self.find_super_attr(s, name),
            Value::Alias(a) => self.find_alias_attr(a, object, name),
            Value::Function(f) => self.find_function_attr(object, f, name),
            Value::Method(m) => self.find_method_attr(object, m, name),
            _ => self.find_builtin_attr(object, name),
        }
    }

    pub(super) fn find_builtin_attr(&mut self, object: Value, name: Symbol) -> R<Option<Found>> {
        let class = self.class_of(object);
        match self.class_attr(class, name) {
            Some(value) => self.bind_found(value, object, class).map(Some),
            None => self.generic_attr(object, class, name),
        }
    }

    /// Attributes that everything has.
    fn generic_attr(&mut self, object: Value, class: Ref<Class>, name: Symbol) -> R<Option<Found>> {
        Ok(match name {
            sym::CLASS => Some(Found::Value(Value::Class(class))),
            sym::NAME | sym::QUALNAME => match object {
                Value::Native(n) => Some(Found::Value(self.heap.str(n.name))),
                Value::Generator(g) => Some(Found::Value(if name == sym::NAME { self.heap[g].name } else { self.heap[g].qualname })),
                _ => None,
            },
            sym::DOC => Some(Found::Value(match object {
                Value::Native(n) => self.heap.str(format!("{}(...)", n.name)),
                _ => Value::None,
            })),
            sym::MODULE if matches!(object, Value::Native(_)) => Some(Found::Value(match object {
                Value::Native(n) if !n.module.is_empty() => self.heap.str(n.module),
                _ => self.heap.str("builtins"),
            })),
            sym::DICT if matches!(object, Value::ClassMethod(_) | Value::StaticMethod(_)) => {
                Some(Found::Value(Value::Dict(self.heap.dict())))
            }
            _ => None,
        })
    }

    fn find_instance_attr(&mut self, object: Value, i: Ref<Instance>, name: Symbol) -> R<Option<Found>> {
        let class = self.heap[i].class;
        if let Some(hook) = self.class_attr(class, sym::GETATTRIBUTE)
            && !matches!(hook, Value::Native(_))
        {
            return self.hooked_attr(object, class, hook, name);
        }
        match self.default_instance_attr(object, i, name) {
            Ok(Some(found)) => Ok(Some(found)),
            Ok(None) => self.missing_attr(object, class, name),
            // A property may raise AttributeError to say that there is none.
            Err(raise) if self.raised(&raise, Builtin::AttributeError) && self.class_attr(class, sym::GETATTR).is_some() => {
                self.missing_attr(object, class, name)
            }
            Err(raise) => Err(raise),
        }
    }

    fn hooked_attr(&mut self, object: Value, class: Ref<Class>, hook: Value, name: Symbol) -> R<Option<Found>> {
        let text = self.symbol_text(name);
        match self.call(hook, &[object, text]) {
            Ok(value) => Ok(Some(Found::Value(value))),
            Err(raise) if self.raised(&raise, Builtin::AttributeError) && self.class_attr(class, sym::GETATTR).is_some() => {
                self.missing_attr(object, class, name)
            }
            Err(raise) => Err(raise),
        }
    }

    /// `__getattr__`, where the class has one.
    fn missing_attr(&mut self, object: Value, class: Ref<Class>, name: Symbol) -> R<Option<Found>> {
        let Some(hook) = self.class_attr(class, sym::GETATTR) else { return Ok(None) };
        let text = self.symbol_text(name);
        let hook = self.bind_value(hook, object, class)?;
        self.call(hook, &[text]).map(|v| Some(Found::Value(v)))
    }

    /// What `object.__getattribute__` does.
    pub(super) fn default_instance_attr(&mut self, object: Value, i: Ref<Instance>, name: Symbol) -> R<Option<Found>> {
        let class = self.heap[i].class;
        let on_class = self.class_attr(class, name);
        if let Some(value) = on_class
            && self.is_data_descriptor(value)
        {
            return self.bind_found(value, object, class).map(Some);
        }
        if let Some(value) = self.own_attr(i, name) {
            return Ok(Some(Found::Value(value)));
        }
        if let Some(value) = on_class {
            return self.bind_found(value, object, class).map(Some);
        }
        match name {
            sym::CLASS => Ok(Some(Found::Value(Value::Class(class)))),
            sym::DICT if self.heap[class].slots.is_none() => Ok(Some(Found::Value(Value::Dict(self.instance_dict(i))))),
            sym::DOC => Ok(Some(Found::Value(Value::None))),
            sym::MODULE => Ok(self.class_attr(class, name).map(Found::Value)),
            _ => Ok(None),
        }
    }

    /// An instance's own attribute.
    #[inline]
    pub(crate) fn own_attr(&mut self, i: Ref<Instance>, name: Symbol) -> Option<Value> {
        match &self.heap[i].attrs {
            Attrs::Inline(items) => items.iter().find(|p| p.0 == name).map(|p| p.1),
            Attrs::Dict(dict) => {
                let dict = *dict;
                self.dict_get_symbol(dict, name)
            }
        }
    }

    /// The value of a string key.
    pub fn dict_get_symbol(&mut self, dict: Ref<Dict>, name: Symbol) -> Option<Value> {
        let key = self.symbol_text(name);
        self.dict_get(dict, key).ok().flatten()
    }

    /// An instance's `__dict__`: from now on its attributes live there.
    pub(super) fn instance_dict(&mut self, i: Ref<Instance>) -> Ref<Dict> {
        let items = match &mut self.heap[i].attrs {
            Attrs::Dict(dict) => return *dict,
            Attrs::Inline(items) => std::mem::take(items),
        };
        let dict = self.symbols_dict(items);
        self.heap[i].attrs = Attrs::Dict(dict);
        dict
    }

    /// A dict with these names as keys.
    pub(crate) fn symbols_dict(&mut self, items: impl IntoIterator<Item = (Symbol, Value)>) -> Ref<Dict> {
        let dict = self.heap.dict();
        for (name, value) in items {
            let key = self.symbol_text(name);
            // A text hashes without running code, and these names differ: nothing can be raised but for want of steps.
            let _ = self.dict_set(dict, key, value);
        }
        dict
    }

    /// True for what wins over an instance's own attribute: properties, and objects with `__set__` or `__delete__`.
    #[inline]
    fn is_data_descriptor(&mut self, value: Value) -> bool {
        match value {
            Value::Property(_) => true,
            Value::Native(n) => n.kind == NativeKind::Getter,
            Value::Instance(i) => {
                let class = self.heap[i].class;
                if let Base::Value(Value::Property(_)) = self.heap[i].base {
                    return true;
                }
                let sets = self.class_attr(class, sym::SET).is_some() || self.class_attr(class, sym::DELETE).is_some();
                sets && self.class_attr(class, sym::GET).is_some()
            }
            _ => false,
        }
    }

    /// What a class attribute becomes when an instance asks for it.
    #[inline]
    fn bind_found(&mut self, value: Value, object: Value, class: Ref<Class>) -> R<Found> {
        Ok(match value {
            Value::Function(_) => Found::Method(value),
            Value::Native(native) => match native.kind {
                NativeKind::Method | NativeKind::Raw => Found::Method(value),
                NativeKind::Function | NativeKind::StaticMethod => Found::Value(value),
                NativeKind::ClassMethod => Found::Value(self.bind_method(value, Value::Class(class))),
                NativeKind::Getter => Found::Value(self.call_getter(native, object)?),
            },
            Value::Property(_) | Value::ClassMethod(_) | Value::StaticMethod(_) | Value::Instance(_) => {
                Found::Value(self.bind_value(value, object, class)?)
            }
            other => Found::Value(other),
        })
    }

    fn call_getter(&mut self, native: &'static Native, object: Value) -> R<Value> {
        let receiver = self.plain(object);
        (native.body)(self, Args::new(&[receiver]))
    }

    /// A class attribute bound to an instance.
    pub(crate) fn bind_value(&mut self, value: Value, object: Value, class: Ref<Class>) -> R<Value> {
        match value {
            Value::Function(_) => Ok(self.bind_method(value, object)),
            Value::Native(native) => match native.kind {
                NativeKind::Method | NativeKind::Raw => Ok(self.bind_method(value, object)),
                NativeKind::Function | NativeKind::StaticMethod => Ok(value),
                NativeKind::ClassMethod => Ok(self.bind_method(value, Value::Class(class))),
                NativeKind::Getter => self.call_getter(native, object),
            },
            Value::ClassMethod(w) => self.bind_class_method(w, class),
            Value::StaticMethod(w) => Ok(self.heap[w].0),
            Value::Property(p) => self.get_property(p, object),
            Value::Instance(i) => {
                if let Base::Value(Value::Property(p)) = self.heap[i].base {
                    return self.get_property(p, object);
                }
                let owner = self.heap[i].class;
                match self.class_attr(owner, sym::GET) {
                    Some(get) => self.call_unbound(get, value, &[object, Value::Class(class)]),
                    None => Ok(value),
                }
            }
            other => Ok(other),
        }
    }

    fn bind_class_method(&mut self, w: Ref<Wrapped>, class: Ref<Class>) -> R<Value> {
        let inner = self.heap[w].0;
        Ok(match inner {
            Value::Function(_) | Value::Native(_) | Value::Method(_) => self.bind_method(inner, Value::Class(class)),
            Value::Property(p) => return self.get_property(p, Value::Class(class)),
            _ => self.bind_method(inner, Value::Class(class)),
        })
    }

    fn get_property(&mut self, p: Ref<Property>, object: Value) -> R<Value> {
        let get = self.heap[p].get;
        if get.is_none() {
            let message = match self.property_name(p, object) {
                Some(name) => format!("property '{name}' of '{}' object has no getter", self.type_name(object)),
                None => format!("property of '{}' object has no getter", self.type_name(object)),
            };
            return Err(self.error(Builtin::AttributeError, message));
        }
        self.call(get, &[object])
    }

    /// The name under which an object's class has a property.
    fn property_name(&self, p: Ref<Property>, object: Value) -> Option<String> {
        let mro = &self.heap[self.class_of(object)].mro;
        mro.iter().flat_map(|c| &self.heap[*c].attrs).find(|a| a.1.is(Value::Property(p))).map(|a| self.symbols.text(*a.0).to_string())
    }

    /// Calls a function found on a class with its receiver.
    pub(super) fn call_unbound(&mut self, function: Value, receiver: Value, args: &[Value]) -> R<Value> {
        match function {
            Value::Function(_) | Value::Native(_) => {
                let mut all = smallvec::SmallVec::<[Value; 6]>::new();
                all.push(receiver);
                all.extend_from_slice(args);
                self.call(function, &all)
            }
            other => {
                let class = self.class_of(receiver);
                let bound = self.bind_value(other, receiver, class)?;
                self.call(bound, args)
            }
        }
    }

    /// The special method of an object, looked up on its type and bound; `None` where there is none (or it is `None`).
    pub fn special(&mut self, object: Value, name: Symbol) -> Option<Value> {
        let class = self.class_of(object);
        let found = self.class_attr(class, name)?;
        if found.is_none() {
            return None;
        }
        self.bind_value(found, object, class).ok()
    }

    /// Calls a special method where the type has it.
    pub fn call_special(&mut self, object: Value, name: Symbol, args: &[Value]) -> R<Option<Value>> {
        let class = self.class_of(object);
        match self.class_attr(class, name) {
            Some(function) if !function.is_none() => self.call_unbound(function, object, args).map(Some),
            _ => Ok(None),
        }
    }

    /// `o.name(...)`
    pub fn call_method(&mut self, object: Value, name: Symbol, args: &[Value]) -> R<Value> {
        match self.find_attr(object, name)? {
            Some(Found::Value(v)) => self.call(v, args),
            Some(Found::Method(function)) => self.call_unbound(function, object, args),
            None => Err(self.no_attribute(object, name)),
        }
    }

    fn find_module_attr(&mut self, m: Ref<Module>, name: Symbol) -> R<Option<Found>> {
        if let Some(&slot) = self.heap[m].index.get(&name) {
            let value = self.heap[m].slots[slot as usize];
            if !value.is_undefined() {
                return Ok(Some(Found::Value(value)));
            }
        }
        Ok(match name {
            sym::NAME => Some(Found::Value(self.heap[m].name)),
            sym::DICT => {
                let dict = self.module_dict(m);
                Some(Found::Value(Value::Dict(dict)))
            }
            sym::CLASS => Some(Found::Value(Builtin::Module.value())),
            sym::DOC => Some(Found::Value(Value::None)),
            _ => return self.module_hook(m, name),
        })
    }

    /// `def __getattr__(name)` of a module.
    fn module_hook(&mut self, m: Ref<Module>, name: Symbol) -> R<Option<Found>> {
        let Some(&slot) = self.heap[m].index.get(&sym::GETATTR) else { return Ok(None) };
        let hook = self.heap[m].slots[slot as usize];
        if hook.is_undefined() {
            return Ok(None);
        }
        let text = self.symbol_text(name);
        self.call(hook, &[text]).map(|v| Some(Found::Value(v)))
    }

    /// A dict of a module's globals as they are now: the same each time.
    pub fn module_dict(&mut self, m: Ref<Module>) -> Ref<Dict> {
        let items: Vec<(Symbol, Value)> = {
            let module = &self.heap[m];
            module.names.iter().copied().zip(module.slots.iter().copied()).filter(|p| !p.1.is_undefined()).collect()
        };
        let Some(dict) = self.heap[m].dict else {
            let dict = self.symbols_dict(items);
            self.heap[m].dict = Some(dict);
            return dict;
        };
        for (name, value) in items {
            let key = self.symbol_text(name);
            // A text hashes without running code: nothing can be raised but for want of steps.
            let _ = self.dict_set(dict, key, value);
        }
        dict
    }

    fn find_host_attr(&mut self, object: Value, name: Symbol) -> R<Option<Found>> {
        if name == sym::CLASS {
            let class = self.class_of(object);
            return Ok(Some(Found::Value(Value::Class(class))));
        }
        let text = self.symbols.text(name).to_string();
        let (host, mut cx) = self.host_cx();
        Ok(host.get_attr(&mut cx, object, &text)?.map(Found::Value))
    }

    fn find_alias_attr(&mut self, a: Ref<Alias>, object: Value, name: Symbol) -> R<Option<Found>> {
        let origin = self.heap[a].origin;
        Ok(match name {
            sym::ORIGIN if !origin.is_none() => Some(Found::Value(origin)),
            sym::ARGS => {
                let args = self.heap[a].args.clone();
                Some(Found::Value(self.heap.tuple(args)))
            }
            sym::CLASS => Some(Found::Value(Value::Class(self.class_of(object)))),
            sym::MRO_ENTRIES => return self.find_builtin_attr(object, name),
            _ if origin.is_none() => return self.find_builtin_attr(object, name),
            _ => return self.find_attr(origin, name),
        })
    }

    fn find_method_attr(&mut self, object: Value, m: Ref<Method>, name: Symbol) -> R<Option<Found>> {
        let Method { callee, receiver } = self.heap[m];
        match name {
            sym::FUNC => Ok(Some(Found::Value(callee))),
            sym::SELF => Ok(Some(Found::Value(receiver))),
            sym::CLASS => self.find_builtin_attr(object, name),
            _ => self.find_attr(callee, name),
        }
    }

    fn find_super_attr(&mut self, s: Ref<Super>, name: Symbol) -> R<Option<Found>> {
        let Super { class, object, object_class } = self.heap[s];
        if name == sym::CLASS {
            return Ok(Some(Found::Value(Builtin::Super.value())));
        }
        if object.is_undefined() {
            return self.find_builtin_attr(Value::Super(s), name);
        }
        match self.symbols.text(name) {
            "__thisclass__" => return Ok(Some(Found::Value(Value::Class(class)))),
            "__self__" => return Ok(Some(Found::Value(object))),
            "__self_class__" => return Ok(Some(Found::Value(Value::Class(object_class)))),
            _ => {}
        }
        let mro = self.heap[object_class].mro.clone();
        let start = mro.iter().position(|c| *c == class).map_or(0, |p| p + 1);
        for &base in &mro[start..] {
            if !self.heap[base].natives.is_empty() {
                self.load_natives(base);
            }
            let Some(value) = self.heap[base].attrs.get(&name).copied() else { continue };
            let on_class = matches!(object, Value::Class(c) if self.is_subclass(c, class));
            return if on_class {
                self.bind_on_class(value, object_class).map(Some)
            } else {
                self.bind_found_for_super(value, object, object_class)
            };
        }
        Ok(None)
    }

    /// `super().method` is called with the object itself, not with the `super`.
    fn bind_found_for_super(&mut self, value: Value, object: Value, class: Ref<Class>) -> R<Option<Found>> {
        Ok(Some(match self.bind_found(value, object, class)? {
            Found::Method(callee) => Found::Value(self.bind_method(callee, object)),
            found => found,
        }))
    }
}
