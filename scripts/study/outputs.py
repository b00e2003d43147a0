# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a study judges of a run: `chaindrive document` defines each output, tests/runs/study.py compares the names."""
import functools
import json
import re

import numpy as np

import chaindrive
from chaindrive.drive import WHEELS
from chaindrive.report.foreign import plain

BANDS = 1000. * 2. ** (np.arange(-1, 14) / 3)  # centres of third octaves, Hz: 800 (nominally) to 20 kHz
NOMINAL = (800, 1000, 1250, 1600, 2000, 2500, 3150, 4000, 5000, 6300, 8000, 10000, 12500, 16000, 20000)
LOWEST = BANDS[0] * 2. ** (-1 / 6)  # 707 Hz


class Run(chaindrive.Run):
    """A run with its window."""

    def __init__(self, folder):
        super().__init__(folder)
        self.inside = self.between(self.start, self.end)

    def engaged(self, sprocket):
        """The engagements with a sprocket in the window."""
        return self.engagements(sprocket, window=True).to_dict("records")

    @functools.lru_cache(maxsize=None)
    def approaches(self, surface):
        """Velocities [m/s] of the rollers that engage with the driver in the window, along the span and normal to it,
        from a pitch time before the touch to one after: array (roller, direction, instant) and the interval of the
        instants [s]; none when fewer than two are within the histories."""
        interval = np.median(np.diff(self.time))
        if not self.pitch_time or not np.isfinite(self.pitch_time):  # a driver that stands
            return None, interval
        n = 2 * int(self.pitch_time / interval)
        if surface and "rollers/surface_velocity_normal" not in self:
            return None, interval
        touches = [(e["roller"], e["time"]) for e in self.engaged("driver")
                   if e["time"] - self.pitch_time >= self.time[0] and e["time"] + self.pitch_time <= self.time[-1]]
        curves = [[self.aligned(values, -self.pitch_time, self.pitch_time, touch, n)
                   for values in self.velocity(roller, surface)] for roller, touch in touches]
        return (np.array(curves), interval) if len(curves) > 1 else (None, interval)

    @functools.lru_cache(maxsize=None)
    def power(self, surface):
        """Mean square velocity per frequency, m2/s2 per bin, both directions together, mean over rollers; frequencies."""
        curves, interval = self.approaches(surface)
        if curves is None:
            return None, None
        return power_spectrum(curves, interval)


def power_spectrum(curves, interval):
    """Mean square of `curves` (roller, direction, instant) per frequency, summed over directions, mean over rollers,
    and the frequencies. The straight line from the first value to the last is taken away, so that no jump is left where
    the period closes. The sum over all bins is the mean square (Parseval)."""
    n = curves.shape[-1]
    line = np.linspace(curves[..., 0], curves[..., -1], n, axis=-1)
    spectrum = np.abs(np.fft.rfft(curves - line)) ** 2 / n ** 2
    spectrum[..., 1:(n + 1) // 2] *= 2  # and the negative frequencies
    return spectrum.sum(axis=1).mean(axis=0), np.fft.rfftfreq(n, interval)


def third_octaves(power, frequency):
    """{nominal centre [Hz]: r.m.s.} of the bands that lie below the largest frequency."""
    bands = {}
    for nominal, centre in zip(NOMINAL, BANDS):
        low, high = centre * 2. ** (-1 / 6), centre * 2. ** (1 / 6)
        if high <= frequency[-1]:
            bands[nominal] = float(np.sqrt(power[(frequency >= low) & (frequency < high)].sum()))
    return bands


def variation(curves):
    """R.m.s. difference of curves (roller, ...) from their mean over the r.m.s. of that."""
    mean = curves.mean(axis=0)
    return float(np.sqrt(np.mean((curves - mean) ** 2) / np.mean(mean ** 2)))


def statistics(values):
    """Mean and largest; of two values and more, coefficient of variation and largest over smallest."""
    values = np.asarray(values, float)
    found = {}
    if len(values) > 0:
        found.update(mean=float(values.mean()), max=float(values.max()))
    if len(values) > 1:
        found.update(cv=float(values.std(ddof=1) / values.mean()), max_over_min=float(values.max() / values.min()))
    return found


def _engagements(run, name):
    sprocket, quantity, which = re.fullmatch("(.*)_(peak|impulse|normal)_(.*)", name).groups()
    key = {"peak": "peak_force", "impulse": "impulse", "normal": "normal_speed"}[quantity]
    return statistics([e[key] for e in run.engaged(sprocket)]).get(which)


def _velocity(run, surface, name):
    curves, _ = run.approaches(surface)
    if curves is None:
        return None
    if name == "variation":
        return variation(curves)
    power, frequency = run.power(surface)
    if name == "spectrum":
        return third_octaves(power, frequency)
    return float(np.sqrt(power[frequency >= LOWEST].sum()))


def _sound(run, name):
    """Of the first observer; none where the run computed no noise."""
    return run.acoustics["observers"][0][name] if run.acoustics else None


def _sound_spectrum(run):
    levels = _sound(run, "third_octaves")
    return levels and {nominal: level for nominal, centre in zip(NOMINAL, BANDS)
                       for band, level in zip(run.acoustics["third_octaves"], levels)
                       if abs(np.log2(band / centre)) < 0.1}


def _sound_peak_cv(run):
    return statistics(_sound(run, "engagement_peaks") or []).get("cv")


def _losses(run):
    return sum(value for name, value in run.summary["energy"].items() if name.endswith("_loss"))


def _ripple(run, path):
    return float(run[path][run.inside].std())


def _plates(run, bending_only):
    if "plates/axial_stress" not in run or not run.inside.any():
        return None
    bending = abs(run["plates/bending_in_plane"]) + abs(run["plates/bending_out_of_plane"])
    stress = bending if bending_only else bending + abs(run["plates/axial_stress"])
    return float(np.nanmax(stress[run.inside]))


#: Outputs that are no members of the summary.
OUTPUTS = {
    "tension_difference_mean": lambda run: run.summary["tight_tension_mean"] - run.summary["slack_tension_mean"],
    "losses": _losses,
    "loss_power_mean": lambda run: _losses(run) / run.time[-1],
    **{name: lambda run, name=name: _engagements(run, name)
       for wheel in WHEELS
       for name in (*(f"{wheel.name}_peak_{which}" for which in ("mean", "max", "cv", "max_over_min")),
                    *(f"{wheel.name}_impulse_{which}" for which in ("mean", "cv")))},
    "driver_normal_speed_mean": lambda run: _engagements(run, "driver_normal_mean"),
    **{name: lambda run, member=member: run.summary.get("life", {}).get(member)
       for name, member in (("wear_rate", "simulated_wear_rate"), ("plate_safety", "simulated_plate_safety"), ("roller_life", "simulated_roller_hours"))},
    "sound_level": lambda run: _sound(run, "level"),
    "sound_level_a": lambda run: _sound(run, "level_a"),
    "sound_spectrum": _sound_spectrum,
    "sound_peak_cv": _sound_peak_cv,
    "tight_tension_ripple": lambda run: _ripple(run, "spans/tight_tension"),
    "driven_speed_ripple": lambda run: _ripple(run, "hubs/driven_speed"),
    **{f"roller_velocity_{what}": lambda run, what=what: _velocity(run, False, what)
       for what in ("rms", "spectrum", "variation")},
    **{f"surface_velocity_{what}": lambda run, what=what: _velocity(run, True, what) for what in ("rms", "variation")},
    "plate_stress_max": lambda run: _plates(run, False),
    "plate_bending_max": lambda run: _plates(run, True),
}


LONGEST = 500  # letters of a sentence


def sentence(text):
    """A text of a file as a table and a page may show it: files may come from anybody, or be damaged."""
    text = " ".join(re.sub(r"[\x00-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff]", " ", plain(text)).split())
    return text if len(text) <= LONGEST else text[:LONGEST] + " ..."


def end_of_run(folder):
    """How the run in `folder` ended, as run_variant.py says: {"status", "error"}; status is none while it has not, or when
    that cannot be read."""
    try:
        end = json.loads((folder / "result.json").read_text(encoding="utf-8"))
        return {"status": int(end["status"]), "error": sentence(str(end["error"]))}
    except FileNotFoundError:
        return {"status": None, "error": "not finished"}
    except (ValueError, TypeError, KeyError, OSError, OverflowError, RecursionError):
        return {"status": None, "error": "result.json is damaged: start the study again"}


def of_run(folder, names):
    """{column: value} of the outputs `names` of the run in `folder`; nan where the model has no such thing. A spectrum has
    a column for each band."""
    values = {}
    try:
        with Run(folder) as run:
            for name in names:
                value = OUTPUTS[name](run) if name in OUTPUTS else run.summary.get(name)
                if isinstance(value, dict):
                    values.update({f"{name} {band} Hz": x for band, x in value.items()})
                else:
                    values[name] = np.nan if value is None else float(value)
    finally:  # thousands of runs are more files and histories than a process may hold
        Run.approaches.cache_clear()
        Run.power.cache_clear()
    return values
