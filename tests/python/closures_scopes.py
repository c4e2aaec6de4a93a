def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

def counter():
    n = 0
    def inc(by=1):
        nonlocal n
        n += by
        return n
    def get():
        return n
    return inc, get
inc, get = counter()
inc(); inc(5)
inc2, get2 = counter()
print(get(), get2())
g = 1
def change():
    global g, newg
    g += 1
    newg = "made"
change()
print(g, newg)
def local_before():
    print(v)
    v = 1
t(local_before)
def local_del():
    v = 1
    del v
    return v
t(local_del)
def free_unbound():
    def inner():
        return w
    if False:
        w = 1
    return inner()
t(free_unbound)
def free_deleted():
    w = 1
    def inner():
        return w
    del w
    return inner()
t(free_deleted)
def aug():
    g += 1
t(aug)
t(lambda: nowhere)
def shadow():
    len = lambda x: "mine"
    return len([1])
print(shadow(), len([1]))
def except_scope():
    e = "before"
    try:
        1 / 0
    except ZeroDivisionError as e:
        pass
    return e
t(except_scope)
def loop_var():
    for i in range(3):
        pass
    return i
print(loop_var())
def nested():
    a = 1
    def m():
        b = 2
        def n():
            nonlocal a, b
            a += 10
            b += 20
            return a, b
        r = n()
        return r, b
    r = m()
    return r, a
print(nested())
class K:
    g = "class"
    def meth(self):
        return g
    h = g
    def use(self, arg=g):
        return arg
print(K().meth(), K.h, K().use())
def f():
    z = "f"
    class L:
        y = z
        z = "L"
        def m(self):
            return z
    return L.y if hasattr(L, "y") else None, L.z, L().m()
t(f)
def f2():
    z = "f2"
    class L:
        y = z
        def m(self): return z
        class In:
            q = z
    return L.y, L().m(), L.In.q
t(f2)
print([f() for f in [lambda x=x: x for x in "abc"]])
adders = []
for k in range(3):
    def add(x):
        return x + k
    adders.append(add)
print([a(10) for a in adders])
def make():
    x = 1
    def s(v):
        nonlocal x
        x = v
    return s, lambda: x
s, r = make()
s("changed")
print(r())
def rec(n):
    return 1 if n == 0 else n * rec(n - 1)
print(rec(20))
del g
t(lambda: g)
def d():
    global g
    g = 9
    del g
    del g
t(d)
def unbound_del():
    del q
    q = 1
t(unbound_del)
x = 0
def swap():
    x = 1
    def in1():
        global x
        x = 2
        def in2():
            return x
        return in2()
    return in1(), x
print(swap(), x)
print(sorted(k for k in {**locals()} if k in ("x", "K")), globals()["x"], "x" in globals(), (lambda: sorted(locals()))(), (lambda a, b: sorted(locals().items()))(1, 2))
def fl():
    a = 1
    def h(): return a
    return sorted(k for k in locals())
print(fl())
class Meta:
    x = 1
    print(sorted(k for k in locals() if not k.startswith("__")))
def defaults(a, b=[], c={}):
    b.append(a)
    c[a] = 1
    return b, c
defaults(1)
print(defaults(2), defaults(3, [], {}), defaults.__defaults__)
f = lambda *a, k=5, **kw: (a, k, kw)
print(f(1, 2), f(k=1, z=2), (lambda: (yield))().__class__.__name__, (lambda x: lambda y: x + y)(1)(2))
print(inc.__closure__[0].cell_contents if inc.__closure__ else None, inc.__name__, inc.__qualname__, K.meth.__qualname__, (lambda: 0).__name__, counter.__module__)
