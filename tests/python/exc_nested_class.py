class Outer:
    class Inner(LookupError): pass
def g():
    yield 1
    raise Outer.Inner("deep", 5)
for v in g():
    print(v)
