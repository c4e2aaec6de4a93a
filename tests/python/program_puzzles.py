def hanoi(n, a="A", b="B", c="C"):
    if n:
        yield from hanoi(n - 1, a, c, b)
        yield f"{a}{c}"
        yield from hanoi(n - 1, b, a, c)
print(" ".join(hanoi(3)), len(list(hanoi(8))))
def queens(n, row=0, cols=0, d1=0, d2=0):
    if row == n: return 1
    total, free = 0, ((1 << n) - 1) & ~(cols | d1 | d2)
    while free:
        bit = free & -free
        free ^= bit
        total += queens(n, row + 1, cols | bit, (d1 | bit) << 1, (d2 | bit) >> 1)
    return total
print([queens(n) for n in range(1, 8)])
board = [[int(c) for c in r] for r in ("530070000", "600195000", "098000060", "800060003", "400803001", "700020006", "060000280", "000419005", "000080079")]
def ok(r, c, v): return all(board[r][j] != v and board[j][c] != v for j in range(9)) and all(board[r // 3 * 3 + i][c // 3 * 3 + j] != v for i in range(3) for j in range(3))
def solve(cells, k=0):
    if k == len(cells): return True
    r, c = cells[k]
    for v in range(1, 10):
        if ok(r, c, v):
            board[r][c] = v
            if solve(cells, k + 1): return True
    board[r][c] = 0
    return False
print(solve([(r, c) for r in range(9) for c in range(9) if not board[r][c]]))
for r in board: print(*r, sep="")
def knapsack(items, cap):
    best = [(0, ())] * (cap + 1)
    for name, w, v in items:
        for c in range(cap, w - 1, -1):
            cand = best[c - w][0] + v, best[c - w][1] + (name,)
            if cand[0] > best[c][0]: best[c] = cand
    return best[cap]
print(knapsack([("map", 9, 150), ("compass", 13, 35), ("water", 53, 200), ("sandwich", 50, 160), ("tin", 68, 45), ("banana", 27, 60)], 100))
def change(n, coins=(50, 20, 10, 5, 2, 1)):
    ways = [1] + [0] * n
    for c in coins:
        for i in range(c, n + 1): ways[i] += ways[i - c]
    return ways[n]
print(change(100), change(200))
def quicksort(a): return a if len(a) < 2 else quicksort([x for x in a[1:] if x < a[0]]) + [a[0]] + quicksort([x for x in a[1:] if x >= a[0]])
def mergesort(a):
    if len(a) < 2: return a
    m = len(a) // 2
    l, r, out = mergesort(a[:m]), mergesort(a[m:]), []
    while l and r: out.append((l if l[0] <= r[0] else r).pop(0))
    return out + l + r
def bubble(a):
    a = a[:]
    for i in range(len(a)):
        for j in range(len(a) - 1 - i):
            if a[j] > a[j + 1]: a[j], a[j + 1] = a[j + 1], a[j]
    return a
def heapsort(a):
    h = []
    for v in a:
        h.append(v)
        i = len(h) - 1
        while i and h[(i - 1) // 2] > h[i]:
            h[i], h[(i - 1) // 2] = h[(i - 1) // 2], h[i]
            i = (i - 1) // 2
    out = []
    while h:
        out.append(h[0])
        last = h.pop()
        if h:
            h[0], i = last, 0
            while (k := min((j for j in (2 * i + 1, 2 * i + 2) if j < len(h)), key=h.__getitem__, default=None)) is not None and h[k] < h[i]:
                h[i], h[k] = h[k], h[i]
                i = k
    return out
seed, data = 12345, []
for _ in range(60):
    seed = (seed * 1103515245 + 12345) % 2 ** 31
    data.append(seed % 1000)
print(quicksort(data) == mergesort(data) == bubble(data) == heapsort(data) == sorted(data), sorted(data)[:8])
def bisect(a, x):
    lo, hi = 0, len(a)
    while lo < hi:
        mid = (lo + hi) // 2
        if a[mid] < x: lo = mid + 1
        else: hi = mid
    return lo
print([bisect([1, 3, 5, 7], x) for x in range(9)])
def perms(s): return [s] if len(s) < 2 else [s[i] + p for i in range(len(s)) for p in perms(s[:i] + s[i + 1:])]
def powerset(s): return [[x for i, x in enumerate(s) if m >> i & 1] for m in range(1 << len(s))]
def partitions(n, m=None):
    if n == 0: yield []
    for k in range(min(n, m or n), 0, -1):
        for rest in partitions(n - k, k): yield [k] + rest
print(perms("abc"), powerset("abc"), list(partitions(5)), sum(1 for _ in partitions(20)))
def newton(f, df, x, eps=1e-12):
    while abs(f(x)) > eps: x -= f(x) / df(x)
    return x
print("%.10f" % newton(lambda x: x * x - 2, lambda x: 2 * x, 1.0), "%.10f" % newton(lambda x: x ** 3 - x - 2, lambda x: 3 * x * x - 1, 1.5))
def simpson(f, a, b, n=100):
    h = (b - a) / n
    return h / 3 * (f(a) + f(b) + sum((4 if i % 2 else 2) * f(a + i * h) for i in range(1, n)))
print("%.10f" % simpson(lambda x: x ** 3, 0, 2), "%.8f" % simpson(lambda x: 1 / x, 1, 2))
pascal = [[1]]
for _ in range(7): pascal.append([a + b for a, b in zip([0] + pascal[-1], pascal[-1] + [0])])
for r in pascal: print(f"{' '.join(map(str, r)):^30}".rstrip())
def ackermann(m, n): return n + 1 if m == 0 else ackermann(m - 1, 1) if n == 0 else ackermann(m - 1, ackermann(m, n - 1))
print(ackermann(2, 3), [sum(int(d) for d in str(2 ** n)) for n in (10, 100, 1000)], len(str(3 ** 1000)), str(7 ** 200)[:20])
def spiral(n):
    g, r, c, dr, dc = [[0] * n for _ in range(n)], 0, 0, 0, 1
    for k in range(1, n * n + 1):
        g[r][c] = k
        if not (0 <= r + dr < n and 0 <= c + dc < n and g[r + dr][c + dc] == 0): dr, dc = dc, -dr
        r, c = r + dr, c + dc
    return g
for row in spiral(4): print(*[f"{v:2}" for v in row])
