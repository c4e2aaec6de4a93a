def bad():
    yield 1
    raise StopIteration("leaks")
print(next(bad()))
print(list(bad()))
