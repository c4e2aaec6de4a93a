from enum import Enum, IntEnum, Flag, auto, unique
from functools import reduce
import operator, random
class Suit(Enum):
    CLUBS, DIAMONDS, HEARTS, SPADES = "CDHS"
    @property
    def red(self): return self in (Suit.DIAMONDS, Suit.HEARTS)
    def __lt__(self, o): return list(Suit).index(self) < list(Suit).index(o)
class Rank(IntEnum):
    TWO = 2
    THREE = auto()
    FOUR = auto()
    JACK = 11
    ACE = 14
deck = [(r, s) for s in Suit for r in Rank]
random.seed(3)
random.shuffle(deck)
print([f"{r.name.title()}{s.value}" for r, s in deck[:6]], max(deck)[0].name, sorted(deck)[0], sum(r for r, _ in deck), [s.name for s in Suit if s.red], Rank.ACE > Rank.JACK, Rank(3), Rank.TWO + Rank.THREE, Rank.JACK - 1)
class Light(Enum):
    RED = ("stop", 3)
    GREEN = ("go", 4)
    YELLOW = ("slow", 1)
    def __init__(self, action, seconds): self.action, self.seconds = action, seconds
    @property
    def next(self):
        members = list(type(self))
        return members[(members.index(self) + 1) % len(members)]
l, total = Light.RED, 0
for _ in range(5):
    print(l.name, l.action, end="; ")
    total += l.seconds
    l = l.next
print(total, Light(("go", 4)), Light["RED"].value[0])
class Perm(Flag):
    READ = auto()
    WRITE = auto()
    EXEC = auto()
    ALL = READ | WRITE | EXEC
    @classmethod
    def parse(cls, s): return reduce(operator.or_, (m for m, c in zip((cls.READ, cls.WRITE, cls.EXEC), "rwx") if c in s), cls(0))
    def short(self): return "".join(c if m in self else "-" for m, c in zip((Perm.READ, Perm.WRITE, Perm.EXEC), "rwx"))
p = Perm.parse("rx")
print(p, p.short(), Perm.WRITE in p, p | Perm.WRITE == Perm.ALL, (Perm.ALL & ~Perm.READ).short(), p ^ Perm.ALL, [m.name for m in p], Perm.parse(""), bool(Perm.parse("")), Perm.ALL.value, len(Perm))
class Shape(Enum):
    CIRCLE = "circle"
    SQUARE = "square"
    def area(self, x):
        match self:
            case Shape.CIRCLE: return round(3.14159 * x * x, 3)
            case Shape.SQUARE: return x * x
    @classmethod
    def _missing_(cls, v): return cls.__members__.get(str(v).upper())
print([s.area(2) for s in Shape], Shape("CIRCLE"), Shape("circle"), {s: s.area(1) for s in Shape})
try: Shape("hexagon")
except ValueError as e: print(e)
class Weekday(IntEnum):
    MON = 1; TUE = 2; WED = 3; THU = 4; FRI = 5; SAT = 6; SUN = 7
    @property
    def weekend(self): return self >= Weekday.SAT
    def plus(self, n): return Weekday((self - 1 + n) % 7 + 1)
print([d.name for d in Weekday if d.weekend], Weekday.SAT.plus(3).name, [d for d in range(1, 4)] == [Weekday.MON, Weekday.TUE, Weekday.WED], ["-"] * Weekday.TUE, f"{Weekday.WED}", repr(Weekday(4)), "%s %d" % (Weekday.MON, Weekday.MON), {Weekday.MON: "start"}[1], list(Weekday)[::3], Weekday.FRI in (5, 6), min(Weekday), Weekday["SUN"] - Weekday["MON"])
class Color(str, Enum):
    RED = "FF0000"
    BLUE = "0000FF"
    def rgb(self): return tuple(int(self[i:i + 2], 16) for i in (0, 2, 4))
    @classmethod
    def random(cls): return random.choice(list(cls))
print(Color.RED.rgb(), Color.BLUE == "0000FF", Color("FF0000").name, Color.RED.lower(), isinstance(Color.random(), Color), sorted(Color), "-".join(c.value for c in Color), Color.RED + "!", len(Color.RED), "FF" in Color.RED, Color.RED.startswith("FF"))
class Event(Enum):
    START = auto()
    STOP = auto()
handlers = {Event.START: lambda n: f"start {n}", Event.STOP: lambda n: f"stop {n}"}
print([handlers[e](i) for i, e in enumerate(Event)], Event.START in handlers, {e.name.lower(): e.value for e in Event}, [(e.name, e.value) for e in Event], dict(zip(Event, "ab")), Event.START is Event(1), Event.START == 1, [e for e in Event if e != Event.STOP], tuple(Event.__members__))
class Base(Enum):
    @classmethod
    def names(cls): return [m.name for m in cls]
    def describe(self): return f"{type(self).__name__}.{self.name}={self.value!r}"
class Dir(Base):
    N = (0, 1); E = (1, 0); S = (0, -1); W = (-1, 0)
    @property
    def left(self): return Dir((-self.value[1], self.value[0]))
    def step(self, pos, n=1): return pos[0] + self.value[0] * n, pos[1] + self.value[1] * n
pos, d = (0, 0), Dir.N
for c in "FFLFRFLLF":
    if c == "F": pos = d.step(pos)
    elif c == "L": d = d.left
    else: d = d.left.left.left
print(pos, d, Dir.names(), Dir.E.describe(), Dir.N.left.left is Dir.S)
Op = Enum("Op", {"ADD": "+", "MUL": "*"})
fn = {Op.ADD: operator.add, Op.MUL: operator.mul}
print([fn[Op(s)](3, 4) for s in "+*"], list(Op), Op.ADD.name)
