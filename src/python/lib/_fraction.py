"""Exact rational numbers, as far as statistics needs them."""

from math import gcd


class Ratio:
    __slots__ = ("numerator", "denominator")

    def __init__(self, numerator, denominator=1):
        common = gcd(numerator, denominator)
        self.numerator = numerator // common
        self.denominator = denominator // common

    def __add__(self, other):
        return Ratio(
            self.numerator * other.denominator + other.numerator * self.denominator, self.denominator * other.denominator
        )

    def __sub__(self, other):
        return Ratio(
            self.numerator * other.denominator - other.numerator * self.denominator, self.denominator * other.denominator
        )

    def __mul__(self, other):
        return Ratio(self.numerator * other.numerator, self.denominator * other.denominator)

    __rmul__ = __mul__

    def __truediv__(self, other):
        return _divide(self, other)

    def __rtruediv__(self, other):
        return _divide(other, self)

    def __le__(self, other):
        return self.numerator <= other * self.denominator

    def __float__(self):
        return self.numerator / self.denominator


def _divide(a, b):
    numerator = a.numerator * b.denominator
    denominator = a.denominator * b.numerator
    return Ratio(-numerator, -denominator) if denominator < 0 else Ratio(numerator, denominator)


def total(parts):
    """The sum of numerators filed under their denominators."""
    result = Ratio(0)
    for denominator, numerator in parts.items():
        result = result + Ratio(numerator, denominator)
    return result
