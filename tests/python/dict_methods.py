def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

d = {"b": 1, "a": 2}
d["c"] = 3
d["b"] = 9
print(d, len(d), list(d), list(d.keys()), list(d.values()), list(d.items()), d.get("a"), d.get("z"), d.get("z", 0), "a" in d, 9 in d, d.pop("a"), d.pop("zz", None), d)
d["a"] = 5
print(d, d.popitem(), d, d.setdefault("b", 0), d.setdefault("n"), d, d.setdefault("m", []))
t(lambda: d["zz"])
t(lambda: d.pop("zz"))
t(lambda: {}.popitem())
t(lambda: d[[]])
t(lambda: d.__getitem__("q"))
def dl(): del d["zz"]
t(dl)
d.update({"x": 1}, y=2)
d.update([("z", 3), ["w", 4]])
d.update(k=5)
print(d)
del d["x"]
print(d, d.copy() == d, d.copy() is d, dict(d) == d, d.clear(), d)
print(dict(a=1, b=2), dict([("a", 1)]), dict([(1, 2)], z=3), dict({"q": 1}), dict(zip("ab", [1, 2])), dict(), dict.fromkeys("ab"), dict.fromkeys([1, 2], 0), {**{"a": 1}, "a": 2, "b": 3}, {1: "int", 1.0: "float", True: "bool"}, {(1, 2): "t", None: "n", "": "e"})
a, b = {"x": 1, "y": 2}, {"y": 3, "z": 4}
print(a | b, b | a, a, {**a, **b})
a |= b
print(a)
a |= [("l", 1)]
print(a)
t(lambda: {} | 5)
t(lambda: {} | [(1, 2)])
print({1: 2} == {1: 2.0}, {1: 2} != {1: 3}, {"a": 1, "b": 2} == {"b": 2, "a": 1}, {} == [], {1: 2} == {2: 1})
t(lambda: {} < {})
k, v, i = a.keys(), a.values(), a.items()
print(k, v, i, len(k), "x" in k, 1 in v, ("x", 1) in i, ("x", 2) in i, "x" in i)
a["new"] = 0
print(k, list(reversed(a)), list(reversed(a.values())), list(reversed(a.items())))
print(sorted({"a": 1, "b": 2}.keys() & {"b", "c"}), sorted({"a": 1}.keys() | {"b": 2}.keys()), {"a": 1}.keys() - {"a"}, sorted({"a": 1, "b": 1}.keys() ^ ["b", "c"]), {"a": 1}.keys() == {"a"}, {"a": 1}.items() == {("a", 1)}, {"a": 1}.items() & {("a", 1)}, {"a": 1}.keys() <= {"a", "b"}, {"a": 1}.keys().isdisjoint(["b"]), {"a": 1}.values() == {"a": 1}.values(), {1: 2}.keys() > set(), type({}.keys()).__name__, type({}.items()).__name__, k.mapping["x"])
t(lambda: {1: 2}.keys()[0])
t(lambda: {1: 2}.values() + [])
t(lambda: hash({}.keys()))
def grow():
    for x in d2: d2[x + 100] = 1
d2 = {1: 1, 2: 2}
t(grow)
def shrink():
    for x in d3: del d3[x]
d3 = {1: 1, 2: 2}
t(shrink)
def swap():
    for x in d4:
        del d4[x]
        d4[x + 10] = 1
d4 = {1: 1, 2: 2, 3: 3}
t(swap)
d5 = {1: 1, 2: 2}
for x in d5: d5[x] = x * 10
for x in list(d5): d5[x + 5] = 0
print(d5)
for x, y in d5.items(): print(x, y, end="; ")
print()
r = {}
r["self"] = r
print(r, {1: [r]}["x"] if False else "")
n = {"a": {"b": {"c": 1}}}
n["a"]["b"]["d"] = 2
print(n, n["a"]["b"]["c"], {"l": [1, {"x": (1,)}]})
c = {}
for w in "the cat the dog the end".split(): c[w] = c.get(w, 0) + 1
print(c, sorted(c.items(), key=lambda p: (-p[1], p[0])), max(c, key=c.get), min(c.values()), sum(c.values()))
g = {}
for w in ("apple", "bob", "avocado"): g.setdefault(w[0], []).append(w)
print(g, {v: k for k, v in {"a": 1, "b": 2}.items()}, dict(sorted({"b": 1, "a": 2}.items())), dict(enumerate("ab")))
class H:
    def __init__(self, v): self.v = v
    def __hash__(self): return 1
    def __eq__(self, o): return isinstance(o, H) and self.v == o.v
    def __repr__(self): return f"H{self.v}"
h = {H(i): i for i in range(5)}
del h[H(2)]
h[H(2)] = "again"
print(h, h[H(3)], H(9) in h)
nan = float("nan")
print({nan: 1}[nan], {nan: 1, float("nan"): 2} == {}, len({float("nan"): 1, float("nan"): 2}), {0.0: 1}[-0.0], {1: "a"}[True], {2 ** 70: 1}[2 ** 70], {1.0: "f"}[1], {"a" "b": 1}, {(1, (2,)): 3}[(1, (2,))], {frozenset([1]): 2}[frozenset([1])])
e = dict.fromkeys(range(20))
for i in range(0, 20, 2): del e[i]
for i in (4, 2, 30): e[i] = "re"
print(e, e.popitem(), next(iter(e)), list(e)[-1])
it = iter({"a": 1, "b": 2})
print(next(it), it.__length_hint__(), list(it), type(it).__name__)
print({}.get, "") if False else None
print(isinstance({}, dict), dict.__name__, {}.__len__(), {1: 2}.__contains__(1), {"a": 1}.__eq__({"a": 1}), {1: 2}.__or__({3: 4}), {1: 2}.__or__(5), {"a": 1}.__iter__().__next__(), bool({}), bool({0: 0}), str({"k": "it's"}), {1, 2} == {1: 0, 2: 0}.keys(), f"{ {'a': 1} }", {"a": 1}.keys())
class S(str): pass
print({S("a"): 1}["a"], {"a": 1}[S("a")], {1: 1}.get(1.0), [*{"a": 1}.items()], dict([*{"a": 1}.items()], b=2))
