def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

print(list(map(str, [1, 2])), list(map(lambda a, b: a + b, [1, 2, 3], [10, 20])), list(map(None.__class__, [])), list(map(int, "123")), list(filter(None, [0, 1, "", "a"])), list(filter(lambda x: x > 1, [1, 2, 3])), list(filter(str.isdigit, "a1b2")), list(zip([1, 2], "ab")), list(zip()), list(zip([1])), list(zip([1, 2, 3], "ab", (True,))), list(zip(*[(1, 2), (3, 4)])), list(zip([1], [2], strict=True)), dict(zip("ab", range(2))))
print(list(enumerate("ab")), list(enumerate("ab", 5)), list(enumerate("ab", start=-1)), list(reversed([1, 2])), list(reversed("ab")), list(reversed(range(3))), list(reversed({"a": 1, "b": 2})), list(reversed((1,))), sorted([3, 1], reverse=True), sorted("hello"), sorted({"b", "a"}), sorted([("a", 2), ("a", 1)]), sum([1, 2]), sum([[1], [2]], []), sum([0.1, 0.2, 0.3]), sum([], 5), sum((1, 2), start=10), sum(range(101)), sum(x * x for x in range(4)), sum([1j, 2]), sum([(1,), (2,)], ()))
print(min(3, 1, 2), max([1, 5, 2]), min("hello"), max("a", "b", key=lambda c: -ord(c)), min([], default="none"), max((), default=None), max([1, -5], key=abs), min([3, 1, 2], key=lambda x: -x), max([(1, "a"), (1, "b")]), max([1, 1.0]), min([1, 1.0, True]), max({"a": 1, "b": 2}), min({1: 9, 0: 5}), max("abc", "abd"), max([[1], [0, 9]]), max(i for i in [1, 3, 2]), any([0, 1]), all([]), any(x == 2 for x in range(5)), all(x for x in range(1, 3)))
it = iter([1, 2])
print(next(it), next(it), next(it, "default"), next(it, None), list(iter(lambda l=[3, 2, 1]: l.pop(), 1)), [x for x in iter("ab")], type(iter({})).__name__, type(iter("")).__name__ != "", iter(it) is it)
for f in (lambda: next(iter([])), lambda: next(zip()), lambda: list(zip([1], [], strict=True)), lambda: list(zip([], [1], strict=True)), lambda: list(zip([1, 2], [1, 2], [1], strict=True)), lambda: list(zip([1], [1, 2], [1, 2], strict=True)), lambda: list(map(lambda x: x, [1], [2])), lambda: list(map(lambda: 0, [1])), lambda: list(map(len, [1])), lambda: sum(["a", "b"]), lambda: sum([[1]]), lambda: min([1, "a"]), lambda: max([]), lambda: max(1), lambda: max(None, 1), lambda: min(key=abs), lambda: max([1], key=1), lambda: sorted([1, None]), lambda: sorted(5), lambda: reversed({1}), lambda: reversed(iter([])), lambda: list(filter(5, [1])), lambda: enumerate("a", 1.5), lambda: [*map(int, ["1", "x"])], lambda: next(5), lambda: iter(None), lambda: sum(1, 2), lambda: any(None), lambda: all(1)):
    t(f)
m = map(lambda x: x * 2, [1, 2, 3])
print(next(m), list(m), list(m), next(m, "end"))
def show(x):
    print("saw", x, end=" ")
    return x
z = zip(map(show, [1, 2, 3]), map(show, "ab"))
print(list(z))
print([a for a in filter(show, [0, 1])], any(map(show, [0, 5, 6])), all(map(show, [1, 0, 9])), max(map(show, [1, 3]), key=show))
e = enumerate(["x", "y"])
print(next(e), list(e))
s = "abc"
for i, (a, b) in enumerate(zip(s, s[1:])): print(i, a + b, end=" ")
print()
class It:
    def __init__(self, n): self.n = n
    def __iter__(self): return iter(range(self.n))
    def __len__(self): return 99
    def __reversed__(self): return "rev!"
print(list(It(3)), sum(It(4)), max(It(5)), sorted(It(3), reverse=True), tuple(It(2)), set(It(2)) == {0, 1}, [*It(2)], reversed(It(1)), len(It(1)), 2 in It(3), dict(enumerate(It(2))), list(zip(It(2), It(9))), list(map(str, It(2))))
class Raise:
    def __iter__(self): yield 1; raise KeyError("mid")
for f in (lambda: list(Raise()), lambda: sum(Raise()), lambda: sorted(Raise()), lambda: dict.fromkeys(Raise()), lambda: ",".join(map(str, Raise())), lambda: [x for x in Raise()], lambda: max(Raise()), lambda: 5 in Raise(), lambda: tuple(zip(Raise(), "abc")), lambda: all(Raise())):
    t(f)
print(1 in Raise(), any(Raise()), next(iter(Raise())))
