//! Compiled code: what `compile` makes and `vm` runs. Plain data without references into a heap, so that it can be shared between runs.

use num_bigint::BigInt;
use ruff_text_size::TextRange;

use super::value::{BinaryOp, CompareOp, UnaryOp};
use crate::syntax::LineIndex;
pub use crate::syntax::{ConstantId, DirectionId};

/// A code object within a run.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct CodeId(pub u32);

/// One instruction of the stack machine, of 8 bytes. Comments show the stack before → after, top at the right.
#[derive(Clone, Copy, PartialEq, Debug)]
#[allow(missing_docs)]
pub enum Op {
    Nop,
    /// a →
    Pop,
    /// a → a a
    Dup,
    /// a b → a b a b
    Dup2,
    /// a b → b a
    Swap,
    /// a b c → c a b
    Rot3,
    /// a b c d → d a b c
    Rot4,
    /// Pushes a copy of the value `n` below the top (0 is the top).
    Copy(u16),
    /// → constant
    Const(u32),
    LoadFast(u16),
    StoreFast(u16),
    DeleteFast(u16),
    /// Variables in cells; the slot holds the cell.
    LoadDeref(u16),
    StoreDeref(u16),
    DeleteDeref(u16),
    /// → cell
    LoadClosure(u16),
    /// In a class body: the namespace first, then the cell.
    LoadClassDeref {
        slot: u16,
        name: u32,
    },
    LoadGlobal(u32),
    StoreGlobal(u32),
    DeleteGlobal(u32),
    /// In a class body: the namespace, then globals, then builtins.
    LoadName(u32),
    StoreName(u32),
    DeleteName(u32),
    /// o → o.name
    LoadAttr(u32),
    /// value o →
    StoreAttr(u32),
    /// o →
    DeleteAttr(u32),
    /// o → function o | value Undefined
    LoadMethod(u32),
    /// o i → `o[i]`
    LoadSubscr,
    /// value o i →
    StoreSubscr,
    /// o i →
    DeleteSubscr,
    /// a b → a op b
    Binary(BinaryOp),
    /// a b → a op= b
    Inplace(BinaryOp),
    /// a → op a
    Unary(UnaryOp),
    /// a → not a
    Not,
    Compare(CompareOp),
    /// a b → a is b; `true`: is not
    Is(bool),
    /// a b → a in b; `true`: not in
    In(bool),
    Jump(u32),
    /// A jump to an earlier instruction: where steps are counted.
    JumpBack(u32),
    PopJumpIfFalse(u32),
    PopJumpIfTrue(u32),
    JumpIfFalseOrPop(u32),
    JumpIfTrueOrPop(u32),
    /// a →; jumps where it is None. (It is popped either way, as with the other `Pop…` jumps.)
    PopJumpIfNone(u32),
    /// iterable → iterator
    GetIter,
    /// iterable → iterator counter: the start of a `for`
    StartLoop,
    /// iterator counter → iterator counter item, or → and jumps to the end
    ForIter(u32),
    BuildTuple(u32),
    BuildList(u32),
    BuildSet(u32),
    /// k v k v … → dict; the operand counts pairs
    BuildDict(u32),
    BuildString(u32),
    /// 2 or 3 parts
    BuildSlice(u8),
    /// item →, appended to the list that then stands `n` below the top (0 is the top)
    ListAppend(u16),
    /// item →, likewise
    SetAdd(u16),
    /// key value →, likewise
    DictAdd(u16),
    /// list iterable → list
    ListExtend,
    SetUpdate,
    /// dict mapping → dict
    DictUpdate,
    /// callee … dict mapping → callee … dict; a repeated key is a TypeError that names the callee, which then stands `n` below the
    /// top (0 is the dict)
    DictMerge(u16),
    ListToTuple,
    /// value, spec if there is one → text; `conversion` is 0 or `s` `r` `a`
    Format {
        conversion: u8,
        spec: bool,
    },
    /// sequence → items, the first on top
    Unpack(u32),
    UnpackEx {
        before: u16,
        after: u16,
    },
    /// [defaults tuple] [keyword defaults dict] [annotations dict] [cells tuple] → function.
    /// `child` is a place in [`Code::children`]; `flags` says which of the four are there: 1, 2, 4, 8. The cells are in the order of the
    /// child's `frees`.
    MakeFunction {
        child: u32,
        flags: u8,
    },
    /// callee a b … → result
    Call(u32),
    /// callee a b … → result; `count` arguments in all, of which the last ones have names: the constant `names`, a tuple
    CallKw {
        count: u16,
        names: u32,
    },
    /// callee, args, kwargs if there are any → result; `true`: with kwargs, a fresh dict. `args` is a tuple or, for a lone `*x`, whatever `x` is: the
    /// machine iterates over it (TypeError: `f() argument after * must be an iterable, not int`)
    CallEx(bool),
    /// function self-or-Undefined a b … → result; the operand counts `a b …`
    CallMethod(u32),
    /// The same with names, as in `CallKw`
    CallMethodKw {
        count: u16,
        names: u32,
    },
    /// value →: leaves the frame, whose other operands go with it; it handles no exception any more
    Return,
    /// value → sent value
    Yield,
    /// iterator sent → result: delegates until the iterator is over
    YieldFrom,
    /// 0: re-raise; 1: exception →; 2: exception cause →
    Raise(u8),
    /// exception →: raises it again with its own traceback
    Reraise,
    /// exception → exception, which is now the one being handled
    PushExc,
    /// The exception that was being handled is done with; operands stay.
    PopExc,
    /// exception type → exception bool
    ExcMatch,
    /// group type → rest-or-None matched-or-None. `group` is a group, another exception (then `matched` is a group around it), or None
    /// (then both are None)
    ExcGroupMatch,
    /// original list → exception-to-raise-or-None. The list has what the clauses raised, in order, then the rest, which may be None
    ExcGroupFinish,
    /// manager → exit result-of-enter
    BeforeWith,
    /// exit exception → exit exception bool: what the manager's exit said
    WithExcept,
    /// → module. `name` may have dots: with `from` the result is the module that it names, without it the outermost package, for
    /// `import a.b`. Leading dots: a relative import, which is an ImportError
    Import {
        name: u32,
        from: bool,
    },
    /// module → module attribute
    ImportFrom(u32),
    /// module →
    ImportStar,
    /// → the function that builds classes
    BuildClass,
    /// → AssertionError
    AssertionError,
    /// subject → subject bool
    MatchSequence,
    /// subject → subject bool
    MatchMapping,
    /// subject → subject length
    GetLen,
    /// subject keys → subject keys values-or-None
    MatchKeys,
    /// subject class names → tuple-or-None; the operand counts positional patterns, `names` is a tuple of the keywords that follow them
    MatchClass(u32),
    /// subject keys → dict: a copy of the subject without the keys
    MatchRest,
    /// A facing is on top: another one where the run says so.
    Direction(DirectionId),
    /// A statement of the module begins; the operand is a place in [`Program::statements`].
    Statement(u32),
    /// a b → a op b with the operands named: locals and constants without a detour over the stack
    BinaryFastFast {
        op: BinaryOp,
        a: u16,
        b: u16,
    },
    /// left local, right constant
    BinaryFastConst {
        op: BinaryOp,
        a: u16,
        constant: u16,
    },
    /// a → a op constant
    BinaryConst {
        op: BinaryOp,
        constant: u16,
    },
    /// a → a op local
    BinaryFast {
        op: BinaryOp,
        b: u16,
    },
    /// a b →, jumps where the comparison is false
    CompareJump {
        op: CompareOp,
        target: u32,
    },
    /// a →, jumps where the comparison with the constant is false
    CompareConstJump {
        op: CompareOp,
        constant: u16,
        target: u32,
    },
    /// o → `o[constant]`
    LoadSubscrConst(u32),
    /// → local.name
    LoadFastAttr {
        slot: u16,
        name: u32,
    },
    /// → a b
    LoadFastFast {
        a: u16,
        b: u16,
    },
}

/// A constant of the program.
#[derive(Clone, PartialEq, Debug)]
#[allow(missing_docs)]
pub enum Const {
    None,
    Ellipsis,
    Bool(bool),
    Int(i64),
    Big(BigInt),
    /// A float; a tunable one with its number.
    Float(f64, Option<ConstantId>),
    Complex(f64, f64),
    Str(Box<str>),
    Bytes(Box<[u8]>),
    Tuple(Vec<Const>),
    FrozenSet(Vec<Const>),
}

/// A region whose exceptions continue at `target`, with the stack cut to `depth` operands and the exception pushed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub struct Handler {
    pub start: u32,
    pub end: u32,
    pub target: u32,
    pub depth: u32,
    /// How many exceptions are being handled within this code at that depth.
    pub handling: u32,
}

/// A `for` of the program: where it runs and where its counter stands, for provenance.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Loop {
    /// Its instructions.
    pub start: u32,
    /// One past them.
    pub end: u32,
    /// The operand at which the iterator stands; the counter follows.
    pub depth: u32,
    /// The `for` and its header.
    pub range: TextRange,
    /// The loop variable that a person would name, with its slot.
    pub variable: Option<(Box<str>, Slot)>,
}

/// Where a variable lives.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Slot {
    Fast(u16),
    Deref(u16),
    Global(u32),
}

/// What a code object is the body of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum CodeKind {
    Module,
    Class,
    Function,
    Lambda,
    Comprehension,
}

/// The parameters of a function. They are the first locals, in this order: positional, keyword-only, `*args`, `**kwargs`.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Params {
    /// Positional parameters, positional-only ones included.
    pub positional: u16,
    /// How many of them are positional-only.
    pub positional_only: u16,
    /// Keyword-only parameters.
    pub keyword_only: u16,
    /// Whether there is a `*args`.
    pub varargs: bool,
    /// Whether there is a `**kwargs`.
    pub varkw: bool,
}

/// A compiled body.
#[derive(Clone, PartialEq, Debug)]
pub struct Code {
    /// `__name__`
    pub name: Box<str>,
    /// `__qualname__`
    pub qualname: Box<str>,
    /// What it is the body of.
    pub kind: CodeKind,
    /// Whether calling it makes a generator.
    pub generator: bool,
    /// Parameters.
    pub params: Params,
    /// Names of the locals, parameters first; a name that begins with a dot is the compiler's own (any kind of code may have some).
    /// Slots after them: cells (`cells`), then captured variables (`frees`), then operands.
    pub locals: Vec<Box<str>>,
    /// Names of the variables that inner functions capture, with the local they start from where that is a parameter.
    pub cells: Vec<(Box<str>, Option<u16>)>,
    /// Names of captured variables.
    pub frees: Vec<Box<str>>,
    /// Instructions.
    pub ops: Vec<Op>,
    /// The piece of text behind each instruction.
    pub ranges: Vec<TextRange>,
    /// Constants.
    pub consts: Vec<Const>,
    /// Attribute, keyword and class-scope names.
    pub names: Vec<Box<str>>,
    /// Inner code objects, as numbers within the same [`Program`].
    pub children: Vec<u32>,
    /// Exception table; inner regions come first.
    pub handlers: Vec<Handler>,
    /// `for` loops; inner ones come first. One loop may have several entries, for separate pieces of its code.
    pub loops: Vec<Loop>,
    /// First instruction and range of each statement, ascending by instruction.
    pub statements: Vec<(u32, TextRange)>,
    /// The docstring.
    pub doc: Option<Box<str>>,
}

/// A statement of the module: where its code begins and ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub struct TopStatement {
    pub start: u32,
    pub end: u32,
    pub range: TextRange,
}

/// A compiled module.
#[derive(Clone, PartialEq, Debug)]
pub struct Program {
    /// All code objects; the module's own is the first.
    pub codes: Vec<Code>,
    /// Names of the global variables, by slot.
    pub globals: Vec<Box<str>>,
    /// The statements of the module.
    pub statements: Vec<TopStatement>,
    /// Where the lines of its text begin.
    pub lines: LineIndex,
}
