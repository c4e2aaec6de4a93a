import statistics
from statistics import *
from statistics import LinearRegression

def t(f):
    try:
        print(f())
    except Exception as e:
        print(type(e).__name__, e, sep=": ")

sets = ([1, 2, 3, 4], [1, 2, 3], [1.5, 2.5, 4.0, 10.25], [0.1] * 10, [1e16, 1.0, -1e16], [2, 4, 4, 4, 5, 5, 7, 9], [1, 2.5, True, 0], [-1.5, 0.3, 1e-300, 1e300], [5], [3, 3], [0.1, 0.2, 0.3, 0.7], [i * 0.37 % 1 for i in range(50)], [10 ** 20, 10 ** 20 + 1, 3], [True, False, True], (x * x for x in range(7)), range(1, 30, 3), [1e308, 1e308], [5e-324, 5e-324, 1e-323])
for d in sets:
    d = list(d)
    print(d if len(d) < 12 else len(d))
    for f in (mean, fmean, median, median_low, median_high, median_grouped, mode, multimode, variance, pvariance, stdev, pstdev, quantiles):
        try:
            print("  ", f.__name__, repr(f(d)), type(f(d)).__name__)
        except Exception as e:
            print("  ", f.__name__, type(e).__name__, e)
for f in (mean, fmean, median, median_low, median_high, median_grouped, mode, multimode, variance, pvariance, stdev, pstdev, quantiles, geometric_mean, harmonic_mean):
    t(lambda: f([]))
for f in (variance, stdev, quantiles):
    t(lambda: f([1]))
t(lambda: mean(["a"]))
t(lambda: mean([None]))
t(lambda: mean([1j]))
t(lambda: mean(5))
t(lambda: fmean(["a"]))
t(lambda: median(["a", "b"]))
t(lambda: mode([[]]))
t(lambda: issubclass(StatisticsError, ValueError))
inf, nan = float("inf"), float("nan")
print(mean([1, inf]), mean([inf, -inf]), mean([1, nan]), fmean([1, inf]), variance([1.0, inf]), median([1, inf, 3]))
t(lambda: stdev([1.0, inf]))
print("%.12g %.12g %.12g" % (geometric_mean([54, 24, 36]), geometric_mean([1.5, 2.5]), geometric_mean([4])))
t(lambda: geometric_mean([0, 1]))
t(lambda: geometric_mean([-1, 1]))
print(harmonic_mean([40, 60]), harmonic_mean([40, 60], weights=[5, 30]), harmonic_mean([5]), harmonic_mean([1, 2, 4]), harmonic_mean([2.5, 3, 10]), harmonic_mean([0, 1]), harmonic_mean(iter([2, 2])), harmonic_mean([1, 1], [1, 1]), harmonic_mean([3], weights=[2]))
t(lambda: harmonic_mean([-1, 2]))
t(lambda: harmonic_mean([1, 2], [1]))
t(lambda: harmonic_mean([1, 2], [-1, 1]))
t(lambda: harmonic_mean(["a"]))
t(lambda: harmonic_mean([-1]))
t(lambda: harmonic_mean([1, 2], [0, 0]))
print(fmean([3.5, 4.0, 5.25]), fmean([1, 2, 3], [1, 1, 2]), fmean(iter([1, 2])), fmean([1, 2], weights=iter([1, 3])))
t(lambda: fmean([1, 2], [1]))
t(lambda: fmean([1, 2], [0, 0]))
print(variance([1, 2, 3], 2), variance([1, 2, 3, 4], 2.5), pvariance([1.5, 2.5], mu=2.0), stdev([1, 2, 3], xbar=2), pstdev([1, 2], 1.5), variance([1, 2, 3, 4, 5, 6]), pvariance([1, 1, 2]), variance([0.5, 0.75, 0.625, 0.375]), stdev([1.5, 2.5, 2.5, 2.75, 3.25, 4.75]), pstdev([1.5, 2.5, 2.5, 2.75, 3.25, 4.75]))
print(quantiles(range(1, 11)), quantiles([1, 2, 3], n=10), quantiles(range(10), n=4, method="inclusive"), quantiles([3, 1], n=2), quantiles([1, 2], n=1), quantiles([105, 129, 87, 86, 111, 111, 89, 81, 108, 92, 110], n=10), quantiles([0.1, 0.7, 1.3], method="inclusive"))
t(lambda: quantiles([1, 2], n=0))
t(lambda: quantiles([1, 2], method="x"))
print(median_grouped([52, 52, 53, 54]), median_grouped([1, 3, 3, 5, 7]), median_grouped([1, 3, 3, 5, 7], interval=2), median_grouped([1]), mode("aabbb"), mode(["red", "blue", "red"]), mode([1, 1.0, 2]), multimode("aabbccd"), multimode([]), median([3, 1, 2]), median("cab") if False else "-", median_low(["b", "a"]), median_high("ab"))
x, y = [1, 2, 3, 4, 5], [2.1, 3.9, 6.2, 7.8, 10.1]
print(covariance(x, y), correlation(x, y), linear_regression(x, y), linear_regression(x, y, proportional=True), correlation(x, x), correlation(x, x[::-1]), covariance([1, 2], [3, 5]), linear_regression([0, 1], [1, 3]).slope, LinearRegression(1, 2))
t(lambda: covariance([1], [1, 2]))
t(lambda: covariance([1], [1]))
t(lambda: correlation([1, 1], [1, 2]))
t(lambda: correlation([1, 2], [1, 2, 3]))
t(lambda: linear_regression([1, 1], [1, 2]))
t(lambda: linear_regression([1], [1]))
slope, intercept = linear_regression(x, y)
print(round(slope, 6), round(intercept, 6))
n = NormalDist(100, 15)
print(n, n.mean, n.stdev, n.variance, n.median, n.mode, NormalDist(), n == NormalDist(100.0, 15.0), hash(n) == hash(NormalDist(100, 15)), n + 5, n - 5, n * 2, n / 2, 5 + n, 5 - n, 2 * n, -n, +n, n + NormalDist(10, 8), n - NormalDist(10, 8), n.zscore(130), NormalDist.from_samples([2, 4, 4, 4, 5, 5, 7, 9]), n != NormalDist(1, 1), n == 5)
print(*["%.12g" % v for v in (n.pdf(100), n.pdf(120), n.cdf(100), n.cdf(130), n.inv_cdf(0.5), n.inv_cdf(0.9), n.inv_cdf(0.001), n.inv_cdf(1e-15), n.inv_cdf(0.08), n.overlap(NormalDist(110, 15)), n.overlap(NormalDist(110, 10)), *n.quantiles(), *NormalDist().quantiles(10))])
t(lambda: NormalDist(0, -1))
t(lambda: n.inv_cdf(0))
t(lambda: n.inv_cdf(1.5))
t(lambda: NormalDist(0, 0).pdf(1))
t(lambda: NormalDist(0, 0).cdf(1))
t(lambda: NormalDist(0, 0).zscore(1))
t(lambda: NormalDist(0, 0).inv_cdf(0.5))
t(lambda: n.overlap(5))
t(lambda: NormalDist.from_samples([1]))
print(*["%.12g" % v for v in n.samples(3, seed=42)], len(n.samples(5)))
print(statistics.mean is mean, mean([1, 2]) == 1.5, type(mean([2, 4])).__name__, type(mean([2.0, 4])).__name__, type(mean([True, True])).__name__, mean({1: 2, 3: 4}), mean({1, 2, 3}), median(x for x in [1, 2]))
