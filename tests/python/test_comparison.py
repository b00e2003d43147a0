# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures and parameters of two runs."""
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


def test_entries_that_differ(runs):
    differ = chaindrive.changes(runs)
    assert list(differ.index) == ["Loads/Resisting torque in N m"]
    assert list(differ.loc[differ.index[0]]) == ["150", "75"]


def test_both_are_of_one_drive(runs):
    assert chaindrive.one_drive(runs)
