# SPDX-License-Identifier: LGPL-2.1-or-later
"""Key figures of a run, each with a sentence that says what it means."""
from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

import numpy as np

from chaindrive.comparison import uncertainty
from chaindrive.drive import Block, Wheel, span_title
from chaindrive.errors import RunError
from chaindrive.report.text import number, percent, quantity
from chaindrive.run import Array, Run


#: Usual in makers' catalogues: breaking load over the largest tension, where drive/checks.cc has 7 over the mean.
LEAST_SAFETY = 5.
#: Of the energy balance, what valid runs stay below.
MOST_IMBALANCE = 0.005


class Answer:
    """A figure: its name, value in SI units and what it means (HTML).

    `warns`: it is not as it should be. `of_window`: it is found in the window of the means, and no better
    than that. `half`: half of its 95 % interval, in its unit; nan where that is not known.
    """

    def __init__(self, name: str, value: float, unit: str, sentence: str, warns: bool = False,
                 of_window: bool = True, half: float = np.nan) -> None:
        self.name, self.value, self.unit, self.sentence, self.warns, self.of_window = name, value, unit, sentence, warns, of_window
        self.half = half


def statistic(run: Run, name: str, which: str) -> Any:
    """A member of the window statistics; None without."""
    found = run.summary.get("statistics", {}).get(name)
    return found.get(which) if isinstance(found, dict) else None


def in_window(run: Run, path: str) -> Array:
    """A history in the window."""
    if not np.isfinite(run.start):
        raise RunError("The drive had not settled when the run ended: there is no window.")
    return run.values(path, *run.window)


def largest(run: Run, name: str, path: str) -> float | None:
    """The largest value in the window, of all steps where that is known, or else of the samples; None without histories."""
    value = statistic(run, name, "largest")
    try:
        return float(np.nanmax(in_window(run, path))) if value is None else value
    except (RunError, ValueError):
        return None


def answers(run: Run) -> list[Answer]:
    """What can be said of a run."""
    found = []
    others = [functools.partial(other_impact, wheel=wheel) for wheel in run.wheels[1:]]
    makers: list[Callable[[Run], Answer | None]] = [tension, slack, shaft, impact, variation, *others, ripple, losses, wear, resonance, noise, model, quality]
    for make in makers:
        try:
            one = make(run)
        except (RunError, KeyError, IndexError, StopIteration, TypeError, ValueError, ZeroDivisionError):
            continue  # the figures of the section say what is missing
        if one is not None and one.value is not None and np.isfinite(one.value):
            found.append(one)
    return found


def _against(value: float, expected: float, unit: str, what: str) -> str:
    return f"{percent(100. * (value / expected - 1.))} against the {quantity(expected, unit)} {what}" if expected else ""


def foreseen(run: Run, label: str) -> float:
    """Tension of the span with this label from closed forms."""
    return next(float(span["tension"]) for span in run.drive["spans"] if span["label"] == label)


def turned(run: Run) -> bool:
    """The spans have changed their parts: the load drives."""
    return bool(run.summary["slack_tension_mean"] > run.summary["tight_tension_mean"])


def largest_of_spans(run: Run) -> float | None:
    """The largest tension of all spans in the window, N."""
    found = [largest(run, f"{span.history}_tension", f"spans/{span.history}_tension") for span in run.spans]
    return max((value for value in found if value is not None), default=None)


def tension(run: Run) -> Answer:
    """Tension of the tight span, and how far it is from breaking."""
    mean, most, expected = run.summary["tight_tension_mean"], largest(run, "tight_tension", "spans/tight_tension"), foreseen(run, "tight")
    strength, highest = run.drive.get("tensile_strength"), largest_of_spans(run) or mean
    safety = f" The chain breaks at {quantity(strength, 'N')} or more, {number(strength / highest, 3)} times the largest tension" if strength else ""
    warns = bool(strength and highest * LEAST_SAFETY > strength)
    if strength:
        safety += ": it would not hold." if highest >= strength else f", where at least {LEAST_SAFETY:.0f} is usual." if warns else "."
    if turned(run):
        text = f"The slack span pulls more, as when the load drives; while the driver drives, power and speed ask for {quantity(expected, 'N')} here."
        text += f" At most {quantity(most, 'N')} in the window." if most else ""
    else:
        text = _against(mean, expected, "N", "that power and speed ask for") + (f"; at most {quantity(most, 'N')} in the window." if most else ".")
    return Answer("Tension of the tight span", mean, "N", text + safety, warns, half=uncertainty(run, "tight_tension_mean"))


def slack(run: Run) -> Answer:
    """Tension of the slack span, and what it comes from."""
    mean = run.summary["slack_tension_mean"]
    tight, alone, half = run.summary["tight_tension_mean"], foreseen(run, "slack"), uncertainty(run, "slack_tension_mean")
    if turned(run):
        return Answer("Tension of the slack span", mean, "N", f"More than the {quantity(tight, 'N')} of the tight span: the spans have changed their "
                      "parts, as when the load drives. Slack, weight and speed alone would give " + quantity(alone, "N") + ".", half=half)
    text = f"{number(100 * mean / tight, 2)}\u00a0% of that of the tight span. "
    if abs(mean - alone) <= max(0.1 * run.drive["effective_tension"], 0.1 * alone):
        text += "It comes from slack, weight and speed, not from the load, and adds to what shafts and joints carry."
    else:
        text += f"Slack, weight and speed alone would give {quantity(alone, 'N')}: the rest comes from a start, a load that changes or swinging."
    return Answer("Tension of the slack span", mean, "N", text, half=half)


def shaft_loads(drive: Block) -> list[Any]:
    """Loads of the shafts of a drive from closed forms, N; up to 0.2.0 the block had one for all of them."""
    return [one.get("shaft_load", drive["shaft_load"]) for one in drive["sprockets"]]


def loads_are_alike(drive: Block) -> bool:
    """Whether one number says them all, as where the same two spans pull at all sprockets."""
    loads = np.array(shaft_loads(drive), float)
    return bool(np.allclose(loads, loads[0], rtol=1e-9, atol=0., equal_nan=True))


def shaft(run: Run) -> Answer:
    """Load of the driver's shaft."""
    mean, most = statistic(run, "driver_load", "mean"), statistic(run, "driver_load", "largest")
    expected = shaft_loads(run.drive)[0]
    if mean is None:
        name, spans = ("Load of each shaft", "both spans") if loads_are_alike(run.drive) else ("Load of the driver's shaft", "the spans at its ends")
        return Answer(name, expected, "N", f"Resultant of the mean tensions of {spans}, from the closed form; "
                      "the centrifugal tension does not load shafts.", of_window=False)
    return Answer("Load of the driver's shaft", mean, "N", f"{_against(mean, expected, 'N', 'of the closed form')}; at most "
                  f"{quantity(most, 'N')}. Bearings are chosen by it.", half=uncertainty(run, "driver_load_mean"))


def impact(run: Run) -> Answer:
    """Peak forces of rollers that seat on the driver."""
    touches = run.engagements("driver", window=True)
    peak, speed = touches["peak_force"].astype(float), touches["normal_speed"].astype(float)
    return Answer("Impact on the driver", peak.mean(), "N", f"Mean peak force of {len(peak)} rollers that seat, the largest "
                  f"{quantity(peak.max(), 'N')}, with {quantity(speed.mean(), 'm/s', 3)} normal to the tooth. It grows with speed and pitch, and "
                  "with the root of the stiffness of the teeth.", half=uncertainty(run, "driver_peak_force_mean"))


def variation(run: Run) -> Answer | None:
    """How much peak forces vary from roller to roller."""
    peak = run.engagements("driver", window=True)["peak_force"].astype(float)
    if len(peak) < 3:
        return None
    share = peak.std(ddof=1) / peak.mean()
    # of a coefficient of variation of independent normal values (Miller, Communications in Statistics 20, 1991, 3351)
    half = 1.96 * share * np.sqrt((0.5 + share ** 2) / (len(peak) - 1))
    return Answer("Difference from roller to roller", 100. * share, "%", "Standard deviation of these peaks over their "
                  f"mean: the weakest of {len(peak)} has {quantity(peak.min(), 'N')}, the strongest {quantity(peak.max(), 'N')}.", half=100. * half)


def other_impact(run: Run, wheel: Wheel) -> Answer:
    """Peak forces of rollers that seat on a sprocket which is not the driver."""
    peak = run.engagements(wheel.name, window=True)["peak_force"].astype(float)
    return Answer(f"Impact on the {wheel.title}", peak.mean(), "N", f"Mean peak force of {len(peak)} rollers, the largest "
                  f"{quantity(peak.max(), 'N')}.", half=uncertainty(run, f"{wheel.name}_peak_force_mean"))


def ripple(run: Run) -> Answer:
    """How much the driven speed varies."""
    mean = run.summary["driven_speed_mean"]
    deviation = statistic(run, "driven_speed", "deviation")
    deviation = float(np.std(in_window(run, "hubs/driven_speed"))) if deviation is None else deviation
    polygon = run.drive["sprockets"][0]["polygon_effect"]
    half = 100. * uncertainty(run, "driven_speed_deviation") / abs(mean)
    return Answer("Ripple of the driven speed", 100. * deviation / mean, "%", f"Standard deviation over the mean of {quantity(mean, 'rad/s')}. "
                  f"The polygon of the driver makes the chain's speed vary by {number(100 * polygon, 3)}\u00a0% from crest to crest; the inertia on "
                  "the spans passes on more or less of it.", half=half)


def losses(run: Run) -> Answer | None:
    """Power that is lost, and where."""
    if "window_energy" in run.summary:
        energy = run.summary["window_energy"]
        power = energy["lost"] / energy["duration"]
        efficiency = run.summary.get("efficiency")
        most = sorted(((one["power"], name) for name, one in run.summary["losses"].items()), reverse=True)[:2]
        where = "; most in " + " and ".join(f"{name} ({quantity(watt, 'W', 3)})" for watt, name in most if watt > 0.)
    else:
        start, end = run.window
        names = [path for path in run.histories.index if path.startswith("energy/") and path.endswith("_loss")]
        parts = {}
        for path in names:
            values = in_window(run, path)
            parts[path] = (values[-1] - values[0]) / (end - start)
        power, efficiency, where = sum(parts.values()), None, ""
        if not parts:
            return None
        name, watt = max(parts.items(), key=lambda item: float(item[1]))
        where = f"; most by {name.removeprefix('energy/').removesuffix('_loss').replace('_', ' ')} ({quantity(watt, 'W', 3)})"
    share = power / run.drive["power"]
    text = f"{number(100 * share, 2)}\u00a0% of the drive's {quantity(run.drive['power'], 'W')}{where}."
    if efficiency is not None:
        around = uncertainty(run, "efficiency")
        text += f" Efficiency in the window: {number(100 * efficiency, 4)}" + (f" ± {number(100 * around, 2)}" if np.isfinite(around) else "") + "\u00a0%."
    return Answer("Loss", power, "W", text, half=uncertainty(run, "loss"))


def wear(run: Run) -> Answer:
    """Pressure of pins and bushes."""
    pressure, area = run.drive["joint_pressure"], run.drive["bearing_area"]
    most = largest_of_spans(run)
    peak = f", {quantity(most / area, 'Pa', 3)} at the largest tension" if most else ""
    return Answer("Pressure in the joints", pressure, "Pa", f"Of the tension that power and speed ask for, on {quantity(area, 'm2', 3)} of pin and bush{peak}. "
                  "Wear grows with it and with the angle by which joints turn: fewer teeth, more wear.", of_window=False)


def resonance(run: Run) -> Answer:
    """The tooth frequency and the resonance next to it."""
    drive = run.drive
    places = [(drive.get("driven_resonance"), drive.get("driven_frequency"), "the driven inertia on the tight span")]
    places += [(span.get("resonance"), span.get("frequency"), f"the {span_title(span)}") for span in drive["spans"]]
    speed = drive["sprockets"][0]["speed"]
    near = min((p for p in places if p[0]), key=lambda p: float(abs(np.log(p[0] / speed))))
    return Answer("Tooth frequency", drive["tooth_frequency"], "Hz", f"The nearest resonance is that of {near[2]} at {quantity(near[1], 'Hz', 3)}, "
                  f"which the teeth meet at {quantity(near[0], 'rad/s')} of the driver; it runs at {quantity(speed, 'rad/s')}.", of_window=False)


def noise(run: Run) -> Answer | None:
    """Level of the sound, where it was computed."""
    if not run.acoustics:
        return None
    observers = run.acoustics["observers"]
    received = next((o for o in observers if o["name"] == "microphone"), observers[0])
    return Answer("Noise", received["level_a"], "dB(A)", f"Level of the rollers' sound at {received['name']}, {number(received['level'], 3)}\u00a0dB without "
                  "weighting. Housing, shafts and plates are not in it.", half=uncertainty(run, "noise"))


def model(run: Run) -> Answer | None:
    """The error of the model in the peak of impacts, where the drive has been calibrated."""
    peak = run.summary.get("accuracy", {}).get("driver_peak_mean")
    if peak is None:
        return None
    low, high = (f"{100 * peak[end]:+.2g}" for end in ("low", "high"))
    return Answer("Error of this model's impact peaks", 100 * peak["error"], "%", f"95 % interval {low} to {high} %, against contact without "
                  "penalty, as the calibration of this drive has found it. Other errors stand below the statistics of the window.", of_window=False)


def quality(run: Run) -> Answer:
    """The error of the energy balance."""
    error = run.summary["energy_imbalance_max"]
    warns, limit = error > MOST_IMBALANCE, f"{100 * MOST_IMBALANCE:g}\u00a0%"
    return Answer("Error of the energy balance", 100. * error, "%", "The largest in the whole run, of the energy turned over. " +
                  (f"Valid runs stay below {limit}: this one cannot be trusted." if warns else
                   f"Valid runs stay below {limit}: the arithmetic can be trusted so far, the model is another question."), warns,
                  of_window=False)
