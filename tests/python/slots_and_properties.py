def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")
class S:
    __slots__ = ("x", "y", "_p")
    def __init__(self, x): self.x = x
    @property
    def p(self): return self._p
    @p.setter
    def p(self, v): self._p = v * 2
s = S(1)
s.p = 5
print(s.x, s.p, S.__slots__, hasattr(s, "y"), hasattr(s, "__dict__"), S.x.__name__, repr(S.x), S.x.__get__(s), type(S.x).__name__)
t(lambda: s.y)
t(lambda: setattr(s, "z", 1))
t(lambda: delattr(s, "y"))
t(lambda: s.__dict__)
t(lambda: vars(s))
del s.x
t(lambda: s.x)
S.x.__set__(s, 9)
print(s.x)
t(lambda: S.x.__get__(5))
class T(S):
    __slots__ = ["z"]
u = T(3)
u.z = 4
print(u.x, u.z, T.__slots__)
t(lambda: setattr(u, "w", 1))
class D(S): pass
d = D(1)
d.extra = 2
print(d.__dict__, d.x)
class One: __slots__ = "only"
o = One()
o.only = 1
print(o.only, One.__slots__)
t(lambda: setattr(o, "o", 1))
class WithDict: __slots__ = ("a", "__dict__")
w = WithDict()
w.a, w.b = 1, 2
print(w.__dict__, w.a)
class Default:
    __slots__ = ("a",)
    def __init__(self, a=5): self.a = a
    def __eq__(self, o): return self.a == o.a
    def __repr__(self): return f"Default({self.a})"
print(Default(), [Default(1)], Default(2) == Default(2))
class Empty: __slots__ = ()
t(lambda: setattr(Empty(), "a", 1))
for body in ({"__slots__": ("a",), "a": 1}, {"__slots__": ("1a",)}, {"__slots__": (5,)}, {"__slots__": ("a b",)}, {"__slots__": 5}):
    t(lambda: type("X", (), body))
t(lambda: type("X", (int,), {"__slots__": ("a",)}))
t(lambda: type("X", (S, WithDict), {}))
class Priv:
    __slots__ = ("__hidden",)
    def __init__(self): self.__hidden = 1
    def get(self): return self.__hidden
print(Priv().get(), Priv()._Priv__hidden)
class Temp:
    def __init__(self, c): self._c = c
    @property
    def f(self):
        "fahrenheit"
        return self._c * 9 / 5 + 32
    @f.setter
    def f(self, v): self._c = (v - 32) * 5 / 9
    @f.deleter
    def f(self): self._c = None
    @property
    def ro(self): return "ro"
    @property
    def boom(self): raise KeyError("inside")
    @property
    def attr_err(self): raise AttributeError("custom attr error")
    only_set = property(None, lambda self, v: setattr(self, "_c", v))
    lam = property(lambda self: self._c, doc="lam doc")
x = Temp(100)
print(x.f, Temp.f.__doc__, Temp.lam.__doc__, x.lam, Temp.f.fget.__name__, Temp.ro.fset)
x.f = 32
print(x._c)
x.f += 18
print(x.f, x._c)
del x.f
print(x._c)
x.only_set = 7
print(x._c)
for f in (lambda: setattr(x, "ro", 1), lambda: delattr(x, "ro"), lambda: x.only_set, lambda: x.boom, lambda: x.attr_err, lambda: hasattr(x, "attr_err"), lambda: getattr(x, "attr_err", "dflt"), lambda: hasattr(x, "boom"), lambda: getattr(x, "boom", 1)):
    t(f)
class Sub(Temp):
    @property
    def ro(self): return super().ro + "!"
    @Temp.f.setter
    def f(self, v): self._c = "sub set"
    @Temp.lam.getter
    def lam(self): return "sub lam"
y = Sub(1)
y.f = 5
print(y.ro, y._c, y.lam, Temp(3).lam)
x.__dict__["ro"] = "shadow"
print(x.ro, x.__dict__["ro"])
class Cls:
    _v = 0
    @classmethod
    def inc(cls): cls._v += 1; return cls._v
    @staticmethod
    def st(*a): return a
class CSub(Cls): pass
print(Cls.inc(), Cls().inc(), CSub.inc(), Cls._v, CSub._v, Cls.st(1, 2), Cls().st(3), CSub.inc.__self__.__name__, Cls.__dict__["st"].__func__(4))
