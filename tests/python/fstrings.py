x, y, name = 10, 3.14159, "wörld"
print(f"{x}", f"{x!r}", f"{name!r}", f"{name!a}", f"{name!s}", f"{x=}", f"{x = }", f"{x=!s}", f"{y=:.2f}", f"{x + 1 = }", f"{name=}", f"{name=!s}", f"{ x = :>5}")
print(f"{{}}", f"{{{x}}}", f"{x}{{}}", f"{{x}}", f"a{x}b{y:.1f}c")
print(f"{x:5}|{x:<5}|{x:^5}|{x:05}|{x:+}", f"{y:8.3f}|", f"{y:<8.3f}|", f"{name:>10}|", f"{name:_^11}|")
w, p = 10, 2
print(f"{y:{w}.{p}f}|", f"{y:>{w}}|", f"{y!r:>{w + 5}}|", f"{'a':{'<' if x else '>'}{w}}|", f"{x:{'0' * 1}{w}}|")
d = {"a": 1, "b": [1, 2]}
print(f"{d['a']} {d['b'][0]} {d}", f'{d["a"]}', f"{[i for i in range(3)]}", f"{ {1: 2}[1] }", f"{(lambda q: q * 2)(4)}", f"{x if x > 5 else y}", f"{x:d}", f"{(x, y)}", f"{x,}")
print(f"""{
    x
    + 1
}""", f'''{x
}''')
print("a" f"{x}" 'b' "c{x}" f"{'d'}")
print(rf"\n{x}\t", f"\n{x}".replace("\n", "N"), fr"{x}\{y:.0f}", f"\x41{x}\u00e9\N{BULLET}")
print(f"{3.0}", f"{1e16}", f"{True}", f"{None}", f"{...}", f"{print.__name__}", f"{int}", f"{type(x)}", f"{''}", f"{'':5}|")
print(f"{x!r:^10}|", f"{name!a:>14}|", f"{[1, 'a']!r}", f"{'q'!r}", f'{"it" + chr(39) + "s"!r}')
class A:
    def __repr__(self): return "A()"
    def __str__(self): return "an A"
    def __format__(self, spec): return "A:" + spec
a = A()
print(f"{a}", f"{a!r}", f"{a!s}", f"{a:x y}", f"{a=}", f"{a=:q}", f"{a=!s}", f"{a!r:>5}")
def f(v):
    print("eval", v)
    return v
print(f"{f(1)}{f(2):{f(5)}}{f(3)}|")
print(f"{x:>{f(6)}}|")
for spec in (".3s", "d"):
    try:
        print(f"{name:{spec}}")
    except ValueError as e:
        print("ValueError", e)
try:
    print(f"{undefined_name}")
except NameError as e:
    print(e)
print(f"{x:=5}|{x:=+5}|", f"{-x:=6}|", f"{(z := 5)}", z, f"{x:,}", f"{1000000:,}", f"{1234.5:,.1f}", f"{0.25:%}", f"{0.256:.1%}")
print(f"{'a' 'b'}", f"{'a' if '}' else 'b'}", f"{'{'}", f"{'}'}", f"{x!r}}}", f"{{{{{x}}}}}")
print(len(f"{x:1000}"), f"{x:x}{x:b}{x:o}{x:#x}{x:c}".encode())
