# SPDX-License-Identifier: LGPL-2.1-or-later
"""Folders of runs that were made, and what tests expect of errors."""
import json
import pathlib

import h5py
import pytest

import chaindrive


def folder(name, time, datasets, summary=()):
    """A folder as a run leaves it, with these datasets {path: (values, unit)}."""
    path = pathlib.Path(name)
    path.mkdir()
    (path / "parameters.prm").write_text("subsection Drive\n  set Driver teeth = 10\n  set Driven teeth = 20\nend\n"
                                         "subsection Output\n  set Quantities = speeds\nend\n")
    start = {"window": {"start": float(time[0]), "end": float(time[-1])}, "drive": {"pitch_time": 0.01, "links": 40}}
    (path / "summary.json").write_text(json.dumps({**start, **dict(summary)}))
    with h5py.File(path / "histories.h5", "w") as file:
        file["time"] = time
        for dataset, (values, unit) in datasets.items():
            file[dataset] = values
            file[dataset].attrs["unit"] = unit
    return chaindrive.open(path)


def refused(words, action):
    """The sentence of the RunError that `action` ends with has these words."""
    with pytest.raises(chaindrive.RunError) as error:
        action()
    assert all(word in str(error.value) for word in words), f"'{error.value}' does not say {words}"
    assert str(error.value).endswith(".")
