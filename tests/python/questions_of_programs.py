"""What programs ask of generators, code, tracebacks, errors and their own globals."""


def steps():
    received = yield 1
    yield from [received]


g = steps()
print(g.gi_suspended, g.gi_code.co_name, g.gi_yieldfrom)
next(g)
print(g.gi_suspended, g.gi_yieldfrom)
g.send(2)
print(type(g.gi_yieldfrom).__name__)


def outer(a, /, b=1, *c, d):
    def inner():
        return a
    return inner


print(outer.__code__.co_cellvars, outer(1, d=2).__code__.co_freevars)

try:
    1 / 0
except ZeroDivisionError as error:
    print(error.__traceback__.tb_lineno, error.__traceback__.tb_next)

error = ValueError("x")
error.__dict__["y"] = 1
error.add_note("noted")
print(error.__notes__, error.y)

try:
    import no_such_module
except ImportError as error:
    print(error.msg, error.name, error.path)
try:
    from math import no_such_name
except ImportError as error:
    print(error.name)
error = SyntaxError("wrong", ("file", 3, 4, "text"))
print(error.msg, error.filename, error.lineno, error.offset, error.text, error)

globals()["injected"] = 5
print(injected, locals() is globals(), "__class__" in dir(5))


class Mapping(dict):
    def __iter__(self):
        return iter(["seen"])

    def keys(self):
        return ["key"]

    def __getitem__(self, key):
        return key * 2


print(dict(Mapping(a=1)), {**Mapping(a=1)})
print(["a"] & {"a": 1}.keys(), ["b"] | {"b": 1}.keys(), ["c", "d"] - {"c": 1}.keys())
