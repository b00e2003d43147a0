# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is missing, damaged or foreign is said in a sentence."""
import pathlib
import shutil

import h5py
import numpy as np
import pytest

import chaindrive
from made import refused


@pytest.fixture(scope="module")
def one(run):
    """A run that has not all histories."""
    return run("some", {"Output/Quantities": "speeds, tensions, roller motion", "Output/Rollers": "0, 5"})


@pytest.fixture
def copy(one):
    """The folder of a copy of the run, to be damaged."""
    return pathlib.Path(shutil.copytree(one.folder, "copy"))


def test_what_was_not_asked_for(one):
    refused(("tooth forces", "Output/Quantities", "speeds, tensions, roller motion"), lambda: one["rollers/driver_force"])
    refused(("joint forces", "fidelity"), lambda: one["joints/roller_bush_force"])
    refused(("no column 6", "Output/Rollers"), lambda: one.column("rollers/velocity_x", 6))
    refused(("'engagements'",), one.engagements)
    assert one.column("rollers/velocity_x", 5).shape == one.time.shape


def test_units_and_entries_that_do_not_exist(one):
    refused(("no unit 'furlong'",), lambda: one.history("spans/tight_tension", units="furlong"))
    refused(("no entry 'Colour'",), lambda: one.parameters["Colour"])


def test_what_is_no_folder_of_a_run():
    refused(("no folder 'nowhere'",), lambda: chaindrive.open("nowhere"))
    pathlib.Path("file").write_text("")
    refused(("is a file",), lambda: chaindrive.open("file"))
    pathlib.Path("foreign").mkdir()
    refused(("not the folder of a run",), lambda: chaindrive.open("foreign"))


def test_a_run_that_has_not_finished(one, copy):
    (copy / "summary.json").unlink()
    refused(("has not finished", "--resume"), lambda: chaindrive.open(copy))
    part = chaindrive.open(copy, partial=True)
    assert len(part["spans/tight_tension"]) == len(one.time)
    assert part.summary == {}
    refused(("has not finished",), part.engagements)


def test_a_summary_that_is_cut_off(copy):
    (copy / "summary.json").write_text('{"driven_angle_end": 1.')
    refused(("summary.json", "damaged"), lambda: chaindrive.open(copy).summary)


def test_histories_that_are_cut_off(copy):
    file = copy / "histories.h5"
    file.write_bytes(file.read_bytes()[:20000])
    refused(("histories.h5", "damaged"), lambda: chaindrive.open(copy).time)


def test_histories_that_are_none(copy):
    (copy / "histories.h5").write_text("time, tension")
    refused(("histories.h5", "no HDF5 file"), lambda: chaindrive.open(copy).time)


def test_histories_that_are_not_there(copy):
    (copy / "histories.h5").unlink()
    refused(("histories.h5", "not kept"), lambda: chaindrive.open(copy).time)


def test_rows_that_a_run_has_not_reached_are_left_out(copy):
    with h5py.File(copy / "histories.h5", "r+") as file:  # as it looks while the program runs
        file["time"][300:] = np.nan
    running = chaindrive.open(copy)
    assert len(running.time) == 300 == len(running["spans/tight_tension"])
