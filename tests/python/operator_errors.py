# Every TypeError message for a bad operation.
count = 0
def t(f):
    global count
    count += 1
    try:
        print(count, f())
    except TypeError as e:
        print(count, e)

def f0(): return "f0"
class E: pass
for call in (
    lambda: [1] + (2,), lambda: (1,) + [2], lambda: [1] + 1, lambda: "a" * "b", lambda: "a" * 1.5, lambda: [1] < 2, lambda: [1] < (1,), lambda: None < None, lambda: 1 < "a", lambda: "a" >= 1, lambda: {} > {}, lambda: object() < object(), lambda: 1 @ 2, lambda: [] @ [], lambda: "a" - "b", lambda: "a" / 2, lambda: -[], lambda: [1, 2] - [1], lambda: (1,) * (2,), lambda: int + 1, lambda: len + 1, lambda: f0 + 1, lambda: (lambda: 0) * 2, lambda: None + 1, lambda: {} + {}, lambda: 1 + [1], lambda: 1.5 + [], lambda: b"a" + "a", lambda: "a" + b"a", lambda: [][0:1] + "a", lambda: range(3) + range(2), lambda: 3 * None, lambda: int < int, lambda: [None, 1] < [None, "a"], lambda: (1, 2) < (1, "a"), lambda: E() + 1, lambda: 1 + E(), lambda: E() < 1, lambda: E() @ 1, lambda: E() ** 2, lambda: pow(E(), 2, 3), lambda: -E(), lambda: ~E(), lambda: E()[0], lambda: E[0], lambda: int[0], lambda: len[0], lambda: f0[0], lambda: len(E()), lambda: iter(E()), lambda: [*E()], lambda: 1 in E(), lambda: abs(E()), lambda: round(E()), lambda: int(E()), lambda: float(E()), lambda: complex(E()), lambda: [1][E()], lambda: range(E()), lambda: divmod(E(), 1), lambda: E() // 1, lambda: E() >> 1, lambda: E() & 1,
):
    t(call)
def aug(op):
    v = E()
    w = [1]
    if op == 0: v += 1
    if op == 1: v -= 1
    if op == 2: w += 5
    if op == 3: w -= [1]
    if op == 4: v **= 2
    if op == 5: v @= 2
    if op == 6: v //= 2
    if op == 7: w *= "a"
    if op == 8: v <<= 2
    if op == 9: v %= 2
    if op == 10:
        del v[0]
    if op == 11: v[0] = 1
    if op == 12: v[0] += 1
    if op == 13: del w.x
    if op == 14: v()
for i in range(15):
    try:
        aug(i)
    except (TypeError, AttributeError) as e:
        print(type(e).__name__, e)
