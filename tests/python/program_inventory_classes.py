class Validated:
    def __set_name__(self, owner, name): self.name = "_" + name
    def __get__(self, obj, cls=None): return self if obj is None else getattr(obj, self.name)
    def __set__(self, obj, value):
        self.check(value)
        setattr(obj, self.name, value)
class Positive(Validated):
    def check(self, v):
        if not isinstance(v, (int, float)): raise TypeError(f"{self.name[1:]} must be a number, not {type(v).__name__}")
        if v <= 0: raise ValueError(f"{self.name[1:]} must be positive, got {v}")
class NonEmpty(Validated):
    def check(self, v):
        if not v: raise ValueError(f"{self.name[1:]} is empty")
class Registry(type):
    kinds = {}
    def __new__(m, name, bases, ns, **kw):
        cls = super().__new__(m, name, bases, ns)
        if kw.get("register", True): m.kinds[name.lower()] = cls
        return cls
    def __init__(cls, name, bases, ns, **kw): super().__init__(name, bases, ns)
    def create(cls, kind, *a): return cls.kinds[kind](*a)
class Item(metaclass=Registry, register=False):
    name = NonEmpty()
    price = Positive()
    count = 0
    def __init__(self, name, price): self.name, self.price = name, price; type(self).count += 1
    def total(self, n=1): return round(self.price * n * (1 - self.discount(n)), 2)
    def discount(self, n): return 0
    def __str__(self): return f"{self.name} @ {self.price:.2f}"
    def __repr__(self): return f"{type(self).__name__}({self.name!r}, {self.price!r})"
    def __lt__(self, o): return (self.price, self.name) < (o.price, o.name)
class Bulk(Item):
    def discount(self, n): return 0.1 if n >= 10 else super().discount(n)
class Sale(Bulk):
    def discount(self, n): return min(super().discount(n) + 0.25, 0.3)
items = [Item("pen", 1.2), Bulk("nail", 0.05), Sale("paint", 20), Registry.create(Item, "bulk", "screw", 0.07)]
print(items, *items, sep=" | ")
print([i.total(10) for i in items], sorted(items), min(items), [i.name for i in sorted(items, reverse=True)], sorted(Registry.kinds), Item.count, Bulk.count, Sale.count, Item.name.name, [type(i).__mro__[1].__name__ for i in items])
for bad in (lambda: Item("", 1), lambda: Item("x", 0), lambda: Item("x", "free"), lambda: setattr(items[0], "price", -3), lambda: Registry.create(Item, "zzz"), lambda: Item("only name"), lambda: items[0] < 5):
    try: print(bad())
    except Exception as e: print(type(e).__name__, e)
print(items[0].price, vars(items[0]))
class Cart:
    def __init__(self): self.lines = {}
    def __iadd__(self, item): self.lines[item.name] = (item, self.lines.get(item.name, (item, 0))[1] + 1); return self
    def __isub__(self, item):
        n = self.lines[item.name][1] - 1
        if n: self.lines[item.name] = (item, n)
        else: del self.lines[item.name]
        return self
    def __len__(self): return sum(n for _, n in self.lines.values())
    def __bool__(self): return bool(self.lines)
    def __contains__(self, item): return getattr(item, "name", item) in self.lines
    def __getitem__(self, k): return self.lines[k][1]
    def __iter__(self):
        for item, n in self.lines.values(): yield item, n
    def __enter__(self): self.saved = dict(self.lines); return self
    def __exit__(self, t, v, tb):
        if t: self.lines = self.saved; print("rolled back:", v)
        return t is ValueError
    def __call__(self, **coupon): return round(sum(i.total(n) for i, n in self) * (1 - coupon.get("off", 0)), 2)
    def __format__(self, spec): return f"{self():{spec or '.2f'}}"
cart = Cart()
print(bool(cart), len(cart))
for _ in range(12): cart += items[1]
cart += items[2]
cart += items[0]; cart -= items[0]
print(len(cart), cart["nail"], items[0] in cart, "paint" in cart, cart(), cart(off=0.5), f"{cart}", f"{cart:>10.3f}", [(str(i), n) for i, n in cart])
with cart as c:
    c += items[0]
    raise ValueError("card declined")
print("pen" in cart)
try:
    with cart: raise KeyError("other")
except KeyError as e: print("left", e)
