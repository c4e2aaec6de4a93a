print("one")
raise ExceptionGroup("several", [ValueError("x"), TypeError("y")])
