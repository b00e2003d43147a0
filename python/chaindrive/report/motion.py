# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moving side view of a chain: positions of rollers and tensions of links at some instants, small enough for a page."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

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
        moved = _moved(run, f"hubs/{about['name']}", about.get("held"), picked)
        at = _placed(moved, np.array([complex(*about["centre"])]))[:, 0]
        across, up = x[0] - at[0].real, y[0] - at[0].imag
        seated = np.abs(np.hypot(across, up) - radius) < 0.03 * drive["pitch"]
        has_phase = seated.any() and about["teeth"]
        phase = np.angle(np.mean(np.exp(1j * about["teeth"] * np.arctan2(up, across)[seated]))) / about["teeth"] if has_phase else 0.
        turns = run[path][picked] if path in run else about["speed"] * run.time[picked]
        sprockets.append({"name": about["name"], "title": about["title"], "teeth": about["teeth"], "radius": _mm(radius),
                          "x": _track(at.real, moved), "y": _track(at.imag, moved),
                          "angle": np.round(phase + sense * (turns - turns[0]), 4).tolist()})
    guides = []
    for guide in drive.get("guides", []):
        moved = _moved(run, f"guides/{guide['span']}", guide.get("held"), picked)
        at = _placed(moved, np.array([complex(*point) for point in guide["points"]]))
        arm = guide.get("held", {}).get("pivot")
        guides.append({"x": [_track(at[:, k].real, moved) for k in range(at.shape[1])], "y": [_track(at[:, k].imag, moved) for k in range(at.shape[1])],
                       "pivot": [_mm(arm[0]), _mm(arm[1])] if arm else None})
    finite = tension[np.isfinite(tension)]
    high = float(np.percentile(finite, 99.5)) if len(finite) else 1.
    return {"x": (1e5 * x).round().astype(int).tolist(), "y": (1e5 * y).round().astype(int).tolist(),
            "tension": np.nan_to_num(tension).round().astype(int).tolist(), "time": (1e6 * run.time[picked]).round().astype(int).tolist(),
            "sprockets": sprockets, "guides": guides, "roller": _mm(_diameter(run) / 2), "low": round(min(0., float(np.percentile(finite, 0.5)))), "high": round(high) or 1}


#: How a tensioner moves what is on it: from the start by a way, or by a turn about a point; complex numbers of the plane.
Moved = tuple[npt.NDArray[Any], complex | None] | None


def _moved(run: Run, history: str, held: dict[str, Any] | None, picked: npt.NDArray[np.int_]) -> Moved:
    if not held or f"{history}_travel" not in run:
        return None
    by = np.asarray(run[f"{history}_travel"])[picked] - held["travel"]
    return (by * complex(*held["direction"]), None) if "direction" in held else (np.exp(1j * held["sense"] * by), complex(*held["pivot"]))


def _placed(moved: Moved, points: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Points by instant, or at the only one of what stands still."""
    if moved is None:
        return points[np.newaxis, :]
    by, pivot = moved
    return np.asarray(points + by[:, np.newaxis] if pivot is None else pivot + (points - pivot) * by[:, np.newaxis])


def _track(values: npt.NDArray[Any], moved: Moved) -> float | list[float]:
    """In mm: a number of what stands still, else one for each instant."""
    return _mm(values[0]) if moved is None else [_mm(value) for value in values]


def at_instant(track: float | list[float], instant: int) -> float:
    """A coordinate of what may move."""
    return track[instant] if isinstance(track, list) else track


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
    if not about["teeth"]:  # a drum, with a notch that shows how it turns
        turns = angle + np.linspace(0.02, 2 * np.pi - 0.02, 90)
        drum = about["radius"] - roller
        return [(0.9 * drum * np.cos(angle), 0.9 * drum * np.sin(angle)), *zip(drum * np.cos(turns), drum * np.sin(turns))]
    points, pitch = [], 2 * np.pi / about["teeth"]
    for tooth in range(about["teeth"]):
        middle = angle + tooth * pitch
        for k in range(3, -4, -1):  # the seat, an arc about the roller
            turn = np.pi + middle + k * 0.35
            points.append((about["radius"] * np.cos(middle) + roller * np.cos(turn), about["radius"] * np.sin(middle) + roller * np.sin(turn)))
        tip = about["radius"] + 0.45 * roller
        points += [(tip * np.cos(middle + share * pitch), tip * np.sin(middle + share * pitch)) for share in (0.43, 0.57)]
    return points


def _line(guide: dict[str, Any]) -> list[tuple[float, float]]:
    """At the last instant, with the pivot of its arm at the end."""
    points = [(at_instant(a, -1), at_instant(b, -1)) for a, b in zip(guide["x"], guide["y"])]
    return [*points, (guide["pivot"][0], guide["pivot"][1])] if guide["pivot"] else points


def still(frames: dict[str, Any]) -> str:
    """One instant as an svg element, for print."""
    x, y = (np.array(frames[axis][-1]) / 100. for axis in "xy")
    margin = 12.
    lines = [_line(guide) for guide in frames["guides"]]
    across, up = (np.concatenate([one, [point[axis] for line in lines for point in line]]) for axis, one in enumerate((x, y)))
    left, right, low, high = across.min() - margin, across.max() + margin, up.min() - margin, up.max() + margin
    out = [f'<svg class="still chain" viewBox="{left:.1f} {-high:.1f} {right - left:.1f} {high - low:.1f}" role="img" '
           f'aria-label="The chain at the end of the run">']
    for about in frames["sprockets"]:
        points = outline(about, about["angle"][-1], frames["roller"])
        out.append('<path class="sprocket" d="M' + "L".join(f"{a + at_instant(about['x'], -1):.1f} {-b - at_instant(about['y'], -1):.1f}" for a, b in points) + 'z"/>')
    for line in lines:
        out.append('<path class="guide" fill="none" stroke="currentColor" stroke-width="1.5" d="M' + "L".join(f"{a:.1f} {-b:.1f}" for a, b in line) + '"/>')
    span = frames["high"] - frames["low"]
    for k, tension in enumerate(frames["tension"][-1]):
        n = (k + 1) % len(x)
        out.append(f'<path stroke="{color((tension - frames["low"]) / span)}" stroke-width="{7 if k % 2 else 5}" stroke-linecap="round" '
                   f'd="M{x[k]:.1f} {-y[k]:.1f}L{x[n]:.1f} {-y[n]:.1f}"/>')
    out.append(f'<path class="rollers" stroke-width="{0.9 * frames["roller"]:.1f}" d="' + "".join(f"M{a:.1f} {-b:.1f}h0" for a, b in zip(x, y)) + '"/></svg>')
    return "".join(out)
