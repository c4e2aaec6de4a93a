def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

a, b = 1, 2
a, b = b, a
print(a, b)
(a, (b, c)), [d, e] = (1, (2, 3)), [4, 5]
print(a, b, c, d, e)
a, *b = 1, 2, 3
*c, d = "xyz"
e, *f, g = range(5)
h, *i, j = (1, 2)
print(a, b, c, d, e, f, g, h, i, j)
*k, = range(3)
[l, *m] = [1]
(n,) = [7]
print(k, l, m, n)
a = b = c = [1]
print(a is b is c)
x, y, = 1, 2
print(x)
(a, *b), c = "abc", 5
print(a, b, c)
for p, (q, *r) in [(1, (2, 3, 4)), (5, [6])]:
    print(p, q, r)
d = {"a": 1, "b": 2}
p, q = d
print(p, q, [*d], {**d, "c": 3, "a": 0}, {"a": 5, **d}, [*range(3), *"ab"], (*[1], 2), {*[1, 1, 2]})
lst = [0, 0, 0]
i = 0
i, lst[i] = 1, 9
print(i, lst)
lst[0], lst[1], *lst[2:] = 1, 2, 3, 4
print(lst)
def u2(v):
    a, b = v
    return a, b
def u3s(v):
    a, b, *c, d = v
    return a, b, c, d
def u1(v):
    a, = v
    return a
def u0(v):
    [] = v
    return "ok"
for v in ((1,), (1, 2, 3), [], [1, 2], "ab", "abc", {1: 2}, range(3), 5, None, (i for i in range(3)), (i for i in range(1)), {1, 2, 3}, iter([1, 2]), b"ab"):
    t(lambda: u2(v))
for v in ((1,), (1, 2, 3), [], "abcdef", 5, iter("ab"), iter("abcd"), None):
    t(lambda: u3s(v))
for v in ((1,), (1, 2), [], 5, "a"):
    t(lambda: u1(v))
for v in ((), [1], "", 5, {}):
    t(lambda: u0(v))
def f(*a, **k):
    return a, k
print(f(*[1, 2], 3, *(4,), x=1, **{"y": 2}, **{"z": 3}))
t(lambda: f(**{"a": 1}, **{"a": 2}))
t(lambda: f(a=1, **{"a": 2}))
t(lambda: f(*5))
t(lambda: f(**5))
t(lambda: f(**[1]))
t(lambda: f(**{1: 2}))
t(lambda: f(*None))
t(lambda: f(1, *None))
t(lambda: [*5])
t(lambda: (*None,))
t(lambda: {*5})
t(lambda: {**5})
t(lambda: {**{"a": 1}, **[1]})
class M:
    def keys(self): return ["p", "q"]
    def __getitem__(self, k): return k * 2
print({**M()}, f(**M()), dict(M()))
def ret():
    return *[1, 2], 3
print(ret())
def gen():
    yield *[1], 2
print(list(gen()))
print([*(x for x in "ab")], [x for x in (*[1], 2)], {**{}}, [*[]], (*(),))
a, b, c = map(str, range(3))
print(a + b + c)
first, second = sorted({3, 1})
print(first, second)
m = [[1, 2], [3, 4]]
print(list(zip(*m)), max(*[1, 5, 3]), print(*"abc", sep="-"))
t(lambda: [a for a, b in [(1, 2, 3)]])
t(lambda: [a for a, b in [5]])
class It:
    def __iter__(self):
        yield 1
        raise ValueError("stop here")
t(lambda: u2(It()))
x = [1, 2, 3]
x[0], x = 5, x
print(x)
a = [1, 2]
a[0], a[1] = a[1], a[0]
print(a)
class Rec:
    def __setattr__(self, k, v): print("set", k, v)
    def __getitem__(self, k): print("get", k)
    def __setitem__(self, k, v): print("item", k, v)
o = Rec()
def n(v):
    print("n", v)
    return v
o.a, o[n(1)], o.b = n("x"), n("y"), n("z")
o.p = o[n("k")] = n("v")
