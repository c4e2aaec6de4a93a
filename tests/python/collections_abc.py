from collections.abc import *
from collections import abc, deque, OrderedDict, defaultdict, Counter, UserDict, UserList, ChainMap
import collections.abc
import collections

def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

kinds = (Hashable, Sized, Iterable, Iterator, Reversible, Container, Collection, Callable, Generator, Set, MutableSet, Mapping, MutableMapping, MappingView, KeysView, ItemsView, ValuesView, Sequence, MutableSequence, ByteString)
def gen(): yield
class It:
    def __iter__(self): return iter([1])
class Nx(It):
    def __next__(self): raise StopIteration
class Len:
    def __len__(self): return 0
class NoHash:
    __hash__ = None
class NoIter(It):
    __iter__ = None
class Eq:
    def __eq__(self, o): return True
for v in ([], (), "", b"", bytearray(), {}, set(), frozenset(), range(0), 5, None, 1.5, gen(), gen, len, int, It(), Nx(), Len(), NoHash(), NoIter(), Eq(), {}.keys(), {}.values(), {}.items(), iter([]), zip(), map(str, []), deque(), OrderedDict(), defaultdict(), Counter(), lambda: 0, [].append, "a".upper, UserDict(), UserList(), ChainMap(), object(), ..., type(int.__dict__), enumerate([]), reversed([])):
    print(type(v).__name__, [k.__name__ for k in kinds if isinstance(v, k)])
print(issubclass(list, Sequence), issubclass(dict, Mapping), issubclass(int, Hashable), issubclass(list, Hashable), issubclass(Sequence, Iterable), issubclass(MutableSequence, Sequence))
t(lambda: issubclass(5, Sized))
t(lambda: Sequence())
t(lambda: Sized())
t(lambda: MutableMapping())
class Part(Sequence):
    def __len__(self): return 3
t(Part)
class Seq(Sequence):
    def __init__(self, n): self.n = n
    def __len__(self): return self.n
    def __getitem__(self, i):
        if isinstance(i, slice): return [self[j] for j in range(*i.indices(self.n))]
        if i < 0: i += self.n
        if not 0 <= i < self.n: raise IndexError(i)
        return i * i
s = Seq(5)
print(list(s), 9 in s, 10 in s, s.index(16), s.count(4), list(reversed(s)), s[1:3], s[-1], len(s), isinstance(s, Reversible), max(s), sorted(s, reverse=True))
t(lambda: s.index(99))
class MSeq(MutableSequence):
    def __init__(self, *a): self.d = list(a)
    def __len__(self): return len(self.d)
    def __getitem__(self, i): return self.d[i]
    def __setitem__(self, i, v): self.d[i] = v
    def __delitem__(self, i): del self.d[i]
    def insert(self, i, v): self.d.insert(i, v)
    def __repr__(self): return f"MSeq{self.d}"
m = MSeq(1, 2)
m.append(3); m.extend([4, 5]); m.reverse(); m.remove(4); m += [9]; m.insert(0, 0)
print(m, m.pop(), m.pop(0), m, m.index(2), m.count(1), 3 in m, m.clear(), m)
t(m.pop)
class Map(Mapping):
    def __init__(self, **d): self.d = d
    def __getitem__(self, k): return self.d[k]
    def __iter__(self): return iter(self.d)
    def __len__(self): return len(self.d)
mp = Map(a=1, b=2)
print(mp["a"], mp.get("z"), mp.get("z", 0), "a" in mp, list(mp.keys()), list(mp.values()), list(mp.items()), mp == {"a": 1, "b": 2}, mp == Map(b=2, a=1), mp != {"a": 1}, dict(mp), {**mp}, len(mp.keys()), "a" in mp.keys(), 1 in mp.values(), ("a", 1) in mp.items(), sorted(mp.keys() & {"a"}), sorted(mp.keys() | {"z"}))
t(lambda: mp["zz"])
t(lambda: hash(mp))
def f(**k): return k
print(f(**mp))
class MMap(MutableMapping):
    def __init__(self): self.d = {}
    def __getitem__(self, k): return self.d[k]
    def __setitem__(self, k, v): self.d[k] = v
    def __delitem__(self, k): del self.d[k]
    def __iter__(self): return iter(self.d)
    def __len__(self): return len(self.d)
mm = MMap()
mm["a"] = 1; mm.update(b=2); mm.update([("c", 3)]); mm.update({"d": 4}); mm.setdefault("e", 5)
print(dict(mm), mm.pop("a"), mm.pop("zz", "none"), mm.popitem(), mm.setdefault("c"), len(mm), mm.clear(), len(mm))
t(lambda: mm.pop("zz"))
t(lambda: mm.popitem())
class S(Set):
    def __init__(self, it=()): self.l = list(dict.fromkeys(it))
    def __contains__(self, x): return x in self.l
    def __iter__(self): return iter(self.l)
    def __len__(self): return len(self.l)
    def __repr__(self): return f"S{self.l}"
a, b = S([1, 2, 3]), S([2, 3, 4])
print(a & b, a | b, a - b, a ^ b, a <= b, S([1]) < a, a == S([3, 2, 1]), a == {1, 2, 3}, a.isdisjoint(b), a >= S([1]), a & [1], a | {9}, {5} | a, {1, 7} - a, a != b)
class MS(MutableSet, S):
    def add(self, x):
        if x not in self.l: self.l.append(x)
    def discard(self, x):
        if x in self.l: self.l.remove(x)
ms = MS([1, 2])
ms.add(3); ms |= {4}; ms -= {1}; ms &= {2, 3}; ms ^= {3, 5}
print(ms, ms.pop(), ms.remove(5), ms)
t(lambda: ms.remove(99))
class Virtual: pass
Sequence.register(Virtual)
print(isinstance(Virtual(), Sequence), issubclass(Virtual, Iterable), isinstance(Virtual(), Mapping))
@Mapping.register
class Deco: pass
print(issubclass(Deco, Mapping), issubclass(Deco, Sized))
t(lambda: Sequence.register(5))
class G(Generator):
    def __init__(self): self.n = 0
    def send(self, v):
        self.n += 1
        if self.n > 3: raise StopIteration
        return self.n, v
    def throw(self, t, v=None, tb=None): raise t
g = G()
print(next(g), g.send("x"), list(g), g.close())
print(Sequence.__name__, Sequence.__module__, Callable[[int], str], Iterable[int], Mapping[str, int], collections.abc.Sized is Sized, abc is collections.abc, sorted(Sequence.__abstractmethods__))
class Cb:
    def __call__(self): pass
print(isinstance(Cb(), Callable), callable(Cb()), isinstance(Cb, Callable))
