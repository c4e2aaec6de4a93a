def trace(f):
    print("decorating", f.__name__)
    def w(*a, **k):
        print("call", f.__name__, a, k)
        return f(*a, **k)
    return w
def tag(name):
    print("tag", name)
    def deco(f):
        print("apply", name)
        f.tag = getattr(f, "tag", ()) + (name,)
        return f
    return deco
@trace
def add(a, b=1): return a + b
print(add(1), add(1, b=2), add.__name__)
@tag("a")
@tag("b")
def f(): pass
print(f.tag)
@lambda c: (c, "wrapped")
class C: pass
print(C[1])
decos = {"x": lambda f: f() + 1}
@decos["x"]
def val(): return 41
print(val)
@(lambda f: f)
def ident(): return "id"
print(ident())
class Count:
    def __init__(self, f): self.f, self.n = f, 0
    def __call__(self, *a):
        self.n += 1
        return self.f(*a)
@Count
def sq(x): return x * x
print(sq(2), sq(3), sq.n)
class Reg:
    items = []
    @classmethod
    def add(cls, f):
        cls.items.append(f.__name__)
        return f
@Reg.add
def one(): pass
@Reg.add
class Two: pass
print(Reg.items)
class P:
    def __init__(self): self._v = 0
    @property
    def v(self):
        "the doc"
        return self._v
    @v.setter
    def v(self, x): self._v = x * 2
    @v.deleter
    def v(self): print("deleted"); self._v = None
    @property
    def ro(self): return "ro"
    @staticmethod
    def s(a): return a
    @classmethod
    def c(cls, a): return cls.__name__, a
    @staticmethod
    @trace
    def st(a): return a
p = P()
p.v = 5
print(p.v, P.v.__doc__, P.s(1), p.s(2), P.c(3), p.c(4), P.st(9))
del p.v
print(p.v)
for op in (lambda: setattr(p, "ro", 1), lambda: delattr(p, "ro")):
    try:
        op()
    except AttributeError as e:
        print(e)
def memo(f):
    cache = {}
    def w(n):
        if n not in cache:
            cache[n] = f(n)
        return cache[n]
    return w
@memo
def fib(n): return n if n < 2 else fib(n - 1) + fib(n - 2)
print(fib(80))
def cls_deco(cls):
    cls.extra = lambda self: "extra " + self.name
    return cls
@cls_deco
class Named:
    name = "nm"
print(Named().extra())
try:
    @undefined_deco
    def q(): pass
except NameError as e:
    print(e)
try:
    @5
    def q(): pass
except TypeError as e:
    print(e)
def order(n):
    print("eval", n)
    return lambda f: (print("apply", n), f)[1]
@order(1)
@order(2)
def h(x=print("default")): return x
