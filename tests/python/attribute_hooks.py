def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

class G:
    cls = "class"
    def __init__(self): self.real = 1
    def __getattr__(self, n):
        if n.startswith("no"):
            raise AttributeError(f"refused {n}")
        return "dyn " + n
g = G()
print(g.real, g.cls, g.foo, hasattr(g, "nope"), getattr(g, "nope", 5), hasattr(g, "anything"))
t(lambda: g.nope)
class GA:
    def __init__(self): self.x = 1
    def __getattribute__(self, n):
        print("ga", n)
        return super().__getattribute__(n)
    def meth(self): return self.x
a = GA()
print(a.x, a.meth())
t(lambda: a.missing)
class Both:
    def __getattribute__(self, n):
        if n == "x": raise AttributeError("from getattribute")
        return object.__getattribute__(self, n)
    def __getattr__(self, n): return "fallback " + n
print(Both().x, Both().y, Both().__class__.__name__)
class Set:
    def __setattr__(self, n, v):
        print("set", n, v)
        object.__setattr__(self, n, v)
    def __delattr__(self, n):
        print("del", n)
        super().__delattr__(n)
s = Set()
s.a = 1
s.a += 2
del s.a
t(lambda: s.a)
def dd(): del s.zz
t(dd)
class Frozen:
    def __init__(self): self.__dict__["v"] = 1
    def __setattr__(self, n, v): raise AttributeError(f"frozen: {n}")
f = Frozen()
t(lambda: setattr(f, "v", 2))
print(f.v)
class Desc:
    def __set_name__(self, owner, name):
        print("set_name", owner.__name__, name)
        self.n = name
    def __get__(self, obj, cls=None):
        if obj is None: return f"class access via {cls.__name__}"
        return obj.__dict__.get(self.n, "unset")
    def __set__(self, obj, v):
        obj.__dict__[self.n] = v * 2
    def __delete__(self, obj):
        print("delete", self.n)
        del obj.__dict__[self.n]
class D:
    d = Desc()
    e = Desc()
class D2(D): pass
x = D()
print(x.d, D.d, D2.e)
x.d = 5
x.__dict__["e"] = "in dict"
print(x.d, x.e, vars(x))
del x.d
print(x.d)
class NonData:
    def __get__(self, obj, cls): return "nondata"
class N:
    nd = NonData()
n = N()
print(n.nd)
n.nd = "inst"
print(n.nd, N.nd)
class RO:
    def __get__(self, o, c): return 1
    def __set__(self, o, v): raise AttributeError("read only")
class Hr:
    r = RO()
h = Hr()
t(lambda: setattr(h, "r", 2))
def delr(): del h.r
t(delr)
class OnlySet:
    def __set__(self, o, v): o.__dict__["os"] = ("via set", v)
class Hs:
    os = OnlySet()
h = Hs()
print(type(h.os).__name__)
h.os = 1
print(h.os)
class Fn:
    def __get__(self, o, c): return lambda *a: (o is None, c.__name__, a)
class Hf:
    f = Fn()
print(Hf.f(1), Hf().f(2))
p = property(lambda self: "got", lambda self, v: print("set", v), lambda self: print("del"), "docs")
class Pc:
    a = p
    b = property()
    c = property(fset=lambda self, v: print("only set", v))
    @property
    def err(self): raise AttributeError("inside property")
    @property
    def typ(self): return self.nonexistent
o = Pc()
print(o.a, p.__doc__, Pc.a is p, p.fget(o))
o.a = 1
del o.a
o.c = 3
for f in (lambda: o.b, lambda: o.c, lambda: setattr(o, "b", 1), lambda: delattr(o, "b"), lambda: delattr(o, "c"), lambda: o.err, lambda: o.typ, lambda: hasattr(o, "err")):
    t(f)
class WithGetattrProp(Pc):
    def __getattr__(self, n): return "rescued " + n
print(WithGetattrProp().err, WithGetattrProp().typ)
class M(type):
    def __getattr__(cls, n): return f"meta {n}"
    def __setattr__(cls, n, v):
        print("meta set", n)
        super().__setattr__(n, v)
class Mc(metaclass=M): pass
print(Mc.foo)
Mc.bar = 1
print(Mc.bar, hasattr(Mc(), "foo"))
class Ck:
    @classmethod
    def cm(cls): return cls
    @staticmethod
    def sm(): return "sm"
print(Ck.cm() is Ck, Ck().cm() is Ck, type(Ck.__dict__["cm"]).__name__, type(Ck.__dict__["sm"]).__name__, Ck.__dict__["sm"](), Ck.cm.__func__.__name__, Ck.cm.__self__ is Ck)
class Cached:
    def __init__(self, f): self.f = f
    def __set_name__(self, o, n): self.name = n
    def __get__(self, o, c):
        if o is None: return self
        v = o.__dict__[self.name] = self.f(o)
        return v
class Use:
    @Cached
    def big(self):
        print("computing")
        return 42
u = Use()
print(u.big, u.big)
class Slot:
    __slots__ = ("a", "__dict__")
z = Slot()
z.a, z.b = 1, 2
print(z.a, z.b, z.__dict__)
del z.a
t(lambda: z.a)
def dz(): del z.a
t(dz)
class BadSetName:
    def __set_name__(self, o, n): raise ValueError("bad name")
def bsn():
    class Q:
        v = BadSetName()
try:
    bsn()
except Exception as e:
    print(type(e).__name__, e, repr(e.__cause__))
print(object.__getattribute__(u, "big"), type.__getattribute__(Use, "__name__"), u.__getattribute__("big"), Use.__dict__["big"].name)
d = {}
t(lambda: d.foo)
t(lambda: getattr(d, "fo" + "o"))
t(lambda: delattr(d, "foo"))
t(lambda: setattr(d, "foo", 1))
