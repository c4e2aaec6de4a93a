from collections import Counter

def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

c = Counter("abracadabra")
print(c, c["a"], c["zz"], "zz" in c, len(c), c.total(), c.most_common(), c.most_common(2), c.most_common(0), list(c), sorted(c.elements()), list(c.items()), dict(c))
print(Counter(), Counter({"a": 2}), Counter(a=1, b=2), Counter(["x", "y", "x"]), Counter([(1, 2), (1, 2)]), Counter({"a": 1}, b=2), Counter(None), Counter(Counter("aab")))
c.update("aaa"); c.update({"b": 10}); c.update(z=1)
print(c)
c.subtract("aab"); c.subtract({"z": 5}); c.subtract(c=1)
print(c, c.most_common()[-2:], c.total())
del c["nope"]; del c["z"]
print(c, c.pop("a"), c.get("a"), c.get("a", 0), c["a"], c)
a, b = Counter(a=3, b=1, d=-1), Counter(a=1, b=2, c=4)
print(a + b, a - b, b - a, a & b, a | b, +a, -a, +Counter(a=0), a == b, a == Counter(a=3, b=1, d=-1), Counter(a=1) == Counter(a=1, b=0), Counter(a=1) != Counter(a=2), Counter(a=1) <= Counter(a=1, b=1), Counter(a=1) < Counter(a=1), Counter(a=2) >= Counter(a=1), Counter(a=2) > Counter(a=1, b=1), Counter(a=1) == {"a": 1})
a += b; print(a)
a -= Counter(a=10); print(a)
a |= Counter(q=3, b=1); print(a)
a &= Counter(q=1, c=10); print(a)
t(lambda: Counter(5))
t(lambda: Counter.fromkeys("ab"))
t(lambda: Counter([[]]))
t(lambda: hash(Counter()))
t(lambda: Counter(1, 2))
t(lambda: Counter(a=1) + {"a": 1})
t(lambda: Counter(a=1) < 5)
c = Counter()
for w in "the cat the dog".split():
    c[w] += 1
print(c, c.copy(), c.copy() is c, type(c.copy()).__name__, c == c.copy(), isinstance(c, dict), max(c, key=c.get), sorted(c.items(), key=lambda p: (-p[1], p[0])), sum(c.values()), c.keys() & {"the"}, {k: v for k, v in c.items() if v > 1}, bool(Counter()), [*c])
print(Counter(x % 3 for x in range(10)), Counter({1: "a"}) , Counter(a=1.5, b=0.5).total(), Counter("ab") | Counter("bc"), c.setdefault("new", 7), c.popitem(), c.clear(), c, Counter(dict(a=2)).most_common(5), list(Counter(a=2, b=0, c=-1).elements()))
class Sub(Counter):
    pass
s = Sub("aab")
print(s, s + Sub("a"), type(s.copy()).__name__, repr(Sub()))
print(Counter({"x": 1, 1: 1, None: 1}), Counter("hello").most_common(1)[0][0], Counter([3, 1, 3, 2, 1]).most_common())
