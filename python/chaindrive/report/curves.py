# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a report, from histories."""
from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt
import pandas as pd

from chaindrive import spectra
from chaindrive.drive import Block, Span, Wheel, span_title, union
from chaindrive.errors import RunError
from chaindrive.report.facts import of_paper
from chaindrive.report.figure import Curve, Figure, Panel, limits
from chaindrive.report.parts import Subject, beside, finite, of_each, together
from chaindrive.run import Array, Label, Run

Subjects = Sequence[Subject]
#: Runs with x and y of a curve.
Done = list[tuple[Subject, tuple[Array, Array]]]

MS = "time (ms)"


def successive(run: Run, n: int = 5) -> list[tuple[int, float, float]]:
    """The first rollers that meet the driver in the window: (roller, time, peak force).

    Or the last ones at all where none does. RunError when there are none.
    """
    found = run.arrivals(n)
    if not found:
        every = run.engagements("driver")[["roller", "time", "peak_force"]]
        found = [(row.roller, row.time, row.peak_force) for row in every[-n:].itertuples()]
    if not found:
        raise RunError(f"In the run in '{run.folder}' no roller meets the driver.")
    return found


def early(subjects: Subjects) -> list[str]:
    """Sentences for runs in whose window no roller meets the driver."""
    done, _ = of_each(subjects, lambda s: (successive(s.run), s.run.arrivals(1)))
    return [f"In the run in '{s.run.folder}' no roller meets the driver between the begin of the window and 1 ms before the end: the rollers shown "
            "met it earlier or later." for s, (_, arrived) in done if not arrived]


def shown(run: Run) -> tuple[float, float]:
    """Begin and end of what figures of the engaging rollers show, s: from the begin of the window on."""
    rollers = successive(run)
    start = run.start if run.arrivals(1) else rollers[0][1] - run.pitch_time
    return max(run.time[0], start), min(run.time[-1], rollers[-1][1] + 1.5 * run.pitch_time)


def over_time(run: Run, path: str, label: Label | None = None, scale: float = 1.,
              part: tuple[float, float] | None = None) -> tuple[Array, Array]:
    """Times, ms, and scaled values of a column of a history."""
    start, end = part or (None, None)
    label = run.labels(path)[0] if label is None else label
    return 1e3 * run.time[run.rows(start, end)], scale * run.column(path, label, start, end)


def has_surface(run: Run) -> bool:
    """Whether the histories have the velocity of a node on the surface of rollers."""
    return "rollers/surface_velocity_normal" in run


# ---- the paper's figures


def velocities(subjects: Subjects) -> Figure:
    """Figures 5 and 7."""
    def panels(run: Run) -> list[Panel]:
        part = shown(run)
        rows = run.rows(*part)
        result = [Panel(MS, name, []) for name in ("along the span (m/s)", "normal to the span (m/s)")]
        for number, (roller, _, _) in enumerate(successive(run)):
            if has_surface(run):
                values = [run.column(f"rollers/surface_velocity_{which}", roller, *part) for which in ("tangential", "normal")]
            else:
                x, y = (run.column(f"rollers/velocity_{axis}", roller, *part) for axis in "xy")
                values = [x * axis[0] + y * axis[1] for axis in (run.along, run.outward)]
            for panel, v in zip(result, values):
                panel.curves.append(Curve(f"roller {number + 1}", 1e3 * run.time[rows], v, number))
        return result

    kinds = {("surface" if has_surface(s.run) else "centre") for s in subjects if _readable(s.run)}
    where = {"surface": "of a node of their surface", "centre": "of their centre of mass"}
    what = " and ".join(where[kind] for kind in sorted(kinds)) or "of their centre of mass"
    figure = beside(subjects, "velocities", "Velocity of five rollers that engage one after the other",
                    f"Velocity {what}. Where a roller seats, its velocity normal to the span jumps; curves that are alike, shifted by "
                    "a pitch time, mean that engagements are alike." + of_paper(subjects, "their Figures 5 (simple model) and 7 (full model)"), panels)
    figure.missing += early(subjects)
    return figure


def _readable(run: Run) -> bool:
    try:
        return bool(len(run.time))
    except RunError:
        return False


def behind_rollers(run: Run, name: str, factor: float) -> list[Curve]:
    """Of the links behind the rollers that engage one after the other."""
    part = shown(run)
    return [Curve(f"behind roller {i + 1}", *over_time(run, name, run.link_behind(roller), factor, part), i)
            for i, (roller, _, _) in enumerate(successive(run))]


def link_forces(subjects: Subjects) -> Figure:
    """Figure 8."""
    def panels(run: Run) -> list[Panel]:
        return [Panel(MS, "tension (kN)", behind_rollers(run, "links/tension", 1e-3))]

    figure = beside(subjects, "link-forces", "Tension of the links behind these rollers",
                    "A link carries the tension of its span until its front roller seats on the driver; then the teeth take the load over." +
                    of_paper(subjects, "their Figure 8"), panels)
    figure.missing += early(subjects)
    return figure


def plate_stress(subjects: Subjects) -> Figure:
    """Figure 9; none without elastic links."""
    def panels(run: Run) -> list[Panel]:
        return [Panel(MS, title, behind_rollers(run, f"plates/{name}", 1e-6))
                for name, title in (("axial_stress", "pull (MPa)"), ("bending_in_plane", "bending in the plane (MPa)"),
                                    ("principal_1", "first principal stress (MPa)"), ("principal_2", "second principal stress (MPa)"))]

    figure = beside(subjects, "plate-stress", "Stress in the side plates of these links",
                    "Mean over the waist of the plate, its bending and the principal stresses in its middle." +
                    of_paper(subjects, "their Figure 9"), panels)
    lumped = [s for s in subjects if s.run.parameters.get("Model/Fidelity") in ("simple", "layered")]
    if len(lumped) == len(subjects):
        figure.missing = ["There are no stresses of plates: links are rigid or bars. Reduced and full fidelity have them."]
    return figure


def contact_forces(subjects: Subjects) -> Figure:
    """Figures 12 and 13."""
    def panels(run: Run) -> list[Panel]:
        part = shown(run)
        curves = []
        for i, (roller, _, _) in enumerate(successive(run)):
            time, force = over_time(run, "rollers/driver_force_peak", roller, 1e-3, part)
            near = np.convolve(force > 0., np.ones(3), "same") > 0  # a touch of one sample has two sides
            curves.append(Curve(f"roller {i + 1}", time, np.where(near, force, np.nan), i))
        return [Panel(MS, "tooth force (kN)", curves)]

    figure = beside(subjects, "contact-forces", "Force between these rollers and the driver",
                    "The first peak is the impact; what follows is the share of the tension that the tooth carries." +
                    of_paper(subjects, "their Figures 12 (full model) and 13 (simple model)"), panels)
    figure.missing += early(subjects)
    return figure


# ---- engagements


def with_wheels(subjects: Subjects) -> list[tuple[Wheel, Subjects]]:
    """Each sprocket of the drives, with the runs that have it."""
    return [(wheel, [s for s in subjects if wheel in s.run.wheels]) for wheel in union(s.run.wheels for s in subjects)]


def aligned(subjects: Subjects) -> Figure:
    """Forces of the engagements in the window, against the time since their touch."""
    def panels(run: Run) -> list[Panel]:
        result = []
        for wheel in run.wheels:
            frame = run.aligned_engagements(wheel.name, before=0.1e-3, after=1.5e-3, units=("ms", "kN"))
            curves = [Curve("single engagements" if i == 0 else "", frame.index.to_numpy(), frame[column].to_numpy(), 7, 0, width=0.6)
                      for i, column in enumerate(frame.columns[:40])]
            if len(curves) > 1:
                curves.append(Curve("their mean", frame.index.to_numpy(), frame.mean(axis=1).to_numpy(), 1, 0, width=2.2))
            if curves:
                result.append(Panel("time since touch (ms)", "tooth force (kN)", curves, wheel.title))
        if not result:
            raise RunError(f"In the run in '{run.folder}' no engagement lies in the window.")
        return result

    return beside(subjects, "aligned", "Engagements laid over each other",
                  "The force on each roller that engages in the window, against the time since its first touch. How far single curves lie from "
                  "their mean is the variation from roller to roller, which listeners hear.", panels)


def peaks(subjects: Subjects) -> Figure:
    """Peak forces of all engagements."""
    def curve(which: str) -> Callable[[Subject], tuple[Array, Array]]:
        def make(subject: Subject) -> tuple[Array, Array]:
            touches = subject.run.engagements(which, window=False)
            touches = touches[touches["complete"].astype(bool)]
            return 1e3 * touches["time"].to_numpy(float), 1e-3 * touches["peak_force"].to_numpy(float)
        return make

    panels, missing = [], []
    for wheel, own in with_wheels(subjects):
        done, sentences = of_each(own, curve(wheel.name))
        missing += sentences
        curves = [Curve(s.name if len(subjects) > 1 else "", x, y, s.color, s.color, "points") for s, (x, y) in done]
        panels.append(Panel("time of the touch (ms)", "peak force (kN)", curves, wheel.title, x_range=limits([c.x for c in curves], False, 0.03)))
    return Figure("peaks", "Peak force of every engagement",
                  "From the start of the run on, in the window and before.", panels, list(dict.fromkeys(missing)))


# ---- the wrap


def _thinning(run: Run, start: float, end: float) -> int:
    """So many samples are passed over that some hundreds are left, at all phases of a pitch time."""
    return max(1, len(run.time[run.rows(start, end)]) // 400)


def pitch_angle(drive: Block, about: Block) -> float:
    """By what a link turns round a wheel, rad; one without teeth has room for no whole number of them."""
    return float(2 * np.pi / about["teeth"] if about["teeth"] else 2 * np.arcsin(drive["loaded_pitch"] / about["pitch_diameter"]))


def round_sprocket(drive: Block, about: Block, x: Array, y: Array) -> tuple[npt.NDArray[np.bool_], Array]:
    """Which points lie on the pitch circle of a sprocket, and their angles, rad.

    In the sense of its rotation, from where the pitch line of the arriving span touches the pitch circle; up to a
    pitch angle before it is negative.
    """
    x, y, pitch = x - about["centre"][0], y - about["centre"][1], pitch_angle(drive, about)
    near = np.abs(np.hypot(x, y) - about["pitch_diameter"] / 2) < 0.2 * drive["pitch"]
    return near, np.mod(about["sense"] * (np.arctan2(y, x) - about["arrival"]) + pitch, 2 * np.pi) - pitch


def along_wrap(run: Run, sprocket: str, bins: int = 4) -> Array:
    """The tooth load on rollers by the pitches that they have passed since the chain met the sprocket.

    Four rows: positions, and mean, tenth and ninetieth percentile in the window, N.
    """
    start, end = run.window if np.isfinite(run.start) else (run.time[0], run.time[-1])
    path = f"rollers/{sprocket}_force"
    run.dataset(path)
    labels = run.labels("rollers/position_x")
    columns = [run.labels(path).index(label) for label in labels]
    every = _thinning(run, start, end)
    x, y = (run.values(f"rollers/position_{axis}", start, end, every) for axis in "xy")
    force = run.values(path, start, end, every)[:, columns]
    about = next(one for one in run.drive["sprockets"] if one["name"] == sprocket)
    near, angle = round_sprocket(run.drive, about, x, y)
    pitch = pitch_angle(run.drive, about)
    position = angle / pitch
    last = about["wrap"] / pitch + 1.
    good = near & (position < last) & np.isfinite(force)
    index = np.floor(position[good] * bins).astype(int)
    values = force[good]
    found = []
    for one in np.unique(index):
        own = values[index == one]
        if len(own) >= 10:
            found.append(((one + 0.5) / bins, own.mean(), *np.percentile(own, (10, 90))))
    if not found:
        raise RunError(f"In the run in '{run.folder}' no roller lies on the sprocket in the window.")
    return np.array(found).T


def wrap(subjects: Subjects) -> Figure:
    """Load of the teeth along all wraps."""
    panels, missing = [], []
    for wheel, own in with_wheels(subjects):
        def load(subject: Subject, which: str = wheel.name) -> Array:
            return along_wrap(subject.run, which)

        done, sentences = of_each(own, load)
        missing += sentences
        curves = []
        for s, (position, mean, low, high) in done:
            name = s.name if len(subjects) > 1 else "mean"
            if len(subjects) == 1:
                curves.append(Curve("80 % of all values", position, 1e-3 * high, s.color, 0, "band", 1e-3 * low))
            curves.append(Curve(name, position, 1e-3 * mean, s.color, s.color, width=2.))
        panels.append(Panel("pitches since the chain met the sprocket", "load of a tooth (kN)", curves, wheel.title,
                            x_range=limits([c.x for c in curves], False, 0.02)))
    return Figure("wrap", "Load of the teeth along the wrap",
                  "Normal force between roller and tooth by the place of the roller on the sprocket, in the window. The teeth next to the "
                  "span that pulls carry most: while the driver drives, its first ones and the last ones of the driven sprocket.", panels, list(dict.fromkeys(missing)))


# ---- spans, shafts


def of_spans(subjects: Subjects, quantity: str, scale: float,
             panel: Callable[[Done, Span], Panel]) -> tuple[list[Panel], list[str]]:
    """A panel for each span of the drives, of a `quantity` of its histories, scaled, and what is missing of the first one."""
    panels, missing = [], []
    for span in union(s.run.spans for s in subjects):
        def curve(subject: Subject, path: str = f"spans/{span.history}_{quantity}") -> tuple[Array, Array]:
            return over_time(subject.run, path, scale=scale)

        done, sentences = of_each([s for s in subjects if span in s.run.spans], curve)
        panels.append(panel(done, span))
        missing.append(sentences)
    return panels, missing[0]


def tensions(subjects: Subjects) -> Figure:
    """Tensions of all spans."""
    def panel(done: Done, span: Span) -> Panel:
        return Panel(MS, "tension (kN)", [Curve(s.name if len(subjects) > 1 else "", x, y, s.color, s.color) for s, (x, y) in done], span.title)

    panels, missing = of_spans(subjects, "tension", 1e-3, panel)
    return Figure("tensions", "Tension of the spans", "Mean of the links in the middle of each span, over the whole run. "
                  "Spans are called tight and slack as they are while the driver drives.", panels, missing)


def offsets(subjects: Subjects) -> Figure:
    """How the middles of all spans swing."""
    def panel(done: Done, span: Span) -> Panel:
        curves = [Curve(s.name if len(subjects) > 1 else "", x, y - np.nanmean(y), s.color, s.color) for s, (x, y) in done]
        return Panel(MS, "offset (mm)", curves, span.title, y_range=limits([c.y for c in curves], False, 0.05))

    panels, missing = of_spans(subjects, "offset", 1e3, panel)
    return Figure("offsets", "Spans in motion", "How the middle of each span swings across its direction of travel, about its mean; each on a scale of its own.", panels, missing)


class Line:
    """The straight line of a span between the pitch circles, m, from the sprocket that is named first in the drive."""

    def __init__(self, span: Block, turned: bool, sense: float) -> None:
        self.title = span_title(span)
        begin, end = np.array(span["begin"], float), np.array(span["end"], float)
        self.length = float(np.hypot(*(end - begin)))
        travel = (end - begin) / self.length
        self._start, self._along = (end, -travel) if turned else (begin, travel)
        self._normal = sense * np.array([travel[1], -travel[0]])  # on the right of a chain that runs counter-clockwise

    def along(self, x: Array, y: Array) -> Array:
        """Places of points along the line, m."""
        place: Array = (x - self._start[0]) * self._along[0] + (y - self._start[1]) * self._along[1]
        return place

    def outward(self, x: Array, y: Array) -> Array:
        """Distances of points from the line on its outer side, m."""
        distance: Array = (x - self._start[0]) * self._normal[0] + (y - self._start[1]) * self._normal[1]
        return distance

    def distance(self, x: Array, y: Array) -> Array:
        """Distances of points from the piece between the pitch circles, m."""
        place = self.along(x, y)
        return np.hypot(self.outward(x, y), place - np.clip(place, 0., self.length))


def lines_of(drive: Block) -> list[Line]:
    """The lines of all spans of a drive; the last one leads back to the driver."""
    last, sense = len(drive["spans"]) - 1, drive["sprockets"][0]["sense"]
    return [Line(span, number == last, sense) for number, span in enumerate(drive["spans"])]


def shapes(subjects: Subjects) -> Figure:
    """Where rollers of the spans are, across the line of the span."""
    def panels(run: Run) -> list[Panel]:
        start, end = run.window if np.isfinite(run.start) else (run.time[0], run.time[-1])
        every = _thinning(run, start, end)
        x, y = (run.values(f"rollers/position_{axis}", start, end, every) for axis in "xy")
        drive, lines = run.drive, lines_of(run.drive)
        free = np.ones(x.shape, bool)
        for about in drive["sprockets"]:
            near, angle = round_sprocket(drive, about, x, y)
            free &= ~(near & (angle > 0.) & (angle < about["wrap"]))
        nearest = np.argmin([line.distance(x, y) for line in lines], axis=0)
        result = []
        for number, line in reversed(list(enumerate(lines))):
            s, d = line.along(x, y), 1e3 * line.outward(x, y)
            bins = np.arange(0., line.length - drive["pitch"] / 2, drive["pitch"])
            near = (s > 0.) & (s < line.length) & (nearest == number) & free
            index = np.digitize(s[near], bins) - 1
            values = d[near]
            found = [((bins[k] + drive["pitch"] / 2), values[index == k].mean(), values[index == k].min(), values[index == k].max())
                     for k in range(len(bins)) if (index == k).sum() > 3]
            if found:
                place, mean, low, high = np.array(found).T
                result.append(Panel("place along the span (mm)", "outward offset (mm)",
                                    [Curve("least to largest", 1e3 * place, high, 0, 0, "band", low), Curve("mean", 1e3 * place, mean, 0, 0, width=2.)],
                                    line.title))
        if not result:
            raise RunError(f"No roller of the run in '{run.folder}' lies in a span: Output/Rollers chooses them.")
        return result

    figure = beside(subjects, "shapes", "Shape of the spans",
                    "Distance of the rollers in the window from the straight line between the pitch circles, outward positive: the mean is the sag, "
                    "the band the motion.", panels)
    for span in union(s.run.spans for s in subjects):  # each span has a scale of its own
        alike = [panel for panel in figure.panels if panel.title.endswith(span.title)]
        curves = [curve for panel in alike for curve in panel.curves]
        for panel in alike:
            panel.y_range = limits([c.y for c in curves] + [c.low for c in curves if c.low is not None], False, 0.05)
    return figure


def shafts(subjects: Subjects) -> Figure:
    """Speed and torque of the shafts."""
    found = []
    for wheel, own in with_wheels(subjects)[1:]:
        def speed(run: Run, path: str = f"hubs/{wheel.name}_speed") -> tuple[Array, Array]:
            return over_time(run, path, scale=30. / np.pi)

        found.append(together(own, "", "", "", MS, f"{wheel.words} speed (rpm)", speed))
    found.append(together(subjects, "", "", "", MS, "driver torque (N m)", lambda run: over_time(run, "hubs/driver_torque")))
    return Figure("shafts", "Speed and torque of the shafts",
                  "The driven shaft follows at the ratio of the teeth; what it deviates is ripple of the polygon and of its own swinging.",
                  [panel for one in found for panel in one.panels], found[0].missing)


# ---- spectra


def marks_of(run: Run) -> list[tuple[float, str]]:
    """What the drive is known to ring at."""
    drive = run.drive
    found = [(drive["tooth_frequency"], "teeth")] if "tooth_frequency" in drive else []
    found += [(span["frequency"], span_title(span)) for span in drive.get("spans", []) if span.get("frequency")]
    if drive.get("driven_frequency"):
        found.append((drive["driven_frequency"], "driven inertia"))
    return found


def amplitudes(run: Run, path: str, label: Label | None = None, scale: float = 1.) -> tuple[Array, Array]:
    """Amplitude of each line in the window, over whole pitch times."""
    lines = run.spectrum(path, label)
    frequency = lines.index.to_numpy()[1:]
    amplitude = scale * np.sqrt(2 * lines["mean_square"].to_numpy()[1:])
    upper = frequency <= max(20. / run.pitch_time, 5000.)
    return frequency[upper], np.maximum(amplitude[upper], 1e-12)


def line_spectra(subjects: Subjects) -> Figure:
    """Spectra of tension, speed, torque and offset."""
    panels, missing = [], []
    speeds = [(f"hubs/{wheel.name}_speed", f"{wheel.words} speed (rpm)", 30. / np.pi) for wheel in union(s.run.wheels[1:] for s in subjects)]
    for path, name, scale in (("spans/tight_tension", "tight tension (N)", 1.), *speeds,
                              ("hubs/driver_torque", "driver torque (N m)", 1.),
                              ("spans/tight_offset", "tight offset (µm)", 1e6)):
        def lines(subject: Subject, which: str = path, factor: float = scale) -> tuple[Array, Array]:
            return amplitudes(subject.run, which, scale=factor)

        done, sentences = of_each(subjects, lines)
        missing += sentences
        curves = [Curve(s.name if len(subjects) > 1 else "", x, y, s.color, s.color) for s, (x, y) in done]
        largest = max((float(c.y.max()) for c in curves), default=1.)
        marks = marks_of(done[0][0].run) if done else []
        panels.append(Panel("frequency (Hz)", name, curves, log_x=True, log_y=True, marks=marks, y_range=(1e-4 * largest, 1.5 * largest)))
    return Figure("spectra", "Spectra of tension, speed and torque",
                  "Amplitude of each line over the window, cut to whole pitch times so that the orders of the tooth frequency do not leak. Vertical "
                  "lines: frequencies that closed forms predict.", panels, list(dict.fromkeys(missing)))


def roller_bands(subjects: Subjects) -> Figure:
    """Third octaves of the velocity of the rollers that engage, from a pitch time before the touch to one after it."""
    def bands(run: Run) -> tuple[Array, Array]:
        interval, period = run.interval(), run.pitch_time
        n = 2 * int(period / interval)
        total = []
        for roller, touch, _ in successive(run, 12):
            if touch - period >= run.time[0] and touch + period <= run.time[-1]:
                part = (touch - period - 4 * interval, touch + period + 4 * interval)
                time = run.time[run.rows(*part)]
                for axis in "xy":
                    values = np.interp(touch + np.linspace(-period, period, n), time, run.column(f"rollers/velocity_{axis}", roller, *part))
                    # without the straight line from end to end, where the period would close with a jump
                    frequency, power = spectra.mean_square_lines(values - np.linspace(values[0], values[-1], n), 2 * period / n)
                    total.append(power)
        if not total:
            raise RunError(f"No roller of the run in '{run.folder}' can be followed from a pitch time before its engagement to one after it.")
        lines = pd.DataFrame({"mean_square": 2 * np.mean(total, axis=0)}, index=frequency)  # of both directions together
        found = spectra.third_octaves(lines, 500., 20000.)
        return found.index.to_numpy(), np.maximum(found["rms"].to_numpy(), 1e-9)

    return together(subjects, "roller-bands", "Vibration of the engaging rollers in third octaves",
                    "R.m.s. velocity in each band, mean over the rollers from a pitch time before the touch to one after it: what a roller does "
                    "beyond its smooth path makes the noise.", "centre of the band (Hz)", "velocity (m/s)", bands, log_x=True, log_y=True)


# ---- noise


def pressures(subjects: Subjects) -> Figure:
    """Sound pressure at the microphone over time."""
    def pressure(run: Run) -> tuple[Array, Array]:
        received = run.sound()
        return 1e3 * received.index.to_numpy(), received.iloc[:, microphone(run)].to_numpy()

    with_noise = [s for s in subjects if s.run.acoustics]
    return together(with_noise, "pressure", "Sound pressure at the microphone", "What it hears of the rollers." +
                    of_paper(subjects, "their Figure 6, as measured"), MS, "pressure (Pa)", pressure)


def microphone(run: Run) -> int:
    """Its number among the observers; the first one where none is called so."""
    names = [observer["name"] for observer in run.acoustics["observers"]]
    return names.index("microphone") if "microphone" in names else 0


def decibels(square: Array) -> Array:
    """Level of a mean square pressure, re 20 uPa."""
    level: Array = 10 * np.log10(np.maximum(square, 1e-20) / 4e-10)
    return level


def noise_spectra(subjects: Subjects) -> Figure:
    """Figures 10 and 11."""
    def lines(run: Run) -> tuple[Array, Array]:
        spectrum = run.sound("spectrum").iloc[1:, microphone(run)]
        return spectrum.index.to_numpy(), decibels(spectrum.to_numpy())

    def bands(run: Run) -> tuple[Array, Array]:
        run.sound("spectrum")
        level = run.acoustics["observers"][microphone(run)]["third_octaves"]
        return finite(np.asarray(run.acoustics["third_octaves"], float), np.asarray(level, float))

    narrow = together(subjects, "", "", "", "frequency (Hz)", "level of a line (dB)", lines, log_x=True)
    wide = together(subjects, "", "", "", "centre of the band (Hz)", "third octave (dB)", bands, log_x=True)
    for panel in narrow.panels + wide.panels:
        top = max(float(np.nanmax(c.y)) for c in panel.curves)
        panel.y_range = (top - 70., top + 5.)
    return Figure("noise-spectra", "Spectrum of the noise at the microphone", "Lines and third octaves of the computed sound pressure, re 20 µPa." +
                  of_paper(subjects, "their Figures 10 (computed) and 11 (measured)"), narrow.panels + wide.panels, narrow.missing or wide.missing)


def directivity(subjects: Subjects) -> Figure:
    """Level by the direction from the engagement."""
    def around(run: Run) -> tuple[Array, Array]:
        found = run.acoustics["directivity"]
        return np.degrees(np.asarray(found["angle"], float)), np.asarray(found["level"], float)

    with_noise = [s for s in subjects if s.run.acoustics]
    return together(with_noise, "directivity", "Level around the engagement",
                    "Sound pressure level by the direction in the plane of the drive, from the point where rollers meet the driver.",
                    "angle (°)", "level (dB)", around)


def noise_engagements(subjects: Subjects) -> Figure:
    """The loudest instant of each pitch time."""
    def one(run: Run) -> tuple[Array, Array]:
        values = np.asarray(run.acoustics["observers"][microphone(run)]["engagement_peaks"], float)
        return np.arange(1., len(values) + 1), values

    with_noise = [s for s in subjects if s.run.acoustics]
    figure = together(with_noise, "noise-peaks", "Loudest instant of each pitch time", "Largest pressure at the microphone in each pitch time of "
                      "the window: engagements are not alike to a listener either.", "pitch time", "largest pressure (Pa)", one)
    for panel in figure.panels:
        for curve in panel.curves:
            curve.kind = "bars"
        panel.y_range = (0., 1.05 * max(float(np.nanmax(c.y)) for c in panel.curves))
        panel.x_range = (0.4, max(len(c.x) for c in panel.curves) + 0.6)
    return figure


# ---- energy


def energies(subjects: Subjects) -> Figure:
    """What the chain stores, and what it has lost."""
    def panels(run: Run) -> list[Panel]:
        stored: list[tuple[str, str]] = []
        lost: list[tuple[str, str]] = []
        for path in run.histories.index:
            name = path.removeprefix("energy/")
            if path.startswith("energy/") and name not in ("imbalance", "drive_work", "resisting_work"):
                (lost if name.endswith("_loss") else stored).append((path, name.removesuffix("_loss").replace("_", " ")))
        if not stored:
            run.dataset("energy/kinetic")
        result, number = [], 0
        for which, title in ((stored, "stored (J)"), (lost, "lost since the start (J)")):
            curves = []
            for path, name in which:
                time, values = over_time(run, path)
                if np.nanmax(np.abs(values)) > 0. and name != "kinetic":
                    curves.append(Curve(name, time, values, number, number))
                    number += 1
            result.append(Panel(MS, title, curves))
        return result

    return beside(subjects, "energies", "Energy", "What the chain stores, without its kinetic energy, and what it has lost since the start, by kind.",
                  panels)
