#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether `chaindrive plan` foretells what a run costs: for each .prm file, plan and run, the CPU time and the memory
that one foretells and the other takes, as a table of doc/performance.md. A run that is foretold to take longer than
--limit seconds is shortened in proportion, window and all, and planned anew.

usage: scripts/cost.py [--limit SECONDS] [--program PROGRAM] [--within FACTOR] [FILE.prm]...

Without files: all of prm/ that are not studies. With --within the script fails when a prediction is farther off than
that factor."""
import argparse
import pathlib
import re
import sys
import tempfile

import program

COST = re.compile(r"^Cost: (\S+) s of CPU time.* (\d+) steps of (\S+) us.*memory (\S+) MB$", re.MULTILINE)


def plan(file, entries, which):
    """(CPU time [s], time of a step [us], memory [MB]) foretold."""
    found = COST.search(program.run(file, entries, "--plan", program=which))
    program.check(found, f"{file}: the plan says nothing of the cost")
    return tuple(map(float, found.group(1, 3, 4)))


def number(text, entry, otherwise):
    """The value of an entry of a .prm file."""
    found = re.search(rf"^\s*set {re.escape(entry)}\s*=\s*(\S+)", text, re.MULTILINE)
    return float(found[1]) if found else otherwise


def shortened(text, share):
    """Entries that end a run, and begin its window, after this share of it."""
    end, window = number(text, "End time in ms", 30.), number(text, "Window start in ms", 10.)
    return {"Time/End time in ms": round(share * end, 4), "Output/Window start in ms": round(share * window, 4)}


def compare(file, limit, which):
    """The row of the table of one file."""
    text, entries = (program.REPOSITORY / file).read_text(), {}
    foretold = plan(file, entries, which)
    if foretold[0] > limit:
        entries = shortened(text, limit / foretold[0])
        foretold = plan(file, entries, which)
    with tempfile.TemporaryDirectory() as folder:
        program.run(file, entries, "--quiet", "--output", folder, program=which)
        summary = program.summary(folder)
    took, steps = summary["cpu_seconds"], summary["steps"]
    loop = sum(took.get(phase, 0.) for phase in ("internal_force", "time_integration", "contact_algorithm"))
    return {"file": str(file), "until": entries.get("Time/End time in ms"), "foretold": foretold[0], "took": took["total"],
            "step foretold": foretold[1], "step": 1e6 * (took["total"] - took["initiation_and_rest"]) / steps, "loop": loop,
            "memory foretold": foretold[2], "memory": summary["memory_peak"] / 1e6}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limit", type=float, default=60.)
    parser.add_argument("--program", default=program.PROGRAM)
    parser.add_argument("--within", type=float, metavar="FACTOR")
    parser.add_argument("files", nargs="*")
    words = parser.parse_args()
    every = sorted(program.REPOSITORY.glob("prm/**/*.prm"))
    files = words.files or [file.relative_to(program.REPOSITORY) for file in every if file.parent.name != "studies"]

    print("| file | run until (ms) | CPU time foretold (s) | taken (s) | foretold / taken | memory foretold (MB) | taken (MB) |")
    print("|---|---|---|---|---|---|---|")
    off = []
    for file in files:
        row = compare(file, words.limit, words.program)
        ratio = row["foretold"] / row["took"]
        print(f"| {pathlib.Path(file).stem} | {row['until'] or 'its end'} | {row['foretold']:.3g} | {row['took']:.3g} | {ratio:.2f} "
              f"| {row['memory foretold']:.0f} | {row['memory']:.0f} |", flush=True)
        if words.within and not 1. / words.within <= ratio <= words.within:
            off.append(f"{file}: {ratio:.2f} of what it took")
    sys.exit("\n".join(off))


if __name__ == "__main__":
    main()
