def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, e.args, sep=": ")

def flow(n):
    out = []
    try:
        out.append("try")
        if n == 1: raise ValueError("v")
        if n == 2: raise KeyError("k")
        if n == 3: return out
        if n == 4: raise IndexError
    except ValueError as e:
        out.append(f"except {e}")
    except (KeyError, TypeError) as e:
        out.append(f"tuple {e!r}")
    except Exception:
        out.append("any")
    else:
        out.append("else")
    finally:
        out.append("finally")
    out.append("after")
    return out
for n in range(5):
    print(n, flow(n))
def ret_order():
    try:
        return "try"
    finally:
        print("finally first")
print(ret_order())
def override():
    try:
        return "try"
    finally:
        return "finally"
print(override())
def swallow():
    try:
        1 / 0
    finally:
        return "swallowed"
print(swallow())
def loops():
    for i in range(5):
        try:
            if i == 1: continue
            if i == 3: break
            print("body", i)
        finally:
            print("fin", i)
    else:
        print("no else")
    return i
print(loops())
def fin_break():
    for i in range(3):
        try:
            1 / 0
        finally:
            break
    return "broke", i
print(fin_break())
def fin_continue():
    r = []
    for i in range(3):
        try:
            r.append(i)
            if i == 1: return r
        finally:
            if i < 2: continue
    return "end", r
print(fin_continue())
def value_kept():
    x = 1
    try:
        return x
    finally:
        x = 2
print(value_kept())
def nested():
    try:
        try:
            raise ValueError("inner")
        except TypeError:
            print("no")
        finally:
            print("inner finally")
    except ValueError as e:
        print("outer", e)
        try:
            raise
        except ValueError as e2:
            print("reraised", e2 is e)
nested()
for f in (lambda: int("x"), lambda: [][0], lambda: {}["k"], lambda: {}[1, 2], lambda: None.x, lambda: 1 + "", lambda: 1 / 0, lambda: undefined, lambda: next(iter([])), lambda: float("x"), lambda: "é".encode("ascii"), lambda: b"\xff".decode(), lambda: [].pop(), lambda: {}.popitem(), lambda: set().pop(), lambda: {}.pop("a"), lambda: [1].remove(2), lambda: [1].index(5), lambda: (1,).index(5), lambda: "a".index("b"), lambda: "a".rindex("b"), lambda: {1}.remove(2), lambda: [].pop(3), lambda: [1].pop(5), lambda: chr(-1), lambda: chr(1114112), lambda: ord(""), lambda: range(5).index(9), lambda: max([]), lambda: min(()), lambda: "a".split(""), lambda: "".partition(""), lambda: "x" * (10 ** 20) if False else 0, lambda: int("9" * 5000), lambda: range(0, 1, 0), lambda: list(zip([1], [1, 2], strict=True)), lambda: list(zip([1, 2], [1], strict=True)), lambda: list(zip([1], [1], [], strict=True)), lambda: bytes([256]), lambda: bytes(-1), lambda: "abc".zfill(-5), lambda: iter([1]).__next__() , lambda: (1).__div__, lambda: [1, 2, 3].index(1, 1), lambda: "abc".format_map(5), lambda: b"a".fromhex("z"), lambda: "a".encode("nope"), lambda: dict([(1,)]), lambda: {**{1: 2}, **{}}, lambda: sum(1), lambda: [3, "a"].sort(), lambda: range(10 ** 30)[10 ** 31], lambda: len(range(10 ** 30)), lambda: [0] * (2 ** 70), lambda: "a" * (2 ** 70), lambda: 1 << (2 ** 70), lambda: (0).to_bytes(-1, "big"), lambda: round(1, "a")):
    t(f)
def asserts():
    for f in (lambda: ass(1), lambda: ass(0), lambda: ass2(0), lambda: ass3(())):
        t(f)
def ass(x): assert x
def ass2(x): assert x, ("tuple", x)
def ass3(x): assert x, f"message {x}"
asserts()
def bad_raise(v):
    raise v
for v in (5, "str", None, object, int, ValueError, ValueError(), KeyError("a"), OSError(2, "No such"), StopIteration(3), Exception(1, 2), [ValueError]):
    t(lambda: bad_raise(v))
def bad_except():
    try:
        1 / 0
    except 5:
        pass
t(bad_except)
def bad_except2():
    try:
        1 / 0
    except (ValueError, "a"):
        pass
t(bad_except2)
def bare():
    raise
t(bare)
class MyErr(Exception): pass
class Sub(MyErr):
    def __init__(self, a, b=None):
        self.a = a
    def __str__(self): return f"sub {self.a}"
t(lambda: bad_raise(MyErr))
t(lambda: bad_raise(MyErr("one")))
t(lambda: bad_raise(MyErr("one", 2)))
t(lambda: bad_raise(Sub(7)))
t(lambda: bad_raise(Sub))
print(repr(MyErr("x")), repr(MyErr()), repr(MyErr(1, "b")), repr(Sub(1, 2)), str(MyErr()), str(MyErr(None)), str(MyErr(("a",))), repr(KeyError("k")), str(KeyError("k")), str(KeyError("a", "b")), str(KeyError()), repr(ValueError("it's")), MyErr("a") == MyErr("a"))
def name_gone():
    try:
        raise ValueError("x")
    except ValueError as e:
        saved = e
    try:
        e
    except UnboundLocalError as err:
        return str(err), saved
print(name_gone())
print([c.__name__ for c in KeyError.__mro__], [c.__name__ for c in ZeroDivisionError.__mro__], [c.__name__ for c in UnicodeEncodeError.__mro__], issubclass(RecursionError, RuntimeError), issubclass(NotImplementedError, RuntimeError), issubclass(ModuleNotFoundError, ImportError), issubclass(KeyboardInterrupt, Exception), IOError is OSError, EnvironmentError is OSError)
e = ValueError("a", 1)
e.extra = 5
e.args = ("changed",)
print(e, e.extra, e.__dict__, repr(e), e.__traceback__, e.__cause__, e.__context__, e.__suppress_context__)
print(repr(StopIteration(5).value), StopIteration().value, AttributeError("x", name="n", obj=1).name, NameError("q", name="z").name, KeyError("x").args, SystemExit(3).code, SystemExit().code, OSError(2, "msg").errno, OSError(2, "msg").strerror, str(OSError(2, "msg", "file")), type(OSError(2, "msg")).__name__, UnicodeDecodeError("utf-8", b"a", 0, 1, "why"))
def rec(n): return rec(n + 1) + 1
try:
    rec(0)
except RecursionError as e:
    print(str(e).startswith("maximum recursion depth exceeded"))
def both():
    try:
        return int("z")
    except ValueError:
        return "handled"
    else:
        return "never"
    finally:
        print("finally of both")
print(both())
try:
    try:
        raise KeyError("first")
    finally:
        try:
            raise IndexError("second")
        except IndexError as e:
            print("in finally", repr(e.__context__))
except KeyError as e:
    print("still", e, e.__context__)
def gen_except():
    for v in (1, "a", None):
        try:
            yield v + 1
        except TypeError as e:
            yield str(e)
print(list(gen_except()))
while True:
    try:
        break
    finally:
        print("broke out")
def deep():
    for a in range(2):
        for b in range(2):
            try:
                try:
                    if b: continue
                    print(a, b)
                finally:
                    print("f1", a, b)
            finally:
                print("f2", a, b)
deep()
