import copy
from copy import copy as c, deepcopy as dc
from dataclasses import dataclass, field
from collections import OrderedDict, defaultdict, deque, namedtuple, Counter
from enum import Enum

def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

l = [1, [2, 3], {"k": [4]}]
s, d = c(l), dc(l)
l[1].append(99); l[2]["k"].append(98); l.append("new")
print(l, s, d, s is l, s[1] is l[1], d[1] is l[1])
for v in (1, 1.5, "s", b"b", None, True, (1, 2), frozenset([1]), range(3), len, int, ..., 2 ** 70, 1j, lambda: 0):
    print(type(v).__name__, c(v) is v, dc(v) is v)
t1 = ([1], 2)
print(c(t1) is t1, dc(t1) is t1, dc(t1), dc(t1)[0] is t1[0], dc((1, (2, 3))) , {1: [2]} == dc({1: [2]}), sorted(dc({3, 1})), dc(bytearray(b"x")))
class A:
    def __init__(self, v): self.v, self.me = v, self
    def __repr__(self): return f"A({self.v})"
a = A([1, 2])
b, e = c(a), dc(a)
print(b.v is a.v, b.me is a, e.v is a.v, e.me is e, e, type(e).__name__)
class Sl:
    __slots__ = ("x", "y", "__z")
    def __init__(self): self.x, self.__z = [1], "private"
    def z(self): return self.__z
sl = Sl()
print(c(sl).x is sl.x, dc(sl).x is sl.x, dc(sl).x, hasattr(dc(sl), "y"), dc(sl).z())
class Cp:
    def __init__(self): self.n = 0
    def __copy__(self): return "copied"
    def __deepcopy__(self, memo): return ("deep", type(memo).__name__)
print(c(Cp()), dc(Cp()), dc([Cp()]), c([Cp()])[0].n)
r = [1]
r.append(r)
rr = dc(r)
print(rr, rr[1] is rr, rr is not r)
dd = {"self": None}
dd["self"] = dd
de = dc(dd)
print(de["self"] is de)
shared = [1]
pair = [shared, shared]
p2 = dc(pair)
print(p2[0] is p2[1], p2[0] is shared)
memo = {}
x = dc(shared, memo)
print(id(shared) in memo, memo[id(shared)] is x, dc(shared, memo) is x)
class L(list):
    def __init__(self, *a): super().__init__(*a); self.tag = [0]
q = L([1, [2]])
q2, q3 = c(q), dc(q)
print(type(q2).__name__, q2, q2.tag is q.tag, q3, q3.tag is q.tag, q3[1] is q[1])
class D(dict):
    pass
w = D(a=[1]); w.extra = [5]
print(c(w), type(dc(w)).__name__, dc(w).extra is w.extra, dc(w)["a"] is w["a"], c(w)["a"] is w["a"])
class I(int): pass
i = I(5); i.note = "n"
print(c(i), c(i).note, type(dc(i)).__name__, dc(i) + 1)
class S(str): pass
print(c(S("ab")), type(dc(S("ab"))).__name__)
class T(tuple): pass
print(dc(T([[1], 2])), type(c(T([1]))).__name__)
P = namedtuple("P", "a b")
p = P([1], 2)
print(c(p), dc(p), dc(p).a is p.a, type(dc(p)).__name__)
@dataclass
class Dc:
    a: list = field(default_factory=list)
    b: int = 1
z = Dc([1])
print(c(z) == z, c(z).a is z.a, dc(z) == z, dc(z).a is z.a)
@dataclass(frozen=True)
class Fr:
    a: list
print(dc(Fr([1])), c(Fr([1])))
o = OrderedDict(a=[1])
print(c(o), dc(o), dc(o)["a"] is o["a"], c(defaultdict(list, a=[1])), dc(defaultdict(list, a=[1])), c(deque([1, 2], 3)), dc(deque([[1]], maxlen=2)), dc(Counter("aab")), type(dc(Counter("a"))).__name__)
class Color(Enum):
    RED = 1
print(c(Color.RED) is Color.RED, dc(Color.RED) is Color.RED, dc([Color.RED])[0] is Color.RED)
class E(Exception):
    pass
ex = E("msg", [1]); ex.code = 5
print(repr(dc(ex)), dc(ex).code, dc(ex).args[1] is ex.args[1])
t(lambda: dc(x for x in []))
t(lambda: c(x for x in []))
t(lambda: dc({}.keys()))
class New:
    def __new__(cls, a): 
        self = super().__new__(cls)
        self.a = a
        return self
print(hasattr(copy, "copy"), copy.Error.__name__, issubclass(copy.Error, Exception), copy.error is copy.Error)
class State:
    def __init__(self): self.a, self.b = 1, 2
    def __getstate__(self): return {"a": 10}
    def __setstate__(self, st): self.__dict__.update(st); self.restored = True
st = c(State())
print(st.__dict__)
class Node:
    def __init__(self, v, parent=None):
        self.v, self.parent, self.kids = v, parent, []
        if parent: parent.kids.append(self)
root = Node(1); k1 = Node(2, root); k2 = Node(3, k1)
r2 = dc(root)
print(r2.kids[0].kids[0].parent.parent is r2, r2.kids[0] is k1, r2.kids[0].kids[0].v)
m = dc(A(5).__repr__)
print(m())
