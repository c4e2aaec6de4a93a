//! Where the objects of a run live: one arena a type, typed indices in place of pointers, and a mark-and-sweep collector (`gc.rs`).
//!
//! Indices make cycles harmless (the whole heap goes when the run ends), let a native function hold on to objects while it calls back into
//! the machine, and never dangle: the collector runs only where every live object can be reached from its roots.

use super::code::CodeId;
use super::frame::SavedFrame;
use super::iter::IterState;
use super::native::Native;
use super::table::Table;
use super::value::{Symbol, Value};
use indexmap::IndexMap;
use num_bigint::BigInt;
use ruff_text_size::TextRange;
use rustc_hash::{FxBuildHasher, FxHashMap};
use smallvec::SmallVec;
use std::cell::Cell as RustCell;
use std::fmt;
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

/// A typed index into the heap.
pub struct Ref<T>(u32, PhantomData<fn() -> T>);

impl<T> Ref<T> {
    /// The reference with this index; only the arena and the table of builtin classes make them.
    pub(super) const fn new(index: u32) -> Ref<T> {
        Ref(index, PhantomData)
    }

    /// The index within its arena.
    #[inline(always)]
    pub const fn index(self) -> u32 {
        self.0
    }
}

impl<T> Clone for Ref<T> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<T> Copy for Ref<T> {}
impl<T> PartialEq for Ref<T> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}
impl<T> Eq for Ref<T> {}
impl<T> std::hash::Hash for Ref<T> {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.0.hash(state)
    }
}
impl<T> fmt::Debug for Ref<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.0)
    }
}

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
}

/// A string: UTF-8, with its length in characters so that ASCII text is indexed at once.
#[derive(Clone, Debug)]
pub struct Str {
    /// The text.
    pub text: Box<str>,
    /// Its length in code points; where this equals the length in bytes the text is ASCII.
    pub chars: usize,
    hash: RustCell<u64>,
}

impl Str {
    /// Wraps a text.
    pub fn new(text: impl Into<Box<str>>) -> Str {
        let text = text.into();
        let chars = if text.is_ascii() { text.len() } else { text.chars().count() };
        Str { text, chars, hash: RustCell::new(0) }
    }

    /// True where each character is one byte.
    #[inline]
    pub fn is_ascii(&self) -> bool {
        self.chars == self.text.len()
    }

    /// The hash of the text, the same in every run; computed once.
    #[inline]
    pub fn hash(&self) -> u64 {
        match self.hash.get() {
            0 if !self.text.is_empty() => self.compute_hash(),
            hash => hash,
        }
    }

    fn compute_hash(&self) -> u64 {
        use std::hash::Hasher;
        let mut hasher = rustc_hash::FxHasher::default();
        hasher.write(self.text.as_bytes());
        self.hash.set(hasher.finish().max(1));
        self.hash.get()
    }
}

/// `bytes`
#[derive(Clone, Debug)]
pub struct Bytes(pub Box<[u8]>);
/// `bytearray`
#[derive(Clone, Debug)]
pub struct ByteArray(pub Vec<u8>);
/// `tuple`
#[derive(Clone, Debug)]
pub struct Tuple(pub SmallVec<[Value; 3]>);
/// `list`
#[derive(Clone, Debug, Default)]
pub struct List(pub Vec<Value>);
/// `dict`
#[derive(Clone, Debug, Default)]
pub struct Dict(pub Table);
/// `set` and `frozenset`
#[derive(Clone, Debug, Default)]
pub struct Set(pub Table);

/// `slice`
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Slice {
    pub start: Value,
    pub stop: Value,
    pub step: Value,
}

/// `range`; bounds beyond 128 bits are an OverflowError.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub struct Range {
    pub start: i128,
    pub stop: i128,
    pub step: i128,
}

impl Range {
    /// How many numbers it has.
    pub fn len(&self) -> u128 {
        let (low, high) = if self.step > 0 { (self.start, self.stop) } else { (self.stop, self.start) };
        if low >= high { 0 } else { (high.abs_diff(low) - 1) / self.step.unsigned_abs() + 1 }
    }

    /// True where it has none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// A function written in Python.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its compiled body.
    pub code: CodeId,
    /// The module whose globals it sees.
    pub module: Ref<Module>,
    /// `__name__`
    pub name: Value,
    /// `__qualname__`
    pub qualname: Value,
    /// `__doc__`
    pub doc: Value,
    /// `__module__`
    pub module_name: Value,
    /// Defaults of the last positional parameters.
    pub defaults: SmallVec<[Value; 2]>,
    /// Defaults of keyword-only parameters.
    pub kwdefaults: SmallVec<[(Symbol, Value); 1]>,
    /// Captured variables, in the order of the code's free variables.
    pub closure: SmallVec<[Ref<Cell>; 2]>,
    /// `__annotations__`: a dict, or `None` where there are none yet.
    pub annotations: Value,
    /// Other attributes.
    pub attrs: Attrs,
}

/// A callable with its first argument.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// What is called: a function, a native, any callable.
    pub callee: Value,
    /// The first argument.
    pub receiver: Value,
}

/// The layout a class inherits from the builtin types: what its instances hold in [`Instance::base`].
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs)]
pub enum Layout {
    Object,
    Int,
    Float,
    Complex,
    Str,
    Bytes,
    ByteArray,
    Tuple,
    List,
    Dict,
    Set,
    FrozenSet,
    Exception,
    Type,
    Property,
    /// Any builtin type that cannot be subclassed.
    Sealed,
}

/// A class.
#[derive(Clone, Debug)]
pub struct Class {
    /// `__name__`
    pub name: Value,
    /// `__qualname__`
    pub qualname: Value,
    /// Direct bases.
    pub bases: SmallVec<[Ref<Class>; 1]>,
    /// Method resolution order, the class itself first.
    pub mro: Vec<Ref<Class>>,
    /// Its own namespace.
    pub attrs: IndexMap<Symbol, Value, FxBuildHasher>,
    /// Its metaclass.
    pub meta: Ref<Class>,
    /// What its instances hold beside attributes.
    pub layout: Layout,
    /// Methods written in Rust that were not put into `attrs` yet (done on first look-up).
    pub natives: &'static [Native],
    /// True for a builtin class: its attributes cannot be set.
    pub builtin: bool,
    /// `__slots__` without `__dict__` all the way up: instances take these names only.
    pub slots: Option<Vec<Symbol>>,
    /// Whether there is a `__getattribute__` or `__getattr__` of the program's own, here or in a base.
    pub hooked: bool,
    /// Direct subclasses.
    pub subclasses: Vec<Ref<Class>>,
}

/// Attributes of an instance: in line until someone asks for `__dict__`.
#[derive(Clone, Debug)]
pub enum Attrs {
    /// In order of first assignment.
    Inline(Vec<(Symbol, Value)>),
    /// The instance's `__dict__`.
    Dict(Ref<Dict>),
}

impl Default for Attrs {
    fn default() -> Self {
        Attrs::Inline(Vec::new())
    }
}

/// What an instance holds beside its attributes.
#[derive(Clone, Debug, Default)]
pub enum Base {
    /// Nothing.
    #[default]
    None,
    /// The value of the builtin type it inherits from (`class Stack(list)`).
    Value(Value),
    /// What every exception has.
    Exception(Box<ExceptionData>),
}

/// What every exception has.
#[derive(Clone, Debug)]
pub struct ExceptionData {
    /// `args`
    pub args: Value,
    /// `__cause__`
    pub cause: Value,
    /// `__context__`
    pub context: Value,
    /// `__suppress_context__`
    pub suppress: bool,
    /// Where it passed, innermost first.
    pub traceback: Vec<TraceEntry>,
}

/// One line of a traceback.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TraceEntry {
    /// The code that was running.
    pub code: CodeId,
    /// The expression or statement.
    pub range: TextRange,
}

/// An instance of a class.
#[derive(Clone, Debug)]
pub struct Instance {
    /// Its class.
    pub class: Ref<Class>,
    /// Its attributes.
    pub attrs: Attrs,
    /// The rest.
    pub base: Base,
}

/// A generator.
#[derive(Clone, Debug)]
pub struct Generator {
    /// Where it stands; `None` while it runs and once it is over.
    pub frame: Option<Box<SavedFrame>>,
    /// The empty place for its frame while it runs.
    pub spare: Option<Box<SavedFrame>>,
    /// True while it runs.
    pub running: bool,
    /// `__name__`
    pub name: Value,
    /// `__qualname__`
    pub qualname: Value,
    /// True once it has been started.
    pub started: bool,
}

/// A native iterator.
#[derive(Clone, Debug)]
pub struct Iter(pub IterState);

/// A module.
#[derive(Clone, Debug)]
pub struct Module {
    /// `__name__`
    pub name: Value,
    /// Global variables by slot.
    pub slots: Vec<Value>,
    /// The name of each slot.
    pub names: Vec<Symbol>,
    /// The slot of each name.
    pub index: FxHashMap<Symbol, u32>,
    /// What `globals()` gave: a name that a program adds there becomes a variable when it is first asked for.
    pub dict: Option<Ref<Dict>>,
}

/// A captured variable.
#[derive(Clone, Copy, Debug)]
pub struct Cell(pub Value);

/// `property`
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub struct Property {
    pub get: Value,
    pub set: Value,
    pub delete: Value,
    pub doc: Value,
}

/// `classmethod`, `staticmethod`, `mappingproxy`: something around a value.
#[derive(Clone, Copy, Debug)]
pub struct Wrapped(pub Value);

/// `super(class, object)`
#[derive(Clone, Copy, Debug)]
pub struct Super {
    /// The search begins after this class…
    pub class: Ref<Class>,
    /// …for this object or class (`Undefined`: unbound)…
    pub object: Value,
    /// …in the order of this class.
    pub object_class: Ref<Class>,
}

/// Which part of a dict a view shows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum ViewKind {
    Keys,
    Values,
    Items,
}

/// `dict_keys`, `dict_values`, `dict_items`
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Which part.
    pub kind: ViewKind,
    /// The dict.
    pub dict: Ref<Dict>,
}

/// `list[int]`, `int | str`
#[derive(Clone, Debug)]
pub struct Alias {
    /// `__origin__`; `None` for a union.
    pub origin: Value,
    /// `__args__`
    pub args: Vec<Value>,
}

/// A small immutable value of the host.
#[derive(Clone, Debug)]
pub struct Record {
    /// What it is; the host's own business.
    pub kind: u16,
    /// Its parts.
    pub items: SmallVec<[Value; 3]>,
}

/// What can be stored in the heap.
pub trait Stored: Sized {
    /// Its arena.
    fn arena(heap: &Heap) -> &Arena<Self>;
    /// Its arena, to change.
    fn arena_mut(heap: &mut Heap) -> &mut Arena<Self>;
    /// Bytes beyond its own size.
    fn extra(&self) -> usize;
    /// Puts the values that it holds on the collector's list.
    fn children(&self, out: &mut Vec<Value>);
}

/// All objects of one type.
#[derive(Debug)]
pub struct Arena<T> {
    pub(super) slots: Vec<Option<T>>,
    pub(super) free: Vec<u32>,
}

impl<T> Default for Arena<T> {
    fn default() -> Self {
        Arena { slots: Vec::new(), free: Vec::new() }
    }
}

macro_rules! heap {
    ($($field:ident: $type:ty,)*) => {
        /// The objects of a run.
        #[derive(Default, Debug)]
        pub struct Heap {
            $(pub(super) $field: Arena<$type>,)*
            /// The empty tuple, once it was asked for; a root.
            pub(super) empty_tuple: Option<Ref<Tuple>>,
            /// Bytes in use, roughly: what the memory limit is about.
            pub bytes: usize,
        }

        $(
            impl Index<Ref<$type>> for Heap {
                type Output = $type;
                #[inline(always)]
                fn index(&self, r: Ref<$type>) -> &$type {
                    self.$field.slots[r.0 as usize].as_ref().expect("the collector keeps what can be reached")
                }
            }
            impl IndexMut<Ref<$type>> for Heap {
                #[inline(always)]
                fn index_mut(&mut self, r: Ref<$type>) -> &mut $type {
                    self.$field.slots[r.0 as usize].as_mut().expect("the collector keeps what can be reached")
                }
            }
        )*

        /// One bit an object: reached by the collector.
        pub(super) struct Marks {
            $(pub(super) $field: Vec<bool>,)*
        }

        impl Marks {
            pub(super) fn new(heap: &Heap) -> Marks {
                Marks { $($field: vec![false; heap.$field.slots.len()],)* }
            }
        }

        impl Heap {
            /// Frees everything that is not marked, and counts anew what is left.
            pub(super) fn sweep(&mut self, marks: &Marks) {
                let mut bytes = 0;
                $(
                    for (i, slot) in self.$field.slots.iter_mut().enumerate() {
                        if let Some(object) = slot {
                            if marks.$field[i] {
                                bytes += std::mem::size_of::<Option<$type>>() + object.extra();
                            } else {
                                *slot = None;
                                self.$field.free.push(i as u32);
                            }
                        }
                    }
                )*
                self.bytes = bytes;
            }
        }
    };
}

heap! {
    bigs: BigInt,
    complexes: Complex,
    strs: Str,
    bytes_objects: Bytes,
    byte_arrays: ByteArray,
    tuples: Tuple,
    lists: List,
    dicts: Dict,
    sets: Set,
    slices: Slice,
    ranges: Range,
    functions: Function,
    methods: Method,
    classes: Class,
    instances: Instance,
    generators: Generator,
    iters: Iter,
    modules: Module,
    cells: Cell,
    properties: Property,
    wrapped: Wrapped,
    supers: Super,
    views: View,
    aliases: Alias,
    records: Record,
}

impl Heap {
    /// Stores an object. Memory limits are checked by the machine at its next safe point; whoever makes something large asks before
    /// (`Vm::reserve`).
    #[inline]
    pub fn alloc<T: Stored>(&mut self, object: T) -> Ref<T> {
        self.bytes += std::mem::size_of::<Option<T>>() + object.extra();
        let arena = T::arena_mut(self);
        if let Some(index) = arena.free.pop() {
            arena.slots[index as usize] = Some(object);
            Ref::new(index)
        } else {
            arena.slots.push(Some(object));
            Ref::new((arena.slots.len() - 1) as u32)
        }
    }

    /// A new `str`.
    pub fn str(&mut self, text: impl Into<Box<str>>) -> Value {
        Value::Str(self.alloc(Str::new(text)))
    }

    /// A new `tuple`.
    /// There is one empty tuple.
    pub fn tuple(&mut self, items: impl Into<SmallVec<[Value; 3]>>) -> Value {
        let items = items.into();
        if !items.is_empty() {
            return Value::Tuple(self.alloc(Tuple(items)));
        }
        let empty = match self.empty_tuple {
            Some(empty) => empty,
            None => {
                let empty = self.alloc(Tuple(items));
                self.empty_tuple = Some(empty);
                empty
            }
        };
        Value::Tuple(empty)
    }

    /// A new `tuple` of a copy of these values.
    #[inline]
    pub(super) fn tuple_from(&mut self, items: &[Value]) -> Value {
        if items.is_empty() || items.len() > 3 {
            return self.tuple(items);
        }
        let tuple = self.alloc(Tuple(SmallVec::from_buf_and_len([Value::Undefined; 3], items.len())));
        for (place, item) in self[tuple].0.iter_mut().zip(items) {
            // Numbers field by field (see `vm::fast`).
            match *item {
                Value::Float(x, h) => *place = Value::Float(x, h),
                _ => std::slice::from_mut(place).copy_from_slice(std::slice::from_ref(item)),
            }
        }
        Value::Tuple(tuple)
    }

    /// A new `list`.
    pub fn list(&mut self, items: Vec<Value>) -> Value {
        Value::List(self.alloc(List(items)))
    }

    /// A new empty `dict`.
    pub fn dict(&mut self) -> Ref<Dict> {
        self.alloc(Dict::default())
    }

    /// An int, normalised.
    pub fn big(&mut self, value: BigInt) -> Value {
        match i64::try_from(&value) {
            Ok(small) => Value::int(small),
            Err(_) => Value::Big(self.alloc(value)),
        }
    }
}

impl Heap {
    /// How many classes there are.
    pub(super) fn class_count(&self) -> u32 {
        self.classes.slots.len() as u32
    }
}
