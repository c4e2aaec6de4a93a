"""typing.Protocol and the protocols of single methods."""

from typing import Generic

_NOT_MEMBERS = frozenset((
    "__abstractmethods__", "__annotations__", "__dict__", "__doc__", "__init__", "__module__", "__new__", "__slots__",
    "__subclasshook__", "__weakref__", "__class_getitem__", "__parameters__", "__orig_bases__", "__orig_class__",
    "__qualname__", "__match_args__", "__static_attributes__", "__init_subclass__", "_is_protocol", "_is_runtime",
    "_is_bare", "__hash__",
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
    _is_bare = True
    __module__ = "typing"
    _is_runtime = False

    def __init_subclass__(cls, *args, **kwargs):
        super().__init_subclass__(*args, **kwargs)
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


SupportsAbs = _supports("SupportsAbs", "__abs__")
SupportsBytes = _supports("SupportsBytes", "__bytes__")
SupportsComplex = _supports("SupportsComplex", "__complex__")
SupportsFloat = _supports("SupportsFloat", "__float__")
SupportsIndex = _supports("SupportsIndex", "__index__")
SupportsInt = _supports("SupportsInt", "__int__")
SupportsRound = _supports("SupportsRound", "__round__")
