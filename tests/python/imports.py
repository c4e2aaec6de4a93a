import math, random as rnd
import collections.abc
import collections as c
from math import pi, sqrt as root
from collections import (deque, Counter as Ct,)
from itertools import *
from functools import reduce
import math as m2
print(math.floor(2.5), pi, root(16), rnd.Random is not None, c.OrderedDict.__name__, collections.abc.Sized.__name__, deque([1]), Ct("aa"), list(chain([1], [2])), reduce(max, [1, 5]), m2 is math, math.pi is pi)
def f():
    import string
    from operator import add
    return string.digits, add(1, 2)
print(f())
try: string
except NameError as e: print(e)
class C:
    import math
    from math import tau
    v = math.ceil(1.2)
print(C.v, C.math is math, C.tau == 2 * pi)
for bad in ("from math import nothing_here", "import collections.nope"):
    pass
try:
    from collections import nothing_here
except ImportError as e: print(type(e).__name__, str(e).split(" (")[0])
print(math.__name__, collections.abc.__name__, c.__name__, type(math).__name__, hasattr(math, "nope"), "sin" in dir(math), vars(math)["pi"] == pi)
try: math.nope
except AttributeError as e: print(e)
import math
math.custom = 5
print(math.custom, m2.custom)
if True:
    from enum import Enum
    import dataclasses, typing
print(Enum.__name__, dataclasses.dataclass.__name__, typing.List[int])
try:
    import copy, statistics
finally:
    print(copy.copy([1]), statistics.mean([1, 2, 3]))
