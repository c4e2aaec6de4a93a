"""functools.singledispatch: picks an implementation by the class of the first argument."""

from _types import mappingproxy
from functools import update_wrapper


def _is_abstract(cls):
    return hasattr(cls, "_abc_registry")


def _find(cls, registry):
    """The implementation for the registered class nearest to `cls`: its method resolution order first, with the
    abstract classes that it only claims to implement put where they first apply."""
    mro = list(cls.__mro__)
    virtual = [c for c in registry if c not in mro and _is_abstract(c) and issubclass(cls, c)]
    if virtual:
        mro = _with_virtual(mro, virtual)
    for position, candidate in enumerate(mro):
        if candidate in registry:
            rival = next((c for c in mro[position + 1:] if c in virtual), None)
            if (
                candidate in virtual and rival is not None
                and not issubclass(candidate, rival) and not issubclass(rival, candidate)
            ):
                raise RuntimeError(f"Ambiguous dispatch: {candidate} or {rival}")
            return registry[candidate]
    return None


def _with_virtual(mro, virtual):
    """Each virtual base after the last class of `mro` that implements it, the more derived ones first."""
    ordered = sorted(virtual, key=lambda c: sum(issubclass(other, c) for other in virtual))
    placed = {}
    for base in ordered:
        last = max(i for i, c in enumerate(mro) if c is not object and issubclass(c, base))
        placed.setdefault(last, []).append(base)
    result = []
    for i, c in enumerate(mro):
        result.append(c)
        result.extend(placed.get(i, ()))
    return result


def _union_members(cls):
    args = getattr(cls, "__args__", None)
    is_union = type(cls) is type(int | str) or getattr(cls, "_name", None) == "Union"
    return args if is_union else None


def _valid(cls):
    members = _union_members(cls)
    if members is not None:
        return all(isinstance(arg, type) for arg in members)
    return isinstance(cls, type) and not hasattr(cls, "__args__")


def singledispatch(func):
    registry = {}
    cache = {}
    name = getattr(func, "__name__", "singledispatch function")

    def dispatch(cls):
        found = cache.get(cls)
        if found is None:
            found = cache[cls] = registry[cls] if cls in registry else _find(cls, registry)
        return found

    def register(cls, func=None):
        if _valid(cls):
            if func is None:
                return lambda f: register(cls, f)
        else:
            if func is not None:
                raise TypeError(f"Invalid first argument to `register()`. {cls!r} is not a class or union type.")
            annotations = getattr(cls, "__annotations__", {})
            if not annotations:
                raise TypeError(
                    f"Invalid first argument to `register()`: {cls!r}. "
                    "Use either `@register(some_class)` or plain `@register` on an annotated function."
                )
            func = cls
            argument, cls = next(iter(annotations.items()))
            if isinstance(cls, str):
                from typing import get_type_hints

                cls = get_type_hints(func)[argument]
            if not _valid(cls):
                what = "not all arguments are classes." if _union_members(cls) is not None else "is not a class."
                raise TypeError(f"Invalid annotation for {argument!r}. {cls!r} {what}")
        for member in _union_members(cls) or (cls,):
            registry[member] = func
        cache.clear()
        return func

    def wrapper(*args, **kwargs):
        if not args:
            raise TypeError(f"{name} requires at least 1 positional argument")
        return dispatch(args[0].__class__)(*args, **kwargs)

    registry[object] = func
    wrapper.register = register
    wrapper.dispatch = dispatch
    wrapper.registry = mappingproxy(registry)
    wrapper._clear_cache = cache.clear
    update_wrapper(wrapper, func)
    return wrapper
