def f():
    try:
        raise KeyboardInterrupt("stopped")
    except Exception:
        print("not here")
    finally:
        print("but here")
f()
