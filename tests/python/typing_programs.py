from typing import Any, Callable, Dict, Generic, Iterable, Iterator, List, Mapping, NamedTuple, Optional, Protocol, Sequence, Set, Tuple, Type, TypeVar, Union, cast, overload, runtime_checkable, Literal, Final, ClassVar, TypedDict, NewType, TYPE_CHECKING
from collections.abc import Callable as Fn
from dataclasses import dataclass, field
if TYPE_CHECKING:
    from nowhere import Nothing
T = TypeVar("T")
K = TypeVar("K")
V = TypeVar("V", bound="Comparable")
Number = Union[int, float]
Vec3 = Tuple[float, float, float]
ObjId = NewType("ObjId", int)
Mode = Literal["fast", "exact"]
LIMIT: Final[int] = 3
class Comparable(Protocol):
    def __lt__(self, other: Any) -> bool: ...
@runtime_checkable
class HasArea(Protocol):
    @property
    def area(self) -> float: ...
class Point(NamedTuple):
    x: float
    y: float = 0.0
    label: Optional[str] = None
    @property
    def norm(self) -> float: return (self.x ** 2 + self.y ** 2) ** 0.5
    def moved(self, dx: Number = 0, dy: Number = 0) -> "Point": return self._replace(x=self.x + dx, y=self.y + dy)
class Stack(Generic[T]):
    limit: ClassVar[int] = LIMIT
    def __init__(self, items: Iterable[T] = ()) -> None: self._items: List[T] = list(items)
    def push(self, item: T) -> "Stack[T]":
        if len(self._items) >= self.limit: raise OverflowError("full")
        self._items.append(item)
        return self
    def pop(self) -> T: return self._items.pop()
    def __iter__(self) -> Iterator[T]: return reversed(self._items)
    def __len__(self) -> int: return len(self._items)
class Cache(Generic[K, T]):
    def __init__(self, make: Callable[[K], T]): self.make, self.d = make, cast(Dict[K, T], {})
    def __getitem__(self, k: K) -> T:
        if k not in self.d: self.d[k] = self.make(k)
        return self.d[k]
class Opts(TypedDict, total=False):
    mode: Mode
    size: int
@dataclass
class Shelf(Generic[T]):
    items: List[T] = field(default_factory=list)
    at: Vec3 = (0.0, 0.0, 0.0)
    cb: Optional[Callable[[T], str]] = None
@overload
def scale(v: int) -> int: ...
@overload
def scale(v: float) -> float: ...
def scale(v): return v * 2
def largest(xs: Sequence[V], key: Optional[Callable[[V], Any]] = None) -> Optional[V]: return max(xs, key=key) if xs else None
def build(cls: Type[T], *args: Any, **kw: Any) -> T: return cls(*args, **kw)
def merge(*ms: Mapping[K, V]) -> Dict[K, V]: return {k: v for m in ms for k, v in m.items()}
def apply(f: Fn[[int], int], n: int | None = None) -> list[int]: return [f(i) for i in range(n or 2)]
p = Point(3, 4)
s: Stack[int] = Stack([1])
s.push(2).push(3)
print(p, p.norm, p.moved(dy=1), Point(1).label, p._asdict(), list(s), len(s), s.pop(), Cache(len)["abc"], Stack[str](["a"]).pop(), scale(2), scale(1.5), largest([3, 1]), largest([]), largest(["a", "bbb"], key=len), build(Point, 1, y=2), merge({"a": 1}, {"b": 2}), apply(lambda v: v * v, 4), ObjId(5) + 1, Opts(mode="fast"), Shelf([1]), Shelf[str](at=(1, 2, 3)).at)
try: s.push(9).push(9).push(9)
except OverflowError as e: print(e)
class Rect:
    def __init__(self, w, h): self.w, self.h = w, h
    @property
    def area(self): return self.w * self.h
print(isinstance(Rect(1, 2), HasArea), isinstance(5, HasArea), isinstance(p, tuple), isinstance([1], Sequence), isinstance({}, Mapping), isinstance(len, Callable), Number, Vec3, Mode, Optional[Point], List[Stack[int]], Dict[str, Callable[..., T]], Stack[int], Shelf.__doc__)
def deco(f: Callable[..., T]) -> Callable[..., T]:
    def w(*a: Any, **k: Any) -> T: return f(*a, **k)
    return w
@deco
def g(x: "NotDefined", y: Set["AlsoNot"] = frozenset()) -> None: return x
print(g(5), apply.__annotations__, scale.__name__)
class Visitor(Generic[T]):
    def visit(self, n: Any) -> T: return getattr(self, f"visit_{type(n).__name__}", self.default)(n)
    def default(self, n: Any) -> T: raise TypeError(f"no visitor for {type(n).__name__}")
class Show(Visitor[str]):
    def visit_int(self, n: int) -> str: return f"int:{n}"
    def visit_list(self, n: list) -> str: return "[" + " ".join(map(self.visit, n)) + "]"
print(Show().visit([1, [2, 3]]), Show.__orig_bases__, Visitor.__parameters__)
try: Show().visit({})
except TypeError as e: print(e)
