# Twelve digits only: the last one or two may differ between libraries.
import math
xs = [0.1, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 7.25, 10.0, 100.5, 1e-5, 1234.5678, -0.3, -1.7, -20.0]
def g(f, x):
    try:
        return "%.12g" % f(x)
    except (ValueError, OverflowError) as e:
        return str(e)
for name in ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "exp", "expm1", "exp2", "log", "log2", "log10", "log1p", "sqrt", "cbrt", "erf", "erfc", "gamma", "lgamma", "degrees", "radians"):
    print(name, *[g(getattr(math, name), x) for x in xs])
for y in (-2.0, -0.5, 0.3, 1.0, 5.0):
    print(*["%.12g" % math.atan2(y, x) for x in (-3.0, -0.1, 0.2, 1.0, 4.0)], *["%.12g" % math.hypot(x, y) for x in (-3.0, 0.2)])
    print(*["%.12g" % math.pow(x, y) for x in (0.3, 1.7, 12.0)], *["%.12g" % (x ** y) for x in (0.3, 1.7, 12.0)], *["%.12g" % math.log(x, 3 + abs(y)) for x in (0.3, 1.7, 12.0)])
print("%.12g %.12g %.12g" % (math.sin(1e6), math.cos(1e15), math.tan(math.pi / 4)), "%.12g" % math.exp(1), "%.12g" % math.log(10 ** 400), "%.12g" % math.log2(3 ** 500), "%.12g" % math.log10(7 ** 300), "%.12g" % (math.e ** math.pi), "%.10g" % math.dist((1, 2, 3), (4, 6, 8.5)))
print(round(math.sin(math.pi), 10), round(math.cos(math.pi / 2), 10), round(math.sin(math.radians(30)), 12), round(math.cos(math.radians(60)), 12), round(math.degrees(math.atan2(1, 1)), 10), round(math.tan(math.radians(45)), 12))
angle = [round(math.cos(2 * math.pi * i / 8), 9) + 0.0 for i in range(8)]
print(angle)
