//! Classes: making them, their attributes, their order of resolution.

use super::Vm;
use super::attr::Found;
use crate::python::classes::Builtin;
use crate::python::error::{R, Raise};
use crate::python::heap::*;
use crate::python::native::{Args, NativeKind};
use crate::python::symbols::sym;
use crate::python::types::member;
use crate::python::value::{Symbol, Value};
use smallvec::SmallVec;

/// Whether an identifier may begin with this character.
fn unicode_ident_start(c: char) -> bool {
    c == '_' || unicode_ident::is_xid_start(c)
}

impl Vm<'_> {
    /// `__name__` of a class.
    pub fn class_name(&self, class: Ref<Class>) -> String {
        self.display(self.heap[class].name)
    }

    /// `__qualname__` of a class.
    pub fn qualified_name(&self, class: Ref<Class>) -> String {
        self.display(self.heap[class].qualname)
    }

    /// `issubclass` without hooks.
    #[inline]
    pub fn is_subclass(&self, class: Ref<Class>, of: Ref<Class>) -> bool {
        class == of || self.heap[class].mro.contains(&of)
    }

    /// `C.name`
    pub(super) fn find_type_attr(&mut self, class: Ref<Class>, name: Symbol) -> R<Option<Found>> {
        let meta = self.heap[class].meta;
        let on_meta = self.class_attr(meta, name);
        if let Some(value) = on_meta
            && matches!(value, Value::Property(_))
        {
            return self.bind_value(value, Value::Class(class), meta).map(|v| Some(Found::Value(v)));
        }
        if let Some(value) = self.type_slot(class, name) {
            return Ok(Some(Found::Value(value)));
        }
        if let Some(value) = self.class_attr(class, name) {
            return self.bind_on_class(value, class).map(Some);
        }
        if let Some(value) = on_meta {
            return self.bind_value(value, Value::Class(class), meta).map(|v| Some(Found::Value(v)));
        }
        if name == sym::ANNOTATIONS && !self.heap[class].builtin {
            let dict = Value::Dict(self.heap.dict());
            self.heap[class].attrs.insert(name, dict);
            self.attr_cache.clear();
            return Ok(Some(Found::Value(dict)));
        }
        if name == sym::DOC {
            return Ok(Some(Found::Value(Value::None)));
        }
        match self.class_attr(meta, sym::GETATTR) {
            Some(hook) => {
                let text = self.symbol_text(name);
                self.call_unbound(hook, Value::Class(class), &[text]).map(|v| Some(Found::Value(v)))
            }
            None => Ok(None),
        }
    }

    /// The attributes that `type` itself computes.
    fn type_slot(&mut self, class: Ref<Class>, name: Symbol) -> Option<Value> {
        Some(match name {
            sym::NAME => self.heap[class].name,
            sym::QUALNAME => self.heap[class].qualname,
            sym::MODULE if self.heap[class].builtin => self.heap.str("builtins"),
            sym::CLASS => Value::Class(self.heap[class].meta),
            sym::MRO => {
                let mro: Vec<Value> = self.heap[class].mro.iter().map(|c| Value::Class(*c)).collect();
                self.heap.tuple(mro)
            }
            _ if self.symbols.text(name) == "__base__" => match self.heap[class].bases.first() {
                Some(base) => Value::Class(*base),
                None => Value::None,
            },
            sym::BASES => {
                let bases: Vec<Value> = self.heap[class].bases.iter().map(|c| Value::Class(*c)).collect();
                self.heap.tuple(bases)
            }
            sym::DICT => {
                self.load_natives(class);
                let mut items: Vec<(Symbol, Value)> = self.heap[class].attrs.iter().map(|(k, v)| (*k, *v)).collect();
                let inherits_dict = self.heap[class].bases.iter().any(|b| !self.heap[*b].builtin);
                if !self.heap[class].builtin && self.heap[class].slots.is_none() && !inherits_dict {
                    let at = items.iter().position(|p| p.0 == sym::DOC).unwrap_or(items.len());
                    items.insert(at, (sym::DICT, Value::Ellipsis));
                    items.insert(at + 1, (sym::WEAKREF, Value::Ellipsis));
                }
                let dict = self.symbols_dict(items);
                Value::Proxy(self.heap.alloc(Wrapped(Value::Dict(dict))))
            }
            sym::DOC => self.heap[class].attrs.get(&sym::DOC).copied()?,
            sym::ANNOTATIONS => self.heap[class].attrs.get(&sym::ANNOTATIONS).copied()?,
            _ => return None,
        })
    }

    /// What a class attribute becomes when the class itself is asked for it.
    pub(super) fn bind_on_class(&mut self, value: Value, class: Ref<Class>) -> R<Found> {
        Ok(Found::Value(match value {
            Value::ClassMethod(_) => self.bind_value(value, Value::Class(class), class)?,
            Value::StaticMethod(w) => self.heap[w].0,
            Value::Native(n) if n.kind == NativeKind::ClassMethod => self.bind_method(value, Value::Class(class)),
            Value::Instance(i) => {
                let owner = self.heap[i].class;
                match self.class_attr(owner, sym::GET) {
                    Some(get) => self.call_unbound(get, value, &[Value::None, Value::Class(class)])?,
                    None => value,
                }
            }
            other => other,
        }))
    }

    /// `C.name = value`
    pub(super) fn set_type_attr(&mut self, class: Ref<Class>, name: Symbol, value: Value) -> R<()> {
        if self.heap[class].builtin {
            let text = self.symbols.text(name).to_string();
            let message = format!("cannot set '{text}' attribute of immutable type '{}'", self.class_name(class));
            return Err(self.type_error(message));
        }
        match (name, value) {
            (sym::NAME, Value::Str(_)) => self.heap[class].name = value,
            (sym::QUALNAME, Value::Str(_)) => self.heap[class].qualname = value,
            (sym::NAME | sym::QUALNAME, _) => {
                let message = format!(
                    "can only assign string to {}.{}, not '{}'",
                    self.class_name(class),
                    self.symbols.text(name),
                    self.type_name(value)
                );
                return Err(self.type_error(message));
            }
            (sym::DICT, _) => {
                let message = "attribute '__dict__' of 'type' objects is not writable".to_string();
                return Err(self.error(Builtin::AttributeError, message));
            }
            (sym::BASES, _) => return Err(self.type_error("__bases__ assignment is not available in PSDL")),
            _ => {
                self.heap[class].attrs.insert(name, value);
            }
        }
        self.attr_cache.clear();
        if matches!(name, sym::GETATTRIBUTE | sym::GETATTR) {
            self.rehook(class);
        }
        Ok(())
    }

    /// A class got another `__getattribute__` or `__getattr__`: so did its subclasses.
    pub(super) fn rehook(&mut self, class: Ref<Class>) {
        let mut todo = vec![class];
        while let Some(class) = todo.pop() {
            self.note_hook(class);
            todo.extend(self.heap[class].subclasses.clone());
        }
    }

    /// `__build_class__(body, name, *bases, metaclass=…, **keywords)`
    pub(super) fn build_class(&mut self, args: Args<'_>) -> R<Value> {
        let (body, name) = (args.at(0), args.at(1));
        let original = &args.pos[2..];
        let bases = self.resolve_bases(original)?;
        let mut keywords: SmallVec<[(Symbol, Value); 4]> = args.kw.iter().copied().collect();
        let explicit = keywords.iter().position(|k| k.0 == sym::N_METACLASS).map(|p| keywords.remove(p).1);
        let meta = self.metaclass(explicit, &bases)?;
        let bases_tuple = self.heap.tuple(bases.as_slice());
        let namespace = self.prepare_namespace(meta, name, bases_tuple, &keywords)?;
        let Value::Function(body) = body else { return Err(self.type_error("__build_class__: func must be a function")) };
        self.run_class_body(body, namespace)?;
        let as_written = original.len() == bases.len() && original.iter().zip(&bases).all(|(a, b)| a.is(*b));
        if !as_written {
            let tuple = self.heap.tuple(original);
            let key = self.symbols.intern("__orig_bases__");
            let key = self.symbol_text(key);
            self.set_item(namespace, key, tuple)?;
        }
        let cell = self.namespace_get(namespace, sym::CLASSCELL)?;
        let class = self.call_with(meta, Args { pos: &[name, bases_tuple, namespace], kw: &keywords })?;
        if let (Some(Value::Cell(cell)), Value::Class(_)) = (cell, class) {
            self.heap[cell].0 = class;
        }
        Ok(class)
    }

    /// Bases with `__mro_entries__` asked (`Generic[T]`).
    fn resolve_bases(&mut self, original: &[Value]) -> R<SmallVec<[Value; 3]>> {
        let mut out = SmallVec::new();
        for &base in original {
            match base {
                Value::Class(_) => out.push(base),
                Value::Alias(a) if !self.heap[a].origin.is_none() => out.push(self.heap[a].origin),
                _ => match self.get_attr_opt(base, sym::MRO_ENTRIES)? {
                    Some(hook) => {
                        let tuple = self.heap.tuple(original);
                        let entries = self.call(hook, &[tuple])?;
                        out.extend(self.collect(entries)?);
                    }
                    None => out.push(base),
                },
            }
        }
        Ok(out)
    }

    fn metaclass(&mut self, explicit: Option<Value>, bases: &[Value]) -> R<Value> {
        let mut winner = match explicit {
            Some(Value::Class(c)) if self.is_subclass(c, Builtin::Type.class()) => c,
            Some(callable) => return Ok(callable),
            // CPython begins with the type of the first base, whatever that is.
            None => bases.first().map_or(Builtin::Type.class(), |b| self.class_of(*b)),
        };
        for base in bases {
            let meta = self.class_of(*base);
            if self.is_subclass(winner, meta) {
                continue;
            }
            if !self.is_subclass(meta, winner) {
                return Err(self.type_error(
                    "metaclass conflict: the metaclass of a derived class must be a (non-strict) subclass of the metaclasses of all its bases",
                ));
            }
            winner = meta;
        }
        Ok(Value::Class(winner))
    }

    fn prepare_namespace(&mut self, meta: Value, name: Value, bases: Value, keywords: &[(Symbol, Value)]) -> R<Value> {
        match self.get_attr_opt(meta, sym::PREPARE)? {
            Some(prepare) => {
                let namespace = self.call_with(prepare, Args { pos: &[name, bases], kw: keywords })?;
                if !matches!(self.plain(namespace), Value::Dict(_)) && self.special(namespace, sym::GETITEM).is_none() {
                    let who = match meta {
                        Value::Class(c) => self.class_name(c),
                        _ => "<metaclass>".to_string(),
                    };
                    let message = format!("{who}.__prepare__() must return a mapping, not {}", self.type_name(namespace));
                    return Err(self.type_error(message));
                }
                Ok(namespace)
            }
            None => Ok(Value::Dict(self.heap.dict())),
        }
    }

    /// A name of a class body's namespace.
    pub(super) fn namespace_get(&mut self, namespace: Value, name: Symbol) -> R<Option<Value>> {
        let key = self.symbol_text(name);
        match namespace {
            Value::Dict(d) => self.dict_get(d, key),
            _ => match self.get_item(namespace, key) {
                Ok(v) => Ok(Some(v)),
                Err(raise) if self.raised(&raise, Builtin::KeyError) => Ok(None),
                Err(raise) => Err(raise),
            },
        }
    }

    /// `type(name, bases, namespace, **keywords)`: what `type.__new__` does.
    pub fn new_class(&mut self, meta: Ref<Class>, name: Value, bases: Value, namespace: Value, keywords: &[(Symbol, Value)]) -> R<Value> {
        let Value::Str(_) = self.plain(name) else {
            let message = format!("type.__new__() argument 1 must be str, not {}", self.type_name(name));
            return Err(self.type_error(message));
        };
        let given = self.collect(bases)?;
        let meta = match self.metaclass(Some(Value::Class(meta)), &given)? {
            Value::Class(c) => c,
            _ => meta,
        };
        let mut base_classes: SmallVec<[Ref<Class>; 1]> = SmallVec::new();
        for base in given {
            match base {
                Value::Class(c) => base_classes.push(c),
                _ => return Err(self.type_error("bases must be types")),
            }
        }
        if base_classes.is_empty() {
            base_classes.push(Builtin::Object.class());
        }
        if base_classes.len() > 256 {
            return Err(self.type_error("too many base classes for PSDL: at most 256"));
        }
        let layout = self.common_layout(&base_classes)?;
        let mro = self.linearize(&base_classes)?;
        let class = self.heap.alloc(Class {
            name: self.plain(name),
            qualname: name,
            bases: base_classes.clone(),
            mro,
            attrs: Default::default(),
            meta,
            layout,
            natives: &[],
            builtin: false,
            slots: None,
            hooked: false,
            subclasses: Vec::new(),
        });
        self.heap[class].mro.insert(0, class);
        for base in &base_classes {
            self.heap[*base].subclasses.push(class);
        }
        self.fill_namespace(class, namespace)?;
        self.make_slots(class)?;
        self.ask_for_mro(class)?;
        self.note_hook(class);
        self.announce_class(class, keywords)?;
        Ok(Value::Class(class))
    }

    /// Notes whether instances have a `__getattribute__` or `__getattr__` of the program's own.
    fn note_hook(&mut self, class: Ref<Class>) {
        let hooked = matches!(self.class_attr(class, sym::GETATTRIBUTE), Some(hook) if !matches!(hook, Value::Native(_)));
        self.heap[class].hooked = hooked || self.class_attr(class, sym::GETATTR).is_some();
    }

    /// A metaclass may have a say in the order of resolution.
    fn ask_for_mro(&mut self, class: Ref<Class>) -> R<()> {
        let meta = self.heap[class].meta;
        let name = self.symbols.intern("mro");
        let Some(hook) = self.class_attr(meta, name).filter(|h| !matches!(h, Value::Native(_))) else { return Ok(()) };
        let order = self.call_unbound(hook, Value::Class(class), &[])?;
        let mut mro = Vec::new();
        for entry in self.collect(order)? {
            match entry {
                Value::Class(c) => mro.push(c),
                other => {
                    let message = format!("mro() returned a non-class ('{}')", self.type_name(other));
                    return Err(self.type_error(message));
                }
            }
        }
        self.heap[class].mro = mro;
        self.attr_cache.clear();
        Ok(())
    }

    fn fill_namespace(&mut self, class: Ref<Class>, namespace: Value) -> R<()> {
        let Value::Dict(dict) = self.plain(namespace) else {
            return Err(self.type_error(format!("type.__new__() argument 3 must be dict, not {}", self.type_name(namespace))));
        };
        let items: Vec<(Value, Value)> = self.heap[dict].0.iter().map(|e| (e.key, e.value)).collect();
        for (key, value) in items {
            let Value::Str(key) = key else { continue };
            let text = self.heap[key].text.clone();
            let name = self.symbols.intern(&text);
            match name {
                sym::QUALNAME => self.heap[class].qualname = value,
                sym::CLASSCELL => {
                    if let Value::Cell(cell) = value {
                        self.heap[cell].0 = Value::Class(class);
                    }
                }
                // These are class methods whether or not the program says so.
                sym::INIT_SUBCLASS | sym::CLASS_GETITEM if matches!(value, Value::Function(_)) => {
                    let wrapped = Value::ClassMethod(self.heap.alloc(Wrapped(value)));
                    self.heap[class].attrs.insert(name, wrapped);
                }
                sym::NEW if matches!(value, Value::Function(_)) => {
                    let wrapped = Value::StaticMethod(self.heap.alloc(Wrapped(value)));
                    self.heap[class].attrs.insert(name, wrapped);
                }
                _ => {
                    self.heap[class].attrs.insert(name, value);
                }
            }
        }
        let has_eq = self.heap[class].attrs.contains_key(&sym::EQ);
        if has_eq && !self.heap[class].attrs.contains_key(&sym::HASH) {
            self.heap[class].attrs.insert(sym::HASH, Value::None);
        }
        if !self.heap[class].attrs.contains_key(&sym::MODULE) {
            let name = match self.frame_module_name() {
                Some(name) => name,
                None => self.heap.str("__main__"),
            };
            self.heap[class].attrs.insert(sym::MODULE, name);
        }
        if !self.heap[class].attrs.contains_key(&sym::DOC) {
            self.heap[class].attrs.insert(sym::DOC, Value::None);
        }
        self.attr_cache.clear();
        Ok(())
    }

    /// `__slots__`: which names the instances may have, where no base gives them a `__dict__`.
    fn make_slots(&mut self, class: Ref<Class>) -> R<()> {
        let Some(spec) = self.heap[class].attrs.get(&sym::SLOTS).copied() else { return Ok(()) };
        let names = match self.plain(spec) {
            Value::Str(_) => vec![spec],
            _ => self.collect(spec)?,
        };
        let mut slots = Vec::new();
        let mut originals = Vec::new();
        for name in names {
            let Value::Str(s) = self.plain(name) else {
                let message = format!("__slots__ items must be strings, not '{}'", self.type_name(name));
                return Err(self.type_error(message));
            };
            let text = self.heap[s].text.clone();
            if !text.chars().next().is_some_and(unicode_ident_start) || !text.chars().skip(1).all(unicode_ident::is_xid_continue) {
                return Err(self.type_error("__slots__ must be identifiers"));
            }
            let private = text.starts_with("__") && !text.ends_with("__");
            let owner = self.class_name(class);
            let mangled = if private { format!("_{}{text}", owner.trim_start_matches('_')) } else { text.to_string() };
            let symbol = self.symbols.intern(&mangled);
            if self.heap[class].attrs.contains_key(&symbol) && symbol != sym::SLOTS {
                return Err(self.value_error(format!("'{text}' in __slots__ conflicts with class variable")));
            }
            slots.push(symbol);
            originals.push(text);
        }
        self.add_members(class, spec, &slots, &originals)?;
        let bases = self.heap[class].bases.clone();
        let mut closed = !slots.contains(&sym::DICT);
        for base in bases {
            let base = &self.heap[base];
            match &base.slots {
                Some(inherited) => slots.extend(inherited.iter().copied()),
                None if base.builtin => {}
                None => closed = false,
            }
        }
        if closed {
            self.heap[class].slots = Some(slots);
        }
        Ok(())
    }

    /// A descriptor for each name of `__slots__`; where those are a dict, its values are their docs.
    fn add_members(&mut self, class: Ref<Class>, spec: Value, slots: &[Symbol], originals: &[Box<str>]) -> R<()> {
        let layout = self.heap[class].layout;
        let sized = matches!(layout, Layout::Int | Layout::Bytes | Layout::Tuple);
        for (&slot, original) in slots.iter().zip(originals) {
            if matches!(slot, sym::DICT | sym::WEAKREF) {
                continue;
            }
            if sized {
                let base = self.heap[class].mro.iter().find(|c| self.heap[**c].builtin).copied().unwrap_or(class);
                let message = format!("nonempty __slots__ not supported for subtype of '{}'", self.class_name(base));
                return Err(self.type_error(message));
            }
            let doc = match self.plain(spec) {
                Value::Dict(docs) => {
                    let key = self.heap.str(original.clone());
                    self.dict_get(docs, key)?.unwrap_or(Value::None)
                }
                _ => Value::None,
            };
            let member = member::new(self, class, slot, doc);
            self.heap[class].attrs.insert(slot, member);
        }
        self.attr_cache.clear();
        Ok(())
    }

    /// `__set_name__` of the attributes, then `__init_subclass__` of the parent.
    fn announce_class(&mut self, class: Ref<Class>, keywords: &[(Symbol, Value)]) -> R<()> {
        let attrs: Vec<(Symbol, Value)> = self.heap[class].attrs.iter().map(|(k, v)| (*k, *v)).collect();
        for (name, value) in attrs {
            if !matches!(value, Value::Instance(_)) {
                continue;
            }
            let text = self.symbol_text(name);
            if let Err(raise) = self.call_special(value, sym::SET_NAME, &[Value::Class(class), text]) {
                return Err(self.set_name_failed(raise, value, name, class));
            }
        }
        let parent = Value::Super(self.heap.alloc(Super { class, object: Value::Class(class), object_class: class }));
        let hook = self.get_attr(parent, sym::INIT_SUBCLASS)?;
        self.call_with(hook, Args { pos: &[], kw: keywords })?;
        Ok(())
    }

    /// An exception of `__set_name__` is the cause of the one that is seen.
    fn set_name_failed(&mut self, raise: Raise, descriptor: Value, name: Symbol, class: Ref<Class>) -> Raise {
        let Raise::Exception(cause) = raise else { return raise };
        let message = format!(
            "Error calling __set_name__ on '{}' instance '{}' in '{}'",
            self.type_name(descriptor),
            self.symbols.text(name),
            self.class_name(class)
        );
        let raise = self.error(Builtin::RuntimeError, message);
        if let Raise::Exception(e) = raise
            && let Some(data) = self.heap.exception_data_mut(e)
        {
            data.cause = cause;
            data.context = cause;
            data.suppress = true;
        }
        raise
    }

    /// Which builtin value the instances hold: the bases must agree.
    fn common_layout(&mut self, bases: &[Ref<Class>]) -> R<Layout> {
        let mut layout = Layout::Object;
        for &base in bases {
            let own = self.heap[base].layout;
            if own == Layout::Sealed {
                let message = format!("type '{}' is not an acceptable base type", self.class_name(base));
                return Err(self.type_error(message));
            }
            if own != Layout::Object && layout != Layout::Object && own != layout {
                return Err(self.type_error("multiple bases have instance lay-out conflict"));
            }
            if own != Layout::Object {
                layout = own;
            }
        }
        Ok(layout)
    }

    /// The C3 linearization of the bases (without the class itself).
    fn linearize(&mut self, bases: &[Ref<Class>]) -> R<Vec<Ref<Class>>> {
        for (i, base) in bases.iter().enumerate() {
            if bases[..i].contains(base) {
                let message = format!("duplicate base class {}", self.class_name(*base));
                return Err(self.type_error(message));
            }
        }
        let total: usize = bases.iter().map(|b| self.heap[*b].mro.len()).sum();
        self.reserve(total * 16)?;
        self.charge(400 + total as u64 * 20)?;
        if let [base] = bases {
            return Ok(self.heap[*base].mro.clone());
        }
        let mut lists: Vec<Vec<Ref<Class>>> = bases.iter().map(|b| self.heap[*b].mro.clone()).collect();
        lists.push(bases.to_vec());
        let mut out = Vec::new();
        while lists.iter().any(|l| !l.is_empty()) {
            let next = lists.iter().filter_map(|l| l.first().copied()).find(|c| !lists.iter().any(|l| l.iter().skip(1).any(|x| x == c)));
            let Some(next) = next else {
                let mut heads: Vec<Ref<Class>> = lists.iter().filter_map(|l| l.first().copied()).collect();
                for at in (1..heads.len()).rev() {
                    if heads[..at].contains(&heads[at]) {
                        heads.remove(at);
                    }
                }
                let names: Vec<String> = heads.iter().map(|b| self.class_name(*b)).collect();
                let message = format!("Cannot create a consistent method resolution\norder (MRO) for bases {}", names.join(", "));
                return Err(self.type_error(message));
            };
            self.charge(total as u64 / 4)?;
            out.push(next);
            for list in &mut lists {
                if list.first() == Some(&next) {
                    list.remove(0);
                }
            }
        }
        Ok(out)
    }
}
