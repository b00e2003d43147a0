# SPDX-License-Identifier: LGPL-2.1-or-later
"""How certain means over the window of a run are, and differences of two runs.

What another chain, another start phase or another model would change is not in these intervals.
"""
from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple, Optional

import numpy as np

from chaindrive.errors import RunError
from chaindrive.run import Array, Run

#: Batches of which a mean is known with an interval, and into which a window is divided at most.
FEWEST, MOST = 4, 20
#: How far apart, in teeth, the driver may stand at the begin of two windows of the same phase.
SAME_PHASE = 1e-3
#: What there is to say of a difference.
PAIRED, APART = "paired by phase", "not paired"
FEW = f"not known: fewer than {FEWEST} batches"
SINGLE = "not known: one value of each run"
UNSAMPLED = "not known: these runs kept no histories of it"


class Means(NamedTuple):
    """What a figure is the mean of.

    values: one per tooth period or engagement, in the unit of the figure. least: how many of them make a batch. phase: what two
    sequences have in common that can be paired.
    """

    values: Array
    least: int
    phase: tuple[object, ...]


class Certainty(NamedTuple):
    """Half of the 95 % interval, nan where it is not known, and in words how it was found or why it is not."""

    uncertainty: float
    words: str


def student(degrees: int) -> float:
    """The 0.975 quantile of Student's distribution, by bisection of its finite series [Abramowitz, Stegun, 26.7.3 and 26.7.4]."""
    def within(t: float) -> float:
        angle = math.atan(t / math.sqrt(degrees))
        even = degrees % 2 == 0
        term, total = (1., 1.) if even else (math.cos(angle), math.cos(angle) if degrees > 1 else 0.)
        for k in range(1 if even else 2, degrees - 2, 2):
            term *= k / (k + 1) * math.cos(angle) ** 2
            total += term
        return math.sin(angle) * total if even else 2 / math.pi * (angle + math.sin(angle) * total)

    low, high = 0., 100.
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if within(middle) < 0.95 else (low, middle)
    return high


def uncertainty_of_mean(values: Sequence[float] | Array, least: int = 1) -> float:
    """Half the width of the 95 % interval of the mean of a stationary sequence; nan with fewer than four batches.

    By batch means, at least `least` values in each, with Student's quantile and the correlation of neighbours, as the program has
    them in summary.json (include/chaindrive/utilities/batch_means.h).
    """
    values = np.asarray(values, float)
    length = max(least, -(-len(values) // MOST), 1)
    n = len(values) // length
    if n < FEWEST or not np.isfinite(values).all():
        return math.nan
    batches = values[len(values) - n * length:].reshape(n, length).mean(axis=1)
    off = batches - batches.mean()
    squares = float(off @ off)
    found = float(off[:-1] @ off[1:]) / squares if squares > 0. else 0.
    correlation = min(max(found + (1. + 3. * found) / n, 0.), 0.9)
    return student(n - 1) * math.sqrt(squares / (n - 1) / n * (1. + correlation) / (1. - correlation))


def least_batch(run: Run) -> int:
    """Tooth periods in a period of the slowest resonance, that of driven inertia and tight span; one where it is faster."""
    pitches: float = run.drive["tooth_frequency"] / run.drive["driven_frequency"] if run.drive.get("driven_frequency") else 1.
    return math.ceil(pitches) if 1. < pitches < 1e6 else 1


def tooth_period_means(run: Run, values: Array) -> Means:
    """Means over the whole tooth periods in the window of what has one value per sample of the histories.

    Integrals over the driver's angle from the begin of the window, by the trapezoidal rule. RunError without histories of it.
    """
    phase, edges, names = _tooth_periods(run)
    integral = np.concatenate([[0.], np.cumsum(0.5 * (values[1:] + values[:-1]) * np.diff(phase))])
    return Means(np.diff(np.interp(edges, phase, integral)), least_batch(run), names)


def tooth_period_rates(run: Run, values: Array) -> Means:
    """How much what has one value per sample of the histories grows per second in each whole tooth period in the window."""
    phase, edges, names = _tooth_periods(run)
    return Means(np.diff(np.interp(edges, phase, values)) / np.diff(np.interp(edges, phase, run.time)), least_batch(run), names)


def _tooth_periods(run: Run) -> tuple[Array, Array, tuple[object, ...]]:
    """Angle of the driver over that of a tooth at each sample, where it is when tooth periods in the window begin and end, `phase` of Means."""
    start, end = run.window
    if not math.isfinite(start):
        raise RunError("The drive had not settled when the run ended: there is no window.")
    angle = run["hubs/driver_angle"]
    phase = (angle - angle[0]) * np.sign(angle[-1] - angle[0]) * run.sprockets[0] / (2. * math.pi)
    first, last = np.interp([start, end], run.time, phase)
    edges = first + np.arange(math.floor(last - first + 1e-9) + 1)
    return phase, edges, (*_drive(run), run.parameters.get("Drive/Layout/Start phase"), first)


def engagement_values(run: Run, wheel: str, column: str) -> Means:
    """A column of the engagements with a sprocket in the window, in their order."""
    found = run.engagements(wheel, window=True)
    return Means(found[column].to_numpy(float), least_batch(run), (*_drive(run), wheel, *found["roller"][:1], 0.))


def _drive(run: Run) -> tuple[object, ...]:
    return run.parameters.get("Drive/Chain/Designation"), run.n_links, run.sprockets


def pairs(one: Means, other: Means) -> bool:
    """Whether the k-th values of two sequences belong together: the same drive at the same phases, and equally many."""
    (*drive, phase), (*other_drive, other_phase) = one.phase, other.phase
    return drive == other_drive and len(one.values) == len(other.values) and abs(float(str(phase)) - float(str(other_phase))) < SAME_PHASE


def of_difference(one: Optional[Means], other: Optional[Means]) -> Certainty:
    """Of the mean of `one` less that of `other`.

    Paired where their phases are the same: the interval of the mean of differences, from which goes what both have in common. Else
    the root of the sum of squares of both half intervals. None stands for what has no sequence.
    """
    if one is None or other is None:
        return Certainty(math.nan, UNSAMPLED)
    if pairs(one, other):
        found, words = uncertainty_of_mean(one.values - other.values, max(one.least, other.least)), PAIRED
    else:
        found, words = math.hypot(uncertainty_of_mean(one.values, one.least), uncertainty_of_mean(other.values, other.least)), APART
    return Certainty(found, words if math.isfinite(found) else FEW)


def sequence(make: Callable[[], Means]) -> Optional[Means]:
    """What `make` gives; None where the run kept too little for it, or its files are damaged."""
    try:
        return make()
    except (RunError, ArithmeticError, AttributeError, LookupError, TypeError, ValueError, OSError):
        return None
