//! The collector: which objects a run can still reach. Runs only at safe points of the machine's outermost loop, where no native
//! function holds a value that the stack does not.

use super::heap::*;
use super::value::Value;
use num_bigint::BigInt;

const VALUE: usize = std::mem::size_of::<Value>();

fn attrs_bytes(attrs: &Attrs) -> usize {
    match attrs {
        Attrs::Inline(items) => items.capacity() * (VALUE + 8),
        Attrs::Dict(_) => 0,
    }
}

fn attrs_children(attrs: &Attrs, out: &mut Vec<Value>) {
    match attrs {
        Attrs::Inline(items) => out.extend(items.iter().map(|p| p.1)),
        Attrs::Dict(dict) => out.push(Value::Dict(*dict)),
    }
}

impl Heap {
    /// Frees what cannot be reached from `roots`.
    pub(super) fn collect(&mut self, roots: Vec<Value>) {
        let mut marks = Marks::new(self);
        let mut todo = roots;
        while let Some(value) = todo.pop() {
            self.mark(value, &mut marks, &mut todo);
        }
        self.sweep(&marks);
    }

    fn mark(&self, value: Value, marks: &mut Marks, todo: &mut Vec<Value>) {
        macro_rules! reach {
            ($r:expr, $field:ident) => {
                if !std::mem::replace(&mut marks.$field[$r.index() as usize], true) {
                    self[$r].children(todo);
                }
            };
        }
        match value {
            Value::Undefined | Value::None | Value::Ellipsis | Value::NotImplemented | Value::Bool(_) => {}
            Value::Int(..) | Value::Float(..) | Value::Native(_) | Value::Host(_) => {}
            Value::Big(r) => reach!(r, bigs),
            Value::Complex(r) => reach!(r, complexes),
            Value::Str(r) => reach!(r, strs),
            Value::Bytes(r) => reach!(r, bytes_objects),
            Value::ByteArray(r) => reach!(r, byte_arrays),
            Value::Tuple(r) => reach!(r, tuples),
            Value::List(r) => reach!(r, lists),
            Value::Dict(r) => reach!(r, dicts),
            Value::Set(r) | Value::FrozenSet(r) => reach!(r, sets),
            Value::Slice(r) => reach!(r, slices),
            Value::Range(r) => reach!(r, ranges),
            Value::Function(r) => reach!(r, functions),
            Value::Method(r) => reach!(r, methods),
            Value::Class(r) => reach!(r, classes),
            Value::Instance(r) => reach!(r, instances),
            Value::Generator(r) => reach!(r, generators),
            Value::Iter(r) => reach!(r, iters),
            Value::Module(r) => reach!(r, modules),
            Value::Cell(r) => reach!(r, cells),
            Value::Property(r) => reach!(r, properties),
            Value::ClassMethod(r) | Value::StaticMethod(r) | Value::Proxy(r) => reach!(r, wrapped),
            Value::Super(r) => reach!(r, supers),
            Value::View(r) => reach!(r, views),
            Value::Alias(r) => reach!(r, aliases),
            Value::Record(r) => reach!(r, records),
        }
    }
}

impl Stored for BigInt {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.bigs
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.bigs
    }
    fn extra(&self) -> usize {
        (self.bits() / 8) as usize
    }
    fn children(&self, _out: &mut Vec<Value>) {}
}

impl Stored for Complex {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.complexes
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.complexes
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, _out: &mut Vec<Value>) {}
}

impl Stored for Str {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.strs
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.strs
    }
    fn extra(&self) -> usize {
        self.text.len()
    }
    fn children(&self, _out: &mut Vec<Value>) {}
}

impl Stored for Bytes {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.bytes_objects
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.bytes_objects
    }
    fn extra(&self) -> usize {
        self.0.len()
    }
    fn children(&self, _out: &mut Vec<Value>) {}
}

impl Stored for ByteArray {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.byte_arrays
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.byte_arrays
    }
    fn extra(&self) -> usize {
        self.0.capacity()
    }
    fn children(&self, _out: &mut Vec<Value>) {}
}

impl Stored for Tuple {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.tuples
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.tuples
    }
    fn extra(&self) -> usize {
        if self.0.spilled() { self.0.capacity() * VALUE } else { 0 }
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend_from_slice(&self.0);
    }
}

impl Stored for List {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.lists
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.lists
    }
    fn extra(&self) -> usize {
        self.0.capacity() * VALUE
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend_from_slice(&self.0);
    }
}

impl Stored for Dict {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.dicts
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.dicts
    }
    fn extra(&self) -> usize {
        self.0.bytes()
    }
    fn children(&self, out: &mut Vec<Value>) {
        for e in self.0.iter() {
            out.push(e.key);
            out.push(e.value);
        }
    }
}

impl Stored for Set {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.sets
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.sets
    }
    fn extra(&self) -> usize {
        self.0.bytes()
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend(self.0.iter().map(|e| e.key));
    }
}

impl Stored for Slice {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.slices
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.slices
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend([self.start, self.stop, self.step]);
    }
}

impl Stored for Range {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.ranges
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.ranges
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, _out: &mut Vec<Value>) {}
}

impl Stored for Function {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.functions
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.functions
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend([self.name, self.qualname, self.doc, self.module_name, self.annotations, Value::Module(self.module)]);
        out.extend_from_slice(&self.defaults);
        out.extend(self.kwdefaults.iter().map(|p| p.1));
        out.extend(self.closure.iter().map(|c| Value::Cell(*c)));
        attrs_children(&self.attrs, out);
    }
}

impl Stored for Method {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.methods
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.methods
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend([self.callee, self.receiver]);
    }
}

impl Stored for Class {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.classes
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.classes
    }
    fn extra(&self) -> usize {
        256 + self.attrs.len() * 40
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend([self.name, self.qualname, Value::Class(self.meta)]);
        out.extend(self.mro.iter().chain(&self.subclasses).map(|c| Value::Class(*c)));
        out.extend(self.attrs.values());
    }
}

impl Stored for Instance {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.instances
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.instances
    }
    fn extra(&self) -> usize {
        attrs_bytes(&self.attrs)
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.push(Value::Class(self.class));
        attrs_children(&self.attrs, out);
        match &self.base {
            Base::None => {}
            Base::Value(v) => out.push(*v),
            Base::Exception(e) => out.extend([e.args, e.cause, e.context]),
        }
    }
}

impl Stored for Generator {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.generators
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.generators
    }
    fn extra(&self) -> usize {
        self.frame.as_ref().map_or(0, |f| 96 + f.stack.len() * VALUE)
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend([self.name, self.qualname]);
        if let Some(frame) = &self.frame {
            frame.children(out);
        }
    }
}

impl Stored for Iter {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.iters
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.iters
    }
    fn extra(&self) -> usize {
        self.0.extra()
    }
    fn children(&self, out: &mut Vec<Value>) {
        self.0.children(out);
    }
}

impl Stored for Module {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.modules
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.modules
    }
    fn extra(&self) -> usize {
        self.slots.len() * 48
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.push(self.name);
        out.extend_from_slice(&self.slots);
        out.extend(self.dict.map(Value::Dict));
    }
}

impl Stored for Cell {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.cells
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.cells
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.push(self.0);
    }
}

impl Stored for Property {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.properties
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.properties
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend([self.get, self.set, self.delete, self.doc]);
    }
}

impl Stored for Wrapped {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.wrapped
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.wrapped
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.push(self.0);
    }
}

impl Stored for Super {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.supers
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.supers
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend([Value::Class(self.class), self.object, Value::Class(self.object_class)]);
    }
}

impl Stored for View {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.views
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.views
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.push(Value::Dict(self.dict));
    }
}

impl Stored for Alias {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.aliases
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.aliases
    }
    fn extra(&self) -> usize {
        self.args.len() * VALUE
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.push(self.origin);
        out.extend_from_slice(&self.args);
    }
}

impl Stored for Record {
    fn arena(heap: &Heap) -> &Arena<Self> {
        &heap.records
    }
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self> {
        &mut heap.records
    }
    fn extra(&self) -> usize {
        0
    }
    fn children(&self, out: &mut Vec<Value>) {
        out.extend_from_slice(&self.items);
    }
}
