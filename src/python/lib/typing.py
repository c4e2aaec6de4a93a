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
    if isinstance(item, type) and (item is Generic or item.__dict__.get("_is_bare_protocol", False)):
        raise TypeError(f"Plain {item!r} is not valid as type argument")
    if type(item) is tuple:
        raise TypeError(f"{what} Got {item!r}.")
    return item


def _collect_parameters(args):
    found = {}
    for item in args:
        if isinstance(item, type):
            continue
        if isinstance(item, (TypeVar, ParamSpec, TypeVarTuple)):
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
    if not any(isinstance(p, TypeVarTuple) for p in parameters):
        _check_count(alias, len(items), len(parameters))
    given = dict(zip(parameters, [_convert(item) for item in items]))
    made = []
    for item in args:
        if isinstance(item, type):
            made.append(item)
        elif isinstance(item, (TypeVar, ParamSpec, TypeVarTuple)):
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
        if self.__origin__ in (Generic, Protocol):
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
        if self.__origin__ is Generic and (Protocol in bases or any(isinstance(b, (_GenericAlias, _SpecialAlias)) for b in later)):
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


class _LiteralAlias(_GenericAlias):
    def __repr__(self):
        return f"typing.Literal[{', '.join([repr(a) for a in self.__args__])}]" if self.__args__ else "typing.Literal[()]"

    def __eq__(self, other):
        if not isinstance(other, _LiteralAlias):
            return NotImplemented
        return {(type(a), a) for a in self.__args__} == {(type(a), a) for a in other.__args__}

    def __hash__(self):
        return hash(frozenset([(type(a), a) for a in self.__args__]))


class _CallableAlias(_GenericAlias):
    def _with(self, args):
        return _CallableAlias(self.__origin__, args, self._name)

    def __repr__(self):
        *parameters, result = self.__args__
        if len(parameters) == 1 and (parameters[0] is ... or isinstance(parameters[0], ParamSpec)):
            return f"typing.Callable[{_type_repr(parameters[0])}, {_type_repr(result)}]"
        return f"typing.Callable[[{', '.join([_type_repr(p) for p in parameters])}], {_type_repr(result)}]"


class _AnnotatedAlias(_GenericAlias):
    def __init__(self, origin, metadata, name=None):
        if isinstance(origin, _AnnotatedAlias):
            metadata = origin.__metadata__ + metadata
            origin = origin.__origin__
        super().__init__(origin, origin)
        self.__metadata__ = metadata

    def _with(self, args):
        return _AnnotatedAlias(args[0], self.__metadata__)

    def __repr__(self):
        return f"typing.Annotated[{_type_repr(self.__origin__)}, {', '.join([repr(m) for m in self.__metadata__])}]"

    def __eq__(self, other):
        if not isinstance(other, _AnnotatedAlias):
            return NotImplemented
        return self.__origin__ == other.__origin__ and self.__metadata__ == other.__metadata__

    def __hash__(self):
        return hash((self.__origin__, self.__metadata__))


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


def _make_literal(form, items):
    unique = []
    for item in items if isinstance(items, tuple) else (items,):
        for value in item.__args__ if isinstance(item, _LiteralAlias) else (item,):
            if not any(type(value) is type(known) and value == known for known in unique):
                unique.append(value)
    return _LiteralAlias(form, tuple(unique), "Literal")


def _make_single(form, item):
    if isinstance(item, tuple):
        raise TypeError(f"{form!r} accepts only single type. Got {item!r}.")
    return _GenericAlias(form, (_convert(item, f"{form!r} accepts only single type."),), form._name)


def _make_concatenate(form, items):
    items = items if isinstance(items, tuple) else (items,)
    return _GenericAlias(form, tuple([_convert(item) for item in items]), form._name)


Union = _SpecialForm("Union", _make_union)


class _TypeParameter(_Typed):
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


class ParamSpec(_TypeParameter):
    def __init__(self, name, *, bound=None, covariant=False, contravariant=False):
        self.__name__ = name
        self.__bound__ = bound
        self.__covariant__ = bool(covariant)
        self.__contravariant__ = bool(contravariant)

    @property
    def args(self):
        return ParamSpecArgs(self)

    @property
    def kwargs(self):
        return ParamSpecKwargs(self)


class ParamSpecArgs:
    _shown = "args"

    def __init__(self, origin):
        self.__origin__ = origin

    def __repr__(self):
        return f"{self.__origin__.__name__}.{self._shown}"

    def __eq__(self, other):
        return type(other) is type(self) and self.__origin__ == other.__origin__

    __hash__ = None


class ParamSpecKwargs(ParamSpecArgs):
    _shown = "kwargs"


class TypeVarTuple(_TypeParameter):
    def __init__(self, name):
        self.__name__ = name

    def __iter__(self):
        yield _GenericAlias(_form("Unpack"), (self,), "Unpack")

    def __repr__(self):
        return self.__name__


class Generic:
    __slots__ = ()
    __parameters__ = ()

    def __class_getitem__(cls, items):
        items = items if isinstance(items, tuple) else (items,)
        if cls is Generic or cls is Protocol:
            name = cls.__name__
            if not items:
                raise TypeError(f"Parameter list to {name}[...] cannot be empty")
            if not all(isinstance(i, (TypeVar, ParamSpec, TypeVarTuple)) or getattr(i, "__origin__", 0) is _form("Unpack") for i in items):
                raise TypeError(f"Parameters to {name}[...] must all be type variables or parameter specification variables.")
            if len(set(items)) != len(items):
                raise TypeError(f"Parameters to {name}[...] must all be unique")
            return _GenericAlias(cls, items)
        args = tuple([_convert(item) if not isinstance(item, list) else tuple(item) for item in items])
        parameters = cls.__parameters__
        if not parameters:
            raise TypeError(f"{cls} is not a generic class")
        if not any(isinstance(p, (ParamSpec, TypeVarTuple)) for p in parameters):
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


_NOT_MEMBERS = frozenset((
    "__abstractmethods__", "__annotations__", "__dict__", "__doc__", "__init__", "__module__", "__new__", "__slots__",
    "__subclasshook__", "__weakref__", "__class_getitem__", "__parameters__", "__orig_bases__", "__orig_class__",
    "__qualname__", "__match_args__", "__static_attributes__", "__init_subclass__", "_is_protocol", "_is_runtime",
    "_is_bare_protocol", "__hash__",
))


def _protocol_members(cls):
    members = set()
    for base in cls.__mro__[:-1]:
        if base is Generic or base is Protocol:
            continue
        for name in [*base.__dict__, *base.__dict__.get("__annotations__", ())]:
            if name not in _NOT_MEMBERS and not name.startswith("_abc_"):
                members.add(name)
    return members


class _ProtocolMeta(type):
    def __instancecheck__(cls, instance):
        if type.__instancecheck__(cls, instance):
            return True
        if not cls._is_own_protocol():
            return False
        cls._require_runtime()
        for name in _protocol_members(cls):
            if not hasattr(instance, name) or getattr(cls, name, None) is not None and getattr(instance, name) is None:
                return False
        return True

    def __subclasscheck__(cls, other):
        if type.__subclasscheck__(cls, other):
            return True
        if not cls._is_own_protocol():
            return False
        cls._require_runtime()
        members = _protocol_members(cls)
        if any(not callable(getattr(cls, name, None)) for name in members):
            raise TypeError("Protocols with non-method members don't support issubclass()")
        if not isinstance(other, type):
            raise TypeError("issubclass() arg 1 must be a class")
        return all(any(name in base.__dict__ and base.__dict__[name] is not None for base in other.__mro__) for name in members)

    def _is_own_protocol(cls):
        return cls.__dict__.get("_is_protocol", False)

    def _require_runtime(cls):
        if not cls.__dict__.get("_is_runtime", False):
            raise TypeError("Instance and class checks can only be used with @runtime_checkable protocols")


def _no_init(self, *args, **kwargs):
    if type(self)._is_protocol:
        raise TypeError("Protocols cannot be instantiated")


class Protocol(Generic, metaclass=_ProtocolMeta):
    __slots__ = ()
    _is_protocol = True
    _is_bare_protocol = True
    _is_runtime = False

    def __init_subclass__(cls, *args, **kwargs):
        super().__init_subclass__(*args, **kwargs)
        cls._is_bare_protocol = False
        if "_is_protocol" not in cls.__dict__:
            cls._is_protocol = any(base is Protocol for base in cls.__bases__)
        if not cls._is_protocol:
            if cls.__init__ is _no_init:
                cls.__init__ = object.__init__
            return
        for base in cls.__bases__:
            structural = base in (object, Generic) or getattr(base, "_is_protocol", False)
            if not structural and base.__module__ not in ("collections.abc", "_collections_abc"):
                raise TypeError(f"Protocols can only inherit from other protocols, got {base!r}")
        if "__init__" not in cls.__dict__:
            cls.__init__ = _no_init

    __init__ = _no_init


def runtime_checkable(cls):
    if not issubclass(cls, Generic) or not getattr(cls, "_is_protocol", False):
        raise TypeError(f"@runtime_checkable can be only applied to protocol classes, got {cls!r}")
    cls._is_runtime = True
    return cls


def _supports(name, method):
    def body(self, *args):
        pass

    body.__name__ = method
    return runtime_checkable(_ProtocolMeta(name, (Protocol,), {method: body, "_is_protocol": True, "__module__": "typing"}))


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


class Annotated:
    __slots__ = ()

    def __new__(cls, *args, **kwargs):
        raise TypeError("Type Annotated cannot be instantiated.")

    def __class_getitem__(cls, items):
        if not isinstance(items, tuple) or len(items) < 2:
            raise TypeError("Annotated[...] should be used with at least two arguments (a type and an annotation).")
        return _AnnotatedAlias(_convert(items[0], "Annotated[t, ...]: t must be a type."), items[1:])

    def __init_subclass__(cls, *args, **kwargs):
        raise TypeError(f"Cannot subclass {cls.__module__}.Annotated")


class NewType:
    def __init__(self, name, tp):
        self.__qualname__ = name
        self.__name__ = name.rpartition(".")[2]
        self.__supertype__ = tp
        self.__module__ = "__main__"

    def __call__(self, x, /):
        return x

    def __repr__(self):
        return f"{self.__module__}.{self.__qualname__}"

    def __mro_entries__(self, bases):
        known = self.__name__

        class Refused:
            def __init_subclass__(cls):
                name = cls.__name__
                raise TypeError(f"Cannot subclass an instance of NewType. Perhaps you were looking for: `{name} = NewType({name!r}, {known})`")

        return (Refused,)

    def __or__(self, other):
        return Union[self, other]

    def __ror__(self, other):
        return Union[other, self]


class _NamedTupleMeta(type):
    def __new__(mcls, name, bases, namespace):
        from collections import namedtuple

        for base in bases:
            if base is not _NamedTuple and base is not Generic:
                raise TypeError("can only inherit from a NamedTuple type and Generic")
        types = {key: _convert(value) for key, value in namespace.get("__annotations__", {}).items()}
        defaults = []
        for field in types:
            if field in namespace:
                defaults.append(field)
            elif defaults:
                plural = "s" if len(defaults) > 1 else ""
                raise TypeError(f"Non-default namedtuple field {field} cannot follow default field{plural} {', '.join(defaults)}")
        made = namedtuple(name, list(types), defaults=[namespace[n] for n in defaults], module=namespace.get("__module__"))
        made.__annotations__ = made.__new__.__annotations__ = types
        if Generic in bases:
            made = type(name, (made, Generic), {"__slots__": ()})
        for key, value in namespace.items():
            if key in _PROHIBITED:
                raise AttributeError(f"Cannot overwrite NamedTuple attribute {key}")
            if key not in ("__module__", "__name__", "__annotations__", "__orig_bases__", "__classcell__") and key not in made._fields:
                setattr(made, key, value)
        return made


_PROHIBITED = frozenset((
    "__new__", "__init__", "__slots__", "__getnewargs__", "_fields", "_field_defaults", "_field_types", "_make", "_replace", "_asdict", "_source",
))


class _BaseMaker:
    """A callable that also stands as a base class: `NamedTuple`, `TypedDict`."""

    def __init__(self, name, make, entries):
        self.__name__ = self.__qualname__ = name
        self._make = make
        self._entries = entries

    def __call__(self, *args, **kwargs):
        return self._make(*args, **kwargs)

    def __mro_entries__(self, bases):
        return self._entries(bases)

    def __repr__(self):
        return f"<function {self.__name__}>"


def _namedtuple(typename, fields=None, /, **kwargs):
    from collections import namedtuple

    if fields is None:
        fields = kwargs.items()
    elif kwargs:
        raise TypeError("Either list of fields or keywords can be provided to NamedTuple, not both")
    types = {name: _convert(value) for name, value in fields}
    made = namedtuple(typename, list(types), module="__main__")
    made.__annotations__ = made.__new__.__annotations__ = types
    return made


def _namedtuple_entries(bases):
    return (_NamedTuple,)


def _new_named_tuple_base():
    return type.__new__(_NamedTupleMeta, "NamedTuple", (), {"__module__": "typing"})


_NamedTuple = _new_named_tuple_base()


class _TypedDictMeta(type):
    def __new__(mcls, name, bases, namespace, total=True):
        for base in bases:
            if type(base) is not _TypedDictMeta and base is not Generic:
                raise TypeError("cannot inherit from both a TypedDict type and a non-TypedDict base class")
        annotations, required, optional = {}, set(), set()
        for base in bases:
            annotations.update(base.__dict__.get("__annotations__", {}))
            required |= base.__dict__.get("__required_keys__", frozenset())
            optional |= base.__dict__.get("__optional_keys__", frozenset())
        for key, value in namespace.get("__annotations__", {}).items():
            value = annotations[key] = _convert(value, "TypedDict('Name', {f0: t0, f1: t1, ...}); each t must be a type")
            origin = getattr(value, "__origin__", None)
            keep = True if origin is _form("Required") else False if origin is _form("NotRequired") else total
            (required if keep else optional).add(key)
        body = {key: value for key, value in namespace.items() if key != "__annotations__"}
        made = type.__new__(mcls, name, (Generic, dict) if Generic in bases else (dict,), body)
        made.__annotations__ = annotations
        made.__required_keys__ = frozenset(required)
        made.__optional_keys__ = frozenset(optional)
        made.__total__ = total
        return made

    def __init__(cls, name, bases, namespace, total=True):
        pass

    def __call__(cls, *args, **kwargs):
        return dict(*args, **kwargs)

    def __instancecheck__(cls, instance):
        raise TypeError("TypedDict does not support instance and class checks")

    __subclasscheck__ = __instancecheck__


def _typed_dict(typename, fields=None, /, *, total=True, **kwargs):
    if fields is None:
        fields = kwargs
    elif kwargs:
        raise TypeError("TypedDict takes either a dict or keyword arguments, but not both")
    return _TypedDictMeta(typename, (), {"__annotations__": dict(fields), "__module__": "__main__"}, total=total)


def _typed_dict_entries(bases):
    return (_TypedDict,)


_TypedDict = type.__new__(_TypedDictMeta, "TypedDict", (), {"__module__": "typing"})
NamedTuple = _BaseMaker("NamedTuple", _namedtuple, _namedtuple_entries)
TypedDict = _BaseMaker("TypedDict", _typed_dict, _typed_dict_entries)


def is_typeddict(tp):
    return isinstance(tp, _TypedDictMeta)


def cast(typ, val):
    return val


def assert_type(val, typ, /):
    return val


def assert_never(arg, /):
    value = repr(arg)
    if len(value) > 100:
        value = value[:100] + "..."
    raise AssertionError(f"Expected code to be unreachable, but got: {value}")


def reveal_type(obj, /):
    return obj


def final(f):
    try:
        f.__final__ = True
    except (AttributeError, TypeError):
        pass
    return f


def no_type_check(arg):
    try:
        arg.__no_type_check__ = True
    except TypeError:
        pass
    return arg


def no_type_check_decorator(decorator):
    def wrapped(*args, **kwargs):
        return no_type_check(decorator(*args, **kwargs))

    return wrapped


def dataclass_transform(**kwargs):
    def decorator(cls_or_fn):
        cls_or_fn.__dataclass_transform__ = kwargs
        return cls_or_fn

    return decorator


_overloads = {}


def _overload_dummy(*args, **kwds):
    raise NotImplementedError(
        "You should not call an overloaded function. A series of @overload-decorated functions outside a stub module "
        "should always be followed by an implementation that is not @overload-ed."
    )


def overload(func):
    key = (getattr(func, "__module__", None), getattr(func, "__qualname__", None))
    _overloads.setdefault(key, []).append(func)
    return _overload_dummy


def get_overloads(func):
    return list(_overloads.get((func.__module__, func.__qualname__), ()))


def clear_overloads():
    _overloads.clear()


def get_origin(tp):
    if isinstance(tp, _AnnotatedAlias):
        return Annotated
    if tp is Generic:
        return Generic
    if isinstance(tp, _SpecialForm) or isinstance(tp, type) and not hasattr(tp, "__args__"):
        return None
    if type(tp) is type(int | None):
        return type(tp)
    return getattr(tp, "__origin__", None)


def get_args(tp):
    if isinstance(tp, _AnnotatedAlias):
        return (tp.__origin__,) + tp.__metadata__
    if isinstance(tp, type) and not hasattr(tp, "__origin__"):
        return ()
    args = getattr(tp, "__args__", ())
    name = getattr(tp.__origin__, "__name__", "") if hasattr(tp, "__origin__") else ""
    if name == "Callable" and args and not (len(args) == 2 and (args[0] is ... or isinstance(args[0], ParamSpec))):
        return (list(args[:-1]), args[-1])
    return args


_BUILTINS = {t.__name__: t for t in (int, float, str, bool, complex, bytes, list, dict, set, frozenset, tuple, object, type, range)}
_BUILTINS["None"] = None


def _resolve(hint, scope):
    """A hint with its forward references looked up; only dotted names can be."""
    if hint is None:
        return _NoneType
    if isinstance(hint, ForwardRef):
        hint = hint.__forward_arg__
    if isinstance(hint, str):
        head, *rest = hint.strip().split(".")
        if head in scope:
            value = scope[head]
        elif head in _BUILTINS:
            value = _BUILTINS[head]
        else:
            raise NameError(f"name {head!r} is not defined")
        for name in rest:
            value = getattr(value, name)
        return _resolve(value, scope)
    if isinstance(hint, _AnnotatedAlias):
        return _AnnotatedAlias(_resolve(hint.__origin__, scope), hint.__metadata__)
    if isinstance(hint, _GenericAlias) and not isinstance(hint, _LiteralAlias):
        args = tuple([_resolve(a, scope) for a in hint.__args__])
        return hint if args == hint.__args__ else hint._with(args)
    return hint


def _without_extras(hint):
    if isinstance(hint, _AnnotatedAlias):
        return _without_extras(hint.__origin__)
    if isinstance(hint, _GenericAlias):
        if isinstance(hint.__origin__, _SpecialForm) and hint.__origin__._name in ("Required", "NotRequired"):
            return _without_extras(hint.__args__[0])
        args = tuple([_without_extras(a) for a in hint.__args__])
        return hint if args == hint.__args__ else hint._with(args)
    return hint


def get_type_hints(obj, globalns=None, localns=None, include_extras=False):
    if getattr(obj, "__no_type_check__", None):
        return {}
    scope = {}
    hints = {}
    if isinstance(obj, type):
        for base in reversed(obj.__mro__):
            scope[base.__name__] = base
            for name, value in base.__dict__.items():
                if type(value) is type(get_type_hints):
                    scope.update(getattr(value, "__globals__", {}))
            hints.update(base.__dict__.get("__annotations__", {}))
    else:
        found = getattr(obj, "__annotations__", None)
        if found is None:
            raise TypeError(f"{obj!r} is not a module, class, method, or function.")
        scope.update(getattr(obj, "__globals__", {}))
        hints.update(found)
    scope.update(globalns or {})
    scope.update(localns or {})
    resolved = {name: _resolve(value, scope) for name, value in hints.items()}
    return resolved if include_extras else {name: _without_extras(value) for name, value in resolved.items()}


_BARE_FORMS = ("NoReturn", "Never", "Self", "LiteralString", "TypeAlias")
_SINGLE_FORMS = ("ClassVar", "Final", "Required", "NotRequired", "TypeGuard", "Unpack")
_SUPPORTS = {
    "SupportsAbs": "__abs__", "SupportsBytes": "__bytes__", "SupportsComplex": "__complex__", "SupportsFloat": "__float__",
    "SupportsIndex": "__index__", "SupportsInt": "__int__", "SupportsRound": "__round__",
}
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
    if name in _SUPPORTS:
        return _supports(name, _SUPPORTS[name])
    if name == "Optional":
        return _SpecialForm(name, _make_optional)
    if name == "Literal":
        return _SpecialForm(name, _make_literal)
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


def _form(name):
    return globals().get(name) or __getattr__(name)


def __getattr__(name):
    made = _make(name)
    if made is None:
        raise AttributeError(f"module 'typing' has no attribute {name!r}")
    globals()[name] = made
    return made
