x = ((((((((((((((((((((1))))))))))))))))))))
y = [[[[[[[[[[[[1]]]]]]]]]]]]
z = {1: {2: {3: {4: {5: {6: "six"}}}}}}
print(x, y, z[1][2][3][4][5][6], (lambda: (lambda: (lambda: (lambda: "deep")())())())())
def a():
    def b():
        def c():
            def d():
                def e(): return v
                return e
            return d
        return c
    v = "closure"
    return b
print(a()()()()())
r = []
for i in range(2):
    for j in range(2):
        for k in range(2):
            if i:
                if j:
                    if k:
                        try:
                            with type("C", (), {"__enter__": lambda s: s, "__exit__": lambda s, *e: True})():
                                while True:
                                    for q in range(3):
                                        if q == 1: raise ValueError
                        finally: r.append((i, j, k))
print(r)
print([[[i * j * k for i in range(2)] for j in range(2)] for k in range(2)], 1 if 0 else 2 if 0 else 3 if 0 else 4 if 1 else 5, not not not not True, - - - -1, ~~~~5, 2 ** -1 ** 2 ** 1, 1 + 2 * 3 - 4 / 2 ** 2 // 1 % 3, (1, (2, (3, (4,)))), 1 < 2 < 3 < 4 < 5 < 6, "a" "b" "c" "d", 1 or 2 and 3 or 4, not 1 or 2, -2 ** 2, (-2) ** 2, 2 ** 3 ** 2, 7 // 2 * 2 + 7 % 2, 1 << 2 + 1, 6 & 3 | 8 ^ 1, 5 > 3 & 1, not 1 == 2, 3 - -3, +-+3, 10 - 5 - 2, 100 / 10 / 2)
class A:
    class B:
        class C:
            class D:
                v = "nested class"
                def f(self): return type(self).__qualname__
print(A.B.C.D.v, A.B.C.D().f())
class Chain:
    def __init__(self): self.n = 0
    def add(self, k): self.n += k; return self
    def __getattr__(self, k): return lambda: k
    def __getitem__(self, k): return self.add(k)
print(Chain().add(1).add(2).add(3)[4][5].n, Chain().foo(), Chain()[1].bar())
d = {"a": [{"b": ({"c": [10, 20]},)}]}
d["a"][0]["b"][0]["c"][1] += 5
print(d, d["a"][0]["b"][0]["c"][-1:])
big = [n for n in range(1000)]
total = 0
for n in big:
    if n % 2 == 0:
        if n % 3 == 0:
            if n % 5 == 0:
                if n % 7 == 0: total += n
            else: continue
        elif n % 4 == 0: pass
        else: total += 1
    else: total -= 1
print(total)
f = lambda n: (lambda s: s(s, n))(lambda s, k: 1 if k < 2 else k * s(s, k - 1))
print(f(15), (lambda *a, **k: (a, k))(*[1, *[2, *[3]]], **{"x": 1, **{"y": 2}}))
args = list(range(300))
def many(*a): return len(a), a[-1]
print(many(*args), max(*args), len({**{str(i): i for i in range(300)}}), sum([*range(300)]), len((*args, *args)), "".join(f"{i % 10}" for i in range(100)))
print(0 + 1 + 2 + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 10 + 11 + 12 + 13 + 14 + 15 + 16 + 17 + 18 + 19 + 20, [1, 2, 3,][2], (1,)[0], {"k": 1,}["k"], f"{'a' + f'{1 + 1}'}", "%s" % ("x",), ("tuple", "of", "strings")[1][0][0])
