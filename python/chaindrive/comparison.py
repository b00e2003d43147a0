# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several runs side by side."""
from __future__ import annotations

import numbers
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import pandas as pd

from chaindrive import certainty, schema
from chaindrive.run import Array, Run

#: Members of the summary that a comparison shows.
KEY_FIGURES = ("tight_tension_mean", "slack_tension_mean", "tight_tension_max_start", "driver_torque_mean", "driven_speed_mean",
               "span_speed_mean", "pitch_time_mean", "efficiency", "driven_angle_end", "drive_work", "resisting_work",
               "energy_imbalance_max", "steps", "wall_seconds")
#: Those that are not found in the window of the means.
WHOLE_RUN = {"tight_tension_max_start", "driven_angle_end", "drive_work", "resisting_work", "energy_imbalance_max", "steps", "wall_seconds",
             "cpu_seconds"}
#: Means over the window: the history of each.
HISTORIES = {"tight_tension": "spans/tight_tension", "slack_tension": "spans/slack_tension", "driver_torque": "hubs/driver_torque",
             "driven_speed": "hubs/driven_speed", "span_speed": "spans/tight_speed"}
#: Those of the engagements with a sprocket in the window.
IMPACTS = ("peak_force", "impulse", "normal_speed")


def names(runs: Sequence[Run]) -> list[str]:
    """A name for each run: its folder, with the folders above where names would be the same."""
    for depth in range(1, 8):
        found = ["/".join(run.folder.resolve().parts[-depth:]) for run in runs]
        if len(set(found)) == len(found):
            return found
    return [f"{i + 1}: {run.name}" for i, run in enumerate(runs)]


def _statistics(run: Run) -> Iterator[tuple[str, str, str]]:
    """Those of the window statistics: signal, member, and what the signal is where the schema does not know it."""
    yield from (("tight_tension", which, "") for which in ("largest", "deviation"))
    yield from ((f"{wheel.name}_load", which, f"load of the {wheel.words} shaft") for wheel in run.wheels for which in ("mean", "largest"))
    yield "driven_speed", "deviation", ""


def figures(run: Run) -> dict[str, tuple[Any, str, str]]:
    """{name: (value, unit, meaning)} of a run."""
    found = {name: (run.summary.get(name), *schema.about(name)) for name in KEY_FIGURES}
    statistics = run.summary.get("statistics", {})
    for signal, which, words in _statistics(run):
        if isinstance(statistics.get(signal), dict):
            path, one = f"statistics/{signal}/{which}", statistics[signal]
            found[f"{signal}_{which}"] = (one.get(which), *(schema.about(path) if path in schema.SUMMARY else (one.get("unit", "1"), f"{words}, {which}")))
    if "lost" in run.summary.get("window_energy", {}) and run.summary["window_energy"].get("duration"):
        energy = run.summary["window_energy"]
        found["loss"] = (energy["lost"] / energy["duration"] if energy["lost"] is not None else None, "W", "loss in the window, mean")
    if isinstance(run.summary.get("engagements"), list):
        for wheel in run.wheels:
            engaged = run.engagements(wheel.name, window=True)
            for column in IMPACTS:
                unit, meaning = schema.about(f"engagements/*/{column}")
                values = engaged[column].astype(float)
                for which, value in (("mean", values.mean()), ("largest", values.max())):
                    found[f"{wheel.name}_{column}_{which}"] = (value, unit, f"{meaning} on the {wheel.title}, {which}")
    if run.acoustics.get("observers"):
        one = _microphone(run)
        found["noise"] = (one.get("level_a"), "dB(A)", f"noise at {one.get('name')}")
    if "total" in run.summary.get("cpu_seconds", {}):
        found["cpu_seconds"] = (run.summary["cpu_seconds"]["total"], "s", "CPU time")
    return {name: about for name, about in found.items() if isinstance(about[0], numbers.Real) and np.isfinite(float(about[0]))}


def means(run: Run, name: str) -> certainty.Means:
    """What the figure of this name is the mean of, in its unit. RunError, KeyError where it is none, or the run did not keep it."""
    wheel, column, which = _of_impacts(run, name)
    if column and which == "mean":
        return certainty.engagement_values(run, wheel, column)
    if name == "pitch_time_mean":
        times = certainty.engagement_values(run, run.wheels[0].name, "time")
        return times._replace(values=np.diff(times.values))
    if name in ("loss", "efficiency"):
        lost = sum(run[path] for path in run.histories.index if path.startswith("energy/") and path.endswith("_loss"))
        rates, energy = certainty.tooth_period_rates(run, np.asarray(lost, float)), run.summary["window_energy"]
        # efficiency is 1 - lost / (drive work - stored): the losses scatter, over a mean power
        power = (energy["drive_work"] - energy["stored"]) / energy["duration"]
        return rates if name == "loss" else rates._replace(values=1. - rates.values / power)
    signal, _, which = name.rpartition("_")
    if which == "mean":
        return certainty.tooth_period_means(run, _signal(run, signal))
    if which == "deviation":
        # of a mean square, whose root changes by its own change over twice the root
        found, values = run.summary["statistics"][signal], _signal(run, signal)
        squares = certainty.tooth_period_means(run, (values - found["mean"]) ** 2)
        return squares._replace(values=0.5 * squares.values / found["deviation"])
    raise KeyError(name)


def _microphone(run: Run) -> dict[str, Any]:
    """What acoustics.json says of the microphone, or else of the first observer."""
    heard = run.acoustics["observers"]
    return dict(next((one for one in heard if one.get("name") == "microphone"), heard[0]))


def _of_impacts(run: Run, name: str) -> tuple[str, str, str]:
    """Sprocket, column and "mean" or "largest" of a figure of impacts; three empty words of any other."""
    return next(((wheel.name, column, which) for wheel in run.wheels for column in IMPACTS for which in ("mean", "largest")
                 if name == f"{wheel.name}_{column}_{which}"), ("", "", ""))


def _signal(run: Run, signal: str) -> Array:
    """The history of a signal of the window statistics."""
    if signal in HISTORIES:
        return run[HISTORIES[signal]]
    return np.hypot(run[f"hubs/{signal}_x"], run[f"hubs/{signal}_y"])


def uncertainty(run: Run, name: str) -> float:
    """Half of the 95 % interval of the figure of this name, in its unit; nan where that is not known, as of one largest value.

    As the summary has it; else, as of runs of earlier versions, from the values per tooth period or engagement that the run kept.
    """
    if name in WHOLE_RUN or name.endswith("_largest"):
        return np.nan
    written = _written_uncertainty(run, name)
    if written is not None:
        return written
    found = certainty.sequence(lambda: means(run, name))
    return np.nan if found is None else certainty.uncertainty_of_mean(found.values, found.least)


def certainty_of_difference(one: Run, other: Run, name: str) -> certainty.Certainty:
    """Of the difference of a figure of two runs: half of its 95 % interval in the unit of the figure, and words.

    From the values per tooth period or engagement where both runs kept them, paired where these are of the same drive at the same
    phases; else from the `uncertainty` of both in their summaries.
    """
    if name in WHOLE_RUN or name.endswith("_largest"):
        return certainty.Certainty(np.nan, certainty.SINGLE)
    first, second = (certainty.sequence(lambda run=run: means(run, name)) for run in (one, other))  # type: ignore[misc]
    if first is not None and second is not None:
        return certainty.of_difference(first, second)
    halves = [_written_uncertainty(run, name) for run in (one, other)]
    if None in halves:
        return certainty.Certainty(np.nan, certainty.UNSAMPLED)
    found = float(np.hypot(*np.array(halves, float)))
    return certainty.Certainty(found, certainty.APART if np.isfinite(found) else certainty.FEW)


def _written_uncertainty(run: Run, name: str) -> float | None:
    """That of a mean, from the summary, nan where it says that there is none; None where it has no such member."""
    wheel, column, which = _of_impacts(run, name)
    signal, _, kind = name.rpartition("_")
    try:
        if name in ("efficiency", "pitch_time_mean"):
            value, kind = run.summary[name.removesuffix("_mean") + "_uncertainty"], "mean"
        elif name == "noise":
            value, kind = _microphone(run)["level_a_uncertainty"], "mean"
        elif name == "loss":
            energy, kind = run.summary["window_energy"], "mean"
            value = energy["lost_uncertainty"] and energy["lost_uncertainty"] / energy["duration"]
        else:
            one = run.summary["impacts"][wheel][column] if column else run.summary["statistics"][signal]
            value = one["uncertainty"]
    except (LookupError, TypeError, ValueError):
        return None
    return None if "mean" not in (which, kind) else float(value) if isinstance(value, numbers.Real) else np.nan


def compare(runs: Sequence[Run]) -> pd.DataFrame:
    """The figures of several runs side by side, with their differences and how certain these are.

    A frame with a row per figure and columns `meaning`, `unit`, one for each run (its folder) and `... uncertainty`, half of its 95 %
    interval or nan where that is not known, and for each but
    the first `... difference` from the first one, `... difference in %`, `... difference uncertainty`, half of the 95 % interval of
    the difference or nan where that is not known, and `... certainty`, how it was found or why it is not known.
    """
    found, columns = [figures(run) for run in runs], names(runs)
    rows = list(dict.fromkeys(name for one in found for name in one))
    about = {name: next(one[name] for one in found if name in one) for name in rows}
    frame = pd.DataFrame({"meaning": [about[n][2] for n in rows], "unit": [about[n][1] for n in rows]}, index=pd.Index(rows, name="figure"))
    for column, one, run in zip(columns, found, runs):
        frame[column] = [one[name][0] if name in one else np.nan for name in rows]
        frame[f"{column} uncertainty"] = [uncertainty(run, name) if name in one else np.nan for name in rows]
    for column, run in zip(columns[1:], runs[1:]):
        frame[f"{column} difference"] = frame[column] - frame[columns[0]]
        frame[f"{column} difference in %"] = 100. * (frame[column] / frame[columns[0]].where(frame[columns[0]] != 0.) - 1.)
        certain = [certainty_of_difference(runs[0], run, name) for name in rows]
        frame[f"{column} difference uncertainty"] = [one.uncertainty for one in certain]
        frame[f"{column} certainty"] = [one.words for one in certain]
    return frame


def changes(runs: Sequence[Run]) -> pd.DataFrame:
    """The entries in which the parameters of runs differ, a column for each run."""
    columns = names(runs)
    paths = list(dict.fromkeys(path for run in runs for path in run.parameters))
    table = {path: [run.parameters.get(path, "") for run in runs] for path in paths}
    differ = {path: values for path, values in table.items() if len(set(values)) > 1}
    return pd.DataFrame.from_dict(differ, orient="index", columns=columns)


def one_drive(runs: Sequence[Run]) -> bool:
    """Whether all runs are of one drive: chain, links and teeth."""
    return len({(run.parameters.get("Drive/Chain/Designation"), run.n_links, run.sprockets) for run in runs}) == 1
