# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures as they are meant: panels with curves, from which svg.py and page.js draw."""
from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from chaindrive.run import Array

#: Points of a curve that the page keeps, and of those that it prints.
KEPT, PRINTED = 1500, 600

#: The least and the largest value of an axis.
Range = tuple[float, float]


@dataclasses.dataclass
class Curve:
    """A curve: `kind` is line, points, bars or band (from `y` to `low`).

    `color` counts through the palette, `dash` through kinds of lines, so that curves can be told apart without
    colours.
    """

    label: str
    x: Array
    y: Array
    color: int = 0
    dash: int = 0
    kind: str = "line"
    low: Optional[Array] = None
    width: float = 1.4


@dataclasses.dataclass
class Panel:
    """Axes with curves. `marks` are vertical lines: (x, label)."""

    x: str
    y: str
    curves: list[Curve]
    title: str = ""
    marks: list[tuple[float, str]] = dataclasses.field(default_factory=list)
    log_x: bool = False
    log_y: bool = False
    x_range: Optional[Range] = None
    y_range: Optional[Range] = None

    def ranges(self) -> tuple[Range, Range]:
        """The least and the largest value of each axis, which the figure finds."""
        if self.x_range is None or self.y_range is None:
            raise ValueError(f"the panel {self.title} is in no figure")
        return self.x_range, self.y_range


@dataclasses.dataclass
class Figure:
    """Panels beside each other, or below each other on a narrow screen, with what they show in a title and a sentence.

    Panels with the same labels of axes have the same axes. `missing`: sentences in the place of what there
    is not.
    """

    key: str
    title: str
    sentence: str
    panels: list[Panel]
    missing: list[str] = dataclasses.field(default_factory=list)

    def __post_init__(self) -> None:
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

    def legend(self) -> list[tuple[str, int, int, str]]:
        """Each label once, with its look."""
        looks: dict[str, tuple[int, int, str]] = {}
        for panel in self.panels:
            for curve in panel.curves:
                if curve.label:
                    looks.setdefault(curve.label, (curve.color, curve.dash, curve.kind))
        return [(label, *look) for label, look in looks.items()]


def limits(arrays: Iterable[npt.ArrayLike], log: bool, margin: float) -> Range:
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


def thin(x: Array, y: Array, n: int) -> tuple[Array, Array]:
    """At most about `n` points of a curve that look the same.

    The least and the largest value of pieces of equal width, in the order in which they come. `x` must grow.
    """
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


def rounded(values: npt.ArrayLike, scale: float) -> list[float | None]:
    """Numbers as short texts can hold them: to a twenty-thousandth of `scale`; None for what is no number."""
    digits = max(0, 5 - math.ceil(math.log10(scale))) if scale > 0. else 3
    numbers = np.round(np.asarray(values, float), digits).tolist()
    numbers = [int(v) if v == v and abs(v) < 1e15 and v == int(v) else v for v in numbers]
    return [v if v == v and abs(v) != math.inf else None for v in numbers]


def significant(values: npt.ArrayLike) -> list[float | None]:
    """Numbers with five digits each, for logarithmic axes."""
    return [float(f"{v:.4e}") if math.isfinite(v) else None for v in np.asarray(values, float)]


def as_data(panel: Panel) -> dict[str, Any]:
    """What page.js draws."""
    curves, (x_range, y_range) = [], panel.ranges()
    for curve in panel.curves:
        x, y = (curve.x, curve.y) if curve.kind in ("bars", "band") else thin(curve.x, curve.y, KEPT)
        short_x = significant(x) if panel.log_x else rounded(x, x_range[1] - x_range[0])
        short_y = significant(y) if panel.log_y else rounded(y, y_range[1] - y_range[0])
        one = {"n": curve.label, "c": curve.color, "d": curve.dash, "k": curve.kind, "w": curve.width, "x": _steps(short_x), "y": short_y}
        if curve.low is not None:
            one["l"] = rounded(curve.low, y_range[1] - y_range[0])
        curves.append(one)
    return {"x": panel.x, "y": panel.y, "xr": list(x_range), "yr": list(y_range), "xl": panel.log_x, "yl": panel.log_y,
            "c": curves, "m": [[x, label] for x, label in panel.marks]}


def _steps(numbers: list[float | None]) -> dict[str, Any] | list[float | None]:
    """Numbers of an arithmetic series as [first, step, how many]."""
    known = [number for number in numbers if number is not None]
    if len(known) == len(numbers) > 4:
        step = (known[-1] - known[0]) / (len(known) - 1)
        off = np.abs(np.asarray(known) - known[0] - step * np.arange(len(known)))
        if off.max() < 0.02 * abs(step):
            return {"first": known[0], "step": step, "n": len(known)}
    return numbers
