def g(f):
    try: f()
    except BaseException as e: return e
class A: pass
a = A()
e = g(lambda: a.missing); print(e.name, e.obj is a, e.args)
e = g(lambda: A.missing); print(e.name, e.obj is A, e)
e = g(lambda: [].foo); print(e.name, e.obj, e)
e = g(lambda: undefined_name); print(e.name, e.args)
e = g(lambda: {}["k"]); print(e.args, repr(e.args[0]), str(e))
e = g(lambda: next(iter([]))); print(e.value, e.args)
e = g(lambda: [][1]); print(e.args)
def gen(): return 5; yield
e = g(lambda: next(gen())); print(e.value, e.args, repr(e))
e = g(lambda: "é".encode("ascii")); print(e.encoding, e.object, e.start, e.end, e.reason, e.args)
e = g(lambda: b"\xff".decode()); print(e.encoding, e.object, e.start, e.end, e.reason)
e = g(lambda: 1 / 0); print(e.args, e.__cause__, e.__context__, e.__suppress_context__, e.__traceback__ is not None)
for e in (OSError(2, "No such file"), OSError(13, "denied", "f.txt"), OSError("one"), OSError(), ImportError("msg", name="n", path="p"), SystemExit(3), SystemExit("bye"), StopIteration(1, 2), KeyError(), KeyError(1), KeyError("a", "b"), ValueError(None), ValueError(1, "x"), Exception(""), Exception([1]), UnicodeEncodeError("utf-8", "a", 0, 1, "why"), SyntaxError("bad"), AttributeError("m", name="q"), NameError("n", name="nm"), AssertionError("a"), MemoryError(), RecursionError("deep"), NotImplementedError("todo"), KeyboardInterrupt(), GeneratorExit(), ArithmeticError(1), LookupError("l"), BufferError("b"), EOFError(), FloatingPointError("f"), TimeoutError("t"), PermissionError(1, "p"), IsADirectoryError("d"), Warning("w"), DeprecationWarning("d"), UserWarning(), BlockingIOError(11, "x")):
    print(type(e).__name__, repr(e), "|", str(e), "|", e.args)
class E(Exception):
    def __init__(self, a, b=2): self.a = a
e = E(1, b=3)
print(e.args, repr(e), str(e), e.a)
class F(Exception):
    def __init__(self, *a, **k): super().__init__(*a); self.k = k
print(F(1, 2, x=3).args, F(1, x=3).k, repr(F()), str(F("m")))
class G(KeyError, ValueError): pass
try: raise G("both")
except ValueError as e: print(type(e).__mro__[1].__name__, str(e))
e = ValueError("x"); e.add_note("n1"); print(e.__notes__, vars(e))
e.args = (1, 2); print(str(e), repr(e)); e.args = "ab"; print(e.args)
class H(Exception):
    code = 5
    @property
    def message(self): return f"{self.args[0]} ({self.code})"
print(H("m").message, isinstance(H(), Exception), issubclass(H, BaseException), H.__name__, H.__mro__[1].__name__)
try:
    try: raise ValueError("inner")
    except ValueError as exc: raise H("outer") from exc
except H as h: print(repr(h.__cause__), h.__cause__ is h.__context__, h.__suppress_context__)
print(ValueError("a") == ValueError("a"), len({ValueError("a"), ValueError("a")}), bool(ValueError()), ValueError("a", 1).args + (2,), Exception().__class__.__name__, isinstance(g(lambda: int("x")), ValueError), ValueError.__init__ is not None, ValueError.__doc__ is not None, Exception.__new__(ValueError, 5).args, type(g(lambda: exit_now)).__name__)
