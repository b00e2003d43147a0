# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures as they are meant: panels with curves, from which svg.py and page.js draw."""
import dataclasses
import math

import numpy as np

#: Points of a curve that the page keeps, and of those that it prints.
KEPT, PRINTED = 1500, 600


@dataclasses.dataclass
class Curve:
    """A curve: `kind` is line, points, bars or band (from `y` to `low`); `color` counts through the palette, `dash` through kinds of
    lines, so that curves can be told apart without colours."""
    label: str
    x: np.ndarray
    y: np.ndarray
    color: int = 0
    dash: int = 0
    kind: str = "line"
    low: np.ndarray = None
    width: float = 1.4


@dataclasses.dataclass
class Panel:
    """Axes with curves. `marks` are vertical lines: (x, label)."""
    x: str
    y: str
    curves: list
    title: str = ""
    marks: list = dataclasses.field(default_factory=list)
    log_x: bool = False
    log_y: bool = False
    x_range: tuple = None
    y_range: tuple = None


@dataclasses.dataclass
class Figure:
    """Panels beside each other, or below each other on a narrow screen, with what they show in a title and a sentence. Panels with the
    same labels of axes have the same axes. `missing`: sentences in the place of what there is not."""
    key: str
    title: str
    sentence: str
    panels: list
    missing: list = dataclasses.field(default_factory=list)

    def __post_init__(self):
        self.panels = [panel for panel in self.panels if any(len(curve.x) for curve in panel.curves)]
        for panel in self.panels:
            alike = [p for p in self.panels if (p.x, p.y) == (panel.x, panel.y)]
            curves = [curve for p in alike for curve in p.curves]
            if panel.x_range is None:
                panel.x_range = limits([curve.x for curve in curves], panel.log_x, 0.)
            if panel.y_range is None:
                lows = [curve.low for curve in curves if curve.low is not None]
                panel.y_range = limits([curve.y for curve in curves] + lows, panel.log_y, 0.05)
                if any(curve.kind == "bars" for curve in curves) and not panel.log_y:
                    panel.y_range = (min(0., panel.y_range[0]), max(0., panel.y_range[1]))

    def legend(self):
        """Each label once, with its look."""
        looks = {}
        for panel in self.panels:
            for curve in panel.curves:
                if curve.label:
                    looks.setdefault(curve.label, (curve.color, curve.dash, curve.kind))
        return [(label, *look) for label, look in looks.items()]


def limits(arrays, log, margin):
    """The range of numbers, with a margin, of positive ones for a logarithmic axis."""
    values = np.concatenate([np.asarray(a, float).ravel() for a in arrays] or [np.zeros(1)])
    values = values[np.isfinite(values) & ((values > 0.) | (not log))]
    if len(values) == 0:
        return (0.1, 1.) if log else (0., 1.)
    low, high = float(values.min()), float(values.max())
    if log:
        return low, max(high * (high / low) ** margin, 1.01 * low)
    gap = margin * (high - low)
    if high == low:
        gap = max(abs(high) * 0.05, 1e-12)
    return low - gap, high + gap


def thin(x, y, n):
    """At most about n points of a curve that look the same: the least and the largest value of pieces of equal width, in the order in
    which they come. x must grow."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    if len(x) <= n:
        return x, y
    edges = np.linspace(0, len(x), n // 2 + 1).astype(int)
    filled = np.where(np.isfinite(y), y, np.inf)
    least = np.array([a + np.argmin(filled[a:b]) for a, b in zip(edges, edges[1:])])
    filled = np.where(np.isfinite(y), y, -np.inf)
    most = np.array([a + np.argmax(filled[a:b]) for a, b in zip(edges, edges[1:])])
    kept = np.unique(np.concatenate([[0], np.minimum(least, most), np.maximum(least, most), [len(x) - 1]]))
    return x[kept], y[kept]


def rounded(values, scale):
    """Numbers as short texts can hold them: to a twenty-thousandth of `scale`; None for what is no number."""
    digits = max(0, 5 - math.ceil(math.log10(scale))) if scale > 0. else 3
    numbers = np.round(np.asarray(values, float), digits).tolist()
    numbers = [int(v) if v == v and abs(v) < 1e15 and v == int(v) else v for v in numbers]
    return [v if v == v and abs(v) != math.inf else None for v in numbers]


def significant(values):
    """Numbers with five digits each, for logarithmic axes."""
    return [float(f"{v:.4e}") if math.isfinite(v) else None for v in np.asarray(values, float)]


def as_data(panel):
    """What page.js draws."""
    curves = []
    for curve in panel.curves:
        x, y = (curve.x, curve.y) if curve.kind in ("bars", "band") else thin(curve.x, curve.y, KEPT)
        short_x = significant(x) if panel.log_x else rounded(x, panel.x_range[1] - panel.x_range[0])
        short_y = significant(y) if panel.log_y else rounded(y, panel.y_range[1] - panel.y_range[0])
        one = {"n": curve.label, "c": curve.color, "d": curve.dash, "k": curve.kind, "w": curve.width, "x": _steps(short_x), "y": short_y}
        if curve.low is not None:
            one["l"] = rounded(curve.low, panel.y_range[1] - panel.y_range[0])
        curves.append(one)
    return {"x": panel.x, "y": panel.y, "xr": list(panel.x_range), "yr": list(panel.y_range), "xl": panel.log_x, "yl": panel.log_y,
            "c": curves, "m": [[x, label] for x, label in panel.marks]}


def _steps(numbers):
    """Numbers of an arithmetic series as [first, step, how many]."""
    if len(numbers) > 4 and None not in numbers:
        step = (numbers[-1] - numbers[0]) / (len(numbers) - 1)
        off = np.abs(np.asarray(numbers) - numbers[0] - step * np.arange(len(numbers)))
        if off.max() < 0.02 * abs(step):
            return {"first": numbers[0], "step": step, "n": len(numbers)}
    return numbers
