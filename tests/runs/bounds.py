# SPDX-License-Identifier: LGPL-2.1-or-later
"""bounds.py PROGRAM REPOSITORY: results at the bounds of what may be asked for: the longest chain, and samples closer than
steps."""
import pathlib
import sys

import program
from program import check

PROGRAM = sys.argv[1]


def run(directory, **entries):
    entries = {"Time/End time in ms": 0.02, "Output/Window start in ms": 0, "Output/Field interval in ms": 0, **entries}
    return program.run("prm/paper/simple.prm", entries, "--output", directory, program=PROGRAM)


def lines(directory, group):
    return pathlib.Path(f"{directory}/histories_{group}.csv").read_text().splitlines()


longest = {"Drive/Number of links": 10000, "Drive/Layout/Centre distance from": "slack", "Drive/Layout/Slack in mm": 1}
run("longest", **longest, **{"Output/CSV": "true"})
columns = lines("longest", "links")[0].split(",")
check(columns[10000] == "tension 9999 [N]", f"the last of {len(columns)} columns is {columns[10000]}")

said = run("close", **{"Output/History interval in us": 1e-9, "Output/CSV": "true"})
steps = program.summary("close")["steps"]
check(f"every step is a sample, {steps + 1} in all" in said, f"it does not say how many samples there are\n{said}")
check(len(lines("close", "hubs")) == steps + 2, f"{len(lines('close', 'hubs')) - 1} samples in {steps} steps")
file, text = (sum(f.stat().st_size for f in pathlib.Path("close").glob(name)) for name in ("histories.h5", "*.csv"))
check(file < 2 * text, f"histories.h5 has {file} bytes, the same as text {text}")
