text = """It was the best of times, it was the worst of times,
it was the age of wisdom, it was the age of foolishness..."""
words = "".join(c.lower() if c.isalpha() or c.isspace() else " " for c in text).split()
freq = {}
for w in words: freq[w] = freq.get(w, 0) + 1
for w, n in sorted(freq.items(), key=lambda p: (-p[1], p[0]))[:6]: print(f"{w:<8}{n:>3} {'#' * n}")
def wrap(s, width):
    lines, line = [], ""
    for w in s.split():
        if line and len(line) + 1 + len(w) > width:
            lines.append(line)
            line = w
        else:
            line = f"{line} {w}".strip()
    return lines + [line] if line else lines
for l in wrap(text, 30): print(f"|{l:<30}|{l:>30}|{l:^30}|")
def caesar(s, k): return "".join(chr((ord(c) - b + k) % 26 + b) if c.isalpha() else c for c in s for b in [65 if c.isupper() else 97])
print(caesar("Hello, World!", 3), caesar(caesar("Hello, World!", 3), -3))
def roman(n):
    out = ""
    for v, s in zip((1000, 900, 500, 400, 100, 90, 50, 40, 10, 9, 5, 4, 1), "M CM D CD C XC L XL X IX V IV I".split()):
        out += s * (n // v)
        n %= v
    return out
def unroman(s):
    v = dict(zip("IVXLCDM", (1, 5, 10, 50, 100, 500, 1000)))
    return sum(-v[a] if v[a] < v.get(b, 0) else v[a] for a, b in zip(s, s[1:] + " "))
print([roman(n) for n in (1, 4, 9, 14, 40, 90, 400, 1994, 2024, 3999)], all(unroman(roman(n)) == n for n in range(1, 500)))
def rle(s):
    out, i = [], 0
    while i < len(s):
        j = i
        while j < len(s) and s[j] == s[i]: j += 1
        out.append((s[i], j - i))
        i = j
    return out
print(rle("aaabccd"), "".join(c * n for c, n in rle("aaabccd")))
def distance(a, b):
    row = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        prev, row[0] = row[0], i
        for j, y in enumerate(b, 1):
            prev, row[j] = row[j], min(row[j] + 1, row[j - 1] + 1, prev + (x != y))
    return row[-1]
print(distance("kitten", "sitting"), distance("", "abc"), distance("same", "same"))
def lcs(a, b):
    t = [[""] * (len(b) + 1) for _ in range(len(a) + 1)]
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            t[i + 1][j + 1] = t[i][j] + x if x == y else max(t[i][j + 1], t[i + 1][j], key=len)
    return t[-1][-1]
print(lcs("AGGTAB", "GXTXAYB"), lcs("programming", "gaming"))
csv = 'name,age,city\nAnn,30,"New York"\nBob,,"He said ""hi"""\n'
def parse_csv(s):
    rows, row, cell, quoted = [], [], "", False
    i = 0
    while i < len(s):
        c = s[i]
        if quoted:
            if c == '"':
                if s[i + 1:i + 2] == '"': cell += '"'; i += 1
                else: quoted = False
            else: cell += c
        elif c == '"': quoted = True
        elif c == ",": row.append(cell); cell = ""
        elif c == "\n": rows.append(row + [cell]); row, cell = [], ""
        else: cell += c
        i += 1
    return rows
head, *body = parse_csv(csv)
print([dict(zip(head, r)) for r in body])
def to_json(v, ind=0):
    pad = "  " * ind
    if v is None: return "null"
    if isinstance(v, bool): return str(v).lower()
    if isinstance(v, (int, float)): return repr(v)
    if isinstance(v, str): return '"' + v.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'
    if isinstance(v, dict): return "{\n" + ",\n".join(f"{pad}  {to_json(str(k))}: {to_json(x, ind + 1)}" for k, x in v.items()) + f"\n{pad}}}" if v else "{}"
    return "[" + ", ".join(to_json(x, ind) for x in v) + "]"
print(to_json({"a": [1, 2.5, None, True], "b": {"c": 'q"\n', "d": {}}, 3: ()}))
print(*("".join(sorted(set(w))) for w in ("banana", "mississippi")), [w for w in ("level", "hello", "noon") if w == w[::-1]], " ".join(w[::-1] for w in "abc def".split()), "-".join(f"{ord(c):02x}" for c in "hi!"), "".join(format(ord(c), "08b") for c in "ab"), sorted("The Quick brown".split(), key=str.lower), "%s has %d items costing $%.2f" % ("cart", 3, 9.5), "a,b;c".replace(";", ",").split(","), [s.strip() for s in " a | b |c ".split("|")])
for n in range(1, 16): print("FizzBuzz"[n * n % 3 * 4:8 - -n ** 4 % 5] or n, end=" ")
print()
for i in range(1, 4): print(*[f"{i * j:3}" for j in range(1, 8)])
print("\n".join("*" * (2 * i + 1) for i in range(3)), "\n".join(f"{'*' * i:^7}" for i in (1, 3, 5)), sep="\n")
