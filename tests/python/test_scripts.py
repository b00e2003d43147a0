# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scripts that read results with the package: figures.py draws and refuses."""
import pathlib
import subprocess
import sys

import pytest


@pytest.fixture
def figures(repository):
    return lambda *words: subprocess.run([sys.executable, "-B", repository / "scripts/figures.py", *words], capture_output=True, text=True)


def test_it_draws(figures, simple):
    drawn = figures("--simple", simple.folder, "--full", simple.folder, "--output", ".")
    assert drawn.returncode == 0, drawn.stderr
    assert "R12 full" in drawn.stdout
    assert pathlib.Path("velocities.png").stat().st_size > 5000


def test_it_refuses_what_is_no_run(figures, simple):
    for words, sentence in (((("nowhere", simple.folder), "There is no folder 'nowhere'")), ((simple.folder, "."), "not the folder of a run")):
        done = figures("--simple", words[0], "--full", words[1])
        assert done.returncode == 2
        assert sentence in done.stderr and "Traceback" not in done.stderr
