a = b = [1]
c = [1]
print(a is b, a is c, a == c, a is not c, None is None, () is (), "abc" is "abc", 1 is 1, True is True, ... is Ellipsis, NotImplemented is NotImplemented, type(a) is list, type(1) is int, int is int, a is a is b, print is print)
print(1 < 2 < 3, 1 < 3 < 2, 3 > 2 > 1, 1 < 2 > 1, 1 == 1.0 == True, 1 < 2 == 2, (1 < 2) == True, 1 < (2 == 2), 1 != 2 != 1, 1 in [1] == True, (1 in [1]) == True, "a" < "b" <= "b" < "c", 1 <= 1 >= 1, not 1 == 2, not (1 == 2), -1 < 0 < 1, 5 > 3 == 3)
print([1, 2] < [1, 2, 0], (1, "b") < (1, "c"), "Z" < "a", "10" < "9", "" < "a", [] < [[]], {1} < {1, 2}, {1} <= {1}, frozenset([1]) == {1}, {1: 2} == {1: 2}, [1, [2]] == [1, [2]], (1,) == [1], 1 == "1", None == 0, "a" == b"a", b"a" < b"b", range(3) == range(0, 3), 2 ** 60 < 2.0 ** 61, -0.0 == 0.0, float("nan") != float("nan"))
for f in (lambda: 1 < "a", lambda: [] < (), lambda: None < 1, lambda: {} < {}, lambda: 1j < 2j, lambda: object() < object(), lambda: int < str, lambda: [1, "a"] < [1, 2], lambda: (None,) < (None, 1), lambda: (None,) < (1,), lambda: "a" > 1, lambda: 1 <= None, lambda: [] >= {}, lambda: {1} < [1], lambda: range(1) < range(2), lambda: print < len, lambda: ... < ..., lambda: b"a" < "a"):
    try:
        print(f())
    except TypeError as e:
        print(e)
class E:
    def __init__(self, v): self.v = v
    def __eq__(self, o):
        print("eq", self.v, getattr(o, "v", o), end="; ")
        return self.v == getattr(o, "v", o)
print(E(1) == E(1), E(1) != E(2), E(1) == 1, 1 == E(1), 1 != E(2), [E(1)] == [E(1)], E(1) in [E(2), E(1)], (E(1), 2) == (E(1), 3), {"k": E(1)} == {"k": E(1)})
e = E(5)
print([e] == [e], e in [e], [e].index(e), [e, e].count(e), (e,) == (e,))
class D: pass
d = D()
print(d == d, d == D(), d != d, d != D(), d.__eq__(d), d.__eq__(1), d.__ne__(d), d.__lt__(d), d.__hash__() == hash(d))
class Sub(E): 
    def __eq__(self, o): print("sub", end="; "); return True
print(E(1) == Sub(2), Sub(1) == E(2))
class OnlyLt:
    def __lt__(self, o): return "lt"
    def __ge__(self, o): return "ge"
print(OnlyLt() < 1, 1 > OnlyLt(), OnlyLt() >= 1, 1 <= OnlyLt())
try:
    OnlyLt() > 1
except TypeError as err: print(err)
x = 257; y = 257
print(x == y, 1000 == 10 ** 3, id(a) == id(b), id(a) != id(c), (a is b) == (id(a) == id(b)))
nan = float("nan")
print(nan in [nan], [nan] == [nan], nan == nan, (nan,) == (nan,), {nan} == {nan}, [nan].count(nan), [float("nan")] == [float("nan")], nan is nan, min(nan, 1) is nan, sorted([3, nan, 1])[0])
print(1 == 1.0 and hash(1) == hash(1.0), 10 ** 20 == 1e20, 10 ** 23 == 1e23, 0.1 + 0.2 == 0.3, 2 ** 53 == 2.0 ** 53 + 1, 9007199254740993 == 9007199254740992.0, 9007199254740993 > 9007199254740992.0, 1e308 < 10 ** 309, float("inf") > 10 ** 400, -float("inf") < -10 ** 400, 1 == 1 + 0j, 0.5 == 1 / 2)
print("a" in "abc", "" in "", "ac" in "abc", 1 in {1: 2}, 2 in {1: 2}, 1.0 in [1], True in [1], None in [None], "1" in [1], (1, 2) in [(1, 2)], [] in [[]], 3 in range(5), 3.0 in range(5), 3.5 in range(5), "k" not in {"k": 1}, 5 in (x for x in [1, 5]), b"a" in b"abc", 97 in b"abc")
