def step(cells):
    counts = {}
    for x, y in cells:
        for dx in (-1, 0, 1):
            for dy in (-1, 0, 1):
                if dx or dy:
                    k = (x + dx, y + dy)
                    counts[k] = counts.get(k, 0) + 1
    return {k for k, n in counts.items() if n == 3 or n == 2 and k in cells}
def show(cells, w=8, h=6):
    for y in range(h):
        print("".join("#" if (x, y) in cells else "." for x in range(w)))
    print()
glider = {(1, 0), (2, 1), (0, 2), (1, 2), (2, 2)}
for _ in range(5):
    show(glider)
    glider = step(glider)
blinker = {(1, 1), (2, 1), (3, 1)}
print(step(step(blinker)) == blinker, sorted(step(blinker)))
def rule(n, width=31, rows=12):
    row = [0] * width
    row[width // 2] = 1
    for _ in range(rows):
        print("".join(" *"[c] for c in row).rstrip())
        row = [n >> (row[i - 1] << 2 | row[i] << 1 | row[(i + 1) % width]) & 1 for i in range(width)]
rule(30)
rule(90, 33, 9)
def mandel(w=48, h=16, n=30):
    for j in range(h):
        line = ""
        for i in range(w):
            c = complex(-2.2 + 3.2 * i / w, -1.2 + 2.4 * j / h)
            z = 0j
            for k in range(n):
                z = z * z + c
                if z.real * z.real + z.imag * z.imag > 4: break
            line += " .:-=+*#%@"[min(k // 3, 9)]
        print(line.rstrip())
mandel()
