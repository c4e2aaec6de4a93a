π = 3; ñandú = "var"; 变量 = [1]
print(π, ñandú, 变量, "π" in globals())
class Été: âge = 5
print(Été.âge, Été.__name__, getattr(Été, "âge"), repr(Été))
ﬁ = 1
print(fi)
