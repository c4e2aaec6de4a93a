def f(a, b=2, /, c=3, *args, d, e=5, **kw):
    "docstring"
    return a, b, c, args, d, e, kw
print(f(1, d=4), f(1, 2, 3, 4, 5, d=6, e=7, z=8), f(1, d=4, b=9, a=10), f.__name__, f.__doc__, f.__defaults__, f.__kwdefaults__, f.__qualname__, f.__module__, f.__annotations__, f.__dict__)
f.attr = 5
f.__doc__ = "new doc"
f.__name__ = "renamed"
print(f.attr, f.__doc__, f.__name__, f.__dict__, hasattr(f, "zz"))
def mut(x, acc=[]):
    acc.append(x)
    return acc
print(mut(1), mut(2), mut(3, []), mut(4), mut.__defaults__)
n = 5
def late(x=n): return x
n = 10
print(late(), late(n))
late.__defaults__ = (99,)
print(late())
late.__defaults__ = None
try: late()
except TypeError as e: print(e)
def kwo(*, a, b=1): return a, b
kwo.__kwdefaults__ = {"a": 7}
print(kwo.__kwdefaults__, end=" ")
try: print(kwo())
except TypeError as e: print(e)
def va(*args, **kwargs): return args, kwargs
print(va(), va(1), va(a=1), va(*[1, 2], **{"x": 3}), va(*"ab", *(1,), k=1, **{"l": 2}), va(*range(2), 5, *[]), va(**{"not identifier": 1, "": 2}))
args = [1, 2]; kw = {"k": 1}
a2, k2 = va(*args, **kw)
args.append(3); kw["z"] = 1
print(a2, k2)
def ret():
    return 1, 2
def none(): pass
def bare(): return
print(ret(), none(), bare(), (lambda: (1, 2))())
def annotated(x: int, y: "str" = "a", *z: float, k: list = None, **o: dict) -> bool: return True
print(annotated.__annotations__, annotated(1))
def outer():
    def inner(): pass
    class C:
        def m(self): pass
    return inner.__qualname__, C.__qualname__, C.m.__qualname__, (lambda: 0).__qualname__
print(outer())
def rec(n): return [] if n == 0 else [n] + rec(n - 1)
print(rec(5))
def apply(fn, *a, **k): return fn(*a, **k)
print(apply(max, 1, 2), apply(sorted, [2, 1], reverse=True), apply(lambda x, y=2: x + y, 1), apply(str.upper, "a"), apply("{}-{x}".format, 1, x=2), apply(dict, a=1), apply(int, "ff", 16), apply([].__len__), apply(print, "p", end="|\n"))
fns = {"add": lambda a, b: a + b, "sub": lambda a, b: a - b}
print({k: v(5, 3) for k, v in fns.items()}, [g.__name__ for g in (len, print, f)], (lambda f, x: f(f(x)))(lambda v: v * 3, 2))
def compose(*fs):
    def run(x):
        for g in reversed(fs): x = g(x)
        return x
    return run
print(compose(str, lambda x: x + 1, abs)(-5))
def curry(f, n, *got): return f(*got) if len(got) >= n else lambda x: curry(f, n, *got, x)
print(curry(lambda a, b, c: (a, b, c), 3)(1)(2)(3))
def gen_args(): yield 1; yield 2
print(va(*gen_args()), max(*gen_args()), [*gen_args()])
def shadow(len, str=3): return len, str
print(shadow(1), shadow(len=2, str=5))
def self_ref(): return self_ref.count
self_ref.count = 7
print(self_ref())
try:
    f.__name__ = 5
except TypeError as e: print(e)
try:
    f.__defaults__ = 5
except TypeError as e: print(e)
try:
    f.__dict__ = 5
except TypeError as e: print(e)
print(type(f).__name__, callable(f), f == f, f != late, bool(f), f is f, isinstance(f, type(lambda: 0)))
def doc1():
    """multi
    line doc"""
def doc2(): "a" "b"
def doc3(): f"not a doc"
def doc4(): b"no"
print(repr(doc1.__doc__), doc2.__doc__, doc3.__doc__, doc4.__doc__)
def many(a, b, c, d, e, f, g, h, i, j, k=1, l=2, *m, n=3, **o): return locals()
print(many(*range(10), 11, 12, 13, n=5, q=7))
