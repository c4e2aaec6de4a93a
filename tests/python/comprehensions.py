def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

print([x * x for x in range(5)], [x for x in range(10) if x % 2 if x > 3], [(x, y) for x in range(3) for y in range(x)], [[y for y in range(x)] for x in range(3)])
print({x: x * x for x in range(3)}, {k: v for v, k in enumerate("abc")}, {x % 2: x for x in range(5)}, sorted({x % 3 for x in range(10)}), list(x for x in "ab"), sum(x for x in range(5)))
x = "outer"
[x for x in range(3)]
print(x)
print([x for x in [x]])
def f():
    y = 10
    return [y + z for z in range(2)], [(lambda: y * z)() for z in range(2)]
print(f())
fs = [lambda: i for i in range(3)]
print([f() for f in fs])
fs = [lambda i=i: i for i in range(3)]
print([f() for f in fs])
class C:
    n = 3
    items = [i for i in range(n)]
    try:
        bad = [n for _ in range(1)]
    except NameError as e:
        print(e)
    ok = [q for q in [n]]
print(C.items, C.ok)
print([y := 5, y ** 2], [last := v for v in range(4)], last)
def g():
    total = 0
    r = [total := total + v for v in range(5)]
    return r, total
print(g())
print(any((w := v) > 2 for v in range(10)), w)
def order(tag, v):
    print(tag, end=" ")
    return v
print({order("k", k): order("v", k) for k in order("it", range(2))})
print([order("e", (a, b)) for a in order("A", [1, 2]) for b in order("B", [a]) if order("c", True)])
gen = (order("lazy", v) for v in order("eager", [1]))
print("made")
print(next(gen))
t(lambda: next(gen))
t(lambda: [1 / v for v in (1, 0)])
t(lambda: {[]: 1 for _ in range(1)})
t(lambda: {[] for _ in range(1)})
t(lambda: [v for v in 5])
t(lambda: (v for v in 5))
t(lambda: [undefined for v in (1,)])
m = [[1, 2, 3], [4, 5, 6]]
print([[row[i] for row in m] for i in range(3)], [v for row in m for v in row], {i: [j for j in range(i)] for i in range(3)})
print([a + b for a, b in zip("ab", "cd")], [a for a, *b in ["abc", "de"]], [b for a, *b in ["abc", "de"]], [i for i, in [(1,), (2,)]])
print([x if x % 2 else -x for x in range(4)], [x for x in (1, 2, 3) if not x == 2], [*[x for x in range(2)], *(y for y in "q")])
print([[[z for z in range(y)] for y in range(x)] for x in range(3)])
def outer():
    k = 1
    def inner():
        return [k + j for j in range(2) if k]
    k = 5
    return inner()
print(outer())
it = iter(range(6))
print([(a, next(it)) for a in it])
print([(lambda v: v + i)(10) for i in range(3)], list(map(lambda t: t[0], [(1, 2)])), [lambda: 0][0]())
print([i for i in range(5) if i not in [j for j in range(3)]], [d for d in {"a": 1, "b": 2}], [k + str(v) for k, v in {"a": 1}.items()])
class It:
    def __init__(self): self.n = 0
    def __iter__(self): return self
    def __next__(self):
        self.n += 1
        if self.n > 3:
            raise StopIteration
        return self.n
print([v for v in It()], [v for v in It() if v != 2], dict((v, v) for v in It()))
def stop():
    raise StopIteration(7)
t(lambda: [stop() for _ in range(1)])
t(lambda: list(stop() for _ in range(1)))
