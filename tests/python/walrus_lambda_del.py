if (n := len([1, 2, 3])) > 2: print("n", n)
while (line := ["a", "b", ""].pop(0) if n == 3 else "") and n > 2:
    print(line); n -= 1
data = [1, 5, 3]
print([y for x in data if (y := x * 2) > 4], y, (z := 5) + z, (lambda: (q := 7))(), [w := 1, w + 1], {"k": (v := 2)}, v, f"{(u := 3)}", u)
def f():
    return [last := i for i in range(3)], last
print(f())
def g(a, b=(d := 4)): return a + b
print(g(1), d)
print((a := 1, b := 2), a, b, any((hit := x) > 2 for x in data), hit, not (m := 0), m)
x = 10
[x := i for i in range(3)]
print(x)
add = lambda a, b=2, *c, d=4, **e: (a, b, c, d, e)
print(add(1), add(1, 3, 5, d=6, z=7), (lambda: 5)(), (lambda *a: a)(1, 2), (lambda **k: k)(a=1), (lambda a, /, b, *, c: (a, b, c))(1, b=2, c=3), (lambda x: (lambda y: x * y))(3)(4), [f(2) for f in (lambda v: v + 1, lambda v: v * 10)], sorted("bca", key=lambda c: -ord(c)), (lambda x: x if x else "zero")(0), (lambda: [i for i in range(3)])(), (lambda: None)())
fact = lambda n: 1 if n < 2 else n * fact(n - 1)
print(fact(10), (lambda f: f(f, 5))(lambda self, n: n and n + self(self, n - 1)), list(map(lambda p: p[0] + p[1], [(1, 2), (3, 4)])))
l = list(range(6))
del l[0], l[-1]
print(l)
del l[1:3]
print(l)
d = {"a": 1, "b": 2}
del d["a"]
print(d)
class C: p = 1; q = 2
del C.p
print(hasattr(C, "p"), C.q)
o = C(); o.r = 5
del o.r
for bad in (lambda: o.r, lambda: C.p):
    try: bad()
    except AttributeError as e: print(e)
v1 = v2 = 3
del v1
try: v1
except NameError as e: print(e)
del (v2), l[0]
print(l)
x, y = 1, 2
del x, y
def h():
    loc = 1
    del loc
    try: return loc
    except UnboundLocalError as e: return str(e)
print(h())
def k():
    for i in range(2): pass
    del i
    try: i
    except UnboundLocalError as e: print(e)
k()
def unb():
    try: del nothing
    except UnboundLocalError as e: print(e)
    nothing = 1
unb()
try: del never_defined
except NameError as e: print(e)
try: del d["zz"]
except KeyError as e: print(repr(e))
try: del l[50]
except IndexError as e: print(e)
try: del (1).real
except AttributeError as e: print(e)
def cl():
    c = 1
    def inner(): return c
    del c
    try: return inner()
    except NameError as e: return str(e)
print(cl())
def glob():
    global made
    made = 1
    del made
    try: return made
    except NameError as e: return str(e)
print(glob())
m = [[1, 2], [3, 4]]
del m[0][1], m[1]
print(m)
class D:
    def __delattr__(self, n): print("delattr", n)
    def __delitem__(self, k): print("delitem", k)
t = D()
del t.x, t["k"], t[1:2], t[...]
(del_ok := 1)
print(del_ok)
