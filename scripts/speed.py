#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""CPU time of the paper's drive on one core: 30 ms of the simple and the layered model at their
default time steps without field output, and how it grows with the number of links. Prints a table
with the medians of several runs.

usage: scripts/speed.py [RUNS] [PROGRAM]
"""
import statistics
import sys
import tempfile

import program

runs = int(sys.argv[1]) if len(sys.argv) > 1 else 3
which = sys.argv[2] if len(sys.argv) > 2 else program.PROGRAM


def measure(model, overrides):
    """Median CPU seconds of the loop's phases (start-up and output not counted) and of everything."""
    loops, totals = [], []
    for _ in range(runs):
        with tempfile.TemporaryDirectory() as folder:
            entries = {"Output/Field interval in ms": 0, **overrides}
            program.run(f"prm/paper/{model}.prm", entries, "--quiet", "--output", folder, program=which)
            summary = program.summary(folder)
        seconds = summary["cpu_seconds"]
        totals.append(seconds["total"])
        loops.append(sum(seconds.get(phase, 0.) for phase in
                         ("internal_force", "time_integration", "contact_algorithm")))
    return statistics.median(loops), statistics.median(totals), summary["steps"]


print(f"{'model':<10}{'links':>6}{'steps':>9}{'forces and motion (s)':>23}{'per link and step (ns)':>24}"
      f"{'whole run (s)':>15}")
for model in ("simple", "layered"):
    for links in (55 if model == "simple" else 56, 110, 220):  # layered: even
        overrides = {} if links == 110 else {"Drive/Number of links": links,
                                             "Drive/Layout/Centre distance from": "slack"}
        loop, total, steps = measure(model, overrides)
        print(f"{model:<10}{links:>6}{steps:>9}{loop:>23.2f}{loop / links / steps * 1e9:>24.1f}"
              f"{total:>15.2f}")
