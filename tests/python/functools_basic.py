from functools import *
import functools, operator

def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

print(reduce(lambda a, b: a + b, [1, 2, 3]), reduce(lambda a, b: a * b, range(1, 6), 10), reduce(max, [3], 5), reduce(operator.add, [], "init"), reduce(lambda a, b: f"({a}{b})", "abcd"))
t(lambda: reduce(lambda a, b: a, []))
t(lambda: reduce(lambda a, b: a, 5))
t(lambda: reduce(5, [1, 2]))
def f(a, b=2, *args, c=3, **kw): return (a, b, args, c, kw)
p = partial(f, 1, c=10)
print(p(), p(5), p(5, 6, 7), p(c=1), p(z=9), p.args, p.keywords, p.func is f, partial(p, 2, d=4)(), partial(p, 2).args, partial(int, base=2)("101"))
t(lambda: partial())
t(lambda: partial(5))
t(lambda: partial(f)())
t(lambda: p(a=1))
print(repr(partial(print, 1, sep="-")), repr(partial(int)), list(map(partial(pow, 2), range(4))), sorted([3, 1], key=partial(operator.mul, -1)))
p.attr = 5
print(p.attr)
class A:
    def m(self, x, y): return (type(self).__name__, x, y)
    pm = partialmethod(m, 1)
    @classmethod
    def c(cls, x): return cls.__name__, x
    pc = partialmethod(c, 5)
    @staticmethod
    def s(x, y): return x + y
    ps = partialmethod(s, 100)
print(A().pm(2), A().pm(y=3), A().pc(), A.pc(), A().ps(1))
calls = []
@lru_cache(maxsize=2)
def sq(n):
    "doc of sq"
    calls.append(n)
    return n * n
print(sq(1), sq(2), sq(1), sq(3), sq(2), sq(1), calls, sq.cache_info(), sq.cache_parameters(), sq.__name__, sq.__doc__, sq.__wrapped__(9))
sq.cache_clear()
print(sq.cache_info(), sq.cache_info().hits, sq(5), sq.cache_info().misses)
@lru_cache
def plain(x, y=1): return x + y
print(plain(1), plain(1, 1), plain(x=1), plain(1, y=1), plain.cache_info(), plain(1.0), plain.cache_info())
@lru_cache(maxsize=None, typed=True)
def typed(x): return type(x).__name__
print(typed(1), typed(1.0), typed(True), typed(1), typed.cache_info())
@lru_cache(maxsize=0)
def none(x): return x
print(none(1), none(1), none.cache_info())
@cache
def fib(n): return n if n < 2 else fib(n - 1) + fib(n - 2)
print(fib(90), fib.cache_info())
t(lambda: plain([]))
t(lambda: lru_cache("a"))
t(lambda: lru_cache(-5)(len).cache_info())
@lru_cache(2)
def boom(x): raise ValueError(x)
for _ in range(2): t(lambda: boom(1))
print(boom.cache_info())
class M:
    def __init__(self, v): self.v = v
    @lru_cache
    def meth(self, x): return self.v + x
    @cached_property
    def big(self):
        "big doc"
        print("computing")
        return self.v * 100
m = M(5)
print(m.meth(1), m.meth(1), M.meth.cache_info(), m.big, m.big, m.__dict__, M.big.__doc__)
del m.big
print(m.big)
m.big = "set"
print(m.big, M.big.attrname)
class Sl:
    __slots__ = ("a",)
    @cached_property
    def c(self): return 1
t(lambda: Sl().c)
class Late: pass
Late.x = cached_property(lambda self: 1)
t(lambda: Late().x)
def two():
    class T:
        a = b = cached_property(lambda s: 1)
try:
    two()
except Exception as e:
    print(type(e).__name__, repr(e.__cause__))
def deco(fn):
    @wraps(fn)
    def w(*a):
        "wrapper doc"
        return fn(*a)
    return w
@deco
def orig(a: int) -> str:
    "original doc"
    return a
orig.custom = 1
print(orig.__name__, orig.__doc__, orig.__wrapped__.__name__, orig.__annotations__, orig(3), orig.__qualname__, orig.__module__)
def g1(): pass
def g2(): "g2 doc"
g2.x = 5
u = update_wrapper(g1, g2)
print(u is g1, g1.__name__, g1.x, g1.__doc__, WRAPPER_ASSIGNMENTS, WRAPPER_UPDATES, update_wrapper(partial(int), int).__name__)
@total_ordering
class V:
    def __init__(self, v): self.v = v
    def __eq__(self, o): return isinstance(o, V) and self.v == o.v
    def __lt__(self, o): return self.v < o.v if isinstance(o, V) else NotImplemented
print(V(1) < V(2), V(1) <= V(1), V(2) > V(1), V(1) >= V(2), V(1) >= V(1), V(1) > V(1), sorted([V(3), V(1)], reverse=True)[0].v)
t(lambda: V(1) <= 5)
t(lambda: V(1) > 5)
@total_ordering
class Ge:
    def __init__(self, v): self.v = v
    def __eq__(self, o): return self.v == o.v
    def __ge__(self, o): return self.v >= o.v
print(Ge(1) < Ge(2), Ge(2) <= Ge(2), Ge(3) > Ge(2), Ge(1) > Ge(1))
@total_ordering
class Le:
    def __init__(self, v): self.v = v
    def __eq__(self, o): return self.v == o.v
    def __le__(self, o): return self.v <= o.v
print(Le(1) < Le(2), Le(2) >= Le(2), Le(3) > Le(2), Le(1) < Le(1))
t(lambda: total_ordering(type("X", (), {})))
print(sorted([3, 1, 2], key=cmp_to_key(lambda a, b: b - a)), max(["a", "ccc"], key=cmp_to_key(lambda a, b: len(a) - len(b))))
K = cmp_to_key(lambda a, b: (a > b) - (a < b))
print(K(1) < K(2), K(1) == K(1), K(2) >= K(1), K(3).obj)
t(lambda: K(1) < 5)
@singledispatch
def show(x, tag=""): return f"object {x}{tag}"
@show.register
def _(x: int, tag=""): return f"int {x}{tag}"
@show.register(list)
def _(x, tag=""): return f"list of {len(x)}{tag}"
@show.register(float)
@show.register(complex)
def num(x, tag=""): return f"number {x}{tag}"
@show.register
def _(x: str | bytes, tag=""): return f"text {x!r}"
show.register(type(None), lambda x, tag="": "nothing")
print(show(1), show(True), show([1, 2], tag="!"), show(2.5), show(1j), show("s"), show(b"b"), show(None), show({}), show.dispatch(bool) is show.dispatch(int), show.dispatch(dict)("q"), sorted(k.__name__ for k in show.registry), show.__name__)
t(lambda: show())
t(lambda: show.register(5))
def noann(x): pass
try:
    show.register(noann)
except TypeError as e:
    print(str(e)[:40])
class Base: pass
class Mid(Base): pass
class Leaf(Mid): pass
show.register(Base, lambda x, tag="": "base")
print(show(Leaf()))
show.register(Mid, lambda x, tag="": "mid")
print(show(Leaf()), show(Base()))
from collections.abc import Mapping, Sized
show.register(Mapping, lambda x, tag="": "mapping")
show.register(Sized, lambda x, tag="": "sized")
print(show({}), show(set()), show((1,)))
class Neg:
    @singledispatchmethod
    def neg(self, a): raise NotImplementedError("cannot negate")
    @neg.register
    def _(self, a: int): return -a
    @neg.register(str)
    def _(self, a): return a[::-1]
print(Neg().neg(5), Neg().neg("abc"))
t(lambda: Neg().neg([]))
