# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stresses of plates, of histories that are known."""
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import chaindrive
from made import folder, refused

ENTRIES = {"Waist ratio": 0.5, "Inner plate height in mm": 10, "Inner plate thickness in mm": 2, "Outer plate height in mm": 8,
           "Outer plate thickness in mm": "auto"}
TIME = np.linspace(0., 0.06, 601)


@pytest.fixture
def plates():
    """The folder of a run in which roller k touches at 15 + 10 k ms: what link j = k - 1 has in the 10 ms before tells j, and
    everything else is far off."""
    links, far = np.arange(40), 1e9
    before = np.array([(TIME >= 0.005 + 0.01 * (j + 1) - 1e-9) & (TIME <= 0.015 + 0.01 * (j + 1) + 1e-9) for j in links]).T
    wave = np.sin(2 * np.pi * 400. * TIME)[:, None]
    histories = {"links/tension": (1000. + links + wave, "N"),
                 "plates/axial_stress": (30e6 + links + wave, "Pa"),
                 "plates/bending_in_plane": (4e6 * wave + 0. * links, "Pa"),
                 "plates/bending_out_of_plane": (-3e6 - links, "Pa"),
                 "plates/principal_1": (20e6 + links, "Pa"),
                 "plates/principal_2": (-5e6 - links, "Pa")}
    folder("plates", TIME, {path: (np.where(before, values, far), unit) for path, (values, unit) in histories.items()},
           {"engagements": [["driver", k, 0.015 + 0.01 * k, 1., 1., 1., 1., True] for k in range(5)]})
    file = pathlib.Path("plates/parameters.prm")
    file.write_text(file.read_text() + "subsection Drive\n  subsection Chain\n" +
                    "".join(f"    set {name} = {value}\n" for name, value in ENTRIES.items()) + "  end\nend\n")
    return file.parent


def test_stresses_before_each_touch(plates):
    found = chaindrive.plate_stresses(chaindrive.open(plates), 4)
    assert list(found.index) == [39, 0, 1, 2]
    assert list(found["kind"]) == ["outer", "inner", "outer", "inner"]
    for link, row in list(found.iterrows())[1:]:
        expected = {"axial": 30e6 + link, "out_of_plane": 3e6 + link, "principal_1": 20e6 + link, "principal_2": -5e6 - link}
        for name, value in expected.items():
            assert row[name] == pytest.approx(value, rel=0, abs=0.1), f"link {link}: {name}"
        assert row["in_plane"] == pytest.approx(4e6 / np.sqrt(2.), rel=2e-2)
    assert found["nominal"][2] == pytest.approx(1002. / (2 * 0.5 * 10e-3 * 2e-3), rel=0, abs=10.)
    assert np.isnan(found["nominal"][1])  # its dimensions are not known


def test_a_run_without_stresses(simple):
    refused(("no history 'plates/axial_stress'", "plate stress"), lambda: chaindrive.plate_stresses(simple))


def test_a_run_without_engagements():
    early = folder("early", TIME, {}, {"engagements": []})
    refused(("no roller meets the driver",), lambda: chaindrive.plate_stresses(early))


def test_figures_py_prints_them(plates, repository):
    said = subprocess.run([sys.executable, "-B", repository / "scripts/figures.py", "--plates", plates], capture_output=True, text=True)
    assert said.returncode == 0, said.stderr
    assert "of nominal" in said.stdout and said.stdout.count("inner") == 3
