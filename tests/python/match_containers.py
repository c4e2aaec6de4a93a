from collections import deque, UserList, UserDict, OrderedDict, defaultdict, ChainMap, Counter, namedtuple
from collections.abc import Sequence, Mapping
class Seq(Sequence):
    def __len__(self): return 2
    def __getitem__(self, i): return [10, 20][i]
class Map(Mapping):
    def __len__(self): return 1
    def __iter__(self): return iter("k")
    def __getitem__(self, k): return {"k": "v"}[k]
class NotSeq:
    def __len__(self): return 2
    def __getitem__(self, i): return [1, 2][i]
def m(v):
    match v:
        case [a, b]: return f"pair {a} {b}"
        case [*all]: return f"seq {all}"
        case {"k": v, **rest}: return f"k={v} {rest}"
        case {}: return "mapping"
        case _: return "other"
for v in (deque([1, 2]), deque("abc"), UserList([3, 4]), Seq(), Map(), UserDict(k=1, z=2), OrderedDict(k=5), defaultdict(int), ChainMap({"k": 1}, {"q": 2}), Counter("k"), NotSeq(), namedtuple("P", "a b")(1, 2), range(2)):
    print(type(v).__name__, m(v))
