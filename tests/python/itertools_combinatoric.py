from itertools import product, permutations, combinations, combinations_with_replacement
def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

print(list(product("ab", [1, 2])), list(product([0, 1], repeat=3)), list(product()), list(product("ab", [])), list(product("a", repeat=0)), list(product("ab", "cd", repeat=1))[-1], len(list(product(range(4), repeat=4))), list(product(*[[1], [2, 3]])), list(product([1, 2], "x", repeat=2)))
print(list(permutations([1, 2, 3])), list(permutations("abc", 2)), list(permutations([1], 2)), list(permutations([])), list(permutations("ab", 0)), len(list(permutations(range(6)))), list(permutations("aab"))[:4], list(permutations(range(3), None))[-1])
print(list(combinations("abcd", 2)), list(combinations(range(4), 3)), list(combinations([1], 2)), list(combinations([], 0)), len(list(combinations(range(10), 4))), list(combinations("aa", 1)), list(combinations(range(3), 0)))
print(list(combinations_with_replacement("abc", 2)), list(combinations_with_replacement([1], 3)), list(combinations_with_replacement([], 2)), list(combinations_with_replacement([], 0)), len(list(combinations_with_replacement(range(5), 3))))
for f in (lambda: product(5), lambda: product("a", repeat=-1), lambda: product("a", repeat="x"), lambda: permutations(5), lambda: permutations("a", -1), lambda: permutations("a", 1.5), lambda: combinations("a", -1), lambda: combinations("a"), lambda: combinations(5, 1), lambda: combinations_with_replacement("a", -1), lambda: product("a", foo=1), lambda: combinations("ab", r="x")):
    t(f)
print(["".join(p) for p in permutations("abc")], sum(1 for c in combinations(range(12), 6) if sum(c) == 33), [(a, b, c) for a, b, c in combinations_with_replacement(range(1, 20), 3) if a * a + b * b == c * c], max(product([1, 2], [3, 4]), key=sum), list(map("".join, product("01", repeat=2))))
it = permutations(range(3))
print(next(it), next(it), len(list(it)), next(it, "done"))
def queens(n):
    return sum(1 for p in permutations(range(n)) if len({p[i] + i for i in range(n)}) == len({p[i] - i for i in range(n)}) == n)
print([queens(n) for n in range(1, 7)])
