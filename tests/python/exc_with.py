class Ctx:
    def __enter__(self): print("in"); return self
    def __exit__(self, *a): print("out", a[0].__name__); return False
with Ctx():
    [1, 2].index(9)
