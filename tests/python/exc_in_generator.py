def gen():
    yield 1
    return_value = 10 / 0
    yield return_value
print(list(x for x in [1]))
total = 0
for v in gen():
    total += v
    print(total)
