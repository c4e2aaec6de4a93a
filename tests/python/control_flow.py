for i in range(3):
    pass
else:
    print("for else", i)
for i in range(5):
    if i == 2: break
else:
    print("never")
print("broke at", i)
n = 0
while n < 3:
    n += 1
    if n == 2: continue
    print("while", n)
else:
    print("while else", n)
while True:
    n -= 1
    if n < 0: break
else:
    print("never")
print(n)
for x in []:
    print("never")
else:
    print("empty else")
for i in range(3):
    for j in range(3):
        if j == 1: continue
        if i == 1: break
        print(i, j, end=" ")
    else:
        print("inner else", i, end=" ")
        continue
    print("inner broke", i, end=" ")
print()
if 0: print("no")
elif []: print("no")
elif "x": print("elif")
else: print("no")
if not None and (1 or 1 / 0): print("short")
x = 5
print("big" if x > 10 else "mid" if x > 3 else "small", (1 if x else 2) + 1, [1, 2][x > 3])
def f(v):
    if v < 0: return "neg"
    if v == 0: return
    for i in range(v):
        if i == 2: return f"loop {i}"
    return "end"
print(f(-1), f(0), f(1), f(5))
for i in range(3):
    i = 10
    print(i, end=" ")
print(i)
a = [1, 2, 3]
for i, a[0] in enumerate("xy"): print(i, a, end=" ")
print()
for a, (b, *c) in [(1, "xyz"), (2, [3])]: print(a, b, c, end=" ")
print()
d = {}
for d["k"] in range(3): pass
print(d)
class O: pass
for O.attr in "ab": pass
print(O.attr)
def deep():
    for a in range(2):
        while True:
            for b in range(2):
                if a: return ("ret", a, b)
                if b: break
            else: continue
            break
print(deep())
total = 0
for i in range(1, 101):
    if i % 15 == 0: total += 3
    elif i % 5 == 0: total += 2
    elif i % 3 == 0: total += 1
print(total)
while (n := n + 1) < 4: print("w", n, end=" ")
print(n)
for _ in range(2): print(_, end=" ")
print(_)
for i in (1, 2, 3): print(i, end=" ") if i != 2 else print("two", end=" ")
print()
for k in {"a": 1, "b": 2}: print(k, end="")
for ch in "hi": print(ch, end="")
for t in zip([1, 2], "ab"): print(t, end="")
for i in reversed(range(3)): print(i, end="")
for i in range(10, 0, -4): print(i, end=" ")
print()
pass; x = 1; y = 2; print(x, y)
if True: x = 3; y = 4
print(x, y)
if x: pass
else: print("no")
def empty(): ...
print(empty(), ...)
i = 0
while i < 10:
    i += 1
    try:
        if i % 2: continue
        if i > 6: break
        print("even", i, end=" ")
    finally:
        print("f", i, end=" ")
print()
