def chain(e, depth=0):
    print("  " * depth + f"{type(e).__name__}({e}) suppress={e.__suppress_context__}")
    if e.__cause__: print("  " * depth + "cause:"); chain(e.__cause__, depth + 1)
    if e.__context__ and e.__context__ is not e.__cause__: print("  " * depth + "context:"); chain(e.__context__, depth + 1)
def run(f):
    try:
        f()
    except BaseException as e:
        chain(e)
def a():
    try:
        1 / 0
    except ZeroDivisionError:
        raise ValueError("during")
def b():
    try:
        1 / 0
    except ZeroDivisionError as e:
        raise ValueError("from") from e
def c():
    try:
        1 / 0
    except ZeroDivisionError:
        raise ValueError("none") from None
def d():
    raise KeyError("k") from IndexError
def e():
    try:
        raise ValueError("1")
    except ValueError:
        try:
            raise KeyError("2")
        except KeyError:
            raise TypeError("3")
def f():
    try:
        raise ValueError("1")
    except ValueError as x:
        raise x
def g():
    try:
        raise ValueError("body")
    finally:
        raise KeyError("finally")
def h():
    raise ValueError from 5
def i():
    try:
        raise ValueError("a")
    except ValueError:
        try:
            raise KeyError("b")
        except KeyError:
            pass
        raise TypeError("c")
def j():
    try:
        undefined_thing
    except NameError:
        [].missing
def k():
    err = ValueError("reused")
    try:
        raise err
    except ValueError:
        try:
            raise KeyError("mid")
        except KeyError:
            raise err
def l():
    class Ctx:
        def __enter__(self): return self
        def __exit__(self, *a): raise RuntimeError("exit failed")
    with Ctx():
        raise ValueError("in body")
def m():
    try:
        raise ValueError("x") from KeyError("explicit")
    except ValueError as e:
        raise RuntimeError("outer") from e.__cause__
def n():
    def gen():
        try:
            yield
        except ValueError:
            raise TypeError("in gen")
    it = gen()
    next(it)
    it.throw(ValueError("thrown"))
def o():
    try:
        raise Exception("with notes")
    except Exception as e:
        e.add_note("note 1")
        e.add_note("note 2")
        print(e.__notes__)
        try:
            e.add_note(5)
        except TypeError as t:
            print(t)
        raise
for fn in (a, b, c, d, e, f, g, h, i, j, k, l, m, n, o):
    print("---", fn.__name__)
    run(fn)
try:
    raise ValueError("tb")
except ValueError as e:
    print(e.__traceback__ is not None, e.with_traceback(None) is e, e.__traceback__)
e = ValueError()
e.__cause__ = KeyError("c")
print(repr(e.__cause__), e.__suppress_context__)
try:
    e.__cause__ = 5
except TypeError as t:
    print(t)
try:
    e.__context__ = "x"
except TypeError as t:
    print(t)
try:
    e.args = 5
except TypeError as t:
    print(t)
