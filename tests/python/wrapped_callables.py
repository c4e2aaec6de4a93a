"""What class methods, static methods, super objects and members of classes show of what they are around."""


class Base:
    "base"

    @classmethod
    def made(cls, x=1):
        "makes"
        return cls.__name__, x

    @staticmethod
    def plain(x):
        "plain"
        return x


for name in "made", "plain":
    wrapper = Base.__dict__[name]
    print(type(wrapper).__name__, wrapper.__name__, wrapper.__qualname__, wrapper.__doc__, wrapper.__wrapped__ is wrapper.__func__)
print(Base.__dict__["plain"](5), classmethod(len), staticmethod(len))
print(str.upper, int.__add__, int.real, dict.__init__)
print(super(Base))


class Slot:
    __slots__ = {"a": "the first"}


slot = Slot()
slot.a = 1
print(Slot.a, Slot.a.__name__, Slot.a.__objclass__, type(Slot.a).__name__, Slot.a.__get__(slot), "a" in vars(Slot))
Slot.a.__set__(slot, 2)
print(slot.a)
del slot.a


def attempt(action):
    try:
        print(action())
    except Exception as error:
        print(type(error).__name__, error)


class Broken:
    def __set_name__(self, owner, name):
        raise ValueError("no")


def broken_class():
    class Owner:
        field = Broken()


attempt(lambda: slot.a)
attempt(lambda: Slot.a.__get__(5))
attempt(lambda: delattr(slot, "a"))
attempt(lambda: str.upper(1))
attempt(lambda: str.upper())
attempt(lambda: int.__add__("a", 1))
attempt(lambda: list.append(5, 1))
attempt(lambda: "a".__add__())
attempt(lambda: dict.fromkeys(5))
attempt(lambda: int.from_bytes("a", "big"))
attempt(lambda: object.__new__(int))
attempt(lambda: int.__new__(str))
attempt(lambda: super(Base).made)
attempt(lambda: setattr(Base, "__name__", 5))
attempt(lambda: setattr(Base, "__dict__", {}))
attempt(lambda: setattr(Base(), "__class__", 5))
attempt(lambda: type("X", [], {}))
attempt(lambda: classmethod())
attempt(lambda: setattr(slice(1), "start", 2))
attempt(lambda: (lambda a=1: 0)(1, 2))
attempt(lambda: Exception(a=1))
attempt(broken_class)
