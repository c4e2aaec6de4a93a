from enum import Flag, IntFlag, auto, STRICT, CONFORM, EJECT, KEEP, FlagBoundary, verify, NAMED_FLAGS, CONTINUOUS, EnumCheck, Enum
def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

class F(Flag):
    R = auto()
    W = auto()
    X = auto()
    RW = R | W
print(list(F), F.R | F.X, repr(F(0)), str(F(0)), bool(F(0)), str(F.R | F.X), F.RW, F(3), list(F.RW), len(F.RW), F.R in F.RW, F.RW in F.R, F(-1), ~F.R, ~F.RW, F.R ^ F.RW, F.R & F.W, F.R == 1, F.RW.name, F(0).name, (F.R | F.X).name, (F.R | F.X).value, F.R | F.W is F.RW, (F.R | F.W) is F.RW, (F.R | F.X) is (F.X | F.R), [m.name for m in F], F["R"], F.__members__, len(F), repr(F), bool(F.R), F.R.value, ~F(0), ~F(7), f"{F.R}", f"{F.R|F.X}", F(5), {F.R: 1}, hash(F.R) == hash("R"), list(F.R | F.X), F.R | F.W | F.X)
for f in (lambda: F(8), lambda: F("x"), lambda: F(1.5), lambda: F.R | 1, lambda: 1 in F.R, lambda: F.R < F.W, lambda: F.R + 1, lambda: F.Q, lambda: F.R | "x", lambda: F(-9)):
    t(f)
class P(IntFlag):
    X = 1
    W = 2
    R = 4
    ALL = 7
print(P.R | P.W, P(8), P(7), P.ALL, str(P.R), ~P.R, P.R | 8, P.R + 1, P(-1), P.R & 4, f"{P.R | P.W}", repr(P(0)), repr(P(12)), (P.R | 8).name, P.R == 4, P.R < 5, list(P(6)), P.R in P.ALL, P.R ^ 1, 1 | P.R, 6 & P.R, int(P.R), isinstance(P.R, int), P.R | P.X == 5, [p for p in P], len(P), P.ALL.name, P(3), P.W << 1, type(P.R | 8).__name__, type(P.R + 1).__name__, P.X * 2, sum(P), max(P), sorted([P.R, P.X]), P(6) & ~P.W, "%d" % P.R, f"{P.R:04b}", P.R.bit_length(), -P.R, P(16) | P.R, ~P(0))
class St(Flag, boundary=STRICT):
    A = 1
    B = 2
class Co(Flag, boundary=CONFORM):
    A = 1
    B = 2
class Ej(Flag, boundary=EJECT):
    A = 1
    B = 2
class Ke(Flag, boundary=KEEP):
    A = 1
    B = 2
t(lambda: St(5))
print(Co(5), Ej(5), type(Ej(5)).__name__, Ke(5), Ke(8), Co(8), ~Ke.A, ~Ej.A, ~Co.A, Ke.A | Ke(4), Ke(-1), FlagBoundary.KEEP, repr(STRICT), list(FlagBoundary), list(EnumCheck))
class Zero(Flag):
    NONE = 0
    A = auto()
    B = auto()
    BOTH = A | B
print(list(Zero), Zero.NONE, Zero(0), Zero.NONE.name, Zero.A & Zero.B, Zero.BOTH, Zero.A | Zero.NONE, bool(Zero.NONE), Zero.__members__)
class Gap(Flag):
    A = 1
    C = 4
    M = 12
print(list(Gap), Gap.M, Gap.A | Gap.M, Gap._flag_mask_, Gap._singles_mask_)
t(lambda: Gap(2))
t(lambda: Gap(8))
t(lambda: Gap.M & Gap(13))
class Back(Flag):
    Z = 8
    Y = 2
    X = 4
print(list(Back), list(Back.Z | Back.Y | Back.X), Back.Z | Back.Y, ~Back.Y)
def bad():
    @verify(NAMED_FLAGS)
    class X(Flag):
        A = 1
        B = 6
t(bad)
def bad2():
    @verify(CONTINUOUS)
    class X(Flag):
        A = 1
        B = 8
t(bad2)
def bad3():
    class X(Flag):
        A = "x"
        B = auto()
t(bad3)
class Meth(Flag):
    A = auto()
    B = auto()
    def names(self): return [m.name for m in self]
    @property
    def count(self): return len(self)
    @classmethod
    def all(cls):
        r = cls(0)
        for m in cls: r |= m
        return r
print((Meth.A | Meth.B).names(), Meth.all(), Meth.all().count, Meth.all() == Meth.A | Meth.B)
x = Meth.A
x |= Meth.B
print(x)
x &= ~Meth.A
print(x)
x ^= Meth.A
print(x, Flag("G", "a b c"), list(Flag("G", "a b c")), list(IntFlag("H", ["a", "b"])), Meth.A.__or__(5), issubclass(Flag, Enum))
