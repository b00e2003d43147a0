# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drives computed with chaindrive, and results read with h5py, numpy and pandas.

    import chaindrive
    run = chaindrive.open("results/simple")
    run.summary["tight_tension_mean"]                       # N, as all units of the files are SI
    run.history("spans/tight_tension", units=("ms", "kN"))  # a frame over time
    run.engagements("driver", window=True)                  # a row per first touch
    chaindrive.compare([run, chaindrive.open("results/layered")])

    drive = chaindrive.Drive("prm/paper/simple.prm", {"Contact/Friction coefficient": 0.2})
    drive.run("results/rough").summary["efficiency"]

Everything that cannot be computed or read is a RunError, a sentence.
"""
from chaindrive import schema
from chaindrive.comparison import changes, compare, one_drive
from chaindrive.errors import RunError
from chaindrive.parameters import Parameters
from chaindrive.plates import plate_stresses
from chaindrive.run import Run, open  # noqa: A004
from chaindrive.running import Drive, run_all
from chaindrive.spectra import harmonics, third_octaves

__all__ = ["Drive", "Parameters", "Run", "RunError", "changes", "compare", "harmonics", "one_drive", "open", "plate_stresses",
           "run_all", "schema", "third_octaves"]
