"""Type hints. Names are made when they are first asked for, so that importing the module costs little."""

from _types import GenericAlias as _Builtin

__all__ = [
    "Annotated", "Any", "Callable", "ClassVar", "Concatenate", "Final", "ForwardRef", "Generic", "Literal", "Optional",
    "ParamSpec", "Protocol", "Tuple", "Type", "TypeVar", "TypeVarTuple", "Union", "AbstractSet", "ByteString", "Container",
    "ContextManager", "Hashable", "ItemsView", "Iterable", "Iterator", "KeysView", "Mapping", "MappingView", "MutableMapping",
    "MutableSequence", "MutableSet", "Sequence", "Sized", "ValuesView", "Awaitable", "AsyncIterator", "AsyncIterable",
    "Coroutine", "Collection", "AsyncGenerator", "AsyncContextManager", "Reversible", "SupportsAbs", "SupportsBytes",
    "SupportsComplex", "SupportsFloat", "SupportsIndex", "SupportsInt", "SupportsRound", "ChainMap", "Counter", "Deque",
    "Dict", "DefaultDict", "List", "OrderedDict", "Set", "FrozenSet", "NamedTuple", "TypedDict", "Generator", "BinaryIO",
    "IO", "Match", "Pattern", "TextIO", "AnyStr", "assert_type", "assert_never", "cast", "clear_overloads",
    "dataclass_transform", "final", "get_args", "get_origin", "get_overloads", "get_type_hints", "is_typeddict",
    "LiteralString", "Never", "NewType", "no_type_check", "no_type_check_decorator", "NoReturn", "NotRequired", "overload",
    "ParamSpecArgs", "ParamSpecKwargs", "Required", "reveal_type", "runtime_checkable", "Self", "Text", "TYPE_CHECKING",
    "TypeAlias", "TypeGuard", "Unpack",
]

TYPE_CHECKING = False
Text = str
_NoneType = type(None)


def _type_repr(item):
    if isinstance(item, type) and not hasattr(item, "__origin__"):
        return item.__qualname__ if item.__module__ == "builtins" else f"{item.__module__}.{item.__qualname__}"
    if item is ...:
        return "..."
    if type(item) is type(_type_repr):
        return item.__name__
    return repr(item)


def _convert(item, what="Parameters to generic types must be types."):
    """A type argument as it is kept: None as its type, a string as a forward reference."""
    if item is None:
        return _NoneType
    if isinstance(item, str):
        return ForwardRef(item)
    if isinstance(item, _SpecialForm) and item._name in ("ClassVar", "Final"):
        raise TypeError(f"Plain {item!r} is not valid as type argument")
    if isinstance(item, _SpecialForm) and item._bare:
        raise TypeError(f"Plain {item!r} is not valid as type argument")
    if _is_bare(item):
        raise TypeError(f"Plain {item!r} is not valid as type argument")
    if type(item) is tuple:
        raise TypeError(f"{what} Got {item!r}.")
    return item


def _is_bare(item):
    """Whether it is Generic or Protocol itself."""
    return isinstance(item, type) and item.__dict__.get("_is_bare", False)


def _collect_parameters(args):
    found = {}
    for item in args:
        if isinstance(item, type):
            continue
        if isinstance(item, _TypeParameter):
            found[item] = None
        else:
            for parameter in getattr(item, "__parameters__", ()):
                found[parameter] = None
    return tuple(found)


def _check_count(what, given, expected):
    if given != expected:
        few = "many" if given > expected else "few"
        raise TypeError(f"Too {few} arguments for {what}; actual {given}, expected {expected}")


def _substitute(alias, args, items):
    """`args` of `alias` with its free parameters replaced, in order, by `items`."""
    parameters = _collect_parameters(args)
    if not parameters:
        raise TypeError(f"{alias!r} is not a generic class")
    items = items if isinstance(items, tuple) else (items,)
    if not any([p._variadic for p in parameters]):
        _check_count(alias, len(items), len(parameters))
    given = dict(zip(parameters, [_convert(item) for item in items]))
    made = []
    for item in args:
        if isinstance(item, type):
            made.append(item)
        elif isinstance(item, _TypeParameter):
            made.append(given.get(item, item))
        else:
            inner = getattr(item, "__parameters__", ())
            made.append(item[tuple([given[p] for p in inner])] if inner else item)
    return tuple(made)


class ForwardRef:
    __slots__ = ("__forward_arg__", "__forward_module__")

    def __init__(self, arg, is_argument=True, module=None, *, is_class=False):
        if not isinstance(arg, str):
            raise TypeError(f"Forward reference must be a string -- got {arg!r}")
        self.__forward_arg__ = arg
        self.__forward_module__ = module

    def __eq__(self, other):
        if not isinstance(other, ForwardRef):
            return NotImplemented
        return self.__forward_arg__ == other.__forward_arg__

    def __hash__(self):
        return hash(("ForwardRef", self.__forward_arg__))

    def __or__(self, other):
        return Union[self, other]

    def __ror__(self, other):
        return Union[other, self]

    def __repr__(self):
        return f"ForwardRef({self.__forward_arg__!r})"


class _Typed:
    """What all forms and aliases have in common."""

    __slots__ = ()
    __module__ = "typing"

    def __or__(self, other):
        return Union[self, other]

    def __ror__(self, other):
        return Union[other, self]


class _SpecialForm(_Typed):
    """`Union`, `Literal`, `ClassVar`: names that mean something to a type checker only."""

    __slots__ = ("_name", "_make", "_bare")

    def __init__(self, name, make=None, bare=False):
        self._name = name
        self._make = make
        self._bare = bare

    def __getitem__(self, items):
        if self._make is None:
            raise TypeError(f"{self!r} is not subscriptable")
        return self._make(self, items)

    def __repr__(self):
        return "typing." + self._name

    def __call__(self, *args, **kwargs):
        raise TypeError(f"Cannot instantiate {self!r}")

    def __mro_entries__(self, bases):
        raise TypeError(f"Cannot subclass {self!r}")

    def __instancecheck__(self, instance):
        raise TypeError(f"{self!r} cannot be used with isinstance()")

    def __subclasscheck__(self, cls):
        raise TypeError(f"{self!r} cannot be used with issubclass()")


def _named_entries(alias, bases, later):
    """What `class X(List[int])` inherits from in place of the alias."""
    entries = () if alias.__origin__ in bases else (alias.__origin__,)
    if any(isinstance(b, (_GenericAlias, _SpecialAlias)) or isinstance(b, type) and issubclass(b, Generic) for b in later):
        return entries
    return entries + (Generic,)


class _GenericAlias(_Typed):
    """A subscripted form or class: `List[int]`, `Box[int]`, `Optional[str]`."""

    def __init__(self, origin, args, name=None):
        self.__origin__ = origin
        self.__args__ = args if isinstance(args, tuple) else (args,)
        self.__parameters__ = _collect_parameters(self.__args__)
        self._name = name

    def _with(self, args):
        return type(self)(self.__origin__, args, self._name)

    def __getitem__(self, items):
        if _is_bare(self.__origin__):
            raise TypeError(f"Cannot subscript already-subscripted {self!r}")
        return self._with(_substitute(self, self.__args__, items))

    def __repr__(self):
        name = "typing." + self._name if self._name else _type_repr(self.__origin__)
        args = ", ".join([_type_repr(a) for a in self.__args__]) or "()"
        return f"{name}[{args}]"

    def __eq__(self, other):
        if not isinstance(other, _GenericAlias):
            return NotImplemented
        return self.__origin__ == other.__origin__ and self.__args__ == other.__args__

    def __hash__(self):
        return hash((self.__origin__, self.__args__))

    def __call__(self, *args, **kwargs):
        if self._name:
            raise TypeError(f"Type {self._name} cannot be instantiated; use {self.__origin__.__name__}() instead")
        made = self.__origin__(*args, **kwargs)
        try:
            made.__orig_class__ = self
        except AttributeError:
            pass
        return made

    def __getattr__(self, name):
        if name.startswith("__") and name.endswith("__") and name not in ("__name__", "__qualname__", "__doc__"):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        return getattr(self.__origin__, name)

    def __mro_entries__(self, bases):
        if isinstance(self.__origin__, _SpecialForm):
            raise TypeError(f"Cannot subclass {self!r}")
        later = bases[[b is self for b in bases].index(True) + 1:]
        if self._name:
            return _named_entries(self, bases, later)
        if self.__origin__ is Generic and (any([_is_bare(b) and b is not Generic for b in bases]) or any(isinstance(b, (_GenericAlias, _SpecialAlias)) for b in later)):
            return ()
        return (self.__origin__,)

    def __instancecheck__(self, instance):
        return self.__subclasscheck__(type(instance))

    def __subclasscheck__(self, cls):
        raise TypeError("Subscripted generics cannot be used with class and instance checks")


class _UnionAlias(_GenericAlias):
    def _with(self, args):
        return Union[args]

    def __eq__(self, other):
        args = _union_args(other)
        return NotImplemented if args is None else set(self.__args__) == set(args)

    def __hash__(self):
        return hash(frozenset(self.__args__))

    def __repr__(self):
        args = self.__args__
        if len(args) == 2 and _NoneType in args:
            return f"typing.Optional[{_type_repr(args[1] if args[0] is _NoneType else args[0])}]"
        return super().__repr__()

    def __call__(self, *args, **kwargs):
        raise TypeError("Cannot instantiate typing.Union")

    def __instancecheck__(self, instance):
        return any(isinstance(instance, arg) for arg in self.__args__)

    def __subclasscheck__(self, cls):
        return any(issubclass(cls, arg) for arg in self.__args__)


class _CallableAlias(_GenericAlias):
    def _with(self, args):
        return _CallableAlias(self.__origin__, args, self._name)

    def __repr__(self):
        *parameters, result = self.__args__
        if len(parameters) == 1 and (parameters[0] is ... or isinstance(parameters[0], _TypeParameter) and parameters[0]._variadic):
            return f"typing.Callable[{_type_repr(parameters[0])}, {_type_repr(result)}]"
        return f"typing.Callable[[{', '.join([_type_repr(p) for p in parameters])}], {_type_repr(result)}]"


class _SpecialAlias(_Typed):
    """`List`, `Iterable`: a class under its name in this module, waiting for parameters."""

    def __init__(self, name, load, count):
        self._name = name
        self._load = load
        self._count = count

    @property
    def __origin__(self):
        origin = self._load
        if isinstance(origin, str):
            module, _, attribute = origin.rpartition(".")
            if module == "collections":
                import collections as found
            else:
                import _collections_abc as found
            origin = self._load = getattr(found, attribute)
        return origin

    @property
    def __parameters__(self):
        return ()

    def __getitem__(self, items):
        items = items if isinstance(items, tuple) else (items,)
        args = tuple([_convert(item) for item in items])
        if self._count == 0:
            raise TypeError(f"{self!r} is not a generic class")
        _check_count(self, len(args), self._count)
        return _GenericAlias(self.__origin__, args, self._name)

    def __repr__(self):
        return "typing." + self._name

    def __call__(self, *args, **kwargs):
        raise TypeError(f"Type {self._name} cannot be instantiated; use {self.__origin__.__name__}() instead")

    def __getattr__(self, name):
        if name == "__name__" or name == "__qualname__":
            return self._name
        if name.startswith("__") and name.endswith("__"):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        return getattr(self.__origin__, name)

    def __mro_entries__(self, bases):
        return _named_entries(self, bases, bases[[b is self for b in bases].index(True) + 1:])

    def __instancecheck__(self, instance):
        return isinstance(instance, self.__origin__)

    def __subclasscheck__(self, cls):
        if isinstance(cls, _SpecialAlias):
            cls = cls.__origin__
        return issubclass(cls, self.__origin__)


class _TupleAlias(_SpecialAlias):
    def __getitem__(self, items):
        items = items if isinstance(items, tuple) else (items,)
        if len(items) >= 2 and items[-1] is ...:
            return _GenericAlias(tuple, tuple([_convert(i) for i in items[:-1]]) + (...,), "Tuple")
        return _GenericAlias(tuple, tuple([_convert(i) for i in items]), "Tuple")


class _CallableForm(_SpecialAlias):
    def __getitem__(self, items):
        if not isinstance(items, tuple) or len(items) != 2:
            raise TypeError("Callable must be used as Callable[[arg, ...], result].")
        parameters, result = items
        if isinstance(parameters, list):
            parameters = tuple([_convert(p) for p in parameters])
        else:
            parameters = (parameters,)
        result = _convert(result, "Callable[args, result]: result must be a type.")
        return _CallableAlias(self.__origin__, parameters + (result,), "Callable")


def _union_args(item):
    if isinstance(item, _UnionAlias):
        return item.__args__
    if type(item) is type(int | None):
        return item.__args__
    return None


def _make_union(form, items):
    if items == ():
        raise TypeError("Cannot take a Union of no types.")
    flat = []
    for item in items if isinstance(items, tuple) else (items,):
        item = _convert(item, "Union[arg, ...]: each arg must be a type.")
        flat.extend(_union_args(item) or (item,))
    unique = []
    for item in flat:
        if item not in unique:
            unique.append(item)
    if len(unique) == 1:
        return unique[0]
    return _UnionAlias(Union, tuple(unique), "Union")


def _make_optional(form, item):
    if isinstance(item, tuple):
        raise TypeError(f"typing.Optional requires a single type. Got {item!r}.")
    return Union[_convert(item), _NoneType]


def _make_single(form, item):
    if isinstance(item, tuple):
        raise TypeError(f"{form!r} accepts only single type. Got {item!r}.")
    return _GenericAlias(form, (_convert(item, f"{form!r} accepts only single type."),), form._name)


def _make_concatenate(form, items):
    items = items if isinstance(items, tuple) else (items,)
    return _GenericAlias(form, tuple([_convert(item) for item in items]), form._name)


Union = _SpecialForm("Union", _make_union)


class _TypeParameter(_Typed):
    _variadic = False

    def __repr__(self):
        return "~" + self.__name__

    def __mro_entries__(self, bases):
        raise TypeError(f"Cannot subclass an instance of {type(self).__name__}")


class TypeVar(_TypeParameter):
    def __init__(self, name, *constraints, bound=None, covariant=False, contravariant=False):
        if covariant and contravariant:
            raise ValueError("Bivariant types are not supported.")
        if constraints and bound is not None:
            raise TypeError("Constraints cannot be combined with bound=...")
        if len(constraints) == 1:
            raise TypeError("A single constraint is not allowed")
        self.__name__ = name
        self.__constraints__ = tuple([_convert(c, "TypeVar(name, constraint, ...): constraints must be types.") for c in constraints])
        self.__bound__ = None if bound is None else _convert(bound, "Bound must be a type.")
        self.__covariant__ = bool(covariant)
        self.__contravariant__ = bool(contravariant)

    def __repr__(self):
        return ("+" if self.__covariant__ else "-" if self.__contravariant__ else "~") + self.__name__


class Generic:
    __slots__ = ()
    _is_bare = True
    __parameters__ = ()

    def __class_getitem__(cls, items):
        items = items if isinstance(items, tuple) else (items,)
        if _is_bare(cls):
            name = cls.__name__
            if not items:
                raise TypeError(f"Parameter list to {name}[...] cannot be empty")
            if not all(isinstance(i, _TypeParameter) or getattr(i, "__origin__", 0) is _form("Unpack") for i in items):
                raise TypeError(f"Parameters to {name}[...] must all be type variables or parameter specification variables.")
            if len(set(items)) != len(items):
                raise TypeError(f"Parameters to {name}[...] must all be unique")
            return _GenericAlias(cls, items)
        args = tuple([_convert(item) if not isinstance(item, list) else tuple(item) for item in items])
        parameters = cls.__parameters__
        if not parameters:
            raise TypeError(f"{cls} is not a generic class")
        if not any([p._variadic for p in parameters]):
            _check_count(cls, len(args), len(parameters))
        return _GenericAlias(cls, args)

    def __init_subclass__(cls, *args, **kwargs):
        super().__init_subclass__(*args, **kwargs)
        bases = cls.__dict__.get("__orig_bases__", cls.__bases__)
        if cls.__name__ != "Protocol" and Generic in bases:
            raise TypeError("Cannot inherit from plain Generic")
        aliases = [b for b in bases if isinstance(b, (_GenericAlias, _Builtin)) or hasattr(b, "__args__")]
        parameters = _collect_parameters(aliases)
        declared = [b for b in aliases if b.__origin__ is Generic]
        if len(declared) > 1:
            raise TypeError("Cannot inherit from Generic[...] multiple types.")
        if declared:
            missing = [p for p in parameters if p not in declared[0].__parameters__]
            if missing:
                raise TypeError(
                    f"Some type variables ({', '.join([str(p) for p in missing])}) are not listed in "
                    f"Generic[{', '.join([str(p) for p in declared[0].__parameters__])}]"
                )
            parameters = declared[0].__parameters__
        cls.__parameters__ = tuple(parameters)


class _AnyMeta(type):
    def __instancecheck__(cls, instance):
        if cls is Any:
            raise TypeError("typing.Any cannot be used with isinstance()")
        return super().__instancecheck__(instance)

    def __repr__(cls):
        return "typing.Any" if cls is Any else super().__repr__()


class Any(metaclass=_AnyMeta):
    def __new__(cls, *args, **kwargs):
        if cls is Any:
            raise TypeError("Any cannot be instantiated")
        return super().__new__(cls)


_BARE_FORMS = ("NoReturn", "Never", "Self", "LiteralString", "TypeAlias")
_SINGLE_FORMS = ("ClassVar", "Final", "Required", "NotRequired", "TypeGuard", "Unpack")
_ALIASES = {
    "List": (list, 1), "Dict": (dict, 2), "Set": (set, 1), "FrozenSet": (frozenset, 1), "Type": (type, 1),
    "Deque": ("collections.deque", 1), "DefaultDict": ("collections.defaultdict", 2), "OrderedDict": ("collections.OrderedDict", 2),
    "Counter": ("collections.Counter", 1), "ChainMap": ("collections.ChainMap", 2), "AbstractSet": ("abc.Set", 1),
    "Hashable": ("abc.Hashable", 0), "Sized": ("abc.Sized", 0), "ByteString": ("abc.ByteString", 0),
    "Awaitable": ("abc.Awaitable", 1), "Coroutine": ("abc.Coroutine", 3), "AsyncIterable": ("abc.AsyncIterable", 1),
    "AsyncIterator": ("abc.AsyncIterator", 1), "AsyncGenerator": ("abc.AsyncGenerator", 2), "Iterable": ("abc.Iterable", 1),
    "Iterator": ("abc.Iterator", 1), "Reversible": ("abc.Reversible", 1), "Container": ("abc.Container", 1),
    "Collection": ("abc.Collection", 1), "MutableSet": ("abc.MutableSet", 1), "Mapping": ("abc.Mapping", 2),
    "MutableMapping": ("abc.MutableMapping", 2), "Sequence": ("abc.Sequence", 1), "MutableSequence": ("abc.MutableSequence", 1),
    "MappingView": ("abc.MappingView", 1), "KeysView": ("abc.KeysView", 1), "ItemsView": ("abc.ItemsView", 2),
    "ValuesView": ("abc.ValuesView", 1), "Generator": ("abc.Generator", 3), "ContextManager": (object, 1),
    "AsyncContextManager": (object, 1), "Pattern": (object, 1), "Match": (object, 1),
}


def _make(name):
    if name in _ALIASES:
        return _SpecialAlias(name, *_ALIASES[name])
    if name in _BARE_FORMS:
        return _SpecialForm(name)
    if name in _SINGLE_FORMS:
        return _SpecialForm(name, _make_single)
    if name == "Optional":
        return _SpecialForm(name, _make_optional)
    if name == "Concatenate":
        return _SpecialForm(name, _make_concatenate)
    if name == "Tuple":
        return _TupleAlias("Tuple", tuple, -1)
    if name == "Callable":
        return _CallableForm("Callable", "abc.Callable", 2)
    if name == "AnyStr":
        return TypeVar("AnyStr", bytes, str)
    if name in ("IO", "TextIO", "BinaryIO"):
        return type(name, (), {"__class_getitem__": classmethod(lambda cls, item: _GenericAlias(cls, item)), "__module__": "typing"})
    return None


_PROTOCOLS = (
    "Protocol", "runtime_checkable", "SupportsAbs", "SupportsBytes", "SupportsComplex", "SupportsFloat", "SupportsIndex",
    "SupportsInt", "SupportsRound",
)
_RECORDS = ("NamedTuple", "TypedDict", "is_typeddict")
_RARE = ("Annotated", "Literal", "NewType", "ParamSpec", "ParamSpecArgs", "ParamSpecKwargs", "TypeVarTuple")


def _load(name):
    """A name that is defined in another module; most of the rest are helpers."""
    if name in _PROTOCOLS:
        import _typing_protocol as found
    elif name in _RECORDS:
        import _typing_records as found
    elif name in _RARE:
        import _typing_rare as found
    elif name in __all__:
        import _typing_helpers as found
    else:
        return None
    return getattr(found, name)


_made = {}


def _form(name):
    """The form called `name`; each is made once."""
    made = _made.get(name)
    if made is None:
        made = _make(name)
        if made is None:
            made = _load(name)
        if made is None:
            raise AttributeError(f"module 'typing' has no attribute {name!r}")
        _made[name] = made
    return made


__getattr__ = _form
