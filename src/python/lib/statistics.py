"""Statistics: sums are exact, and rounded once at the end, as CPython's are."""

from itertools import repeat as _repeat
from math import exp, fsum, isfinite as _isfinite, isqrt as _isqrt, log, sqrt

from _fraction import Ratio as _Ratio, total as _total

__all__ = [
    "NormalDist", "StatisticsError", "correlation", "covariance", "fmean", "geometric_mean", "harmonic_mean",
    "linear_regression", "mean", "median", "median_grouped", "median_high", "median_low", "mode", "multimode", "pstdev",
    "pvariance", "quantiles", "stdev", "variance",
]


def __getattr__(name):
    if name == "NormalDist":
        from _normal_dist import NormalDist as value
    elif name == "LinearRegression":
        value = _linear_regression_type()
    else:
        raise AttributeError(f"module 'statistics' has no attribute {name!r}")
    return value


_made = []


def _linear_regression_type():
    """The result of linear_regression, made once."""
    if not _made:
        from collections import namedtuple

        _made.append(namedtuple("LinearRegression", ("slope", "intercept"), module="statistics"))
    return _made[0]


class StatisticsError(ValueError):
    pass


def _exact_ratio(x):
    try:
        return x.as_integer_ratio()
    except AttributeError:
        pass
    except (OverflowError, ValueError):
        return x, None
    try:
        return x.numerator, x.denominator
    except AttributeError:
        raise TypeError(f"can't convert type '{type(x).__name__}' to numerator/denominator") from None


def _coerce(T, S):
    """The type of a result made from values of both types."""
    if T is S or S is int or S is bool:
        return T
    if T is int or issubclass(S, T):
        return S
    if issubclass(T, S) or issubclass(S, int):
        return T
    if issubclass(T, int):
        return S
    raise TypeError(f"don't know how to coerce {T.__name__} and {S.__name__}")


def _common_type(types):
    result = int
    for kind in types:
        result = _coerce(result, kind)
    return result


def _sum(data):
    """The type of the result, the exact sum (or an infinity or nan) and the count."""
    count = 0
    types = {}
    parts = {}
    for x in data:
        types[type(x)] = None
        n, d = _exact_ratio(x)
        count += 1
        parts[d] = parts.get(d, 0) + n
    found = parts[None] if None in parts else _total(parts)
    return _common_type(types), found, count


def _sum_of_squares(data, center=None):
    """The type of the result, the exact sum of squared deviations, the center and the count."""
    if center is not None:
        T, found, count = _sum((d := x - center) * d for x in data)
        return T, found, center, count
    count = 0
    types = {}
    parts = {}
    squares = {}
    for x in data:
        types[type(x)] = None
        n, d = _exact_ratio(x)
        count += 1
        parts[d] = parts.get(d, 0) + n
        squares[d] = squares.get(d, 0) + n * n
    if not count:
        found = center = _Ratio(0)
    elif None in parts:
        found = center = parts[None]
    else:
        sx = _total(parts)
        sxx = _Ratio(0)
        for d, n in squares.items():
            sxx = sxx + _Ratio(n, d * d)
        found = (count * sxx - sx * sx) / count
        center = sx / count
    return _common_type(types), found, center, count


def _convert(value, T):
    if type(value) is T:
        return value
    if not isinstance(value, _Ratio):
        return T(value)
    if issubclass(T, int):
        if value.denominator == 1:
            return T(value.numerator)
        T = float
    return T(value.numerator / value.denominator)


def _root_to_odd(n, m):
    a = _isqrt(n // m)
    return a | (a * a * m != n)


def _sqrt_of_ratio(n, m):
    """The square root of n/m, correctly rounded: enough bits are kept, the last one odd where any were lost."""
    q = (n.bit_length() - m.bit_length() - 109) // 2
    if q >= 0:
        return (_root_to_odd(n, m << 2 * q) << q) / 1
    return _root_to_odd(n << -2 * q, m) / (1 << -q)


def mean(data):
    T, found, n = _sum(data)
    if n < 1:
        raise StatisticsError("mean requires at least one data point")
    return _convert(found / n, T)


def fmean(data, weights=None):
    try:
        n = len(data)
    except TypeError:
        data = list(data)
        n = len(data)
    if weights is None:
        found = fsum(data)
        if not n:
            raise StatisticsError("fmean requires at least one data point")
        return found / n
    try:
        count = len(weights)
    except TypeError:
        weights = list(weights)
        count = len(weights)
    numerator = fsum(map(lambda x, w: x * w, data, weights))
    if n != count:
        raise StatisticsError("data and weights must be the same length")
    denominator = fsum(weights)
    if not denominator:
        raise StatisticsError("sum of weights must be non-zero")
    return numerator / denominator


def geometric_mean(data):
    try:
        return exp(fmean(map(log, data)))
    except ValueError:
        raise StatisticsError("geometric mean requires a non-empty dataset containing positive numbers") from None


_NEGATIVE = "harmonic mean does not support negative values"


def _checked(values):
    for x in values:
        if x < 0:
            raise StatisticsError(_NEGATIVE)
        yield x


def harmonic_mean(data, weights=None):
    if iter(data) is data:
        data = list(data)
    n = len(data)
    if n < 1:
        raise StatisticsError("harmonic_mean requires at least one data point")
    if n == 1 and weights is None:
        x = data[0]
        if not isinstance(x, (int, float)):
            raise TypeError("unsupported type")
        if x < 0:
            raise StatisticsError(_NEGATIVE)
        return x
    if weights is None:
        weights = _repeat(1, n)
        sum_weights = n
    else:
        if iter(weights) is weights:
            weights = list(weights)
        if len(weights) != n:
            raise StatisticsError("Number of weights does not match data size")
        _, sum_weights, _ = _sum(_checked(weights))
    try:
        T, found, _ = _sum(w / x if w else 0 for w, x in zip(weights, _checked(data)))
    except ZeroDivisionError:
        return 0
    if found <= 0:
        raise StatisticsError("Weighted sum must be positive")
    return _convert(sum_weights / found, T)


def _sorted(data):
    data = sorted(data)
    if not data:
        raise StatisticsError("no median for empty data")
    return data, len(data)


def median(data):
    data, n = _sorted(data)
    if n % 2:
        return data[n // 2]
    return (data[n // 2 - 1] + data[n // 2]) / 2


def median_low(data):
    data, n = _sorted(data)
    return data[(n - 1) // 2]


def median_high(data):
    data, n = _sorted(data)
    return data[n // 2]


def median_grouped(data, interval=1.0):
    data, n = _sorted(data)
    x = data[n // 2]
    first = data.index(x)
    frequency = 0
    while first + frequency < n and not x < data[first + frequency]:
        frequency += 1
    try:
        interval = float(interval)
        x = float(x)
    except ValueError:
        raise TypeError("Value cannot be converted to a float")
    return x - interval / 2.0 + interval * (n / 2 - first) / frequency


def _counts(data):
    counts = {}
    for x in data:
        counts[x] = counts.get(x, 0) + 1
    return counts


def mode(data):
    counts = _counts(data)
    if not counts:
        raise StatisticsError("no mode for empty data")
    return max(counts, key=counts.get)


def multimode(data):
    counts = _counts(data)
    if not counts:
        return []
    most = max(counts.values())
    return [value for value, count in counts.items() if count == most]


def quantiles(data, *, n=4, method="exclusive"):
    if n < 1:
        raise StatisticsError("n must be at least 1")
    data = sorted(data)
    size = len(data)
    if size < 2:
        raise StatisticsError("must have at least two data points")
    result = []
    if method == "inclusive":
        for i in range(1, n):
            j, delta = divmod(i * (size - 1), n)
            result.append((data[j] * (n - delta) + data[j + 1] * delta) / n)
    elif method == "exclusive":
        for i in range(1, n):
            j = min(max(i * (size + 1) // n, 1), size - 1)
            delta = i * (size + 1) - j * n
            result.append((data[j - 1] * (n - delta) + data[j] * delta) / n)
    else:
        raise ValueError(f"Unknown method: {method!r}")
    return result


def variance(data, xbar=None):
    T, ss, _, n = _sum_of_squares(data, xbar)
    if n < 2:
        raise StatisticsError("variance requires at least two data points")
    return _convert(ss / (n - 1), T)


def pvariance(data, mu=None):
    T, ss, _, n = _sum_of_squares(data, mu)
    if n < 1:
        raise StatisticsError("pvariance requires at least one data point")
    return _convert(ss / n, T)


def stdev(data, xbar=None):
    _, ss, _, n = _sum_of_squares(data, xbar)
    if n < 2:
        raise StatisticsError("stdev requires at least two data points")
    square = ss / (n - 1)
    return _sqrt_of_ratio(square.numerator, square.denominator)


def pstdev(data, mu=None):
    _, ss, _, n = _sum_of_squares(data, mu)
    if n < 1:
        raise StatisticsError("pstdev requires at least one data point")
    square = ss / n
    return _sqrt_of_ratio(square.numerator, square.denominator)


def _mean_stdev(data):
    _, ss, xbar, n = _sum_of_squares(data)
    if n < 2:
        raise StatisticsError("stdev requires at least two data points")
    square = ss / (n - 1)
    if not isinstance(square, _Ratio):
        return float(xbar), float(xbar) / float(ss)
    return float(xbar), _sqrt_of_ratio(square.numerator, square.denominator)


def _paired(x, y, what):
    n = len(x)
    if len(y) != n:
        raise StatisticsError(f"{what} requires that both inputs have same number of data points")
    if n < 2:
        raise StatisticsError(f"{what} requires at least two data points")
    return n


def _deviations(x, xbar, y, ybar):
    return fsum((xi - xbar) * (yi - ybar) for xi, yi in zip(x, y))


def covariance(x, y, /):
    n = _paired(x, y, "covariance")
    return _deviations(x, fsum(x) / n, y, fsum(y) / n) / (n - 1)


def correlation(x, y, /):
    n = _paired(x, y, "correlation")
    xbar = fsum(x) / n
    ybar = fsum(y) / n
    sxy = _deviations(x, xbar, y, ybar)
    sxx = _deviations(x, xbar, x, xbar)
    syy = _deviations(y, ybar, y, ybar)
    try:
        return sxy / sqrt(sxx * syy)
    except ZeroDivisionError:
        raise StatisticsError("at least one of the inputs is constant")


def linear_regression(x, y, /, *, proportional=False):
    n = _paired(x, y, "linear regression")
    if proportional:
        sxy = fsum(xi * yi for xi, yi in zip(x, y))
        sxx = fsum(xi * xi for xi in x)
    else:
        xbar = fsum(x) / n
        ybar = fsum(y) / n
        sxy = _deviations(x, xbar, y, ybar)
        sxx = _deviations(x, xbar, x, xbar)
    try:
        slope = sxy / sxx
    except ZeroDivisionError:
        raise StatisticsError("x is constant")
    intercept = 0.0 if proportional else ybar - slope * xbar
    return _linear_regression_type()(slope=slope, intercept=intercept)
