//! `match`: what patterns ask.

use super::Vm;
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::heap::*;
use crate::python::symbols::sym;
use crate::python::value::{Symbol, Value};

impl Vm<'_> {
    /// Whether a sequence pattern looks into it: lists, tuples, ranges, and what registers as a `Sequence`; never text.
    pub(super) fn match_sequence(&mut self, value: Value) -> bool {
        match self.plain(value) {
            Value::List(_) | Value::Tuple(_) | Value::Range(_) => true,
            Value::Host(_) | Value::Record(_) => self.host_items(value).is_ok_and(|items| items.is_some()),
            Value::Instance(_) => self.is_deque(value) || self.is_abstract(value, "Sequence"),
            _ => false,
        }
    }

    /// Whether a mapping pattern looks into it.
    pub(super) fn match_mapping(&mut self, value: Value) -> bool {
        match self.plain(value) {
            Value::Dict(_) | Value::Proxy(_) => true,
            Value::Instance(_) => self.is_abstract(value, "Mapping"),
            _ => false,
        }
    }

    /// A `deque` is a sequence even where nobody has asked for the abstract classes.
    fn is_deque(&mut self, value: Value) -> bool {
        let class = self.class_of(value);
        let deque = self.heap[class].mro.iter().copied().find(|c| self.class_name(*c) == "deque");
        let module = deque.and_then(|c| self.get_attr_opt(Value::Class(c), sym::MODULE).ok().flatten());
        matches!(module, Some(Value::Str(text)) if self.text(text) == "collections")
    }

    /// `isinstance(value, collections.abc.NAME)`, where a program has imported that.
    fn is_abstract(&mut self, value: Value, name: &str) -> bool {
        let Some(module) = self.symbols.find("_collections_abc") else { return false };
        let Some(&module) = self.modules.get(&module) else { return false };
        let name = self.symbols.intern(name);
        let Ok(Some(class)) = self.get_attr_opt(Value::Module(module), name) else { return false };
        self.isinstance(value, class).unwrap_or(false)
    }

    /// The values of these keys; None where one is missing.
    pub(super) fn match_keys(&mut self, subject: Value, keys: Value) -> R<Value> {
        let keys = self.collect(keys)?;
        let mut seen: Vec<Value> = Vec::new();
        let mut values = Vec::new();
        for key in keys {
            for other in &seen {
                if self.eq(*other, key)? {
                    let message = format!("mapping pattern checks duplicate key ({})", self.repr(key)?);
                    return Err(self.value_error(message));
                }
            }
            seen.push(key);
            let found = match subject {
                Value::Dict(d) => self.dict_get(d, key)?,
                _ => {
                    let get = self.symbols.intern("get");
                    let marker = Builtin::Object.value();
                    let value = self.call_method(subject, get, &[key, marker])?;
                    if value.is(marker) { None } else { Some(value) }
                }
            };
            match found {
                Some(value) => values.push(value),
                None => return Ok(Value::None),
            }
        }
        Ok(self.heap.tuple(values))
    }

    /// The attributes that a class pattern binds; None where it does not match.
    pub(super) fn match_class(&mut self, subject: Value, class: Value, positional: usize, names: Value) -> R<Value> {
        let Value::Class(c) = class else {
            return Err(self.type_error("called match pattern must be a type"));
        };
        if !self.isinstance(subject, class)? {
            return Ok(Value::None);
        }
        let mut values = Vec::new();
        let mut seen: Vec<Symbol> = Vec::new();
        if positional > 0 {
            match self.get_attr_opt(class, sym::MATCH_ARGS)? {
                Some(args) => {
                    let Value::Tuple(args) = args else {
                        let message = format!("{}.__match_args__ must be a tuple (got {})", self.class_name(c), self.type_name(args));
                        return Err(self.type_error(message));
                    };
                    let allowed = self.heap[args].0.len();
                    if positional > allowed {
                        return Err(self.too_many_patterns(c, allowed, positional));
                    }
                    for i in 0..positional {
                        let name = self.heap[args].0[i];
                        if !matches!(name, Value::Str(_)) {
                            let message = format!("__match_args__ elements must be strings (got {})", self.type_name(name));
                            return Err(self.type_error(message));
                        }
                        let name = self.intern_value(name);
                        if seen.contains(&name) {
                            return Err(self.repeated_attribute(c, name));
                        }
                        seen.push(name);
                    }
                }
                None if self.matches_itself(c) => {
                    if positional > 1 {
                        return Err(self.too_many_patterns(c, 1, positional));
                    }
                    values.push(subject);
                }
                None => return Err(self.too_many_patterns(c, 0, positional)),
            }
        }
        for name in self.collect(names)? {
            let name = self.intern_value(name);
            if seen.contains(&name) {
                return Err(self.repeated_attribute(c, name));
            }
            seen.push(name);
        }
        for name in seen {
            match self.get_attr_opt(subject, name)? {
                Some(value) => values.push(value),
                None => return Ok(Value::None),
            }
        }
        Ok(self.heap.tuple(values))
    }

    fn repeated_attribute(&mut self, class: Ref<Class>, name: Symbol) -> crate::python::error::Raise {
        let message = format!("{}() got multiple sub-patterns for attribute '{}'", self.class_name(class), self.symbols.text(name));
        self.type_error(message)
    }

    fn too_many_patterns(&mut self, class: Ref<Class>, allowed: usize, given: usize) -> crate::python::error::Raise {
        let s = if allowed == 1 { "" } else { "s" };
        let message = format!("{}() accepts {allowed} positional sub-pattern{s} ({given} given)", self.class_name(class));
        self.type_error(message)
    }

    /// The builtin types whose single positional pattern is the subject itself.
    fn matches_itself(&self, class: Ref<Class>) -> bool {
        use Builtin as B;
        [B::Bool, B::ByteArray, B::Bytes, B::Dict, B::Float, B::FrozenSet, B::Int, B::List, B::Set, B::Str, B::Tuple]
            .iter()
            .any(|b| self.is_subclass(class, b.class()))
    }

    /// A copy of a mapping without some keys: `**rest`.
    pub(super) fn match_rest(&mut self, subject: Value, keys: Value) -> R<Value> {
        let rest = self.heap.dict();
        self.update_from_mapping(rest, subject)?;
        for key in self.collect(keys)? {
            self.dict_remove(rest, key)?;
        }
        Ok(Value::Dict(rest))
    }
}
