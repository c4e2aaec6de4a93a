def risky(n):
    try:
        return 1 / n
    except ZeroDivisionError as e:
        e.add_note("while dividing")
        raise
    else:
        print("never")
print(risky(4))
risky(0)
