# SPDX-License-Identifier: LGPL-2.1-or-later
"""settled_phases.py PROGRAM: a drive whose spans cannot follow the polygon starts settled at any phase of it: mean tensions over the nine
pitches after the first three are those that the load, the sag and the chain's speed need, and from phase to phase the same. In an empty
folder."""
import sys

import program
from program import REPOSITORY, check

PROGRAM = sys.argv[1]
FILE = REPOSITORY / "prm/twelve/10b-25-75.prm"
ENTRIES = {"Model/Stiffness from": "dimensions", "Time/End time in ms": 19.86, "Output/Window start in ms": 4.97, "Output/History interval in us": 20}

for fidelity in ("simple", "layered"):
    means = []
    for phase in (0, 0.25, 0.5, 0.75):
        program.run(FILE, {**ENTRIES, "Model/Fidelity": fidelity, "Drive/Layout/Start phase": phase}, "--output", "run", program=PROGRAM)
        found = program.summary("run")
        means.append((found["tight_tension_mean"], found["slack_tension_mean"]))
        tensions = [span["tension"] for span in found["drive"]["spans"] if span["label"] in ("tight", "slack")]
    tight, slack = (list(values) for values in zip(*means))
    print(f"{fidelity}: tight span {', '.join(f'{t:.1f}' for t in tight)} N, slack span {', '.join(f'{t:.1f}' for t in slack)} N, needed "
          f"{max(tensions):.1f} and {min(tensions):.1f} N")
    check(max(tight) < 1.02 * min(tight), f"{fidelity}: tight span {tight} N")
    check(max(slack) < 1.15 * min(slack), f"{fidelity}: slack span {slack} N")
    check(all(abs(t / max(tensions) - 1) < 0.04 for t in tight), f"{fidelity}: tight span {tight} N instead of {max(tensions)} N")
