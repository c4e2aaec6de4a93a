import operator
from operator import *
def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

print(add(1, 2), sub(5, 3), mul("a", 3), truediv(1, 4), floordiv(-7, 2), mod(-7, 3), pow(2, 10), neg(5), pos(-5), invert(5), inv(0), abs(-3), lshift(1, 4), rshift(16, 2), and_(6, 3), or_(6, 3), xor(6, 3), not_([]), truth([0]), eq(1, 1.0), ne(1, 2), lt(1, 2), le(2, 2), gt("b", "a"), ge(1, 2), is_(None, None), is_not(1, None), index(True), concat([1], [2]), contains("abc", "b"), countOf([1, 2, 1], 1), indexOf("abc", "c"), getitem({"a": 1}, "a"), getitem([1, 2, 3], slice(1, None)), length_hint([1, 2]), length_hint(iter([1, 2, 3])), length_hint(5, 9), matmul if False else "")
l = [1, 2, 3]
print(setitem(l, 0, 9), l, delitem(l, 1), l, iadd(l, [4]), l, iconcat([1], [2]), imul([1], 2), isub(5, 2), ior({1}, {2}) == {1, 2}, iand(6, 3), ixor(5, 1), ipow(2, 3), ifloordiv(7, 2), imod(7, 4), itruediv(1, 2), ilshift(1, 2), irshift(8, 1))
g = itemgetter(1)
g2 = itemgetter(0, 2)
print(g("abc"), g2("abc"), g({1: "one"}), itemgetter("k")({"k": 5}), itemgetter(slice(1, 3))("abcd"), sorted([(1, "b"), (0, "c"), (2, "a")], key=itemgetter(1)), list(map(itemgetter(0), ["ab", "cd"])), g, g2, itemgetter(-1)([1, 2]))
class A:
    def __init__(self, v): self.v, self.inner = v, self if v == 1 else A(1) if v else None
    def m(self, x=0, *, y=1): return (self.v, x, y)
a = A(5)
print(attrgetter("v")(a), attrgetter("inner.v")(a), attrgetter("v", "inner.v")(a), attrgetter("real", "imag")(3 + 4j), methodcaller("m")(a), methodcaller("m", 7, y=8)(a), methodcaller("upper")("abc"), methodcaller("split", ",")("a,b"), attrgetter("v"), attrgetter("a.b", "c"), methodcaller("m", 1, y=2), sorted([A(0), A(1)], key=attrgetter("v"), reverse=True)[0].v, operator.call(lambda x: x + 1, 5))
for f in (lambda: itemgetter(), lambda: itemgetter(5)([1]), lambda: itemgetter("k")({}), lambda: attrgetter(), lambda: attrgetter(5), lambda: attrgetter("zz")(a), lambda: attrgetter("inner.zz")(a), lambda: methodcaller(), lambda: methodcaller(5), lambda: methodcaller("zz")(a), lambda: add(1, "a"), lambda: add(1), lambda: indexOf([1], 5), lambda: concat(1, 2), lambda: index(1.5), lambda: getitem([1], 5), lambda: contains(5, 1), lambda: truediv(1, 0), lambda: not_(), lambda: length_hint(1, "a"), lambda: countOf(5, 1), lambda: neg("a"), lambda: lt(1, "a"), lambda: itemgetter(1)(5)):
    t(f)
from functools import reduce
print(reduce(operator.mul, range(1, 6)), list(map(operator.add, [1, 2], [3, 4])), sum(map(operator.mul, [1, 2, 3], [4, 5, 6])), operator.__add__(1, 2), operator.__lt__(1, 2), operator.__contains__([1], 1), operator.__getitem__("abc", 0), operator.add.__name__)
class Vec:
    def __init__(self, *v): self.v = v
    def __matmul__(self, o): return sum(a * b for a, b in zip(self.v, o.v))
    def __imatmul__(self, o): return "imatmul"
print(matmul(Vec(1, 2), Vec(3, 4)), imatmul(Vec(1), Vec(2)), max({"a": 3, "b": 7}.items(), key=itemgetter(1)), min([A(0), A(1)], key=attrgetter("v")).v)
