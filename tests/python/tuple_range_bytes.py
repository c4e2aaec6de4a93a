def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

p = (1, 2, 3, 2)
print(p.count(2), p.index(2), p.index(2, 2), p + (4,), p * 2, p[1:3], p[::-1], len(p), 2 in p, (1,), (), tuple("ab"), tuple([1]), tuple(), p == (1, 2, 3, 2), (1, 2) < (1, 3), (1,) < (1, 0), () < (1,), hash((1, 2)) == hash((1, 2)), max(p), sorted(p), 1 if () else 0, tuple(p) is p, p[:] is p, (1, [2]), ((),), 2 * (1,), (1, 2) != (2, 1), (1, "a", None, 2.5, (3,)))
t(lambda: p.index(9))
t(lambda: p.index(1, 1))
t(lambda: p + [1])
t(lambda: p.append)
t(lambda: hash((1, [])))
def st(): p[0] = 1
t(st)
def aug():
    q = ([1], 2)
    try:
        q[0] += [5]
    except TypeError as e:
        print(e, q)
aug()
print(hash(()), hash((1,)), hash((1, 2)), hash((1.5, 2)), hash((0, -1)), hash(((1, 2), 3)))
r = range(2, 20, 3)
print(r, list(r), len(r), r[0], r[-1], r[1:3], r[::-1], 5 in r, 6 in r, 5.0 in r, "a" in r, r.index(8), r.count(5), r.count(6), r.start, r.stop, r.step, list(reversed(r)), r == range(2, 18 + 1, 3), r == range(2, 20, 3), hash(r) == hash(range(2, 20, 3)), range(0) == range(5, 5), range(0, 3, 2) == range(0, 4, 2), bool(range(0)), bool(r), sum(r), max(r), min(r))
print(range(5), range(1, 5), range(0, 5, 1), range(5, 0, -2), list(range(5, 0, -2)), list(range(0, -5, -2)), list(range(5, 0)), list(range(-3)), range(10)[2:8:2], range(10)[-3:], range(10)[::-2], list(range(10)[7:2:-2]), range(0, 10 ** 20, 10 ** 19), list(range(10 ** 20, 10 ** 20 + 3)), 10 ** 20 in range(10 ** 21), range(10 ** 21)[10 ** 20], len(range(0, 10 ** 18, 7)), range(True), tuple(range(3)), range(3).__len__())
t(lambda: range(1, 10, 0))
t(lambda: range(1.5))
t(lambda: range(5)[5])
t(lambda: range(5)[-6])
t(lambda: range(5).index(7))
t(lambda: range(5) < range(6))
t(lambda: range("5"))
def sr(): range(5)[0] = 1
t(sr)
it = iter(range(3))
print(next(it), list(it), next(it, "end"), type(iter(range(3))).__name__)
b = b"Hello\x00\xff"
print(b, b[0], b[1:3], len(b), b + b"x", b * 2, b == b"Hello\x00\xff", list(b[:3]), b"a" in b"abc", 97 in b"abc", b"abc".upper(), b"ABC".lower(), b"a,b".split(b","), b" x ".strip(), b"abc".find(b"c"), b"abc".replace(b"b", b"XX"), b"-".join([b"a", b"b"]), b"abc".hex(), b"abc".hex("-"), bytes.fromhex("61 62"), bytes(3), bytes([1, 2]), bytes(range(3)), bytes(b"x"), bytes("é", "utf-8"), b"abc".startswith(b"a"), b"ab".decode(), b"\xc3\xa9".decode("utf-8"), b"\xe9".decode("latin-1"), b"\xff".decode("utf-8", "replace"), b"\xff".decode("ascii", "ignore"), b"a" < b"b", hash(b"a") == hash(b"a"), b"it's", b'"', b"'\"", b"\\\t\n\r\x7f", b"abc"[::-1], b"abc".isalpha(), b"12".isdigit(), b"a b".title(), b"abc".count(b"b"), b"abc".center(7, b"*"), b"5".zfill(3), bytes(), b"ab".partition(b"b"), b"abc".index(99), b"a\nb".splitlines(), b"abc".endswith((b"c",)), b"abc".removeprefix(b"a"))
t(lambda: b"\xff".decode())
t(lambda: b"a\xc3".decode())
t(lambda: b"\xe2\x28\xa1".decode())
t(lambda: b"a" + "a")
t(lambda: b"a" == "a")
t(lambda: "a" in b"a")
t(lambda: 256 in b"a")
t(lambda: b"abc"["a"])
t(lambda: bytes([300]))
t(lambda: b"a".join(["x"]))
t(lambda: bytes("a"))
t(lambda: b"a".split("a"))
t(lambda: b"abc".index(b"z"))
t(lambda: bytes.fromhex("6"))
def sb(): b"abc"[0] = 1
t(sb)
ba = bytearray(b"abc")
ba[0] = 120
ba.append(33); ba.extend(b"yz"); ba += b"!"; ba[1:2] = b"123"; del ba[-1]
print(ba, len(ba), bytes(ba), ba.pop(), ba, ba.decode(), ba == b"x123c!y", ba.upper(), ba[0], ba[:2], bytearray(2), bytearray(), list(bytearray(b"ab")), ba.find(b"c"), ba * 2, b"a" + bytearray(b"b"), bytearray(b"a") + b"b", type(b"a" + bytearray(b"b")).__name__, ba.copy() is ba, ba.remove(120), ba, ba.reverse(), ba, ba.insert(0, 65), ba, ba.clear(), ba)
t(lambda: bytearray([256]))
t(lambda: hash(bytearray()))
t(lambda: ba.append(256))
t(lambda: ba.append("a"))
t(lambda: ba.pop())
