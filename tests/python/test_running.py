# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drives that are computed from Python give what the command line gives, and say what is wrong in its words."""
import pathlib
import shutil

import numpy as np
import pytest

import chaindrive
from conftest import SHORT
from made import refused

FEW = {"Time/End time in ms": 2, "Output/Window start in ms": 1, "Output/Field interval in ms": 0}


@pytest.fixture(autouse=True)
def _program(request, monkeypatch):
    """The one that is tested."""
    monkeypatch.setenv("CHAINDRIVE_PROGRAM", request.config.getoption("--program"))


@pytest.fixture
def drive(repository):
    """That of the paper, simple and short."""
    return chaindrive.Drive(repository / "prm/paper/simple.prm", SHORT)


def test_the_same_as_the_command_line(drive, simple):
    run = drive.run("results/here")
    assert run.folder == pathlib.Path("results/here") and list(run.histories.index) == list(simple.histories.index)
    for name in run.histories.index:
        assert np.array_equal(run[name], simple[name], equal_nan=True), name


@pytest.mark.filterwarnings("ignore:The window")
def test_entries_and_copies(drive):
    rough = drive.changed({**FEW, "Contact/Friction coefficient": 0.3, "Output/Rollers": [0, 5], "Output/CSV": True})
    rough["Loads/Driver speed in rad/s"] = 94.25
    assert "Contact/Friction coefficient" not in drive.entries and rough["Loads/Driver speed in rad/s"] == 94.25
    run = rough.run("rough")
    assert run.parameters["Friction coefficient"] == "0.3" and run.parameters["Output/Rollers"] == "0, 5"
    assert list(pathlib.Path("rough").glob("*.csv"))
    assert run.drive["sprockets"][0]["speed"] == pytest.approx(94.25)


def test_a_drive_from_its_data():
    designed = chaindrive.Drive.designed("10B", (21, 63), 500, 1450, kW=3)
    plan = designed.plan()
    assert "10B" in plan and "21" in plan
    run = designed.changed({"Time/End time in ms": 4, "Output/Window start in ms": 2}).run("designed")
    assert run.parameters["Driven teeth"] == "63" and [one["teeth"] for one in run.drive["sprockets"]] == [21, 63]
    refused(("kW",), lambda: chaindrive.Drive.designed("10B", (21, 63), 500, 1450, kW=3, Nm=2))


def test_what_the_program_refuses(drive, repository):
    with pytest.raises(chaindrive.RunError, match="Did you mean 'Contact/Friction coefficient'"):
        drive.changed({"Contact/Friction coeficient": 0.1}).plan()
    refused(("Number of links = 111",), lambda: drive.changed({"Drive/Number of links": 111, "Model/Fidelity": "layered"}).run("odd"))
    with pytest.raises(chaindrive.RunError, match="no parameter file .nowhere.prm."):
        chaindrive.Drive("nowhere.prm").plan()
    assert not pathlib.Path("odd").exists()


def test_warnings(drive):
    with pytest.warns(UserWarning, match="The window"):
        drive.changed(FEW).run("short")


def test_on_two_ranks(drive, simple):
    run = drive.run("two", ranks=2)
    assert np.array_equal(run["spans/tight_tension"], simple["spans/tight_tension"])


@pytest.mark.filterwarnings("ignore:The window")
def test_several_at_a_time(drive):
    drives = {str(mu): drive.changed({**FEW, "Contact/Friction coefficient": mu}) for mu in (0.1, 0.2, 0.3)}
    runs = chaindrive.run_all(drives, "several", cores=2)
    assert list(runs) == list(drives)
    assert [run.parameters["Friction coefficient"] for run in runs.values()] == list(drives)
    drives["0.2"]["Contact/Friction coefficient"] = -1
    shutil.rmtree("several")
    refused(("0.2: ", "Friction coefficient = -1"), lambda: chaindrive.run_all(drives, "several", cores=2))
    assert chaindrive.open("several/0.3").finished


def test_no_program(drive, monkeypatch):
    monkeypatch.setenv("CHAINDRIVE_PROGRAM", "/nowhere/chaindrive")
    refused(("There is no program '/nowhere/chaindrive'",), drive.plan)
