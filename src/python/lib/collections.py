"""Containers. What few programs use waits in other modules until it is asked for."""

from _types import GenericAlias as _GenericAlias

__all__ = ["ChainMap", "Counter", "OrderedDict", "UserDict", "UserList", "UserString", "defaultdict", "deque", "namedtuple"]


def __getattr__(name):
    if name in ("ChainMap", "UserDict", "UserList", "UserString"):
        import _collections_user as found

        value = getattr(found, name)
    elif name == "Counter":
        from _collections_counter import Counter as value
    elif name == "abc":
        import _collections_abc as value
    else:
        raise AttributeError(f"module 'collections' has no attribute {name!r}")
    return value


class OrderedDict(dict):
    __class_getitem__ = classmethod(_GenericAlias)

    def popitem(self, last=True):
        if not self:
            raise KeyError("dictionary is empty")
        key = next(reversed(self) if last else iter(self))
        return key, self.pop(key)

    def move_to_end(self, key, last=True):
        value = dict.pop(self, key)
        if last:
            dict.__setitem__(self, key, value)
            return
        others = list(dict.items(self))
        dict.clear(self)
        dict.__setitem__(self, key, value)
        dict.update(self, others)

    def pop(self, key, *default, **named):
        return dict.pop(self, key, *default, *named.values())

    def setdefault(self, key, default=None):
        if key in self:
            return self[key]
        self[key] = default
        return default

    def copy(self):
        return self.__class__(self)

    @classmethod
    def fromkeys(cls, iterable, value=None):
        made = cls()
        for key in iterable:
            made[key] = value
        return made

    def __eq__(self, other):
        if isinstance(other, OrderedDict):
            return dict.__eq__(self, other) and list(self) == list(other)
        return dict.__eq__(self, other)

    def __ne__(self, other):
        return not self == other

    __hash__ = None

    def __or__(self, other):
        if not isinstance(other, dict):
            return NotImplemented
        made = self.__class__(self)
        made.update(other)
        return made

    def __ror__(self, other):
        if not isinstance(other, dict):
            return NotImplemented
        made = self.__class__(other)
        made.update(self)
        return made

    def __ior__(self, other):
        self.update(other)
        return self

    def __repr__(self):
        if not self:
            return f"{self.__class__.__name__}()"
        key = id(self)
        if key in _showing:
            return "..."
        _showing.add(key)
        try:
            return f"{self.__class__.__name__}({list(self.items())!r})"
        finally:
            _showing.discard(key)


_showing = set()


class defaultdict(dict):
    __slots__ = ("default_factory",)
    __class_getitem__ = classmethod(_GenericAlias)

    def __init__(self, default_factory=None, /, *args, **kwargs):
        if default_factory is not None and not callable(default_factory):
            raise TypeError("first argument must be callable or None")
        self.default_factory = default_factory
        dict.__init__(self, *args, **kwargs)

    def __missing__(self, key):
        if self.default_factory is None:
            raise KeyError(key)
        value = self[key] = self.default_factory()
        return value

    def __repr__(self):
        key = id(self)
        if key in _showing:
            factory = "..."
        else:
            _showing.add(key)
            try:
                factory = repr(self.default_factory)
            finally:
                _showing.discard(key)
        return f"{type(self).__name__}({factory}, {dict.__repr__(self)})"

    def copy(self):
        return type(self)(self.default_factory, self)

    __copy__ = copy

    def __or__(self, other):
        if not isinstance(other, dict):
            return NotImplemented
        made = self.copy()
        made.update(other)
        return made

    def __ror__(self, other):
        if not isinstance(other, dict):
            return NotImplemented
        made = type(self)(self.default_factory, other)
        made.update(self)
        return made


def _item(index):
    return _Field(lambda self: tuple.__getitem__(self, index))


class _Field(property):
    def __set__(self, instance, value):
        raise AttributeError("can't set attribute")

    def __delete__(self, instance):
        raise AttributeError("can't delete attribute")


_KEYWORDS = frozenset((
    "False None True and as assert async await break class continue def del elif else except finally for from global "
    "if import in is lambda nonlocal not or pass raise return try while with yield"
).split())


def _field_names(names, rename):
    if isinstance(names, str):
        names = names.replace(",", " ").split()
    names = [str(name) for name in names]
    if rename:
        seen = set()
        for index, name in enumerate(names):
            if not name.isidentifier() or name in _KEYWORDS or name.startswith("_") or name in seen:
                names[index] = f"_{index}"
            seen.add(name)
    return names


def _check_names(typename, names, rename):
    for name in [typename, *names]:
        if type(name) is not str:
            raise TypeError("Type names and field names must be strings")
        if not name.isidentifier():
            raise ValueError(f"Type names and field names must be valid identifiers: {name!r}")
        if name in _KEYWORDS:
            raise ValueError(f"Type names and field names cannot be a keyword: {name!r}")
    seen = set()
    for name in names:
        if name.startswith("_") and not rename:
            raise ValueError(f"Field names cannot start with an underscore: {name!r}")
        if name in seen:
            raise ValueError(f"Encountered duplicate field name: {name!r}")
        seen.add(name)


def namedtuple(typename, field_names, *, rename=False, defaults=None, module=None):
    typename = str(typename)
    names = _field_names(field_names, rename)
    _check_names(typename, names, rename)
    names = tuple(names)
    count = len(names)
    field_defaults = {}
    if defaults is not None:
        defaults = tuple(defaults)
        if len(defaults) > count:
            raise TypeError("Got more default values than field names")
        field_defaults = dict(zip(names[count - len(defaults):], defaults))
    template = ", ".join([f"{name}=%r" for name in names])
    new = tuple.__new__

    def __new__(_cls, /, *args, **kwargs):
        if kwargs or len(args) != count:
            from _binding import bind

            bound = bind(f"{typename}.__new__", ("_cls",) + names, (), field_defaults, (_cls,) + args, kwargs)
            args = [bound[name] for name in names]
        return new(_cls, args)

    @classmethod
    def _make(cls, iterable):
        result = new(cls, iterable)
        if len(result) != count:
            raise TypeError(f"Expected {count} arguments, got {len(result)}")
        return result

    def _replace(self, /, **changes):
        result = self._make([changes.pop(name, value) for name, value in zip(names, self)])
        if changes:
            raise ValueError(f"Got unexpected field names: {list(changes)!r}")
        return result

    def __repr__(self):
        return self.__class__.__name__ + "(" + template % tuple(self) + ")"

    def _asdict(self):
        return dict(zip(names, self))

    def __getnewargs__(self):
        return tuple(self)

    namespace = {
        "__doc__": f"{typename}({', '.join(names)})",
        "__slots__": (),
        "_fields": names,
        "_field_defaults": field_defaults,
        "__new__": __new__,
        "_make": _make,
        "_replace": _replace,
        "__repr__": __repr__,
        "_asdict": _asdict,
        "__getnewargs__": __getnewargs__,
        "__match_args__": names,
    }
    for method in (__new__, _make.__func__, _replace, __repr__, _asdict, __getnewargs__):
        method.__qualname__ = f"{typename}.{method.__name__}"
    for index, name in enumerate(names):
        namespace[name] = _item(index)
    namespace["__module__"] = "__main__" if module is None else module
    return type(typename, (tuple,), namespace)


class deque:
    """Two stacks, back to back: `_front` holds the first items, the very first one last."""

    __slots__ = ("_front", "_back", "_maxlen", "_version")
    _match_sequence_ = True
    __class_getitem__ = classmethod(_GenericAlias)
    __hash__ = None

    def __init__(self, iterable=(), maxlen=None):
        if maxlen is not None:
            if not isinstance(maxlen, int):
                raise TypeError("an integer is required")
            if maxlen < 0:
                raise ValueError("maxlen must be non-negative")
        self._maxlen = maxlen
        self._front = []
        self._version = 0
        self._back = list(iterable)
        if maxlen is not None and len(self._back) > maxlen:
            del self._back[:len(self._back) - maxlen]

    @property
    def maxlen(self):
        return self._maxlen

    def append(self, x, /):
        self._version += 1
        self._back.append(x)
        if self._maxlen is not None and len(self._front) + len(self._back) > self._maxlen:
            self.popleft()

    def appendleft(self, x, /):
        self._version += 1
        self._front.append(x)
        if self._maxlen is not None and len(self._front) + len(self._back) > self._maxlen:
            self.pop()

    def pop(self):
        back = self._back
        if not back:
            front = self._front
            if not front:
                raise IndexError("pop from an empty deque")
            half = (len(front) + 1) // 2
            back.extend(front[:half][::-1])
            del front[:half]
        self._version += 1
        return back.pop()

    def popleft(self):
        front = self._front
        if not front:
            back = self._back
            if not back:
                raise IndexError("pop from an empty deque")
            half = (len(back) + 1) // 2
            front.extend(back[:half][::-1])
            del back[:half]
        self._version += 1
        return front.pop()

    def extend(self, iterable, /):
        for x in list(iterable) if iterable is self else iterable:
            self.append(x)

    def extendleft(self, iterable, /):
        for x in list(iterable) if iterable is self else iterable:
            self.appendleft(x)

    def clear(self):
        self._version += 1
        self._front.clear()
        self._back.clear()

    def _set(self, items):
        self._version += 1
        self._front = []
        self._back = items

    def copy(self):
        return self.__class__(self) if self._maxlen is None else self.__class__(self, self._maxlen)

    __copy__ = copy

    def rotate(self, n=1, /):
        size = len(self._front) + len(self._back)
        if size < 2:
            return
        n %= size
        if n <= size - n:
            for _ in range(n):
                self.appendleft(self.pop()) if self._maxlen is None else self._front.append(self.pop())
        else:
            for _ in range(size - n):
                self.append(self.popleft()) if self._maxlen is None else self._back.append(self.popleft())

    def reverse(self):
        self._version += 1
        self._front, self._back = self._back, self._front

    def _find(self, value, start, stop):
        version = self._version
        for index, item in enumerate(self):
            if index >= stop:
                break
            if index >= start:
                found = item is value or item == value
                if self._version != version:
                    raise RuntimeError("deque mutated during iteration")
                if found:
                    return index
        return -1

    def count(self, value, /):
        version = self._version
        total = 0
        for item in self._front[::-1] + self._back:
            if item is value or item == value:
                total += 1
            if self._version != version:
                raise RuntimeError("deque mutated during iteration")
        return total

    def index(self, value, start=0, stop=None, /):
        size = len(self)
        start, stop, _ = slice(start, stop).indices(size)
        found = self._find(value, start, stop)
        if found < 0:
            raise ValueError(f"{value!r} is not in deque")
        return found

    def remove(self, value, /):
        try:
            found = self._find(value, 0, len(self))
        except RuntimeError:
            raise IndexError("deque mutated during remove().") from None
        if found < 0:
            raise ValueError(f"{value!r} is not in deque")
        del self[found]

    def insert(self, index, value, /):
        size = len(self)
        if self._maxlen is not None and size >= self._maxlen:
            raise IndexError("deque already at its maximum size")
        items = list(self)
        items.insert(index, value)
        self._set(items)

    def _place(self, index):
        """The stack and the index in it of the item at `index`."""
        if not hasattr(index, "__index__"):
            raise TypeError(f"sequence index must be integer, not {type(index).__name__!r}")
        index = index.__index__()
        size = len(self._front)
        if index < 0:
            index += size + len(self._back)
        if not 0 <= index < size + len(self._back):
            raise IndexError("deque index out of range")
        return (self._front, size - 1 - index) if index < size else (self._back, index - size)

    def __getitem__(self, index):
        stack, at = self._place(index)
        return stack[at]

    def __setitem__(self, index, value):
        stack, at = self._place(index)
        stack[at] = value

    def __delitem__(self, index):
        stack, at = self._place(index)
        self._version += 1
        del stack[at]

    def __len__(self):
        return len(self._front) + len(self._back)

    def __iter__(self):
        return _walk(self, self._front[::-1] + self._back)

    def __reversed__(self):
        return _walk(self, self._back[::-1] + self._front)

    def __contains__(self, value):
        return self._find(value, 0, len(self)) >= 0

    def __repr__(self):
        key = id(self)
        if key in _showing:
            return "[...]"
        _showing.add(key)
        try:
            shown = repr(self._front[::-1] + self._back)
        finally:
            _showing.discard(key)
        if self._maxlen is not None:
            shown += f", maxlen={self._maxlen}"
        return f"{type(self).__name__}({shown})"

    def __add__(self, other):
        if not isinstance(other, deque):
            raise TypeError(f'can only concatenate deque (not "{type(other).__name__}") to deque')
        made = self.copy()
        made.extend(other)
        return made

    def __iadd__(self, other):
        self.extend(other)
        return self

    def __mul__(self, times):
        if not hasattr(times, "__index__"):
            raise TypeError(f"can't multiply sequence by non-int of type {type(times).__name__!r}")
        items = list(self) * times
        return self.__class__(items) if self._maxlen is None else self.__class__(items, self._maxlen)

    __rmul__ = __mul__

    def __imul__(self, times):
        items = list(self) * times
        self._set(items if self._maxlen is None else items[max(0, len(items) - self._maxlen):])
        return self

    def __eq__(self, other):
        return list(self) == list(other) if isinstance(other, deque) else NotImplemented

    def __lt__(self, other):
        return list(self) < list(other) if isinstance(other, deque) else NotImplemented

    def __le__(self, other):
        return list(self) <= list(other) if isinstance(other, deque) else NotImplemented

    def __gt__(self, other):
        return list(self) > list(other) if isinstance(other, deque) else NotImplemented

    def __ge__(self, other):
        return list(self) >= list(other) if isinstance(other, deque) else NotImplemented


def _walk(owner, items):
    version = owner._version
    for item in items:
        if owner._version != version:
            raise RuntimeError("deque mutated during iteration")
        yield item
