class A:
    print("body")
    x = 1
    y = [x for _ in range(2)]
