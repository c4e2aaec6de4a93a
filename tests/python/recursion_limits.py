def depth(n): return 0 if n == 0 else 1 + depth(n - 1)
print(depth(500))
def forever(n): return forever(n + 1)
def caught():
    try: forever(0)
    except RecursionError as e: return type(e).__name__, str(e).startswith("maximum recursion depth exceeded"), isinstance(e, RuntimeError)
print(caught(), caught())
class R:
    def __repr__(self): return repr(self)
    def __eq__(self, o): return self == o
    def __getattr__(self, n): return getattr(self, n + "x")
    def __len__(self): return len(self)
    def __hash__(self): return hash(self)
    def __call__(self): return self()
    def __add__(self, o): return self + o
    def __iter__(self): return iter(self)
    def __bool__(self): return bool(self)
    def __contains__(self, x): return x in self
r = R()
for f in (lambda: repr(r), lambda: r == 1, lambda: r.foo, lambda: len(r), lambda: hash(r), lambda: r(), lambda: r + 1, lambda: list(r), lambda: bool(r), lambda: 1 in r):
    try: f()
    except RecursionError: print("RecursionError", end=" ")
print()
a = []
for _ in range(50): a = [a]
print(str(a).count("["), a == a)
l = [1]; l.append(l)
d = {}; d["d"] = d; d["l"] = l
t = ([],); t[0].append(t)
print(l, d, t, l[1] is l, repr(l), str(d), f"{l}")
b = [1]; b.append(b)
try: print(l == b)
except RecursionError: print("eq recursion")
deep = nested = []
for _ in range(100000):
    inner = []
    nested.append(inner)
    nested = inner
for f in (lambda: repr(deep), lambda: deep == [deep]):
    try: print(type(f()).__name__)
    except RecursionError: print("too deep")
def gen(n):
    if n: yield from gen(n - 1)
    yield n
print(sum(gen(100)))
try: print(sum(1 for _ in gen(5000)))
except RecursionError: print("gen too deep")
def mutual_a(n): return n if n <= 0 else mutual_b(n - 1)
def mutual_b(n): return n if n <= 0 else mutual_a(n - 2)
print(mutual_a(300))
def fin(n):
    try: return fin(n + 1)
    finally: pass
try: fin(0)
except RecursionError: print("fin")
def memo(n, seen={}):
    if n < 2: return n
    if n not in seen: seen[n] = memo(n - 1) + memo(n - 2)
    return seen[n]
print(memo(300))
cls = object
class P:
    @property
    def x(self): return self.x
try: P().x
except RecursionError: print("prop")
class N:
    def __init__(self): N()
try: N()
except RecursionError: print("init")
sort_me = [3, 1]
def key(v): return sorted(sort_me, key=key)
try: key(1)
except RecursionError: print("sort key")
print("ok")
