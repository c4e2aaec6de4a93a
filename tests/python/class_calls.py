# A class reached through an attribute, and called: no receiver may slip in.
class D:
    def __init__(self, it=(), size=None): self.it, self.size = it, size
    def again(self): return self.__class__(self.it, 7)
    def one(self): return self.__class__([1])
    def named(self): return self.__class__(size=3)
    def none(self): return self.__class__()
    def through_type(self): return type(self)(1, 2)
    def __repr__(self): return f"D({self.it}, {self.size})"
class Holder:
    made = D
    class Inner:
        def __init__(self, *args, **kwargs): self.args = args, kwargs
h = Holder()
h.own = D
print(D().again(), D().one(), D().named(), D().none(), D().through_type(), Holder.made(1), h.made(1, 2), h.own(5), Holder.Inner(1, 2, k=3).args, h.Inner().args, Holder().Inner(*[1], **{"z": 2}).args)
for call in (lambda: h.made(1, 2, 3), lambda: Holder.made(zz=1), lambda: h.own(1, it=2)):
    try: call()
    except TypeError as e: print(e)
import collections, enum, dataclasses
print(collections.OrderedDict([(1, 2)]), collections.deque([1], 3), collections.Counter("aa"), dataclasses.field(default=1).default, D.__class__.__name__, [c(1) for c in (h.made, Holder.made)])
