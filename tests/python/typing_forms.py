from typing import *
import typing

T = TypeVar("T")
K = TypeVar("K", bound=int)
C = TypeVar("C", int, str)
class Box(Generic[T]):
    def __init__(self, v: T = None): self.v = v
    def get(self) -> T: return self.v
class Pair(Generic[T, K]): pass
class IntBox(Box[int]): pass
class Sized2(Protocol):
    def size(self) -> int: ...
@runtime_checkable
class Named(Protocol):
    name: str
    def hello(self): ...
@runtime_checkable
class CanRun(Protocol):
    def run(self): ...
class Runner:
    def run(self): return "ran"
class Thing:
    name = "thing"
    def hello(self): return "hi"
def show(f):
    try:
        print(repr(f()))
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

for f in (lambda: List[5], lambda: List[int, str], lambda: List[()], lambda: List["X"], lambda: Dict[int], lambda: Dict[str, int], lambda: Optional[int], lambda: Optional[1, 2], lambda: Optional[None], lambda: Union[int], lambda: Union[int, str, int], lambda: Union[()], lambda: Union[int, None], lambda: Union[int, str, None], lambda: Union[int, Union[str, float]], lambda: Union[int, Optional[str]], lambda: Union, lambda: Optional,
    lambda: Tuple[()], lambda: Tuple[int, ...], lambda: Tuple, lambda: Tuple[int, str], lambda: Callable, lambda: Callable[[int, str], bool], lambda: Callable[..., int], lambda: Callable[[], None], lambda: Callable[int], lambda: Callable[[int], "X"], lambda: Literal[1, "a", None, True], lambda: Literal[1, 1], lambda: Final[int], lambda: ClassVar[int], lambda: ClassVar, lambda: Final, lambda: Any, lambda: Any(), lambda: NoReturn, lambda: T, lambda: K, lambda: C,
    lambda: TypeVar("S", int), lambda: TypeVar("X", covariant=True), lambda: TypeVar("X", contravariant=True), lambda: TypeVar("X", covariant=True, contravariant=True), lambda: TypeVar("X", int, str, bound=int), lambda: Box, lambda: Box[int], lambda: Box[int, str], lambda: Box[T], lambda: Box[T][int], lambda: Pair[int, T][str], lambda: Pair[int], lambda: List[T][int], lambda: Dict[T, K][int, str], lambda: Dict[K, T].__parameters__, lambda: Box[int](3).v, lambda: Box[int].__origin__, lambda: Box.__parameters__, lambda: Box[int].__args__, lambda: IntBox(4).get(), lambda: IntBox[int],
    lambda: List, lambda: List(), lambda: List[int](), lambda: isinstance([], List), lambda: isinstance([], List[int]), lambda: isinstance(5, Union[int, str]), lambda: isinstance(5, Optional[str]), lambda: isinstance(5, Any), lambda: isinstance({}, Mapping), lambda: isinstance(5, Callable), lambda: isinstance(len, Callable), lambda: issubclass(list, List), lambda: isinstance([], Iterable), lambda: isinstance("a", Sequence), lambda: isinstance({1}, AbstractSet), lambda: isinstance(5, Hashable),
    lambda: Sized2(), lambda: isinstance(5, Sized2), lambda: isinstance(5, Named), lambda: isinstance(Thing(), Named), lambda: isinstance(Runner(), CanRun), lambda: issubclass(Runner, CanRun), lambda: issubclass(int, CanRun), lambda: issubclass(Thing, Named), lambda: runtime_checkable(Thing),
    lambda: cast(int, "a"), lambda: NewType("UserId", int), lambda: NewType("UserId", int)(5), lambda: Annotated[int, "m", 5], lambda: Annotated[int], lambda: Annotated[int, 1].__metadata__, lambda: Annotated[Annotated[int, 1], 2], lambda: get_origin(List[int]), lambda: get_args(Dict[str, int]), lambda: get_origin(Union[int, str]), lambda: get_origin(5), lambda: get_args(Callable[[int], str]), lambda: get_args(Callable[..., str]), lambda: get_args(Optional[int]), lambda: get_origin(list[int]), lambda: get_args(list[int]), lambda: get_origin(Literal[1]), lambda: get_args(Literal[1, "b"]), lambda: get_origin(Annotated[int, 1]), lambda: get_args(Annotated[int, 1]), lambda: get_origin(Box[int]), lambda: get_origin(Box), lambda: get_args(int), lambda: get_origin(Generic[T]),
    lambda: Type[int], lambda: Iterable[int], lambda: Iterator, lambda: Mapping[str, int], lambda: Sequence[float], lambda: Set[int], lambda: FrozenSet[int], lambda: DefaultDict[str, int], lambda: Deque[int], lambda: Counter[str], lambda: OrderedDict[str, int], lambda: Generator[int, None, str], lambda: Awaitable[int], lambda: Text, lambda: AnyStr, lambda: Hashable, lambda: isinstance(5, SupportsInt), lambda: isinstance("a", SupportsInt), lambda: isinstance(1.5, SupportsFloat), lambda: isinstance(-2, SupportsAbs), lambda: Self, lambda: LiteralString, lambda: Never, lambda: ParamSpec("P"), lambda: TypeGuard[int], lambda: Required[int], lambda: TypeVarTuple("Ts") if False else "Ts",
    lambda: int | List[int], lambda: List[int] | None, lambda: List[int] | Dict[str, int], lambda: Optional[List["N"]], lambda: List[int] == List[int], lambda: hash(List[int]) == hash(List[int]), lambda: Union[int, str] == Union[str, int], lambda: List[Union[int, str]], lambda: List[list[int]], lambda: List[Callable[[int], str]], lambda: List[None], lambda: List[...], lambda: Generic, lambda: Generic[int], lambda: Generic[T, T], lambda: Generic[T], lambda: Protocol, lambda: Protocol[T], lambda: TYPE_CHECKING, lambda: ForwardRef("X"), lambda: List[int].__module__, lambda: List.__origin__, lambda: List._name, lambda: Box[int].foo, lambda: Box[int].__name__, lambda: List.__name__, lambda: Union[int, "N"], lambda: Dict[str, Any], lambda: Dict[str, List[int]][int], lambda: List[int][str], lambda: Tuple[T, ...][int], lambda: Callable[[T], K][int, str], lambda: Callable[[T], T].__parameters__, lambda: Type[T], lambda: assert_type(5, int), lambda: assert_never(5), lambda: is_typeddict(5), lambda: List[ClassVar], lambda: List[Generic], lambda: typing.nothing_here, lambda: Union(), lambda: Optional(), lambda: TypeVar("T2").__name__, lambda: K.__bound__, lambda: C.__constraints__):
    show(f)
def mro():
    class L(List[int]): pass
    class D(Dict[str, T], Generic[T]): pass
    class M(Mapping[str, int]):
        def __getitem__(self, k): return 1
        def __len__(self): return 1
        def __iter__(self): return iter("k")
    print([c.__name__ for c in L.__mro__], L([1, 2]), D[int], D.__parameters__, dict(M()), isinstance(M(), Mapping), [c.__name__ for c in Box.__mro__], Box.__orig_bases__, IntBox.__orig_bases__, [c.__name__ for c in IntBox.__mro__])
mro()
def bad1():
    class X(Generic): pass
def bad2():
    class X(Union[int, str]): pass
def bad3():
    class X(T): pass
def bad4():
    class X(Generic[T], Box[K]): pass
def bad5():
    class X(NewType("U", int)): pass
def bad6():
    class X(Runner, Protocol): pass
for f in (bad1, bad4, bad5, bad6):
    show(f)
class Employee(NamedTuple):
    """An employee."""
    name: str
    id: int = 3
    def hi(self): return f"hi {self.name}"
    @property
    def double(self): return self.id * 2
e = Employee("Al")
print(e, e.hi(), e.double, Employee._fields, Employee._field_defaults, Employee.__annotations__, e == ("Al", 3), Employee.__doc__, e._replace(id=9), e._asdict(), isinstance(e, tuple), Employee.__mro__[1].__name__)
for f in (lambda: Employee(), lambda: Employee(1, 2, 3), lambda: Employee(nme=1)):
    show(f)
def nt1():
    class X(NamedTuple):
        a: int = 1
        b: int
def nt2():
    class X(NamedTuple):
        a: int
        def _replace(self): pass
for f in (nt1, nt2, lambda: NamedTuple("P", [("x", int), ("y", int)])(1, 2), lambda: NamedTuple("P", x=int, y=str)(1, "b")):
    show(f)
class Movie(TypedDict):
    title: str
    year: int
class Sequel(Movie, total=False):
    number: int
    studio: Required[str]
print(Movie(title="A", year=1), type(Movie(title="A")).__name__, Movie.__annotations__, sorted(Sequel.__annotations__), sorted(Sequel.__required_keys__), sorted(Sequel.__optional_keys__), Movie.__total__, Sequel.__total__, is_typeddict(Movie), TypedDict("P", {"x": int})(x=1), Movie({"title": "q"}))
show(lambda: isinstance({}, Movie))
@overload
def f(x: int) -> int: ...
@overload
def f(x: str) -> str: ...
def f(x): return x
print(f(1), f("a"), final(Runner) is Runner, Runner.__final__)
def ann(a: int, b: Optional[str] = None, *c: "int", d: List[int], **e: Any) -> None: pass
print(get_type_hints(ann))
class H:
    a: int
    b: "str"
    c: ClassVar[int] = 1
class H2(H):
    d: Optional["H"] = None
    e: Annotated[int, "meta"] = 1
print(get_type_hints(H2), get_type_hints(H2, include_extras=True)["e"])
show(lambda: get_type_hints(5))
class Stack(Generic[T]):
    def __init__(self) -> None: self.items: List[T] = []
    def push(self, x: T) -> None: self.items.append(x)
    def pop(self) -> T: return self.items.pop()
s: Stack[int] = Stack[int]()
s.push(1)
s.push(2)
print(s.pop(), s.items, s.__orig_class__)
x: Final = 5
y: Dict[str, List[Tuple[int, ...]]] = {}
print(x, y, list[int], dict[str, list[int]], int | None, int | str | None, tuple[int, ...], list["x"], type[int], isinstance(5, int | str), isinstance(None, int | None), (int | str) == (str | int), (int | str).__args__, list[int].__origin__, list[int] == list[int], list[int]([1, 2]), set[int] | None, issubclass(int, int | str))
for f in (lambda: isinstance([], list[int]), lambda: int | 5, lambda: list[int][str], lambda: issubclass(list, list[int]), lambda: int[str]):
    show(f)
