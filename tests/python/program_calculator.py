class Token:
    def __init__(self, kind, value): self.kind, self.value = kind, value
    def __repr__(self): return f"{self.kind}:{self.value}"
def tokenize(s):
    i = 0
    while i < len(s):
        ch = s[i]
        if ch.isspace():
            i += 1
        elif ch.isdigit() or ch == ".":
            j = i
            while j < len(s) and (s[j].isdigit() or s[j] == "."): j += 1
            yield Token("num", float(s[i:j]) if "." in s[i:j] else int(s[i:j]))
            i = j
        elif ch.isalpha():
            j = i
            while j < len(s) and s[j].isalnum(): j += 1
            yield Token("name", s[i:j])
            i = j
        elif ch in "+-*/^()=,":
            yield Token("op", ch)
            i += 1
        else:
            raise SyntaxError(f"unexpected {ch!r} at {i}")
    yield Token("end", None)
class Parser:
    def __init__(self, env): self.env = env
    def parse(self, text):
        self.toks = list(tokenize(text))
        self.pos = 0
        v = self.assign()
        if self.peek().kind != "end": raise SyntaxError(f"trailing {self.peek()}")
        return v
    def peek(self): return self.toks[self.pos]
    def take(self, value=None):
        t = self.peek()
        if value is not None and t.value != value: raise SyntaxError(f"expected {value!r}, found {t}")
        self.pos += 1
        return t
    def assign(self):
        if self.peek().kind == "name" and self.toks[self.pos + 1].value == "=":
            name = self.take().value
            self.take("=")
            self.env[name] = v = self.assign()
            return v
        return self.sum()
    def sum(self):
        v = self.product()
        while self.peek().value in ("+", "-"):
            v = v + self.product() if self.take().value == "+" else v - self.product()
        return v
    def product(self):
        v = self.unary()
        while self.peek().value in ("*", "/"):
            if self.take().value == "*": v *= self.unary()
            else: v /= self.unary()
        return v
    def unary(self):
        if self.peek().value == "-":
            self.take()
            return -self.unary()
        return self.power()
    def power(self):
        base = self.atom()
        if self.peek().value == "^":
            self.take()
            return base ** self.unary()
        return base
    def atom(self):
        t = self.take()
        if t.kind == "num": return t.value
        if t.kind == "name":
            if self.peek().value == "(":
                self.take("(")
                args = []
                while self.peek().value != ")":
                    args.append(self.sum())
                    if self.peek().value == ",": self.take()
                self.take(")")
                return self.env[t.value](*args)
            return self.env[t.value]
        if t.value == "(":
            v = self.sum()
            self.take(")")
            return v
        raise SyntaxError(f"unexpected {t}")
p = Parser({"pi": 3.14, "max": max, "abs": abs})
for line in ("1 + 2 * 3", "(1 + 2) * 3", "2 ^ 3 ^ 2", "-2 ^ 2", "10 / 4 - 1", "x = y = 5", "x * y + pi", "max(1, x, 3) + abs(-2)", "1 / 0", "1 +", "(1", "foo", "3 $ 4", "1 2", "-(-3)", "2 * -3", "1.5.2", ".5 + 1."):
    try:
        print(f"{line:24} = {p.parse(line)}")
    except Exception as e:
        print(f"{line:24} ! {type(e).__name__}: {e}")
print(list(tokenize("a+1.5")))
