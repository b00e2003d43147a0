# SPDX-License-Identifier: LGPL-2.1-or-later
"""blade_of_nodes.py PROGRAM REPOSITORY: the drive of prm/drives/blade.prm with links of finite elements, whose plates slide on the
blade with their nodes. Spring and damper press the blade, in the mean, as the chain leans on it, and it rubs by its coefficient."""
import pathlib
import sys

import numpy as np

import chaindrive
import program
from drive_run import below, near

PROGRAM, FILE = sys.argv[1], pathlib.Path(sys.argv[2]) / "prm/drives/blade.prm"

entries = {"Model/Fidelity": "full", "Model/Stiffness from": "dimensions", "Time/End time in ms": 0.5, "Output/Window start in ms": 0,
           "Output/Window end in ms": "auto", "Output/History interval in us": 2, "Output/Quantities": "speeds, tensions, tooth forces, energy"}
program.run(FILE, entries, "--output", "nodes", program=PROGRAM)
run, summary = chaindrive.open("nodes"), program.summary("nodes")
force, rubbing = (np.asarray(run[f"guides/driver_to_driven_{what}"]) for what in ("force", "friction"))
near("nodes: friction over force", rubbing.mean() / force.mean(), 0.1, 0.001)
# the plan says: 2.789 N m, 28.2 N at the middle of the line
moment = np.asarray(run["guides/driver_to_driven_tensioner_moment"])
near("nodes: moment of the force at the middle of the blade over that of spring and damper", force.mean() * 2.789 / 28.2 / moment.mean(), 1, 0.15)
below("nodes: energy imbalance", summary["energy_imbalance_max"], 1e-4)
below("nodes: momentum imbalance", summary["momentum_imbalance_max"], 1e-9)
