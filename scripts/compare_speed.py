#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""compare_speed.py OLD NEW [RUNS [CASE...]]: compares the time of the time loop of two builds of chaindrive.

Each CASE, or all but those of contact without penalty (exact-half, exact, exact-06b and exact-16a), runs RUNS times (7) with both
programs alternately, because the speed of a shared machine changes within minutes. Prints the medians of the CPU time of each phase
in seconds, and the median of the ratios new over old of the pairs.
"""
import statistics
import sys
import tempfile

import program

PHASES = ("internal_force", "time_integration", "contact_algorithm")
QUIET = {
    "Output/Field interval in ms": 0,
    "Output/Checkpoint interval in ms": 0,
    "Output/Window start in ms": 0,
}
CASES = {
    "simple": ("prm/paper/simple.prm", {"Time/End time in ms": 12}),
    "layered": ("prm/paper/layered.prm", {"Time/End time in ms": 6}),
    "reduced": ("prm/paper/reduced-half.prm", {"Reduction/Modes up to in kHz": 60, "Time/End time in ms": 0.4, "Output/History interval in us": 20}),
    "full": ("prm/paper/full-coarse.prm", {"Time/End time in ms": 0.25, "Output/History interval in us": 20}),
}
HALF = {"Model/Fidelity": "reduced", "Model/Symmetry model": "true"}
WITHOUT_PENALTY = {
    "exact-half": ("prm/paper/reduced-half.prm", {"Time/End time in ms": 5}),
    "exact": ("prm/paper/reduced.prm", {"Time/End time in ms": 3}),
    "exact-06b": ("prm/twelve/06b-13-19.prm", {**HALF, "Time/End time in ms": 6}),
    "exact-16a": ("prm/twelve/16a-11-17.prm", {**HALF, "Time/End time in ms": 3}),
}


def seconds(which, case):
    """CPU seconds of each phase of one run, and of all of them."""
    file, entries = (CASES | WITHOUT_PENALTY)[case]
    with tempfile.TemporaryDirectory() as folder:
        program.run(file, {**QUIET, **entries}, "--quiet", "--output", folder, program=which)
        cpu = program.summary(folder)["cpu_seconds"]
    found = {phase: cpu.get(phase, 0.0) for phase in PHASES}
    return {**found, "loop": sum(found.values())}


def main(arguments):
    program.check(len(arguments) >= 2, __doc__)
    old, new = arguments[:2]
    runs = int(arguments[2]) if len(arguments) > 2 else 7
    print(f"{'case':12}{'phase':20}{'old (s)':>9}{'new (s)':>9}{'new / old':>11}{'least':>8}{'most':>8}")
    for case in arguments[3:] or CASES:
        pairs = [(seconds(old, case), seconds(new, case)) for _ in range(runs)]
        for phase in (*PHASES, "loop"):
            before, after = ([pair[i][phase] for pair in pairs] for i in (0, 1))
            if not max(before):
                continue
            ratios = [b / a for a, b in zip(before, after)]
            row = f"{statistics.median(before):9.3f}{statistics.median(after):9.3f}{statistics.median(ratios):11.3f}"
            print(f"{case:12}{phase:20}{row}{min(ratios):8.3f}{max(ratios):8.3f}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
