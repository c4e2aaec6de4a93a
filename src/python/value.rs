//! Values of a program. A value is 16 bytes and `Copy`: numbers stand in it, all else is a typed index into the [`Heap`].
//!
//! [`Heap`]: super::heap::Heap

use super::heap::*;
use super::native::Native;
use crate::trace::Handle;
use num_bigint::BigInt;

/// A Python object, or the mark of an unbound slot.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    /// An unbound variable, a hole; never seen by a program.
    Undefined,
    /// `None`
    None,
    /// `...`
    Ellipsis,
    /// `NotImplemented`
    NotImplemented,
    /// `True`, `False`
    Bool(bool),
    /// An int of 64 bits, and where it came from.
    Int(i64, Handle),
    /// A float, and where it came from.
    Float(f64, Handle),
    /// An int that does not fit 64 bits (always normalised: a `Big` never fits an i64).
    Big(Ref<BigInt>),
    /// A complex number.
    Complex(Ref<Complex>),
    /// `str`
    Str(Ref<Str>),
    /// `bytes`
    Bytes(Ref<Bytes>),
    /// `bytearray`
    ByteArray(Ref<ByteArray>),
    /// `tuple`
    Tuple(Ref<Tuple>),
    /// `list`
    List(Ref<List>),
    /// `dict`
    Dict(Ref<Dict>),
    /// `set`
    Set(Ref<Set>),
    /// `frozenset` (the same storage as a set)
    FrozenSet(Ref<Set>),
    /// `slice`
    Slice(Ref<Slice>),
    /// `range`
    Range(Ref<Range>),
    /// A function written in Python.
    Function(Ref<Function>),
    /// A function written in Rust; as an attribute of a class it binds like a Python function if it is a method.
    Native(&'static Native),
    /// A callable bound to its first argument.
    Method(Ref<Method>),
    /// A class, built in or the program's.
    Class(Ref<Class>),
    /// An instance of a program's class, or of a builtin class without a variant of its own (`object()`, exceptions).
    Instance(Ref<Instance>),
    /// A generator.
    Generator(Ref<Generator>),
    /// A native iterator: `list_iterator`, `zip`, `itertools.chain`…
    Iter(Ref<Iter>),
    /// A module.
    Module(Ref<Module>),
    /// The cell of a captured variable; only in slots and closures.
    Cell(Ref<Cell>),
    /// `property`
    Property(Ref<Property>),
    /// `classmethod`
    ClassMethod(Ref<Wrapped>),
    /// `staticmethod`
    StaticMethod(Ref<Wrapped>),
    /// `super()`
    Super(Ref<Super>),
    /// `dict.keys()`, `.values()`, `.items()`
    View(Ref<View>),
    /// `mappingproxy`: a read-only view of a class's namespace or of a dict
    Proxy(Ref<Wrapped>),
    /// `list[int]`
    Alias(Ref<Alias>),
    /// An object of the host, by its kind and number (a scene object, `o.center`, a function of the host).
    Host(HostObject),
    /// An immutable value of the host made of a few values (a vector).
    Record(Ref<Record>),
}

/// An object of the host; what `kind` and `id` mean is the host's own business.
#[derive(Clone, Copy, Debug)]
pub struct HostObject {
    /// What it is.
    pub kind: u16,
    /// A small number beside the id, free for the host.
    pub part: u8,
    /// Which one.
    pub id: u32,
    /// The direction of the program in whose place it stands; makes no difference to what it is.
    pub site: Handle,
}

impl HostObject {
    fn key(self) -> (u16, u8, u32) {
        (self.kind, self.part, self.id)
    }
}

impl PartialEq for HostObject {
    fn eq(&self, other: &HostObject) -> bool {
        self.key() == other.key()
    }
}

impl Eq for HostObject {}

impl std::hash::Hash for HostObject {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}

impl Value {
    /// An int that no literal reaches.
    #[inline(always)]
    pub const fn int(v: i64) -> Value {
        Value::Int(v, Handle::NONE)
    }

    /// A float that no literal reaches.
    #[inline(always)]
    pub const fn float(v: f64) -> Value {
        Value::Float(v, Handle::NONE)
    }

    /// `is`: the same object. Small values are the same where they are equal and of one type, as in a CPython that shares constants.
    pub fn is(self, other: Value) -> bool {
        use Value::*;
        match (self, other) {
            (Undefined, Undefined) | (None, None) | (Ellipsis, Ellipsis) | (NotImplemented, NotImplemented) => true,
            (Bool(a), Bool(b)) => a == b,
            (Int(a, _), Int(b, _)) => a == b,
            (Float(a, _), Float(b, _)) => a.to_bits() == b.to_bits(),
            (Native(a), Native(b)) => std::ptr::eq(a, b),
            (Host(a), Host(b)) => a == b,
            (a, b) => std::mem::discriminant(&a) == std::mem::discriminant(&b) && a.index().is_some() && a.index() == b.index(),
        }
    }

    /// The heap index, for values that live there: with the variant, the identity of the object.
    pub fn index(self) -> Option<u32> {
        use Value::*;
        Some(match self {
            Big(r) => r.index(),
            Complex(r) => r.index(),
            Str(r) => r.index(),
            Bytes(r) => r.index(),
            ByteArray(r) => r.index(),
            Tuple(r) => r.index(),
            List(r) => r.index(),
            Dict(r) => r.index(),
            Set(r) | FrozenSet(r) => r.index(),
            Slice(r) => r.index(),
            Range(r) => r.index(),
            Function(r) => r.index(),
            Method(r) => r.index(),
            Class(r) => r.index(),
            Instance(r) => r.index(),
            Generator(r) => r.index(),
            Iter(r) => r.index(),
            Module(r) => r.index(),
            Cell(r) => r.index(),
            Property(r) => r.index(),
            ClassMethod(r) | StaticMethod(r) | Proxy(r) => r.index(),
            Super(r) => r.index(),
            View(r) => r.index(),
            Alias(r) => r.index(),
            Record(r) => r.index(),
            Undefined | None | Ellipsis | NotImplemented | Bool(_) | Int(..) | Float(..) | Native(_) | Host(_) => return Option::None,
        })
    }

    /// True for a slot that holds nothing.
    #[inline(always)]
    pub fn is_undefined(self) -> bool {
        matches!(self, Value::Undefined)
    }

    /// True for `None`.
    #[inline(always)]
    pub fn is_none(self) -> bool {
        matches!(self, Value::None)
    }

    /// The handle that a number carries.
    #[inline(always)]
    pub fn handle(self) -> Handle {
        match self {
            Value::Int(_, h) | Value::Float(_, h) => h,
            _ => Handle::NONE,
        }
    }
}

/// An attribute or keyword name, interned in a run. Equal texts have equal symbols.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct Symbol(pub u32);

/// The operators of `a op b`, in the order of CPython's slots.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[repr(u8)]
#[allow(missing_docs)]
pub enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
    FloorDiv,
    Mod,
    Pow,
    LShift,
    RShift,
    And,
    Or,
    Xor,
    MatMul,
}

impl BinaryOp {
    /// `+`, `-`, … as an error message spells it.
    pub fn text(self) -> &'static str {
        use BinaryOp::*;
        match self {
            Add => "+",
            Sub => "-",
            Mul => "*",
            Div => "/",
            FloorDiv => "//",
            Mod => "%",
            Pow => "** or pow()",
            LShift => "<<",
            RShift => ">>",
            And => "&",
            Or => "|",
            Xor => "^",
            MatMul => "@",
        }
    }
}

/// The operators of `op a`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[repr(u8)]
#[allow(missing_docs)]
pub enum UnaryOp {
    Neg,
    Pos,
    Invert,
}

/// The rich comparisons.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[repr(u8)]
#[allow(missing_docs)]
pub enum CompareOp {
    Lt,
    Le,
    Eq,
    Ne,
    Gt,
    Ge,
}

impl CompareOp {
    /// The operator with its sides exchanged.
    pub fn swapped(self) -> CompareOp {
        use CompareOp::*;
        match self {
            Lt => Gt,
            Le => Ge,
            Eq => Eq,
            Ne => Ne,
            Gt => Lt,
            Ge => Le,
        }
    }

    /// `<`, `<=`, …
    pub fn text(self) -> &'static str {
        use CompareOp::*;
        match self {
            Lt => "<",
            Le => "<=",
            Eq => "==",
            Ne => "!=",
            Gt => ">",
            Ge => ">=",
        }
    }

    /// Whether an ordering satisfies the operator.
    pub fn holds(self, order: std::cmp::Ordering) -> bool {
        use std::cmp::Ordering::*;
        match self {
            CompareOp::Lt => order == Less,
            CompareOp::Le => order != Greater,
            CompareOp::Eq => order == Equal,
            CompareOp::Ne => order != Equal,
            CompareOp::Gt => order == Greater,
            CompareOp::Ge => order != Less,
        }
    }
}
