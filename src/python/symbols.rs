//! Interned names. The names that the machine itself looks up have fixed numbers (`sym::INIT`).

use super::value::Symbol;
use rustc_hash::FxHashMap;
use std::borrow::Cow;

macro_rules! symbols {
    ($($constant:ident = $text:literal,)*) => {
        /// Names with fixed numbers.
        #[allow(missing_docs)]
        pub mod sym {
            use super::super::value::Symbol;
            #[allow(non_camel_case_types, clippy::upper_case_acronyms, dead_code)]
            #[repr(u32)]
            enum Number { $($constant,)* }
            $(pub const $constant: Symbol = Symbol(Number::$constant as u32);)*
        }
        const FIXED: &[&str] = &[$($text,)*];
    };
}

symbols! {
    NAME = "__name__",
    QUALNAME = "__qualname__",
    MODULE = "__module__",
    DOC = "__doc__",
    DICT = "__dict__",
    CLASS = "__class__",
    BASES = "__bases__",
    MRO = "__mro__",
    INIT = "__init__",
    NEW = "__new__",
    DEL = "__del__",
    REPR = "__repr__",
    STR = "__str__",
    BYTES = "__bytes__",
    FORMAT = "__format__",
    HASH = "__hash__",
    BOOL = "__bool__",
    LEN = "__len__",
    LENGTH_HINT = "__length_hint__",
    GETATTR = "__getattr__",
    GETATTRIBUTE = "__getattribute__",
    SETATTR = "__setattr__",
    DELATTR = "__delattr__",
    DIR = "__dir__",
    GET = "__get__",
    SET = "__set__",
    DELETE = "__delete__",
    SET_NAME = "__set_name__",
    INIT_SUBCLASS = "__init_subclass__",
    CLASS_GETITEM = "__class_getitem__",
    PREPARE = "__prepare__",
    INSTANCECHECK = "__instancecheck__",
    SUBCLASSCHECK = "__subclasscheck__",
    SUBCLASSES = "__subclasses__",
    SUBCLASSHOOK = "__subclasshook__",
    CALL = "__call__",
    GETITEM = "__getitem__",
    SETITEM = "__setitem__",
    DELITEM = "__delitem__",
    MISSING = "__missing__",
    ITER = "__iter__",
    NEXT = "__next__",
    REVERSED = "__reversed__",
    CONTAINS = "__contains__",
    ENTER = "__enter__",
    EXIT = "__exit__",
    SLOTS = "__slots__",
    MATCH_ARGS = "__match_args__",
    ANNOTATIONS = "__annotations__",
    DEFAULTS = "__defaults__",
    KWDEFAULTS = "__kwdefaults__",
    CLOSURE = "__closure__",
    CODE = "__code__",
    GLOBALS = "__globals__",
    WRAPPED = "__wrapped__",
    FUNC = "__func__",
    SELF = "__self__",
    LT = "__lt__",
    LE = "__le__",
    EQ = "__eq__",
    NE = "__ne__",
    GT = "__gt__",
    GE = "__ge__",
    ADD = "__add__",
    SUB = "__sub__",
    MUL = "__mul__",
    TRUEDIV = "__truediv__",
    FLOORDIV = "__floordiv__",
    MOD = "__mod__",
    POW = "__pow__",
    LSHIFT = "__lshift__",
    RSHIFT = "__rshift__",
    AND = "__and__",
    OR = "__or__",
    XOR = "__xor__",
    MATMUL = "__matmul__",
    RADD = "__radd__",
    RSUB = "__rsub__",
    RMUL = "__rmul__",
    RTRUEDIV = "__rtruediv__",
    RFLOORDIV = "__rfloordiv__",
    RMOD = "__rmod__",
    RPOW = "__rpow__",
    RLSHIFT = "__rlshift__",
    RRSHIFT = "__rrshift__",
    RAND = "__rand__",
    ROR = "__ror__",
    RXOR = "__rxor__",
    RMATMUL = "__rmatmul__",
    IADD = "__iadd__",
    ISUB = "__isub__",
    IMUL = "__imul__",
    ITRUEDIV = "__itruediv__",
    IFLOORDIV = "__ifloordiv__",
    IMOD = "__imod__",
    IPOW = "__ipow__",
    ILSHIFT = "__ilshift__",
    IRSHIFT = "__irshift__",
    IAND = "__iand__",
    IOR = "__ior__",
    IXOR = "__ixor__",
    IMATMUL = "__imatmul__",
    DIVMOD = "__divmod__",
    RDIVMOD = "__rdivmod__",
    NEG = "__neg__",
    POS = "__pos__",
    ABS = "__abs__",
    INVERT = "__invert__",
    INT = "__int__",
    FLOAT = "__float__",
    COMPLEX = "__complex__",
    INDEX = "__index__",
    ROUND = "__round__",
    TRUNC = "__trunc__",
    FLOOR = "__floor__",
    CEIL = "__ceil__",
    CAUSE = "__cause__",
    CONTEXT = "__context__",
    SUPPRESS_CONTEXT = "__suppress_context__",
    TRACEBACK = "__traceback__",
    NOTES = "__notes__",
    ORIGIN = "__origin__",
    ARGS = "__args__",
    COPY = "__copy__",
    DEEPCOPY = "__deepcopy__",
    CLASSCELL = "__classcell__",
    FSPATH = "__fspath__",
    MAIN = "__main__",
    BUILTINS = "__builtins__",
    ALL = "__all__",
    FILE = "__file__",
    MRO_ENTRIES = "__mro_entries__",
    OBJCLASS = "__objclass__",
    ISABSTRACTMETHOD = "__isabstractmethod__",
    ABSTRACTMETHODS = "__abstractmethods__",
    TYPE_PARAMS = "__type_params__",
    REDUCE_EX = "__reduce_ex__",
    REDUCE = "__reduce__",
    SIZEOF = "__sizeof__",
    GETSTATE = "__getstate__",
    GETNEWARGS = "__getnewargs__",
    WEAKREF = "__weakref__",
    DEBUG = "__debug__",
    IMPORT = "__import__",
    BUILD_CLASS = "__build_class__",
    N_ARGS = "args",
    N_KWARGS = "kwargs",
    N_SELF = "self",
    N_NAME = "name",
    N_VALUE = "value",
    N_VALUES = "values",
    N_KEYS = "keys",
    N_ITEMS = "items",
    N_SEND = "send",
    N_THROW = "throw",
    N_CLOSE = "close",
    N_KEY = "key",
    N_REVERSE = "reverse",
    N_DEFAULT = "default",
    N_START = "start",
    N_STOP = "stop",
    N_STEP = "step",
    N_END = "end",
    N_SEP = "sep",
    N_FILE = "file",
    N_FLUSH = "flush",
    N_MRO = "mro",
    N_GET = "get",
    N_ADD = "add",
    N_APPEND = "append",
    N_EXTEND = "extend",
    N_UPDATE = "update",
    N_POP = "pop",
    N_WITH_TRACEBACK = "with_traceback",
    N_ADD_NOTE = "add_note",
    N_MESSAGE = "message",
    N_EXCEPTIONS = "exceptions",
    N_SPLIT = "split",
    N_SUBGROUP = "subgroup",
    N_DERIVE = "derive",
    N_STRICT = "strict",
    N_INITIAL = "initial",
    N_FUNC = "func",
    N_FGET = "fget",
    N_FSET = "fset",
    N_FDEL = "fdel",
    N_DOC = "doc",
    N_METACLASS = "metaclass",
    N_MSG = "msg",
    N_OBJ = "obj",
    N_PATH = "path",
    N_ENCODING = "encoding",
    N_ERRORS = "errors",
    N_MAXSPLIT = "maxsplit",
    N_KEEPENDS = "keepends",
    N_TABSIZE = "tabsize",
    N_OLD = "old",
    N_NEW = "new",
    N_COUNT = "count",
    N_BASE = "base",
    N_NDIGITS = "ndigits",
    N_ITERABLE = "iterable",
    N_REPEAT = "repeat",
    N_FUNCTION = "function",
    N_REAL = "real",
    N_IMAG = "imag",
    N_SIGNED = "signed",
    N_BYTEORDER = "byteorder",
    N_LENGTH = "length",
    N_BYTES = "bytes",
    N_RANDOM = "random",
    N_SEED = "seed",
    N_CODE = "code",
}

/// The names of a run.
#[derive(Debug)]
pub struct Interner {
    texts: Vec<Cow<'static, str>>,
    index: FxHashMap<Cow<'static, str>, Symbol>,
}

impl Default for Interner {
    fn default() -> Self {
        Interner::new()
    }
}

impl Interner {
    /// The fixed names alone.
    pub fn new() -> Interner {
        let mut interner = Interner { texts: Vec::with_capacity(512), index: FxHashMap::with_capacity_and_hasher(512, Default::default()) };
        for text in FIXED {
            interner.add(Cow::Borrowed(text));
        }
        interner
    }

    /// The symbol of a text.
    pub fn intern(&mut self, text: &str) -> Symbol {
        if let Some(&symbol) = self.index.get(text) {
            return symbol;
        }
        self.add(Cow::Owned(text.to_string()))
    }

    fn add(&mut self, text: Cow<'static, str>) -> Symbol {
        let symbol = Symbol(self.texts.len() as u32);
        self.texts.push(text.clone());
        self.index.insert(text, symbol);
        symbol
    }

    /// The symbol of a text that was interned before.
    pub fn find(&self, text: &str) -> Option<Symbol> {
        self.index.get(text).copied()
    }

    /// The text of a symbol.
    #[inline]
    pub fn text(&self, symbol: Symbol) -> &str {
        &self.texts[symbol.0 as usize]
    }

    /// How many names there are.
    pub fn len(&self) -> usize {
        self.texts.len()
    }

    /// Never: the fixed names are always there.
    pub fn is_empty(&self) -> bool {
        self.texts.is_empty()
    }
}
