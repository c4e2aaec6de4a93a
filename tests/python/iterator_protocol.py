def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")
class Count:
    def __init__(self, n): self.n, self.i = n, 0
    def __iter__(self): print("iter", end=" "); return self
    def __next__(self):
        print("next", end=" ")
        if self.i >= self.n: raise StopIteration
        self.i += 1
        return self.i
c = Count(2)
for x in c: print(x, end=" ")
print(list(c), list(Count(2)), [*Count(1)], sum(Count(3)), 2 in Count(5), max(Count(3)), tuple(Count(0)), dict(zip(Count(2), "ab")))
a, b = Count(2)
print(a, b)
t(lambda: (lambda a, b: 0)(*Count(3)))
class Getitem:
    def __getitem__(self, i):
        print("get", i, end=" ")
        if i > 2: raise IndexError
        return i * i
print(list(Getitem()), 4 in Getitem(), [x for x in Getitem()], iter(Getitem()).__class__.__name__, next(iter(Getitem())))
class StopGet:
    def __getitem__(self, i):
        if i > 1: raise StopIteration
        return i
print(list(StopGet()))
class ErrGet:
    def __getitem__(self, i): raise KeyError(i)
t(lambda: list(ErrGet()))
class NoNext:
    def __iter__(self): return self
class IterNone: __iter__ = None
class IterList:
    def __iter__(self): return [1, 2]
class NextOnly:
    def __next__(self): return 1
for v in (NoNext(), IterNone(), IterList(), NextOnly(), 5, None, object(), print, int):
    t(lambda: [x for x in v])
t(lambda: next(NoNext()))
t(lambda: next([1]))
print(next(NextOnly()), next(NextOnly(), "d"))
it = iter([1, 2, 3])
print(it is iter(it), next(it), it.__length_hint__(), list(it), next(it, None), list(it))
n = 0
def tick():
    global n
    n += 1
    return n
print(list(iter(tick, 4)), n, [x for x in iter(lambda: "done", "done")], type(iter(tick, 1)).__name__)
def err():
    raise StopIteration
print(list(iter(err, 5)))
l = [1, 2, 3]
i = iter(l)
next(i); l.append(4); print(list(i)); l.append(5); print(list(i))
l = [1, 2, 3, 4]
for v in l:
    if v == 2: l.remove(v)
    print(v, end=" ")
print(l)
l = [1, 2]
for v in l:
    if len(l) < 6: l.insert(0, v + 10)
print(l)
l = [1, 2, 3, 4, 5]
for v in reversed(l):
    if v == 4: l.pop()
    print(v, end=" ")
print(l)
d = {"a": 1, "b": 2}
for change in ("d['z'] = 1", "del d['a']"):
    try:
        for k in d:
            if change[0] == "d" and change[1] == "[": d["z"] = 1
            else: del d["a"]
    except RuntimeError as e: print(e)
for k in d: d[k] = 9
print(d)
for k in list(d): d[k + k] = 1
print(d)
s = {1, 2, 3}
try:
    for v in s: s.add(v + 100)
except RuntimeError as e: print(e)
it = iter({"a": 1, "b": 2}.items())
print(next(it), list(it))
ds = {1: 1, 2: 2, 3: 3}
it = iter(ds)
next(it); ds[4] = 4
t(lambda: next(it))
t(lambda: next(it))
z = zip([1, 2, 3], (x for x in "ab"))
print(list(z), list(z))
g = (x for x in [1, 2, 3])
print(list(zip(g, g)), list(g))
r = range(3)
print(list(zip(iter(r), iter(r))), iter(r) is iter(r), list(r), list(r), next(iter(r)), r.__iter__().__next__())
gen = (i for i in range(3))
print(2 in gen, 2 in gen, list(gen))
e = enumerate("abc")
print(next(e), list(e), iter(e) is e)
f = filter(None, [0, 1, 2])
print(next(f), iter(f) is f, list(f))
rev = reversed([1, 2, 3])
print(next(rev), list(rev), rev.__length_hint__())
class Rng:
    def __len__(self): return 3
    def __getitem__(self, i): return "abc"[i]
print(list(Rng()), list(reversed(Rng())), "b" in Rng(), list(enumerate(Rng())), min(Rng()), *Rng())
print(list(map(lambda *a: a, [1, 2], [3, 4, 5])), list(zip("ab", [1, 2], (3, 4))), sum(1 for _ in Count(2)))
class Chain:
    def __init__(self, *its): self.its = its
    def __iter__(self):
        for i in self.its: yield from i
print(list(Chain([1], "ab", (2,), {"k": 1}, range(2))), len(list(Chain())), sorted(Chain([2], [1])))
