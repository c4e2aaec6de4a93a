//! The hash table behind `dict` and `set`: insertion order, tombstones, and no calls into the machine.
//!
//! Equality of keys may run Python code, so the table only offers candidates; `hashing.rs` decides.

use super::value::Value;
use hashbrown::HashTable;

/// One key with its value; a removed one has the key `Undefined`.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The hash of the key.
    pub hash: u64,
    /// The key.
    pub key: Value,
    /// The value (`None` in a set).
    pub value: Value,
}

/// Up to this many entries are searched one after the other, without an index.
const LINEAR: usize = 8;

/// An insertion-ordered hash table.
#[derive(Clone, Debug, Default)]
pub struct Table {
    entries: Vec<Entry>,
    index: HashTable<u32>,
    live: usize,
    /// Everything before this position was removed.
    first: usize,
}

/// Spreads the bits of a hash: those of small ints differ in the lowest only.
#[inline]
fn spread(hash: u64) -> u64 {
    hash.wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(26)
}

impl Table {
    /// How many keys there are.
    pub fn len(&self) -> usize {
        self.live
    }

    /// True where there is no key.
    pub fn is_empty(&self) -> bool {
        self.live == 0
    }

    /// The number of positions, removed ones counted: iteration goes over `0..positions()`.
    pub fn positions(&self) -> usize {
        self.entries.len()
    }

    /// The entry at a position; `None` where it was removed or never was.
    #[inline]
    pub fn at(&self, position: usize) -> Option<Entry> {
        self.entries.get(position).copied().filter(|e| !e.key.is_undefined())
    }

    /// The value at a position that [`find`](Table::find) gave.
    #[inline]
    pub fn value_at(&self, position: usize) -> Option<&Value> {
        self.entries.get(position).map(|e| &e.value)
    }

    /// The same, to change.
    #[inline]
    pub fn value_at_mut(&mut self, position: usize) -> Option<&mut Value> {
        self.entries.get_mut(position).map(|e| &mut e.value)
    }

    /// The first live entry at or after a position, with its position.
    #[inline]
    pub fn next_from(&self, position: usize) -> Option<(usize, Entry)> {
        let mut position = position.max(self.first);
        while let Some(entry) = self.entries.get(position) {
            if !entry.key.is_undefined() {
                return Some((position, *entry));
            }
            position += 1;
        }
        None
    }

    /// The last live entry before a position.
    pub fn last_before(&self, position: usize) -> Option<(usize, Entry)> {
        (0..position.min(self.entries.len())).rev().map(|p| (p, self.entries[p])).find(|(_, e)| !e.key.is_undefined())
    }

    /// All live entries in order of insertion.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = Entry> + '_ {
        self.entries.iter().copied().filter(|e| !e.key.is_undefined())
    }

    /// The position of the first entry of this hash that `same` accepts.
    #[inline]
    pub fn find(&self, hash: u64, mut same: impl FnMut(Value) -> bool) -> Option<usize> {
        if self.index.is_empty() {
            return self.entries.iter().position(|e| e.hash == hash && !e.key.is_undefined() && same(e.key));
        }
        let entries = &self.entries;
        self.index
            .find(spread(hash), |&i| {
                let e = &entries[i as usize];
                e.hash == hash && same(e.key)
            })
            .map(|&i| i as usize)
    }

    /// The positions of all entries of this hash.
    pub fn candidates(&self, hash: u64) -> Vec<usize> {
        let of_hash = |&p: &usize| self.entries[p].hash == hash && !self.entries[p].key.is_undefined();
        if self.index.is_empty() {
            return (0..self.entries.len()).filter(of_hash).collect();
        }
        let mut found: Vec<usize> = self.index.iter_hash(spread(hash)).map(|&i| i as usize).filter(of_hash).collect();
        found.sort_unstable();
        found
    }

    /// Adds a key that is not there yet.
    pub fn push(&mut self, hash: u64, key: Value, value: Value) {
        if self.entries.len() == self.entries.capacity() && self.entries.len() > 2 * self.live.max(4) {
            self.compact();
        }
        let position = self.entries.len() as u32;
        self.entries.push(Entry { hash, key, value });
        self.live += 1;
        if !self.index.is_empty() {
            let entries = &self.entries;
            self.index.insert_unique(spread(hash), position, |&i| spread(entries[i as usize].hash));
        } else if self.entries.len() > LINEAR {
            self.reindex();
        }
    }

    /// Replaces the value at a position.
    pub fn set_value(&mut self, position: usize, value: Value) {
        self.entries[position].value = value;
    }

    /// Removes the entry at a position.
    pub fn remove(&mut self, position: usize) -> Entry {
        let entry = self.entries[position];
        if !self.index.is_empty()
            && let Ok(found) = self.index.find_entry(spread(entry.hash), |&i| i as usize == position)
        {
            found.remove();
        }
        self.entries[position].key = Value::Undefined;
        self.entries[position].value = Value::Undefined;
        self.live -= 1;
        if self.live == 0 {
            self.clear();
        } else if position == self.first {
            while self.entries[self.first].key.is_undefined() {
                self.first += 1;
            }
        } else {
            while self.entries.last().is_some_and(|e| e.key.is_undefined()) {
                self.entries.pop();
            }
        }
        entry
    }

    /// Removes everything.
    pub fn clear(&mut self) {
        self.entries.clear();
        self.index.clear();
        self.live = 0;
        self.first = 0;
    }

    /// Roughly how many bytes it takes.
    pub fn bytes(&self) -> usize {
        self.entries.capacity() * std::mem::size_of::<Entry>() + self.index.capacity() * 5
    }

    fn compact(&mut self) {
        self.entries.retain(|e| !e.key.is_undefined());
        self.first = 0;
        if !self.index.is_empty() {
            self.reindex();
        }
    }

    fn reindex(&mut self) {
        self.index.clear();
        self.index.reserve(self.entries.len() * 2, |_| 0);
        let entries = &self.entries;
        for (i, e) in entries.iter().enumerate().filter(|(_, e)| !e.key.is_undefined()) {
            self.index.insert_unique(spread(e.hash), i as u32, |&i| spread(entries[i as usize].hash));
        }
    }
}
