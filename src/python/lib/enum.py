"""Enumerations, as CPython 3.11 has them. Flags' boundaries and the checks of `verify` wait in `_enum_checks`."""

from _types import mappingproxy as _mappingproxy

__all__ = [
    "EnumType", "EnumMeta", "Enum", "IntEnum", "StrEnum", "Flag", "IntFlag", "ReprEnum", "auto", "unique", "property",
    "verify", "member", "nonmember", "FlagBoundary", "STRICT", "CONFORM", "EJECT", "KEEP", "global_flag_repr",
    "global_enum_repr", "global_str", "global_enum", "EnumCheck", "CONTINUOUS", "NAMED_FLAGS", "UNIQUE",
    "pickle_by_global_name", "pickle_by_enum_name",
]

_builtin_property = property
_SUNDER = frozenset((
    "_order_", "_generate_next_value_", "_numeric_repr_", "_missing_", "_ignore_", "_iter_member_", "_iter_member_by_value_",
    "_iter_member_by_def_",
))
_DATA_TYPES = (int, str, float, bytes, tuple, complex, frozenset, list, dict, set)
_UNSET = object()
Enum = Flag = ReprEnum = None


def __getattr__(name):
    if name not in __all__:
        raise AttributeError(f"module 'enum' has no attribute {name!r}")
    import _enum_checks

    return getattr(_enum_checks, name)


class nonmember:
    def __init__(self, value):
        self.value = value


class member:
    def __init__(self, value):
        self.value = value


class auto:
    def __init__(self, value=_UNSET):
        self.value = value

    def __repr__(self):
        return f"auto({'_auto_null' if self.value is _UNSET else repr(self.value)})"


class property:
    """Like the builtin, but members of the same name stay reachable through the class."""

    member = None

    def __init__(self, fget=None, fset=None, fdel=None, doc=None):
        self.fget = fget
        self.fset = fset
        self.fdel = fdel
        self.__doc__ = doc if doc is not None else getattr(fget, "__doc__", None)

    def __set_name__(self, owner, name):
        self.name = name
        self.clsname = owner.__name__

    def __get__(self, instance, owner=None):
        if instance is None:
            if self.member is not None:
                return self.member
            try:
                return owner._member_map_[self.name]
            except KeyError:
                raise AttributeError(f"{owner!r} has no attribute {self.name!r}") from None
        if self.fget is None:
            return self.member
        return self.fget(instance)

    def __set__(self, instance, value):
        if self.fset is None:
            raise AttributeError(f"<enum {self.clsname!r}> cannot set attribute {self.name!r}")
        return self.fset(instance, value)

    def __delete__(self, instance):
        if self.fdel is None:
            raise AttributeError(f"<enum {self.clsname!r}> cannot delete attribute {self.name!r}")
        return self.fdel(instance)

    def getter(self, fget):
        return type(self)(fget, self.fset, self.fdel, self.__doc__)

    def setter(self, fset):
        return type(self)(self.fget, fset, self.fdel, self.__doc__)

    def deleter(self, fdel):
        return type(self)(self.fget, self.fset, fdel, self.__doc__)


class _Name(_builtin_property):
    def __set__(self, instance, value):
        raise AttributeError("<enum 'Enum'> cannot set attribute 'name'")


class _Value(_builtin_property):
    def __set__(self, instance, value):
        raise AttributeError("<enum 'Enum'> cannot set attribute 'value'")


def _is_descriptor(obj):
    kind = type(obj)
    return hasattr(kind, "__get__") or hasattr(kind, "__set__") or hasattr(kind, "__delete__")


class EnumDict(dict):
    """The namespace of an enumeration's body: tells members from everything else as they are assigned."""

    def __init__(self):
        super().__init__()
        self._member_names = {}
        self._last_values = []
        self._ignore = []
        self._auto_called = False
        self._cls_name = None
        self._generate_next_value = None

    def __setitem__(self, key, value):
        if key.startswith("__") and key.endswith("__") and len(key) > 4:
            if key == "__order__":
                key = "_order_"
        elif key.startswith(f"_{self._cls_name}__"):
            pass
        elif len(key) > 2 and key[0] == key[-1] == "_" and key[1] != "_":
            value = self._reserved(key, value)
        elif key in self._member_names:
            raise TypeError(f"{key!r} already defined as {self[key]!r}")
        elif key in self._ignore or isinstance(value, nonmember):
            value = value.value if isinstance(value, nonmember) else value
        elif not _is_descriptor(value):
            value = self._new_member(key, value)
        super().__setitem__(key, value)

    def _reserved(self, key, value):
        if key not in _SUNDER:
            raise ValueError(f"_sunder_ names, such as {key!r}, are reserved for future Enum use")
        if key == "_generate_next_value_":
            if self._auto_called:
                raise TypeError("_generate_next_value_ must be defined before members")
            self._generate_next_value = value.__func__ if isinstance(value, staticmethod) else value
        elif key == "_ignore_":
            value = value.replace(",", " ").split() if isinstance(value, str) else list(value)
            self._ignore = value
            already = set(value) & set(self._member_names)
            if already:
                raise ValueError(f"_ignore_ cannot specify already set names: {already!r}")
        return value

    def _new_member(self, key, value):
        if key in self:
            raise TypeError(f"{key!r} already defined as {self[key]!r}")
        if isinstance(value, member):
            value = value.value
        if isinstance(value, auto):
            value = self._next(key, value)
        elif type(value) is tuple and any(isinstance(v, auto) for v in value):
            value = tuple([self._next(key, v) if isinstance(v, auto) else v for v in value])
        else:
            self._last_values.append(value)
        self._member_names[key] = None
        return value

    def _next(self, key, value):
        if value.value is _UNSET:
            value.value = self._generate_next_value(key, 1, len(self._member_names), self._last_values[:])
            self._auto_called = True
        self._last_values.append(value.value)
        return value.value

    def update(self, members=(), /, **more):
        for key, value in dict(members, **more).items():
            self[key] = value


class _Pending:
    """A member that waits for its class: `__set_name__` puts the real one in its place."""

    def __init__(self, value):
        self.value = value

    def __set_name__(self, cls, name):
        value = self.value
        args = value if isinstance(value, tuple) else (value,)
        if cls._member_type_ is tuple:
            args = (args,)
        made = cls._new_member_(cls, *args) if cls._use_args_ else cls._new_member_(cls)
        if not hasattr(made, "_value_"):
            if cls._member_type_ is object:
                made._value_ = value
            else:
                try:
                    made._value_ = cls._member_type_(*args)
                except Exception as error:
                    raise TypeError("_value_ not set in __new__, unable to create it") from error
        made._name_ = name
        made.__objclass__ = cls
        made.__init__(*args)
        made._sort_order_ = len(cls._member_names_)
        _enrol(cls, name, made, made._value_)


def _enrol(cls, name, made, value):
    """Adds a new member to its class, or finds the one whose alias it is."""
    known = _by_value(cls, value)
    is_flag = Flag is not None and issubclass(cls, Flag)
    if known is not None:
        made = known
    else:
        if not is_flag or isinstance(value, int) and value > 0 and value & (value - 1) == 0:
            cls._member_names_.append(name)
        if is_flag and isinstance(value, int):
            cls._flag_mask_ |= value
            if value > 0 and value & (value - 1) == 0:
                cls._singles_mask_ |= value
            cls._all_bits_ = 2 ** cls._flag_mask_.bit_length() - 1
    hidden = next((base.__dict__[name] for base in cls.__mro__[1:] if name in base.__dict__), None)
    if hidden is not None and hasattr(type(hidden), "__get__"):
        redirect = property(getattr(hidden, "fget", None))
        redirect.member = made
        redirect.__set_name__(cls, name)
        type.__setattr__(cls, name, redirect)
    else:
        type.__setattr__(cls, name, made)
    cls._member_map_[name] = made
    try:
        cls._value2member_map_.setdefault(value, made)
    except TypeError:
        pass


def _by_value(cls, value):
    try:
        return cls._value2member_map_.get(value)
    except TypeError:
        return next((m for m in cls._member_map_.values() if m._value_ == value), None)


def _mixins(name, bases):
    """The data type that members carry and the enumeration that the class derives from."""
    if not bases:
        return object, Enum
    for chain in bases:
        for base in chain.__mro__:
            if isinstance(base, EnumType) and base._member_names_:
                raise TypeError(f"<enum {name!r}> cannot extend {base!r}")
    if not isinstance(bases[-1], EnumType):
        raise TypeError("new enumerations should be created as `EnumName([mixin_type, ...] [data_type,] enum_type)`")
    found = []
    for chain in bases:
        candidate = None
        for base in chain.__mro__:
            if base is object:
                continue
            if isinstance(base, EnumType):
                if base._member_type_ is not object:
                    found.append(base._member_type_)
                    break
            elif base in _DATA_TYPES or "__new__" in base.__dict__ or "__dataclass_fields__" in base.__dict__:
                found.append(candidate or base)
                break
            else:
                candidate = candidate or base
    if len(set(found)) > 1:
        raise TypeError(f"too many data types for {name!r}: {set(found)!r}")
    return found[0] if found else object, bases[-1]


def _data_repr(bases):
    for chain in bases:
        for base in chain.__mro__:
            if isinstance(base, EnumType):
                return base._value_repr_
            if base is not object and base not in _DATA_TYPES and "__repr__" in base.__dict__:
                return base.__dict__["__repr__"]
    return None


def _find_new(namespace, member_type, first_enum):
    """What makes a member, and whether it takes the value as arguments."""
    new = namespace.get("__new__")
    if new is not None:
        return getattr(new, "__func__", new), first_enum is not None, True
    for possible in (member_type, first_enum):
        target = getattr(possible, "__new_member__", None)
        if target is not None:
            return target, False, True
    if any(base in _DATA_TYPES or "__new__" in base.__dict__ for base in member_type.__mro__ if base is not object):
        return member_type.__new__, False, True
    return object.__new__, False, False


class EnumType(type):
    @classmethod
    def __prepare__(metacls, name, bases, **kwds):
        namespace = EnumDict()
        namespace._cls_name = name
        _, first_enum = _mixins(name, bases)
        if first_enum is not None:
            namespace._generate_next_value = first_enum._generate_next_value_
        return namespace

    def __new__(metacls, name, bases, namespace, *, boundary=None, _simple=False, **kwds):
        ignored = namespace.get("_ignore_", [])
        members = {key: namespace[key] for key in namespace._member_names if key not in ignored}
        if "mro" in members or "" in members:
            raise ValueError(f"invalid enum member name(s) {'mro' if 'mro' in members else ''!r}")
        member_type, first_enum = _mixins(name, bases) if Enum is not None else (object, None)
        new, save_new, use_args = _find_new(namespace, member_type, first_enum) if Enum is not None else (object.__new__, False, False)
        order = namespace.get("_order_")
        body = {key: value for key, value in namespace.items() if key not in ignored and key not in ("_ignore_", "_order_")}
        if isinstance(body.get("_generate_next_value_"), type(_find_new)):
            body["_generate_next_value_"] = staticmethod(body["_generate_next_value_"])
        for key, value in members.items():
            body[key] = _Pending(value)
        body["_new_member_"] = staticmethod(new) if isinstance(new, type(_find_new)) else new
        body["_use_args_"] = use_args
        body["_member_names_"] = []
        body["_member_map_"] = {}
        body["_value2member_map_"] = {}
        body["_member_type_"] = member_type
        body["_value_repr_"] = _data_repr(bases)
        body["_boundary_"] = boundary or getattr(first_enum, "_boundary_", None)
        body["_flag_mask_"] = body["_all_bits_"] = body["_singles_mask_"] = 0
        body["_inverted_"] = None
        try:
            cls = super().__new__(metacls, name, bases, body, **kwds)
        except RuntimeError as error:
            raise error.__cause__ or error
        if Enum is not None:
            _finish(cls, body, bases, member_type, first_enum, new if save_new else None)
        if order is not None:
            _check_order(cls, order)
        return cls

    def __init__(cls, name, bases, namespace, **kwds):
        pass

    def __bool__(cls):
        return True

    def __call__(cls, value, names=None, *, module=None, qualname=None, type=None, start=1, boundary=None):
        if names is None:
            return cls.__new__(cls, value)
        return _create(cls, value, names, module, qualname, type, start, boundary)

    def __contains__(cls, item):
        if not isinstance(item, Enum):
            raise TypeError(
                f"unsupported operand type(s) for 'in': {type(item).__qualname__!r} and {cls.__class__.__qualname__!r}"
            )
        return isinstance(item, cls) and item._name_ in cls._member_map_

    def __delattr__(cls, name):
        if name in cls._member_map_:
            raise AttributeError(f"{cls.__name__!r} cannot delete member {name!r}.")
        super().__delattr__(name)

    def __setattr__(cls, name, value):
        if name in cls.__dict__.get("_member_map_", ()):
            raise AttributeError(f"cannot reassign member {name!r}")
        super().__setattr__(name, value)

    def __dir__(cls):
        names = {
            "__class__", "__contains__", "__doc__", "__getitem__", "__init_subclass__", "__iter__", "__len__", "__members__",
            "__module__", "__name__", "__qualname__", *cls._member_names_,
        }
        if cls._new_member_ is not object.__new__:
            names.add("__new__")
        return sorted(names if cls._member_type_ is object else names | set(dir(cls._member_type_)))

    def __getattr__(cls, name):
        raise AttributeError(name) from None

    def __getitem__(cls, name):
        return cls._member_map_[name]

    def __iter__(cls):
        return iter([cls._member_map_[name] for name in cls._member_names_])

    def __reversed__(cls):
        return iter([cls._member_map_[name] for name in reversed(cls._member_names_)])

    def __len__(cls):
        return len(cls._member_names_)

    @_builtin_property
    def __members__(cls):
        return _mappingproxy(cls._member_map_)

    def __repr__(cls):
        kind = "flag" if Flag is not None and issubclass(cls, Flag) else "enum"
        return f"<{kind} {cls.__name__!r}>"


EnumMeta = EnumType


def _set_unless(cls, body, name, value):
    if name not in body:
        type.__setattr__(cls, name, value)
        body[name] = value


def _finish(cls, body, bases, member_type, first_enum, own_new):
    """Gives the class the methods that a mixed-in type hides."""
    if ReprEnum is not None and ReprEnum in bases:
        if member_type is object:
            raise TypeError("ReprEnum subclasses must be mixed with a data type (i.e. int, str, float, etc.)")
        _set_unless(cls, body, "__format__", member_type.__format__)
        shown = member_type.__str__
        _set_unless(cls, body, "__str__", member_type.__repr__ if shown is object.__str__ else shown)
    for name in ("__repr__", "__str__", "__format__"):
        if name not in body and getattr(cls, name) in (getattr(member_type, name), getattr(object, name)):
            type.__setattr__(cls, name, getattr(first_enum, name))
    if Flag is not None and issubclass(cls, Flag):
        for name in ("__or__", "__and__", "__xor__", "__ror__", "__rand__", "__rxor__", "__invert__"):
            _set_unless(cls, body, name, getattr(Flag, name))
        values = [m._value_ for m in cls]
        if values != sorted(values):
            type.__setattr__(cls, "_iter_member_", cls._iter_member_by_def_)
    if own_new is not None:
        type.__setattr__(cls, "__new_member__", own_new)
    type.__setattr__(cls, "__new__", Enum.__new__)


def _check_order(cls, order):
    if isinstance(order, str):
        order = order.replace(",", " ").split()
    if issubclass(cls, Flag):
        order = [name for name in order if name in cls._member_names_]
    else:
        order = [name for name in order if name not in cls._member_map_ or name in cls._member_names_]
    if order != cls._member_names_:
        raise TypeError(f"member order does not match _order_:\n  {cls._member_names_!r}\n  {order!r}")


def _create(cls, class_name, names, module, qualname, mixin, start, boundary):
    """The functional form: `Enum("Color", "RED GREEN")`."""
    metacls = cls.__class__
    bases = (cls,) if mixin is None else (mixin, cls)
    namespace = metacls.__prepare__(class_name, bases)
    if isinstance(names, str):
        names = names.replace(",", " ").split()
    if isinstance(names, (tuple, list)) and names and isinstance(names[0], str):
        values = []
        pairs = []
        for count, name in enumerate(names):
            value = first_value = cls._generate_next_value_(name, start, count, values[:])
            values.append(first_value)
            pairs.append((name, value))
        names = pairs
    for item in names:
        name, value = (item, names[item]) if isinstance(item, str) else item
        namespace[name] = value
    namespace["__module__"] = "__main__" if module is None else module
    if qualname is not None:
        namespace["__qualname__"] = qualname
    return metacls.__new__(metacls, class_name, bases, namespace, boundary=boundary)


class Enum(metaclass=EnumType):
    def __new__(cls, value):
        if type(value) is cls:
            return value
        try:
            return cls._value2member_map_[value]
        except KeyError:
            pass
        except TypeError:
            for known in cls._member_map_.values():
                if known._value_ == value:
                    return known
        return _looked_for(cls, value)

    def __init__(self, *args, **kwds):
        pass

    def _generate_next_value_(name, start, count, last_values):
        if not last_values:
            return start
        try:
            last_values.sort()
        except TypeError:
            pass
        for value in reversed(last_values):
            try:
                return value + 1
            except TypeError:
                pass
        return start

    @classmethod
    def _missing_(cls, value):
        return None

    def __repr__(self):
        cls = self.__class__
        shown = cls._value_repr_ or repr
        return f"<{cls.__name__}.{self._name_}: {shown(self._value_)}>"

    def __str__(self):
        return f"{self.__class__.__name__}.{self._name_}"

    def __dir__(self):
        if self.__class__._member_type_ is object:
            names = {"__class__", "__doc__", "__eq__", "__hash__", "__module__", "name", "value"}
        else:
            names = set(object.__dir__(self))
        names.update([name for name in getattr(self, "__dict__", ()) if name[0] != "_"])
        for cls in self.__class__.__mro__:
            names.update([name for name in cls.__dict__ if name[0] != "_" and name not in self._member_map_])
        return sorted(names)

    def __format__(self, format_spec):
        return str(self).__format__(format_spec)

    def __hash__(self):
        return hash(self._name_)

    def __reduce_ex__(self, proto):
        return self.__class__, (self._value_,)

    def __copy__(self):
        return self

    def __deepcopy__(self, memo):
        return self

    name = _Name(lambda self: self._name_)
    value = _Value(lambda self: self._value_)


def _looked_for(cls, value):
    """Asks `_missing_` for a value that no member has."""
    if not cls._member_map_:
        raise TypeError(f"{cls!r} has no members defined")
    error = result = None
    try:
        result = cls._missing_(value)
    except Exception as raised:
        error = raised
    if isinstance(result, cls):
        return result
    if Flag is not None and issubclass(cls, Flag) and cls._boundary_ == "eject" and isinstance(result, int):
        return result
    invalid = ValueError(f"{value!r} is not a valid {cls.__qualname__}")
    if error is None and result is None:
        raise invalid
    if error is None:
        error = TypeError(f"error in {cls.__name__}._missing_: returned {result!r} instead of None or a valid member")
    if not isinstance(error, ValueError):
        error.__context__ = invalid
    raise error


class ReprEnum(Enum):
    """An Enum that keeps its mixed-in type's `str()` and `format()`."""


class IntEnum(int, ReprEnum):
    pass


class StrEnum(str, ReprEnum):
    def __new__(cls, *values):
        if len(values) > 3:
            raise TypeError(f"too many arguments for str(): {values!r}")
        if len(values) == 1 and not isinstance(values[0], str):
            raise TypeError(f"{values[0]!r} is not a string")
        for what, given in zip(("encoding", "errors"), values[1:]):
            if not isinstance(given, str):
                raise TypeError(f"{what} must be a string, not {given!r}")
        made = str.__new__(cls, str(*values))
        made._value_ = str(*values)
        return made

    def _generate_next_value_(name, start, count, last_values):
        return name.lower()


class Flag(Enum, boundary="strict"):
    _numeric_repr_ = staticmethod(repr)

    def _generate_next_value_(name, start, count, last_values):
        if not last_values:
            return start if start is not None else 1
        last = max(last_values)
        try:
            return 2 ** last.bit_length()
        except Exception:
            raise TypeError(f"invalid flag value {last!r}") from None

    @classmethod
    def _iter_member_by_value_(cls, value):
        rest = value & cls._flag_mask_
        while rest:
            bit = rest & -rest
            yield cls._value2member_map_[bit]
            rest ^= bit

    _iter_member_ = _iter_member_by_value_

    @classmethod
    def _iter_member_by_def_(cls, value):
        yield from sorted(cls._iter_member_by_value_(value), key=lambda m: m._sort_order_)

    @classmethod
    def _missing_(cls, value):
        from _enum_checks import pseudo_member

        return pseudo_member(cls, value)

    def __contains__(self, other):
        if not isinstance(other, self.__class__):
            raise TypeError(
                f"unsupported operand type(s) for 'in': {type(other).__qualname__!r} and {self.__class__.__qualname__!r}"
            )
        return other._value_ & self._value_ == other._value_

    def __iter__(self):
        yield from self._iter_member_(self._value_)

    def __len__(self):
        return self._value_.bit_count()

    def __repr__(self):
        cls = self.__class__
        shown = (cls._value_repr_ or repr)(self._value_)
        return f"<{cls.__name__}: {shown}>" if self._name_ is None else f"<{cls.__name__}.{self._name_}: {shown}>"

    def __str__(self):
        name = self.__class__.__name__
        return f"{name}({self._value_!r})" if self._name_ is None else f"{name}.{self._name_}"

    def __bool__(self):
        return bool(self._value_)

    def _bits(self, other):
        if isinstance(other, self.__class__):
            return other._value_
        if self._member_type_ is not object and isinstance(other, self._member_type_):
            return other
        return NotImplemented

    def __or__(self, other):
        bits = self._bits(other)
        return bits if bits is NotImplemented else self.__class__(self._value_ | bits)

    def __and__(self, other):
        bits = self._bits(other)
        return bits if bits is NotImplemented else self.__class__(self._value_ & bits)

    def __xor__(self, other):
        bits = self._bits(other)
        return bits if bits is NotImplemented else self.__class__(self._value_ ^ bits)

    def __invert__(self):
        if self._inverted_ is None:
            if self._boundary_ in ("eject", "keep"):
                self._inverted_ = self.__class__(~self._value_)
            else:
                self._inverted_ = self.__class__(self._singles_mask_ & ~self._value_)
        return self._inverted_

    __ror__ = __or__
    __rand__ = __and__
    __rxor__ = __xor__


class IntFlag(int, ReprEnum, Flag, boundary="keep"):
    pass


def unique(enumeration):
    aliases = [(name, m.name) for name, m in enumeration.__members__.items() if name != m.name]
    if aliases:
        shown = ", ".join([f"{alias} -> {name}" for alias, name in aliases])
        raise ValueError(f"duplicate values found in {enumeration!r}: {shown}")
    return enumeration
