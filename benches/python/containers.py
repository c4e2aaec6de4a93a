names = ["chair", "table", "lamp", "sofa", "desk", "plant"]
counts = {}
for i in range(100000):
    n = names[i % 6]
    counts[n] = counts.get(n, 0) + 1
words = [f"{names[i % 6]} {i}" for i in range(20000)]
by = {}
for w in words:
    by.setdefault(w.split()[0], []).append(w)
order = sorted(words, key=lambda w: (w[0], len(w), w))
squares = {i: i * i for i in range(50000) if i % 2}
evens = {i for i in range(50000) if i % 2 == 0}
print(counts, len(by["sofa"]), order[:2], sum(squares.values()), len(evens), sum(x for x in squares if x in squares))
