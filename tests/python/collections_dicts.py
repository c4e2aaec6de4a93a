from collections import OrderedDict, defaultdict, ChainMap, UserDict, UserList, UserString
import collections

def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

o = OrderedDict([("a", 1), ("b", 2), ("c", 3)])
o.move_to_end("a"); print(o)
o.move_to_end("c", last=False); print(o, list(o), list(reversed(o)), o.popitem(), o.popitem(last=False), o)
t(lambda: o.move_to_end("zz"))
t(lambda: OrderedDict().popitem())
t(lambda: o["zz"])
t(lambda: o.pop("zz"))
t(lambda: OrderedDict(5))
print(OrderedDict(a=1), OrderedDict(), OrderedDict({"x": 1}), OrderedDict(a=1, b=2) == OrderedDict(b=2, a=1), OrderedDict(a=1, b=2) == dict(b=2, a=1), dict(b=2, a=1) == OrderedDict(a=1, b=2), OrderedDict(a=1) != OrderedDict(a=1), OrderedDict.fromkeys("ab", 0), OrderedDict(a=1) | {"b": 2}, {"b": 2} | OrderedDict(a=1), o.copy(), type(o.copy()).__name__, isinstance(o, dict), o.setdefault("q", 5), o.pop("q"), o.pop("q", "d"), o.get("b"))
o["b"] = 99; o["n"] = 1; o.update(z=2, b=0); del o["n"]
print(o, list(o.keys()), list(o.values()), list(o.items()), len(o), "b" in o)
o |= {"k": 1}
print(o, o.clear(), o, OrderedDict([(i, i) for i in range(3)]))
class LRU(OrderedDict):
    def __init__(self, n):
        super().__init__()
        self.n = n
    def __getitem__(self, k):
        v = super().__getitem__(k)
        self.move_to_end(k)
        return v
    def __setitem__(self, k, v):
        super().__setitem__(k, v)
        if len(self) > self.n: del self[next(iter(self))]
l = LRU(2)
l["a"] = 1; l["b"] = 2; l["a"]; l["c"] = 3
print(list(l), l.n, type(l).__name__)

d = defaultdict(list)
d["x"].append(1); d["x"].append(2); d["y"]
print(d, d["x"], dict(d), len(d), "z" in d, d.get("z"), d.default_factory, d.copy(), type(d.copy()).__name__)
n = defaultdict(int)
for ch in "hello": n[ch] += 1
print(n, sorted(n.items()), n == {"h": 1, "e": 1, "l": 2, "o": 1}, defaultdict(int, a=1), defaultdict(None, {"k": 1}), defaultdict(), defaultdict(lambda: 5)["q"], defaultdict(int, [("a", 1)], b=2), defaultdict(int) | {"a": 1}, {"a": 1} | defaultdict(int))
t(lambda: defaultdict()["k"])
t(lambda: defaultdict(5))
t(lambda: defaultdict(list, 5))
t(lambda: n["zz"].foo)
n.default_factory = None
t(lambda: n["another"])
def boom(): raise ValueError("factory")
t(lambda: defaultdict(boom)["k"])
tree = lambda: defaultdict(tree)
tr = tree()
tr["a"]["b"]["c"] = 1
print(list(tr), list(tr["a"]), tr["a"]["b"]["c"], n.setdefault("s", 5), n.pop("h"), n.pop("none", None))
class Dd(defaultdict):
    def __missing__(self, k): return "missing " + k
print(Dd(int)["q"], Dd(int))
nested = defaultdict(lambda: defaultdict(int))
nested["a"]["b"] += 1
print({k: dict(v) for k, v in nested.items()}, repr(defaultdict(set, {1: {2}})))
rec = defaultdict(list)
rec["self"] = rec
print(rec)

base, over = {"a": 1, "b": 2}, {"b": 20, "c": 30}
c = ChainMap(over, base)
print(c, c["a"], c["b"], len(c), list(c), dict(c), "c" in c, c.get("zz"), c.maps, c.parents, c.new_child({"d": 1}), c.new_child(e=2), bool(ChainMap()), ChainMap(), sorted(c.items()), list(c.values()))
c["new"] = 1; del c["b"]
print(over, base, c["b"], c.pop("new"), c == {"a": 1, "b": 2, "c": 30}, c.copy().maps[0] is over, c | {"z": 1}, {"q": 1} | c)
t(lambda: c["zz"])
t(lambda: c.pop("a"))
def dl(): del c["a"]
t(dl)
t(lambda: ChainMap().popitem())

class U(UserDict):
    def __setitem__(self, k, v): super().__setitem__(str(k), v)
u = U({1: "a"}, b=2)
u[3] = "c"
print(u, u.data, len(u), "1" in u, 1 in u, u.get("3"), sorted(u), u == {"1": "a", "b": 2, "3": "c"}, u.pop("b"), u | {"z": 1}, u.copy(), type(u.copy()).__name__, dict(u), list(u.items()))
t(lambda: u["zz"])
ul = UserList([3, 1, 2])
ul.append(5); ul.sort(); ul += [9]; ul.insert(0, "x") if False else ul.extend((7,))
print(ul, ul[0], ul[1:3], type(ul[1:3]).__name__, len(ul), ul + [1], [0] + ul, ul * 2, 5 in ul, ul == [1, 2, 3, 5, 9, 7], ul.index(5), ul.pop(), ul.count(1), list(reversed(ul)), ul < [9], ul.data)
us = UserString("Hello")
print(us, us.upper(), type(us.upper()).__name__, us + " x", "y " + us, us[1], us[1:3], len(us), us == "Hello", "ell" in us, us * 2, us.split("l"), us.replace("l", "L"), us.find("l"), hash(us) == hash("Hello"), repr(us), us % (), UserString("%s!") % "a", us.startswith("He"), us.join(["a", "b"]), int(UserString("5")), us.encode(), us < "I")
t(lambda: collections.nothing)
print(collections.OrderedDict is OrderedDict, collections.abc.Mapping.__name__)
