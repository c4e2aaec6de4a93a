def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

a = [3, 1, 2]
a.append(4); a.extend([5, 6]); a.extend("ab"); a.extend(x for x in (7,)); a.insert(0, "first"); a.insert(-1, "pen"); a.insert(100, "last"); a.insert(-100, "zero")
print(a, len(a), a.pop(), a.pop(0), a.pop(-2), a)
a.remove("a")
print(a, a.index(5), a.count(1), 5 in a, "z" not in a)
t(lambda: a.remove("nope"))
t(lambda: a.index("nope"))
t(lambda: [].pop())
t(lambda: [1].pop(1))
t(lambda: [1].pop(-2))
t(lambda: [1, 2, 3].index(1, 1))
print([1, 2, 1].index(1, 1), [1, 2, 1].index(1, -1), [1, 2, 3].index(2, 0, 100))
b = [3, 1, 2]
print(b.sort(), b, b.reverse(), b, b.copy(), b.copy() is b, b.clear(), b)
print([1, 2] + [3], [1] * 3, 2 * [0], [1] * 0, [1] * -1, [[]] * 2, [1, 2] == [1, 2], [1] == (1,), [1, 2] < [1, 3], [1] < [1, 0], [] < [1], [2] > [1, 9], [1, 2] != [2, 1], [1, "a"] < [2, 5])
x = [[0] * 2] * 2
x[0][0] = 1
print(x)
y = [[0] * 2 for _ in range(2)]
y[0][0] = 1
print(y)
r = [1]
r.append(r)
print(r, r[1][1][1] is r)
r2 = [1]
r2 += r2
r2 *= 2
print(r2, list(reversed(r2)), [*r2, 0])
c = d = [1]
c += [2]
print(d, c is d)
c = c + [3]
print(d, c)
d.extend(d)
print(d)
s = [5, 3, 9, 1]
print(sorted(s), s, sorted(s, reverse=True), sorted(s, key=lambda v: -v), max(s), min(s), sum(s), any(s), all(s), list(enumerate(s)), list(zip(s, "abcd")), list(map(str, s)), list(filter(lambda v: v > 3, s)))
w = ["bb", "a", "ccc", "dd", "e"]
print(sorted(w, key=len), sorted(w, key=len, reverse=True), sorted(w, key=lambda v: (len(v), v)), sorted(w, key=lambda v: (-len(v), v)), max(w, key=len), min(w, key=len))
w.sort(key=len, reverse=True)
print(w)
st = [(1, "b"), (0, "z"), (1, "a"), (0, "y")]
print(sorted(st, key=lambda p: p[0]), sorted(st, key=lambda p: p[0], reverse=True), sorted(st), sorted(st, key=lambda p: p[1]))
t(lambda: [1, "a"].sort())
t(lambda: sorted([None, 1]))
t(lambda: sorted([1, 2j]))
t(lambda: sorted([[1], ["a"]]))
t(lambda: sorted([1, 2], key=lambda v: 1 / 0))
print(sorted([True, 0, 2, False]), sorted([1.5, 1, 0.5]), sorted([float("inf"), -1, 3]), sorted("bca"), sorted({"b": 1, "a": 2}), sorted([(2, "a"), (1, "b")]), sorted([[2], [1, 5]]), sorted(["B", "a", "C"], key=str.lower), sorted(range(5), key=lambda v: v % 2))
def during():
    v = [3, 2, 1]
    v.sort(key=lambda e: v.append(5) or e)
t(during)
def seen():
    v = [3, 1, 2]
    out = []
    v.sort(key=lambda e: (out.append(len(v)), e)[1])
    return v, out
print(seen())
z = [1, 2, 3, 4, 5, 6]
for v in z:
    if v % 2 == 0: z.remove(v)
print(z)
g = [1]
for v in g:
    if len(g) < 5: g.append(v + 1)
print(g)
it = iter([1, 2, 3])
print(next(it), list(it), list(it), it.__length_hint__())
h = [1, 2, 3]
hi = iter(h)
next(hi)
h.clear()
print(list(hi))
h.extend([1, 2, 3, 4])
print(list(hi))
q = [1, 2, 3]
q[1:2], q[0] = [9, 9], 5
print(q)
del q[0], q[-1]
print(q)
print(list(), list("ab"), list(range(3)), list({1: 2}), list((1,)), list(x for x in "q"), [None] * 2, [True, None, 1.5, "s", b"b", (), {}, [], ...], str(["it's", 'q"']), [[1, [2, [3]]]], [1,], [(1,), ()])
print([1, 2, 3].__contains__(2), [1].__len__(), [1, 2].__getitem__(-1), [1].__add__([2]), [1].__mul__(2), [1].__eq__((1,)), list.__name__, [].__class__, [1, 2, 3].__reversed__().__next__(), [1, 2].__iadd__((3,)), [0].__bool__ if False else "-")
l = [1, 2]
l.__setitem__(0, 5); l.__delitem__(1); l.__init__([7, 8])
print(l)
class E:
    def __init__(self, v): self.v = v
    def __eq__(self, o): return True
print([1, 2].index(E(1)), [1, 2].count(E(1)), E(1) in [3], [E(1)] == [5])
big = list(range(1000))
print(sum(big), big[::250], sorted(big, key=lambda v: (v * 7919) % 1009)[:5], sorted(big, reverse=True)[:3])
m = sorted([(v * 37 % 11, v) for v in range(40)], key=lambda p: p[0])
print(m)
m = sorted([(v * 37 % 11, v) for v in range(40)], key=lambda p: p[0], reverse=True)
print(m)
t(lambda: [] + None)
t(lambda: [1, 2].sort(key=1))
