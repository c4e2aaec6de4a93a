def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

print(abs(-5), abs(5.5), abs(-0.0), abs(3 + 4j), abs(True), abs(-2 ** 70), divmod(7, 3), divmod(-7, 3), divmod(7, -3), divmod(7.5, 2), divmod(-1, 1e300), divmod(2 ** 70, 3), pow(2, 5), pow(2, 5, 3), pow(2, -2), pow(0, 0), pow(2.5, 2), pow(base=2, exp=3, mod=5), pow(7, -1, 11), pow(-3, -1, 7), pow(4, 0.5))
print(round(2.5), round(3.5), round(-2.5), round(2.567, 2), round(1234, -2), round(1250, -2), round(-5.5), round(5), round(5, 2), round(0.5), round(1.5), round(1e16), round(2.5, 0), round(2.675, 2), round(1.0), round(True), round(1e300), round(-0.3), round(0.1 + 0.2, 10), round(number=2.5, ndigits=None), round(123456.789, -3), round(99.995, 2), round(5.015, 2), round(1e-7, 3), round(45, -1), round(55, -1), round(2 ** 70, -10))
print(int("12"), int(3.99), int(-3.99), int("-0b11", 2), int("ff", 16), int("0xff", 0), int("7_000"), int(True), int(" 5\n"), float("1e3"), float("-.5"), float(3), float("nan") != float("nan"), complex("1+2j"), complex(3), complex(1, 2), bool(""), bool("x"), bin(5), oct(8), hex(255), bin(-1), hex(-17), chr(65), ord("A"), ord("€"), chr(0x10FFFF) == "\U0010ffff", hash(5), hash(2.0), hash(True))
class N:
    def __abs__(self): return "abs"
    def __divmod__(self, o): return ("dm", o)
    def __rdivmod__(self, o): return ("rdm", o)
    def __pow__(self, o, m=None): return ("pow", o, m)
    def __rpow__(self, o, m=None): return ("rpow", o)
    def __round__(self, *a): return ("round", a)
    def __int__(self): return 42
    def __float__(self): return 4.5
    def __index__(self): return 7
    def __complex__(self): return 1j
    def __bool__(self): return False
    def __trunc__(self): return 9
n = N()
print(abs(n), divmod(n, 1), divmod(1, n), pow(n, 2), pow(n, 2, 3), pow(2, n), round(n), round(n, 1), int(n), float(n), bin(n), hex(n), oct(n), complex(n), bool(n), chr(n) == "\x07", range(n), [1] * n, "abcdefgh"[n], (5).__round__(n), int("11", base=N()))
class OnlyIndex:
    def __index__(self): return 3
class OnlyTrunc:
    def __trunc__(self): return 8
print(int(OnlyIndex()), float(OnlyIndex()), complex(OnlyIndex()), int(OnlyTrunc()))
for f in (lambda: abs("a"), lambda: abs(None), lambda: divmod(1, 0), lambda: divmod("a", "b"), lambda: divmod(1j, 1), lambda: pow("a", 2), lambda: pow(2, 3, 0), lambda: pow(2, -1, 4), lambda: pow(2.0, 3, 5), lambda: pow(2, 3, 5.0), lambda: pow(2, "a"), lambda: round("a"), lambda: round(1.5, "a"), lambda: round(None), lambda: round(1, 1.5), lambda: int("a"), lambda: int("1.5"), lambda: int("0x1"), lambda: int("5", 1), lambda: int("5", 40), lambda: int(5, 10), lambda: int("12", 2), lambda: int(""), lambda: int(" "), lambda: int("- 5"), lambda: int("+-5"), lambda: int(1j), lambda: int({}), lambda: float("a"), lambda: float(""), lambda: float([]), lambda: float("1 2"), lambda: chr(-1), lambda: chr(0x110000), lambda: chr("a"), lambda: ord("ab"), lambda: ord(5), lambda: bin("a"), lambda: bin(1.0), lambda: hex(None), lambda: complex("a"), lambda: complex(None), lambda: float("0x10"), lambda: int("²"), lambda: pow(0, -1), lambda: 0 ** -1.5, lambda: round(float("nan")), lambda: int(float("inf")), lambda: sum([1, "a"]), lambda: int("1" * 4301), lambda: len(str(10 ** 4300)), lambda: len(str(10 ** 4299)), lambda: len(hex(10 ** 5000))):
    t(f)
