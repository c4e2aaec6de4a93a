def t(f):
    try:
        print(f())
    except BaseException as e:
        print(type(e).__name__, e, sep=": ")

def g():
    x = yield 1
    print("got", x)
    y = yield 2
    print("got", y)
    return "done"
i = g()
print(next(i), i.send("a"))
try:
    i.send("b")
except StopIteration as e:
    print("stop", e.value, e.args)
t(lambda: next(i))
t(lambda: g().send(5))
def c():
    try:
        while True:
            try:
                v = yield
                print("v", v)
            except ValueError as e:
                print("caught", e)
                yield "from except"
    finally:
        print("cleanup")
k = c()
next(k)
k.send(1)
print(k.throw(ValueError("oops")), k.throw(ValueError, "again") if False else "")
next(k)
k.close()
k.close()
t(lambda: next(k))
k = c()
t(lambda: k.throw(KeyError("before start")))
def bad_close():
    try:
        yield 1
    except GeneratorExit:
        yield 2
b = bad_close()
next(b)
t(b.close)
def ret_close():
    try:
        yield 1
    except GeneratorExit:
        print("exit")
        return 5
b = ret_close()
next(b)
print(b.close())
def sub():
    r = yield "s1"
    print("sub got", r)
    try:
        yield "s2"
    except RuntimeError as e:
        print("sub caught", e)
        yield "s3"
    return "sub result"
def main():
    r = yield from sub()
    print("main got", r)
    r = yield from [10, 20]
    print("list gives", r)
    r = yield from (x for x in "z")
    return "end"
m = main()
print(next(m), m.send("hello"), m.throw(RuntimeError("rt")), next(m), next(m), next(m))
t(lambda: next(m))
def deleg_close():
    try:
        yield from inner_close()
    finally:
        print("outer fin")
def inner_close():
    try:
        yield 1
    finally:
        print("inner fin")
d = deleg_close()
next(d)
d.close()
def stop_inside():
    yield 1
    raise StopIteration("x")
t(lambda: list(stop_inside()))
def next_inside():
    yield 1
    next(iter([]))
try:
    list(next_inside())
except RuntimeError as e:
    print(e, repr(e.__cause__), e.__context__ is e.__cause__)
def running():
    try:
        next(r)
    except ValueError as e:
        print(e)
    yield 1
r = running()
next(r)
def tree(n):
    if n:
        yield from tree(n - 1)
        yield n
        yield from tree(n - 1)
print(list(tree(3)))
def fib():
    a, b = 0, 1
    while True:
        yield a
        a, b = b, a + b
f = fib()
print([next(f) for _ in range(15)], [x for x, _ in zip(fib(), range(5))])
def fin():
    try:
        yield 1
        yield 2
    finally:
        print("fin")
for v in fin():
    print(v)
def loop_break():
    for v in fin():
        print("first", v)
        break
it = fin()
for v in it:
    break
print(next(it), next(it, "dflt"), next(it, "dflt2"))
def empty():
    return
    yield
print(list(empty()), list(x for x in ()), sum(empty()), tuple(empty()), dict(empty()))
def expr():
    x = (yield) or "none"
    z = [(yield 1), (yield 2)]
    print(x, z)
    print((yield 3), f"{(yield 4)}")
e = expr()
next(e)
for v in ("a", "b", "c", "d"):
    print("y", e.send(v))
t(lambda: e.send("e"))
print(type(e).__name__, e.__name__, e.__qualname__, iter(e) is e, hasattr(e, "__next__"), e.gi_running, e.gi_frame is None)
def nestedgen():
    def inner():
        yield n
    n = 5
    yield from inner()
    n = 6
    yield from inner()
print(list(nestedgen()))
def ctx():
    try:
        raise KeyError("k")
    except KeyError:
        yield 1
        try:
            raise
        except KeyError as e:
            yield repr(e)
print(list(ctx()))
x = (print("lazy"), 1)[1] if False else (n for n in [1, 2, 3])
print(2 in x, list(x))
def throw_type():
    try:
        yield
    except Exception as e:
        yield type(e).__name__, e.args
g2 = throw_type(); next(g2)
print(g2.throw(TypeError))
g2 = throw_type(); next(g2)
print(g2.throw(TypeError("a", "b")))
t(lambda: throw_type().throw(5))
def non():
    yield from 5
t(lambda: list(non()))
class Sub:
    def __iter__(self): return self
    def __next__(self):
        print("next")
        return 1
    def send(self, v):
        print("send", v)
        if v == "stop":
            raise StopIteration("result")
        return v
    def throw(self, *a):
        print("throw", type(a[0]).__name__ if not isinstance(a[0], type) else a[0].__name__)
        return "thrown"
    def close(self):
        print("close")
def ds():
    r = yield from Sub()
    yield "after", r
q = ds()
print(next(q), next(q), q.send(5), q.throw(ValueError("v")), q.send("stop"))
q = ds(); next(q); q.close()
def gen_return_in_finally():
    try:
        yield 1
        raise ValueError
    finally:
        return "swallowed"
print(list(gen_return_in_finally()))
class Tree:
    def __init__(self, v, *kids): self.v, self.kids = v, kids
    def __iter__(self):
        yield self.v
        for k in self.kids:
            yield from k
print(list(Tree(1, Tree(2, Tree(3)), Tree(4))))
a, *b = (n * n for n in range(4))
print(a, b, max(n for n in [3, 9, 2]), sorted((n for n in "cab"), reverse=True), ",".join(c for c in "xyz"), any(n > 1 for n in [1, 2]), dict((n, n) for n in "ab"))
