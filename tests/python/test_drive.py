# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sprockets and spans of a drive, as this version and earlier ones write them."""
import copy
import json

import numpy as np
import pytest

import chaindrive
from chaindrive import drive
from chaindrive.report import curves, motion, parts
from made import folder

NEW_OF_SPROCKETS = ("title", "centre", "sense", "arrival", "inertia", "shaft_load")
NEW_OF_SPANS = ("label", "begin", "end")


def earlier(block):
    """The block as version 0.2.0 writes it."""
    old = copy.deepcopy(block)
    for one in old["sprockets"]:
        one["name"] = one["title"]
        for name in NEW_OF_SPROCKETS:
            del one[name]
    for one in old["spans"]:
        one["name"] = one["label"]
        for name in NEW_OF_SPANS:
            del one[name]
    return old


def of_earlier_version(run, name):
    """A copy of a run with the summary of an earlier version."""
    folder = run.folder.parent / name
    if not folder.exists():
        folder.mkdir()
        for file in ("histories.h5", "parameters.prm"):
            (folder / file).symlink_to(run.folder / file)
        summary = json.loads((run.folder / "summary.json").read_text())
        (folder / "summary.json").write_text(json.dumps({**summary, "drive": earlier(summary["drive"])}))
    return chaindrive.open(folder)


@pytest.fixture(params=["upper", "lower"])
def runs(run, request):
    """A run, and the same as an earlier version would have left it."""
    one = run("simple") if request.param == "upper" else run("lower", {"Drive/Layout/Tight span": "lower"})
    return one, of_earlier_version(one, f"{request.param}-of-0.2.0")


def test_names_of_both_versions(runs):
    for one in runs:
        assert [tuple(wheel) for wheel in one.wheels] == [("driver", "driver"), ("driven", "driven sprocket")]
        assert [tuple(span) for span in one.spans] == [("driven_to_driver", "tight", "tight span"), ("driver_to_driven", "slack", "slack span")]
        assert one.sprockets == (15, 42)
    assert "title" not in runs[1].summary["drive"]["sprockets"][0]


def test_places_of_both_versions(runs):
    new, old = (one.drive for one in runs)
    for one, other in zip(new["sprockets"], old["sprockets"]):
        assert one["sense"] == other["sense"] == (1 if runs[0].outward[1] > 0 else -1)
        assert np.exp(1j * one["arrival"]) == pytest.approx(np.exp(1j * other["arrival"]), abs=1e-9)
        assert one["centre"] == pytest.approx(other["centre"], abs=1e-9)
    for one, other in zip(new["spans"], old["spans"]):
        for end in ("begin", "end"):
            assert one[end] == pytest.approx(other[end], abs=1e-9)


def test_figures_of_both_versions(runs):
    new, old = runs
    for sprocket in ("driver", "driven"):
        assert curves.along_wrap(new, sprocket) == pytest.approx(curves.along_wrap(old, sprocket), rel=1e-3)
    films = [motion.frames_of(one) for one in runs]
    assert films[0] == films[1]


def test_sprockets_turn_with_the_chain(runs):
    """In the first and the last picture alike rollers sit between the teeth."""
    for one in runs:
        frames = motion.frames_of(one)
        for about in frames["sprockets"]:
            for which in (0, len(frames["x"]) // 2, -1):
                x, y = (np.array(frames[axis][which]) / 100. - about[axis] for axis in "xy")
                seated = np.abs(np.hypot(x, y) - about["radius"]) < 0.3
                off = np.angle(np.exp(1j * about["teeth"] * (np.arctan2(y, x) - about["angle"][which])[seated]))
                assert seated.sum() >= 5 and np.abs(off).mean() < 0.3


def test_the_chain_arrives_where_it_is_said(runs):
    """Rollers on both sprockets bear from the first pitch on, and none before it; those of a span lie on its line."""
    for one in runs:
        for wheel in one.wheels:
            position, mean, _, _ = curves.along_wrap(one, wheel.name)
            about = next(s for s in one.drive["sprockets"] if s["name"] == wheel.name)
            last = about["wrap"] * about["teeth"] / (2 * np.pi)
            loaded = position[mean > 0.05 * mean.max()]
            assert -0.6 < loaded.min() < 1. and last - 2. < loaded.max() < last + 1.
        ends = [(np.array(span["begin"]), np.array(span["end"]), span["length"]) for span in one.drive["spans"]]
        assert all(np.hypot(*(end - begin)) == pytest.approx(length, rel=1e-9) for begin, end, length in ends)


def test_what_is_no_drive_stays_as_it_is():
    for block in ({}, {"sprockets": 3}, {"sprockets": [1, 2], "spans": []}, {"sprockets": [{"name": "driver"}] * 2, "spans": [{"name": "slack"}, {"name": "tight"}]}):
        assert drive.as_now(block, 1) is block
        assert drive.wheels_of(block) and drive.spans_of(block)


def of_wheels(sense, places):
    """The block of a drive with sprockets {name: (x, y, radius, turn)}; -1 turns against the drive, which itself may be its mirror image."""
    names, spans, normals = list(places), [], []
    for name, after in zip(names, [*names[1:], names[0]]):
        (x, y, r, turn), (u, v, q, other) = places[name], places[after]
        normal = np.arctan2(v - y, u - x) - np.arccos((turn * r - other * q) / np.hypot(u - x, v - y))  # on the right of the chain
        normals.append(normal)
        ends = [[a + t * b * np.cos(normal), sense * (c + t * b * np.sin(normal))] for a, c, b, t in (places[name], places[after])]
        spans.append({"name": f"{name}_to_{after}", "label": "", "begin": ends[0], "end": ends[1]})
    spans[0]["label"], spans[-1]["label"] = "slack", "tight"
    sprockets = [{"name": name, "title": f"the {name}", "centre": [x, sense * y], "sense": sense * turn, "teeth": 20, "pitch_diameter": 2 * r,
                  "arrival": sense * (normals[i - 1] + (0. if turn > 0 else np.pi)), "wrap": np.mod(turn * (normals[i] - normals[i - 1]), 2 * np.pi),
                  "speed": 10.} for i, (name, (x, y, r, turn)) in enumerate(places.items())]
    return {"sprockets": sprockets, "spans": spans, "pitch": 0.016, "pitch_time": 0.01, "links": 40}


TRIANGLE = {"driver": (0., 0., 0.05, 1), "fan": (0.5, 0., 0.05, 1), "driven": (0.25, 0.4, 0.07, 1)}
#: An idler presses the upper span down, and nearly onto the lower one.
IDLER = {"driver": (0., 0., 0.06, 1), "driven": (0.5, 0., 0.06, 1), "idler": (0.25, 0., 0.05, -1)}


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("places", [TRIANGLE, IDLER])
def test_three_sprockets(sense, places):
    """Points of each span, 3 mm outside of its line, are found as such, and those of the wraps in no span."""
    block = of_wheels(sense, places)
    x, y, rng = [], [], np.random.default_rng(1)
    for span in block["spans"]:
        begin, end = np.array(span["begin"]), np.array(span["end"])
        along = (end - begin) / np.hypot(*(end - begin))
        at = begin + rng.uniform(0.01, 0.99, (2000, 1)) * (end - begin) + 3e-3 * sense * np.array([along[1], -along[0]])
        x, y = [*x, *at[:, 0]], [*y, *at[:, 1]]
    for about in block["sprockets"]:
        angle = about["arrival"] + about["sense"] * rng.uniform(0.01, 0.99, 500) * about["wrap"]
        x, y = ([*values, *(about["centre"][k] + 0.5 * about["pitch_diameter"] * of(angle))] for k, (values, of) in enumerate(((x, np.cos), (y, np.sin))))
    time, of_points = np.arange(2.), lambda values: (np.array([values, values]), "m")
    one = folder("three", time, {"rollers/position_x": of_points(x), "rollers/position_y": of_points(y)}, {"drive": block})
    second, third = list(places)[1:]
    assert one.sprockets == (20, 20, 20) and [wheel.name for wheel in one.wheels] == ["driver", second, third]
    assert [span.history for span in one.spans] == ["tight", f"{second}_to_{third}", "slack"]
    assert [span.title for span in one.spans] == ["tight span", f"span from {second} to {third}", "slack span"]
    found = curves.shapes([parts.Subject(one, "three", 0)])
    assert [panel.title for panel in found.panels] == [span.title for span in one.spans] and not found.missing
    for panel in found.panels:
        band, mean = panel.curves
        assert mean.y == pytest.approx(3., abs=1e-6) and band.low == pytest.approx(3., abs=1e-6) and len(mean.x) > 10
    for about in block["sprockets"]:
        centre, radius = np.array(about["centre"]), 0.5 * about["pitch_diameter"]
        points = [np.array(span[end]) for span in block["spans"] for end in ("begin", "end") if about["name"] in span["name"]]
        assert sum(np.hypot(*(point - centre)) == pytest.approx(radius, rel=1e-9) for point in points) == 2
