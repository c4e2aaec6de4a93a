"""Shallow and deep copies. There is no pickling, so instances are rebuilt from `__dict__` and `__slots__`."""

__all__ = ["Error", "copy", "deepcopy"]


class Error(Exception):
    pass


error = Error

_SHARED = frozenset((
    type(None), bool, int, float, complex, str, bytes, range, type(...), type(NotImplemented), slice, property,
    type, type(len), type(lambda: 0), type([].append), type(int | str),
))
_REFUSED = (type(iter([])), type(x for x in ()), type({}.keys()), type({}.values()), type({}.items()))


def _slots(cls):
    names = []
    for base in cls.__mro__:
        slots = base.__dict__.get("__slots__", ())
        for name in (slots,) if isinstance(slots, str) else slots:
            if name not in ("__dict__", "__weakref__"):
                if name.startswith("__") and not name.endswith("__"):
                    name = f"_{base.__name__.lstrip('_')}{name}"
                names.append(name)
    return names


_DEFAULT_STATE = getattr(object, "__getstate__", None)


def _state(x):
    """The instance's attributes as `__getstate__` gives them: a dict, None where there are none, or that and the slots."""
    own = getattr(type(x), "__getstate__", None)
    if own is not None and own is not _DEFAULT_STATE:
        return x.__getstate__()
    slots = {name: getattr(x, name) for name in _slots(type(x)) if hasattr(x, name)}
    attributes = getattr(x, "__dict__", None) or None
    return (attributes, slots) if slots else attributes


def _restore(y, state):
    if state is None:
        return
    if hasattr(y, "__setstate__"):
        y.__setstate__(state)
        return
    slots = None
    if isinstance(state, tuple) and len(state) == 2:
        state, slots = state
    if state is not None:
        y.__dict__.update(state)
    if slots is not None:
        for name, value in slots.items():
            object.__setattr__(y, name, value)


def _blank(x, cls, convert):
    """A new instance of `cls` with the builtin part of `x`, its items put through `convert`."""
    if hasattr(cls, "__getnewargs__") and not isinstance(x, (str, bytes, int, float, complex)):
        args = x.__getnewargs__()
        return cls.__new__(cls, *[convert(a) for a in args])
    if isinstance(x, tuple):
        return tuple.__new__(cls, [convert(v) for v in x])
    if isinstance(x, frozenset):
        return frozenset.__new__(cls, [convert(v) for v in x])
    for base in (int, float, complex, str, bytes):
        if isinstance(x, base):
            return base.__new__(cls, base(x))
    if isinstance(x, BaseException):
        return cls.__new__(cls, *[convert(a) for a in x.args])
    return cls.__new__(cls)


def _fill(x, y, convert):
    if isinstance(x, list):
        list.extend(y, [convert(v) for v in list.__iter__(x)])
    elif isinstance(x, dict):
        for key, value in dict.items(x):
            y[convert(key)] = convert(value)
    elif isinstance(x, set):
        set.update(y, [convert(v) for v in x])
    elif isinstance(x, bytearray):
        bytearray.extend(y, x)


def _same(value):
    return value


def copy(x):
    cls = type(x)
    if cls in _SHARED or cls is tuple or cls is frozenset or isinstance(x, type):
        return x
    if cls in (list, dict, set, bytearray):
        return x.copy()
    copier = getattr(cls, "__copy__", None)
    if copier is not None:
        return copier(x)
    if cls in _REFUSED:
        raise TypeError(f"cannot pickle {cls.__name__!r} object")
    y = _blank(x, cls, _same)
    _restore(y, _state(x))
    _fill(x, y, _same)
    return y


_ABSENT = object()


def deepcopy(x, memo=None, _nil=None):
    cls = type(x)
    if cls in _SHARED:
        return x
    if memo is None:
        memo = {}
    key = id(x)
    y = memo.get(key, _ABSENT)
    if y is not _ABSENT:
        return y
    if cls is list:
        y = memo[key] = []
        for value in x:
            y.append(deepcopy(value, memo))
    elif cls is dict:
        y = memo[key] = {}
        for name, value in x.items():
            y[deepcopy(name, memo)] = deepcopy(value, memo)
    elif cls is tuple:
        y = _deep_tuple(x, memo, key)
    elif isinstance(x, type):
        return x
    else:
        copier = getattr(x, "__deepcopy__", None)
        y = copier(memo) if copier is not None else _deep_instance(x, cls, memo, key)
    if y is not x:
        memo[key] = y
        memo.setdefault(id(memo), []).append(x)
    return y


def _deep_tuple(x, memo, key):
    items = [deepcopy(value, memo) for value in x]
    if key in memo:
        return memo[key]
    for old, new in zip(x, items):
        if old is not new:
            return tuple(items)
    return x


def _deep_instance(x, cls, memo, key):
    if cls in _REFUSED:
        raise TypeError(f"cannot pickle {cls.__name__!r} object")

    def convert(value):
        return deepcopy(value, memo)

    if cls is type((lambda self: 0).__get__(0)):
        return cls(x.__func__, convert(x.__self__))
    y = _blank(x, cls, convert)
    memo[key] = y
    _restore(y, convert(_state(x)))
    _fill(x, y, convert)
    return y
