//! Hashes and the look-up of keys in dicts and sets.
//!
//! The table only offers candidates; here it is decided whether one equals the key, on the heap alone where that is possible, else through
//! `__eq__`, which may change the very table that is being searched. A traced number that serves as a key is pinned: where a key goes
//! depends on its value to the last bit.

use super::classes::Builtin;
use super::error::R;
use super::heap::*;
use super::numbers::{hash_big, hash_float};
use super::symbols::sym;
use super::table::Table;
use super::value::Value;
use super::vm::Vm;
use num_traits::ToPrimitive;
use std::ops::{Index, IndexMut};

/// Growth of a table, in bytes, from which the memory limit is looked at without waiting for the next safe point.
const LARGE: usize = 1 << 16;
/// Tuples nested deeper than this are compared by the machine, which guards its recursion.
const SHALLOW: u32 = 16;

/// What has a table of keys: dicts and sets.
pub trait Keyed: Stored {
    /// Its table.
    fn table(&self) -> &Table;
    /// Its table, to change.
    fn table_mut(&mut self) -> &mut Table;
}

impl Keyed for Dict {
    fn table(&self) -> &Table {
        &self.0
    }
    fn table_mut(&mut self) -> &mut Table {
        &mut self.0
    }
}

impl Keyed for Set {
    fn table(&self) -> &Table {
        &self.0
    }
    fn table_mut(&mut self) -> &mut Table {
        &mut self.0
    }
}

/// The hash of an int of 64 bits: its remainder modulo 2⁶¹ − 1, with its sign; never −1.
#[inline]
pub fn hash_int(v: i64) -> i64 {
    const MODULUS: u64 = (1 << 61) - 1;
    if (0..MODULUS as i64).contains(&v) {
        return v;
    }
    let m = (v.unsigned_abs() % MODULUS) as i64;
    match if v < 0 { -m } else { m } {
        -1 => -2,
        h => h,
    }
}

/// The hash of a tuple, from the hashes of its items.
fn hash_items(hashes: impl ExactSizeIterator<Item = i64>) -> i64 {
    const P1: u64 = 11_400_714_785_074_694_791;
    const P2: u64 = 14_029_467_366_897_019_727;
    const P5: u64 = 2_870_177_450_012_600_261;
    let len = hashes.len() as u64;
    let mut acc = P5;
    for h in hashes {
        acc = acc.wrapping_add((h as u64).wrapping_mul(P2)).rotate_left(31).wrapping_mul(P1);
    }
    acc = acc.wrapping_add(len ^ (P5 ^ 3_527_539));
    if acc == u64::MAX { 1_546_275_796 } else { acc as i64 }
}

/// The hash of a frozenset: the same in any order.
fn hash_unordered(hashes: impl ExactSizeIterator<Item = u64>) -> i64 {
    let len = hashes.len() as u64;
    let mut acc = hashes.fold(0, |acc, h| acc ^ ((h ^ 89_869_747) ^ (h << 16)).wrapping_mul(3_644_798_167));
    acc ^= (len + 1).wrapping_mul(1_927_868_237);
    acc ^= (acc >> 11) ^ (acc >> 25);
    acc = acc.wrapping_mul(69069).wrapping_add(907_133_923);
    if acc == u64::MAX { 590_923_713 } else { acc as i64 }
}

fn hash_text(text: &[u8]) -> i64 {
    if text.is_empty() {
        return 0;
    }
    use std::hash::Hasher;
    let mut hasher = rustc_hash::FxHasher::default();
    hasher.write(text);
    (hasher.finish() >> 1) as i64
}

#[inline]
fn same_text(heap: &Heap, x: Ref<Str>, y: Ref<Str>) -> bool {
    x == y || heap[x].text == heap[y].text
}

/// Whether two keys of equal hash are the same, where that can be said without running Python code.
fn same_key(heap: &Heap, a: Value, b: Value, depth: u32) -> Option<bool> {
    use Value::*;
    match (a, b) {
        (Str(x), Str(y)) => return Some(same_text(heap, x, y)),
        (Int(x, _), Int(y, _)) => return Some(x == y),
        _ if a.is(b) => return Some(true),
        _ => {}
    }
    Some(match (a, b) {
        (Float(x, _), Float(y, _)) => x == y,
        (Int(x, _), Float(y, _)) | (Float(y, _), Int(x, _)) => y == x as f64 && y.to_i128() == Some(x.into()),
        (Bool(x), Int(y, _)) | (Int(y, _), Bool(x)) => i64::from(x) == y,
        (Bool(x), Float(y, _)) | (Float(y, _), Bool(x)) => f64::from(u8::from(x)) == y,
        (Big(x), Big(y)) => heap[x] == heap[y],
        (Bytes(x), Bytes(y)) => heap[x].0 == heap[y].0,
        (Tuple(x), Tuple(y)) => {
            let (x, y) = (&heap[x].0, &heap[y].0);
            if x.len() != y.len() {
                return Some(false);
            }
            if depth == 0 {
                return Option::None;
            }
            for (&p, &q) in x.iter().zip(y) {
                if !same_key(heap, p, q, depth - 1)? {
                    return Some(false);
                }
            }
            true
        }
        (Str(_) | Int(..) | Float(..) | Bool(_) | None | Tuple(_), Str(_) | Int(..) | Float(..) | Bool(_) | None | Tuple(_)) => false,
        (Class(_) | Function(_) | Native(_), Class(_) | Function(_) | Native(_)) => false,
        _ => return Option::None,
    })
}

impl Heap {
    /// Where a dict has this very text as a key; no other key that might equal it is asked.
    #[inline]
    fn position_of(&self, dict: Ref<Dict>, key: Ref<Str>) -> Option<usize> {
        let text = &self[key];
        if text.chars == 0 {
            return None;
        }
        self[dict].0.find(text.hash() >> 1, |k| matches!(k, Value::Str(k) if same_text(self, k, key)))
    }

    /// The value under this text.
    #[inline]
    pub(super) fn value_of(&self, dict: Ref<Dict>, key: Ref<Str>) -> Option<&Value> {
        self[dict].0.value_at(self.position_of(dict, key)?)
    }

    /// The same, to change.
    #[inline]
    pub(super) fn place_of(&mut self, dict: Ref<Dict>, key: Ref<Str>) -> Option<&mut Value> {
        let position = self.position_of(dict, key)?;
        self[dict].0.value_at_mut(position)
    }
}

impl Vm<'_> {
    /// `hash(value)`. What a program sees of hashes is CPython's for numbers and tuples of numbers, and the same in every run for all else.
    pub fn hash(&mut self, value: Value) -> R<i64> {
        Ok(match value {
            Value::Int(v, _) => {
                self.pin(value);
                hash_int(v)
            }
            Value::Str(s) => match &self.heap[s] {
                empty if empty.chars == 0 => 0,
                text => (text.hash() >> 1) as i64,
            },
            Value::Bool(b) => i64::from(b),
            Value::Float(v, _) => {
                self.pin(value);
                hash_float(v)
            }
            Value::Big(b) => hash_big(&self.heap[b]),
            Value::Complex(c) => {
                let Complex { re, im } = self.heap[c];
                match hash_float(re).wrapping_add(hash_float(im).wrapping_mul(1_000_003)) {
                    -1 => -2,
                    h => h,
                }
            }
            Value::None => 0xfca8_6420,
            Value::Tuple(t) => return self.hash_tuple(t),
            Value::FrozenSet(s) => hash_unordered(self.heap[s].0.iter().map(|e| e.hash).collect::<Vec<_>>().into_iter()),
            Value::Bytes(b) => hash_text(&self.heap[b].0),
            Value::Range(r) => self.hash_range(r)?,
            Value::Instance(_) => return self.hash_instance(value),
            Value::List(_) | Value::Dict(_) | Value::Set(_) | Value::ByteArray(_) | Value::Slice(_) => return self.unhashable(value),
            Value::View(v) if self.heap[v].kind != ViewKind::Values => return self.unhashable(value),
            Value::Proxy(p) => return self.nested("", |vm| vm.hash(vm.heap[p].0)),
            Value::Alias(a) => {
                let Alias { origin, args } = self.heap[a].clone();
                let items = self.new_tuple(args);
                let (x, y) = (self.hash(origin)?, self.hash(items)?);
                hash_items([x, y].into_iter())
            }
            Value::Method(m) => {
                let Method { callee, receiver } = self.heap[m];
                hash_items([self.identity(callee), self.identity(receiver)].into_iter())
            }
            Value::Record(r) if self.host_hashable(value) => {
                let items = self.heap[r].items.clone();
                let items = items.iter().map(|&v| self.hash(v)).collect::<R<Vec<_>>>()?;
                hash_items(items.into_iter())
            }
            Value::Host(_) if self.host_hashable(value) => self.identity(value),
            Value::Host(_) | Value::Record(_) => return self.unhashable(value),
            Value::Class(c) if self.heap[c].meta != Builtin::Type.class() => return self.hash_instance(value),
            other => self.identity(other),
        })
    }

    /// The same, the common keys at once.
    #[inline(always)]
    fn key_hash(&mut self, key: Value) -> R<i64> {
        match key {
            Value::Str(s) if self.heap[s].chars > 0 => Ok((self.heap[s].hash() >> 1) as i64),
            Value::Int(v, h) if h.is_none() => Ok(hash_int(v)),
            _ => self.hash(key),
        }
    }

    fn unhashable(&mut self, value: Value) -> R<i64> {
        let name = self.type_name(value);
        Err(self.type_error(format!("unhashable type: '{name}'")))
    }

    fn hash_tuple(&mut self, tuple: Ref<Tuple>) -> R<i64> {
        let items = self.heap[tuple].0.clone();
        self.charge(items.len() as u64 * 2)?;
        let mut hashes = smallvec::SmallVec::<[i64; 8]>::new();
        for item in items {
            hashes.push(match item {
                Value::Int(..) | Value::Float(..) | Value::Str(_) | Value::Bool(_) | Value::None => self.hash(item)?,
                _ => self.nested("", |vm| vm.hash(item))?,
            });
        }
        Ok(hash_items(hashes.into_iter()))
    }

    fn hash_range(&mut self, range: Ref<Range>) -> R<i64> {
        let range = self.heap[range];
        let len = range.len();
        let mut parts = [Value::None; 3];
        parts[0] = self.heap.big(len.into());
        if len > 0 {
            parts[1] = self.heap.big(range.start.into());
        }
        if len > 1 {
            parts[2] = self.heap.big(range.step.into());
        }
        let parts = self.new_tuple(parts);
        self.hash(parts)
    }

    /// Through `__hash__` of its class, unless that is the inherited one of a builtin type.
    fn hash_instance(&mut self, value: Value) -> R<i64> {
        let Some(method) = self.special(value, sym::HASH) else { return self.unhashable(value) };
        if method.is_none() {
            return self.unhashable(value);
        }
        if let Value::Method(m) = method
            && let Value::Native(_) = self.heap[m].callee
        {
            return match self.plain(value) {
                Value::List(_) | Value::Dict(_) | Value::Set(_) | Value::ByteArray(_) => self.unhashable(value),
                Value::Instance(_) | Value::Class(_) => Ok(self.identity(value)),
                plain => self.hash(plain),
            };
        }
        match self.call(method, &[])? {
            Value::Bool(b) => Ok(i64::from(b)),
            Value::Int(v, h) => {
                self.pin(Value::Int(v, h));
                Ok(if v == -1 { -2 } else { v })
            }
            Value::Big(b) => Ok(hash_big(&self.heap[b])),
            _ => Err(self.type_error("__hash__ method should return an integer")),
        }
    }

    /// A number that tells objects apart: the default hash, and what `id()` is made from. The same in every run.
    pub fn identity(&self, value: Value) -> i64 {
        let class = u64::from(self.class_of(value).index()) << 32;
        match value {
            Value::Native(n) => hash_text(n.name.as_bytes()),
            Value::Host(o) => ((u64::from(o.kind) << 48 | u64::from(o.part) << 40 | u64::from(o.id)) & (u64::MAX >> 2)) as i64,
            Value::Int(v, _) => hash_int(v),
            Value::Float(v, _) => (v.to_bits() >> 1) as i64,
            Value::Bool(b) => i64::from(b),
            _ => (class | u64::from(value.index().unwrap_or(0))) as i64,
        }
    }

    /// Where a key stands in a table.
    #[inline]
    pub(super) fn position<T: Keyed>(&mut self, of: Ref<T>, hash: i64, key: Value) -> R<Option<usize>>
    where
        Heap: IndexMut<Ref<T>> + Index<Ref<T>, Output = T>,
    {
        let (heap, mut unsure, mut probes) = (&self.heap, false, 0u64);
        let found = heap[of].table().find(hash as u64, |k| {
            probes += 1;
            match (k, key) {
                (Value::Str(x), Value::Str(y)) => same_text(heap, x, y),
                (Value::Int(x, _), Value::Int(y, _)) => x == y,
                _ => same_key(heap, k, key, SHALLOW).unwrap_or_else(|| {
                    unsure = true;
                    false
                }),
            }
        });
        if probes > 8 {
            self.charge(probes * 4)?;
        }
        if found.is_some() || !unsure {
            return Ok(found);
        }
        self.position_by_eq(of, hash, key)
    }

    #[cold]
    fn position_by_eq<T: Keyed>(&mut self, of: Ref<T>, hash: i64, key: Value) -> R<Option<usize>>
    where
        Heap: IndexMut<Ref<T>> + Index<Ref<T>, Output = T>,
    {
        'again: loop {
            for position in self.heap[of].table().candidates(hash as u64) {
                let Some(entry) = self.heap[of].table().at(position) else { continue 'again };
                self.charge(1)?;
                let same = self.eq(entry.key, key)?;
                match self.heap[of].table().at(position) {
                    Some(now) if now.hash == entry.hash && now.key.is(entry.key) => {}
                    _ => continue 'again,
                }
                if same {
                    return Ok(Some(position));
                }
            }
            return Ok(None);
        }
    }

    /// Adds a key that is not there, or replaces the value of one that is.
    pub(super) fn insert<T: Keyed>(&mut self, of: Ref<T>, hash: i64, key: Value, value: Value) -> R<()>
    where
        Heap: IndexMut<Ref<T>> + Index<Ref<T>, Output = T>,
    {
        if let Some(position) = self.position(of, hash, key)? {
            self.heap[of].table_mut().set_value(position, value);
            return Ok(());
        }
        self.insert_new(of, hash as u64, key, value)
    }

    /// Adds a key that is known not to be there.
    pub(super) fn insert_new<T: Keyed>(&mut self, of: Ref<T>, hash: u64, key: Value, value: Value) -> R<()>
    where
        Heap: IndexMut<Ref<T>> + Index<Ref<T>, Output = T>,
    {
        let table = self.heap[of].table_mut();
        let before = table.bytes();
        table.push(hash, key, value);
        let grown = table.bytes().saturating_sub(before);
        if grown > 0 {
            self.heap.bytes += grown;
            if grown > LARGE {
                // The table was built anew: each entry went to another place.
                self.reserve(grown)?;
                let entries = self.heap[of].table().len() as u64;
                self.charge(entries * 4)?;
            }
        }
        Ok(())
    }

    /// `dict[key]`, without `__missing__`.
    pub fn dict_get(&mut self, dict: Ref<Dict>, key: Value) -> R<Option<Value>> {
        let hash = self.key_hash(key)?;
        let position = self.position(dict, hash, key)?;
        Ok(position.and_then(|p| self.heap[dict].0.at(p)).map(|e| e.value))
    }

    /// `dict[key] = value`
    pub fn dict_set(&mut self, dict: Ref<Dict>, key: Value, value: Value) -> R<()> {
        let hash = self.key_hash(key)?;
        self.insert(dict, hash, key, value)
    }

    /// Removes a key and gives its value.
    pub fn dict_remove(&mut self, dict: Ref<Dict>, key: Value) -> R<Option<Value>> {
        let hash = self.key_hash(key)?;
        let position = self.position(dict, hash, key)?;
        Ok(position.map(|p| self.heap[dict].0.remove(p).value))
    }

    /// `key in set`
    pub fn set_has(&mut self, set: Ref<Set>, key: Value) -> R<bool> {
        let hash = self.key_hash(key)?;
        Ok(self.position(set, hash, key)?.is_some())
    }

    /// `set.add(key)`
    pub fn set_add(&mut self, set: Ref<Set>, key: Value) -> R<()> {
        let hash = self.key_hash(key)?;
        self.insert(set, hash, key, Value::None)
    }

    /// Removes a key; whether it was there.
    pub fn set_remove(&mut self, set: Ref<Set>, key: Value) -> R<bool> {
        let hash = self.key_hash(key)?;
        let position = self.position(set, hash, key)?;
        if let Some(p) = position {
            self.heap[set].0.remove(p);
        }
        Ok(position.is_some())
    }

    /// Runs something that may go deeper with the depth of the data: RecursionError in place of an overflow of the stack.
    /// `doing` ends CPython's message: " in comparison", " while getting the repr of an object".
    pub fn nested<T>(&mut self, doing: &str, f: impl FnOnce(&mut Self) -> R<T>) -> R<T> {
        if self.frames.len() + self.native_depth as usize >= self.limits.recursion {
            return Err(self.error(Builtin::RecursionError, format!("maximum recursion depth exceeded{doing}")));
        }
        self.native_depth += 1;
        let result = stacker::maybe_grow(128 << 10, 1 << 20, || f(self));
        self.native_depth -= 1;
        result
    }
}
