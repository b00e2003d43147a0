# SPDX-License-Identifier: LGPL-2.1-or-later
"""The notebook: as Jupyter writes it but without outputs, and its cells run and give what runs of the command line give."""
import json
import pathlib
import subprocess

import numpy as np
import pytest

import chaindrive


@pytest.fixture
def notebook(repository):
    return json.loads((repository / "python/fan.ipynb").read_text())


def test_form(notebook):
    assert (notebook["nbformat"], notebook["nbformat_minor"]) == (4, 5)
    assert len({cell["id"] for cell in notebook["cells"]}) == len(notebook["cells"])
    for cell in notebook["cells"]:
        assert cell["cell_type"] in ("code", "markdown") and cell["source"]
        assert cell["cell_type"] == "markdown" or (cell["outputs"] == [] and cell["execution_count"] is None), "outputs are not kept"


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_cells(notebook, request, monkeypatch, capsys):
    program = request.config.getoption("--program")
    monkeypatch.setenv("CHAINDRIVE_PROGRAM", program)
    names = {}
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), cell["id"], "exec"), names)
    printed = capsys.readouterr().out
    assert "17 teeth: tight span" in printed and "25 teeth" in printed
    assert pathlib.Path("comparison.html").stat().st_size > 1e5

    # the same by the command line
    made = subprocess.run([program, "template", "--chain=08B", "--teeth=17/34", "--centre=400", "--rpm=1000", "--kW=1"],
                          capture_output=True, text=True, check=True)
    pathlib.Path("fan.prm").write_text(made.stdout)
    subprocess.run([program, "fan.prm", "--quiet", "--set", "Model/Stiffness from=dimensions", "--output", "by_hand"], check=True)
    by_hand = chaindrive.open("by_hand")
    assert np.array_equal(by_hand["spans/tight_tension"], names["tension"].to_numpy()[:, 0])
    assert len(names["peaks"]) == by_hand.summary["impacts"]["driver"]["number"]
    # a smaller sprocket pulls more for the same power, by far more than chance
    row = names["table"].loc["tight_tension_mean"]
    assert row["25 difference"] + row["25 difference uncertainty"] < 0
    assert row["25 certainty"] == "not paired"
