from collections import deque

def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

d = deque([1, 2, 3])
d.append(4); d.appendleft(0); d.extend([5, 6]); d.extendleft([-1, -2])
print(d, len(d), d[0], d[-1], d[3], d.pop(), d.popleft(), d)
d.rotate(2); print(d)
d.rotate(-3); print(d)
d.rotate(100); print(d)
d.reverse(); print(d, list(reversed(d)))
d.insert(2, "x"); d.insert(-1, "y"); d.insert(100, "z"); d.insert(-100, "a"); print(d)
d.remove("x"); del d[0]; del d[-1]; d[0] = "first"; d[-1] = "last"; print(d)
print(d.index("y"), d.count(3), "y" in d, "q" not in d, d.copy() == d, d.copy() is d, d.clear(), d, bool(d), not d)
m = deque(maxlen=3)
for i in range(5):
    m.append(i)
print(m, m.maxlen, deque("abc").maxlen, deque(range(10), 3), deque(range(10), maxlen=0), deque([1, 2], maxlen=5))
m.appendleft("l"); print(m)
m.extend("abcd"); print(m)
m.extendleft([7, 8]); print(m)
m.rotate(); print(m)
t(lambda: m.insert(0, 1))
t(lambda: deque().pop())
t(lambda: deque().popleft())
t(lambda: deque([1])[5])
t(lambda: deque([1])[-2])
t(lambda: deque([1])["a"])
t(lambda: deque([1])[0:1])
t(lambda: deque([1]).remove(5))
t(lambda: deque([1]).index(5))
t(lambda: deque(5))
t(lambda: deque([], -1))
t(lambda: deque([], "a"))
t(lambda: deque([1]) + [2])
def it():
    x = deque([1, 2, 3])
    for v in x: x.append(v)
t(it)
def st(): deque([1])[3] = 5
t(st)
a, b = deque([1, 2]), deque([1, 3])
print(a < b, a == deque([1, 2]), a != b, a >= b, a == [1, 2], a + b, a * 2, 2 * a, deque([1, 2], 3) + deque([3, 4]), deque([1, 2], 3) * 2)
a += [5]; a *= 2
print(a)
q = deque([(0, "start")])
seen = {0}
order = []
while q:
    n, how = q.popleft()
    order.append(n)
    for k in (n * 2 + 1, n * 2 + 2):
        if k < 15 and k not in seen:
            seen.add(k); q.append((k, how))
print(order)
r = deque([1])
r.append(r)
print(r)
print(list(map(str, deque([1, 2]))), sum(deque([1, 2])), sorted(deque([2, 1])), [*deque("ab")], tuple(deque([1])), max(deque([1, 5])), dict(enumerate(deque("a"))), deque([]) == deque(), isinstance(d, deque), type(d).__name__, deque.__name__)
x = deque(range(1000))
for i in range(500):
    x.popleft(); x.append(i)
for i in range(300):
    x.appendleft(x.pop())
print(sum(x), x[0], x[-1], len(x), x[500], x.index(10), list(x)[::250])
class Dq(deque):
    def top(self): return self[-1]
s = Dq([1, 2], maxlen=2)
s.append(3)
print(s, s.top(), s.copy(), type(s.copy()).__name__)
s.tag = 5
print(s.tag, deque([1, 2, 2]).count(2), deque([1, 2, 3, 2]).index(2, 2), deque([[1], {2: 3}]))
i = iter(deque([1, 2]))
print(next(i), list(i), next(i, "end"))
