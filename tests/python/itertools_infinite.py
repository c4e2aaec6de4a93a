from itertools import *
import itertools, operator
def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

c = count(5)
print(next(c), next(c), c, count(), count(1, 2), count(0.5, 0.25), [x for _, x in zip(range(4), count(0.5, 0.25))], list(islice(count(10, -3), 4)), count(-5), list(islice(count(2 ** 63 - 1), 3)), list(islice(count(step=5), 3)))
cy = cycle("ab")
print([next(cy) for _ in range(5)], list(islice(cycle([1, 2, 3]), 7)), list(cycle([])))
print(list(repeat("x", 3)), list(repeat(1, 0)), list(repeat(1, -5)), repeat(5), repeat("a", 2), list(zip(repeat(1), "ab")), list(map(pow, range(4), repeat(2))), repeat(1, 3).__length_hint__())
print(list(accumulate([1, 2, 3, 4])), list(accumulate([3, 1, 4], max)), list(accumulate([1, 2, 3], operator.mul)), list(accumulate([1, 2], initial=100)), list(accumulate([])), list(accumulate([], initial=5)), list(accumulate("abc")), list(accumulate([1, 2, 3], lambda a, b: a * 10 + b)), list(accumulate([2, 3], func=operator.sub, initial=10)))
print(list(chain("ab", [1], ())), list(chain()), list(chain.from_iterable(["ab", [1, 2]])), list(chain.from_iterable(x * 2 for x in "xy")), list(chain({"k": 1}, range(2))))
print(list(compress("abcdef", [1, 0, 1, 0, 1])), list(compress("abc", [True, False, True, True])), list(dropwhile(lambda x: x < 3, [1, 3, 2, 5])), list(takewhile(lambda x: x < 3, [1, 2, 3, 1])), list(filterfalse(lambda x: x % 2, range(6))), list(filterfalse(None, [0, 1, "", "a"])), list(starmap(pow, [(2, 3), (3, 2)])), list(starmap(lambda *a: sum(a), [(1,), (1, 2, 3), ()])))
print(list(islice("abcdef", 3)), list(islice("abcdef", 2, 4)), list(islice("abcdef", 1, None, 2)), list(islice("abc", None)), list(islice("abc", 10)), list(islice(range(10), 0, 8, 3)), list(islice([], 5)), list(islice("abc", 0)))
it = iter(range(10))
print(list(islice(it, 3)), next(it), list(islice(it, 1, 3)), list(it))
print(list(pairwise("abcd")), list(pairwise([1])), list(pairwise([])), list(zip_longest("abc", [1])), list(zip_longest("ab", [1, 2, 3], fillvalue="-")), list(zip_longest()), list(zip_longest([1], [], [2, 3])))
a, b = tee([1, 2, 3])
print(next(a), next(a), list(b), list(a), [list(x) for x in tee("ab", 3)], tee([], 0), list(tee(iter("xy"))[1]))
print([(k, list(g)) for k, g in groupby("aabbca")], [(k, len(list(g))) for k, g in groupby([1, 1, 2, 3, 3])], [(k, list(g)) for k, g in groupby(range(6), key=lambda x: x // 2)], [k for k, g in groupby("aab")], list(groupby([])), [(k, [v for _, v in g]) for k, g in groupby([("x", 1), ("x", 2), ("y", 3)], key=lambda p: p[0])])
g = groupby("aab")
k1, g1 = next(g)
k2, g2 = next(g)
print(k1, list(g1), k2, list(g2))
for f in (lambda: islice("a", -1), lambda: islice("a", 0, -1), lambda: islice("a", 0, 1, 0), lambda: islice("a", "x"), lambda: islice("a"), lambda: repeat(), lambda: cycle(), lambda: cycle(5), lambda: chain(5).__next__(), lambda: list(chain([1], 5)), lambda: count("a"), lambda: list(accumulate(5)), lambda: list(accumulate([1, "a"])), lambda: list(starmap(pow, [1])), lambda: list(compress(5, [1])), lambda: tee([1], -1), lambda: tee(5), lambda: pairwise(5), lambda: zip_longest([1], foo=2), lambda: list(takewhile(5, [1])), lambda: repeat(1, "a"), lambda: list(filterfalse(5, [1])), lambda: groupby(), lambda: next(islice([1], 0))):
    t(f)
print(sum(islice(count(1), 100)), max(takewhile(lambda x: x < 50, (x * x for x in count()))), dict(zip("abc", count(1))), list(zip(count(), "ab", cycle([True, False]))), next(dropwhile(lambda n: n % 7 or n % 5, count(1))), iter(count()).__class__.__name__, isinstance(chain(), chain), type(iter(cycle("a"))) is cycle)
def primes():
    sieve = {}
    for q in count(2):
        p = sieve.pop(q, None)
        if p is None:
            sieve[q * q] = q
            yield q
        else:
            x = q + p
            while x in sieve: x += p
            sieve[x] = p
print(list(islice(primes(), 15)))
