def sieve(n):
    flags = [True] * (n + 1)
    flags[0:2] = [False, False]
    for i in range(2, int(n ** 0.5) + 1):
        if flags[i]:
            flags[i * i::i] = [False] * len(flags[i * i::i])
    return [i for i, f in enumerate(flags) if f]
p = sieve(200)
print(p, len(p), sum(p))
def is_prime(n):
    if n < 2: return False
    if n % 2 == 0: return n == 2
    d, s = n - 1, 0
    while d % 2 == 0:
        d //= 2
        s += 1
    for a in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37):
        if a % n == 0: continue
        x = pow(a, d, n)
        if x in (1, n - 1): continue
        for _ in range(s - 1):
            x = x * x % n
            if x == n - 1: break
        else:
            return False
    return True
print([n for n in range(50) if is_prime(n)], is_prime(2 ** 61 - 1), is_prime(2 ** 61 + 1), is_prime(10 ** 18 + 9))
def factor(n):
    out, d = {}, 2
    while d * d <= n:
        while n % d == 0:
            out[d] = out.get(d, 0) + 1
            n //= d
        d += 1 if d == 2 else 2
    if n > 1: out[n] = out.get(n, 0) + 1
    return out
for n in (360, 97, 1001, 2 ** 20, 999999, 123456789):
    f = factor(n)
    print(n, "=", " * ".join(f"{p}^{k}" if k > 1 else str(p) for p, k in f.items()))
def gcd(a, b):
    while b: a, b = b, a % b
    return a
def egcd(a, b):
    if not b: return a, 1, 0
    g, x, y = egcd(b, a % b)
    return g, y, x - a // b * y
print(gcd(1071, 462), egcd(240, 46), [gcd(a, 12) for a in range(13)])
def collatz(n):
    steps = 0
    while n != 1:
        n = n // 2 if n % 2 == 0 else 3 * n + 1
        steps += 1
    return steps
best = max(range(1, 1000), key=collatz)
print(best, collatz(best))
print([n for n in range(1, 10000) if sum(d for d in range(1, n // 2 + 1) if n % d == 0) == n][:3] if False else [n for n in range(2, 500) if sum(d for d in range(1, n // 2 + 1) if n % d == 0) == n])
