# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the paper's drive, simple and short, that tests of the package read."""
import pathlib

import pytest

import chaindrive
import program

SHORT = {"Time/End time in ms": 16, "Output/Window start in ms": 8, "Output/Field interval in ms": 0}


def pytest_addoption(parser):
    parser.addoption("--program", default=str(program.PROGRAM), help="chaindrive, that of build/ by default")


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path, monkeypatch):
    """Every test writes into a folder of its own."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture(scope="session")
def run(request, tmp_path_factory):
    """run(NAME, {"Section/Entry": value}): a run in a folder of that name; the next time that of the first."""
    root, runs = tmp_path_factory.mktemp("runs"), {}

    def of(name, entries=()):
        if name not in runs:
            program.run("prm/paper/simple.prm", {**SHORT, **dict(entries)}, "--quiet", "--output", root / name,
                        program=request.config.getoption("--program"))
            runs[name] = dict(entries)
        assert runs[name] == dict(entries), f"two runs have the name {name}"
        return chaindrive.open(root / name)

    return of


@pytest.fixture(scope="session")
def simple(run):
    """The drive as it is."""
    return run("simple")


@pytest.fixture
def repository():
    """The folder of the sources."""
    return pathlib.Path(program.REPOSITORY)
