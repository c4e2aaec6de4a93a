def t(f):
    try:
        v = f()
        print(sorted(v) if isinstance(v, (set, frozenset)) else v)
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

S = sorted
a, b = {1, 2, 3}, {2, 3, 4}
print(S(a | b), S(a & b), S(a - b), S(a ^ b), S(a.union(b, [9])), S(a.intersection(b, [2])), S(a.difference(b, [1])), S(a.symmetric_difference([3, 7])), S(a.union()), S(a.intersection()), S(a.union("x" for _ in ()) ), a.isdisjoint([5]), a.isdisjoint({1}), {1} <= a, {1} < a, a <= a, a < a, a >= {2}, a > {2}, a.issubset([1, 2, 3, 4]), a.issuperset([1]), a == {3, 2, 1}, a != b, a == frozenset(a), a == [1, 2, 3])
a.add(9); a.add(1); a.discard(100); a.discard(9); a.update([5, 6], (7,)); a.remove(7)
print(S(a), len(a), 5 in a, 10 not in a)
a |= {10}; a &= {1, 2, 10}; a -= {2}; a ^= {1, 3}
print(S(a))
a.intersection_update([3, 10, 4]); a.difference_update([10]); a.symmetric_difference_update([5])
print(S(a), S(a.copy()), a.copy() is a, a.clear(), a, set(), {1}, frozenset(), frozenset([1]), {None}, {"a"}, {(1, 2)})
t(lambda: {1}.remove(5))
t(lambda: {1}.remove("x"))
t(lambda: set().pop())
t(lambda: {1}.add([]))
t(lambda: {[]})
t(lambda: {{}})
t(lambda: {1} | [1])
t(lambda: {1} & "a")
t(lambda: {1}[0])
t(lambda: {1} < 5)
t(lambda: {1} + {1})
t(lambda: set(5))
t(lambda: frozenset([1]).add(1))
t(lambda: hash({1}))
t(lambda: {1}.union(5))
t(lambda: [] in {1})
t(lambda: {1} in {frozenset([1])})
t(lambda: {1}.remove([]))
t(lambda: {1}.discard([]))
def it():
    s = {1, 2}
    for v in s: s.add(v + 10)
t(it)
f = frozenset([1, 2])
print(S(f | {3}), type(f | {3}).__name__, type({3} | f).__name__, type(f & {1}).__name__, S(f.union([5])), f == {1, 2}, hash(f) == hash(frozenset([2, 1])), {f: "fs"}[frozenset([2, 1])], f.copy() is f, frozenset(f) is f, f <= {1, 2, 3}, S(f ^ {1}), f - {1})
g = f
g |= {3}
print(S(g), S(f))
print(S({1, 1.0, True}), len({0, False, 0.0}), {1, True}, {True, 1}, S({x % 3 for x in range(9)}), S(set("hello")), S(set(range(5))), S({*[1, 2], *{2, 3}}), S(set({"a": 1})), set([(1,)]), bool(set()), bool({0}))
s = {3}
print(s.pop(), s, sum({1, 2, 3}), max({1, 5, 2}), min({4, 2}), sorted({"b", "a"}, reverse=True), any({0, 1}), all({0}), len(set([1, 1, 2])), isinstance(f, set), isinstance(s, set), set.__name__, {1, 2}.__len__(), {1}.__contains__(1), {1}.__or__([1]), {1}.__eq__({1}))
x = {1, 2, 3, 4, 5}
print(S(v for v in x if v % 2), S(map(lambda v: v * 2, x)), S(zip(x, x)), list(dict.fromkeys([3, 1, 3, 2])), S(set([1, 2]) - set([2]) | {9} & {9, 8}))
class Q(frozenset):
    def __repr__(self): return "Q!"
print(Q([1]), Q([1]) | {2} == {1, 2}, type(Q([1]) | {2}).__name__, {Q([1]), frozenset([1])})
print(repr({1}), str(frozenset({2})), repr({"it's"}), [{1}], {"k": {2}}, {frozenset()}, repr({frozenset({1})}), set([float("nan")] * 2) != set())
u = set([10, 20])
u2 = u
u |= {30}
print(S(u2), u2 is u)
u.update()
u.update("ab", [1]) if False else u.update({40})
print(S(u), {1, 2}.isdisjoint({}), {1}.issuperset([]), set() <= set(), set() < {1}, {1}.issubset({1}), {1, 2} >= {1}, not {1} <= {2}, {1} == {1.0})
n = sum(1 for v in range(100) if v in {v for v in range(0, 100, 7)})
print(n, len({(i % 3, i % 2) for i in range(20)}), len({str(i) for i in range(50)}), len(set(range(1000)) & set(range(500, 1500))))
