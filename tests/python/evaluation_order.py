log = []
def e(tag, v=None):
    log.append(tag)
    return v
def show(label):
    print(label, " ".join(map(str, log)))
    log.clear()
class T:
    def __init__(self, n): self.n = n
    def __add__(self, o): log.append("add"); return self
    def __radd__(self, o): log.append("radd"); return self
    def __iadd__(self, o): log.append("iadd"); return self
    def __getitem__(self, k): log.append(f"get {k}"); return 1
    def __setitem__(self, k, v): log.append(f"set {k} {v}")
    def __delitem__(self, k): log.append(f"del {k}")
    def __getattr__(self, k): log.append(f"attr {k}"); return 1
    def __call__(self, *a, **k): log.append("call"); return 1
    def __lt__(self, o): log.append("lt"); return True
    def __contains__(self, o): log.append("in"); return True
    def __bool__(self): log.append("bool"); return True
t = T(1)
e("a", 1) + e("b", 2) * e("c", 3); show("arith")
e("a", 2) ** e("b", 3) ** e("c", 1); show("pow")
(e("a", 1), [e("b"), {e("c"): e("d"), e("e"): e("f")}], {e("g")}); show("displays")
e("f", lambda *a, **k: None)(e("x"), *e("y", []), e("z"), k=e("k"), **e("kw", {})); show("call")
e("o", t)[e("k", 5)] = e("v", 9); show("setitem")
e("o", t).attr2 if False else e("o", t).zz; show("attr")
x = y = e("once", 5); show("chain")
e("o", t)[e("i", 1)] += e("v", 2); show("aug item")
a = [0, 0]
i = 0
i, a[i] = 1, 5
print(i, a)
e("a", 1) < e("b", 2) < e("c", 3); show("cmp")
e("a", 3) < e("b", 2) < e("c", 3); show("cmp short")
e("a", 0) and e("b", 1); show("and")
e("a", 1) and e("b", 0) and e("c", 1); show("and")
e("a", 0) or e("b", 1) or e("c", 1); show("or")
e("yes", 1) if e("cond", 1) else e("no", 2); show("cond")
[e("elt") for _ in e("iter", [1]) if e("if", 1)]; show("comp")
{e("k"): e("v") for _ in e("iter", [1])}; show("dictcomp")
f"{e('a')}{e('b', 5):{e('spec', '>3')}}{e('c')!r}"; show("fstring")
def d(a=e("default a"), *, b=e("default b")) -> e("ret ann"): pass
show("def")
def ann(a: e("ann a") = e("def a"), *b: e("ann b"), c: e("ann c") = e("def c")) -> e("ret"): pass
show("ann")
@e("deco1", lambda f: e("apply1", f))
@e("deco2", lambda f: e("apply2", f))
def g(x=e("default")): pass
show("deco")
class C(e("base", object), metaclass=e("meta", type)):
    e("body")
show("class")
lst = [1, 2, 3]
lst[e("i", 0)], lst[e("j", 1)] = e("x", 10), e("y", 20); show("tuple assign")
print(lst)
del lst[e("d1", 0)], lst[e("d2", 0)]; show("del")
e("l", lst).append(e("arg")); show("method")
e("not", 1) not in e("container", []); show("not in")
assert e("test", 1), e("msg"); show("assert ok")
try:
    assert e("test", 0), e("msg", "m")
except AssertionError: pass
show("assert fail")
def gen():
    e("start"); yield e("y1"); e("mid"); yield e("y2"); e("end")
for v in gen(): e("loop")
show("gen")
try:
    raise e("exc", ValueError) from e("cause", None)
except ValueError: pass
show("raise")
lst[e("lo", 0):e("hi", 1):e("st", 1)]; show("slice")
t[e("a", 1):e("b", 2), e("c", 3)]; show("ext slice")
print(e("p1", "x"), e("p2", "y"), sep=e("sep", "-")); show("print")
(lambda a=e("ldef"): a)(); show("lambda")
x = e("rhs", 1); x += e("aug", 2); show("aug name")
t.q += e("v", 1); show("aug attr")
def kw(**k): return list(k)
print(kw(**e("d1", {"z": 1}), a=e("a"), **e("d2", {"b": 2}))); show("kw")
w = (e("w1", 1), (n := e("walrus", 5)), e("w2", n)); show("walrus")
match e("subject", 2):
    case 1: e("one")
    case v if e("guard", v == 2): e("two")
show("match")
with e("ctx", type("X", (), {"__enter__": lambda s: e("enter", 1), "__exit__": lambda s, *a: e("exit")})()) as lst[e("target", 0)]: e("with body")
show("with")
-e("neg", 1) + +e("pos", 1); ~e("inv", 1); show("unary")
print([*e("s1", [1]), e("m", 2), *e("s2", [3])]); show("star")
global_x: e("var ann") = e("var value"); show("annassign")
y: e("only ann"); show("annonly")
