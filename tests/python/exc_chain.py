try:
    int("twelve")
except ValueError as e:
    print("handling", e)
    raise RuntimeError("could not read") from e
