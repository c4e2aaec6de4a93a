class A:
    __x = 1
    def __init__(self): self.__y = 2; self.___z = 3; self.__w__ = 4; self._p = 5
    def get(self): return self.__x, self.__y, self.___z, self.__w__
    def __m(self): return "A.__m"
    def call(self): return self.__m()
    def kw(self, __k=1): return __k
    def loc(self):
        __v = 9
        return sorted(k for k in locals() if "v" in k)
    class Inner:
        __i = "inner"
        def g(self): return self.__i
class B(A):
    __x = 10
    def __m(self): return "B.__m"
    def both(self): return self.__m(), self.call(), self.__x, self._A__x
a, b = A(), B()
print(a.get(), b.get(), sorted(vars(a)), b.both(), a.kw(), a.kw(_A__k=5), a.loc(), A.Inner().g(), A.Inner._Inner__i, sorted(n for n in vars(A) if "_A" in n))
for f in (lambda: a.__y, lambda: A.__x, lambda: a.kw(__k=5)):
    try: print(f())
    except (AttributeError, TypeError) as e: print(e)
class _Under:
    __v = 1
class __: 
    __v = 2
print(_Under._Under__v, [k for k in vars(__) if k.endswith("v")])
class C:
    def f(self):
        global __glob
        __glob = 5
        return __glob
C().f()
print(_C__glob)
class D:
    import math as __m
    def pi(self): return self.__m.floor(3.7)
    try: raise ValueError
    except ValueError as __e: pass
    for __i in range(2): pass
    def has(self): return hasattr(D, "_D__i"), hasattr(D, "_D__e")
print(D().pi(), D().has())
x = "global"
class E:
    x = "class"
    y = x
    def f(self): return x
    g = lambda self: x
    z = [x for _ in range(1)]
    w = [v for v in x]
    print(x, y, z, w)
    def default(self, p=x): return p
    x = "rebound"
    q = x
print(E().f(), E().g(), E.q, E().default(), E.z)
def outer():
    x = "outer"
    class F:
        y = x
        x = "f class"
        z = x
        def m(self): return x
    return F.y if hasattr(F, "y") else None, F.z, F().m()
try: print(outer())
except NameError as e: print(e)
def outer2():
    v = "enclosing"
    class G:
        a = v
        def m(self): return v
        class H:
            b = v
            def n(self): return v
    v = "changed"
    return G.a, G().m(), G.H.b, G.H().n()
print(outer2())
class I:
    global made_in_class
    made_in_class = 1
    a = 2
    del a
print(made_in_class, hasattr(I, "a"), hasattr(I, "made_in_class"))
def outer3():
    n = 1
    class J:
        nonlocal n
        n = 2
        k = n
    return n, J.k, hasattr(J, "n")
print(outer3())
class K:
    print(__qualname__, __module__)
    __qualname__ = "Renamed"
    l = sorted(k for k in locals())
print(K.__qualname__, K.__name__, K.l, repr(K))
class L:
    for i in range(3):
        exec_ = i
    if i == 2: cond = "yes"
    while i: i -= 1
    with type("X", (), {"__enter__": lambda s: 5, "__exit__": lambda s, *a: None})() as entered: pass
    try: 1 / 0
    except ZeroDivisionError: caught = True
    def meth(self): return __class__
    @staticmethod
    def st(): return __class__.__name__
print(L.i, L.exec_, L.cond, L.entered, L.caught, L().meth() is L, L.st())
