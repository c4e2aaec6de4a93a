"""The operators as functions (from `_operator`), and callables that look something up."""

from _operator import *

__all__ = [
    "abs", "add", "and_", "attrgetter", "call", "concat", "contains", "countOf", "delitem", "eq", "floordiv", "ge", "getitem",
    "gt", "iadd", "iand", "iconcat", "ifloordiv", "ilshift", "imatmul", "imod", "imul", "index", "indexOf", "inv", "invert",
    "ior", "ipow", "irshift", "is_", "is_not", "isub", "itemgetter", "itruediv", "ixor", "le", "length_hint", "lshift", "lt",
    "matmul", "methodcaller", "mod", "mul", "ne", "neg", "not_", "or_", "pos", "pow", "rshift", "setitem", "sub", "truediv",
    "truth", "xor",
]


def _one(name, args, keywords):
    if keywords:
        raise TypeError(f"{name} takes no keyword arguments")
    if len(args) != 1:
        raise TypeError(f"{name} expected 1 argument, got {len(args)}")
    return args[0]


class itemgetter:
    __slots__ = ("_items",)

    def __init__(self, *items, **keywords):
        if keywords:
            raise TypeError("itemgetter() takes no keyword arguments")
        if not items:
            raise TypeError("itemgetter expected 1 argument, got 0")
        self._items = items

    def __call__(self, *args, **keywords):
        o = _one("itemgetter", args, keywords)
        items = self._items
        if len(items) == 1:
            return o[items[0]]
        return tuple([o[i] for i in items])

    def __repr__(self):
        return f"operator.itemgetter({', '.join(map(repr, self._items))})"


class attrgetter:
    __slots__ = ("_paths",)

    def __init__(self, *names, **keywords):
        if keywords:
            raise TypeError("attrgetter() takes no keyword arguments")
        if not names:
            raise TypeError("attrgetter expected 1 argument, got 0")
        for name in names:
            if not isinstance(name, str):
                raise TypeError("attribute name must be a string")
        self._paths = [name.split(".") for name in names]

    def __call__(self, *args, **keywords):
        o = _one("attrgetter", args, keywords)
        found = []
        for path in self._paths:
            value = o
            for name in path:
                value = getattr(value, name)
            found.append(value)
        return found[0] if len(found) == 1 else tuple(found)

    def __repr__(self):
        return f"operator.attrgetter({', '.join(repr('.'.join(path)) for path in self._paths)})"


class methodcaller:
    __slots__ = ("_name", "_args", "_keywords")

    def __init__(self, *args, **keywords):
        if not args:
            raise TypeError("methodcaller needs at least one argument, the method name")
        name, *args = args
        if not isinstance(name, str):
            raise TypeError("method name must be a string")
        self._name, self._args, self._keywords = name, args, keywords

    def __call__(self, *args, **keywords):
        return getattr(_one("methodcaller", args, keywords), self._name)(*self._args, **self._keywords)

    def __repr__(self):
        shown = [self._name, *self._args]
        texts = [repr(value) for value in shown] + [f"{name}={value!r}" for name, value in self._keywords.items()]
        return f"operator.methodcaller({', '.join(texts)})"


__abs__, __add__, __and__, __call__, __concat__, __contains__, __delitem__ = abs, add, and_, call, concat, contains, delitem
__eq__, __floordiv__, __ge__, __getitem__, __gt__, __iadd__, __iand__ = eq, floordiv, ge, getitem, gt, iadd, iand
__iconcat__, __ifloordiv__, __ilshift__, __imatmul__, __imod__, __imul__ = iconcat, ifloordiv, ilshift, imatmul, imod, imul
__index__, __inv__, __invert__, __ior__, __ipow__, __irshift__, __isub__ = index, inv, invert, ior, ipow, irshift, isub
__itruediv__, __ixor__, __le__, __lshift__, __lt__, __matmul__, __mod__ = itruediv, ixor, le, lshift, lt, matmul, mod
__mul__, __ne__, __neg__, __not__, __or__, __pos__, __pow__ = mul, ne, neg, not_, or_, pos, pow
__rshift__, __setitem__, __sub__, __truediv__, __xor__ = rshift, setitem, sub, truediv, xor
