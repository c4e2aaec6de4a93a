from dataclasses import dataclass, field, fields, asdict, astuple, replace, is_dataclass, make_dataclass, FrozenInstanceError, MISSING, KW_ONLY, InitVar, Field
from typing import ClassVar, List, Optional
import dataclasses

def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

@dataclass
class Point:
    x: int
    y: int = 0
    tags: list = field(default_factory=list)
    def norm(self): return abs(self.x) + abs(self.y)
p, q = Point(1), Point(1, 2, ["a"])
p.tags.append("t")
print(p, q, Point(3).tags, p.norm(), p == Point(1, 0, ["t"]), p == q, p != q, p == (1, 0, ["t"]), Point(x=5, y=6), Point.y, hasattr(Point, "x"), hasattr(Point, "tags"), Point.__match_args__, Point.__doc__, Point.__init__.__qualname__, Point.__eq__.__name__)
for f in (lambda: Point(), lambda: Point(1, 2, [], 4), lambda: Point(z=1), lambda: Point(1, x=2), lambda: Point(1, 2, 3, 4, 5), lambda: Point(y=1), lambda: hash(p), lambda: p < q, lambda: Point(1, 2, 3, bad=1)):
    t(f)
@dataclass(order=True, frozen=True)
class V:
    a: float
    b: str = "z"
    c: Optional[int] = field(default=None, compare=False, repr=False)
v, w = V(1.5), V(1.5, "a", 9)
print(v, w, v > w, v >= w, v < w, v <= w, hash(v) == hash(V(1.5)), v == V(1.5, c=3), sorted([v, w, V(0)]), {v: 1}[V(1.5)], max(v, w), V.__doc__)
def setv(): v.a = 3
def delv(): del v.a
def newv(): v.zz = 1
for f in (setv, delv, newv, lambda: v < 5, lambda: V()):
    t(f)
print(issubclass(FrozenInstanceError, AttributeError))
@dataclass
class Base:
    i: int = 1
    j: int = 2
    kind: ClassVar[str] = "base"
@dataclass
class Child(Base):
    k: int = 3
    i: float = 9.5
    def __post_init__(self): self.total = self.i + self.j + self.k
c = Child()
print(c, c.total, Child(1, 2, 3), Child.kind, [f.name for f in fields(c)], [f.type.__name__ for f in fields(Child)], [f.default for f in fields(Base)], Child.__match_args__, isinstance(c, Base), c == Base(), vars(c))
@dataclass
class Kw:
    a: int
    _: KW_ONLY
    b: int
    c: int = 5
k = Kw(1, b=2)
print(k, Kw.__match_args__, Kw.__doc__)
for f in (lambda: Kw(1), lambda: Kw(1, 2), lambda: Kw(1, 2, b=3), lambda: Kw(), lambda: Kw(b=1)):
    t(f)
@dataclass(kw_only=True)
class AllKw:
    a: int
    b: int = 2
    c: int = field(default=3, kw_only=False)
print(AllKw(7, a=1), AllKw(a=1))
t(lambda: AllKw(1, 2, a=3))
t(lambda: AllKw(1))
@dataclass
class Inv:
    base: int
    scale: InitVar[int] = 2
    result: int = field(init=False)
    log: list = field(init=False, default_factory=list, repr=False)
    const: int = field(init=False, default=7)
    def __post_init__(self, scale):
        self.result = self.base * scale
        self.log.append(scale)
i = Inv(5, 3)
print(i, i.log, i.const, Inv(2), [f.name for f in fields(Inv)], Inv.scale, asdict(i))
t(lambda: Inv(1, 2, 3))
t(lambda: replace(i, base=1))
print(replace(i, base=1, scale=10))
t(lambda: replace(i, scale=1, result=5))
print(replace(p, x=10), replace(p) == p, replace(p) is p, replace(v, b="new"))
t(lambda: replace(5))
t(lambda: replace(p, nope=1))
@dataclass(slots=True)
class S:
    a: int
    b: int = 2
s = S(1)
print(s, S.__slots__, hasattr(s, "__dict__"), S(1) == s)
def sets(): s.zz = 1
t(sets)
@dataclass(frozen=True, slots=True)
class FS:
    a: int = 1
fs = FS(3)
print(fs, hash(fs) == hash(FS(3)))
@dataclass(unsafe_hash=True)
class UH:
    a: int
    b: list = field(hash=False, default_factory=list)
print(hash(UH(1)) == hash(UH(1, [2])), {UH(1): "x"}[UH(1)])
@dataclass(eq=False)
class NoEq:
    a: int
n = NoEq(1)
print(n == n, n == NoEq(1), hash(n) == hash(n))
@dataclass(repr=False, init=False)
class Own:
    a: int
    def __init__(self): self.a = 99
    def __repr__(self): return f"own {self.a}"
print(Own(), Own() == Own())
@dataclass
class Custom:
    a: int
    def __eq__(self, o): return "custom eq"
    def __repr__(self): return "custom repr"
print(Custom(1) == 5, Custom(1))
@dataclass
class Tree:
    v: int
    kids: List["Tree"] = field(default_factory=list)
    parent: "Tree" = None
tr = Tree(1, [Tree(2), Tree(3, [Tree(4)])])
print(tr)
tr.kids[0].parent = tr
print(tr)
print(asdict(Tree(1, [Tree(2)])), astuple(Tree(1, [Tree(2)])), asdict(p, dict_factory=lambda kv: sorted(kv)), astuple(p, tuple_factory=list))
@dataclass
class Holder:
    d: dict
    t: tuple
    n: object = None
h = Holder({"k": Point(1)}, (Point(2), [Point(3)]))
a = asdict(h)
print(a, a["d"] is h.d, astuple(h))
for f in (lambda: asdict(Point), lambda: asdict(5), lambda: astuple(5), lambda: fields(5), lambda: fields(int)):
    t(f)
print(is_dataclass(Point), is_dataclass(p), is_dataclass(5), is_dataclass(int))
def bad1():
    @dataclass
    class X:
        a: int = 1
        b: int
def bad2():
    @dataclass
    class X:
        a: list = []
def bad3():
    @dataclass
    class X:
        a = field()
def bad4():
    @dataclass(frozen=True)
    class X(Point): pass
def bad5():
    @dataclass
    class X(V): pass
def bad6():
    @dataclass(order=True, eq=False)
    class X: pass
def bad7():
    @dataclass(order=True)
    class X:
        def __lt__(self, o): pass
def bad8():
    @dataclass(slots=True)
    class X:
        __slots__ = ("a",)
        a: int
def bad9():
    @dataclass(frozen=True)
    class X:
        def __setattr__(self, n, v): pass
def bad10():
    @dataclass(unsafe_hash=True)
    class X:
        def __hash__(self): return 1
def bad11():
    @dataclass
    class X:
        a: ClassVar[list] = field(default_factory=list)
def bad12():
    @dataclass
    class X:
        a: int
        _: KW_ONLY
        b: int
        __: KW_ONLY
def bad13():
    @dataclass
    class X:
        a: dict = {}
def bad14():
    field(default=1, default_factory=int)
def bad15():
    @dataclass(bogus=1)
    class X: pass
def bad16():
    @dataclass
    class X:
        a: Point = Point(1)
def bad17():
    @dataclass
    class X(Base):
        z: int
for f in (bad1, bad2, bad3, bad4, bad5, bad6, bad7, bad8, bad9, bad10, bad11, bad12, bad13, bad14, bad15, bad16, bad17):
    t(f)
M = make_dataclass("M", ["a", ("b", int), ("c", int, 5), ("d", list, field(default_factory=list))], bases=(Base,) if False else (), namespace={"twice": lambda self: self.b * 2})
m = M(1, 2)
print(m, m.twice(), M.__name__, M.__annotations__)
t(lambda: make_dataclass("N", ["a", "a"]))
t(lambda: make_dataclass("N", ["for"]))
t(lambda: make_dataclass("N", ["1x"]))
t(lambda: make_dataclass("N", [("a", int, 1, 2)]))
f = fields(Point)[1]
print(f.name, f.type, f.default, f.default_factory is MISSING, f.init, f.repr, f.hash, f.compare, f.metadata, f.kw_only, fields(Point)[2].default_factory)
@dataclass
class Meta:
    a: int = field(default=1, metadata={"unit": "m"})
print(fields(Meta)[0].metadata["unit"], fields(Meta)[0].metadata)
match Point(1, 2):
    case Point(0, y): print("no", y)
    case Point(x, y): print("yes", x, y)
match Kw(1, b=2):
    case Kw(a, b=b): print(a, b)
@dataclass
class Outer:
    @dataclass
    class Inner:
        v: int = 1
    i: Inner = field(default_factory=Inner)
print(Outer(), Outer.Inner(), Outer.Inner.__doc__, Outer.__doc__)
@dataclass
class Prop:
    _w: float = 1.0
    @property
    def w(self): return self._w * 2
    @classmethod
    def make(cls, w): return cls(w)
    @staticmethod
    def unit(): return "m"
print(Prop.make(4).w, Prop.unit(), Prop())
class Mixin:
    def describe(self): return f"{type(self).__name__} with {len(fields(self))} fields"
@dataclass
class Mixed(Mixin):
    a: int = 1
    b: int = 2
print(Mixed().describe())
@dataclass
class Empty: pass
print(Empty(), Empty() == Empty(), fields(Empty), Empty.__doc__)
t(lambda: Empty(1))
@dataclass
class One:
    x: float
nan = float("nan")
print(One(nan) == One(nan), One(float("nan")) == One(float("nan")), One(1) == One(1.0))
@dataclass
class Sup(Point):
    z: int = 0
    def __post_init__(self): self.super_called = True
print(Sup(1, 2, [], 3), Sup(1) == Point(1), Sup(1).super_called)
@dataclass(order=True)
class Prio:
    prio: int
    item: object = field(compare=False)
print(sorted([Prio(3, "c"), Prio(1, {}), Prio(2, None)]), min(Prio(1, "a"), Prio(1, "b")))
print(dataclasses.dataclass is dataclass, Point.__dataclass_fields__["x"].name, Point.__init__.__annotations__, repr(V.__dataclass_params__))
