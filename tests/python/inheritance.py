def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

class A:
    def who(self): return ["A"]
    def __init__(self, **k): print("A.init", k)
class B(A):
    def who(self): return ["B"] + super().who()
    def __init__(self, b=0, **k):
        print("B.init", b)
        super().__init__(**k)
class C(A):
    def who(self): return ["C"] + super().who()
    def __init__(self, c=0, **k):
        print("C.init", c)
        super().__init__(**k)
class D(B, C):
    def who(self): return ["D"] + super().who()
d = D(b=1, c=2, z=3)
print(d.who(), [k.__name__ for k in D.__mro__], [k.__name__ for k in D.mro()], D.__base__.__name__, [k.__name__ for k in D.__bases__])
print(super(B, d).who(), super(C, d).who(), super(D, D).who(d), super(B, D).who(d))
t(lambda: super(A, d).who())
t(lambda: super(D, A()).who())
t(lambda: super(C, B()))
def nosuper(): return super().x
t(nosuper)
def mro_conflict():
    class X(A, B): pass
t(mro_conflict)
class X: pass
class Y: pass
class XY(X, Y): pass
class YX(Y, X): pass
def mro2():
    class Z(XY, YX): pass
t(mro2)
class O: pass
class E1(O): pass
class E2(O): pass
class E3(O): pass
class F1(E1, E2): pass
class F2(E3, E2): pass
class G(F1, F2): pass
print([k.__name__ for k in G.__mro__])
class Base:
    registry = []
    def __init_subclass__(cls, /, tag=None, **kw):
        super().__init_subclass__(**kw)
        Base.registry.append((cls.__name__, tag))
class S1(Base, tag="one"): pass
class S2(S1): pass
print(Base.registry)
def badkw():
    class S3(Base, other=1): pass
t(badkw)
class P:
    @property
    def v(self): return 1
    @classmethod
    def make(cls): return cls.__name__
    @staticmethod
    def st(): return "P.st"
class Q(P):
    @property
    def v(self): return super().v + 1
    @classmethod
    def make(cls): return "Q:" + super().make()
    @staticmethod
    def st(): return "Q+" + P.st()
print(Q().v, Q.make(), Q().make(), Q.st())
class R(Q):
    v = property(Q.v.fget, lambda self, x: print("set", x))
r = R()
r.v = 5
print(r.v)
class L(list):
    def append(self, x):
        super().append(x * 2)
    def __getitem__(self, i): return ("got", super().__getitem__(i))
    def __repr__(self): return "L" + super().__repr__()
l = L([1, 2])
l.append(3)
print(l, l[0], len(l), l == [1, 2, 6], isinstance(l, list), l + [1], type(l + [1]).__name__, type(l[:]).__name__, sorted(l), list(l), type(l.copy()).__name__)
class Dd(dict):
    def __missing__(self, k): return k * 2
    def __setitem__(self, k, v): super().__setitem__(k, v + 1)
d = Dd(a=1)
d["b"] = 1
d.update(c=1)
print(d, d["zz"], d.get("zz"), "zz" in d, d.setdefault("e", 1), d["e"])
class I(int):
    def __add__(self, o): return I(int(self) + int(o) + 100)
    def __repr__(self): return f"I({int(self)})"
print(I(5) + 1, 1 + I(5), I(5) - 1, type(I(5) - 1).__name__, I(5) == 5, hash(I(5)) == hash(5), {5: "x"}[I(5)], I("12"), [I(1)], f"{I(3)}", f"{I(3):03d}", str(I(3)), "%d %s" % (I(3), I(4)), I(7) // 2, abs(I(-3)), -I(3), I(3) * 2, bool(I(0)), range(I(2)), [10, 20][I(1)])
class Fl(float):
    def __new__(cls, v): return super().__new__(cls, v * 2)
print(Fl(1.5), Fl(1.5) + 1, repr(Fl(0.25)), Fl(2).is_integer(), type(Fl(1) * 1).__name__)
class St(str):
    def __new__(cls, v, extra=None):
        s = super().__new__(cls, v)
        s.extra = extra
        return s
    def shout(self): return self.upper() + "!"
s = St("abc", extra=5)
print(s, repr(s), s.extra, s.shout(), s + "d", type(s + "d").__name__, s == "abc", {"abc": 1}[s], s[0], len(s), "".join([s, s]), type(str(s)).__name__, type(s.upper()).__name__, s in "xabcx", type(s[:]).__name__)
class Tp(tuple):
    def __new__(cls, *a): return super().__new__(cls, a)
    @property
    def first(self): return self[0]
tp = Tp(1, 2, 3)
print(tp, tp.first, tp == (1, 2, 3), hash(tp) == hash((1, 2, 3)), tp + (4,), type(tp[:2]).__name__, {(1, 2, 3): "t"}[tp], sorted([Tp(2), Tp(1)]), tp < (1, 2, 4))
class Ex(ValueError):
    def __init__(self, code, msg):
        super().__init__(msg)
        self.code = code
try:
    raise Ex(5, "bad")
except ValueError as e:
    print(e, e.code, e.args, repr(e))
class Ex2(Exception):
    def __str__(self): return "custom str"
t(lambda: (_ for _ in ()).throw(Ex2(1, 2)))
print(repr(Ex2(1, 2)), Ex2(1, 2).args, str(Ex2()), repr(Ex2()), repr(Ex2("a")))
class Se(set):
    pass
print(Se([1]) | {2}, type(Se([1]) | {2}).__name__, Se([1]) == {1}, repr(Se([1])), repr(Se()), repr(frozenset([1])), type(Se([1]).copy()).__name__)
class Slots:
    __slots__ = ("a", "b")
    def __init__(self): self.a = 1
class SubSlots(Slots):
    __slots__ = ("c",)
class SubDict(Slots): pass
x = SubSlots()
x.c = 3
print(x.a, x.c)
t(lambda: x.b)
t(lambda: setattr(x, "d", 1))
t(lambda: x.__dict__)
y = SubDict()
y.anything = 1
print(y.__dict__, y.a, Slots.__slots__, type(Slots.a).__name__)
def slotconf():
    class Z:
        __slots__ = ("a",)
        a = 1
t(slotconf)
def slotbad():
    class Z:
        __slots__ = ("1a",)
t(slotbad)
class Abs:
    def run(self): raise NotImplementedError
    def go(self): raise NotImplementedError("go!")
t(lambda: Abs().run())
t(lambda: Abs().go())
class Mix1:
    def __repr__(self): return f"{type(self).__name__}({', '.join(f'{k}={v!r}' for k, v in vars(self).items())})"
class Pt(Mix1):
    def __init__(self, x, y): self.x, self.y = x, y
print(Pt(1, "a"), [Pt(2, 3)], {"k": Pt(0, 0)})
