# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures and parameters of two runs."""
import json
import math

import pytest

import chaindrive


@pytest.fixture(scope="module")
def runs(run):
    return [run("simple"), run("braked", {"Loads/Resisting torque in N m": 75})]


def test_figures_and_their_differences(runs):
    table = chaindrive.compare(runs)
    torque = [one.summary["driver_torque_mean"] for one in runs]
    row = table.loc["driver_torque_mean"]
    assert row["unit"] == "N m" and row["simple"] == torque[0] and row["braked"] == torque[1]
    assert row["braked difference in %"] == pytest.approx(100 * (torque[1] / torque[0] - 1), rel=0, abs=1e-9)
    assert -60 < row["braked difference in %"] < -40  # half of the torque
    impacts = runs[1].engagements("driver", window=True)["peak_force"]
    assert table.loc["driver_peak_force_largest", "braked"] == pytest.approx(impacts.max(), rel=0, abs=1e-9)


def test_levels_have_intervals(runs):
    heard = [{"name": "front", "level_a": 70.}, {"name": "microphone", "level_a": 81., "level_a_uncertainty": 0.3}]
    quiet = [{"name": "microphone", "level_a": 77., "level_a_uncertainty": 0.4}]
    for one, observers in zip(runs, (heard, quiet)):
        (one.folder / "acoustics.json").write_text(json.dumps({"observers": observers}))
    table = chaindrive.compare([chaindrive.open(one.folder) for one in runs]).loc["noise"]
    assert table["simple"] == 81. and table["simple uncertainty"] == 0.3
    assert table["braked difference"] == -4. and table["braked difference uncertainty"] == pytest.approx(0.5, rel=1e-12)
    assert table["braked certainty"] == "not paired"
    quiet[0]["level_a_uncertainty"] = None  # too few pitch times
    (runs[1].folder / "acoustics.json").write_text(json.dumps({"observers": quiet}))
    table = chaindrive.compare([chaindrive.open(one.folder) for one in runs]).loc["noise"]
    assert math.isnan(table["braked uncertainty"]) and math.isnan(table["braked difference uncertainty"])
    for one in runs:
        (one.folder / "acoustics.json").unlink()


def test_entries_that_differ(runs):
    differ = chaindrive.changes(runs)
    assert list(differ.index) == ["Loads/Resisting torque in N m"]
    assert list(differ.loc[differ.index[0]]) == ["150", "75"]


def test_both_are_of_one_drive(runs):
    assert chaindrive.one_drive(runs)
