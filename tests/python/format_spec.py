# Every format specification, and what is refused.
def t(v, spec):
    try:
        print(repr(spec).ljust(14), repr(format(v, spec)))
    except Exception as e:
        print(repr(spec).ljust(14), type(e).__name__, e, sep=": ")

for v in (0, 5, -5, 12345, -1234567, 2 ** 70, True):
    print("---", v)
    for s in ("", "d", "5d", "<8", ">8", "^8", "=8", "08", "+d", " d", "-d", "*^9", "*=9d", "b", "#b", "o", "#o", "x", "#x", "X", "#X", "#010x", "_b", "_x", ",", "_", ",d", "015,", "015_d", "c" if 0 <= v < 1000 else "n", "e", ".2f", "f", "g", "%", ".1%", "+,", "n", "010", "<010", "z.1f", "x>+9,", "#_x", "é^9"):
        t(v, s)
for v in (0.0, -0.0, 1.5, -2.675, 1234567.891, 1e-7, 1e22, 123456789012345680.0, float("inf"), float("-inf"), float("nan"), 0.00012345, 99999.95, 1e100):
    print("---", v)
    for s in ("", "f", ".0f", ".1f", ".2f", "#.0f", "e", ".0e", ".3e", "#.0e", "E", "g", ".3g", "#g", "G", ".10g", ".17g", "%", ".0%", "+.1f", " .1f", "08.2f", "+010.2f", "<10.1f", "^10.1f", "*=10.1f", ",", ",.2f", "_.1f", "015,.2f", "n", ".3", ".1", ".20f", "z.0f", "z.1f", "F", "10", "010", "#", "+"):
        t(v, s)
for v in ("", "abc", "héllo", "x" * 12):
    print("---", v)
    for s in ("", "s", "10", "<10", ">10", "^10", "*^11", ".2", "10.2", ">10.1s", "05", "-<7", "{<6", "é>8"):
        t(v, s)
print("--- errors")
for v, s in ((1, "s"), (1, ".2d"), (1, ".2"), (1, "q"), (1.0, "d"), (1.0, "s"), (1.0, "x"), ("a", "d"), ("a", "=10"), ("a", "+"), ("a", ","), ("a", "#"), ("a", " "), ("a", "_"), (1, ",x"), (1, ",b"), (1, "_c"), (1, ",,"), (1, ",_"), (1, "+c"), (1, "#c"), (-1, "c"), (1114112, "c"), (1, "5.d"), (1, "."), (1.0, ".f"), (None, "5"), ([], "5"), ({}, "x"), ((1,), ">9"), (1.0, ",e"), (1.0, "_%"), (1.0, "c"), ("a", "10d"), (1, "zd"), (1, "99999999999999999999"), (1.0, ".99999999999999999999f"), (1j, "=10"), (1j, "010"), (1, "10 "), (True, "s"), (object, "5"), (1, "__"), (1.5, "__"), (1.5, "ab"), (1, "+ d")):
    t(v, s)
print(format(None), format([1], ""), format((1,)), format(True), format(True, "5"), format(False, "d"), format(1.0), format("a"))
print(f"{5:{'>'}{10}}|", f"{3.14159:.{2}f}", f"{'x':{'*'}^{7}}", f"{10:#{'x'}}", f"{1:{''}}")
class F:
    def __format__(self, spec):
        return f"<{spec}>"
class G(F):
    def __str__(self):
        return "G!"
    def __format__(self, spec):
        return spec and 3
print(f"{F()}", f"{F():abc}", "{:{}}".format(F(), "q"), format(F(), "z"), f"{G()!s:>5}")
try:
    format(G(), "x")
except TypeError as e:
    print(e)
try:
    format(1, 2)
except TypeError as e:
    print(e)
try:
    format(object(), "x")
except TypeError as e:
    print(e)
