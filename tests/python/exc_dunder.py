class Money:
    def __init__(self, v): self.v = v
    def __add__(self, o):
        if not isinstance(o, Money): return NotImplemented
        return Money(self.v + o.v)
print((Money(1) + Money(2)).v)
print(sum([Money(1), Money(2)]).v)
