//! `sorted` and `list.sort`: a stable merge sort whose comparisons may raise, and may change the list that is being sorted.

use crate::python::error::R;
use crate::python::heap::*;
use crate::python::iterate::VALUE;
use crate::python::native::Args;
use crate::python::symbols::sym;
use crate::python::types::iterator::positional;
use crate::python::value::Value;
use crate::python::vm::Vm;
use std::cmp::Ordering;

/// How to sort, as the keywords say it.
struct Order {
    key: Option<Value>,
    reverse: bool,
}

fn order(vm: &mut Vm<'_>, function: &str, args: Args<'_>) -> R<Order> {
    let mut order = Order { key: None, reverse: false };
    for &(name, value) in args.kw {
        if name == sym::N_KEY {
            order.key = (!value.is_none()).then_some(value);
        } else if name == sym::N_REVERSE {
            let value = vm.pin(value);
            order.reverse = vm.index(value)? != 0;
        } else {
            let name = vm.symbols.text(name).to_string();
            return Err(vm.type_error(format!("'{name}' is an invalid keyword argument for {function}()")));
        }
    }
    Ok(order)
}

/// `sorted(iterable, *, key=None, reverse=False)`
pub fn sorted(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    positional(vm, "sorted", &Args::new(args.pos), 1, 1)?;
    let items = vm.collect(args.at(0))?;
    let order = order(vm, "sort", args)?;
    let items = sort_by(vm, items, order)?;
    Ok(vm.new_list(items))
}

/// `list.sort(*, key=None, reverse=False)`
pub fn sort(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let list = super::this(vm, &args)?;
    if args.pos.len() > 1 {
        return Err(vm.type_error("sort() takes no positional arguments"));
    }
    let order = order(vm, "sort", args)?;
    // The list is empty while its items are compared: a change in the meantime can be told by that.
    let items = std::mem::take(&mut vm.heap[list].0);
    let result = sort_by(vm, items.clone(), order);
    let changed = vm.heap[list].0.capacity() > 0;
    let (items, result) = match result {
        Ok(sorted) => (sorted, Ok(Value::None)),
        Err(raise) => (items, Err(raise)),
    };
    vm.heap[list].0 = items;
    if changed && result.is_ok() {
        return Err(vm.value_error("list modified during sort"));
    }
    result
}

/// Sorts values ascending, without a key: what `sorted(values)` does.
pub fn sort_values(vm: &mut Vm<'_>, items: Vec<Value>) -> R<Vec<Value>> {
    sort_by(vm, items, Order { key: None, reverse: false })
}

fn sort_by(vm: &mut Vm<'_>, items: Vec<Value>, order: Order) -> R<Vec<Value>> {
    vm.reserve(items.len() * 4 * VALUE)?;
    let keys = match order.key {
        None => items.clone(),
        Some(function) => {
            let mut keys = Vec::with_capacity(items.len());
            for &item in &items {
                vm.charge(1)?;
                keys.push(vm.call(function, &[item])?);
            }
            keys
        }
    };
    let depth = u64::from(items.len().max(2).ilog2());
    vm.charge(items.len() as u64 * depth / 8)?;
    // Reversed twice, so that equal items keep their order.
    let mut places: Vec<u32> = (0..items.len() as u32).collect();
    if order.reverse {
        places.reverse();
    }
    if !plain_sort(&vm.heap, &mut places, &keys) {
        merge_sort(vm, &mut places, &keys)?;
    }
    if order.reverse {
        places.reverse();
    }
    Ok(places.into_iter().map(|p| items[p as usize]).collect())
}

/// The kind of a key that is compared without running Python code and without guarding anything.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Plain {
    Int,
    Float,
    Str,
}

fn plain(key: &Value) -> Option<Plain> {
    match key {
        Value::Int(_, h) if h.is_none() => Some(Plain::Int),
        Value::Float(v, h) if h.is_none() && !v.is_nan() => Some(Plain::Float),
        Value::Str(_) => Some(Plain::Str),
        _ => None,
    }
}

/// Compares two keys of one plain kind.
#[inline]
fn compare(heap: &Heap, a: &Value, b: &Value) -> Ordering {
    match (a, b) {
        (Value::Int(a, _), Value::Int(b, _)) => a.cmp(b),
        (Value::Float(a, _), Value::Float(b, _)) => a.partial_cmp(b).unwrap_or(Ordering::Equal),
        (Value::Str(a), Value::Str(b)) if a == b => Ordering::Equal,
        (Value::Str(a), Value::Str(b)) => heap[*a].text.cmp(&heap[*b].text),
        _ => Ordering::Equal,
    }
}

/// Sorts by keys that are all of one plain kind, or tuples of plain items of which those at the same place are of one kind. `false`, and
/// nothing is done, where they are not.
fn plain_sort(heap: &Heap, places: &mut [u32], keys: &[Value]) -> bool {
    let Some(first) = keys.first() else { return true };
    let rows = match plain(first) {
        Some(kind) => {
            if !keys.iter().all(|k| plain(k) == Some(kind)) {
                return false;
            }
            keys.iter().map(std::slice::from_ref).collect()
        }
        None => match rows(heap, keys) {
            Some(rows) => rows,
            None => return false,
        },
    };
    let mut heads: Vec<Head> = places.iter().map(|&place| Head::of(heap, rows[place as usize], place)).collect();
    heads.sort_by(|a, b| {
        a.compare(b).unwrap_or_else(|| {
            let (x, y) = (rows[a.place as usize], rows[b.place as usize]);
            x.iter().zip(y).map(|(p, q)| compare(heap, p, q)).find(|o| o.is_ne()).unwrap_or_else(|| x.len().cmp(&y.len()))
        })
    });
    for (place, head) in places.iter_mut().zip(heads) {
        *place = head.place;
    }
    true
}

/// The beginning of a key in numbers of the same order, so that most comparisons need not look at the key itself.
struct Head {
    items: [u64; 2],
    /// How many of the two say all of their item.
    whole: u8,
    place: u32,
}

impl Head {
    fn of(heap: &Heap, row: &[Value], place: u32) -> Head {
        let (mut items, mut whole) = ([0; 2], 0);
        for (head, item) in items.iter_mut().zip(row) {
            let complete = match item {
                Value::Int(v, _) => {
                    *head = (*v as u64) ^ (1 << 63);
                    true
                }
                Value::Float(v, _) => {
                    // Both zeros are equal.
                    let bits = (v + 0.0).to_bits();
                    *head = if bits >> 63 == 1 { !bits } else { bits | 1 << 63 };
                    true
                }
                Value::Str(s) => {
                    // Seven bytes and, as the last, how many there are.
                    let text = heap[*s].text.as_bytes();
                    let mut bytes = [0; 8];
                    for (byte, own) in bytes.iter_mut().zip(&text[..text.len().min(7)]) {
                        *byte = *own;
                    }
                    bytes[7] = text.len().min(8) as u8;
                    *head = u64::from_be_bytes(bytes);
                    text.len() < 8
                }
                _ => false,
            };
            if !complete {
                break;
            }
            whole += 1;
        }
        Head { items, whole, place }
    }

    /// The order, where the heads say it.
    #[inline]
    fn compare(&self, other: &Head) -> Option<Ordering> {
        for (i, (a, b)) in self.items.iter().zip(&other.items).enumerate() {
            if i > usize::from(self.whole.min(other.whole)) {
                return None;
            }
            match a.cmp(b) {
                Ordering::Equal => {}
                order => return Some(order),
            }
        }
        None
    }
}

/// The items of keys that are tuples of plain items, those at the same place of one kind.
fn rows<'a>(heap: &'a Heap, keys: &[Value]) -> Option<Vec<&'a [Value]>> {
    let mut kinds: Vec<Plain> = Vec::new();
    let mut rows = Vec::with_capacity(keys.len());
    for key in keys {
        let Value::Tuple(row) = key else { return None };
        let row = heap[*row].0.as_slice();
        for (i, item) in row.iter().enumerate() {
            let kind = plain(item)?;
            if i == kinds.len() {
                kinds.push(kind);
            } else if kinds[i] != kind {
                return None;
            }
        }
        rows.push(row);
    }
    Some(rows)
}

/// Stable, by `less` alone: runs that are already in order are taken as they are (as CPython does, whose count of comparisons on sorted input
/// programs can see), short ones grow by binary insertion, then neighbours are merged.
fn merge_sort(vm: &mut Vm<'_>, places: &mut [u32], keys: &[Value]) -> R<()> {
    const SHORT: usize = 32;
    let len = places.len();
    let mut runs: Vec<usize> = vec![0];
    let mut start = 0;
    while start < len {
        let mut end = natural_run(vm, &mut places[start..], keys)? + start;
        let goal = len.min(start + if len < 64 { len } else { SHORT });
        while end < goal {
            insert_into(vm, &mut places[start..=end], keys)?;
            end += 1;
        }
        runs.push(end);
        start = end;
    }
    while runs.len() > 2 {
        let mut merged = vec![0];
        for pair in (0..runs.len() - 1).step_by(2) {
            let (a, b) = (runs[pair], runs[pair + 1]);
            let c = runs.get(pair + 2).copied().unwrap_or(b);
            merge(vm, &mut places[a..c], b - a, keys)?;
            merged.push(c);
        }
        runs = merged;
    }
    Ok(())
}

/// The length of the run that the places begin with: ascending, or strictly descending and then turned round.
fn natural_run(vm: &mut Vm<'_>, places: &mut [u32], keys: &[Value]) -> R<usize> {
    let key = |p: u32| keys[p as usize];
    if places.len() < 2 {
        return Ok(places.len());
    }
    let descending = vm.less(key(places[1]), key(places[0]))?;
    let mut len = 2;
    while len < places.len() {
        vm.charge(1)?;
        if vm.less(key(places[len]), key(places[len - 1]))? != descending {
            break;
        }
        len += 1;
    }
    if descending {
        places[..len].reverse();
    }
    Ok(len)
}

/// Puts the last place where it belongs among the sorted ones before it.
fn insert_into(vm: &mut Vm<'_>, places: &mut [u32], keys: &[Value]) -> R<()> {
    let Some((&pivot, sorted)) = places.split_last() else { return Ok(()) };
    let (mut low, mut high) = (0, sorted.len());
    while low < high {
        vm.charge(1)?;
        let middle = (low + high) / 2;
        if vm.less(keys[pivot as usize], keys[places[middle] as usize])? {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    places[low..].rotate_right(1);
    Ok(())
}

/// Merges the two sorted parts of the places, the second from `middle` on.
fn merge(vm: &mut Vm<'_>, places: &mut [u32], middle: usize, keys: &[Value]) -> R<()> {
    let (left, right) = (places[..middle].to_vec(), places[middle..].to_vec());
    let (mut i, mut j) = (0, 0);
    while i < left.len() && j < right.len() {
        vm.charge(1)?;
        if vm.less(keys[right[j] as usize], keys[left[i] as usize])? {
            places[i + j] = right[j];
            j += 1;
        } else {
            places[i + j] = left[i];
            i += 1;
        }
    }
    let rest = i + j;
    for (place, &p) in places[rest..].iter_mut().zip(left[i..].iter().chain(&right[j..])) {
        *place = p;
    }
    Ok(())
}
