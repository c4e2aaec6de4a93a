class I(int):
    def __repr__(self): return 'I(%d)' % int(self)
class F(float): pass
class S(str):
    def upper(self): return S('up:' + super().upper())
class B(bytes): pass
class BA(bytearray):
    def __init__(self, *a): super().__init__(*a); self.tag = 1
class C(complex): pass
i = I(5)
print(i, i + 1, type(i + 1), -i, i * 2.0, i == 5, hash(i) == hash(5), {i: 1}[5], i // 2, divmod(i, 3), pow(i, 2), i ** 2, abs(I(-3)), f'{i}', f'{i:3d}', '%d' % i, '%s' % i, str(i), repr(i), int(i), type(int(i)), round(i), bool(I(0)), i.real, i.bit_length(), [0,1,2,3,4,5,6][i], 'ab' * i, range(i), i < 6, 4 < i, i & 1, i << 1)
f = F(2.5)
print(f, f + 1, type(f + 1), f == 2.5, round(f), f'{f:.2f}', '%g' % f, int(f), f.is_integer(), f.hex(), float(f), type(float(f)), -f, abs(F(-1.0)), f < 3, repr(f), divmod(f, 1), f ** 2, f // 1, hash(f) == hash(2.5))
s = S('abc')
print(s, s.upper(), type(s.upper()), s + 'd', type(s + 'd'), s * 2, s[0], s[::-1], len(s), s == 'abc', hash(s) == hash('abc'), {s: 1}['abc'], 'x' + s, ','.join([s, s]), s.replace('a', s), f'{s:>5}', '%s' % s, 'b' in s, s in 'xabcx', s.split(s), s < 'abd', list(s), s % (), '%s|' % s, str(s), type(str(s)), repr(s), s.format(), 'abc'.startswith(s), s.join('12'), s.encode(), 'abcabc'.count(s), int(S('12')), float(S('1.5')), complex(S('1j')))
b = B(b'ab')
print(b, b + b'c', type(b + b'c'), b[0], b == b'ab', hash(b) == hash(b'ab'), b.upper(), b.decode(), len(b), list(b), b * 2, b in b'xab')
ba = BA(b'xy')
ba.append(65); ba[0] = 66; ba += b'!'
print(ba, ba.tag, type(ba), len(ba), ba == b'ByA!', bytes(ba))
c = C(1, 2)
print(c, c + 1, c.real, c == 1+2j, abs(c), c.conjugate(), complex(c), type(complex(c)), f'{c:.1f}')
print(isinstance(i, int), isinstance(s, str), issubclass(I, int), I.__mro__, int.__add__(i, 2), str.upper(s), I.from_bytes(b'\x05', 'big'), type(I.from_bytes(b'\x05', 'big')), F.fromhex('0x1p1'), type(F.fromhex('0x1p1')), B.fromhex('61'), type(B.fromhex('61')))
class N(int):
    def __new__(cls, v, unit): 
        self = super().__new__(cls, v)
        self.unit = unit
        return self
    def __add__(self, o): return N(int(self) + int(o), self.unit)
    def __radd__(self, o): return ('radd', o)
n = N(3, 'm')
print(n, n.unit, n + 4, (n + 4).unit, 1 + n, sum([n, n], 0))
class D:
    def __init__(self, v): self.v = v
    def __index__(self): return self.v
    def __float__(self): return self.v + 0.5
    def __complex__(self): return complex(self.v, 1)
    def __int__(self): return self.v * 10
    def __round__(self, n=None): return ('r', n)
    def __trunc__(self): return 77
    def __format__(self, spec): return f'<{spec}>'
    def __bool__(self): return False
    def __bytes__(self): return b'BB'
    def __str__(self): return 'str!'
    def __repr__(self): return 'repr!'
d = D(2)
print(int(d), float(d), complex(d), bool(d), round(d), round(d, 1), f'{d:x}', f'{d}', f'{d!r}', f'{d!s:>6}', '%d' % d, '%x' % d, '%s %r' % (d, d), '%f' % d, '{} {:abc} {!r}'.format(d, d, d), [1,2,3][d], 'abc'[d], 'ab' * d, bytes(d), (5).to_bytes(d, 'big'), 'abc'.center(D(7)), 'a,b,c'.split(',', D(1)), 1 << D(3) if False else 0, hex(d), bin(d), chr(D(65)), b'%b' % d, '%c' % D(66), '%*d' % (5, 3), round(2.567, d), range(d), 'abcabc'.find('a', D(1)), 'abc'[D(0):D(2)], divmod(7, 2), pow(2, 5, 3), str(d), ascii('é'))
try: print(1 + d)
except TypeError as e: print(e)
try: print(1.0 + d)
except TypeError as e: print(e)
try: print('x' + d)
except TypeError as e: print(e)
try: print([1] * 'a')
except TypeError as e: print(e)
try: print('%s %s' % (1,))
except TypeError as e: print(e)
try: print('{:d}'.format(d), '{:d}'.format(1.0))
except ValueError as e: print(e)
try: 'é'.encode('ascii')
except UnicodeEncodeError as e: print(e.args, e.encoding, e.object, e.start, e.end, e.reason, e)
try: b'a\xff'.decode()
except UnicodeDecodeError as e: print(e.args, e.encoding, e.object, e.start, e.end, e.reason, e, repr(e))
try: raise UnicodeDecodeError('x', b'abc', 0, 2, 'why')
except ValueError as e: print(e)
try: UnicodeEncodeError('x')
except TypeError as e: print(e)
print(str(UnicodeTranslateError('abc', 1, 2, 'why')))
