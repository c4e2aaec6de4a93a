def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

class M(type):
    @classmethod
    def __prepare__(mcs, name, bases, **kw):
        print("prepare", name, [b.__name__ for b in bases], kw)
        return {"injected": 1}
    def __new__(mcs, name, bases, ns, **kw):
        print("new", name, sorted(k for k in ns if not k.startswith("__")), kw)
        cls = super().__new__(mcs, name, bases, ns)
        cls.made_by = "M"
        return cls
    def __init__(cls, name, bases, ns, **kw):
        print("init", name)
        super().__init__(name, bases, ns)
    def __call__(cls, *a, **k):
        print("call", cls.__name__, a, k)
        return super().__call__(*a, **k)
    def meth(cls): return "meta method of " + cls.__name__
    @property
    def prop(cls): return "prop " + cls.__name__
    def __len__(cls): return 7
    def __iter__(cls): return iter("it")
    def __getitem__(cls, k): return cls.__name__ + "[" + repr(k) + "]"
    def __contains__(cls, k): return k == 1
    def __repr__(cls): return f"<M {cls.__name__}>"
    def __instancecheck__(cls, o): return o == 5 or super().__instancecheck__(o)
    def __subclasscheck__(cls, o): return o is int or super().__subclasscheck__(o)
    def __add__(cls, o): return "added"
    def __bool__(cls): return False
    def __eq__(cls, o): return cls is o
    def __hash__(cls): return 3
class A(metaclass=M, flag=True):
    x = injected + 1
    def __init__(self, v): self.v = v
class B(A): pass
b = B(3)
print(b.v, B.x, B.made_by, A.meth(), A.prop, len(A), list(A), A["k"], 1 in A, repr(A), isinstance(5, A), isinstance(6, A), isinstance(b, A), issubclass(int, A), issubclass(str, A), A + 1, bool(A), type(A).__name__, type(B) is M, A == B, hash(A))
t(lambda: b.meth())
t(lambda: b.prop)
print(f"{A}", str(B), [A])
class N(type): pass
def conflict():
    class X(A, metaclass=N): pass
t(conflict)
class NM(M): pass
class Y(A, metaclass=NM): pass
print(type(Y).__name__)
def func_meta(name, bases, ns): return (name, bases, sorted(k for k in ns if k[0] != "_"))
class F(metaclass=func_meta):
    a = 1
    b = 2
print(F)
class Order(dict):
    def __setitem__(self, k, v):
        if not k.startswith("__"): print("define", k, v if not callable(v) else "callable")
        super().__setitem__(k, v)
class OM(type):
    @classmethod
    def __prepare__(m, n, b): return Order()
class Ordered(metaclass=OM):
    one = 1
    two = one + 1
    def three(self): pass
class Singleton(type):
    inst = {}
    def __call__(cls, *a):
        if cls not in cls.inst: cls.inst[cls] = super().__call__(*a)
        return cls.inst[cls]
class Db(metaclass=Singleton):
    def __init__(self): print("created")
print(Db() is Db())
class Reg(type):
    reg = {}
    def __init__(cls, name, bases, ns):
        super().__init__(name, bases, ns)
        if bases: Reg.reg[name] = cls
class Plug(metaclass=Reg): pass
class P1(Plug): pass
class P2(Plug): pass
print(list(Reg.reg))
class CG:
    def __class_getitem__(cls, k): return f"{cls.__name__}<{k}>"
print(CG[int], CG[1, 2])
class Sub(CG): pass
print(Sub["q"])
def badprep():
    class BP(type):
        @classmethod
        def __prepare__(m, n, b): return 5
    class Z(metaclass=BP): pass
t(badprep)
class Abstract(type):
    def __call__(cls, *a, **k):
        missing = [n for n in dir(cls) if getattr(getattr(cls, n), "abstract", False)]
        if missing: raise TypeError(f"abstract: {missing}")
        return super().__call__(*a, **k)
def abstract(f): f.abstract = True; return f
class Shape(metaclass=Abstract):
    @abstract
    def area(self): pass
class Sq(Shape):
    def area(self): return 4
t(Shape)
print(Sq().area())
print(type.__call__(Sq).area(), type("Dyn", (Shape,), {"area": lambda s: 1})().area(), M.__mro__[1].__name__, isinstance(A, type), isinstance(A, M), type(M).__name__)
class KwInit:
    def __init_subclass__(cls, **kw): print("sub", cls.__name__, kw)
class K1(KwInit, a=1, b="x"): pass
class MroM(type):
    def mro(cls): return [cls, Extra, object]
class Extra:
    def hi(self): return "extra"
class Mr(metaclass=MroM): pass
print(Mr().hi(), [c.__name__ for c in Mr.__mro__])
class Ent:
    def __mro_entries__(self, bases): return (Extra,)
class UsesEnt(Ent()): pass
print(UsesEnt.__bases__ == (Extra,), hasattr(UsesEnt, "__orig_bases__"))
print(vars(A)["x"], A.__dict__["made_by"], "x" in vars(B))
