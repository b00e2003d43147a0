# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moving side view of a chain: positions of rollers and tensions of links at some instants, small enough for a page."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from chaindrive.errors import RunError
from chaindrive.run import Run

#: Red, green and blue, from 0 to 255.
Color = tuple[int, int, int]

FRAMES = 200
#: Of cividis, which people with any colour vision read alike.
LIGHT = ((0, 34, 78), (53, 69, 108), (102, 105, 112), (148, 142, 119), (200, 183, 104), (254, 232, 56))

#: The same, lighter where it is dark, for a dark page.
DARK = ((74, 116, 190), (110, 128, 168), (141, 141, 146), (172, 164, 138), (211, 194, 116), (254, 232, 56))


def frames_of(run: Run) -> dict[str, Any]:
    """What page.js plays: positions in hundredths of a millimetre, tensions in newtons, time in microseconds.

    RunError where not all rollers are in the histories.
    """
    labels = run.labels("rollers/position_x")
    if len(labels) != run.n_links:
        raise RunError(f"There is no moving picture of the run in '{run.folder}': its histories have {len(labels)} of {run.n_links} rollers. "
                       "Output/Rollers = all keeps them.")
    drive = run.drive
    if "sprockets" not in drive:
        raise RunError(f"There is no moving picture of the run in '{run.folder}': its summary does not say what the drive is.")
    start = max(run.time[0], run.time[-1] - 20 * run.pitch_time)
    rows = run.rows(start)
    count = rows.stop - rows.start
    step = max(1, -(-count // FRAMES))  # equal steps of rows are read at once
    picked = np.arange(rows.start, rows.stop, step)
    x, y = (run.dataset(f"rollers/position_{axis}")[rows.start:rows.stop:step] for axis in "xy")
    tension = run.dataset("links/tension")[rows.start:rows.stop:step] if "links/tension" in run else np.zeros_like(x)
    sprockets = []
    for about in drive["sprockets"]:
        radius, sense, path = about["pitch_diameter"] / 2, about["sense"], f"hubs/{about['name']}_angle"
        across, up = x[0] - about["centre"][0], y[0] - about["centre"][1]
        seated = np.abs(np.hypot(across, up) - radius) < 0.03 * drive["pitch"]
        phase = np.angle(np.mean(np.exp(1j * about["teeth"] * np.arctan2(up, across)[seated]))) / about["teeth"] if seated.any() else 0.
        turns = run[path][picked] if path in run else about["speed"] * run.time[picked]
        sprockets.append({"name": about["name"], "title": about["title"], "teeth": about["teeth"], "radius": _mm(radius),
                          "x": _mm(about["centre"][0]), "y": _mm(about["centre"][1]),
                          "angle": np.round(phase + sense * (turns - turns[0]), 4).tolist()})
    finite = tension[np.isfinite(tension)]
    high = float(np.percentile(finite, 99.5)) if len(finite) else 1.
    return {"x": (1e5 * x).round().astype(int).tolist(), "y": (1e5 * y).round().astype(int).tolist(),
            "tension": np.nan_to_num(tension).round().astype(int).tolist(), "time": (1e6 * run.time[picked]).round().astype(int).tolist(),
            "sprockets": sprockets, "roller": _mm(_diameter(run) / 2), "low": round(min(0., float(np.percentile(finite, 0.5)))), "high": round(high) or 1}


def _mm(length: float) -> float:
    return round(1e3 * length, 3)


def _diameter(run: Run) -> float:
    try:
        return 1e-3 * run.parameter("Drive/Chain/Roller diameter in mm")
    except RunError:
        return 0.64 * float(run.drive["pitch"])  # auto: about that of all sizes


def color(value: float, stops: Sequence[Color] = LIGHT) -> str:
    """Of a number between 0 and 1."""
    place = min(max(value, 0.), 1.) * (len(stops) - 1)
    first = min(int(place), len(stops) - 2)
    mixed = [a + (b - a) * (place - first) for a, b in zip(stops[first], stops[first + 1])]
    return "#" + "".join(f"{int(round(part)):02x}" for part in mixed)


def outline(about: dict[str, Any], angle: float, roller: float) -> list[tuple[float, float]]:
    """A sprocket as a path in mm, y upwards: seats of the rollers and tips of the teeth between them."""
    points, pitch = [], 2 * np.pi / about["teeth"]
    for tooth in range(about["teeth"]):
        middle = angle + tooth * pitch
        for k in range(3, -4, -1):  # the seat, an arc about the roller
            turn = np.pi + middle + k * 0.35
            points.append((about["radius"] * np.cos(middle) + roller * np.cos(turn), about["radius"] * np.sin(middle) + roller * np.sin(turn)))
        tip = about["radius"] + 0.45 * roller
        points += [(tip * np.cos(middle + share * pitch), tip * np.sin(middle + share * pitch)) for share in (0.43, 0.57)]
    return points


def still(frames: dict[str, Any]) -> str:
    """One instant as an svg element, for print."""
    x, y = (np.array(frames[axis][-1]) / 100. for axis in "xy")
    margin = 12.
    left, right, low, high = x.min() - margin, x.max() + margin, y.min() - margin, y.max() + margin
    out = [f'<svg class="still chain" viewBox="{left:.1f} {-high:.1f} {right - left:.1f} {high - low:.1f}" role="img" '
           f'aria-label="The chain at the end of the run">']
    for about in frames["sprockets"]:
        points = outline(about, about["angle"][-1], frames["roller"])
        out.append('<path class="sprocket" d="M' + "L".join(f"{a + about['x']:.1f} {-b - about['y']:.1f}" for a, b in points) + 'z"/>')
    span = frames["high"] - frames["low"]
    for k, tension in enumerate(frames["tension"][-1]):
        n = (k + 1) % len(x)
        out.append(f'<path stroke="{color((tension - frames["low"]) / span)}" stroke-width="{7 if k % 2 else 5}" stroke-linecap="round" '
                   f'd="M{x[k]:.1f} {-y[k]:.1f}L{x[n]:.1f} {-y[n]:.1f}"/>')
    out.append(f'<path class="rollers" stroke-width="{0.9 * frames["roller"]:.1f}" d="' + "".join(f"M{a:.1f} {-b:.1f}h0" for a, b in zip(x, y)) + '"/></svg>')
    return "".join(out)
