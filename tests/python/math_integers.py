import math
def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

print(math.gcd(12, 18), math.gcd(), math.gcd(5), math.gcd(0, 0), math.gcd(-12, 18), math.gcd(12, 18, 27), math.gcd(2 ** 100, 6 ** 50), math.lcm(4, 6), math.lcm(), math.lcm(0, 5), math.lcm(-3, 5), math.lcm(2, 3, 4), math.lcm(10 ** 20, 15))
print(math.factorial(0), math.factorial(20), math.factorial(25), math.factorial(True), math.comb(5, 2), math.comb(5, 7), math.comb(0, 0), math.comb(100, 50), math.perm(5, 2), math.perm(5), math.perm(3, 5), math.perm(30, 20), math.isqrt(0), math.isqrt(17), math.isqrt(10 ** 40), math.isqrt(10 ** 40 - 1), math.isqrt(2 ** 64 - 1), math.prod([1, 2, 3]), math.prod([]), math.prod([2, 3], start=4), math.prod([0.5, 4]), math.prod(range(1, 25)), math.prod((x for x in [1.5, 2])), math.prod([True, 2]))
for f in (lambda: math.factorial(-1), lambda: math.factorial(1.0), lambda: math.factorial(2.5), lambda: math.factorial("a"), lambda: math.factorial(10 ** 20), lambda: math.gcd(1.5, 2), lambda: math.gcd("a"), lambda: math.lcm(1.0), lambda: math.comb(-1, 2), lambda: math.comb(5, -1), lambda: math.comb(1.5, 2), lambda: math.perm(-1), lambda: math.perm(5, -2), lambda: math.isqrt(-1), lambda: math.isqrt(2.0), lambda: math.prod(5), lambda: math.prod(["a"]), lambda: math.prod([1], 2), lambda: math.comb(5), lambda: math.gcd(a=1)):
    t(f)
print(math.floor(2.7), math.floor(-2.7), math.ceil(2.1), math.ceil(-2.1), math.trunc(2.9), math.trunc(-2.9), math.floor(5), math.ceil(10 ** 30), math.floor(1e20), math.ceil(-0.5), math.trunc(True), math.floor(-0.0), math.ceil(1e-300), type(math.floor(2.0)).__name__)
for f in (lambda: math.floor(float("inf")), lambda: math.ceil(float("nan")), lambda: math.trunc(float("-inf")), lambda: math.floor("a"), lambda: math.ceil(None), lambda: math.trunc("x"), lambda: math.floor([])):
    t(f)
class R:
    def __floor__(self): return "floor!"
    def __ceil__(self): return "ceil!"
    def __trunc__(self): return "trunc!"
class Fl:
    def __float__(self): return 2.5
class Ix:
    def __index__(self): return 9
print(math.floor(R()), math.ceil(R()), math.trunc(R()), math.floor(Fl()), math.ceil(Fl()), math.sqrt(Ix()), math.factorial(Ix()), math.gcd(Ix(), 6), math.isqrt(Ix()), math.hypot(Fl()), math.copysign(Ix(), -1))
t(lambda: math.trunc(Fl()))
