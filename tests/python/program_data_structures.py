class Node:
    def __init__(self, v, nxt=None): self.v, self.next = v, nxt
class LinkedList:
    def __init__(self, it=()):
        self.head, self.n = None, 0
        for v in reversed(list(it)): self.push(v)
    def push(self, v): self.head = Node(v, self.head); self.n += 1
    def pop(self):
        if self.head is None: raise IndexError("pop from empty list")
        v, self.head = self.head.v, self.head.next
        self.n -= 1
        return v
    def reverse(self):
        prev, cur = None, self.head
        while cur: cur.next, prev, cur = prev, cur, cur.next
        self.head = prev
        return self
    def __iter__(self):
        cur = self.head
        while cur: yield cur.v; cur = cur.next
    def __len__(self): return self.n
    def __repr__(self): return " -> ".join(map(repr, self)) or "empty"
l = LinkedList("abc")
l.push(1)
print(l, len(l), l.pop(), l.reverse(), list(l), "b" in l, LinkedList(), bool(LinkedList()))
try: LinkedList().pop()
except IndexError as e: print(e)
class Tree:
    def __init__(self): self.root = None
    def add(self, k, v=None):
        def put(n):
            if n is None: return [k, v, None, None]
            if k == n[0]: n[1] = v
            else:
                side = 2 if k < n[0] else 3
                n[side] = put(n[side])
            return n
        self.root = put(self.root)
        return self
    def __iter__(self):
        def walk(n):
            if n:
                yield from walk(n[2])
                yield n[0], n[1]
                yield from walk(n[3])
        return walk(self.root)
    def depth(self, n=...):
        n = self.root if n is ... else n
        return 0 if n is None else 1 + max(self.depth(n[2]), self.depth(n[3]))
    def __getitem__(self, k):
        n = self.root
        while n:
            if n[0] == k: return n[1]
            n = n[2] if k < n[0] else n[3]
        raise KeyError(k)
t = Tree()
for i, k in enumerate("mcxaetz"): t.add(k, i)
print(list(t), t.depth(), t["e"], [k for k, _ in t])
try: t["q"]
except KeyError as e: print(repr(e))
class Trie:
    def __init__(self): self.kids, self.end = {}, False
    def insert(self, w):
        n = self
        for ch in w: n = n.kids.setdefault(ch, Trie())
        n.end = True
    def words(self, prefix=""):
        n = self
        for ch in prefix:
            if ch not in n.kids: return []
            n = n.kids[ch]
        return ([prefix] if n.end else []) + [w for ch in sorted(n.kids) for w in self.words(prefix + ch)]
tr = Trie()
for w in "tea ten to inn in i".split(): tr.insert(w)
print(tr.words(), tr.words("te"), tr.words("x"))
class Heap:
    def __init__(self, key=lambda v: v): self.a, self.key = [], key
    def push(self, v):
        a = self.a; a.append(v); i = len(a) - 1
        while i and self.key(a[i]) < self.key(a[p := (i - 1) >> 1]): a[i], a[p] = a[p], a[i]; i = p
    def pop(self):
        a = self.a; a[0], a[-1] = a[-1], a[0]; v = a.pop(); i = 0
        while (c := 2 * i + 1) < len(a):
            if c + 1 < len(a) and self.key(a[c + 1]) < self.key(a[c]): c += 1
            if self.key(a[i]) <= self.key(a[c]): break
            a[i], a[c] = a[c], a[i]; i = c
        return v
    def __len__(self): return len(self.a)
h = Heap(key=lambda t: -t[0])
for p in ((3, "c"), (9, "a"), (1, "z"), (7, "q"), (9, "b")): h.push(p)
print([h.pop() for _ in range(len(h))])
class Poly:
    def __init__(self, *c): self.c = c
    def __call__(self, x):
        r = 0
        for k in self.c: r = r * x + k
        return r
    def __mul__(self, o):
        out = [0] * (len(self.c) + len(o.c) - 1)
        for i, a in enumerate(self.c):
            for j, b in enumerate(o.c): out[i + j] += a * b
        return Poly(*out)
    def __str__(self):
        n = len(self.c) - 1
        terms = [f"{k}x^{n - i}" for i, k in enumerate(self.c) if k]
        return " + ".join(terms).replace("x^0", "").replace("x^1 ", "x ") or "0"
p = Poly(1, 0, -2)
print(p(3), p * Poly(1, 1), Poly(0), [p(x) for x in range(-2, 3)])
class Frac:
    def __init__(self, n, d=1):
        if d == 0: raise ZeroDivisionError("Frac with zero denominator")
        a, b = abs(n), abs(d)
        while b: a, b = b, a % b
        s = -1 if d < 0 else 1
        self.n, self.d = s * n // a, s * d // a
    def __add__(self, o): o = Frac.of(o); return Frac(self.n * o.d + o.n * self.d, self.d * o.d)
    __radd__ = __add__
    def __sub__(self, o): return self + -Frac.of(o)
    def __neg__(self): return Frac(-self.n, self.d)
    def __mul__(self, o): o = Frac.of(o); return Frac(self.n * o.n, self.d * o.d)
    __rmul__ = __mul__
    def __truediv__(self, o): o = Frac.of(o); return self * Frac(o.d, o.n)
    def __eq__(self, o): o = Frac.of(o); return (self.n, self.d) == (o.n, o.d)
    def __lt__(self, o): o = Frac.of(o); return self.n * o.d < o.n * self.d
    def __float__(self): return self.n / self.d
    def __hash__(self): return hash(self.n / self.d)
    def __repr__(self): return f"{self.n}/{self.d}" if self.d != 1 else str(self.n)
    @staticmethod
    def of(v): return v if isinstance(v, Frac) else Frac(v)
print(Frac(2, 4), Frac(1, 3) + Frac(1, 6), 1 + Frac(1, 2), Frac(3, 4) * 2, Frac(1, 2) / Frac(3, 4), Frac(1, -2), sum([Frac(1, k) for k in range(1, 8)]), sorted([Frac(1, 2), Frac(1, 3)]), float(Frac(1, 3)), Frac(2, 2) == 1, len({Frac(1, 2), Frac(2, 4)}))
try: Frac(1, 2) / 0
except ZeroDivisionError as e: print(e)
class LRU:
    def __init__(self, cap): self.cap, self.d, self.hits, self.misses = cap, {}, 0, 0
    def get(self, k, make):
        if k in self.d: self.hits += 1; self.d[k] = v = self.d.pop(k); return v
        self.misses += 1
        self.d[k] = v = make(k)
        if len(self.d) > self.cap: del self.d[next(iter(self.d))]
        return v
c = LRU(2)
print([c.get(k, lambda k: k * k) for k in (1, 2, 1, 3, 2, 1)], list(c.d), c.hits, c.misses)
