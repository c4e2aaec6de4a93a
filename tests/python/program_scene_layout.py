# A room laid out the way layout programs are written: loops, lambdas, comprehensions, helper functions.
import math, random
from dataclasses import dataclass, field
random.seed(0)
@dataclass
class Obj:
    name: str
    w: float
    d: float
    h: float
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    turn: int = 1
    tags: set = field(default_factory=set)
    @property
    def size(self): return (self.d, self.w) if self.turn % 2 == 0 else (self.w, self.d)
    @property
    def min(self): return self.x - self.size[0] / 2, self.y - self.size[1] / 2
    @property
    def max(self): return self.x + self.size[0] / 2, self.y + self.size[1] / 2
    def overlaps(self, o):
        return all(min(a, c) - max(b, d) > 1e-9 for a, b, c, d in zip(self.max, self.min, o.max, o.min))
W, D = 6.0, 5.0
X_MAX, Y_MAX, X_MIN, Y_MIN = range(4)
table = Obj("Table", 1.6, 0.9, 0.75)
chairs = [Obj(f"Chair {i}", 0.45, 0.5, 0.9) for i in range(6)]
gap = 0.05
for i, chair in enumerate(chairs):
    side, k = divmod(i, 3)
    chair.x = table.x + (k - 1) * (table.w / 3)
    if side == 0:
        chair.y = table.max[1] + gap + chair.d / 2
        chair.turn = Y_MIN
    else:
        chair.y = table.min[1] - gap - chair.d / 2
        chair.turn = Y_MAX
for c in chairs: print(f"{c.name}: ({c.x:.3f}, {c.y:.3f}) turn {c.turn} min {tuple(round(v, 3) for v in c.min)}")
shelves = [Obj("Shelf", 0.9, 0.3, 2.0) for _ in range(4)]
walls = {X_MAX: lambda o, t: (W / 2 - o.d / 2, t), Y_MAX: lambda o, t: (t, D / 2 - o.d / 2), X_MIN: lambda o, t: (-W / 2 + o.d / 2, t), Y_MIN: lambda o, t: (t, -D / 2 + o.d / 2)}
for wall, shelf in zip(walls, shelves):
    shelf.turn = (wall + 2) % 4
    shelf.x, shelf.y = walls[wall](shelf, 0.5 * (-1) ** wall)
    shelf.tags |= {"wall", wall}
print([(s.x, s.y, s.turn, s.size) for s in shelves], sorted(map(str, shelves[0].tags)))
def ring(n, r, cx=0, cy=0):
    for k in range(n):
        a = 2 * math.pi * k / n
        yield round(cx + r * math.cos(a), 6) + 0.0, round(cy + r * math.sin(a), 6) + 0.0
plants = []
for x, y in ring(5, 2):
    p = Obj("Plant", 0.3, 0.3, 1.0, x, y)
    tries = 0
    while any(p.overlaps(o) for o in [table, *chairs, *shelves, *plants]) and tries < 20:
        p.x += random.uniform(-0.2, 0.2)
        p.y += random.uniform(-0.2, 0.2)
        tries += 1
    plants.append(p)
print([(round(p.x, 4), round(p.y, 4)) for p in plants])
books, x = [], -0.4
for width in [0.03, 0.05, 0.02] * 4:
    if x + width > 0.4: break
    b = Obj("Book", width, 0.2, random.choice([0.2, 0.25, 0.3]))
    b.x, x = x + width / 2, x + width + 0.001
    books.append(b)
print(len(books), [round(b.x, 4) for b in books], [b.h for b in books])
grid = [[Obj(f"Desk {r}{c}", 1, 0.6, 0.7, (c - 1) * 1.5, (r - 0.5) * 1.8) for c in range(3)] for r in range(2)]
for row in grid: print(*((d.name, d.x, d.y) for d in row))
flat = [d for row in grid for d in row]
pairs = [(a.name, b.name) for i, a in enumerate(flat) for b in flat[i + 1:] if math.dist((a.x, a.y), (b.x, b.y)) < 1.6]
print(pairs, max(flat, key=lambda d: (d.x, d.y)).name, sum(d.w * d.d for d in flat), {d.name[-1]: d.x for d in flat})
everything = {"table": table, **{f"chairs[{i}]": c for i, c in enumerate(chairs)}, **{f"shelves[{i}]": s for i, s in enumerate(shelves)}}
bad = [(a, b) for a in everything for b in everything if a < b and everything[a].overlaps(everything[b])]
print(bad, all(-W / 2 <= o.min[0] and o.max[0] <= W / 2 for o in everything.values()), table, sep="\n")
levels = [0.0]
for h in (0.4, 0.35, 0.3): levels.append(round(levels[-1] + h, 2))
print(levels, [round(i * 0.1, 2) for i in range(4)], math.degrees(math.atan2(1, 1)) == 45.0, [int(a / 90) % 4 for a in (0, 90, 180.0, 270, 359)])
