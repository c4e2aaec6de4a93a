def place(obj, x, y, *, facing): return obj, x, y, facing
print(place("bed", 1, 2, facing="Y"))
print(place("bed", 1, facing="Y"))
