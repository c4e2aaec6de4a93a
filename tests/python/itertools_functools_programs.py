from itertools import accumulate, chain, combinations, count, cycle, groupby, islice, permutations, product, repeat, starmap, takewhile, tee, zip_longest, pairwise
from functools import reduce, partial, lru_cache, cmp_to_key, wraps, singledispatch
from operator import itemgetter, attrgetter, mul, add, methodcaller
from collections import Counter, defaultdict, OrderedDict, deque, namedtuple, ChainMap
rows = [("fruit", "apple", 3), ("veg", "kale", 2), ("fruit", "fig", 5), ("veg", "leek", 2), ("nut", "pecan", 1)]
rows.sort(key=itemgetter(0))
for k, g in groupby(rows, itemgetter(0)): print(k, [(n, c) for _, n, c in g], end=" ")
print()
by = defaultdict(list)
for kind, name, n in rows: by[kind].append(name)
print(dict(by), {k: sum(map(itemgetter(2), g)) for k, g in groupby(rows, key=itemgetter(0))}, Counter(k for k, *_ in rows).most_common(1), sorted(rows, key=itemgetter(2, 1))[0], max(rows, key=itemgetter(2)))
print(list(accumulate([5, -2, 7], add)), list(accumulate(range(1, 6), mul)), list(accumulate([3, 1, 4, 1, 5], max)), [b - a for a, b in pairwise([1, 4, 9, 16])], reduce(lambda a, d: a * 10 + d, [1, 2, 3]), reduce(lambda d, kv: {**d, kv[0]: kv[1]}, [("a", 1), ("b", 2)], {}), sum(starmap(mul, [(1, 2), (3, 4)])))
def chunks(it, n):
    it = iter(it)
    while c := list(islice(it, n)): yield c
def flatten(x): return list(chain.from_iterable(x))
def grouper(it, n, fill=None): return zip_longest(*[iter(it)] * n, fillvalue=fill)
def sliding(it, n):
    w = deque(islice(it := iter(it), n - 1), maxlen=n)
    for x in it: w.append(x); yield tuple(w)
def roundrobin(*its):
    q = deque(map(iter, its))
    while q:
        it = q.popleft()
        try: yield next(it)
        except StopIteration: continue
        q.append(it)
print(list(chunks(range(7), 3)), flatten([[1], [2, 3], []]), list(grouper("abcde", 2, "-")), list(sliding(range(5), 3)), "".join(roundrobin("abc", "D", "EF")), list(islice(cycle("ab"), 5)), list(takewhile(lambda x: x < 20, (x * x for x in count(1)))), dict(zip(count(1), "ab")), list(zip("abc", repeat(0))))
print(["".join(p) for p in product("ab", repeat=2)], len(list(permutations(range(5), 3))), [c for c in combinations([1, 2, 3, 4], 2) if sum(c) == 5], sum(1 for a, b in combinations(range(10), 2) if (a + b) % 3 == 0), max(product(range(3), repeat=2), key=lambda p: p[0] - p[1]))
@lru_cache(maxsize=None)
def ways(n, parts=(1, 5, 10)): return 1 if n == 0 else sum(ways(n - p, tuple(q for q in parts if q <= p)) for p in parts if p <= n)
print(ways(50), ways.cache_info().misses > 10)
@lru_cache
def grid(r, c): return 1 if r == 0 or c == 0 else grid(r - 1, c) + grid(r, c - 1)
print(grid(16, 16), grid.cache_info())
def counted(f):
    @wraps(f)
    def w(*a, **k):
        w.calls += 1
        return f(*a, **k)
    w.calls = 0
    return w
@counted
def area(w, d=1): "area of"; return w * d
print(area(2, d=3), area(4), area.calls, area.__name__, area.__doc__)
double = partial(mul, 2)
pow2 = partial(pow, 2)
print(list(map(double, [1, 2])), pow2(10), partial(sorted, key=len, reverse=True)(["a", "ccc", "bb"]), partial("{}-{}".format, "x")("y"), list(map(methodcaller("upper"), "ab")), sorted(["b10", "a2", "b9"], key=cmp_to_key(lambda a, b: (int(a[1:]) > int(b[1:])) - (int(a[1:]) < int(b[1:])))))
P = namedtuple("P", "name age")
ps = [P("bob", 30), P("al", 25), P("cy", 30)]
print(sorted(ps, key=attrgetter("age", "name")), {a: [p.name for p in g] for a, g in groupby(sorted(ps, key=attrgetter("age")), attrgetter("age"))}, max(ps, key=attrgetter("age")).name, ps[0]._replace(age=1), [p._asdict() for p in ps][:1], dict(ps[:2]), list(zip(*ps)))
a, b = tee(x * x for x in range(4))
print(sum(a), max(b), Counter("mississippi").most_common(2), Counter(a=3) - Counter(a=1, b=2), sorted((Counter("aab") + Counter("abc")).items()), sorted(Counter("aab").elements()))
od = OrderedDict.fromkeys("hello")
od.move_to_end("h")
print("".join(od), od.popitem(last=False), list(od), ChainMap({"a": 1}, {"a": 2, "b": 3})["b"], dict(ChainMap({"a": 1}, {"a": 2, "b": 3})))
@singledispatch
def show(x): return f"?{x}"
show.register(int, lambda x: f"i{x}")
show.register(list, lambda x: "[" + ",".join(map(show, x)) + "]")
print(show([1, "a", [2, True]]), show(None))
hist = deque(maxlen=3)
for v in range(6): hist.append(v); hist.rotate(1) if v % 2 else None
print(hist, sum(hist), list(hist)[::-1])
pipeline = reduce(lambda f, g: lambda x: g(f(x)), [lambda x: x + 1, lambda x: x * 2, str])
print(pipeline(3), list(map(sum, zip(*[[1, 2], [3, 4]]))), dict(enumerate(accumulate("abc"))), [k for k, g in groupby("aaabbc") if len(list(g)) > 1], list(chain(range(2), "a", [None])))
