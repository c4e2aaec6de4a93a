from math import factorial, isqrt
f = factorial(100)
print(f, len(str(f)), f // factorial(98), f % 10 ** 30, str(f)[::-1].lstrip("0")[:10])
a, b = 0, 1
for _ in range(500): a, b = b, a + b
print(a)
x, y = 3 ** 200, 7 ** 150
print(x * y, x - y, y // x, y % x, divmod(y, x), x & y, x | y, x ^ y, ~x, x << 13, y >> 200, -y >> 200, -x // y, -y // x, -y % x)
print(isqrt(10 ** 101), isqrt(x) ** 2 <= x < (isqrt(x) + 1) ** 2, pow(x, y, 10 ** 20), pow(3, -1, 10 ** 20 + 39), x == int(str(x)), int(hex(x), 16) == x, int(oct(y), 8) == y, int(bin(x), 2) == x, int(str(y), 10) == y, int("z" * 30, 36))
print(float(x), float(2 ** 1023), x / y, y / x, 10 ** 400 / 10 ** 399, (2 ** 53 + 1) / 1, 10 ** 22 / 3, int(1e22), int(1e23), int(2.0 ** 100), round(x, -80), 2 ** 0.5 * 10 ** 20)
print(f"{x:,}", f"{x:_}", f"{x:e}", f"{x:x}", f"{x:.3e}", f"{y:d}"[:20], "%d" % x == str(x), "%x" % y == hex(y)[2:], f"{10 ** 30:>40}", f"{-10 ** 20:+,}", f"{10 ** 25:g}")
for e in (lambda: float(10 ** 400), lambda: 10 ** 400 * 1.0, lambda: 10 ** 400 / 3, lambda: int("1" * 5000), lambda: str(10 ** 5000), lambda: 10 ** 400 + 0.5, lambda: 1.0 < 10 ** 400, lambda: 10 ** 400 == 1e300, lambda: f"{10 ** 400:f}", lambda: f"{10 ** 400:.2e}", lambda: round(10 ** 400, 2) == 10 ** 400, lambda: 2 ** 10000 % 97, lambda: (10 ** 400) ** -1, lambda: 10 ** 400 // 1.0, lambda: [0][10 ** 20], lambda: range(10 ** 20)[10 ** 19], lambda: "a" * 10 ** 20, lambda: [1][:10 ** 30], lambda: chr(10 ** 10), lambda: (10 ** 20).to_bytes(4, "big"), lambda: hash(10 ** 100), lambda: 1 << 10 ** 20, lambda: 0 << 10 ** 20, lambda: 1 >> 10 ** 20, lambda: complex(10 ** 400), lambda: divmod(10 ** 400, 7.0), lambda: 5 % -(10 ** 30), lambda: -5 // 10 ** 30, lambda: bool(10 ** 400), lambda: int(str(10 ** 100)[:50]), lambda: (-2) ** 1001 % 1000, lambda: 0 ** 10 ** 20, lambda: 1 ** 10 ** 20, lambda: (-1) ** (10 ** 20 + 1)):
    try: print(e())
    except Exception as err: print(type(err).__name__, err)
n, digits = 1, 0
while n < 10 ** 60: n = n * 7 + 3; digits += 1
print(n, digits, sum(map(int, str(n))), n.bit_length(), n.bit_count(), (n).to_bytes(30, "big").hex(), int.from_bytes(n.to_bytes(30, "little"), "little") == n, sorted([x, y, -x, 0])[0] == -x, max(x, y) == y, min(x, 1.5), x > 1e90, x < 1e100, x != x + 1, {x: "big"}[3 ** 200], x in [x], abs(-x) == x, +x == x, -(-x) == x, x.real == x, x.conjugate() == x, x.denominator, isinstance(x, int))
def pi_digits(k):
    q, r, t, k1, m, z, out = 1, 0, 1, 1, 3, 3, ""
    while len(out) < k:
        if 4 * q + r - t < m * t:
            out += str(m)
            q, r, m = 10 * q, 10 * (r - m * t), 10 * (3 * q + r) // t - 10 * m
        else:
            q, r, t, k1, m, z = q * k1, (2 * q + r) * z, t * z, k1 + 1, (q * (7 * k1 + 2) + r * z) // (t * z), z + 2
    return out
print(pi_digits(60))
print(sum(10 ** i for i in range(40)), [10 ** i for i in (17, 18, 19, 20)], 9223372036854775807 + 1, -9223372036854775808 - 1, 2 ** 63 * 2 ** 63, 4294967296 ** 2, 99999999999 * 99999999999, 9223372036854775807 - -1, -9223372036854775808 // -1, -9223372036854775808 % -1, 3037000500 * 3037000500, 6 * 1537228672809129302, -(2 ** 63) * -1, abs(-(2 ** 63)), (2 ** 62) << 1, (2 ** 62) << 2, 1 << 63, 1 << 64)
