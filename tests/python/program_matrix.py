class Matrix:
    def __init__(self, rows): self.rows = [list(map(float, r)) for r in rows]
    @classmethod
    def identity(cls, n): return cls([[i == j for j in range(n)] for i in range(n)])
    @property
    def shape(self): return len(self.rows), len(self.rows[0])
    def __getitem__(self, ij):
        i, j = ij
        return self.rows[i][j]
    def __setitem__(self, ij, v):
        i, j = ij
        self.rows[i][j] = v
    def __matmul__(self, o):
        if self.shape[1] != o.shape[0]: raise ValueError(f"shapes {self.shape} and {o.shape} do not match")
        cols = list(zip(*o.rows))
        return Matrix([[sum(a * b for a, b in zip(r, c)) for c in cols] for r in self.rows])
    def __add__(self, o): return Matrix([[a + b for a, b in zip(p, q)] for p, q in zip(self.rows, o.rows)])
    def __mul__(self, k): return Matrix([[a * k for a in r] for r in self.rows])
    __rmul__ = __mul__
    def __pow__(self, n):
        r, b = Matrix.identity(len(self.rows)), self
        while n:
            if n & 1: r = r @ b
            b, n = b @ b, n >> 1
        return r
    def __eq__(self, o): return self.rows == o.rows
    def __repr__(self): return "\n".join(" ".join(f"{v:8.3f}" for v in r) for r in self.rows)
    @property
    def T(self): return Matrix(zip(*self.rows))
    def det(self):
        m = [r[:] for r in self.rows]
        n, d = len(m), 1.0
        for i in range(n):
            p = max(range(i, n), key=lambda r: abs(m[r][i]))
            if m[p][i] == 0: return 0.0
            if p != i: m[i], m[p] = m[p], m[i]; d = -d
            d *= m[i][i]
            for r in range(i + 1, n):
                f = m[r][i] / m[i][i]
                for c in range(i, n): m[r][c] -= f * m[i][c]
        return d
    def inverse(self):
        n = len(self.rows)
        m = [r + [float(i == j) for j in range(n)] for i, r in enumerate(self.rows)]
        for i in range(n):
            p = max(range(i, n), key=lambda r: abs(m[r][i]))
            m[i], m[p] = m[p], m[i]
            k = m[i][i]
            m[i] = [v / k for v in m[i]]
            for r in range(n):
                if r != i:
                    f = m[r][i]
                    m[r] = [a - f * b for a, b in zip(m[r], m[i])]
        return Matrix([r[n:] for r in m])
a = Matrix([[2, 1], [5, 3]])
b = Matrix([[1, 2, 3], [4, 5, 6]])
print(a @ b, b.T, a + a * 2, 3 * a, a ** 10, sep="\n--\n")
print(a.det(), Matrix([[1, 2, 3], [4, 5, 6], [7, 8, 10]]).det(), Matrix([[1, 2], [2, 4]]).det(), a.inverse(), a @ a.inverse() == Matrix.identity(2), a.shape, b[1, 2])
a[0, 0] = 9
print(a[0, 0], a == a, a == b)
try:
    b @ b
except ValueError as e:
    print(e)
fib = Matrix([[1, 1], [1, 0]]) ** 30
print(fib[0, 1])
print(Matrix([[4, -2, 1], [-2, 4, -2], [1, -2, 4]]).inverse())
