# SPDX-License-Identifier: LGPL-2.1-or-later
"""Statistics of a study. Runs of different variants from the same start phase belong together: samples of the
bootstrap (Efron 1979) take phases, with both runs of each."""
import numpy as np

#: The bootstrap of fewer values, which knows nothing between them, gives intervals that are too short: those of two values hold the
#: mean in half of all cases.
FEWEST = 4


def _resample(n, samples, seed):
    return np.random.default_rng(seed).integers(n, size=(samples, n))


def mean_interval(values, samples, seed):
    """Mean and its 95 percent percentile interval; an interval of nan for fewer than FEWEST values."""
    values = np.asarray(values, float)
    if len(values) < FEWEST or not np.all(np.isfinite(values)):
        return (float(values.mean()) if len(values) else np.nan, np.nan, np.nan)
    means = values[_resample(len(values), samples, seed)].mean(axis=1)
    return float(values.mean()), *map(float, np.percentile(means, (2.5, 97.5)))


def error_interval(values, reference, samples, seed):
    """Mean of `values` over mean of `reference`, less one, in percent, and its 95 percent interval. Both belong to the
    same phases in the same order; nan for the interval of fewer than FEWEST."""
    values, reference = np.asarray(values, float), np.asarray(reference, float)
    if len(values) == 0 or not np.all(np.isfinite(values)) or not np.all(np.isfinite(reference)) or reference.mean() == 0:
        return np.nan, np.nan, np.nan
    error = 100 * (values.mean() / reference.mean() - 1)
    if len(values) < FEWEST:
        return float(error), np.nan, np.nan
    of = _resample(len(values), samples, seed)
    errors = 100 * (values[of].mean(axis=1) / reference[of].mean(axis=1) - 1)
    return float(error), *map(float, np.percentile(errors, (2.5, 97.5)))


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
