import math
class Vec:
    __slots__ = ("x", "y", "z")
    def __init__(self, x=0.0, y=0.0, z=0.0): self.x, self.y, self.z = x, y, z
    def __add__(self, o): return Vec(self.x + o.x, self.y + o.y, self.z + o.z)
    def __sub__(self, o): return Vec(self.x - o.x, self.y - o.y, self.z - o.z)
    def __mul__(self, k): return self.dot(k) if isinstance(k, Vec) else Vec(self.x * k, self.y * k, self.z * k)
    __rmul__ = __mul__
    def __truediv__(self, k): return self * (1 / k)
    def __neg__(self): return self * -1
    def __iter__(self): yield from (self.x, self.y, self.z)
    def __eq__(self, o): return tuple(self) == tuple(o)
    def __hash__(self): return hash(tuple(self))
    def __abs__(self): return math.hypot(*self)
    def __repr__(self): return "Vec({:g}, {:g}, {:g})".format(*self)
    def dot(self, o): return sum(a * b for a, b in zip(self, o))
    def cross(self, o): return Vec(self.y * o.z - self.z * o.y, self.z * o.x - self.x * o.z, self.x * o.y - self.y * o.x)
    def rotated(self, deg):
        a = math.radians(deg)
        return Vec(round(self.x * math.cos(a) - self.y * math.sin(a), 9) + 0.0, round(self.x * math.sin(a) + self.y * math.cos(a), 9) + 0.0, self.z)
a, b = Vec(1, 2, 3), Vec(4, 5, 6)
print(a + b, a - b, a * 2, 2 * a, a * b, a / 2, -a, abs(Vec(3, 4, 0)), a.cross(b), a == Vec(1, 2, 3), len({a, Vec(1, 2, 3)}), Vec(1, 0).rotated(90), [*a], max(a), sum([a, b], Vec()))
class Box:
    def __init__(self, c, s): self.c, self.s = c, s
    @property
    def min(self): return self.c - self.s * 0.5
    @property
    def max(self): return self.c + self.s * 0.5
    def overlap(self, o):
        v = 1.0
        for lo1, hi1, lo2, hi2 in zip(self.min, self.max, o.min, o.max):
            d = min(hi1, hi2) - max(lo1, lo2)
            if d <= 0: return 0.0
            v *= d
        return v
    def __contains__(self, p): return all(l <= v <= h for l, v, h in zip(self.min, p, self.max))
bed = Box(Vec(0, 0, 0.5), Vec(2, 1.6, 1))
table = Box(Vec(1, 0.8, 0.25), Vec(0.5, 0.5, 0.5))
print(bed.min, bed.max, bed.overlap(table), table.overlap(Box(Vec(9, 9, 9), Vec(1, 1, 1))), Vec(0.5, 0.5, 0.5) in bed, Vec(5, 0, 0) in bed)
chairs, n = [], 6
for i in range(n):
    ang = 2 * math.pi * i / n
    chairs.append((round(1.5 * math.cos(ang), 4) + 0.0, round(1.5 * math.sin(ang), 4) + 0.0))
print(chairs)
def shoelace(pts): return abs(sum(x1 * y2 - x2 * y1 for (x1, y1), (x2, y2) in zip(pts, pts[1:] + pts[:1]))) / 2
def hull(pts):
    pts = sorted(set(pts))
    def half(ps):
        out = []
        for p in ps:
            while len(out) > 1 and (out[-1][0] - out[-2][0]) * (p[1] - out[-2][1]) - (out[-1][1] - out[-2][1]) * (p[0] - out[-2][0]) <= 0: out.pop()
            out.append(p)
        return out[:-1]
    return half(pts) + half(pts[::-1])
print(shoelace([(0, 0), (4, 0), (4, 3), (0, 3)]), hull([(0, 0), (2, 1), (1, 1), (4, 0), (4, 4), (0, 4), (2, 2)]))
grid = {(x, y): abs(x) + abs(y) for x in range(-2, 3) for y in range(-2, 3)}
for y in range(2, -3, -1): print(" ".join(f"{grid[x, y]:2d}" for x in range(-2, 3)))
room = {"width": 5.0, "depth": 4.0}
items = [("sofa", 2.0, 0.9), ("desk", 1.2, 0.6), ("lamp", 0.3, 0.3)]
x = -room["width"] / 2
for name, w, d in sorted(items, key=lambda t: t[1] * t[2], reverse=True):
    print(f"{name:<5} x={x + w / 2:+.3f} y={room['depth'] / 2 - d / 2:+.3f} area={w * d:.2f}")
    x += w + 0.1
print(f"{x:.2f}", x <= room["width"] / 2, math.isclose(0.1 * 3, 0.3), round(2.5 * 0.1, 3), [round(i * 0.1, 1) for i in range(5)], [i / 10 for i in range(5)], sum(i * 0.1 for i in range(11)))
