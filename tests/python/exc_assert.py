x = [1, 2]
assert len(x) == 2, "never"
assert not x
