# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several runs side by side."""
from __future__ import annotations

import numbers
from collections.abc import Sequence
from typing import Any

import numpy as np
import pandas as pd

from chaindrive.run import Run

#: Figures of the summary that a comparison shows: member, unit, what it is.
FIGURES = {
    "tight_tension_mean": ("N", "tension of the tight span, mean"),
    "slack_tension_mean": ("N", "tension of the slack span, mean"),
    "tight_tension_max_start": ("N", "tension of the tight span, largest in the first 10 ms"),
    "driver_torque_mean": ("N m", "driver torque, mean"),
    "driven_speed_mean": ("rad/s", "driven speed, mean"),
    "span_speed_mean": ("m/s", "speed of the tight span, mean"),
    "pitch_time_mean": ("s", "time from engagement to engagement, mean"),
    "efficiency": ("1", "efficiency in the window"),
    "driven_angle_end": ("rad", "angle of the driven sprocket at the end"),
    "drive_work": ("J", "work of the driver"),
    "resisting_work": ("J", "work against the load"),
    "energy_imbalance_max": ("1", "error of the energy balance, largest"),
    "steps": ("1", "time steps"),
    "wall_seconds": ("s", "elapsed time"),
}
#: Those that are not found in the window of the means.
WHOLE_RUN = {"tight_tension_max_start", "driven_angle_end", "drive_work", "resisting_work", "energy_imbalance_max", "steps", "wall_seconds",
             "cpu_seconds"}
#: Those of the window statistics: signal, member, unit, what it is.
STATISTICS = (("tight_tension", "largest", "N", "tension of the tight span, largest"),
              ("tight_tension", "deviation", "N", "tension of the tight span, standard deviation"),
              ("driver_load", "mean", "N", "load of the driver's shaft, mean"), ("driver_load", "largest", "N", "load of the driver's shaft, largest"),
              ("driven_load", "mean", "N", "load of the driven shaft, mean"), ("driven_load", "largest", "N", "load of the driven shaft, largest"),
              ("driven_speed", "deviation", "rad/s", "driven speed, standard deviation"))
#: Those of the engagements with a sprocket in the window: column, unit, what it is.
IMPACTS = {"peak_force": ("N", "peak force of an impact"), "impulse": ("N s", "impulse of an impact"),
           "normal_speed": ("m/s", "normal speed of an impact")}


def names(runs: Sequence[Run]) -> list[str]:
    """A name for each run: its folder, with the folders above where names would be the same."""
    for depth in range(1, 8):
        found = ["/".join(run.folder.resolve().parts[-depth:]) for run in runs]
        if len(set(found)) == len(found):
            return found
    return [f"{i + 1}: {run.name}" for i, run in enumerate(runs)]


def figures(run: Run) -> dict[str, tuple[Any, str, str]]:
    """{name: (value, unit, meaning)} of a run."""
    found = {name: (run.summary.get(name), *about) for name, about in FIGURES.items()}
    statistics = run.summary.get("statistics", {})
    for signal, which, unit, meaning in STATISTICS:
        if isinstance(statistics.get(signal), dict):
            found[f"{signal}_{which}"] = (statistics[signal].get(which), unit, meaning)
    if "lost" in run.summary.get("window_energy", {}) and run.summary["window_energy"].get("duration"):
        energy = run.summary["window_energy"]
        found["loss"] = (energy["lost"] / energy["duration"] if energy["lost"] is not None else None, "W", "loss in the window, mean")
    if isinstance(run.summary.get("engagements"), list):
        for sprocket in ("driver", "driven"):
            engaged = run.engagements(sprocket, window=True)
            for column, (unit, meaning) in IMPACTS.items():
                values = engaged[column].astype(float)
                for which, value in (("mean", values.mean()), ("largest", values.max())):
                    found[f"{sprocket}_{column}_{which}"] = (value, unit, f"{meaning} on the {sprocket if sprocket == 'driver' else 'driven sprocket'}, {which}")
    if run.acoustics.get("observers"):
        heard = run.acoustics["observers"]
        one = next((o for o in heard if o.get("name") == "microphone"), heard[0])
        found["noise"] = (one.get("level_a"), "dB(A)", f"noise at {one.get('name')}")
    if "total" in run.summary.get("cpu_seconds", {}):
        found["cpu_seconds"] = (run.summary["cpu_seconds"]["total"], "s", "CPU time")
    return {name: about for name, about in found.items() if isinstance(about[0], numbers.Real) and np.isfinite(float(about[0]))}


def compare(runs: Sequence[Run]) -> pd.DataFrame:
    """The figures of several runs side by side, with their differences.

    A frame with a row per figure and columns `meaning`, `unit`, one for each run (its folder), and for each but
    the first `... difference` from the first one and `... difference in %`.
    """
    found, columns = [figures(run) for run in runs], names(runs)
    rows = list(dict.fromkeys(name for one in found for name in one))
    about = {name: next(one[name] for one in found if name in one) for name in rows}
    frame = pd.DataFrame({"meaning": [about[n][2] for n in rows], "unit": [about[n][1] for n in rows]}, index=pd.Index(rows, name="figure"))
    for column, one in zip(columns, found):
        frame[column] = [one[name][0] if name in one else np.nan for name in rows]
    for column in columns[1:]:
        frame[f"{column} difference"] = frame[column] - frame[columns[0]]
        frame[f"{column} difference in %"] = 100. * (frame[column] / frame[columns[0]].where(frame[columns[0]] != 0.) - 1.)
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
