eg = ExceptionGroup("group", [ValueError("a"), TypeError("b"), ExceptionGroup("inner", [KeyError("c"), ValueError("d")])])
print(eg, repr(eg), eg.message, len(eg.exceptions), type(eg.exceptions).__name__)
m, r = eg.split(ValueError)
print(repr(m), repr(r))
print(repr(eg.subgroup(KeyError)), eg.subgroup(OSError), repr(eg.subgroup(lambda e: "a" in str(e))), repr(eg.derive([ValueError(1)])))
def run(exc):
    try:
        try:
            raise exc
        except* ValueError as e:
            print("V", repr(e))
        except* (KeyError, IndexError) as e:
            print("K", repr(e))
        else:
            print("else")
        finally:
            print("finally")
    except BaseException as e:
        print("left", repr(e), repr(e.__context__) if not isinstance(e, BaseExceptionGroup) else "")
run(eg)
run(ValueError("plain"))
run(TypeError("other"))
run(ExceptionGroup("only", [ValueError(1), KeyError(2)]))
try:
    pass
except* ValueError:
    print("no")
else:
    print("nothing raised")
def reraise():
    try:
        raise ExceptionGroup("g", [ValueError(1), TypeError(2)])
    except* ValueError as e:
        raise
try:
    reraise()
except ExceptionGroup as e:
    print("reraised", repr(e))
def newraise():
    try:
        raise ExceptionGroup("g", [ValueError(1), TypeError(2)])
    except* ValueError as e:
        raise KeyError("new") from e
    except* TypeError:
        print("also here")
try:
    newraise()
except Exception as e:
    print("new", repr(e), repr(e.__cause__), repr(e.__context__))
def two_new():
    try:
        raise ExceptionGroup("g", [ValueError(1), TypeError(2), OSError(3)])
    except* ValueError as e:
        raise KeyError("new")
    except* TypeError:
        raise IndexError("newer")
try:
    two_new()
except ExceptionGroup as e:
    print("two", repr(e), [repr(x) for x in e.exceptions])
def t(f):
    try:
        print(repr(f()))
    except Exception as e:
        print(type(e).__name__, e, sep=": ")
t(lambda: ExceptionGroup("x", []))
t(lambda: ExceptionGroup("x", [5]))
t(lambda: ExceptionGroup("x", 5))
t(lambda: ExceptionGroup(5, [ValueError()]))
t(lambda: ExceptionGroup("x"))
t(lambda: ExceptionGroup("x", [KeyboardInterrupt()]))
t(lambda: BaseExceptionGroup("x", [ValueError()]))
t(lambda: BaseExceptionGroup("x", [KeyboardInterrupt()]))
t(lambda: eg.split(5))
class MyEG(ExceptionGroup):
    def derive(self, excs):
        return MyEG(self.message + "!", excs)
print(repr(MyEG("m", [ValueError(1), KeyError(2)]).split(ValueError)))
def badstar():
    try:
        raise ValueError
    except* ExceptionGroup:
        pass
t(badstar)
print(isinstance(eg, Exception), issubclass(ExceptionGroup, BaseExceptionGroup), [c.__name__ for c in ExceptionGroup.__mro__])
for i in range(3):
    try:
        if i: raise ExceptionGroup("l", [ValueError(i)])
    except* ValueError as e:
        print("loop", i, e.exceptions)
    else:
        print("loop else", i)
