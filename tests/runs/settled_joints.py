# SPDX-License-Identifier: LGPL-2.1-or-later
"""settled_joints.py PROGRAM: at a settled start of elastic bodies no joint carries more or less than its links pull with: the forces at
both pins of each outer link are the same within 6 % of the largest, and that is the tension of the tight span within 5 % (the start
corrects to 3 % of what joints are placed for). In an empty folder."""
import sys

import h5py
import numpy as np

import program
from program import REPOSITORY, check

PROGRAM = sys.argv[1]
FILE = REPOSITORY / "prm/verification/hard.prm"
SHORT = {
    "Drive/Layout/Start": "settled", "Model/Fidelity": "reduced", "Mesh/Refinement": 0, "Model/Stiffness from": "parts",
    "Loads/Driver speed in rad/s": 45, "Contact/Friction coefficient": 0, "Drive/Layout/Centre distance from": "slack",
    "Time/End time in ms": 0.02, "Output/Window start in ms": 0, "Output/History interval in us": 10, "Output/Field interval in ms": 0,
}
# worn, and taut: forces at the pins of one link were once apart by half of the largest
WORN = {**SHORT, "Drive/Chain/Designation": "08B", "Drive/Number of links": 34, "Drive/Driver teeth": 13, "Drive/Driven teeth": 17,
        "Drive/Chain/Elongation in percent": 1.5, "Drive/Layout/Start phase": 0.962, "Drive/Layout/Slack in mm": 0.03,
        "Loads/Resisting torque in N m": 49.76, "Model/Symmetry model": "false", "Effects/Tooth compliance": "off"}
HEAVY = {**SHORT, "Drive/Chain/Designation": "08B", "Drive/Number of links": 26, "Drive/Driver teeth": 15, "Drive/Driven teeth": 11,
         "Drive/Layout/Start phase": 0.67, "Drive/Layout/Slack in mm": 0.2, "Loads/Resisting torque in N m": 64.51, "Model/Symmetry model": "true"}
CASES = {
    "worn, exact": WORN,
    "heavy load, exact": {**HEAVY, "Drive/Layout/Tight span": "lower"},
    "heavy load, penalty": {**HEAVY, "Contact/Enforcement": "penalty"},
    "heavy load, full": {**HEAVY, "Model/Fidelity": "full", "Model/Elastic sprockets": "off", "Mesh/Roller/Cells around": 24},
}

for name, entries in CASES.items():
    program.run(FILE, entries, "--output", "run", program=PROGRAM)
    with h5py.File("run/histories.h5") as histories:
        pins = np.array(histories["joints/bush_pin_force"][0])
        tight = float(histories["spans/tight_tension"][0])
    outer = [(pins[k], pins[(k + 1) % len(pins)]) for k in range(1, len(pins), 2)]
    apart = max(abs(a - b) for a, b in outer) / pins.max()
    print(f"{name}: tight span {tight:.0f} N, largest force in a joint {pins.max():.0f} N, pins of one link apart by {100 * apart:.1f} % of it")
    check(apart < 0.06, f"{name}: pins of one outer link carry forces that are {100 * apart:.0f} % of the largest apart")
    check(abs(pins.max() / tight - 1) < 0.05, f"{name}: a joint carries {pins.max():.0f} N where the tight span has {tight:.0f} N")
