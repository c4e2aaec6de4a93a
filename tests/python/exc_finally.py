def f():
    try:
        raise ValueError("first")
    finally:
        print("cleaning up")
        raise KeyError("second")
try:
    f()
finally:
    print("outer finally")
