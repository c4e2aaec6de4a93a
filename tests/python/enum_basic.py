from enum import Enum, IntEnum, StrEnum, auto, unique, EnumMeta, EnumType, member, nonmember, verify, UNIQUE, CONTINUOUS, ReprEnum
import enum

def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

class C(Enum):
    "Doc of C"
    RED = 1
    GREEN = 2
    CRIMSON = 1
    def shout(self): return self.name + "!"
    @property
    def double(self): return self.value * 2
    @classmethod
    def first(cls): return cls.RED
    @staticmethod
    def stat(): return "static"
    def __call__(self, x): return (self.name, x)
print(C.RED, repr(C.RED), C.RED.name, C.RED.value, C(2), C["RED"], C.CRIMSON, C.CRIMSON is C.RED, C(1) is C.RED, C(C.RED) is C.RED, list(C), len(C), C.RED in C, C.RED.shout(), C.GREEN.double, C.first(), C.stat(), C.RED("x"), C.__doc__, C.__name__, repr(C), str(C), type(C.RED), type(C).__name__, isinstance(C.RED, C), C.RED.__class__ is C)
print(C.__members__, list(C.__members__.items()), list(reversed(C)), C.RED == C.RED, C.RED == 1, C.RED != C.GREEN, C.RED is C.RED, {C.RED: "r"}[C.CRIMSON], hash(C.RED) == hash("RED"), bool(C.RED), f"{C.RED}", f"{C.RED:>8}", "%s" % C.RED, "{!r}".format(C.RED), f"{C.RED!r}", [C.RED], (C.GREEN,), {"k": C.RED}, sorted(C, key=lambda c: -c.value), C.RED.GREEN)
for f in (lambda: C(3), lambda: C("x"), lambda: C["Q"], lambda: C.Q, lambda: 1 in C, lambda: C.RED < C.GREEN, lambda: C.RED + 1, lambda: C.RED.foo, lambda: setattr(C, "RED", 5), lambda: delattr(C, "GREEN"), lambda: setattr(C.RED, "value", 5), lambda: setattr(C.RED, "name", 5), lambda: C(), lambda: C([1]), lambda: C(None), lambda: unique(C), lambda: verify(UNIQUE)(C), lambda: C.RED.value.foo, lambda: sorted(C)):
    t(f)
C.RED.note = "extra"
C.NEW = 5
print(C.RED.note, C.NEW, len(C), dir(C)[:2], "RED" in dir(C), [x for x in dir(C.RED) if not x.startswith("_")])
class A(Enum):
    X = auto()
    Y = auto()
    Z = 10
    W = auto()
print(list(A), [a.value for a in A])
class S(StrEnum):
    LOW = auto()
    HIGH = "high!"
print(S.LOW, repr(S.LOW), S.LOW == "low", S.HIGH.upper(), f"{S.LOW:>6}", S("low"), "x" + S.LOW, S.LOW in ("low",), {"low": 1}[S.LOW], len(S.HIGH), S.LOW + "er", str(S.LOW), "".join(S), isinstance(S.LOW, str), sorted(S))
class I(IntEnum):
    ONE = 1
    TWO = 2
    UNO = 1
print(I.ONE, repr(I.ONE), I.ONE + 1, I.ONE < I.TWO, I.ONE == 1, I(2), f"{I.TWO}", f"{I.TWO:03d}", "%d" % I.TWO, "%s" % I.TWO, str(I.ONE), [10, 20, 30][I.ONE], max(I), sum(I), sorted([I.TWO, I.ONE]), int(I.TWO), I.ONE | I.TWO, I.TWO ** 3, -I.ONE, I.TWO / 4, hash(I.ONE) == hash(1), {1: "a"}[I.ONE], I.TWO.bit_length(), range(I.TWO), I.UNO, 1 in [I.ONE], bool(I(1)), I["TWO"], isinstance(I.ONE, int), round(I.TWO), divmod(I.TWO, 2))
t(lambda: I(5))
t(lambda: I("1"))
class M(str, Enum):
    A = "a"
    B = "b"
print(M.A, repr(M.A), M.A == "a", M.A + "c", f"{M.A}", M("b"), M.A.value, M.A.upper(), "%s" % M.A, M.A < M.B, {"a": 1}[M.A], format(M.A), json if False else "-")
class Fl(float, Enum):
    PI = 3.14
    E = 2.71
print(Fl.PI, repr(Fl.PI), Fl.PI * 2, Fl.PI > Fl.E, round(Fl.PI, 1), f"{Fl.PI}")
class Planet(Enum):
    EARTH = (5.97, 6.37)
    MARS = (0.64, 3.39)
    def __init__(self, mass, radius):
        self.mass = mass
        self.radius = radius
    @property
    def density(self): return round(self.mass / self.radius, 3)
print(Planet.EARTH, Planet.EARTH.mass, Planet.MARS.density, Planet.EARTH.value, Planet((0.64, 3.39)), repr(Planet.MARS))
class Coord(bytes, Enum):
    def __new__(cls, value, label):
        obj = bytes.__new__(cls, [value])
        obj._value_ = value
        obj.label = label
        return obj
    PX = (0, "P.X")
    PY = (1, "P.Y")
print(Coord.PY, Coord.PY.label, Coord(1), Coord.PY.value)
class Auto(Enum):
    def _generate_next_value_(name, start, count, last): return f"{name}-{start}-{count}-{last}"
    P = auto()
    Q = auto()
print(list(Auto))
class Miss(Enum):
    A = 1
    OTHER = 99
    @classmethod
    def _missing_(cls, value):
        if value == "bad": return 5
        if value == "err": raise KeyError("custom")
        if value == "none": return None
        return cls.OTHER
print(Miss(1), Miss(50), Miss([1]))
for v in ("bad", "err", "none"):
    t(lambda: Miss(v))
class Cmp(Enum):
    LOW, MID, HIGH = range(3)
    def __lt__(self, o): return self.value < o.value
    def __str__(self): return f"<{self.name.lower()}>"
    def __eq__(self, o): return self is o
    def __hash__(self): return 5
print(sorted(Cmp, reverse=True), max(Cmp), str(Cmp.LOW), f"{Cmp.MID:>7}", Cmp.LOW)
Animal = Enum("Animal", "ANT BEE CAT")
print(list(Animal), Animal.ANT, Animal.__module__, list(Enum("L", ["A", "B"], start=0)), list(Enum("P", [("A", 5), ("B", 6)])), list(Enum("D", {"A": "x"})), list(IntEnum("I2", "A,B")), list(Enum("T", "A B", type=str)), Enum("E", []), list(StrEnum("SE", "Aa Bb")))
class Base(Enum):
    def hi(self): return f"hi {self.name}"
class Derived(Base):
    A = 1
print(Derived.A.hi(), issubclass(Derived, Base), isinstance(Derived.A, Base), Derived.A)
def e1():
    class X(C): pass
def e2():
    class X(Enum):
        A = 1
        A = 2
def e3():
    class X(Enum):
        A = 1
        def A(self): pass
def e4():
    class X(Enum):
        _bad_ = 1
def e5():
    class X(Enum, int):
        A = 1
def e6():
    @unique
    class X(Enum):
        A = 1
        B = 1
        D = 1
def e7():
    class X(IntEnum):
        A = "x"
def e8():
    class X(StrEnum):
        A = 1
def e9():
    @verify(CONTINUOUS)
    class X(Enum):
        A = 1
        B = 4
def e10():
    class X(Enum):
        mro = 1
def e11():
    class X(Enum):
        A = "a"
        B = auto()
def e12():
    class X(int, str, Enum):
        A = 1
def e13():
    class X(Planet): pass
def e14():
    class X(Enum):
        A = 1, 2
        def __init__(self, a): self.a = a
for f in (e1, e2, e3, e4, e5, e6, e7, e8, e9, e10, e11, e13, e14):
    t(f)
class Mixed(Enum):
    A = 1
    f = lambda self: "func"
    helper = nonmember(5)
    wrapped = member("wrapped")
    _private = 3
    __dunder_like = 4
    class Nested: pass
print([m.name for m in Mixed if m.name not in ("Nested",)], Mixed.A.f(), Mixed.helper, Mixed.wrapped, Mixed._private, Mixed.A._Mixed__dunder_like)
class Ig(Enum):
    _ignore_ = "tmp i"
    tmp = 5
    A = tmp + 1
    for i in range(2): pass
print(list(Ig))
class Shape(Enum):
    SQUARE = "sq"
    CIRCLE = "ci"
def area(s):
    match s:
        case Shape.SQUARE: return "square"
        case Shape.CIRCLE: return "circle"
print(area(Shape.CIRCLE), {s: s.value for s in Shape}, Shape.SQUARE.name.title(), [s.name for s in Shape], [s for s in Shape if s is not Shape.SQUARE], dict(Shape.__members__), "SQUARE" in Shape.__members__, Shape._member_names_, Shape._value2member_map_)
class Names(Enum):
    name = 1
    value = 2
print(Names.name, Names.value, Names.name.name, Names.value.value)
class Un(Enum):
    A = [1, 2]
    B = {"k": 1}
    D = [1, 2]
print(list(Un), Un([1, 2]), Un.D is Un.A, Un({"k": 1}))
t(lambda: Un([9]))
class Order(Enum):
    _order_ = "A B"
    A = 1
    B = 2
print(list(Order))
def bo():
    class X(Enum):
        _order_ = "B A"
        A = 1
        B = 2
t(bo)
class Dc:
    def __init__(self, v): self.v = v
    def __repr__(self): return f"Dc({self.v})"
class Objs(Enum):
    A = Dc(1)
    B = Dc(2)
print(Objs.A, repr(Objs.A), Objs.B.value.v)
class Bools(Enum):
    YES = True
    NO = False
    ALSO = 1
print(list(Bools), Bools(1), Bools(0), Bools.ALSO)
class ZeroE(Enum):
    Z = 0
    N = None
    def __bool__(self): return bool(self.value)
print(bool(ZeroE.Z), ZeroE.N, ZeroE(None), bool(C.RED))
class Op(Enum):
    ADD = "+"
    MUL = "*"
    def apply(self, a, b):
        return {Op.ADD: lambda: a + b, Op.MUL: lambda: a * b}[self]()
    @classmethod
    def parse(cls, s):
        for m in cls:
            if m.value == s: return m
        raise ValueError(s)
print(Op.ADD.apply(2, 3), Op.parse("*").apply(2, 3), Op("+"), EnumMeta is EnumType, isinstance(C, EnumType), issubclass(IntEnum, ReprEnum), enum.Enum is Enum)
class Tup(Enum):
    A = (1, auto())
    B = ("b", 2)
print([x.value for x in Tup])
for i, c in enumerate(C): print(i, c.name, end=" ")
print(*zip(C, "ab"), set(C) == {C.RED, C.GREEN}, C.GREEN in {C.RED, C.GREEN}, tuple(C))
