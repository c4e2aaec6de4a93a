def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

class A:
    "doc"
    x = 1
    def __init__(self): self.y = 2
    def m(self): pass
class B(A): pass
a, b = A(), B()
print(type(a) is A, type(5), type("a"), type(None), type(type), type(A), type(a.m).__name__, type(A.m).__name__, type(len), type([].append).__name__, type(...), type(NotImplemented), type({}.keys()), type(x for x in []), type(lambda: 0), type(range(1)), type(1j), type(b""), type(frozenset()), type(slice(1)), type(iter([])), type(zip()), type(property()), type(int | str), type(list[int]))
print(isinstance(1, int), isinstance(True, int), isinstance(1, (str, int)), isinstance(1, (str, (float, int))), isinstance(b, A), isinstance(a, B), isinstance(A, type), isinstance(1, object), isinstance(int, object), isinstance(1, int | str), isinstance([], list | tuple), isinstance(None, type(None)), isinstance(1, ()), issubclass(B, A), issubclass(bool, int), issubclass(A, (int, object)), issubclass(A, A), issubclass(int, int | str))
print(callable(len), callable(a), callable(A), callable(a.m), callable(lambda: 0), callable(5), hasattr(a, "x"), hasattr(a, "zz"), getattr(a, "y"), getattr(a, "zz", "dflt"), getattr(a, "zz", None), setattr(a, "new", 5), a.new, delattr(a, "new"), hasattr(a, "new"), vars(a), sorted(vars(A))[:3], [n for n in dir(a) if not n.startswith("__")], dir(b) == dir(a), [n for n in dir(5) if n.startswith("bit")], sorted(dir({}))[-3:])
print(repr("a"), repr(5), repr(None), repr([1, "x"]), ascii("é"), ascii(["☃"]), str(b"a"), format(5, "03"), format("x"), hash("a") == hash("a"), hash((1, 2)) == hash((1, 2)), id(a) == id(a), a is a, len("abc"), len({}), len(range(5)), bool(a), a == a, a != b, A == A, A.__doc__, a.__doc__, len.__doc__ is not None, A.__name__, a.__class__.__name__, len.__name__, (lambda: 0).__name__, a.m.__name__)
print(list("ab"), tuple([1]), dict(a=1), set([1]), frozenset([1]), bytes([65]), bytearray(b"a"), str(), int(), float(), complex(), bool(), list(), tuple(), dict(), bytes(), object().__class__, slice(1, 2, 3), range(1, 2), type("X", (), {})().__class__.__name__, super(B, b).__thisclass__.__name__, property(lambda s: 1).fget(0), staticmethod(len)("ab"), classmethod(lambda c: c).__func__(3))
for f in (lambda: isinstance(1, "int"), lambda: isinstance(1, [int]), lambda: isinstance(1, (int, "a")), lambda: isinstance(1, ("a", int)), lambda: issubclass(1, int), lambda: issubclass(int, [int]), lambda: isinstance(1, list[int]), lambda: getattr(a, "zz"), lambda: getattr(a, 5), lambda: setattr(a, 5, 1), lambda: delattr(a, "zz"), lambda: setattr(5, "x", 1), lambda: setattr(object(), "x", 1), lambda: vars(5), lambda: vars(object()), lambda: len(5), lambda: len(a), lambda: hash([]), lambda: hash({}), lambda: hash(([],)), lambda: hash(slice(1)), lambda: hash(bytearray()), lambda: type(1, 2), lambda: type("A", (1,), {}), lambda: type("A", (), 1), lambda: type(1, (), {}), lambda: type(), lambda: object(1), lambda: A(1), lambda: super(), lambda: super(5), lambda: super(A, 5), lambda: super(A, int), lambda: str(b"a", "nope"), lambda: str("a", "utf-8"), lambda: bytes("a"), lambda: bytes(-1), lambda: callable(), lambda: id(), lambda: repr(), lambda: dir(1, 2), lambda: format(), lambda: format(5, 5), lambda: classmethod(), lambda: property(1, 2, 3, 4, 5), lambda: int.nope, lambda: A.nope, lambda: a.m.nope, lambda: len.nope, lambda: None.nope, lambda: (1).nope, lambda: globals().nope, lambda: print.x, lambda: range(3).start2, lambda: slice(1).foo, lambda: (i for i in []).foo, lambda: ....foo, lambda: ZeroDivisionError().foo, lambda: property().foo):
    t(f)
print(object() == object(), object is object, isinstance(object, type), issubclass(type, object), type.__mro__, bool.__mro__, bool.__bases__, A.__mro__, [c.__name__ for c in B.mro()], int.__name__, int.__qualname__, int.__module__, A.__dict__["x"], A.__module__, type(a).__bases__, B.__base__, A.__subclasses__())
g = globals()
g["injected"] = 5
print(injected, "A" in g, locals() is globals(), __name__, sorted(k for k in g if k in ("a", "b", "t")))
def loc(p, q=2):
    r = 3
    return sorted(locals().items())
print(loc(1))
