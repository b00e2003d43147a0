# SPDX-License-Identifier: LGPL-2.1-or-later
"""drum_of_nodes.py PROGRAM REPOSITORY: the drum of prm/drives/flat-idler.prm on the tight span, where plates of finite elements lie on it
with their nodes. It bears, in the mean, what two spans of that tension that meet at its wrap press it with, as it does in `layered`."""
import pathlib
import sys

import numpy as np

import chaindrive
import program
from drive_run import below, near

PROGRAM, FILE = sys.argv[1], pathlib.Path(sys.argv[2]) / "prm/drives/flat-idler.prm"

for fidelity, symmetry in (("layered", "auto"), ("full", "true")):
    entries = {"Model/Fidelity": fidelity, "Model/Symmetry model": symmetry, "Mesh/Refinement": 0,
               "Drive/Wheels/Order of travel": "driver, driven, idler", "Drive/Wheels/idler/Centre in mm": "190, 62",
               "Drive/Wheels/idler/Flat/Runs on": "plates", "Loads/Resisting torque in N m": 60, "Loads/Driver speed in rpm": 300,
               "Time/End time in ms": 1.5, "Output/Window start in ms": 0.5, "Output/Window end in ms": "auto"}
    program.run(FILE, entries, "--output", fidelity, program=PROGRAM)
    run, summary = chaindrive.open(fidelity), program.summary(fidelity)
    load = np.mean(np.hypot(*(run.values(f"hubs/idler_load_{axis}", *run.window) for axis in "xy")))
    wrap = next(wheel["wrap"] for wheel in run.drive["sprockets"] if wheel["name"] == "idler")
    near(f"{fidelity}: load of the drum over that of its wrap", load / (2 * summary["tight_tension_mean"] * np.sin(wrap / 2)), 1, 0.04)
    below(f"{fidelity}: energy imbalance", summary["energy_imbalance_max"], 1e-4)
