# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sprockets and spans of a drive, from the member `drive` of a summary."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

#: The block of the drive, or a part of it.
Block = dict[str, Any]


class Wheel(NamedTuple):
    """A sprocket: its name in histories, and what sentences call it."""

    name: str
    title: str

    @property
    def words(self) -> str:
        """The name as a part of a sentence: "driven" of "driven speed"."""
        return self.name.replace("_", " ")


class Span(NamedTuple):
    """A span: its name in histories, "tight", "slack" or "" as it pulls while the driver drives, and what sentences call it."""

    name: str
    label: str
    title: str

    @property
    def history(self) -> str:
        """How its histories begin: f"spans/{span.history}_tension"."""
        return self.label or self.name


#: Sprockets that a parameter file can ask for, the driver first: those of a run whose summary does not name them.
WHEELS = (Wheel("driver", "driver"), Wheel("driven", "driven sprocket"))


def span_title(span: Block) -> str:
    """What sentences call a span of the block: "tight span", or "span from driver to driven"."""
    return f"{span['label']} span" if span["label"] else "span from " + str(span["name"]).replace("_", " ")


def wheels_of(block: Block) -> tuple[Wheel, ...]:
    """The sprockets of a drive, the driver first, in the direction of travel."""
    try:
        return tuple(Wheel(str(one["name"]), str(one["title"])) for one in block["sprockets"]) or WHEELS
    except (KeyError, TypeError):
        return WHEELS


def spans_of(block: Block) -> tuple[Span, ...]:
    """The spans of a drive, the one that pulls the most first: from that which the driver pulls, against the direction of travel."""
    try:
        found = tuple(Span(str(one["name"]), str(one["label"]), span_title(one)) for one in reversed(block["spans"]))
    except (KeyError, TypeError):
        found = ()
    return found or tuple(Span(name, label, f"{label} span") for name, label in zip(reversed(_span_names()), ("tight", "slack")))


def union(several: Iterable[Sequence[Any]]) -> list[Any]:
    """Sprockets, or spans, of several drives, each of them once."""
    return list(dict.fromkeys(one for drive in several for one in drive))


def _span_names() -> list[str]:
    return [f"{one.name}_to_{WHEELS[(i + 1) % len(WHEELS)].name}" for i, one in enumerate(WHEELS)]


# ---- summaries of earlier versions


def as_now(block: Block, sense: int | None) -> Block:
    """The block of any version as this one writes it.

    Up to 0.2.0 a drive was a driver at the origin, a driven sprocket beside it on the x axis, and one span on
    either side; the name of a sprocket was what is its title now, that of a span its label, and places were not
    said. `sense`: that of the drive, 1 is counter-clockwise; None where nobody knows, and places stay out. A
    block that is of no version stays as it is.
    """
    try:
        sprockets, spans = block["sprockets"], block["spans"]
        if any("title" in one for one in sprockets) or len(sprockets) != len(WHEELS) or [one["name"] for one in spans] != ["slack", "tight"]:
            return block
        named = {"sprockets": [{**one, "name": wheel.name, "title": wheel.title} for one, wheel in zip(sprockets, WHEELS)],
                 "spans": [{**one, "name": name, "label": one["name"]} for one, name in zip(spans, _span_names())]}
        return {**block, **(_with_places(named, float(block["centre_distance"]), sense) if sense else named)}
    except (KeyError, TypeError, ValueError):
        return block


def _with_places(block: Block, distance: float, sense: int) -> Block:
    """Adds centres, senses, angles of arrival and the ends of the spans, m and rad."""
    radii = [0.5 * float(one["pitch_diameter"]) for one in block["sprockets"]]
    centres = np.array([[0., 0.], [distance, 0.]])
    lean = np.arcsin((radii[1] - radii[0]) / distance)
    normals = [np.array([-np.sin(lean), side * np.cos(lean)]) for side in (-sense, sense)]  # outward, of the slack span and the tight one
    arriving = (normals[1], normals[0])
    sprockets = [{**one, "centre": centre.tolist(), "sense": sense, "arrival": float(np.arctan2(normal[1], normal[0]))}
                 for one, centre, normal in zip(block["sprockets"], centres, arriving)]
    touching = [[(centre + radius * normal).tolist() for centre, radius in zip(centres, radii)] for normal in normals]
    spans = [{**block["spans"][0], "begin": touching[0][0], "end": touching[0][1]},
             {**block["spans"][1], "begin": touching[1][1], "end": touching[1][0]}]
    return {"sprockets": sprockets, "spans": spans}
