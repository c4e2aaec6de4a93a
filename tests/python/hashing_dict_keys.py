def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")
print(hash(0), hash(1), hash(-1), hash(-2), hash(2 ** 61 - 1), hash(2 ** 61), hash(-(2 ** 61)), hash(2 ** 200), hash(0.0), hash(-0.0), hash(1.0), hash(0.5), hash(1.5), hash(1e308), hash(5e-324), hash(float("inf")), hash(float("-inf")), hash(True), hash(False), hash(1 + 0j), hash(1j), hash(2.5 + 1.5j), hash(()), hash((1,)), hash((1, 2, 3)), hash((1.0, 2)), hash(((),)), hash((0, 0)), hash((-1,)), hash(range(5)) == hash(range(0, 5)), hash(None) == hash(None), hash(frozenset()), hash(frozenset([1, 2, 3])), hash(frozenset([3, 2, 1])), hash(frozenset([0])), hash(frozenset([(1, 2)])), hash(10 ** 18), hash(-10 ** 18), hash(123456.789), hash(-1.0), hash(-0.5))
print({1: "a", 1.0: "b", True: "c"}, {0: 1, False: 2, 0.0: 3, 0j: 4}, {(1, 2): 1}[(1.0, 2)], {"a": 1, "a": 2}, {1, 1.0, True}, len({0, -0.0, False}), {2 ** 53: 1}.get(2.0 ** 53), {frozenset([1]): 1}[frozenset([1.0])], 1.0 in {1}, (1, 2) in {(1.0, 2.0)}, {None: 1}[None], {...: 2}[...], {int: "int"}[int], {len: 1}[len])
for v in ([], {}, set(), bytearray(), ([],), (1, {}), slice(1), {}.keys(), [1]):
    t(lambda: hash(v))
    t(lambda: {v: 1})
    t(lambda: {v})
    t(lambda: v in {})
t(lambda: {[1]: 2 for _ in range(1)})
t(lambda: {}.get([]))
t(lambda: {1}.add([]))
t(lambda: [] in {1})
t(lambda: {}.setdefault([], 1))
t(lambda: dict([([], 1)]))
t(lambda: dict.fromkeys([[]]))
t(lambda: set([[]]))
t(lambda: {}.pop([]))
class Eq:
    def __init__(self, v): self.v = v
    def __eq__(self, o): return isinstance(o, Eq) and self.v == o.v
t(lambda: hash(Eq(1)))
t(lambda: {Eq(1)})
print(Eq.__hash__, Eq(1) == Eq(1))
class H(Eq):
    def __hash__(self): return hash(self.v)
print({H(1): "x"}[H(1)], H(1) in {H(1)}, len({H(1), H(1), H(2)}), {H(1): 1} == {H(1): 1}, hash(H(5)))
class Restore(Eq):
    __hash__ = object.__hash__
print(isinstance(hash(Restore(1)), int), len({Restore(1), Restore(1)}))
class NoHash: __hash__ = None
t(lambda: hash(NoHash()))
class Col:
    log = []
    def __init__(self, n): self.n = n
    def __hash__(self): return 42
    def __eq__(self, o): Col.log.append((self.n, o.n)); return self.n == o.n
    def __repr__(self): return f"C{self.n}"
d = {Col(1): "one", Col(2): "two"}
d[Col(3)] = "three"
print(d, Col.log)
Col.log.clear()
print(d[Col(2)], len(Col.log) > 0, Col(9) in d, d.pop(Col(1)), d, list(d))
class Bad:
    def __hash__(self): raise ValueError("no hash today")
    def __eq__(self, o): return True
t(lambda: {Bad(): 1})
class BadEq:
    def __hash__(self): return 1
    def __eq__(self, o): raise RuntimeError("eq failed")
t(lambda: len({BadEq(), BadEq()}))
t(lambda: {1: 0}.get(BadEq()))
class RetBad:
    def __hash__(self): return 1.5
t(lambda: hash(RetBad()))
class Big:
    def __hash__(self): return 2 ** 100
print(hash(Big()) == hash(2 ** 100))
class Bh:
    def __hash__(self): return True
print(hash(Bh()))
m = {}
k = [1]
m[tuple(k)] = "t"
print(m[(1,)], m.get(tuple([1])), {**m, (2,): 1})
obj = object()
print({obj: 1}[obj], obj in {obj}, object() in {obj})
nan = float("nan")
dn = {nan: 1}
print(dn[nan], float("nan") in dn, len({nan, nan}), len({float("nan"), float("nan")}))
s = {1, "a", (1, 2), None, frozenset()}
print(len(s), all(x in s for x in (1, "a", (1, 2), None, frozenset(), 1.0)), (1, 2.0) in s, set() in [frozenset()], set() in {frozenset()})
