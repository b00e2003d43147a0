# SPDX-License-Identifier: LGPL-2.1-or-later
"""Histories, units and engagements of a run, against the files themselves."""
import h5py
import numpy as np
import pytest


@pytest.fixture(scope="module")
def file(simple):
    with h5py.File(simple.folder / "histories.h5") as opened:
        yield opened


def test_a_sound_run_has_no_events(simple):
    assert simple.events == []
    assert simple.summary["window"]["valid"] is True


def test_a_chain_that_jumps_is_an_event_in_the_window(run):
    jumped = run("jumped", {"Drive/Layout/Centre distance from": "slack", "Drive/Layout/Slack in mm": 70,
                            "Loads/Resisting torque in N m": 600})
    assert "jumped" in [event["kind"] for event in jumped.events]
    assert jumped.summary["window"]["valid"] is False


def test_columns_and_a_part_in_other_units(simple, file):
    time, tension = file["time"][:], file["links/tension"][:]
    frame = simple.history("links/tension", columns=[7, 3], start=4e-3, end=6e-3, units=("ms", "kN"))
    inside = (time >= 4e-3) & (time <= 6e-3)
    assert list(frame.columns) == [7, 3]
    assert len(frame) == inside.sum() > 50
    np.testing.assert_allclose(frame[3], 1e-3 * tension[inside, 3], rtol=1e-14)
    np.testing.assert_allclose(frame.index, 1e3 * time[inside], rtol=1e-14)
    assert frame.attrs["unit"] == "kN" and frame.attrs["time_unit"] == "ms" and frame.attrs["description"]
    assert simple.history("links/tension").shape == tension.shape


def test_a_group_in_one_frame(simple, file):
    hubs = simple.group("hubs", units="rpm")
    np.testing.assert_allclose(hubs["driven_speed"], file["hubs/driven_speed"][:] * 30 / np.pi)
    assert hubs.attrs["units"]["driven_speed"] == "rpm"
    assert hubs.attrs["units"]["driver_torque"] == "N m"


def test_the_list_of_histories_has_all(simple, file):
    assert len(simple.histories) == sum(len(group) for group in file.values() if isinstance(group, h5py.Group))


def test_engagements_in_the_window(simple):
    touches = simple.engagements("driver", window=True, units=("ms", "mN s"))
    expected = [e for e in simple.summary["engagements"]
                if e["sprocket"] == "driver" and e["complete"] and 8e-3 <= e["time"] <= 16e-3]
    assert len(touches) == len(expected) >= 2
    assert touches["impulse"][1] == pytest.approx(1e3 * expected[1]["impulse"], rel=0, abs=1e-12)
    aligned = simple.aligned_engagements(before=0., after=1e-3)
    assert len(aligned.columns) >= 1
    for number, force in aligned.items():
        assert force.max() == pytest.approx(expected[number]["peak_force"], rel=1e-3)


def test_the_drive(simple):
    assert simple.n_links == 110
    assert simple.sprockets == (15, 42)
    assert simple.parameter("Driver teeth") == 15
    assert simple.pitch_time == pytest.approx(2 * np.pi / (15 * 120.74), rel=0, abs=1e-12)
