#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""CPU time of the paper's drive on one core: 30 ms of the simple and the layered model at their
default time steps without field output, and how it grows with the number of links. Prints a table
with the medians of several runs. With --drives the same of 20 ms of drives with wheels, guides and
tensioners beside it, and what start and outputs take.

usage: scripts/speed.py [RUNS] [PROGRAM] [--drives]
"""
import statistics
import sys
import tempfile

import program

words = [word for word in sys.argv[1:] if word != "--drives"]
runs = int(words[0]) if words else 3
which = words[1] if len(words) > 1 else program.PROGRAM


def measure(file, overrides):
    """Medians of CPU seconds: {"loop": forces and motion, "output", "start", "total"}; links; steps."""
    found = []
    for _ in range(runs):
        with tempfile.TemporaryDirectory() as folder:
            entries = {"Output/Field interval in ms": 0, **overrides}
            program.run(file, entries, "--quiet", "--output", folder, program=which)
            summary = program.summary(folder)
        seconds = summary["cpu_seconds"]
        loop = sum(seconds.get(phase, 0.) for phase in ("internal_force", "time_integration", "contact_algorithm"))
        output = seconds["output"]
        found.append({"loop": loop, "output": output, "start": seconds["total"] - loop - output, "total": seconds["total"]})
    medians = {name: statistics.median(one[name] for one in found) for name in found[0]}
    return medians, summary["drive"]["links"], summary["steps"]


def drives():
    """The table of --drives."""
    print(f"{'drive':<12}{'model':<9}{'links':>6}{'steps':>8}{'forces and motion':>19}{'outputs':>9}{'start (s)':>11}")
    for file in ("paper/simple", "drives/conveyor", "drives/timing", "drives/motorcycle", "drives/elevator"):
        for model in ("simple", "layered"):
            entries = {"Model/Fidelity": model, "Time/End time in ms": 20, "Output/Window start in ms": 10,
                       "Output/Window end in ms": "auto", "Output/History interval in us": 50}
            seconds, links, steps = measure(f"prm/{file}.prm", entries)
            loop, output = (seconds[name] / links / steps * 1e9 for name in ("loop", "output"))
            print(f"{file.split('/')[1] if 'paper' not in file else 'paper':<12}{model:<9}{links:>6}{steps:>8}{loop:>19.1f}{output:>9.1f}"
                  f"{seconds['start']:>11.2f}", flush=True)


if "--drives" in sys.argv:
    drives()
    sys.exit()
print(f"{'model':<10}{'links':>6}{'steps':>9}{'forces and motion (s)':>23}{'per link and step (ns)':>24}"
      f"{'whole run (s)':>15}")
for model in ("simple", "layered"):
    for links in (55 if model == "simple" else 56, 110, 220):  # layered: even
        overrides = {} if links == 110 else {"Drive/Number of links": links,
                                             "Drive/Layout/Centre distance from": "slack"}
        seconds, _, steps = measure(f"prm/paper/{model}.prm", overrides)
        loop, total = seconds["loop"], seconds["total"]
        print(f"{model:<10}{links:>6}{steps:>9}{loop:>23.2f}{loop / links / steps * 1e9:>24.1f}"
              f"{total:>15.2f}")
