def fib(n):
    return n if n < 2 else fib(n - 1) + fib(n - 2)


def place(x, y, gap=0.1, *, scale=1.0):
    return (x + gap) * scale, (y - gap) * scale


acc = 0.0
for k in range(60000):
    a, b = place(k, k + 1, scale=0.5)
    acc += a - b
print(fib(22), acc)
