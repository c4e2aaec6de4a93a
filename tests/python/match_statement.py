class Pt:
    __match_args__ = ("x", "y")
    def __init__(self, x, y): self.x, self.y = x, y
class Plain:
    def __init__(self, **k): self.__dict__.update(k)
class Color:
    RED = "red"
    class Deep: BLUE = "blue"
def m(v):
    match v:
        case None: return "None"
        case True | False as b: return f"bool {b}"
        case 0: return "zero"
        case -1 | -2.5: return "neg"
        case 1 + 2j: return "complex"
        case "hi" | b"hi": return "greeting"
        case Color.RED: return "red const"
        case Color.Deep.BLUE: return "blue const"
        case int(n) if n > 100: return f"big {n}"
        case int() | float() as n: return f"num {n}"
        case str(s): return f"str {s}"
        case []: return "empty seq"
        case [x]: return f"one {x}"
        case [1, 2, *rest]: return f"12+{rest}"
        case [first, *_, last] if first == last: return f"same ends {first}"
        case (a, [b, *c], {"k": d}): return f"nested {a} {b} {c} {d}"
        case [*_, "end"]: return "ends"
        case (x, y): return f"pair {x} {y}"
        case Pt(0, 0): return "origin"
        case Pt(x=0, y=yy): return f"on y {yy}"
        case Pt(xx, Pt(a, b)): return f"pt in pt {xx} {a} {b}"
        case Pt(xx): return f"pt x={xx}"
        case {"type": "circle", "r": r}: return f"circle {r}"
        case {"type": t, **rest} if rest: return f"typed {t} {rest}"
        case {"only": _}: return "only"
        case {1: a, 2: b}: return f"ints {a} {b}"
        case {}: return "mapping"
        case Plain(name=n, age=int(a)): return f"plain {n} {a}"
        case Plain(name=n): return f"plain2 {n}"
        case set() | frozenset(): return "set"
        case type(): return "type"
        case _: return "other"
for v in (None, True, False, 0, 0.0, -1, -2.5, 1 + 2j, "hi", b"hi", "red", "blue", 101, 7, 1.5, "s", [], (), [5], (1, 2), [1, 2, 3, 4], (3, 4, 3), [1, [2, 3, 4], {"k": 5, "z": 1}], ["a", "b", "end"], (8, 9), [1, 3, 4], Pt(0, 0), Pt(0, 5), Pt(1, Pt(2, 3)), Pt(9, 9), {"type": "circle", "r": 2, "x": 1}, {"type": "sq", "w": 1}, {"type": "bare"}, {"only": 1}, {1: "a", 2: "b", 3: "c"}, {}, {"q": 1}, Plain(name="n", age=3), Plain(name="n", age="x"), Plain(zz=1), {1}, frozenset(), int, range(3), range(0), object(), bytearray(b"x"), iter([1]), (c for c in "")):
    print(m(v))
def cap(v):
    match v:
        case [a, b] | [a, b, _]: return a, b
        case {"a": [x, {"b": y}]}: return x, y
        case (int() as i, str() as s, *r): return i, s, r
        case x: return ("capture", x)
print(cap([1, 2]), cap((1, 2, 3)), cap({"a": (1, {"b": 2})}), cap((1, "a", 5, 6)), cap("zz"))
def lits(v):
    match v:
        case 1: return "int 1"
        case 1.5: return "1.5"
        case "a" "b": return "ab"
        case -0.0: return "zero"
        case 10 | 20 | 30: return "tens"
    return "none"
print([lits(v) for v in (1, True, 1.0, 1.5, "ab", 0, 20, "x")])
x = 5
match x:
    case y if y > 10: print("big")
    case y if (z := y * 2) == 10: print("guard walrus", z, y)
match (1, 2, 3):
    case a, b, c: print(a, b, c)
match 1, 2:
    case 1, q: print(q)
match [1, [2, [3, [4]]]]:
    case [a, [b, [c, [d]]]]: print(a + b + c + d)
def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")
def bad1():
    match Plain(a=1):
        case Plain(1): return "no"
def bad2():
    match Pt(1, 2):
        case Pt(1, 2, 3): return "no"
def bad3():
    match Pt(1, 2):
        case Pt(1, x=5): return "no"
def bad4():
    match 5:
        case x.y.z: return "no"
def bad5():
    notcls = 5
    match 5:
        case notcls(): return "no"
class BadArgs: __match_args__ = 5
class BadArgs2: __match_args__ = (1,)
class BadArgs3: __match_args__ = ["x"]
def bad6():
    match BadArgs():
        case BadArgs(1): return "no"
def bad7():
    match BadArgs2():
        case BadArgs2(1): return "no"
def bad8():
    match BadArgs3():
        case BadArgs3(1): return "no"
def bad9():
    match 5:
        case int(1, 2): return "no"
def bad10():
    match {1: 2}:
        case {Color.RED: 1, "red": 2}: return "no"
    return "fell through"
for f in (bad1, bad2, bad3, bad4, bad5, bad6, bad7, bad8, bad9, bad10):
    t(f)
class Log:
    def __eq__(self, o):
        print("eq", o)
        return o == 2
match Log():
    case 1: print("one")
    case 2: print("two")
class LM(dict):
    def get(self, k, d=None):
        print("get", k)
        return super().get(k, d)
match LM(a=1):
    case {"a": 2}: print("no")
    case {"b": _}: print("no")
    case {"a": 1}: print("yes")
class Len(list):
    def __len__(self):
        print("len")
        return super().__len__()
match Len([1, 2]):
    case [_]: print("no")
    case [a, _]: print("two", a)
def order(s):
    match s.split():
        case ["go", ("north" | "south") as d]: return d
        case ["go", *_]: return "where?"
        case ["take", item, *others]: return item, others
        case [cmd]: return cmd
        case _: return "?"
print([order(s) for s in ("go north", "go up", "take a b c", "look", "", "x y")])
def ev(e):
    match e:
        case int() | float(): return e
        case ("+", a, b): return ev(a) + ev(b)
        case ("*", a, b): return ev(a) * ev(b)
        case ("neg", a): return -ev(a)
print(ev(("+", 1, ("*", 2, ("neg", 3)))), ev("x"))
match = 5; case = 6; _ = 7
print(match, case, _)
match match:
    case 5: print("soft keyword")
def unbound(v):
    match v:
        case [a, 5]: pass
        case [_, b]: pass
    try: return a
    except UnboundLocalError: return "a unbound"
print(unbound([1, 5]), unbound([1, 6]))
