x: int = 5
y: "undefined type"
z: list[int] = [1]
(paren): float = 2.5
print(x, z, paren, __annotations__)
try: y
except NameError as e: print(e)
class A:
    a: int
    b: str = "b"
    c: "Forward" = None
    d: list["A"] = []
    def m(self, p: int, *q: str, r: float = 1.0, **s: dict) -> "A": return self
print(A.__annotations__, A.b, hasattr(A, "a"), A.m.__annotations__)
class B(A):
    e: bool
print(B.__annotations__, B.__dict__.get("__annotations__"), A.__annotations__ is B.__annotations__)
def f(a: int = "not checked", b: print("evaluated") = 1) -> None:
    local: undefined_is_fine = 3
    other: int
    try: other
    except UnboundLocalError as e: print(e)
    return local
print(f(), f.__annotations__)
l = [0, 1]
l[0]: int = 5
A.attr: int = 7
print(l, A.attr, "attr" in A.__annotations__)
def g(a: "str", /, b: int | None = None, *, c: dict[str, int] = {}): pass
print(g.__annotations__)
lam = lambda v: v
print(lam.__annotations__)
class Empty: pass
print(Empty.__annotations__, f.__annotations__ is f.__annotations__)
try:
    bad: undefined_name = 1
except NameError as e: print(e)
i: int
for i in range(2): pass
print(i, list(__annotations__))
