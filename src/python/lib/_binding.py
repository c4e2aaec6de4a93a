"""Binds arguments to parameters that are known only at run time, with the words of CPython's own TypeErrors."""


def _listed(names):
    quoted = [repr(name) for name in names]
    if len(quoted) < 3:
        return " and ".join(quoted)
    return ", ".join(quoted[:-1]) + ", and " + quoted[-1]


def _missing(function, names, kind):
    plural = "" if len(names) == 1 else "s"
    return TypeError(f"{function}() missing {len(names)} required {kind} argument{plural}: {_listed(names)}")


def _too_many(function, positional, defaults, given, keyword_only_given):
    most = len(positional)
    least = sum(name not in defaults for name in positional)
    takes = str(most) if least == most else f"from {least} to {most}"
    plural = "s" if least != most or most != 1 else ""
    but = str(given)
    if keyword_only_given:
        but += f" positional argument{'' if given == 1 else 's'} (and {keyword_only_given} keyword-only argument{'' if keyword_only_given == 1 else 's'})"
    was = "was" if given == 1 and not keyword_only_given else "were"
    return TypeError(f"{function}() takes {takes} positional argument{plural} but {but} {was} given")


def bind(function, positional, keyword_only, defaults, args, kwargs):
    """The value of each parameter, by name. `positional` includes the receiver, as `args` does."""
    bound = dict(zip(positional, args))
    for name, value in kwargs.items():
        if name in bound:
            raise TypeError(f"{function}() got multiple values for argument {name!r}")
        if name not in positional and name not in keyword_only:
            raise TypeError(f"{function}() got an unexpected keyword argument {name!r}")
        bound[name] = value
    if len(args) > len(positional):
        raise _too_many(function, positional, defaults, len(args), sum(name in bound for name in keyword_only))
    for names, kind in ((positional, "positional"), (keyword_only, "keyword-only")):
        absent = [name for name in names if name not in bound]
        required = [name for name in absent if name not in defaults]
        if required:
            raise _missing(function, required, kind)
        for name in absent:
            bound[name] = defaults[name]
    return bound
