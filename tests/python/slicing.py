def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

a = list(range(10))
for s in (slice(None), slice(2, 5), slice(None, 3), slice(-3, None), slice(None, None, 2), slice(None, None, -1), slice(8, 2, -2), slice(-100, 100), slice(5, 2), slice(2, 5, -1), slice(None, -1), slice(1, -1, 3), slice(100, None, -3), slice(None, -100, -4), slice(-1, -11, -1), slice(2 ** 70), slice(-2 ** 70, 2 ** 70, 2 ** 70)):
    print(s, a[s], tuple(a)[s], "0123456789"[s], range(10)[s], bytes(a)[s], s.indices(10))
t(lambda: a[::0])
t(lambda: "abc"[::0])
t(lambda: range(3)[::0])
t(lambda: a["a"])
t(lambda: a[None])
t(lambda: a[1.0:2])
t(lambda: a["1":])
t(lambda: a[10])
t(lambda: a[-11])
t(lambda: (1,)[5])
t(lambda: "abc"[3])
t(lambda: "abc"["a"])
t(lambda: (1,)["a"])
t(lambda: b"ab"[2])
t(lambda: range(3)[3])
t(lambda: range(3)["a"])
t(lambda: {}[1:2])
t(lambda: a[1, 2])
t(lambda: 5[0])
t(lambda: None[0])
t(lambda: a[2 ** 70])
def st(f):
    a = list(range(10))
    try:
        f(a)
        print(a)
    except Exception as e:
        print(type(e).__name__, e, sep=": ")
def f1(a): a[2:5] = [20, 30]
def f2(a): a[2:2] = "xy"
def f3(a): a[:] = []
def f4(a): a[::2] = [0] * 5
def f5(a): a[::2] = [0] * 4
def f6(a): a[5:2] = [1, 2]
def f7(a): a[::-1] = range(10)
def f8(a): a[1:3] = 5
def f9(a): a[::2] = 5
def f10(a): a[-3:] = (x * x for x in range(3))
def f11(a): a[20] = 1
def f12(a): a["a"] = 1
def f13(a): del a[2:5]
def f14(a): del a[::2]
def f15(a): del a[::-3]
def f16(a): del a[100]
def f17(a): del a[-1], a[0]
def f18(a): del a["x"]
def f19(a): a[2:8:3] = "ab"
def f20(a): a[3:1:-1] = "ab"
def f21(a): a[100:] = [1]
def f22(a): a[:] = a[::-1]
def f23(a): a[2:4] = a
def f24(a): a[1:1] = ()
def f25(a): del a[5:5]
def f26(a): a[8:2:-2] = [1, 2, 3]
def f27(a): a[1:2] = {"k": 1}
def f28(a): del a[9:0:-4]
def f29(a): a[0:0:2] = [1]
def f30(a): a[-100:3] = [7]
for f in (f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19, f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30):
    st(f)
class I:
    def __init__(self, v): self.v = v
    def __index__(self): return self.v
print(a[I(2)], a[I(1):I(7):I(2)], "abc"[I(-1)], (1, 2, 3)[I(0)], range(10)[I(3)], [0] * I(3), bin(I(5)), list(range(I(3))))
class S:
    def __getitem__(self, k): return k
    def __setitem__(self, k, v): print("set", k, v)
    def __delitem__(self, k): print("del", k)
s = S()
print(s[1], s[1:2], s[::], s[1:2, 3], s[...], s[()], s[1:, ::2], s[:], s["a":"b"], s[None])
s[1:2] = 3
del s[::2], s[0]
s[0], s[1:] = 1, 2
sl = slice(1, 2, 3)
print(sl.start, sl.stop, sl.step, sl == slice(1, 2, 3), sl != slice(1, 2), slice(5).start, slice(1, 2) < slice(1, 3), repr(slice("a", None)))
t(lambda: hash(slice(1)))
t(lambda: slice())
t(lambda: tuple.__getitem__((1,), 1))
def f():
    (1, 2)[0] = 3
t(f)
def f():
    "abc"[0] = "x"
t(f)
def f():
    del "abc"[0]
t(f)
def f():
    del range(3)[0]
t(f)
def f():
    None[0] = 1
t(f)
print(slice(1, None, 2).indices(6), slice(None, None, -1).indices(0), slice(-5, 5).indices(3))
t(lambda: slice(1).indices(-1))
