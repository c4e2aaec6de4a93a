//! `len(o)`, `o[i]`, `o[i] = v`, `del o[i]`, `x in o`: which type answers them, and how.

use super::classes::Builtin;
use super::error::{R, Raise};
use super::heap::*;
use super::symbols::sym;
use super::types::{bytes, list, range, slice};
use super::value::Value;
use super::vm::Vm;
use num_traits::{Signed, ToPrimitive};

impl Vm<'_> {
    /// `len(object)`
    pub fn len(&mut self, object: Value) -> R<usize> {
        Ok(match object {
            Value::List(r) => self.heap[r].0.len(),
            Value::Tuple(r) => self.heap[r].0.len(),
            Value::Str(r) => self.heap[r].chars,
            Value::Dict(r) => self.heap[r].0.len(),
            Value::Set(r) | Value::FrozenSet(r) => self.heap[r].0.len(),
            Value::Bytes(r) => self.heap[r].0.len(),
            Value::ByteArray(r) => self.heap[r].0.len(),
            Value::View(r) => self.heap[self.heap[r].dict].0.len(),
            Value::Range(r) => match i64::try_from(self.heap[r].len()) {
                Ok(len) => len as usize,
                Err(_) => return Err(self.error(Builtin::OverflowError, "Python int too large to convert to C ssize_t".into())),
            },
            Value::Proxy(r) => match self.heap[r].0 {
                Value::Class(class) => self.heap[class].attrs.len(),
                inner => return self.len(inner),
            },
            Value::Host(_) | Value::Record(_) => match self.host_items(object)? {
                Some(items) => items.len(),
                None => return self.no_len(object),
            },
            Value::Instance(_) | Value::Class(_) => return self.len_special(object),
            _ => return self.no_len(object),
        })
    }

    fn no_len(&mut self, object: Value) -> R<usize> {
        let name = self.type_name(object);
        Err(self.type_error(format!("object of type '{name}' has no len()")))
    }

    fn len_special(&mut self, object: Value) -> R<usize> {
        let Some(method) = self.special(object, sym::LEN).filter(|m| !m.is_none()) else { return self.no_len(object) };
        if self.is_native(method) {
            let plain = self.plain(object);
            if !matches!(plain, Value::Instance(_) | Value::Class(_)) {
                return self.len(plain);
            }
        }
        let result = self.call(method, &[])?;
        let len = self.index_big(result)?;
        if len.is_negative() {
            return Err(self.value_error("__len__() should return >= 0"));
        }
        match len.to_i64() {
            Some(len) => Ok(len as usize),
            None => {
                let name = self.type_name(result);
                Err(self.error(Builtin::OverflowError, format!("cannot fit '{name}' into an index-sized integer")))
            }
        }
    }

    /// An index into a sequence of `len` items, counted from the end where negative. `what` says whose messages are meant: "list",
    /// "tuple", "string", "range" or "bytes".
    pub fn position_in(&mut self, what: &str, index: Value, len: usize) -> R<usize> {
        let outside = match what {
            "list" => "list index out of range",
            "tuple" => "tuple index out of range",
            "string" => "string index out of range",
            "range" => "range object index out of range",
            _ => "index out of range",
        };
        self.place_in(what, outside, index, len)
    }

    /// The same with another message for an index outside.
    pub fn place_in(&mut self, what: &str, outside: &str, index: Value, len: usize) -> R<usize> {
        let i = match self.pin(index) {
            Value::Int(i, _) => i,
            Value::Bool(b) => i64::from(b),
            Value::Big(_) => i64::MAX,
            other => {
                if matches!(other, Value::Float(..) | Value::Str(_) | Value::Slice(_)) || self.special(other, sym::INDEX).is_none() {
                    let name = self.type_name(other);
                    return Err(self.type_error(match what {
                        "string" => format!("string indices must be integers, not '{name}'"),
                        "bytes" => format!("byte indices must be integers or slices, not {name}"),
                        _ => format!("{what} indices must be integers or slices, not {name}"),
                    }));
                }
                self.index_big(other)?.to_i64().unwrap_or(i64::MAX)
            }
        };
        if i == i64::MAX {
            let name = self.type_name(index);
            return Err(self.error(Builtin::IndexError, format!("cannot fit '{name}' into an index-sized integer")));
        }
        let place = if i < 0 { i.saturating_add(len as i64) } else { i };
        match usize::try_from(place) {
            Ok(place) if place < len => Ok(place),
            _ => Err(self.error(Builtin::IndexError, outside.into())),
        }
    }

    /// `object[index]`
    pub fn get_item(&mut self, object: Value, index: Value) -> R<Value> {
        match (object, index) {
            (Value::List(r), Value::Int(i, h)) if h.is_none() => {
                let items = &self.heap[r].0;
                let place = if i < 0 { i.wrapping_add(items.len() as i64) } else { i };
                match items.get(place as usize) {
                    Some(&item) => Ok(item),
                    None => Err(self.error(Builtin::IndexError, "list index out of range".into())),
                }
            }
            (Value::List(r), Value::Slice(s)) => {
                let span = slice::span(self, s, self.heap[r].0.len())?;
                self.charge(span.len as u64 / 8)?;
                self.reserve(span.len * 16)?;
                let items = span.of(&self.heap[r].0);
                Ok(self.new_list(items))
            }
            (Value::List(r), _) => {
                let place = self.position_in("list", index, self.heap[r].0.len())?;
                self.get_item(object, Value::int(place as i64))
            }
            (Value::Tuple(r), Value::Slice(s)) => {
                let span = slice::span(self, s, self.heap[r].0.len())?;
                if span.step == 1 && span.len == self.heap[r].0.len() {
                    return Ok(object);
                }
                self.charge(span.len as u64 / 8)?;
                self.reserve(span.len * 16)?;
                let items = span.of(&self.heap[r].0);
                Ok(self.new_tuple(items))
            }
            (Value::Tuple(r), _) => {
                let place = self.position_in("tuple", index, self.heap[r].0.len())?;
                Ok(self.heap[r].0[place])
            }
            (Value::Dict(r), _) => match self.dict_get(r, index)? {
                Some(value) => Ok(value),
                None => Err(self.key_error(index)),
            },
            (Value::Str(r), _) => self.get_character(r, index),
            (Value::Bytes(_) | Value::ByteArray(_), _) => bytes::get_item(self, object, index),
            (Value::Range(r), _) => range::get_item(self, r, index),
            (Value::Host(_) | Value::Record(_), _) => match self.host_items(object)? {
                Some(items) => {
                    let items = self.new_tuple(items.as_slice());
                    self.get_item(items, index)
                }
                None => self.not_subscriptable(object),
            },
            (Value::Proxy(r), _) => match self.heap[r].0 {
                Value::Class(class) => self.class_entry(class, index),
                inner => self.get_item(inner, index),
            },
            (Value::Instance(_) | Value::Class(_), _) => self.get_item_special(object, index),
            (Value::Alias(r), _) => self.filled_alias(object, r, index),
            _ => self.not_subscriptable(object),
        }
    }

    /// `list[T][int]`: the type variables among the arguments are replaced, in order.
    fn filled_alias(&mut self, object: Value, alias: Ref<Alias>, index: Value) -> R<Value> {
        let Alias { origin, args } = self.heap[alias].clone();
        let mut variables: Vec<Value> = Vec::new();
        for &arg in &args {
            if matches!(arg, Value::Instance(_)) && self.type_name(arg) == "TypeVar" && !variables.iter().any(|v| v.is(arg)) {
                variables.push(arg);
            }
        }
        if variables.is_empty() {
            let shown = self.repr(object)?;
            return Err(self.type_error(format!("{shown} is not a generic class")));
        }
        let given = match index {
            Value::Tuple(t) => self.heap[t].0.to_vec(),
            one => vec![one],
        };
        if given.len() != variables.len() {
            let (shown, few) = (self.repr(object)?, if given.len() < variables.len() { "few" } else { "many" });
            let (n, wanted) = (given.len(), variables.len());
            return Err(self.type_error(format!("Too {few} arguments for {shown}; actual {n}, expected {wanted}")));
        }
        let filled = |arg: &Value| variables.iter().position(|v| v.is(*arg)).map_or(*arg, |i| given[i]);
        let args = args.iter().map(filled).collect();
        Ok(Value::Alias(self.heap.alloc(Alias { origin, args })))
    }

    fn get_character(&mut self, text: Ref<Str>, index: Value) -> R<Value> {
        let len = self.heap[text].chars;
        let span = match index {
            Value::Slice(s) => slice::span(self, s, len)?,
            _ => {
                let start = self.position_in("string", index, len)? as isize;
                slice::Span { start, step: 1, len: 1, stop: start + 1 }
            }
        };
        // Where characters are of several sizes, those before it are counted.
        let bytes = self.heap[text].text.len();
        let passed = if bytes == len { 0 } else { span.start.max(span.stop).max(0) as u64 / 4 };
        self.charge(span.len as u64 / 32 + passed)?;
        let Str { text, .. } = &self.heap[text];
        let part: String = if text.len() == len {
            span.indices().map(|i| char::from(text.as_bytes()[i])).collect()
        } else if span.step == 1 {
            text.chars().skip(span.start as usize).take(span.len).collect()
        } else {
            let chars: Vec<char> = text.chars().collect();
            span.indices().map(|i| chars[i]).collect()
        };
        Ok(self.new_str(part))
    }

    fn not_subscriptable<T>(&mut self, object: Value) -> R<T> {
        let name = self.type_name(object);
        Err(self.type_error(format!("'{name}' object is not subscriptable")))
    }

    /// `vars(Class)[name]`
    fn class_entry(&mut self, class: Ref<Class>, name: Value) -> R<Value> {
        if let Value::Str(s) = name
            && let Some(symbol) = self.symbols.find(&self.heap[s].text)
            && let Some(&value) = self.heap[class].attrs.get(&symbol)
        {
            return Ok(value);
        }
        Err(self.key_error(name))
    }

    fn get_item_special(&mut self, object: Value, index: Value) -> R<Value> {
        if let Some(method) = self.special(object, sym::GETITEM).filter(|m| !m.is_none()) {
            if self.is_native(method) {
                return match self.plain(object) {
                    Value::Dict(dict) => match self.dict_get(dict, index)? {
                        Some(value) => Ok(value),
                        None => self.missing(object, index),
                    },
                    Value::Instance(_) | Value::Class(_) => self.call(method, &[index]),
                    plain => self.get_item(plain, index),
                };
            }
            return self.call(method, &[index]);
        }
        let Value::Class(class) = object else { return self.not_subscriptable(object) };
        if class == Builtin::Type.class() {
            return Ok(self.alias(object, index));
        }
        match self.get_attr_opt(object, sym::CLASS_GETITEM)? {
            Some(method) => self.call(method, &[index]),
            None => {
                let name = self.str_of_name(class);
                Err(self.type_error(format!("type '{name}' is not subscriptable")))
            }
        }
    }

    fn str_of_name(&self, class: Ref<Class>) -> String {
        match self.heap[class].name {
            Value::Str(s) => self.heap[s].text.to_string(),
            _ => String::new(),
        }
    }

    /// What a subclass of dict answers for a key that is not there: `__missing__`, else KeyError.
    pub(super) fn missing(&mut self, object: Value, key: Value) -> R<Value> {
        match self.special(object, sym::MISSING) {
            Some(method) => self.call(method, &[key]),
            None => Err(self.key_error(key)),
        }
    }

    /// `list[int]`
    pub fn alias(&mut self, origin: Value, index: Value) -> Value {
        let args = match index {
            Value::Tuple(t) => self.heap[t].0.to_vec(),
            one => vec![one],
        };
        Value::Alias(self.heap.alloc(Alias { origin, args }))
    }

    /// `object[index] = value`
    pub fn set_item(&mut self, object: Value, index: Value, value: Value) -> R<()> {
        match object {
            Value::List(r) => match index {
                Value::Slice(s) => list::set_slice(self, r, s, value),
                _ => {
                    let place = self.place_in("list", "list assignment index out of range", index, self.heap[r].0.len())?;
                    self.heap[r].0[place] = value;
                    Ok(())
                }
            },
            Value::Dict(r) => self.dict_set(r, index, value),
            Value::ByteArray(r) => bytes::set_item(self, r, index, value),
            Value::Instance(_) | Value::Class(_) => match self.special(object, sym::SETITEM).filter(|m| !m.is_none()) {
                Some(method) if self.is_native(method) && !matches!(self.plain(object), Value::Instance(_) | Value::Class(_)) => {
                    let plain = self.plain(object);
                    self.set_item(plain, index, value)
                }
                Some(method) => self.call(method, &[index, value]).map(|_| ()),
                None => Err(self.refused(object, "does not support item assignment")),
            },
            _ => Err(self.refused(object, "does not support item assignment")),
        }
    }

    fn refused(&mut self, object: Value, what: &str) -> Raise {
        let name = self.type_name(object);
        self.type_error(format!("'{name}' object {what}"))
    }

    /// `del object[index]`
    pub fn del_item(&mut self, object: Value, index: Value) -> R<()> {
        match object {
            Value::List(r) => match index {
                Value::Slice(s) => list::del_slice(self, r, s),
                _ => {
                    let place = self.place_in("list", "list assignment index out of range", index, self.heap[r].0.len())?;
                    self.charge((self.heap[r].0.len() - place) as u64 / 64)?;
                    self.heap[r].0.remove(place);
                    Ok(())
                }
            },
            Value::ByteArray(r) => bytes::del_item(self, r, index),
            Value::Dict(r) => match self.dict_remove(r, index)? {
                Some(_) => Ok(()),
                None => Err(self.key_error(index)),
            },
            Value::Instance(_) | Value::Class(_) => match self.special(object, sym::DELITEM).filter(|m| !m.is_none()) {
                Some(method) if self.is_native(method) && !matches!(self.plain(object), Value::Instance(_) | Value::Class(_)) => {
                    let plain = self.plain(object);
                    self.del_item(plain, index)
                }
                Some(method) => self.call(method, &[index]).map(|_| ()),
                None => Err(self.refused(object, "doesn't support item deletion")),
            },
            _ => Err(self.refused(object, "doesn't support item deletion")),
        }
    }

    /// `item in container`
    pub fn contains(&mut self, container: Value, item: Value) -> R<bool> {
        match container {
            Value::List(r) => {
                let mut i = 0;
                while let Some(&candidate) = self.heap[r].0.get(i) {
                    self.charge(1)?;
                    if self.eq(candidate, item)? {
                        return Ok(true);
                    }
                    i += 1;
                }
                Ok(false)
            }
            Value::Tuple(r) => {
                let items = self.heap[r].0.clone();
                self.any_equal(&items, item)
            }
            Value::Dict(r) => Ok(self.dict_get(r, item)?.is_some()),
            Value::Set(r) | Value::FrozenSet(r) => self.set_contains(r, item),
            Value::Str(r) => match self.plain(item) {
                Value::Str(part) => {
                    self.charge(self.heap[r].text.len() as u64 / 64)?;
                    Ok(self.heap[r].text.contains(&*self.heap[part].text))
                }
                other => {
                    let name = self.type_name(other);
                    Err(self.type_error(format!("'in <string>' requires string as left operand, not {name}")))
                }
            },
            Value::Bytes(_) | Value::ByteArray(_) => bytes::contains(self, container, item),
            Value::Range(r) => range::contains(self, r, item),
            Value::View(r) => self.view_contains(r, item),
            Value::Proxy(r) => match self.heap[r].0 {
                Value::Class(class) => match self.class_entry(class, item) {
                    Ok(_) => Ok(true),
                    Err(Raise::Exception(_)) => Ok(false),
                    Err(stop) => Err(stop),
                },
                inner => self.contains(inner, item),
            },
            Value::Host(_) | Value::Record(_) => match self.host_items(container)? {
                Some(items) => self.any_equal(&items, item),
                None => self.not_a_container(container),
            },
            Value::Iter(_) | Value::Generator(_) => self.contains_by_iteration(container, item),
            Value::Instance(_) | Value::Class(_) => self.contains_special(container, item),
            _ => self.not_a_container(container),
        }
    }

    fn not_a_container<T>(&mut self, container: Value) -> R<T> {
        let name = self.type_name(container);
        Err(self.type_error(format!("argument of type '{name}' is not iterable")))
    }

    fn any_equal(&mut self, items: &[Value], item: Value) -> R<bool> {
        for &candidate in items {
            self.charge(1)?;
            if self.eq(candidate, item)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// `item in set`; a set stands for the frozenset of the same items.
    pub(super) fn set_contains(&mut self, set: Ref<Set>, item: Value) -> R<bool> {
        let key = self.set_key(item);
        self.set_has(set, key)
    }

    /// The key that `item` is in look-ups of sets: a set stands for the frozenset of the same items.
    pub(super) fn set_key(&mut self, item: Value) -> Value {
        match self.plain(item) {
            Value::Set(inner) => {
                let copy = self.heap[inner].clone();
                Value::FrozenSet(self.heap.alloc(copy))
            }
            _ => item,
        }
    }

    fn view_contains(&mut self, view: Ref<View>, item: Value) -> R<bool> {
        let View { kind, dict } = self.heap[view];
        match kind {
            ViewKind::Keys => Ok(self.dict_get(dict, item)?.is_some()),
            ViewKind::Values => {
                let values: Vec<Value> = self.heap[dict].0.iter().map(|e| e.value).collect();
                self.any_equal(&values, item)
            }
            ViewKind::Items => {
                let Value::Tuple(pair) = self.plain(item) else { return Ok(false) };
                let &[key, value] = self.heap[pair].0.as_slice() else { return Ok(false) };
                match self.dict_get(dict, key)? {
                    Some(found) => self.eq(found, value),
                    None => Ok(false),
                }
            }
        }
    }

    fn contains_special(&mut self, container: Value, item: Value) -> R<bool> {
        if self.refuses(container, sym::CONTAINS) {
            let name = self.type_name(container);
            return Err(self.type_error(format!("'{name}' object is not a container")));
        }
        match self.special(container, sym::CONTAINS) {
            Some(method) if self.is_native(method) && !matches!(self.plain(container), Value::Instance(_) | Value::Class(_)) => {
                let plain = self.plain(container);
                self.contains(plain, item)
            }
            Some(method) => {
                let verdict = self.call(method, &[item])?;
                self.truth(verdict)
            }
            None if self.special(container, sym::ITER).is_none() && self.special(container, sym::GETITEM).is_none() => {
                self.not_a_container(container)
            }
            None => self.contains_by_iteration(container, item),
        }
    }

    pub(super) fn contains_by_iteration(&mut self, container: Value, item: Value) -> R<bool> {
        let mut found = false;
        self.for_each(container, |vm, candidate| {
            found = vm.eq(candidate, item)?;
            Ok(!found)
        })?;
        Ok(found)
    }
}
