//! Iteration: `iter()`, `next()`, and taking all items of something at once.

use super::classes::Builtin;
use super::error::{R, Raise};
use super::heap::*;
use super::iter::IterState;
use super::modules::itertools;
use super::symbols::sym;
use super::value::{BinaryOp, Symbol, Value};
use super::vm::Vm;

/// The size of a value, in bytes, as memory limits count it.
pub(super) const VALUE: usize = std::mem::size_of::<Value>();

impl Vm<'_> {
    /// A new native iterator.
    pub fn new_iter(&mut self, state: IterState) -> Value {
        Value::Iter(self.heap.alloc(Iter(state)))
    }

    /// `iter(object)`
    pub fn iter(&mut self, object: Value) -> R<Value> {
        let state = match object {
            Value::List(list) => IterState::List { list, index: 0 },
            Value::Range(range) => range_state(self.heap[range]),
            Value::Tuple(tuple) => IterState::Tuple { tuple, index: 0 },
            Value::Str(str) => IterState::Str { str, offset: 0 },
            Value::Dict(dict) => self.dict_state(dict, ViewKind::Keys),
            Value::View(view) => {
                let View { kind, dict } = self.heap[view];
                self.dict_state(dict, kind)
            }
            Value::Set(set) | Value::FrozenSet(set) => IterState::Set { set, position: 0, len: self.heap[set].0.len() },
            Value::Bytes(bytes) => IterState::Bytes { bytes, index: 0 },
            Value::ByteArray(bytes) => IterState::ByteArray { bytes, index: 0 },
            Value::Iter(_) | Value::Generator(_) => return Ok(object),
            Value::Proxy(proxy) => match self.heap[proxy].0 {
                Value::Class(_) => {
                    let items = self.collect(object)?;
                    IterState::Items { items: items.into(), index: 0 }
                }
                inner => return self.iter(inner),
            },
            Value::Host(_) | Value::Record(_) => match self.host_items(object)? {
                Some(items) => IterState::Items { items: items.to_vec().into(), index: 0 },
                None => return self.not_iterable(object),
            },
            Value::Instance(_) | Value::Class(_) => return self.iter_special(object),
            _ => return self.not_iterable(object),
        };
        Ok(self.new_iter(state))
    }

    fn not_iterable<T>(&mut self, object: Value) -> R<T> {
        let name = self.type_name(object);
        Err(self.type_error(format!("'{name}' object is not iterable")))
    }

    fn dict_state(&self, dict: Ref<Dict>, kind: ViewKind) -> IterState {
        IterState::Dict { dict, kind, position: 0, len: self.heap[dict].0.len() }
    }

    /// Through the class's `__iter__`, or `__getitem__` from 0 on.
    fn iter_special(&mut self, object: Value) -> R<Value> {
        if self.refuses(object, sym::ITER) {
            return self.not_iterable(object);
        }
        let Some(method) = self.special(object, sym::ITER) else {
            return match self.special(object, sym::GETITEM) {
                Some(_) => Ok(self.new_iter(IterState::Sequence { object, index: 0 })),
                None => self.not_iterable(object),
            };
        };
        if self.is_native(method) {
            let plain = self.plain(object);
            if !matches!(plain, Value::Instance(_) | Value::Class(_)) {
                return self.iter(plain);
            }
        }
        let iter = self.call(method, &[])?;
        let good = match iter {
            Value::Iter(_) | Value::Generator(_) => true,
            _ => self.special(iter, sym::NEXT).is_some(),
        };
        if !good {
            let name = self.type_name(iter);
            return Err(self.type_error(format!("iter() returned non-iterator of type '{name}'")));
        }
        Ok(iter)
    }

    /// True where the class says by None that it does not have this special method.
    pub(super) fn refuses(&mut self, object: Value, name: Symbol) -> bool {
        let class = self.class_of(object);
        self.class_attr(class, name).is_some_and(|method| method.is_none())
    }

    /// True for a method written in Rust, bound to its receiver.
    pub(super) fn is_native(&self, method: Value) -> bool {
        matches!(method, Value::Method(m) if matches!(self.heap[m].callee, Value::Native(_)))
    }

    /// The next item of an iterator; `None` at its end.
    pub fn next(&mut self, iter: Value) -> R<Option<Value>> {
        let Value::Iter(r) = iter else { return self.next_other(iter) };
        match &mut self.heap[r].0 {
            IterState::List { list, index } => {
                let (list, i) = (*list, *index);
                *index += 1;
                if let Some(&item) = self.heap[list].0.get(i) {
                    return Ok(Some(item));
                }
            }
            IterState::Range { next, step, left } => {
                if *left > 0 {
                    let value = *next;
                    *left -= 1;
                    *next = value.wrapping_add(*step);
                    return Ok(Some(Value::int(value)));
                }
            }
            IterState::Tuple { tuple, index } => {
                let (tuple, i) = (*tuple, *index);
                *index += 1;
                if let Some(&item) = self.heap[tuple].0.get(i) {
                    return Ok(Some(item));
                }
            }
            IterState::Items { items, index } => {
                if let Some(&item) = items.get(*index) {
                    *index += 1;
                    return Ok(Some(item));
                }
            }
            IterState::Dict { .. } | IterState::DictReversed { .. } => return self.next_of_dict(r),
            IterState::Set { set, position, len } => {
                let (set, from, len) = (*set, *position, *len);
                if self.heap[set].0.len() != len {
                    if let IterState::Set { len, .. } = &mut self.heap[r].0 {
                        *len = usize::MAX;
                    }
                    return Err(self.error(Builtin::RuntimeError, "Set changed size during iteration".into()));
                }
                if let Some((at, entry)) = self.heap[set].0.next_from(from) {
                    self.charge((at - from) as u64 / 16)?;
                    if let IterState::Set { position, .. } = &mut self.heap[r].0 {
                        *position = at + 1;
                    }
                    return Ok(Some(entry.key));
                }
            }
            IterState::Enumerate { iter, count } => {
                let (iter, count) = (*iter, *count);
                return self.next_enumerated(r, iter, count);
            }
            IterState::Zip { .. } => return self.next_zipped(r),
            IterState::Done(_) => return Ok(None),
            IterState::Tool(_) => return itertools::next(self, r),
            _ => return self.next_rare(r),
        }
        self.heap[r].0.finish();
        Ok(None)
    }

    /// The next item of an iterator within another: as deep as the program nested them, RecursionError in place of an overflow.
    #[inline]
    pub(super) fn next_inner(&mut self, iter: Value) -> R<Option<Value>> {
        match iter {
            Value::Iter(r) if self.heap[r].0.is_composed() => self.nested("", |vm| vm.next(iter)),
            _ => self.next(iter),
        }
    }

    fn next_of_dict(&mut self, r: Ref<Iter>) -> R<Option<Value>> {
        let (dict, kind, from, len, back) = match self.heap[r].0 {
            IterState::Dict { dict, kind, position, len } => (dict, kind, position, len, false),
            IterState::DictReversed { dict, kind, position, len } => (dict, kind, position, len, true),
            _ => return Ok(None),
        };
        let table = &self.heap[dict].0;
        let changed = table.len() != len;
        let found = if back { table.last_before(from) } else { table.next_from(from) };
        let found = found.filter(|_| !changed);
        if let IterState::Dict { position, len, .. } | IterState::DictReversed { position, len, .. } = &mut self.heap[r].0 {
            if changed {
                *len = usize::MAX;
            }
            if let Some((at, _)) = found {
                *position = if back { at } else { at + 1 };
            }
        }
        if changed {
            return Err(self.error(Builtin::RuntimeError, "dictionary changed size during iteration".into()));
        }
        let Some((at, entry)) = found else {
            self.heap[r].0.finish();
            return Ok(None);
        };
        self.charge(at.abs_diff(from) as u64 / 16)?;
        Ok(Some(match kind {
            ViewKind::Keys => entry.key,
            ViewKind::Values => entry.value,
            ViewKind::Items => self.new_tuple([entry.key, entry.value].as_slice()),
        }))
    }

    fn next_enumerated(&mut self, r: Ref<Iter>, iter: Value, count: Value) -> R<Option<Value>> {
        let Some(item) = self.next_inner(iter)? else { return Ok(None) };
        let following = match count {
            Value::Int(n, h) if h.is_none() && n < i64::MAX => Value::int(n + 1),
            _ => self.binary(BinaryOp::Add, count, Value::int(1))?,
        };
        if let IterState::Enumerate { count, .. } = &mut self.heap[r].0 {
            *count = following;
        }
        Ok(Some(self.new_tuple([count, item].as_slice())))
    }

    fn next_zipped(&mut self, r: Ref<Iter>) -> R<Option<Value>> {
        let mut row = smallvec::SmallVec::<[Value; 3]>::new();
        loop {
            let (iter, strict) = match &self.heap[r].0 {
                IterState::Zip { iters, strict } => match iters.get(row.len()) {
                    Some(&iter) => (iter, *strict),
                    None => break,
                },
                _ => return Ok(None),
            };
            match self.next_inner(iter)? {
                Some(item) => row.push(item),
                None if strict => return self.zip_ends(r, row.len()),
                None => return Ok(None),
            }
        }
        if row.is_empty() { Ok(None) } else { Ok(Some(self.new_tuple(row))) }
    }

    /// `zip(strict=True)`: the iterator at `at` is the first that ended; all the others must have ended too.
    fn zip_ends(&mut self, r: Ref<Iter>, at: usize) -> R<Option<Value>> {
        let plural = |n: usize| if n == 1 { " 1".to_string() } else { format!("s 1-{n}") };
        if at > 0 {
            return Err(self.value_error(format!("zip() argument {} is shorter than argument{}", at + 1, plural(at))));
        }
        let mut i = 1;
        while let IterState::Zip { iters, .. } = &self.heap[r].0 {
            let Some(&iter) = iters.get(i) else { break };
            if self.next_inner(iter)?.is_some() {
                return Err(self.value_error(format!("zip() argument {} is longer than argument{}", i + 1, plural(i))));
            }
            i += 1;
        }
        Ok(None)
    }

    fn next_rare(&mut self, r: Ref<Iter>) -> R<Option<Value>> {
        match &mut self.heap[r].0 {
            IterState::ListReversed { list, left } => {
                let (list, n) = (*list, *left);
                if n > 0 {
                    *left -= 1;
                    if let Some(&item) = self.heap[list].0.get(n - 1) {
                        return Ok(Some(item));
                    }
                }
            }
            IterState::BigRange { range, next } => {
                if *next < range.len() {
                    let value = num_bigint::BigInt::from(range.start) + num_bigint::BigInt::from(range.step) * *next;
                    *next += 1;
                    return Ok(Some(self.heap.big(value)));
                }
            }
            IterState::Str { str, offset } => {
                let (str, at) = (*str, *offset);
                if let Some(c) = self.heap[str].text.get(at..).and_then(|t| t.chars().next()) {
                    if let IterState::Str { offset, .. } = &mut self.heap[r].0 {
                        *offset += c.len_utf8();
                    }
                    let mut buffer = [0; 4];
                    return Ok(Some(self.new_str(&*c.encode_utf8(&mut buffer))));
                }
            }
            IterState::Bytes { bytes, index } => {
                let (bytes, i) = (*bytes, *index);
                *index += 1;
                if let Some(&byte) = self.heap[bytes].0.get(i) {
                    return Ok(Some(Value::int(byte.into())));
                }
            }
            IterState::ByteArray { bytes, index } => {
                let (bytes, i) = (*bytes, *index);
                *index += 1;
                if let Some(&byte) = self.heap[bytes].0.get(i) {
                    return Ok(Some(Value::int(byte.into())));
                }
            }
            IterState::Map { .. } => return self.next_mapped(r),
            IterState::Filter { function, iter } => {
                let (function, iter) = (*function, *iter);
                while let Some(item) = self.next_inner(iter)? {
                    self.charge(1)?;
                    let kept = match function {
                        Value::None => self.truth(item)?,
                        _ => {
                            let verdict = self.call(function, &[item])?;
                            self.truth(verdict)?
                        }
                    };
                    if kept {
                        return Ok(Some(item));
                    }
                }
                return Ok(None);
            }
            IterState::Call { function, sentinel } => {
                let (function, sentinel) = (*function, *sentinel);
                let result = self.call(function, &[]);
                if let Some(item) = self.or_end(result)?
                    && !self.eq(item, sentinel)?
                {
                    return Ok(Some(item));
                }
            }
            IterState::Sequence { object, index } => {
                let (object, i) = (*object, *index);
                *index = i.saturating_add(1);
                if let Some(item) = self.item_or_end(object, i)? {
                    return Ok(Some(item));
                }
            }
            IterState::SequenceReversed { object, left } => {
                let (object, n) = (*object, *left);
                if n > 0 {
                    *left -= 1;
                    if let Some(item) = self.item_or_end(object, n - 1)? {
                        return Ok(Some(item));
                    }
                }
            }
            _ => return Ok(None),
        }
        self.heap[r].0.finish();
        Ok(None)
    }

    fn next_mapped(&mut self, r: Ref<Iter>) -> R<Option<Value>> {
        let mut row = smallvec::SmallVec::<[Value; 4]>::new();
        loop {
            let (iter, function) = match &self.heap[r].0 {
                IterState::Map { iters, function } => (iters.get(row.len()).copied(), *function),
                _ => return Ok(None),
            };
            let Some(iter) = iter else { return self.call(function, &row).map(Some) };
            match self.next_inner(iter)? {
                Some(item) => row.push(item),
                None => return Ok(None),
            }
        }
    }

    /// A result, or `None` where it is a StopIteration.
    pub(super) fn or_end(&mut self, result: R<Value>) -> R<Option<Value>> {
        match result {
            Ok(value) => Ok(Some(value)),
            Err(Raise::Exception(e)) if self.is_instance(e, Builtin::StopIteration) => Ok(None),
            Err(other) => Err(other),
        }
    }

    fn item_or_end(&mut self, object: Value, index: i64) -> R<Option<Value>> {
        match self.get_item(object, Value::int(index)) {
            Err(Raise::Exception(e)) if self.is_instance(e, Builtin::IndexError) => Ok(None),
            result => self.or_end(result),
        }
    }

    fn next_other(&mut self, iter: Value) -> R<Option<Value>> {
        match iter {
            Value::Generator(g) => self.resume_generator(g, Value::None),
            Value::Instance(_) | Value::Class(_) => {
                let Some(method) = self.special(iter, sym::NEXT) else { return self.not_an_iterator(iter) };
                let result = self.call(method, &[]);
                self.or_end(result)
            }
            _ => self.not_an_iterator(iter),
        }
    }

    fn not_an_iterator<T>(&mut self, value: Value) -> R<T> {
        let name = self.type_name(value);
        Err(self.type_error(format!("'{name}' object is not an iterator")))
    }

    /// All items of an iterable.
    pub fn collect(&mut self, iterable: Value) -> R<Vec<Value>> {
        let heap = &self.heap;
        let items: Vec<Value> = match iterable {
            Value::List(list) => heap[list].0.clone(),
            Value::Tuple(tuple) => heap[tuple].0.to_vec(),
            Value::Dict(dict) => heap[dict].0.iter().map(|e| e.key).collect(),
            Value::Set(set) | Value::FrozenSet(set) => heap[set].0.iter().map(|e| e.key).collect(),
            Value::View(view) if heap[view].kind == ViewKind::Keys => heap[heap[view].dict].0.iter().map(|e| e.key).collect(),
            Value::View(view) if heap[view].kind == ViewKind::Values => heap[heap[view].dict].0.iter().map(|e| e.value).collect(),
            Value::Proxy(proxy) if matches!(heap[proxy].0, Value::Class(_)) => {
                let Value::Class(class) = heap[proxy].0 else { return Ok(Vec::new()) };
                let names: Vec<_> = heap[class].attrs.keys().copied().collect();
                names.into_iter().map(|s| self.heap.str(self.symbols.text(s))).collect()
            }
            Value::Range(range) => return self.collect_range(self.heap[range]),
            _ => {
                let iter = self.iter(iterable)?;
                return self.collect_iter(iter);
            }
        };
        self.charge(items.len() as u64 / 8)?;
        self.reserve(items.len() * VALUE)?;
        Ok(items)
    }

    fn collect_range(&mut self, range: Range) -> R<Vec<Value>> {
        let len = usize::try_from(range.len()).unwrap_or(usize::MAX);
        self.reserve(len.saturating_mul(VALUE))?;
        self.charge(len as u64 / 4)?;
        Ok((0..len as i128).map(|i| self.heap.big(range.start.wrapping_add(range.step.wrapping_mul(i)).into())).collect())
    }

    fn collect_iter(&mut self, iter: Value) -> R<Vec<Value>> {
        let mut items = Vec::new();
        while let Some(item) = self.next(iter)? {
            if items.len() == items.capacity() && items.len() > 1024 {
                self.reserve(items.len() * 2 * VALUE)?;
            }
            self.charge(1)?;
            items.push(item);
        }
        Ok(items)
    }

    /// Calls `f` with each item until it answers false.
    pub fn for_each(&mut self, iterable: Value, mut f: impl FnMut(&mut Self, Value) -> R<bool>) -> R<()> {
        let iter = self.iter(iterable)?;
        while let Some(item) = self.next(iter)? {
            self.charge(1)?;
            if !f(self, item)? {
                break;
            }
        }
        Ok(())
    }
}

/// The iterator of a range.
pub(super) fn range_state(range: Range) -> IterState {
    let len = range.len();
    let last = range.start.checked_add(range.step.saturating_mul(i128::try_from(len).unwrap_or(i128::MAX)));
    match (i64::try_from(range.start), i64::try_from(range.step), last.map(i64::try_from), u64::try_from(len)) {
        (Ok(next), Ok(step), Some(Ok(_)), Ok(left)) => IterState::Range { next, step, left },
        _ => IterState::BigRange { range, next: 0 },
    }
}

/// The iterator of a range backwards.
pub(super) fn range_reversed(range: Range) -> IterState {
    let len = i128::try_from(range.len()).unwrap_or(i128::MAX);
    let last = range.start.saturating_add(range.step.saturating_mul(len - 1));
    range_state(Range { start: last, stop: range.start.saturating_sub(range.step), step: range.step.saturating_neg() })
}
