# Every TypeError message for a bad call.
count = 0
def t(f):
    global count
    count += 1
    try:
        print(count, f())
    except TypeError as e:
        print(count, e)

def f0(): return "f0"
def f1(a): return a
def f2(a, b): return a, b
def f3(a, b, c): return a, b, c
def fd(a, b=2, c=3): return a, b, c
def fs(*args): return args
def fk(**kw): return kw
def fko(*, k): return k
def fko2(*, k, l, m=3): return k, l, m
def fpo(a, b, /): return a, b
def fpod(a, b=2, /, c=3, *, d=4): return a, b, c, d
def fall(a, /, b, *args, c, d=5, **kw): return a, b, args, c, d, kw
def fpk(a, /, **kw): return a, kw
def fask(a, *args, k): return a, args, k
for call in (
    lambda: f0(1), lambda: f0(1, 2), lambda: f0(x=1), lambda: f1(), lambda: f1(1, 2), lambda: f1(1, a=2), lambda: f1(b=1), lambda: f1(1, b=2),
    lambda: f2(), lambda: f2(1), lambda: f2(b=1), lambda: f2(1, 2, 3), lambda: f2(1, 2, 3, 4), lambda: f2(1, a=3), lambda: f3(), lambda: f3(1), lambda: f3(b=2),
    lambda: fd(), lambda: fd(1, 2, 3, 4), lambda: fd(1, c=5), lambda: fd(1, 2, b=3), lambda: fd(b=1), lambda: fd(1, d=1), lambda: fd(1, 2, 3, 4, 5),
    lambda: fs(a=1), lambda: fs(), lambda: fs(1, 2), lambda: fk(1), lambda: fk(1, 2, a=1), lambda: fk(a=1),
    lambda: fko(), lambda: fko(1), lambda: fko(1, k=2), lambda: fko(k=1), lambda: fko(k=1, z=2), lambda: fko(1, 2, k=2), lambda: fko2(), lambda: fko2(k=1), lambda: fko2(m=1), lambda: fko2(1),
    lambda: fpo(), lambda: fpo(1), lambda: fpo(1, b=2), lambda: fpo(a=1, b=2), lambda: fpo(1, 2, 3), lambda: fpo(1, 2, b=3), lambda: fpo(1, 2),
    lambda: fpod(1), lambda: fpod(a=1), lambda: fpod(1, b=3), lambda: fpod(1, 2, 3, 4), lambda: fpod(1, 2, 3, d=9), lambda: fpod(1, 2, 3, 4, d=5), lambda: fpod(1, 2, 3, 4, 5, d=5, e=1),
    lambda: fall(1), lambda: fall(1, 2), lambda: fall(1, 2, c=3), lambda: fall(1, b=2, c=3, a=9), lambda: fall(1, 2, 3, 4, c=5, z=6), lambda: fall(b=1, c=2), lambda: fall(), lambda: fall(1, 2, b=3, c=4),
    lambda: fpk(1, a=2), lambda: fpk(a=2), lambda: fask(1, 2), lambda: fask(k=1), lambda: fask(),
    lambda: (lambda x: x)(), lambda: (lambda: 0)(1), lambda: (lambda *a, k: k)(), lambda: (lambda x, y=1: x)(1, 2, 3),
    lambda: f1(*(1, 2)), lambda: f1(**{"b": 1}), lambda: f1(1, **{"a": 1}), lambda: f1(*[], **{}), lambda: f2(*"ab"), lambda: f2(**{"a": 1, "b": 2}),
):
    t(call)
class A:
    def m(self): return "m"
    def m1(self, x): return x
    def mk(self, *, k): return k
    @staticmethod
    def s(x): return x
    @classmethod
    def c(cls, x): return cls.__name__, x
    def __call__(self, x): return x
class B:
    def __init__(self, x, y=1): self.x = x
class E: pass
class N:
    def __new__(cls, x): return object.__new__(cls)
a = A()
for call in (
    lambda: a.m(1), lambda: a.m1(), lambda: a.m1(1, 2), lambda: a.m1(y=1), lambda: a.m1(1, x=2), lambda: A.m(), lambda: A.m1(1), lambda: A.m1(), lambda: a.mk(1), lambda: a.mk(),
    lambda: a.s(), lambda: a.s(1, 2), lambda: A.s(1), lambda: a.c(), lambda: A.c(1, 2), lambda: A.c(3), lambda: a(), lambda: a(1, 2), lambda: a(x=4),
    lambda: B(), lambda: B(1, 2, 3), lambda: B(1, z=2), lambda: B(1, x=2), lambda: E(1), lambda: E(x=1), lambda: N(), lambda: N(1, 2), lambda: A(1), lambda: object(1), lambda: B(y=2),
    lambda: 5(), lambda: None(), lambda: "a"(), lambda: [](1), lambda: {}(), lambda: a.m()(), lambda: (1, 2)(3), lambda: ...(), lambda: E()(), lambda: NotImplemented(), lambda: True(), lambda: 1.5(),
):
    t(call)
