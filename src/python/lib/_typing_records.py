"""typing.NamedTuple and typing.TypedDict."""

from typing import Generic, _convert, _form


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
