def averager():
    total, n, avg = 0.0, 0, None
    while True:
        x = yield avg
        if x is None: return total, n
        total += x; n += 1
        avg = total / n
a = averager()
next(a)
print([a.send(v) for v in (10, 20, 60)])
try: a.send(None)
except StopIteration as e: print(e.value)
def grouper(results, key):
    while True: results[key] = yield from averager()
res = {}
for key, vals in {"a": [1, 2], "b": [5]}.items():
    g = grouper(res, key); next(g)
    for v in vals: g.send(v)
    g.send(None)
print(res)
class Scheduler:
    def __init__(self): self.queue, self.time, self.log = [], 0, []
    def spawn(self, name, gen): self.queue.append((self.time, len(self.log), name, gen))
    def run(self):
        while self.queue:
            self.queue.sort(key=lambda t: t[:2])
            self.time, _, name, gen = self.queue.pop(0)
            try:
                delay = next(gen)
                self.log.append(f"{self.time}:{name}")
                self.queue.append((self.time + delay, len(self.log), name, gen))
            except StopIteration as e:
                self.log.append(f"{self.time}:{name} done {e.value}")
def worker(n, delay):
    for i in range(n): yield delay
    return n * delay
s = Scheduler()
s.spawn("fast", worker(3, 1)); s.spawn("slow", worker(2, 2))
s.run()
print(*s.log, sep=", ")
def pipeline(*stages):
    def run(src):
        for st in stages: src = st(src)
        return src
    return run
evens = lambda it: (x for x in it if x % 2 == 0)
square = lambda it: (x * x for x in it)
def take(n):
    def st(it):
        for _, x in zip(range(n), it): yield x
    return st
def naturals():
    n = 0
    while True: yield n; n += 1
print(list(pipeline(evens, square, take(5))(naturals())))
def window(it, n):
    buf = []
    for x in it:
        buf.append(x)
        if len(buf) == n: yield tuple(buf); del buf[0]
print(list(window("abcde", 3)), list(window([1], 2)))
def flatten(x):
    for v in x:
        if isinstance(v, (list, tuple)): yield from flatten(v)
        else: yield v
print(list(flatten([1, [2, (3, [4, []])], 5])))
def machine():
    state = "idle"
    while True:
        ev = yield state
        match state, ev:
            case "idle", "start": state = "running"
            case "running", ("pause" | "stop") as e: state = {"pause": "paused", "stop": "idle"}[e]
            case "paused", "start": state = "running"
            case _, "reset": state = "idle"
            case _: pass
m = machine(); next(m)
print([m.send(e) for e in ("start", "pause", "bogus", "start", "stop", "pause", "reset")])
def resource(log):
    log.append("open")
    try:
        while True:
            try: cmd = yield
            except ValueError as e: log.append(f"handled {e}")
            else: log.append(f"cmd {cmd}")
    finally: log.append("closed")
log = []
r = resource(log); next(r); r.send("a"); r.throw(ValueError("bad")); r.send("b"); r.close()
print(log)
def inner():
    try:
        x = yield 1
        print("inner got", x)
        yield 2
    finally: print("inner cleanup")
    return "unused"
def outer():
    try:
        r = yield from inner()
        print("result", r)
    except KeyError as e:
        print("outer caught", e); yield "recovered"
    finally: print("outer cleanup")
o = outer()
print(next(o), o.send("x"), o.throw(KeyError("k")), next(o, "end"))
def countdown(n):
    while n > 0:
        jump = yield n
        n = jump if jump is not None else n - 1
c = countdown(10)
print(next(c), next(c), c.send(3), list(c))
def tee2(it):
    a, b = [], []
    it = iter(it)
    def side(own, other):
        while True:
            if not own:
                try: v = next(it)
                except StopIteration: return
                own.append(v); other.append(v)
            yield own.pop(0)
    return side(a, b), side(b, a)
x, y = tee2("abc")
print(next(x), list(y), list(x))
print(sum(x * y for x, y in zip(*tee2([1, 2, 3]))), max((len(w), w) for w in "a bbb cc".split()), dict((k, list(v)) for k, v in (("a", (i for i in range(2))), ("b", iter("x")))))
