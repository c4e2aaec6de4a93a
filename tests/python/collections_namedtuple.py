from collections import namedtuple
import collections

def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

P = namedtuple("P", ["x", "y"])
p = P(1, y=2)
print(p, p.x, p[1], p._fields, P._fields, p._asdict(), p._replace(x=10), P._make([5, 6]), p == (1, 2), p + (3,), p * 2, len(p), hash(p) == hash((1, 2)), isinstance(p, tuple), P.__name__, P.__doc__, P.__mro__[1:], list(p), max(p), sorted([P(2, 1), P(1, 5)]), p < P(1, 3), P.__match_args__, P.__slots__, repr(p), str(p), f"{p}", "%s" % (p,), p.count(1), p.index(2), p[:1], p[::-1], {p: 1}[(1, 2)], P.__module__)
x, y = p
print(x, y, P(*[7, 8]), P(**{"x": 1, "y": 2}), P(x=3, y=4), (lambda x, y: x + y)(*p), [a + b for a, b in [P(1, 2), P(3, 4)]], dict(zip(P._fields, p)))
print(namedtuple("A", "a b c")(1, 2, 3), namedtuple("B", "a, b")(1, 2), namedtuple("E", "")(), namedtuple("D", "a b c", defaults=(2, 3))(1), namedtuple("D", "a b", defaults=[1, 2])._field_defaults, namedtuple("R", "a def a 1x _p", rename=True)._fields)
for f in (lambda: P(1), lambda: P(), lambda: P(1, 2, 3), lambda: P(1, z=2), lambda: P(1, 2, x=3), lambda: P(y=1), lambda: P._make([1]), lambda: P._make([1, 2, 3]), lambda: p._replace(z=1), lambda: p.zz, lambda: p[5], lambda: P(1, 2, 3, 4, q=1)):
    t(f)
D = namedtuple("D", "a b c", defaults=(2, 3))
for f in (lambda: D(), lambda: D(1, 2, 3, 4), lambda: D(b=1), lambda: D(1, c=9), lambda: D(1, d=1)):
    t(f)
def s1(): p.x = 5
def s2(): del p.x
def s3(): p.new = 1
def s4(): p[0] = 1
for f in (s1, s2, s3, s4):
    t(f)
for f in (lambda: namedtuple("X", "a a"), lambda: namedtuple("X", "_a"), lambda: namedtuple("X", "class"), lambda: namedtuple("1X", "a"), lambda: namedtuple("X", "a-b"), lambda: namedtuple("def", "a"), lambda: namedtuple("X", "a", defaults=(1, 2)), lambda: namedtuple("X", [1]), lambda: namedtuple("X"), lambda: namedtuple("X", 5)):
    t(f)
class Pt(namedtuple("Pt", "x y")):
    __slots__ = ()
    def __add__(self, o): return Pt(self.x + o.x, self.y + o.y)
    @property
    def norm(self): return (self.x ** 2 + self.y ** 2) ** 0.5
    def __str__(self): return f"<{self.x},{self.y}>"
q = Pt(3, 4)
print(q, repr(q), q.norm, repr(q + q), q._replace(x=0), Pt._make((1, 2)), type(q._replace(x=1)).__name__, q == (3, 4), Pt.__bases__[0].__name__)
class Q(namedtuple("Base", "a b")):
    def __new__(cls, a, b=10): return super().__new__(cls, a * 2, b)
print(Q(1), Q(1, 2), Q(b=3, a=1))
match p:
    case P(x=1, y=yy): print("kw", yy)
match p:
    case P(a, b): print("pos", a, b)
match p:
    case (a, b): print("seq", a, b)
print(P(1, P(2, 3)), P([1], {"a": 1})._asdict(), P(None, "it's"), P._field_defaults, P(1, 2) is P(1, 2), P(1, 2) != P(1, 3), bool(P(0, 0)), bool(namedtuple("E", "")()), P.__new__.__qualname__, P._make.__qualname__)
class Own(namedtuple("Own", ["v"])):
    """Docs."""
print(Own.__doc__, Own(5), Own(5).v)
