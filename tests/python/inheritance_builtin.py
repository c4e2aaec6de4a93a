class Stack(list):
    def push(self, *v): self.extend(v); return self
    def peek(self): return self[-1]
    def __contains__(self, v): print("contains", v); return super().__contains__(v)
    def __len__(self): return super().__len__() * 1
s = Stack([1]).push(2, 3)
print(s, s.peek(), 2 in s, len(s), s[0], s[1:], type(s[1:]).__name__, s.pop(), sorted(s, reverse=True), s + [9], type(s + [9]).__name__, [*s], isinstance(s, list), s == [1, 2], Stack("ab"), bool(Stack()), s.copy(), type(s.copy()).__name__, repr(Stack()), str(s), list(reversed(s)))
class Attr(dict):
    __getattr__ = dict.__getitem__
    __setattr__ = dict.__setitem__
    __delattr__ = dict.__delitem__
a = Attr(x=1)
a.y = 2; a["z"] = 3
del a.x
print(a, a.y, a.z, "y" in a, a | {"q": 1}, type(a | {}).__name__, dict(a), {**a}, a.keys(), len(a), a == {"y": 2, "z": 3}, a.get("nope"), list(a))
try: a.nope
except KeyError as e: print(repr(e))
class Upper(dict):
    def __setitem__(self, k, v): super().__setitem__(k.upper(), v)
    def __getitem__(self, k): return super().__getitem__(k.upper())
    def __contains__(self, k): return super().__contains__(k.upper())
    def __missing__(self, k): return f"missing {k}"
u = Upper(a=1)
u["b"] = 2
print(u, u["b"], "b" in u, u.get("B"), u.get("b"), u["zz"], Upper([("k", 1)]), u.setdefault("c", 3), u, u.update(d=4), u, u.pop("B"))
class Temp(float):
    unit = "C"
    def __new__(cls, v, unit="C"):
        self = super().__new__(cls, v)
        self.unit = unit
        return self
    def __add__(self, o): return Temp(float(self) + float(o), self.unit)
    def __str__(self): return f"{float(self):.1f}°{self.unit}"
t = Temp(20.55, "F")
print(t, repr(t), t + 1, t - 1, type(t - 1).__name__, t > 20, round(t, 1), int(t), f"{t}", f"{t:.3f}", sum([t, t]), max(t, 5.0) is t, hash(t) == hash(20.55), {t: 1}[20.55], t == 20.55, [t], abs(Temp(-1)), -t, bool(Temp(0)))
class Id(int):
    def __new__(cls, v): return super().__new__(cls, int(v) % 100)
    def __repr__(self): return f"Id<{int(self)}>"
    def __eq__(self, o): return int(self) == int(o) % 100
    __hash__ = int.__hash__
i = Id("1234")
print(i, str(i), i + 1, i == 134, hash(i), [i], {i: "x"}[34], i.bit_length(), range(i)[-1], "%d" % i, f"{i:04}", f"{i!r}", [0] * Id(3), i in [134], int.__repr__(i), i // 5, divmod(i, 10), i ** 2, -i, i < 50)
class Name(str):
    def __new__(cls, s): return super().__new__(cls, s.strip().title())
    def __eq__(self, o): return self.lower() == o.lower()
    def __hash__(self): return hash(self.lower())
    def __add__(self, o): return Name(str(self) + " " + o)
    def __len__(self): return 99
n = Name("  john ")
print(n, n == "JOHN", n + "smith", type(n + "x").__name__, len(n), n[0], n.upper(), type(n.upper()).__name__, {n: 1}["john"] if False else n in {Name("JOHN"): 1}, "-".join([n, n]), n.replace("J", "K"), f"{n:>8}", "%s" % n, n in ["john"], sorted([Name("b"), Name("a")]), repr(n), n.split("h"), n * 2, "oh" in n, list(n))
class Pair(tuple):
    def __new__(cls, a, b): return super().__new__(cls, (a, b))
    a = property(lambda s: s[0])
    def __add__(self, o): return Pair(self[0] + o[0], self[1] + o[1])
    def __repr__(self): return f"<{self[0]}|{self[1]}>"
p = Pair(1, 2)
print(p, p.a, p + (1, 1), p == (1, 2), hash(p) == hash((1, 2)), [*p], p[::-1], type(p[:]).__name__, p * 2, len(p), 2 in p, {p: 1}[(1, 2)], max(p), sorted([Pair(2, 1), Pair(1, 9)]), "%s-%s" % p, str(p), (lambda a, b: a - b)(*p), isinstance(p, tuple))
x, y = p
print(x, y)
class Tags(set):
    def add(self, v): super().add(v.lower())
    def __or__(self, o): return Tags(super().__or__(o))
g = Tags(["A"])
g.add("B"); g |= {"q"}
print(sorted(g), type(g).__name__, sorted(g | {"z"}), type(g | {"z"}).__name__, type(g & {"A"}).__name__, type(g - {"A"}).__name__, type(g.union([1])).__name__, len(g), g == {"A", "b", "q"}, repr(Tags()), isinstance(g, set))
class Err(ValueError, KeyError):
    def __init__(self, msg, *, code): super().__init__(msg); self.code = code
    def __str__(self): return f"{super().__str__()} [{self.code}]"
for kind in (ValueError, KeyError, LookupError, Exception):
    try: raise Err("oops", code=7)
    except kind as e: print(kind.__name__, e, e.code, e.args)
class Bool2(int):
    def __bool__(self): return False
    def __add__(self, o): return super().__add__(o) * 2
print(bool(Bool2(5)), Bool2(5) + 1, 1 + Bool2(5), sum([Bool2(1), Bool2(2)]), not Bool2(1))
class Fs(frozenset):
    def __new__(cls, *a): return super().__new__(cls, a)
print(sorted(Fs(3, 1, 2)), Fs(1) == {1}, hash(Fs(1)) == hash(frozenset([1])), type(Fs(1) | {2}).__name__)
