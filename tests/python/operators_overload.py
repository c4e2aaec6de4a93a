def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

class V:
    def __init__(self, x): self.x = x
    def __repr__(self): return f"V({self.x})"
for name, sym in (("add", "+"), ("sub", "-"), ("mul", "*"), ("truediv", "/"), ("floordiv", "//"), ("mod", "%"), ("matmul", "@"), ("pow", "**"), ("and", "&"), ("or", "|"), ("xor", "^"), ("lshift", "<<"), ("rshift", ">>"), ("divmod", "divmod")):
    def fwd(self, o, s=sym): return f"{self}{s}{o}"
    def rev(self, o, s=sym): return f"{o} r{s} {self}"
    setattr(V, f"__{name}__", fwd)
    setattr(V, f"__r{name}__", rev)
a, b = V(1), V(2)
print(a + b, a - 1, 1 - a, a * b, a / 2, 2 / a, a // b, a % 2, "s" % a if False else "", a @ b, 1 @ a, a ** 2, 2 ** a, a & 1, 1 & a, a | b, a ^ b, a << 1, 1 >> a, divmod(a, 1), divmod(1, a), [1] + a, "x" + a, None + a, (1,) * a)
a += 5
print(a)
class U:
    def __neg__(self): return "neg"
    def __pos__(self): return "pos"
    def __invert__(self): return "inv"
    def __abs__(self): return "abs"
    def __round__(self, n=None): return ("round", n)
    def __trunc__(self): return 5
    def __floor__(self): return "floor"
    def __int__(self): return 7
    def __float__(self): return 2.5
    def __complex__(self): return 1j
    def __index__(self): return 3
    def __bool__(self): return False
    def __len__(self): return 9
    def __hash__(self): return 11
    def __str__(self): return "str!"
    def __bytes__(self): return b"by"
    def __contains__(self, x): return x == "in"
    def __call__(self, *a, **k): return a, k
    def __dir__(self): return ["b", "a"]
    def __length_hint__(self): return 3
    def __reversed__(self): return iter("rev")
    def __format__(self, s): return f"fmt[{s}]"
    def __sizeof__(self): return 1
u = U()
print(-u, +u, ~u, abs(u), round(u), round(u, 2), int(u), float(u), complex(u), bin(u), [0] * 2, bool(u), len(u), hash(u), str(u), bytes(u), "in" in u, 5 not in u, u(1, k=2), dir(u), list(reversed(u)), f"{u:x}", not u, hex(u), "abcd"[u], range(u), chr(U()) == "\x03", divmod(10, 3))
class Ip:
    def __init__(self): self.log = []
    def __iadd__(self, o): self.log.append(("i+", o)); return self
    def __isub__(self, o): return "replaced"
    def __imul__(self, o): return NotImplemented
    def __mul__(self, o): return "mul fallback"
i = Ip()
j = i
i += 1
i += [2]
print(i is j, i.log)
i *= 3
print(i)
j -= 1
print(j)
class C:
    def __init__(self, v): self.v = v
    def __lt__(self, o): print("lt", end=" "); return self.v < o.v
    def __eq__(self, o): print("eq", end=" "); return isinstance(o, C) and self.v == o.v
    def __repr__(self): return f"C{self.v}"
print(C(1) < C(2), C(1) > C(2), C(1) == C(1), C(1) != C(1), C(1) == 5, C(1) != 5, sorted([C(3), C(1), C(2)]), min(C(2), C(1)), max([C(1), C(3)]), C(1) in [C(2), C(1)], [C(1)] == [C(1)], [C(1)].index(C(1)), [C(1), C(1)].count(C(1)))
t(lambda: C(1) <= C(2))
t(lambda: hash(C(1)))
t(lambda: {C(1)})
class NI:
    def __add__(self, o): return NotImplemented
    def __eq__(self, o): return NotImplemented
    def __lt__(self, o): return NotImplemented
t(lambda: NI() + 1)
t(lambda: NI() < 1)
t(lambda: NI() == 1)
n = NI()
print(n == n, n != n)
class P:
    def __add__(self, o): return "P+"
    def __radd__(self, o): return "P r+"
class Q(P):
    def __radd__(self, o): return "Q r+"
class R(P): pass
print(P() + Q(), P() + R(), Q() + P(), P() + P(), P() + 1, 1 + P())
class S:
    def __eq__(self, o): return "truthy eq"
    def __ne__(self, o): return []
    def __lt__(self, o): return None
    __hash__ = None
print(S() == 1, S() != 1, S() < 1, 1 == S(), 1 > S(), [S()] == [1], S() in [5])
class Seq:
    def __getitem__(self, i):
        if i >= 4: raise IndexError(i)
        return i * 10
print(list(Seq()), 20 in Seq(), 25 in Seq(), [*Seq()], tuple(zip(Seq(), "ab")), sum(Seq()), max(Seq()), list(iter(Seq())), dict(enumerate(Seq())))
t(lambda: list(reversed(Seq())))
class Seq2(Seq):
    def __len__(self): return 4
print(list(reversed(Seq2())), bool(Seq2()))
class Cont:
    def __init__(self): self.d = {}
    def __getitem__(self, k): return self.d.get(k, ("none", k))
    def __setitem__(self, k, v): self.d[k] = v
    def __delitem__(self, k): print("del", k); self.d.pop(k, None)
    def __len__(self): return len(self.d)
    def __iter__(self): return iter(self.d)
    def __contains__(self, k): return k in self.d
c = Cont()
c[1] = "a"
c[1, 2] = "t"
c["x"] = 1
c["x"] += 5
del c["q"]
print(c[1], c[1, 2], c["x"], c[5], len(c), list(c), 1 in c, 7 in c, c[1:2] if False else c[...])
class BadLen:
    def __len__(self): return -1
class BadLen2:
    def __len__(self): return "a"
class BadBool:
    def __bool__(self): return 1
class BadIndex:
    def __index__(self): return "x"
class BadStr:
    def __str__(self): return 5
    def __repr__(self): return 6
class BadHash:
    def __hash__(self): return "h"
class BadIter:
    def __iter__(self): return 5
class BadFloat:
    def __float__(self): return 1
class BadInt:
    def __int__(self): return 1.5
class BadContains:
    def __contains__(self, x): raise ValueError("no contains")
class HugeLen:
    def __len__(self): return 2 ** 70
for f in (lambda: len(BadLen()), lambda: len(BadLen2()), lambda: bool(BadLen()), lambda: bool(BadBool()), lambda: [1][BadIndex()], lambda: str(BadStr()), lambda: repr(BadStr()), lambda: hash(BadHash()), lambda: iter(BadIter()), lambda: float(BadFloat()), lambda: int(BadInt()), lambda: 1 in BadContains(), lambda: f"{BadStr()}", lambda: f"{BadStr()!r}", lambda: print(BadStr()), lambda: [BadStr()].__repr__(), lambda: "%s" % BadStr(), lambda: len(HugeLen()), lambda: bool(V(1) and 0)):
    t(f)
class H:
    def __init__(self, v): self.v = v
    def __hash__(self): return self.v % 3
    def __eq__(self, o): return isinstance(o, H) and self.v == o.v
print(len({H(1), H(4), H(1), H(7)}), {H(1): "a", H(4): "b"}[H(4)], H(1) in {H(4)}, hash(H(5)))
class BigHash:
    def __hash__(self): return 2 ** 61
class NegHash:
    def __hash__(self): return -1
print(hash(BigHash()), hash(NegHash()))
class Pw:
    def __pow__(self, o, m=None): return ("pow", o, m)
    def __rpow__(self, o): return ("rpow", o)
    def __ipow__(self, o): return ("ipow", o)
p = Pw()
print(p ** 2, pow(p, 2, 3), 2 ** p)
p **= 4
print(p)
class G:
    def __gt__(self, o): return "gt"
    def __ge__(self, o): return "ge"
print(G() > 1, 1 < G(), 1 <= G())
t(lambda: G() < 1)
class Ch:
    def __init__(self, n): self.n = n
    def __lt__(self, o): print(f"{self.n}<{o.n}", end=" "); return self.n < o.n
x, y, z = Ch(1), Ch(3), Ch(2)
print(x < y < z, y < x < z, x < z < y)
