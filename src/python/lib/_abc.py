"""Abstract base classes: virtual subclasses and abstract methods."""

_epoch = [0]


def abstractmethod(function):
    function.__isabstractmethod__ = True
    return function


class ABCMeta(type):
    def __new__(mcls, name, bases, namespace, /, **kwargs):
        cls = super().__new__(mcls, name, bases, namespace, **kwargs)
        abstract = {key for key, value in namespace.items() if getattr(value, "__isabstractmethod__", False)}
        for base in bases:
            for key in getattr(base, "__abstractmethods__", ()):
                if getattr(getattr(cls, key, None), "__isabstractmethod__", False):
                    abstract.add(key)
        cls.__abstractmethods__ = frozenset(abstract)
        cls._abc_registry = []
        cls._abc_known = {}
        return cls

    def __call__(cls, *args, **kwargs):
        missing = cls.__abstractmethods__
        if missing:
            plural = "" if len(missing) == 1 else "s"
            names = ", ".join(sorted(missing))
            raise TypeError(f"Can't instantiate abstract class {cls.__name__} with abstract method{plural} {names}")
        return super().__call__(*args, **kwargs)

    def register(cls, subclass):
        if not isinstance(subclass, type):
            raise TypeError("Can only register classes")
        if issubclass(subclass, cls):
            return subclass
        if issubclass(cls, subclass):
            raise RuntimeError("Refusing to create an inheritance cycle")
        cls._abc_registry.append(subclass)
        _epoch[0] += 1
        return subclass

    def __instancecheck__(cls, instance):
        actual = type(instance)
        return cls.__subclasscheck__(actual) or instance.__class__ is not actual and cls.__subclasscheck__(instance.__class__)

    def __subclasscheck__(cls, subclass):
        if not isinstance(subclass, type):
            raise TypeError("issubclass() arg 1 must be a class")
        answer, epoch = cls._abc_known.get(subclass, (False, -1))
        if answer or epoch == _epoch[0]:
            return answer
        answer = _decide(cls, subclass)
        cls._abc_known[subclass] = (answer, _epoch[0])
        return answer


def _decide(cls, subclass):
    hooked = cls.__subclasshook__(subclass)
    if hooked is not NotImplemented:
        return bool(hooked)
    if cls in subclass.__mro__:
        return True
    return any(issubclass(subclass, known) for known in cls._abc_registry) or any(
        issubclass(subclass, derived) for derived in type.__subclasses__(cls)
    )
