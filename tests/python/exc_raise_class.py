class Wrong(Exception): pass
try:
    raise Wrong
except Wrong as e:
    print(repr(e), e.args)
raise NotImplementedError
