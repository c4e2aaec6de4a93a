def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

a = 1 + 2j
print(a, 2j, -2j, 1 - 0j, 0j, -0j, complex(1, -2), complex(-0.0, 0.0), complex(0.0, -0.0), 1.5 + 2.5j, complex(1e20, 1e-5), complex(float("nan"), float("inf")))
print(a + 1, a - 1.5, a * 2, a / 2, a * a, a / (3 - 1j), a ** 2, a ** 0, a ** -1, -a, +a, abs(3 + 4j), a.conjugate(), a.real, a.imag)
print(a == 1 + 2j, a == (1, 2), 1 + 0j == 1, hash(1 + 0j) == hash(1), bool(0j), bool(1j), complex("1+2j"), complex("j"), complex("-3.5j"), complex(" (1-2j) "), complex(2), complex("5"))
t(lambda: a < 1)
t(lambda: a // 2)
t(lambda: a % 2)
t(lambda: divmod(a, 1))
t(lambda: int(a))
t(lambda: a / 0)
t(lambda: 0j ** -1)
t(lambda: complex("1 + 2j"))
t(lambda: complex("a"))
t(lambda: complex("1", 2))
t(lambda: complex(1, "2"))
t(lambda: complex([]))
t(lambda: round(a))
t(lambda: a + "x")
print(repr(1j * 1j), str(1e100j), {1j: 2}[1j], isinstance(1j, complex), type(1j * 0), sum([1j, 2]), (1 + 1j).__abs__() == 2 ** 0.5)
print(f"{a:.2f}", f"{a}", f"{3j!r:>6}", "%s" % a, f"{1.5 + 2j:10.1f}|", f"{a:>12}|", f"{a:+.1e}")
