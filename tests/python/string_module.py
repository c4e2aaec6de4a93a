import string
from string import Template, Formatter, capwords

def t(f):
    try:
        print(repr(f()))
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

print(string.ascii_letters, string.ascii_lowercase, string.ascii_uppercase, string.digits, string.hexdigits, string.octdigits, string.punctuation, repr(string.whitespace), repr(string.printable))
print(capwords("hello  world foo"), capwords("a-b-c", "-"), capwords(""), capwords("  x y  "), capwords("it's HERE"))
s = Template("$who likes ${what}s, $$5 and $who again")
print(s.substitute(who="tim", what="kung pao"), s.substitute({"who": "a", "what": "b"}), s.substitute({"who": "a", "what": "b"}, who="kw"), s.safe_substitute(who="x"), s.template, s.is_valid(), s.get_identifiers())
t(lambda: s.substitute(who="x"))
t(lambda: Template("$100").substitute())
t(lambda: Template("a\nb $ c").substitute())
t(lambda: Template("${x").substitute(x=1))
t(lambda: Template("$").substitute())
t(lambda: Template("abc\ndef\n${").substitute())
t(lambda: Template("$x").substitute(1, 2))
for text in ("$$", "$x$y", "${x}y", "$x_1", "$_a", "$x.y", "$é", "$1", "${1}", "x$", "", "$$$x", "${x}${y}", "$X"):
    tp = Template(text)
    print(repr(text), repr(tp.safe_substitute(x=1, y=2, X="up")), tp.is_valid())
print(Template("$a $b").safe_substitute({"a": None}), Template("$n").substitute(n=5), Template("$n").substitute({"n": [1]}))
class Pct(Template):
    delimiter = "%"
print(Pct("%x and $x %%").substitute(x=1), Pct("%{x}y").substitute(x=1))
f = Formatter()
print(f.format("{} {}", 1, 2), f.format("{1} {0}", 1, 2), f.format("{a} {b!r:>5}", a=1, b="x"), f.format("{0.real} {1[0]} {2[k]}", 3, [4], {"k": 5}), f.format("{{}} {:{}}", "a", 5) + "|", f.format("{:.{p}f}", 3.14159, p=2), f.format("plain"), f.vformat("{0} {k}", (1,), {"k": 2}), f.format("{:>{w}}", 1, w=4), f.format("{!s} {!a}", "é", "é"))
for call in (lambda: f.format("{} {0}", 1), lambda: f.format("{0} {}", 1), lambda: f.format("{}"), lambda: f.format("{x}"), lambda: f.format("{"), lambda: f.format("}"), lambda: f.format("{0!z}", 1), lambda: f.format("{0", 1), lambda: f.format("{5}", 1), lambda: f.format()):
    t(call)
print(list(f.parse("a{b!r:c}d{{e}}{}{f[0].g}")), f.get_field("0.real", (5,), {}), f.get_field("a[k][0]", (), {"a": {"k": [7]}}), f.convert_field(5, "r"), f.convert_field("x", None), f.get_value(0, [9], {}), f.get_value("k", [], {"k": 8}), f.format_field(3.14159, ".2f"))
class Default(Formatter):
    def get_value(self, key, args, kwargs):
        if isinstance(key, str):
            return kwargs.get(key, f"<{key}>")
        return super().get_value(key, args, kwargs)
    def format_field(self, value, spec):
        return spec[5:] if spec.startswith("const") else super().format_field(value, spec)
    def check_unused_args(self, used, args, kwargs):
        print("used", sorted(map(str, used)))
print(Default().format("{a} {b} {0} {1:const!}", "x", "y", a=1))
print("a" in string.ascii_letters, string.digits.index("7"), "".join(c for c in "a1b2!" if c not in string.punctuation + string.digits), string.ascii_uppercase[:5], dict(zip(string.ascii_lowercase, range(3))))
