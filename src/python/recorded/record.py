"""Records what CPython 3.11 answers, for the unit tests of numbers and text: run it beside the tables that it writes."""
import json
import math
import random
import struct
import sys

assert sys.version_info[:2] == (3, 11), "the tables are those of CPython 3.11"
random.seed(7)


def bits(x):
    if x != x:
        x = float("nan")
    return str(struct.unpack("<Q", struct.pack("<d", x))[0])


def write(name, rows):
    with open(name, "w", encoding="utf-8") as out:
        out.write("[\n" + ",\n".join(json.dumps(row) for row in rows) + "\n]\n")


def attempt(f, show):
    try:
        return show(f())
    except Exception as error:
        return f"{type(error).__name__}: {error}"


FLOATS = [0.0, -0.0, 0.1, 0.5, 1.0, 1.5, 2.5, -2.5, 2.675, 1e15, 1e16, 123456789012345680.0, 1e22, 1e23, 1e-4, 1e-5, 5e-324,
          2.2250738585072014e-308, 1.7976931348623157e308, math.pi, -math.e * 1e-7, 0.25, 0.35, 1e100, 9007199254740993.0,
          3.0, 100.0, 12345.678, 0.0001, 0.00012345, float("inf"), float("-inf"), float("nan")]


def any_float():
    kind = random.random()
    if kind < 0.4:
        return round(random.uniform(-1000, 1000), random.randrange(6))
    if kind < 0.6:
        return random.randrange(-2000, 2000) / 8
    x = struct.unpack("<d", struct.pack("<Q", random.getrandbits(64)))[0]
    return x if math.isfinite(x) else 0.125


MANY = FLOATS + [any_float() for _ in range(150)]


def numbers():
    ints = [1, 3, 7, 10**15, 2**53 - 1, 2**53 + 1, 2**63 - 1, 10**30, 10**308, 10**310, 10**400, 3**500, 5**700, 2**1074, 7 * 2**1080]
    pairs = [(random.choice((1, -1)) * a, b) for a in ints for b in ints if random.random() < 0.5]
    pairs += [(random.getrandbits(random.randrange(1, 200)), random.getrandbits(random.randrange(1, 200)) + 1) for _ in range(150)]
    # Halfway cases, and subnormal results.
    pairs += [(2**54 + 2 * k + 1, 2**e) for k in range(4) for e in (1, 60, 1074)] + [(k, 2**1074) for k in range(1, 8)] + [(k, 2**1075) for k in range(1, 8)]
    write("divide.json", [[str(a), str(b), attempt(lambda: a / b, bits)] for a, b in pairs])
    rows = [[bits(x), n, attempt(lambda: round(x, n), bits)] for x in MANY for n in (0, 1, 2, 3, 5, 10, 17, -1, -2, -3, -16, -308, 323, 400, -400)
            if math.isfinite(x) and n in (0, 1, 2, -1) or random.random() < 0.2]
    write("round.json", rows)
    pairs = [(random.choice(MANY), random.choice(MANY)) for _ in range(400)]
    write("divmod.json", [[bits(x), bits(y), *map(bits, divmod(x, y))] for x, y in pairs if y != 0 and x == x and y == y])
    write("hash_float.json", [[bits(x), hash(x)] for x in MANY if x == x])
    write("hash_int.json", [[str(n), hash(n)] for n in (0, 1, -1, 2**61 - 1, 2**61, -2**61, 2**63, -2**100, 10**30, 10**100 + 7)])
    texts = [("0", 10), ("-0", 10), ("12", 10), (" +7\n", 10), ("1_000", 10), ("1__0", 10), ("_1", 10), ("1_", 10), ("", 10), ("-", 10),
             ("0x1f", 16), ("1F", 16), ("0x1f", 0), ("0b101", 0), ("0o17", 0), ("0o8", 0), ("010", 0), ("00", 0), ("0_0", 0), ("0x_1", 0),
             ("0_x1", 0), ("0b", 2), ("z", 36), ("9", 8), ("0b1", 16), ("\u0663\u0664", 10), ("1\u0663", 10), ("\u00b2", 10), ("1 2", 10), ("- 1", 10),
             ("9" * 40, 10), ("9" * 4300, 10), ("9" * 4301, 10), ("f" * 5000, 16), ("\u30001\u2003", 10), ("+-1", 10), ("1.5", 10), ("0x", 16)]
    write("parse_int.json", [[t, b, attempt(lambda: int(t, b), hex)] for t, b in texts])
    texts = ["1", "1.", ".5", ".", "", "1e5", "1e", "1e+", "1E-3", "-1.5e-7", "+.5", "inf", "-Infinity", "NaN", "nano", "infinit", "1_0.5", "1_.5",
             "1._5", "1e1_0", "1e_1", "_1", "1__0", " 7\t", "1 2", "0x1p3", "\u0663.\u0665", "1e400", "-1e-400", "1d5", "9007199254740993", "2.675",
             "0." + "0" * 400 + "1", "1" * 400, "1\u0663", "\u00bd", "e5", "+", "--1", "1e5.5"]
    write("parse_float.json", [[t, attempt(lambda: float(t), bits)] for t in texts])
    texts = ["1+2j", "1", "j", "-j", "+j", "1j", "(1+2j)", " ( 1-2J ) ", "1+j", "1-j", "1 + 2j", "1+2", "x", "", "()", "(", "1e5j", "1e5-1e-5j", "nan+infj",
             "1_0+2_0j", "+1-+2j", "1+2j3", "jj", ".5j", "1.5-.5j", "-0j", "(1+2j", "1+2j)", "((1))"]
    write("parse_complex.json", [[t, attempt(lambda: complex(t), lambda c: bits(c.real) + " " + bits(c.imag))] for t in texts])


SPECS = ["", "5", "<5", ">5", "^6", "=8", "*^9", "\u00e9>4", "05", "<05", "+", " ", "-", "+08", "z", "z.1f", "#", "#x", "#010X", "#b", "_b", "_x", "o", "x", "X", "c", "5c",
         "+c", "#c", "d", "n", ",", "_", ",d", "015,", "014,", "08_", "<15,", ",x", ",s", ",c", ".2f", ".0f", "#.0f", "10.3f", "010.3f", "+.3e", "E", ".0e",
         "#.0e", "g", "G", "#g", ".3g", ".10g", ".3", ".17", "20.15", "#.3", "%", ".1%", ",.2f", "_.3f", "015,.1f", "F", "s", ".2", "<8.2s", "^7s", "=5s", "10s", "abc",
         "5dd", ".", "1.", "99999999999999999999d", ".99999999999999999999f", ".9999999999f", ",_", "_,", ",,", "\x01", "\u00e9", "q", "0", "00", "000005", "^^5", "<<5", "{", "}",
         ".60g", "#.60g"]
LONG = ["1000", ".400f", ".1100e"]


def text():
    ints = [0, 1, -1, 7, 97, 255, -255, 12345, -1234567, 10**20, -10**30, 0x10ffff, 2**70]
    floats = FLOATS + [any_float() for _ in range(12)] + [9.995, 0.05, 1e10, 999999.5, 1234567.891]
    complexes = [0j, 1j, -1j, 1 + 2j, complex(-0.0, 1), complex(1.5, -0.0), complex(1e20, float("nan")), 1234.5 - 2j]
    strings = ["", "a", "abcdef", "h\u00e9llo", "\u4f60\u597d"]
    rows = []
    for kind, values, show in (("int", ints, str), ("float", floats, bits), ("complex", complexes, lambda c: bits(c.real) + " " + bits(c.imag)), ("str", strings, str)):
        for value in values:
            for spec in SPECS + LONG:
                if random.random() < (0.7 if kind == "str" else 0.05 if spec in LONG else 0.3):
                    rows.append([kind, show(value), spec, attempt(lambda: format(value, spec), str)])
    write("format.json", rows)
    write("float_repr.json", [[bits(x), repr(x)] for x in MANY])
    texts = ["", "a", "it's", 'say "hi"', "it's \"both\"", "tab\tnew\nret\r", "\\", "\0\x1f\x7f", "\u00e9\u00a0\u00ad", "\u200b\u2028\ufeff", "\U0001f600\U000e0001", "\ue000\uffff",
             "\u0378", "\u4f60", "\u0301", "\u3000"]
    write("repr.json", [[t, repr(t), ascii(t)] for t in texts])
    import unicodedata
    # This letter got its capital in Unicode 16.
    some = [chr(c) for c in range(0x250) if c != 0x19b] + [chr(c) for c in range(0x110000) if unicodedata.category(chr(c)) not in ("Cn", "Cs", "Co") and random.random() < 0.002]
    some += list("\u01c4\u01c5\u01c6\u01f1\u0390\u10d0\u13a0\u13f8\uab70\u1e9e\u1f80\u1f88\u1fb2\u1fb3\u1fb7\u1fbc\ufb00\ufb03\u0587\u2460\u00b2\u2155\u4e00\u0660\u0669\u3007\u2160\U0001d7ce\U0001d7ff\u3000")
    rows = [[c, [c.isalpha(), c.isdecimal(), c.isdigit(), c.isnumeric(), c.isspace(), c.isprintable(), unicodedata.category(c) == "Lt"], c.title(), c.casefold()] for c in some]
    write("characters.json", rows)


if __name__ == "__main__":
    numbers()
    text()
