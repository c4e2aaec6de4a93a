class C:
    def __init__(self, n, suppress=False, enter_fail=False): self.n, self.s, self.ef = n, suppress, enter_fail
    def __enter__(self):
        print("enter", self.n)
        if self.ef: raise RuntimeError("enter " + self.n)
        return self.n
    def __exit__(self, t, v, tb):
        print("exit", self.n, t and t.__name__, v, tb is not None)
        return self.s
def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

with C("a") as a: print("body", a)
with C("a") as a, C("b") as b: print(a, b)
with (C("p") as p, C("q"),): print(p)
with (C("z")): print("plain")
with C("s", True): raise ValueError("suppressed")
print("after")
def nos():
    with C("n"): raise ValueError("not suppressed")
t(nos)
def two():
    with C("outer", True), C("inner"): raise KeyError("k")
    return "went on"
t(two)
def ef():
    with C("x"), C("y", enter_fail=True), C("never"): print("never")
t(ef)
def ret():
    with C("r"): return "returned"
t(ret)
def loop():
    for i in range(3):
        with C(str(i)):
            if i == 0: continue
            if i == 1: break
    return i
t(loop)
with C("t") as (x, *y): print(x, y)
class D: d = {}
with C("attr") as D.attr, C("item") as D.d["k"]: pass
print(D.attr, D.d)
class NoEnter:
    def __exit__(self, *a): pass
class NoExit:
    def __enter__(self): pass
def ne():
    with NoEnter(): pass
def nx():
    with NoExit(): pass
def n5():
    with 5: pass
t(ne); t(nx); t(n5)
class InstAttr:
    def __init__(self):
        self.__enter__ = lambda: 1
        self.__exit__ = lambda *a: None
def ia():
    with InstAttr(): pass
t(ia)
class Gen:
    def __init__(self, g): self.g = g
    def __enter__(self): return next(self.g)
    def __exit__(self, t, v, tb):
        if v is None:
            next(self.g, None)
            return False
        try:
            self.g.throw(v)
        except StopIteration:
            return True
        except BaseException as e:
            if e is v: return False
            raise
def manager(f): return lambda *a: Gen(f(*a))
@manager
def tag(n):
    print(f"<{n}>")
    try:
        yield n
    except ValueError as e:
        print("tag caught", e)
    finally:
        print(f"</{n}>")
with tag("h1") as h: print("in", h)
with tag("h2"): raise ValueError("oops")
def ke():
    with tag("h3"): raise KeyError("k")
t(ke)
def nested():
    with C("1"):
        try:
            with C("2"): raise ValueError("x")
        except ValueError: print("caught between")
        finally: print("fin")
nested()
class Truthy:
    def __enter__(self): return self
    def __exit__(self, *a): return "yes"
with Truthy(): 1 / 0
class Order:
    def __enter__(self): print("enter looked up")
    def __exit__(self, *a): print("exit args", [x.__name__ if isinstance(x, type) else x for x in a[:2]])
def mk():
    print("made")
    return Order()
with mk(): print("b")
def exc_in_target():
    with C("tt") as (a, b, c): pass
t(exc_in_target)
def fin():
    try:
        with C("w"): return 1
    finally:
        print("finally after exit")
t(fin)
def gen():
    with C("g"):
        yield 1
        yield 2
g = gen()
next(g)
g.close()
