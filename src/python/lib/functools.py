"""Functions on functions."""

from _types import GenericAlias as _GenericAlias

__all__ = [
    "update_wrapper", "wraps", "WRAPPER_ASSIGNMENTS", "WRAPPER_UPDATES", "total_ordering", "cache", "cmp_to_key",
    "lru_cache", "reduce", "partial", "partialmethod", "singledispatch", "singledispatchmethod", "cached_property",
]

WRAPPER_ASSIGNMENTS = ("__module__", "__name__", "__qualname__", "__doc__", "__annotations__")
WRAPPER_UPDATES = ("__dict__",)
_ABSENT = object()


def update_wrapper(wrapper, wrapped, assigned=WRAPPER_ASSIGNMENTS, updated=WRAPPER_UPDATES):
    for name in assigned:
        try:
            value = getattr(wrapped, name)
        except AttributeError:
            pass
        else:
            setattr(wrapper, name, value)
    for name in updated:
        getattr(wrapper, name).update(getattr(wrapped, name, {}))
    wrapper.__wrapped__ = wrapped
    return wrapper


def wraps(wrapped, assigned=WRAPPER_ASSIGNMENTS, updated=WRAPPER_UPDATES):
    def decorator(wrapper):
        return update_wrapper(wrapper, wrapped, assigned, updated)

    return decorator


def reduce(function, sequence, initial=_ABSENT, /):
    try:
        items = iter(sequence)
    except TypeError:
        raise TypeError("reduce() arg 2 must support iteration") from None
    if initial is _ABSENT:
        try:
            initial = next(items)
        except StopIteration:
            raise TypeError("reduce() of empty iterable with no initial value") from None
    for item in items:
        initial = function(initial, item)
    return initial


class partial:
    __slots__ = ("func", "args", "keywords", "__dict__", "__weakref__")
    __class_getitem__ = classmethod(_GenericAlias)

    def __new__(cls, func=_ABSENT, /, *args, **keywords):
        if func is _ABSENT:
            raise TypeError("type 'partial' takes at least one argument")
        if not callable(func):
            raise TypeError("the first argument must be callable")
        if isinstance(func, partial):
            args = func.args + args
            keywords = {**func.keywords, **keywords}
            func = func.func
        self = super().__new__(cls)
        self.func = func
        self.args = args
        self.keywords = keywords
        return self

    def __call__(self, /, *args, **keywords):
        if keywords or self.keywords:
            return self.func(*self.args, *args, **{**self.keywords, **keywords})
        return self.func(*self.args, *args)

    def __repr__(self):
        shown = [repr(self.func)]
        shown.extend([repr(x) for x in self.args])
        shown.extend([f"{k}={v!r}" for k, v in self.keywords.items()])
        name = type(self).__qualname__
        return f"{'functools.' if type(self) is partial else type(self).__module__ + '.'}{name}({', '.join(shown)})"


class partialmethod:
    __class_getitem__ = classmethod(_GenericAlias)

    def __init__(self, func, /, *args, **keywords):
        if not callable(func) and not hasattr(func, "__get__"):
            raise TypeError(f"{func!r} is not callable or a descriptor")
        if isinstance(func, partialmethod):
            self.func = func.func
            self.args = func.args + args
            self.keywords = {**func.keywords, **keywords}
        else:
            self.func = func
            self.args = args
            self.keywords = keywords

    def __repr__(self):
        shown = [repr(self.func), *[repr(x) for x in self.args], *[f"{k}={v!r}" for k, v in self.keywords.items()]]
        return f"functools.partialmethod({', '.join(shown)})"

    def __get__(self, obj, cls=None):
        getter = getattr(type(self.func), "__get__", None)
        if getter is not None:
            bound = getter(self.func, obj, cls)
            if bound is not self.func:
                return partial(bound, *self.args, **self.keywords)
        function, own, keywords = self.func, self.args, self.keywords

        def method(receiver, /, *args, **more):
            return function(receiver, *own, *args, **{**keywords, **more})

        return method.__get__(obj, cls)


class _Key:
    """A call as a key of a cache: equal where the arguments (and, if typed, their types) are."""


def _key(args, keywords, typed):
    if not keywords and not typed:
        if len(args) == 1 and type(args[0]) in (int, str):
            return args[0]
        return args
    key = args
    if keywords:
        key += (_Key,)
        for item in keywords.items():
            key += item
    if typed:
        key += tuple([type(v) for v in args])
        if keywords:
            key += tuple([type(v) for v in keywords.values()])
    return key


class _CacheInfo(tuple):
    __slots__ = ()
    _fields = ("hits", "misses", "maxsize", "currsize")

    hits = property(lambda self: self[0])
    misses = property(lambda self: self[1])
    maxsize = property(lambda self: self[2])
    currsize = property(lambda self: self[3])

    def __repr__(self):
        return "CacheInfo(hits=%r, misses=%r, maxsize=%r, currsize=%r)" % tuple(self)


_CacheInfo.__name__ = _CacheInfo.__qualname__ = "CacheInfo"


def lru_cache(maxsize=128, typed=False):
    if isinstance(maxsize, int):
        maxsize = max(maxsize, 0)
    elif callable(maxsize) and isinstance(typed, bool):
        return _cached(maxsize, 128, typed)
    elif maxsize is not None:
        raise TypeError("Expected first argument to be an integer, a callable, or None")

    def decorator(function):
        return _cached(function, maxsize, typed)

    return decorator


def cache(user_function, /):
    return _cached(user_function, None, False)


def _cached(function, maxsize, typed):
    if not callable(function):
        raise TypeError("the first argument must be callable")
    known = {}
    hits = misses = 0

    def uncached(*args, **keywords):
        nonlocal misses
        misses += 1
        return function(*args, **keywords)

    def unbounded(*args, **keywords):
        nonlocal hits, misses
        key = _key(args, keywords, typed)
        value = known.get(key, _ABSENT)
        if value is not _ABSENT:
            hits += 1
            return value
        misses += 1
        value = known[key] = function(*args, **keywords)
        return value

    def bounded(*args, **keywords):
        nonlocal hits, misses
        key = _key(args, keywords, typed)
        value = known.pop(key, _ABSENT)
        if value is not _ABSENT:
            hits += 1
            known[key] = value
            return value
        misses += 1
        value = function(*args, **keywords)
        if key not in known:
            if len(known) >= maxsize:
                del known[next(iter(known))]
            known[key] = value
        return value

    wrapper = uncached if maxsize == 0 else unbounded if maxsize is None else bounded

    def cache_info():
        return _CacheInfo((hits, misses, maxsize, len(known)))

    def cache_clear():
        nonlocal hits, misses
        hits = misses = 0
        known.clear()

    wrapper.cache_info = cache_info
    wrapper.cache_clear = cache_clear
    wrapper.cache_parameters = lambda: {"maxsize": maxsize, "typed": typed}
    return update_wrapper(wrapper, function)


class cached_property:
    __class_getitem__ = classmethod(_GenericAlias)

    def __init__(self, func):
        self.func = func
        self.attrname = None
        self.__doc__ = func.__doc__

    def __set_name__(self, owner, name):
        if self.attrname is None:
            self.attrname = name
        elif name != self.attrname:
            raise TypeError(
                f"Cannot assign the same cached_property to two different names ({self.attrname!r} and {name!r})."
            )

    def __get__(self, instance, owner=None):
        if instance is None:
            return self
        name = self.attrname
        if name is None:
            raise TypeError("Cannot use cached_property instance without calling __set_name__ on it.")
        try:
            values = instance.__dict__
        except AttributeError:
            kind = type(instance).__name__
            raise TypeError(f"No '__dict__' attribute on {kind!r} instance to cache {name!r} property.") from None
        value = values.get(name, _ABSENT)
        if value is _ABSENT:
            value = values[name] = self.func(instance)
        return value


def cmp_to_key(mycmp):
    class K:
        __slots__ = ("obj",)
        __hash__ = None

        def __init__(self, obj):
            self.obj = obj

        def _ask(self, other):
            if not isinstance(other, K):
                raise TypeError("other argument must be K instance")
            return mycmp(self.obj, other.obj)

        def __lt__(self, other):
            return self._ask(other) < 0

        def __gt__(self, other):
            return self._ask(other) > 0

        def __eq__(self, other):
            return self._ask(other) == 0

        def __le__(self, other):
            return self._ask(other) <= 0

        def __ge__(self, other):
            return self._ask(other) >= 0

    return K


def _not(result):
    return result if result is NotImplemented else not result


def _or_equal(result, self, other):
    return result if result is NotImplemented else result or self == other


def _and_unequal(result, self, other):
    return result if result is NotImplemented else not result and self != other


def _and_differs(result, self, other):
    return result if result is NotImplemented else result and self != other


def _or_same(result, self, other):
    return result if result is NotImplemented else not result or self == other


def _derived(root):
    """The three comparisons that follow from the one called `root`."""

    def ask(self, other):
        return getattr(type(self), root)(self, other)

    def opposite(self, other):
        return _not(ask(self, other))

    if root in ("__lt__", "__gt__"):
        def mirrored(self, other):
            return _and_unequal(ask(self, other), self, other)

        def weaker(self, other):
            return _or_equal(ask(self, other), self, other)

        names = ("__gt__", "__le__", "__ge__") if root == "__lt__" else ("__lt__", "__ge__", "__le__")
    else:
        def mirrored(self, other):
            return _or_same(ask(self, other), self, other)

        def weaker(self, other):
            return _and_differs(ask(self, other), self, other)

        names = ("__ge__", "__lt__", "__gt__") if root == "__le__" else ("__le__", "__gt__", "__lt__")
    return dict(zip(names, (mirrored, weaker, opposite)))


def total_ordering(cls):
    roots = [op for op in ("__lt__", "__le__", "__gt__", "__ge__") if getattr(cls, op, None) is not getattr(object, op, None)]
    if not roots:
        raise ValueError("must define at least one ordering operation: < > <= >=")
    root = next(op for op in ("__lt__", "__le__", "__gt__", "__ge__") if op in roots)
    for name, method in _derived(root).items():
        if name not in roots:
            method.__name__ = name
            setattr(cls, name, method)
    return cls


def singledispatch(func):
    from _singledispatch import singledispatch

    return singledispatch(func)


class singledispatchmethod:
    def __init__(self, func):
        if not callable(func) and not hasattr(func, "__get__"):
            raise TypeError(f"{func!r} is not callable or a descriptor")
        self.dispatcher = singledispatch(func)
        self.func = func

    def register(self, cls, method=None):
        return self.dispatcher.register(cls, func=method)

    def __get__(self, obj, cls=None):
        def method(*args, **kwargs):
            return self.dispatcher.dispatch(args[0].__class__).__get__(obj, cls)(*args, **kwargs)

        method.__isabstractmethod__ = getattr(self.func, "__isabstractmethod__", False)
        method.register = self.register
        update_wrapper(method, self.func)
        return method
