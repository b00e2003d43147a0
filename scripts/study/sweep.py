# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study against one of its entries (Study/Against): curves of its outputs, and against the driver's speed the orders of
tooth frequency at each speed, with the resonances that the design data of the drive predict."""
import math

import matplotlib
import numpy as np

import outputs
import wear
from chaindrive.drive import span_title

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "study"
import matplotlib.pyplot as plt
from matplotlib.colors import LogNorm
from PIL import Image

SPEED = "Loads/Driver speed in rad/s"
RPM = 30 / math.pi  # per rad/s
HIGHEST = 6  # order that is shown
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")  # Okabe and Ito, for all eyes
MARKS = "osD^vX"


class Sweep:
    """The variants of a study as curves: {label: variants by rising abscissa}."""

    def __init__(self, study):
        self.study, self.path = study, study.about["against"]
        self.is_speed = self.path == SPEED
        self.label = "driver speed (rpm)" if self.is_speed else self.path.split("/")[-1]
        self.curves = {}
        apart = self._apart()
        for variant in sorted(study.variants, key=self.abscissa):
            label = ", ".join(variant["changes"][path] for path in apart)
            self.curves.setdefault(label, []).append(variant)

    def abscissa(self, variant):
        return float(variant["changes"][self.path]) * (RPM if self.is_speed else 1.)

    def _apart(self):
        """Entries whose values tell curves apart: variants of one abscissa differ in them, and not only as in one before."""
        kept = []
        for path in self.study.variants[0].get("changes", {}):
            if path != self.path and len(self._groups([*kept, path])) > len(self._groups(kept)):
                kept.append(path)
        return kept

    def _groups(self, paths):
        """By how many values of `paths` variants of one abscissa differ, as pairs."""
        return {(self.abscissa(v), *(v["changes"][p] for p in paths)) for v in self.study.variants}

    def results(self, variant):
        """Folders of the runs of a variant that have come to their end."""
        done = self.study.done(variant)
        return [self.study.directory / run["folder"] for run in variant["runs"] if run["phase"] in done]

    def resonances(self):
        """[(what, Hz, rpm at which the tooth frequency meets it)] of the drive, from the figures of its slowest run."""
        if not self.is_speed:
            return []
        first = min((v for v in self.study.variants if self.results(v) and self.abscissa(v) > 0), key=self.abscissa, default=None)
        if first is None:
            return []
        drive = outputs.chaindrive.open(self.results(first)[0]).drive
        found = [("driven inertia on the tight span", drive["driven_frequency"], drive["driven_resonance"] * RPM)]
        found += [(span_title(span), span["frequency"], span["resonance"] * RPM) for span in drive["spans"]]
        return [(what, frequency, speed) for what, frequency, speed in found if frequency and speed]


def plain(text):
    """`text` as Matplotlib draws it: neither a formula between dollars, nor hidden by a first underscore."""
    return (" " if text.startswith("_") else "") + text.replace("$", r"\$")


def order_amplitudes(time, values, period, begin, end):
    """Amplitudes of `values` [same unit] at orders of the frequency 1/`period`, from as many whole periods as fit between
    `begin` and `end` [s], and these orders. Samples need not be equally apart: between them values are linear."""
    n = int((end - begin) / period + 1e-6)
    if n < 1:
        return np.array([]), np.array([])
    per_period = max(4 * HIGHEST, math.ceil(period / np.median(np.diff(time))))
    at = begin + np.arange(n * per_period) * period / per_period
    spectrum = np.abs(np.fft.rfft(np.interp(at, time, values))) * 2 / len(at)
    return np.arange(len(spectrum)) / n, spectrum


def tension_orders(folder):
    with outputs.Run(folder) as run:
        if "spans/tight_tension" not in run:
            return np.array([]), np.array([])
        return order_amplitudes(run.time, run["spans/tight_tension"], run.pitch_time, run.start, run.end)


def sound_orders(folder):
    """Of the first observer, Pa; none where the run computed no noise."""
    run = outputs.Run(folder)
    if not run.acoustics:
        return np.array([]), np.array([])
    spectrum = run.sound("spectrum")
    return spectrum.index.to_numpy() * run.pitch_time, np.sqrt(2 * spectrum.iloc[:, 0].to_numpy())


def draw(sweep, file, dpi=100):
    """A panel for each output: a curve for each combination of the other entries, with intervals over phases."""
    study = sweep.study
    names = [c for c in study.columns if not c.endswith(" Hz")]
    columns = min(2, len(names)) or 1
    rows = math.ceil(len(names) / columns) or 1
    figure, axes = plt.subplots(rows, columns, figsize=(4.6 * columns, 2.7 * rows), squeeze=False, layout="constrained")
    every = [sweep.abscissa(v) for v in study.variants]
    marked = [(speed / order, order) for what, _, speed in sweep.resonances() if what.startswith("driven") for order in (1, 2, 3)
              if min(every) <= speed / order <= max(every)]
    for axis, name in zip(axes.flat, names):
        for (label, variants), colour, mark in zip(sweep.curves.items(), COLOURS * 9, MARKS * 9):
            at = np.array([sweep.abscissa(v) for v in variants])
            value, low, high = (np.array([v["row"][f"{name}{end}"] for v in variants]) for end in ("", " low", " high"))
            axis.plot(at, value, mark + "-", color=colour, ms=3.5, lw=1.2, label=plain(label))
            known = np.isfinite(low)
            axis.vlines(at[known], low[known], high[known], color=colour, lw=1)
        for speed, order in marked:
            axis.axvline(speed, color="0.5", lw=0.8, ls=":" if order > 1 else "--", zorder=0)
            axis.annotate(str(order), (speed, 0.99), xycoords=("data", "axes fraction"), fontsize=7, color="0.4", va="top")
        unit = study.about["units"].get(name, "1")
        axis.set(title=name.replace("_", " ") + (f" ({unit})" if unit != "1" else ""), xlabel=plain(sweep.label))
        if max(every) > 5 * min(every) > 0:
            axis.set_xscale("log")
            ticks = [t for t in (200, 300, 500, 700, 1000, 1500, 2000, 3000, 4000) if 0.99 * min(every) <= t <= 1.01 * max(every)]
            axis.set_xticks(ticks if sweep.is_speed else axis.get_xticks(), minor=False)
            axis.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
            axis.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
            axis.tick_params(axis="x", labelsize=7)
        axis.title.set_fontsize(9)
        axis.grid(color="0.92", lw=0.6)
    for axis in axes.flat[len(names):]:
        axis.set_visible(False)
    if len(sweep.curves) > 1:
        axes.flat[0].legend(fontsize=7, frameon=False)
    _save(figure, file, dpi)


def draw_orders(sweep, file, dpi=100):
    """The waterfall: amplitudes at orders of tooth frequency, a row for each speed, of the tight span's tension and of the
    sound where there is one; lines where the resonances lie. Nothing is drawn, and False returned, without such data."""
    panels = []
    for what, unit, decades, read in (("tight tension", "N", 3, tension_orders), ("sound pressure", "Pa", 4, sound_orders)):
        for label, variants in sweep.curves.items():
            rows = [(sweep.abscissa(v), *read(sweep.results(v)[0])) for v in variants
                    if sweep.results(v) and sweep.abscissa(v) > 0]  # a drive that stands has no tooth frequency
            rows = [row for row in rows if len(row[1]) > 1]
            if len({row[0] for row in rows}) > 1 and any(row[2][row[1] >= 0.5].max() > 0 for row in rows):
                panels.append((", ".join(filter(None, (what, label))) + f", amplitude ({unit})", decades, rows))
    if not panels or not sweep.is_speed:
        return False
    columns = min(2, len(panels))
    height = math.ceil(len(panels) / columns)
    figure, axes = plt.subplots(height, columns, figsize=(4.6 * columns, 3.6 * height), squeeze=False, layout="constrained")
    for axis, panel in zip(axes.flat, panels):
        _waterfall(sweep, figure, axis, *panel)
    for axis in axes.flat[len(panels):]:
        axis.set_visible(False)
    _save(figure, file, dpi)
    return True


def _waterfall(sweep, figure, axis, title, decades, rows):
    speeds = np.array([row[0] for row in rows])
    middles = np.sqrt(speeds[1:] * speeds[:-1])
    edges = np.concatenate([[speeds[0] ** 2 / middles[0]], middles, [speeds[-1] ** 2 / middles[-1]]])
    above = np.concatenate([row[2][row[1] >= 0.5] for row in rows])
    norm = LogNorm(above.max() / 10. ** decades, above.max())
    for (_, orders, amplitudes), low, high in zip(rows, edges, edges[1:]):
        step, shown = orders[1], (orders > 0.2) & (orders < HIGHEST + 0.5)
        picture = axis.pcolormesh(np.append(orders[shown] - step / 2, orders[shown][-1] + step / 2), [low, high],
                                  np.maximum(amplitudes[shown], norm.vmin)[np.newaxis], norm=norm, cmap="cividis",
                                  rasterized=True)
    at = np.geomspace(edges[0], edges[-1], 200)
    for (what, _, meets), style in zip(sweep.resonances(), ("-", "--", ":")):
        order = meets / at
        inside = (order > 0.2) & (order < HIGHEST + 0.4)
        if inside.sum() > 1:
            axis.plot(order[inside], at[inside], style, color="white", lw=1.2, label=what)
    axis.set(xlim=(0.2, HIGHEST + 0.4), yscale="log", title=plain(title), xlabel="order of tooth frequency", ylabel=sweep.label,
             ylim=(edges[0], edges[-1]))
    shown = speeds if len(speeds) < 9 else [s for s in speeds if any(abs(s / t - 1) < 0.02 for t in (200, 300, 600, 870, 1500, 2000, 4000))]
    axis.set_yticks(shown, [f"{s:.0f}" for s in shown], minor=False)
    axis.yaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    axis.title.set_fontsize(9)
    figure.colorbar(picture, ax=axis, shrink=0.9)
    if axis.get_legend_handles_labels()[0]:
        axis.legend(fontsize=7, labelcolor="white", frameon=False, loc="upper right")


def draw_wear(sweep, file, dpi=100):
    """Elongation over hours, of a study of wear; nothing is drawn, and False returned, of others."""
    found = wear.curves(sweep) if wear.applies(sweep.study.about) else []
    if not found:
        return False
    figure, axis = plt.subplots(figsize=(6, 3.6), layout="constrained")
    wear.draw(found, axis, COLOURS * 9, MARKS * 9, plain)
    _save(figure, file, dpi)
    return True


def _save(figure, file, dpi):
    svg = str(file).endswith("svg")
    figure.savefig(file, dpi=dpi, metadata={"Date": None} if svg else None)
    plt.close(figure)
    if not svg:  # half the size in a document, and no difference to the eye
        with Image.open(file) as picture:
            small = picture.convert("RGB").quantize(256)
        small.save(file, optimize=True)


def tables(sweep, heading, number):
    """(head, body) of the resonances and of each curve. A row that ends early has its last cell across the rest."""
    study, found = sweep.study, []
    if sweep.resonances():
        found.append((["what may resonate", "first frequency (Hz)", "tooth frequency meets it at (rpm)", "its second order (rpm)"],
                      [[what, number(hertz), number(speed), number(speed / 2)] for what, hertz, speed in sweep.resonances()]))
    if wear.applies(study.about):
        found += wear.tables(wear.curves(sweep))
    for label, variants in sweep.curves.items():
        head = [sweep.label + (f", {label}" if label else ""), *(heading(study, c) for c in study.columns), "CPU (s)"]
        found.append((head, [[number(sweep.abscissa(v)), v["row"]["message"]] if v["row"]["not valid"] else
                             [number(sweep.abscissa(v)), *(number(v["row"][c]) for c in study.columns), number(v["row"]["cpu"], 3)]
                             for v in variants]))
    return found
