# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels as still pictures, for print and where no script runs. Colours are those of the page's style sheet."""
from __future__ import annotations

import html
import math

import numpy as np
import numpy.typing as npt

from chaindrive.report.figure import PRINTED, Curve, Panel, Range, thin
from chaindrive.run import Array

WIDTH, HEIGHT = 480, 290
LEFT, RIGHT, TOP, BOTTOM = 58, 12, 12, 42
DASHES = ("", "6 3", "2 2", "8 3 2 3", "1 3")


def ticks(low: float, high: float, log: bool, most: int = 7) -> list[float]:
    """Values on an axis at round numbers."""
    if log:
        first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
        steps = (1., 2., 5.) if last - first <= 3 else (1.,)
        every = max(1, (last - first) // most)
        found = [s * 10. ** e for e in range(first, last + 1, every) for s in steps]
    else:
        raw = (high - low) / most
        size = 10. ** math.floor(math.log10(raw))
        step = next(s * size for s in (1., 2., 2.5, 5., 10.) if s * size >= raw * (1 - 1e-9))
        found = [step * k for k in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]
    return [value for value in found if low * (1 - 1e-9) <= value <= high * (1 + 1e-9) or not log]


def label(value: float) -> str:
    """A number beside an axis."""
    text = f"{value:.6g}"
    return "0" if abs(value) < 1e-12 else text.replace("-", "−") if "e" not in text else text


class Axis:
    """From values to points of the picture."""

    def __init__(self, limits: Range, log: bool, start: float, end: float) -> None:
        self.log, self.start, self.end = log, start, end
        self.low, self.high = limits
        self.ends = (math.log10(self.low), math.log10(self.high)) if log else limits

    def __call__(self, values: npt.ArrayLike) -> Array:
        """Points of the picture; nan for what a logarithmic axis does not have."""
        numbers: Array = np.asarray(values, float)
        if self.log:
            numbers = np.log10(np.where(numbers > 0., numbers, np.nan))
        return self.start + (self.end - self.start) * (numbers - self.ends[0]) / (self.ends[1] - self.ends[0])


def path(x: Array, y: Array) -> str:
    """Points as a path that is broken where there is no number."""
    words, pen = [], False
    for a, b in zip(x.tolist(), y.tolist()):
        if math.isfinite(a) and math.isfinite(b):
            words.append(f"{'L' if pen else 'M'}{a:.1f} {b:.1f}")
            pen = True
        else:
            pen = False
    return "".join(words)


def draw(panel: Panel, name: str) -> str:
    """The panel as an svg element; `name` is its own in the page."""
    x_range, y_range = panel.ranges()
    x, y = Axis(x_range, panel.log_x, LEFT, WIDTH - RIGHT), Axis(y_range, panel.log_y, HEIGHT - BOTTOM, TOP)
    out = [f'<svg class="still" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{html.escape(panel.title or panel.y)}">',
           f'<clipPath id="{name}"><rect x="{LEFT}" y="{TOP}" width="{WIDTH - LEFT - RIGHT}" height="{HEIGHT - TOP - BOTTOM}"/></clipPath>']
    grid, texts = [], []
    for value in ticks(*x_range, panel.log_x):
        at = float(x(value))
        grid.append(f"M{at:.1f} {TOP}V{HEIGHT - BOTTOM}")
        texts.append(f'<text x="{at:.1f}" y="{HEIGHT - BOTTOM + 15}" text-anchor="middle">{label(value)}</text>')
    for value in ticks(*y_range, panel.log_y, 6):
        at = float(y(value))
        grid.append(f"M{LEFT} {at:.1f}H{WIDTH - RIGHT}")
        texts.append(f'<text x="{LEFT - 6}" y="{at + 4:.1f}" text-anchor="end">{label(value)}</text>')
    out.append(f'<path class="grid" d="{"".join(grid)}"/><g clip-path="url(#{name})">')
    for number, curve in enumerate(panel.curves):
        out.append(_curve(curve, x, y, number, panel))
    out.append("</g>")
    for value, text in panel.marks:
        if x_range[0] <= value <= x_range[1]:
            at = float(x(value))
            out.append(f'<path class="mark" d="M{at:.1f} {TOP}V{HEIGHT - BOTTOM}"/>'
                       f'<text class="mark" text-anchor="end" transform="translate({at - 3:.1f} {TOP + 2}) rotate(-90)">{html.escape(text)}</text>')
    middle = (TOP + HEIGHT - BOTTOM) / 2
    out += [*texts, f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 8}" text-anchor="middle">{html.escape(panel.x)}</text>',
            f'<text x="13" y="{middle}" text-anchor="middle" transform="rotate(-90 13 {middle})">{html.escape(panel.y)}</text></svg>']
    return "".join(out)


def _curve(curve: Curve, x: Axis, y: Axis, number: int, panel: Panel) -> str:
    color = f"c{curve.color % 8}"
    if curve.kind == "bars":
        n = max(1, sum(c.kind == "bars" for c in panel.curves))
        which = sum(c.kind == "bars" for c in panel.curves[:number])
        at = x(curve.x)
        width = 0.8 * (np.min(np.abs(np.diff(at))) if len(at) > 1 else 40.) / n
        least, largest = panel.ranges()[1]
        foot = float(y(least if panel.log_y or least > 0. else min(max(0., least), largest)))
        left = at + (which - n / 2) * width
        bars = "".join(f"M{a:.1f} {foot:.1f}V{b:.1f}h{width:.1f}V{foot:.1f}z" for a, b in zip(left, y(curve.y)) if math.isfinite(b))
        return f'<path class="bar {color}" d="{bars}"/>'
    if curve.kind == "band" and curve.low is not None:
        good = np.isfinite(curve.y) & np.isfinite(curve.low)
        up, down = path(x(curve.x[good]), y(curve.y[good])), path(x(curve.x[good][::-1]), y(curve.low[good][::-1]))
        return f'<path class="band {color}" d="{up}{down.replace("M", "L", 1)}z"/>'
    if curve.kind == "points":
        marks = "".join(f"M{a:.1f} {b:.1f}h0" for a, b in zip(x(curve.x).tolist(), y(curve.y).tolist()) if math.isfinite(b))
        return f'<path class="points {color}" d="{marks}"/>'
    points = thin(curve.x, curve.y, PRINTED)
    dash = f' stroke-dasharray="{DASHES[curve.dash % 5]}"' if curve.dash % 5 else ""
    return f'<path class="line {color}" stroke-width="{curve.width}"{dash} d="{path(x(points[0]), y(points[1]))}"/>'
