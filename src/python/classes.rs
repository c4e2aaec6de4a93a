//! The builtin classes: they stand at the beginning of each heap's class arena, in the order of [`Builtin`].

use super::heap::{Class, Heap, Layout, Ref};
use super::native::Native;
use super::symbols::sym;
use super::types;
use super::value::Value;

/// What a builtin class is made from.
struct Row {
    name: &'static str,
    bases: &'static [Builtin],
    layout: Layout,
    natives: &'static [Native],
}

macro_rules! builtins {
    ($($variant:ident = $name:literal, [$($base:ident),*], $layout:ident, $natives:expr;)*) => {
        /// A builtin class.
        #[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
        #[repr(u32)]
        #[allow(missing_docs)]
        pub enum Builtin { $($variant,)* }

        const ROWS: &[Row] = &[$(Row { name: $name, bases: &[$(Builtin::$base),*], layout: Layout::$layout, natives: $natives },)*];
        const ALL: &[Builtin] = &[$(Builtin::$variant,)*];
    };
}

builtins! {
    Object = "object", [], Object, types::object::OBJECT;
    Type = "type", [Object], Type, types::object::TYPE;
    Int = "int", [Object], Int, types::int::METHODS;
    Bool = "bool", [Int], Sealed, types::int::BOOL;
    Float = "float", [Object], Float, types::float::METHODS;
    Complex = "complex", [Object], Complex, types::complex::METHODS;
    Str = "str", [Object], Str, types::str::METHODS;
    Bytes = "bytes", [Object], Bytes, types::bytes::METHODS;
    ByteArray = "bytearray", [Object], ByteArray, types::bytes::ARRAY;
    Tuple = "tuple", [Object], Tuple, types::tuple::METHODS;
    List = "list", [Object], List, types::list::METHODS;
    Dict = "dict", [Object], Dict, types::dict::METHODS;
    Set = "set", [Object], Set, types::set::METHODS;
    FrozenSet = "frozenset", [Object], FrozenSet, types::set::FROZEN;
    Slice = "slice", [Object], Sealed, types::range::SLICE;
    Range = "range", [Object], Sealed, types::range::METHODS;
    NoneType = "NoneType", [Object], Sealed, &[];
    Ellipsis = "ellipsis", [Object], Sealed, &[];
    NotImplementedType = "NotImplementedType", [Object], Sealed, &[];
    Function = "function", [Object], Sealed, types::function::FUNCTION;
    NativeFunction = "builtin_function_or_method", [Object], Sealed, types::function::NATIVE;
    NativeMethod = "method_descriptor", [Object], Sealed, types::function::NATIVE;
    Method = "method", [Object], Sealed, types::function::METHOD;
    Generator = "generator", [Object], Sealed, types::function::GENERATOR;
    Module = "module", [Object], Sealed, &[];
    Cell = "cell", [Object], Sealed, types::function::CELL;
    Property = "property", [Object], Property, types::function::PROPERTY;
    ClassMethod = "classmethod", [Object], Sealed, types::function::CLASS_METHOD;
    StaticMethod = "staticmethod", [Object], Sealed, types::function::STATIC_METHOD;
    Super = "super", [Object], Sealed, &[];
    MappingProxy = "mappingproxy", [Object], Sealed, types::dict::PROXY;
    GenericAlias = "types.GenericAlias", [Object], Sealed, types::object::ALIAS;
    UnionType = "types.UnionType", [Object], Sealed, types::object::ALIAS;
    DictKeys = "dict_keys", [Object], Sealed, types::dict::KEYS;
    DictValues = "dict_values", [Object], Sealed, types::dict::VALUES;
    DictItems = "dict_items", [Object], Sealed, types::dict::ITEMS;
    Enumerate = "enumerate", [Object], Sealed, types::iterator::METHODS;
    Zip = "zip", [Object], Sealed, types::iterator::METHODS;
    Map = "map", [Object], Sealed, types::iterator::METHODS;
    Filter = "filter", [Object], Sealed, types::iterator::METHODS;
    Reversed = "reversed", [Object], Sealed, types::iterator::METHODS;
    ListIterator = "list_iterator", [Object], Sealed, types::iterator::METHODS;
    ListReverseIterator = "list_reverseiterator", [Object], Sealed, types::iterator::METHODS;
    TupleIterator = "tuple_iterator", [Object], Sealed, types::iterator::METHODS;
    RangeIterator = "range_iterator", [Object], Sealed, types::iterator::METHODS;
    LongRangeIterator = "longrange_iterator", [Object], Sealed, types::iterator::METHODS;
    StrIterator = "str_iterator", [Object], Sealed, types::iterator::METHODS;
    BytesIterator = "bytes_iterator", [Object], Sealed, types::iterator::METHODS;
    ByteArrayIterator = "bytearray_iterator", [Object], Sealed, types::iterator::METHODS;
    DictKeyIterator = "dict_keyiterator", [Object], Sealed, types::iterator::METHODS;
    DictValueIterator = "dict_valueiterator", [Object], Sealed, types::iterator::METHODS;
    DictItemIterator = "dict_itemiterator", [Object], Sealed, types::iterator::METHODS;
    DictReverseKeyIterator = "dict_reversekeyiterator", [Object], Sealed, types::iterator::METHODS;
    SetIterator = "set_iterator", [Object], Sealed, types::iterator::METHODS;
    CallableIterator = "callable_iterator", [Object], Sealed, types::iterator::METHODS;
    SequenceIterator = "iterator", [Object], Sealed, types::iterator::METHODS;
    MemberDescriptor = "member_descriptor", [Object], Sealed, types::member::METHODS;
    SlotWrapper = "wrapper_descriptor", [Object], Sealed, types::function::NATIVE;
    MethodWrapper = "method-wrapper", [Object], Sealed, types::function::NATIVE;
    GetSet = "getset_descriptor", [Object], Sealed, types::function::GETSET;
    Traceback = "traceback", [Object], Sealed, &[];
    CodeObject = "code", [Object], Sealed, &[];
    ToolAccumulate = "itertools.accumulate", [Object], Sealed, types::iterator::METHODS;
    ToolChain = "itertools.chain", [Object], Sealed, types::iterator::CHAIN;
    ToolCombinations = "itertools.combinations", [Object], Sealed, types::iterator::METHODS;
    ToolCombinationsWithReplacement = "itertools.combinations_with_replacement", [Object], Sealed, types::iterator::METHODS;
    ToolCompress = "itertools.compress", [Object], Sealed, types::iterator::METHODS;
    ToolCount = "itertools.count", [Object], Sealed, types::iterator::SHOWN;
    ToolCycle = "itertools.cycle", [Object], Sealed, types::iterator::METHODS;
    ToolDropwhile = "itertools.dropwhile", [Object], Sealed, types::iterator::METHODS;
    ToolFilterfalse = "itertools.filterfalse", [Object], Sealed, types::iterator::METHODS;
    ToolGroupby = "itertools.groupby", [Object], Sealed, types::iterator::METHODS;
    ToolIslice = "itertools.islice", [Object], Sealed, types::iterator::METHODS;
    ToolPairwise = "itertools.pairwise", [Object], Sealed, types::iterator::METHODS;
    ToolPermutations = "itertools.permutations", [Object], Sealed, types::iterator::METHODS;
    ToolProduct = "itertools.product", [Object], Sealed, types::iterator::METHODS;
    ToolRepeat = "itertools.repeat", [Object], Sealed, types::iterator::SHOWN;
    ToolStarmap = "itertools.starmap", [Object], Sealed, types::iterator::METHODS;
    ToolTakewhile = "itertools.takewhile", [Object], Sealed, types::iterator::METHODS;
    ToolZipLongest = "itertools.zip_longest", [Object], Sealed, types::iterator::METHODS;
    ToolGrouper = "itertools._grouper", [Object], Sealed, types::iterator::METHODS;
    ToolTee = "itertools._tee", [Object], Sealed, types::iterator::METHODS;
    BaseException = "BaseException", [Object], Exception, types::exception::METHODS;
    SystemExit = "SystemExit", [BaseException], Exception, types::exception::SYSTEM_EXIT;
    KeyboardInterrupt = "KeyboardInterrupt", [BaseException], Exception, &[];
    GeneratorExit = "GeneratorExit", [BaseException], Exception, &[];
    BaseExceptionGroup = "BaseExceptionGroup", [BaseException], Exception, types::exception::GROUP;
    Exception = "Exception", [BaseException], Exception, &[];
    ExceptionGroup = "ExceptionGroup", [BaseExceptionGroup, Exception], Exception, &[];
    StopIteration = "StopIteration", [Exception], Exception, types::exception::STOP_ITERATION;
    StopAsyncIteration = "StopAsyncIteration", [Exception], Exception, &[];
    ArithmeticError = "ArithmeticError", [Exception], Exception, &[];
    FloatingPointError = "FloatingPointError", [ArithmeticError], Exception, &[];
    OverflowError = "OverflowError", [ArithmeticError], Exception, &[];
    ZeroDivisionError = "ZeroDivisionError", [ArithmeticError], Exception, &[];
    AssertionError = "AssertionError", [Exception], Exception, &[];
    AttributeError = "AttributeError", [Exception], Exception, types::exception::ATTRIBUTE_ERROR;
    BufferError = "BufferError", [Exception], Exception, &[];
    EOFError = "EOFError", [Exception], Exception, &[];
    ImportError = "ImportError", [Exception], Exception, types::exception::IMPORT_ERROR;
    ModuleNotFoundError = "ModuleNotFoundError", [ImportError], Exception, &[];
    LookupError = "LookupError", [Exception], Exception, &[];
    IndexError = "IndexError", [LookupError], Exception, &[];
    KeyError = "KeyError", [LookupError], Exception, types::exception::KEY_ERROR;
    MemoryError = "MemoryError", [Exception], Exception, &[];
    NameError = "NameError", [Exception], Exception, types::exception::NAME_ERROR;
    UnboundLocalError = "UnboundLocalError", [NameError], Exception, &[];
    OSError = "OSError", [Exception], Exception, types::exception::OS_ERROR;
    BlockingIOError = "BlockingIOError", [OSError], Exception, &[];
    ChildProcessError = "ChildProcessError", [OSError], Exception, &[];
    ConnectionError = "ConnectionError", [OSError], Exception, &[];
    BrokenPipeError = "BrokenPipeError", [ConnectionError], Exception, &[];
    ConnectionAbortedError = "ConnectionAbortedError", [ConnectionError], Exception, &[];
    ConnectionRefusedError = "ConnectionRefusedError", [ConnectionError], Exception, &[];
    ConnectionResetError = "ConnectionResetError", [ConnectionError], Exception, &[];
    FileExistsError = "FileExistsError", [OSError], Exception, &[];
    FileNotFoundError = "FileNotFoundError", [OSError], Exception, &[];
    InterruptedError = "InterruptedError", [OSError], Exception, &[];
    IsADirectoryError = "IsADirectoryError", [OSError], Exception, &[];
    NotADirectoryError = "NotADirectoryError", [OSError], Exception, &[];
    PermissionError = "PermissionError", [OSError], Exception, &[];
    ProcessLookupError = "ProcessLookupError", [OSError], Exception, &[];
    TimeoutError = "TimeoutError", [OSError], Exception, &[];
    ReferenceError = "ReferenceError", [Exception], Exception, &[];
    RuntimeError = "RuntimeError", [Exception], Exception, &[];
    NotImplementedError = "NotImplementedError", [RuntimeError], Exception, &[];
    RecursionError = "RecursionError", [RuntimeError], Exception, &[];
    SyntaxError = "SyntaxError", [Exception], Exception, types::exception::SYNTAX_ERROR;
    IndentationError = "IndentationError", [SyntaxError], Exception, &[];
    TabError = "TabError", [IndentationError], Exception, &[];
    SystemError = "SystemError", [Exception], Exception, &[];
    TypeError = "TypeError", [Exception], Exception, &[];
    ValueError = "ValueError", [Exception], Exception, &[];
    UnicodeError = "UnicodeError", [ValueError], Exception, &[];
    UnicodeDecodeError = "UnicodeDecodeError", [UnicodeError], Exception, types::unicode_error::DECODE;
    UnicodeEncodeError = "UnicodeEncodeError", [UnicodeError], Exception, types::unicode_error::ENCODE;
    UnicodeTranslateError = "UnicodeTranslateError", [UnicodeError], Exception, types::unicode_error::TRANSLATE;
    Warning = "Warning", [Exception], Exception, &[];
    BytesWarning = "BytesWarning", [Warning], Exception, &[];
    DeprecationWarning = "DeprecationWarning", [Warning], Exception, &[];
    EncodingWarning = "EncodingWarning", [Warning], Exception, &[];
    FutureWarning = "FutureWarning", [Warning], Exception, &[];
    ImportWarning = "ImportWarning", [Warning], Exception, &[];
    PendingDeprecationWarning = "PendingDeprecationWarning", [Warning], Exception, &[];
    ResourceWarning = "ResourceWarning", [Warning], Exception, &[];
    RuntimeWarning = "RuntimeWarning", [Warning], Exception, &[];
    SyntaxWarning = "SyntaxWarning", [Warning], Exception, &[];
    UnicodeWarning = "UnicodeWarning", [Warning], Exception, &[];
    UserWarning = "UserWarning", [Warning], Exception, &[];
}

impl Builtin {
    /// The class object.
    #[inline(always)]
    pub const fn class(self) -> Ref<Class> {
        Ref::new(self as u32)
    }

    /// The class as a value.
    pub const fn value(self) -> Value {
        Value::Class(self.class())
    }

    /// `__name__`
    pub fn name(self) -> &'static str {
        ROWS[self as usize].name
    }

    /// The name of a builtin class with its module, where that is not `builtins`: `types.UnionType`.
    pub fn full_name(class: Ref<Class>) -> Option<&'static str> {
        ROWS.get(class.index() as usize).map(|row| row.name)
    }

    /// The builtin class in whose table a native function stands.
    pub fn owner(native: &'static Native) -> Option<Builtin> {
        let place = ROWS.iter().position(|row| row.natives.as_ptr_range().contains(&std::ptr::from_ref(native)))?;
        ALL.get(place).copied()
    }

    /// The builtin class of this name that programs reach without an import.
    pub fn by_name(name: &str) -> Option<Builtin> {
        let position = ROWS.iter().position(|row| row.name == name)?;
        let hidden = matches!(ROWS[position].layout, Layout::Sealed)
            && !matches!(
                name,
                "bool" | "slice" | "range" | "classmethod" | "staticmethod" | "super" | "enumerate" | "zip" | "map" | "filter" | "reversed"
            );
        if hidden { None } else { Some(ALL[position]) }
    }
}

/// Fills the class arena of a new heap.
pub(super) fn install(heap: &mut Heap) {
    for row in ROWS {
        let short = row.name.rsplit('.').next().unwrap_or(row.name);
        let name = heap.str(short);
        let mut mro = vec![Ref::new(heap.class_count())];
        for base in row.bases {
            for class in heap[base.class()].mro.clone() {
                if !mro.contains(&class) {
                    mro.push(class);
                }
            }
        }
        if row.bases.len() > 1 {
            // ExceptionGroup alone: BaseException comes after Exception.
            mro.retain(|c| !matches!(c.index(), i if i == Builtin::BaseException as u32 || i == Builtin::Object as u32));
            mro.extend([Builtin::BaseException.class(), Builtin::Object.class()]);
        }
        heap.alloc(Class {
            name,
            qualname: name,
            bases: row.bases.iter().map(|b| b.class()).collect(),
            mro,
            attrs: Default::default(),
            meta: Builtin::Type.class(),
            layout: row.layout,
            natives: row.natives,
            builtin: true,
            slots: None,
            hooked: false,
            subclasses: Vec::new(),
        });
    }
    // What can change cannot be a key, and says so.
    for builtin in [Builtin::List, Builtin::Dict, Builtin::Set, Builtin::ByteArray, Builtin::Slice] {
        heap[builtin.class()].attrs.insert(sym::HASH, Value::None);
    }
    for (i, row) in ROWS.iter().enumerate() {
        for base in row.bases {
            heap[base.class()].subclasses.push(Ref::new(i as u32));
        }
    }
}
