import math
vals = [None, False, True, 0, 1, -1, 0.0, -0.0, 0.1, float("nan"), float("inf"), 0j, 1j, "", " ", "0", "False", b"", b"\0", [], [0], [[]], (), (0,), {}, {0: 0}, set(), {0}, frozenset(), range(0), range(1), range(5, 5), ..., NotImplemented if False else "ni", object(), int, print, lambda: 0, iter([]), (x for x in []), bytearray(), 2 ** 100, -(2 ** 100), slice(0), {}.keys(), {1: 1}.values(), zip(), map(str, []), enumerate([])]
print([int(bool(v)) for v in vals])
print([1 if v else 0 for v in vals])
print([not v for v in vals])
class L:
    def __init__(self, n): self.n = n
    def __len__(self): print("len", end=" "); return self.n
class B(L):
    def __bool__(self): print("bool", end=" "); return self.n > 5
class N: pass
print(bool(L(0)), bool(L(3)), bool(B(3)), bool(B(9)), bool(N()), bool(N), not L(0))
if L(1): print("truthy")
while not B(9): print("never")
print(L(0) or "default", L(2) and "both", [] or {} or "last", 1 and 2 and 3, 0 or None, None or 0, "" and 1, not not "x", (not []) + 1)
print(any([]), all([]), any([0, "", None]), all([1, "a", [0]]), any(x > 2 for x in [1, 3]), all(x for x in [1, 0]), any([[], [0]]), all([[]]))
print(list(filter(None, vals[:12])), list(filter(bool, [0, 1, 2])), [v for v in ["a", "", "b"] if v])
class Bad:
    def __bool__(self): return "yes"
class Neg:
    def __len__(self): return -1
class Err:
    def __bool__(self): raise ValueError("no truth")
for c in (Bad, Neg, Err):
    for f in (lambda: bool(c()), lambda: not c(), lambda: 1 if c() else 2, lambda: c() and 1, lambda: [x for x in [1] if c()], lambda: any([c()])):
        try:
            print(f())
        except Exception as e:
            print(type(e).__name__, e)
print(True == 1, True is (1 == 1), True + 1, False == 0, True == "True", isinstance(True, int), [True, False].index(1), {True: "t"}[1], max(True, 2), sorted([True, False, 2, -1]), sum([True, True]), str(True), repr(False), int(True), float(True), "%d" % True, f"{True}", f"{True:d}", f"{True:5}", True & 1, True and 1, 5 == True, bool("False"), True.real, True.bit_length(), True ^ True, True < 2, -True, ~True, True // 1, True ** 2, divmod(True, 2), round(True), abs(False), hash(True), True.__class__.__name__)
x = [] == False, [] == [], () == [], "" == None, 0 == None, 0 == "", 0 == False, 0.0 == False, None == None, None is None, math.nan == math.nan
print(x)
