import random
random.seed(0)
print(random.random(), random.random(), random.uniform(1, 10), random.randint(1, 6), random.randrange(10), random.randrange(0, 100, 5), random.choice("abcdef"), random.getrandbits(10), random.getrandbits(100))
l = list(range(10))
random.shuffle(l)
print(l, random.sample(range(100), 5), random.sample("abcdefgh", 3), random.choices([1, 2, 3], k=6), random.choices("ab", weights=[1, 9], k=8), random.choices("abc", cum_weights=[1, 3, 10], k=5))
random.seed(42)
print([random.randint(1, 100) for _ in range(10)], [round(random.random(), 6) for _ in range(5)])
for s in (1, 2 ** 40, -5, 3.7, "hello", "", b"bytes", True, 10 ** 50, "é", bytearray(b"x"), 1.0, 0.0, -1):
    random.seed(s)
    print(repr(s), random.random(), random.randrange(1000), random.choice("xyz"))
random.seed(5)
print(random.randbytes(5), random.randrange(10 ** 30), random.randint(-5, 5), random.randint(3, 3), random.randrange(5, 6), random.randrange(10, 0, -3), random.getrandbits(1), random.getrandbits(0), random.getrandbits(64), random.randrange(2 ** 65))
a = random.Random(7)
b = random.Random(7)
print(a.random() == b.random(), a.randint(1, 10), b.randint(1, 10), random.Random("s").random(), a is b)
st = random.getstate()
x = [random.random() for _ in range(3)]
random.setstate(st)
print(x == [random.random() for _ in range(3)], len(st), st[0])
def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")
for f in (lambda: random.choice([]), lambda: random.randint(5, 1), lambda: random.randrange(0), lambda: random.randrange(5, 5), lambda: random.randrange(1, 10, 0), lambda: random.sample([1, 2], 3), lambda: random.sample({1, 2}, 1), lambda: random.sample([1], -1), lambda: random.choices([], k=1), lambda: random.choices([1, 2], weights=[1]), lambda: random.choices([1, 2], [1, 1], cum_weights=[1, 2]), lambda: random.choices([1], weights=[0]), lambda: random.shuffle((1, 2)), lambda: random.shuffle("ab"), lambda: random.getrandbits(-1), lambda: random.seed([]), lambda: random.randint(1), lambda: random.uniform("a", 1), lambda: random.choice(5), lambda: random.choice({1: 2}), lambda: random.random(1), lambda: random.randrange("a"), lambda: random.choice(None)):
    t(f)
random.seed(0)
print(random.sample(range(10), k=10), random.sample(["a", "b"], 2), random.sample([1, 1, 2], counts=[2, 1, 1], k=3), random.choices(range(5), k=0), random.sample([], 0), random.sample(range(10 ** 9), 3))
random.seed(0)
deck = [(r, s) for s in "CD" for r in range(3)]
random.shuffle(deck)
print(deck, random.choice(deck), random.choice(range(100)), random.choice((1,)), random.choice("é☃"))
random.seed(1)
print(sum(random.random() < 0.5 for _ in range(1000)), sum(random.randint(1, 6) for _ in range(100)), [random.choice([True, False]) for _ in range(8)])
