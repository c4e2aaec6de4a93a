import random
random.seed(0)
g = lambda v: "%.12g" % v
for _ in range(3):
    print(g(random.gauss(0, 1)), g(random.normalvariate(10, 2)), g(random.expovariate(1.5)), g(random.triangular(1, 5, 2)), g(random.triangular()), g(random.uniform(-1, 1)), g(random.betavariate(2, 3)), g(random.gammavariate(2, 1)), g(random.gammavariate(0.5, 2)), g(random.gammavariate(1, 3)), g(random.lognormvariate(0, 0.5)), g(random.vonmisesvariate(0, 4)), g(random.paretovariate(3)), g(random.weibullvariate(1, 1.5)))
r = random.Random(123)
print(g(r.gauss(5, 2)), g(r.gauss(5, 2)), g(r.gauss(mu=1, sigma=0)), g(r.normalvariate()), g(r.vonmisesvariate(1, 0)), g(r.triangular(0, 0, 0)), g(r.uniform(5, 5)), g(r.gauss()), g(r.expovariate(2)))
r.seed(123)
print(g(r.gauss(5, 2)))
def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")
for f in (lambda: r.expovariate(0), lambda: r.gammavariate(-1, 1), lambda: r.gammavariate(1, 0), lambda: r.betavariate(0, 1), lambda: r.paretovariate(0)):
    t(f)
random.seed(2024)
pts = [(round(random.uniform(-3, 3), 4), round(random.gauss(0, 0.5), 4)) for _ in range(4)]
print(pts)
walk = 0
for _ in range(100): walk += random.choice((-1, 1))
print(walk, [random.randint(0, 3) for _ in range(12)])
class Fixed(random.Random):
    def random(self): return 0.25
f = Fixed()
print(f.random(), f.uniform(0, 4), f.choice("abcd"), f.randint(1, 4), f.triangular(0, 1, 0.5))
