# SPDX-License-Identifier: LGPL-2.1-or-later
"""Statistics of a study. Runs of different variants from the same start phase belong together: where a phase is left out, both runs of
it are."""
import numpy as np

from chaindrive.certainty import student

#: Fewer values give no interval.
FEWEST = 4


def half(estimate, n):
    """Half of the 95 percent interval of an estimate from n values, Student's quantile times the deviation that the jackknife finds
    [Efron and Tibshirani, An Introduction to the Bootstrap, ch. 11]: estimate(chosen) is that of the values with these numbers, one or an
    array. Of a mean it is Student's interval; of anything that is nearly linear in the values it holds as often, also for four of them."""
    without = np.array([estimate([k for k in range(n) if k != i]) for i in range(n)])
    return student(n - 1) * np.sqrt((n - 1) / n * ((without - without.mean(axis=0)) ** 2).sum(axis=0))


def mean_interval(values):
    """Mean and its 95 percent interval; an interval of nan for fewer than FEWEST values."""
    values = np.asarray(values, float)
    if len(values) < FEWEST or not np.all(np.isfinite(values)):
        return (float(values.mean()) if len(values) else np.nan, np.nan, np.nan)
    mean, wide = float(values.mean()), float(half(lambda chosen: values[chosen].mean(), len(values)))
    return mean, mean - wide, mean + wide


def error_interval(values, reference):
    """Mean of `values` over mean of `reference`, less one, in percent, and its 95 percent interval: of the logarithm of the ratio where
    that has one. Both belong to the same phases in the same order; nan for the interval of fewer than FEWEST."""
    values, reference = np.asarray(values, float), np.asarray(reference, float)
    if len(values) == 0 or not np.all(np.isfinite(values)) or not np.all(np.isfinite(reference)) or reference.mean() == 0:
        return np.nan, np.nan, np.nan

    def ratio(chosen):
        return values[chosen].mean() / reference[chosen].mean()

    n = len(values)
    whole = ratio(list(range(n)))
    error = float(100 * (whole - 1))
    if n < FEWEST:
        return error, np.nan, np.nan
    if whole > 0 and all(ratio([k for k in range(n) if k != i]) > 0 for i in range(n)):
        wide = half(lambda chosen: np.log(ratio(chosen)), n)
        return error, float(100 * (whole * np.exp(-wide) - 1)), float(100 * (whole * np.exp(wide) - 1))
    wide = 100 * half(ratio, n)
    return error, float(error - wide), float(error + wide)


def efficient(points):
    """Which of the `points` (cost, error) belong to the efficient (Pareto) front: no other is at most as dear and at most
    as wrong, and better in one of them. Points with nan never do."""
    points = np.asarray(points, float).reshape(-1, 2)
    known = np.all(np.isfinite(points), axis=1)
    front = []
    for i, point in enumerate(points):
        better = np.all(points[known] <= point, axis=1) & np.any(points[known] < point, axis=1)
        front.append(bool(known[i]) and not better.any())
    return front
