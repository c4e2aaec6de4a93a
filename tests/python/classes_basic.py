def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

class A:
    """Doc of A."""
    x = 1
    lst = []
    def __init__(self, v=0): self.v = v
    def get(self): return self.v
    def me(self): return self
a, b = A(1), A(2)
a.lst.append("shared")
a.x += 10
print(a.x, b.x, A.x, b.lst, a.get(), A.get(b), A.__doc__, A.__name__, A.__qualname__, A.__module__, a.__dict__, a.__class__ is A, A.__bases__, A.__mro__)
A.y = 5
A.hi = lambda self, n: (self.v, n)
print(a.y, a.hi(3), hasattr(a, "y"), hasattr(a, "z"), getattr(a, "z", "dflt"), getattr(a, "v"))
del A.y
t(lambda: a.y)
t(lambda: A.y)
t(lambda: a.nope)
t(lambda: A.nope)
t(lambda: None.foo)
t(lambda: (5).foo)
t(lambda: [].foo)
t(lambda: "a".foo)
t(lambda: len.foo)
t(lambda: int.foo)
t(lambda: (lambda: 0).foo)
def setnone(): None.foo = 1
def setint(): (5).foo = 1
def setlist(): [].append = 1
def setobj(): object().x = 1
def delmiss(): del a.nope
def delcls(): del A.nope
def setbuiltin(): int.foo = 1
def delx(): del a.get
def setmod(): type.x = 1
for f in (setnone, setint, setlist, setobj, delmiss, delcls, setbuiltin, delx, setmod):
    t(f)
m = a.get
a.v = 99
print(m(), m.__self__ is a, m.__func__ is A.get, m.__name__, a.get == a.get, a.get is a.get, a.get == b.get, A.get is A.get)
setattr(a, "dyn amic", 7)
print(getattr(a, "dyn amic"), vars(a), "v" in vars(a), sorted(k for k in dir(a) if not k.startswith("_")))
a.__dict__["inj"] = 3
print(a.inj)
a.__dict__ = {"only": 1}
print(a.only, a.x)
t(lambda: a.v)
class B(A):
    x = 2
    def get(self): return super().get() * 10
print(B(4).get(), B.x, B().x, isinstance(B(), A), issubclass(B, A), issubclass(A, B), isinstance(A(), (int, A)), B.__base__.__name__, A.__subclasses__() == [B], type(B()).__name__)
class Empty: pass
e = Empty()
e.a = 1
print(e.__dict__, Empty.__dict__.keys() >= {"__module__", "__dict__"}, Empty() == Empty(), Empty() != Empty(), e == e, hash(e) == hash(e), bool(e), not e)
class Name:
    __private = 5
    def __secret(self): return "s"
    def call(self): return self.__secret(), self.__private
    def __init__(self): self.__inst = 1
n = Name()
print(n.call(), n._Name__secret(), n._Name__private, vars(n))
t(lambda: n.__private)
t(lambda: n.__inst)
class Outer:
    class Inner:
        v = 3
        def q(self): return self.__class__.__qualname__
    i = Inner()
print(Outer.Inner().q(), Outer.i.v, Outer.Inner.__name__, repr(Outer.Inner))
class WithBody:
    vals = []
    for i in range(3):
        vals.append(i * i)
    if vals:
        def meth(self): return "defined in if"
    else:
        def other(self): pass
    del i
print(WithBody.vals, WithBody().meth(), hasattr(WithBody, "i"), hasattr(WithBody, "other"))
class New:
    made = 0
    def __new__(cls, *a, **k):
        cls.made += 1
        print("new", a, k)
        return super().__new__(cls)
    def __init__(self, *a, **k): print("init", a, k)
New(1, x=2)
class Other:
    def __new__(cls): return 42
    def __init__(self): print("never")
print(Other(), New.made)
class RetInit:
    def __init__(self): return 5
t(RetInit)
class Single:
    _i = None
    def __new__(cls):
        if cls._i is None:
            cls._i = super().__new__(cls)
        return cls._i
print(Single() is Single())
T = type("T", (A,), {"k": 1, "m": lambda self: self.k})
print(T.__name__, T().m(), T.__mro__[1].__name__, T(5).get(), repr(T))
t(lambda: type("X", (int, str), {}))
t(lambda: type("X", (5,), {}))
t(lambda: type("X", (bool,), {}))
t(lambda: type("X", (A, A), {}))
t(lambda: type("X", (object, A), {}))
t(lambda: type(5, (), {}))
def badbase():
    class X(5): pass
t(badbase)
def finalbase():
    class X(bool): pass
t(finalbase)
def frange():
    class X(range): pass
t(frange)
x = A()
x.__class__ = B
print(type(x).__name__, x.get())
def badcls(): x.__class__ = int
t(badcls)
def badcls2(): x.__class__ = 5
t(badcls2)
def kw():
    class X(A, foo=1): pass
t(kw)
class Ann:
    a: int
    b: str = "x"
    c: "Undefined" = 1
print(Ann.__annotations__, Ann.b, hasattr(Ann, "a"))
def fn(a: int, b: "s" = 1, *c: float, d: str, **e: dict) -> None: pass
print(fn.__annotations__, fn.__defaults__, fn.__kwdefaults__, fn.__doc__)
print(repr(A), str(int), repr(type), repr(type(None)), repr(type(...)), repr(type(NotImplemented)), repr(type(len)), repr(type(lambda: 0)), type(type).__name__, repr(object), type(a.get).__name__, type([].append).__name__, type(A.get).__name__, type(int.bit_length).__name__, type(A.__dict__).__name__)
