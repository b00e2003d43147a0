# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spectra of records with equal intervals: mean squares per line, third octaves, harmonics of the teeth."""
from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pandas as pd

from chaindrive.errors import RunError

Array = npt.NDArray[np.float64]

#: Samples are taken at whole steps, so that intervals differ by a step or so.
JITTER = 0.1


def interval_of(time: Array, what: str = "record") -> float:
    """The interval of equally spaced times, s. RunError when a time is off by more than a tenth of an interval."""
    if len(time) < 2:
        raise RunError(f"The {what} have fewer than two samples.")
    interval = (time[-1] - time[0]) / (len(time) - 1)
    straight = time[0] + interval * np.arange(len(time))
    # the last one may be the end of the run and come early
    off = np.abs(time - straight)
    if off.max() > JITTER * interval and len(time) > 3:
        interval = (time[-2] - time[0]) / (len(time) - 2)
        off = np.abs(time[:-1] - time[0] - interval * np.arange(len(time) - 1))
    if not off.max() <= JITTER * interval:
        steps = np.diff(time)
        raise RunError(f"The {what} are not sampled at equal intervals, but at {1e6 * steps.min():.4g} to {1e6 * steps.max():.4g} us: "
                       "there are no spectra of them. A step below Output/History interval in us makes them equal.")
    return float(interval)


def resample(time: Array, values: Array, at: Array) -> Array:
    """`values` at the instants `at` by cubic interpolation through the four nearest of nearly equal samples."""
    interval = (time[-1] - time[0]) / (len(time) - 1)
    position = np.interp(at, time, np.arange(len(time)))
    first = np.clip(np.floor(position).astype(int) - 1, 0, len(time) - 4)
    nodes = [(time[first + k] - at) / interval for k in range(4)]
    result = np.zeros(len(at))
    for k in range(4):
        weight = np.ones(len(at))
        for j in range(4):
            if j != k:
                weight *= nodes[j] / (nodes[j] - nodes[k])
        result += weight * values[first + k]
    return result


def whole_periods(time: Array, values: Array, period: float) -> tuple[Array, Array]:
    """The record from its begin on over as many whole periods as it has, at equal intervals that divide them.

    RunError when there is not a single one.
    """
    n = int(np.floor((time[-1] - time[0]) / period * (1 + 1e-6)))
    if n < 1:
        raise RunError(f"The record of {1e3 * (time[-1] - time[0]):.4g} ms is shorter than a pitch time, {1e3 * period:.4g} ms: it has no "
                       "spectrum over whole pitch times. A longer window (section Output) gives one.")
    samples = n * max(4, int(round(period * (len(time) - 1) / (time[-1] - time[0]))))
    at = time[0] + n * period / samples * np.arange(samples)
    return at, resample(time, values, at)


def mean_square_lines(values: Array, interval: float, window: str = "none") -> tuple[Array, Array]:
    """Frequencies in Hz and the mean square on each line, of one side.

    Their sum is the mean square of `values`, with a Hann window its estimate from the tapered record.
    """
    n = len(values)
    taper = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(n) / n) if window == "hann" else np.ones(n)
    power = np.abs(np.fft.rfft(values * taper)) ** 2 / n ** 2 / np.mean(taper ** 2)
    power[1:(n + 1) // 2] *= 2  # and the negative frequencies
    return np.fft.rfftfreq(n, interval), power


def third_octaves(spectrum: pd.DataFrame, lowest: float = 20., highest: float = 20000.) -> pd.DataFrame:
    """Root mean square in third octaves (IEC 61260-1, base ten) of a frame that Run.spectrum() gives.

    Between two centres, Hz: a line that lies across an edge counts for both bands by its shares. Bands
    without a line, below the first or above the last one, are left out.
    """
    frequency, power = spectrum.index.to_numpy(), spectrum["mean_square"].to_numpy()
    step = frequency[1] - frequency[0]
    centres = 10. ** (np.arange(round(10 * np.log10(lowest)), round(10 * np.log10(highest)) + 1) / 10)
    centres = centres[(centres * 10. ** 0.05 <= frequency[-1] + step / 2) & (centres * 10. ** 0.05 > step / 2)]
    sums = np.concatenate([[0.], np.cumsum(power[1:])])  # without the mean

    def below(edge: float) -> float:
        return float(np.interp(edge, frequency + step / 2, sums, left=0.))

    values = [np.sqrt(max(0., below(centre * 10. ** 0.05) - below(centre * 10. ** -0.05))) for centre in centres]
    frame = pd.DataFrame({"rms": values}, index=pd.Index(centres, name="frequency"))
    frame.attrs = dict(spectrum.attrs)
    return frame


def harmonics(spectrum: pd.DataFrame, frequency: float, n: int = 10) -> pd.DataFrame:
    """Amplitudes of the first `n` harmonics of `frequency`, Hz, in a spectrum over whole periods."""
    lines = spectrum.index.to_numpy()
    step = lines[1] - lines[0]
    orders = [order for order in range(1, n + 1) if order * frequency <= lines[-1]]
    at = [int(round(order * frequency / step)) for order in orders]
    amplitude = np.sqrt(2 * spectrum["mean_square"].to_numpy()[at])
    frame = pd.DataFrame({"frequency": lines[at], "amplitude": amplitude}, index=pd.Index(orders, name="order"))
    frame.attrs = dict(spectrum.attrs)
    return frame
