a = [1]; b = a
a += [2]; print(a, b, a is b)
a = a + [3]; print(a, b, a is b)
a *= 2; print(a)
t = (1,); u = t
t += (2,); print(t, u)
s = "a"; r = s
s += "b"; s *= 2; print(s, r)
x = 7
x += 1.5; print(x)
x -= 1; x *= 2; x /= 5; x //= 1; x **= 3; x %= 7; print(x)
i = 12
i <<= 2; i >>= 1; i |= 1; i &= 0x1D; i ^= 6; i //= 2; i **= 2; i %= 40; i -= 3; print(i)
st = {1, 2}; alias = st
st |= {3}; st &= {2, 3, 4}; st -= {4}; st ^= {9}; print(sorted(st), st is alias)
d = {"a": 1}; e = d
d |= {"b": 2}; print(d, d is e)
class A: v = 10
o = A()
o.v += 5
print(o.v, A.v, o.__dict__)
l = [[1], 2]
l[0] += [5]; l[1] += 5; l[-1] *= 2; print(l)
m = {"k": [1], "n": 1}
m["k"] += "xy"; m["n"] -= 4; print(m)
try:
    m["zz"] += 1
except KeyError as err: print(repr(err))
try:
    tup = ([1], 2)
    tup[0] += [9]
except TypeError as err: print(err, tup)
try:
    un += 1
except NameError as err: print(err)
def f():
    try:
        loc += 1
        loc = 0
    except UnboundLocalError as err: print(err)
f()
calls = []
def idx(n):
    calls.append(n)
    return n
arr = [10, 20, 30]
arr[idx(1)] += idx(5)
print(arr, calls)
class I:
    def __init__(self, v): self.v = v
    def __add__(self, o): return I(self.v + o)
    def __repr__(self): return f"I{self.v}"
q = I(1); w = q
q += 5
print(q, w)
class J(I):
    def __iadd__(self, o): self.v += o * 100; return self
q = J(1); w = q
q += 5
print(q, w, q is w)
class K:
    def __iadd__(self, o): return None
k = K(); k += 1; print(k)
l = [1, 2, 3]
l += (4,); l += {5: 0}; l += range(2); l += "ab"; l[1:2] += [7, 8]
print(l)
try:
    l += 5
except TypeError as err: print(err)
try:
    t += [1]
except TypeError as err: print(err)
n = 5
n = n = n + 1
print(n)
def outer():
    c = 0
    def inc():
        nonlocal c
        c += 1
        return c
    inc(); inc()
    return c
print(outer())
total = 0
def g():
    global total
    total += 1
for _ in range(3): g()
print(total)
x = y = []
x += [1]; y = y + [2]
print(x, y)
f1 = 0.1
for _ in range(9): f1 += 0.1
print(f1)
z = 1j; z *= z; z += 1; print(z)
c = True; c += True; print(c, type(c).__name__)
c = True; c &= False; print(c); c |= 2; print(c)
M = [[0] * 2] * 2
M[0][0] += 1
print(M)
bs = b"a"; bs += b"b"; print(bs)
ba = bytearray(b"a"); bb = ba; ba += b"c"; print(ba, bb)
