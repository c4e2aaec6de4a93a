def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")
people = [("Bob", 30), ("alice", 25), ("Carl", 30), ("dave", 25), ("Eve", 35)]
print(sorted(people), sorted(people, key=lambda p: p[1]), sorted(people, key=lambda p: p[1], reverse=True), sorted(people, key=lambda p: p[0].lower()), sorted(people, key=lambda p: (-p[1], p[0])), sorted(sorted(people, key=lambda p: p[0]), key=lambda p: p[1]), sep="\n")
seed, data = 7, []
for i in range(200):
    seed = (seed * 75 + 74) % 65537
    data.append((seed % 20, i))
s = sorted(data, key=lambda p: p[0])
print(all(a[0] < b[0] or a[0] == b[0] and a[1] < b[1] for a, b in zip(s, s[1:])))
r = sorted(data, key=lambda p: p[0], reverse=True)
print(all(a[0] > b[0] or a[0] == b[0] and a[1] < b[1] for a, b in zip(r, r[1:])), r[:3], s[:3])
count = 0
class K:
    def __init__(self, v): self.v = v
    def __lt__(self, o):
        global count
        count += 1
        return self.v < o.v
    def __repr__(self): return f"K{self.v}"
print(sorted([K(3), K(1), K(2)]), count)
count = 0
sorted([K(i) for i in range(50)])
print(count)
count = 0
sorted([K(-i) for i in range(50)])
print(count)
class NoLt:
    def __gt__(self, o): return True
    def __repr__(self): return "N"
print(sorted([NoLt(), NoLt()]))
class Neither: pass
t(lambda: sorted([Neither(), Neither()]))
class Raises:
    def __lt__(self, o): raise ValueError("cmp")
t(lambda: sorted([Raises(), Raises()]))
t(lambda: sorted([1, 2, "a", 3]))
t(lambda: [3, 1, None].sort())
t(lambda: sorted([1, 2], key=lambda x: x.foo))
l = [3, 1, 2]
t(lambda: l.sort(key=lambda x: 1 / (x - 1)))
print(l)
l = [5, 1, "x", 2]
t(lambda: l.sort())
print(sorted(map(str, l)))
print(sorted([]), sorted([1]), sorted([2, 1, 2, 1]), sorted([True, False, True]), sorted([0.5, 1, -1, 2.25]), sorted("The quick".split()), sorted("banana"), sorted({3: "a", 1: "b"}), sorted([[2, 1], [1, 9], [1]]), sorted([(1, "b"), (1, "a")]), sorted([{1, 2}, {1}], key=len), sorted(["10", "9", "2"]), sorted(["10", "9", "2"], key=int), sorted([float("inf"), 1, float("-inf")]), sorted(range(5), key=lambda x: (x % 2, -x)), sorted(["b", "A", "c"], key=str.casefold), sorted([b"b", b"a"]), sorted([-3, 2, -1], key=abs), sorted(["ab", "a", "abc"], key=len, reverse=True), sorted([1, 1.0, True], reverse=True))
a = [3, 1, 2]
print(a.sort(reverse=True), a, a.sort(key=None), a, a.reverse(), a, list(reversed(a)), a)
b = a
a.sort()
print(b, max(a), min(a), a.index(max(a)))
d = {"x": 3, "y": 1, "z": 2}
print(sorted(d), sorted(d.values()), sorted(d.items(), key=lambda kv: kv[1]), dict(sorted(d.items(), key=lambda kv: -kv[1])), max(d, key=d.get), min(d.items(), key=lambda kv: kv[1])[0], sorted(d, key=d.__getitem__, reverse=True))
idx = sorted(range(len(a)), key=lambda i: [30, 10, 20][i])
print(idx, [x for _, x in sorted(zip([3, 1, 2], "cab"))], list(zip(*sorted(zip([3, 1, 2], "cab")))))
big = [(i * 7919) % 10007 for i in range(2000)]
print(sorted(big)[:5], sorted(big, reverse=True)[:5], sorted(big, key=lambda v: v % 100)[:5], sorted(big) == sorted(sorted(big, reverse=True)), sum(i * v for i, v in enumerate(sorted(big))) % 1000003)
calls = []
def key(v):
    calls.append(v)
    return -v
print(sorted([1, 3, 2], key=key), calls)
class Money:
    def __init__(self, c): self.c = c
    def __eq__(self, o): return self.c == o.c
    def __lt__(self, o): return self.c < o.c
    def __repr__(self): return f"${self.c}"
print(sorted([Money(5), Money(2)]), max(Money(1), Money(3)), min([Money(4), Money(2)]), Money(2) in [Money(2)], sorted([Money(1), Money(1)])[0])
