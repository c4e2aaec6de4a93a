from dataclasses import dataclass, field, replace, asdict, astuple, fields
from typing import Optional, List, Dict, ClassVar, Tuple
from enum import Enum
from functools import total_ordering, cached_property
import math
class Side(Enum):
    LEFT = "left"
    RIGHT = "right"
    @property
    def other(self): return Side.RIGHT if self is Side.LEFT else Side.LEFT
@dataclass(frozen=True)
class Size:
    width: float
    depth: float
    height: float = 1.0
    def __post_init__(self):
        for f in fields(self):
            if getattr(self, f.name) <= 0: raise ValueError(f"{f.name} must be positive")
    @property
    def area(self): return self.width * self.depth
    def scaled(self, k): return replace(self, width=self.width * k, depth=self.depth * k)
    def __mul__(self, k): return Size(*(v * k for v in astuple(self)))
@dataclass
class Item:
    name: str
    size: Size
    side: Side = Side.LEFT
    tags: List[str] = field(default_factory=list)
    parent: Optional["Item"] = field(default=None, repr=False, compare=False)
    count: ClassVar[int] = 0
    _cache: Dict[str, float] = field(default_factory=dict, init=False, repr=False, compare=False)
    def __post_init__(self):
        type(self).count += 1
        self.tags = [*self.tags, self.name.lower()]
    def volume(self):
        if "v" not in self._cache: self._cache["v"] = self.size.area * self.size.height
        return self._cache["v"]
    def flip(self): self.side = self.side.other; return self
@dataclass
class Lamp(Item):
    watts: int = 40
    lit: bool = field(default=False, kw_only=True)
a = Item("Sofa", Size(2, 0.9))
b = Lamp("Lamp", Size(0.3, 0.3, 1.6), Side.RIGHT, ["light"], a, 60, lit=True)
print(a, b, sep="\n")
print(a.volume(), round(b.volume(), 3), Item.count, Lamp.count, b.parent.name, a.flip().side, a == Item("Sofa", Size(2, 0.9), Side.RIGHT), a == b, Size(1, 2) == Size(1.0, 2.0), hash(Size(1, 2)) == hash(Size(1, 2)), {Size(1, 1): "unit"}[Size(1, 1)], Size(1, 2).scaled(2), Size(1, 2) * 3)
for bad in (lambda: Size(0, 1), lambda: Size(1), lambda: replace(Size(1, 1), depth=-1), lambda: setattr(Size(1, 1), "width", 2), lambda: Lamp("x", Size(1, 1), lit=True, volts=5), lambda: Lamp("x", Size(1, 1), Side.LEFT, [], None, 1, True)):
    try: print(bad())
    except Exception as e: print(type(e).__name__, e)
d = asdict(b)
print(d, d["size"]["width"], astuple(b)[1])
c = replace(b, name="Spot", watts=10)
print(c, c.tags, Item.count, Lamp.count, [f.name for f in fields(Lamp)], [f.name for f in fields(Lamp) if f.kw_only])
@total_ordering
@dataclass
class Version:
    major: int
    minor: int = 0
    def __lt__(self, o): return (self.major, self.minor) < (o.major, o.minor)
    @classmethod
    def parse(cls, s): return cls(*map(int, s.split(".")))
vs = [Version.parse(s) for s in ("1.10", "1.9", "0.5", "2")]
print(sorted(vs), max(vs), Version(1) >= Version(0, 9), Version(1) <= Version(1), Version(3) > Version(2, 9))
@dataclass
class Circle:
    r: float
    @cached_property
    def area(self): print("computed", end=" "); return round(math.pi * self.r ** 2, 4)
    def __eq__(self, o): return isinstance(o, Circle) and math.isclose(self.r, o.r)
k = Circle(2)
print(k.area, k.area, k == Circle(2.0000000000001), k)
@dataclass(order=True)
class Task:
    sort_index: Tuple = field(init=False, repr=False)
    name: str
    priority: int = 5
    def __post_init__(self): self.sort_index = (-self.priority, self.name)
print(sorted([Task("b"), Task("a"), Task("z", 9)]), Task("a") < Task("b"))
@dataclass
class Graph:
    edges: Dict[str, List[str]] = field(default_factory=lambda: {"root": []})
    def add(self, a, b): self.edges.setdefault(a, []).append(b); return self
g, h = Graph(), Graph()
g.add("root", "x").add("x", "y")
print(g, h, g == h, h == Graph())
@dataclass
class Meta(type): pass
try: print(Meta.__name__)
except Exception as e: print(e)
class Plain:
    def __init__(self, a): self.a = a
@dataclass
class FromPlain(Plain):
    b: int = 2
    def __post_init__(self): super().__init__(self.b * 2)
print(FromPlain(5), FromPlain(5).a, vars(FromPlain()))
match b:
    case Lamp(name=n, size=Size(w, dp), lit=True): print("lamp", n, w, dp)
match a:
    case Lamp(): print("lamp?")
    case Item(n, Size(height=hh), Side.RIGHT): print("item", n, hh)
