"""Functions of typing that work on hints or only mark what they are given."""

from typing import ForwardRef, Generic, _GenericAlias, _NoneType, _SpecialForm, _TypeParameter
from _typing_rare import Annotated, _AnnotatedAlias, _LiteralAlias


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
    if name == "Callable" and args and not (len(args) == 2 and (args[0] is ... or isinstance(args[0], _TypeParameter) and args[0]._variadic)):
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
