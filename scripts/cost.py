#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares the predictions of `chaindrive plan` with runs: CPU time and memory, predicted and taken, for each .prm
file, as a table of doc/performance.md. A run that is predicted to take longer than --limit seconds is shortened in
proportion, including its window, and planned again.

usage: scripts/cost.py [--limit SECONDS] [--program PROGRAM] [--within FACTOR] [--fit] [FILE.prm]...

--fit also prints the ratio of the mean cost of a step to that of the first steps, averaged over runs with elastic
bodies: change_of_elastic of source/cost.cc. Without files: all of prm/ except studies. With --within the script fails
when a prediction is off by more than that factor three times in a row, since other load on the machine may slow
either."""
import argparse
import pathlib
import re
import sys
import tempfile

import program

COST = re.compile(r"^Cost: (?P<total>\S+) s of CPU time.*start-up (?P<start>\S+) s, (?P<steps>\d+) steps of (?P<step>\S+) us"
                  r"(?: \((?P<first>\S+) us at first\))?.*memory (?P<memory>\S+) MB$", re.MULTILINE)


def plan(file, entries, which):
    """What is predicted: total, start, steps, step, memory; first: a step at first [us], of elastic bodies only."""
    found = COST.search(program.run(file, entries, "--plan", program=which))
    program.check(found, f"{file}: the plan says nothing of the cost")
    return {name: float(value) for name, value in found.groupdict().items() if value}


def number(text, entry, otherwise):
    """The value of an entry of a .prm file."""
    found = re.search(rf"^\s*set {re.escape(entry)}\s*=\s*(\S+)", text, re.MULTILINE)
    return float(found[1]) if found and found[1] not in ("auto", "settled") else otherwise


def shortened(text, share):
    """Entries that end a run, and its window, after this share of it."""
    otherwise = {"Time/End time in ms": 30., "Output/Window start in ms": 10., "Output/Window end in ms": None}
    given = {path: number(text, path.split("/")[1], value) for path, value in otherwise.items()}
    return {path: round(share * value, 4) for path, value in given.items() if value is not None}


def compare(file, limit, which):
    """The row of the table of one file."""
    text, entries = (program.REPOSITORY / file).read_text(), {}
    predicted = plan(file, entries, which)
    if predicted["total"] > limit:
        entries = shortened(text, limit / predicted["total"])
        predicted = plan(file, entries, which)
    with tempfile.TemporaryDirectory() as folder:
        program.run(file, entries, "--quiet", "--output", folder, program=which)
        summary = program.summary(folder)
    took = summary["cpu_seconds"]
    outputs = predicted["total"] - predicted["start"] - 1e-6 * predicted["steps"] * predicted["step"]
    loop = took["total"] - took["initiation_and_rest"] - outputs
    return {"until": entries.get("Time/End time in ms"), "predicted": predicted["total"], "took": took["total"],
            "change": 1e6 * loop / summary["steps"] / predicted["first"] if "first" in predicted else None,
            "memory predicted": predicted["memory"], "memory": summary["memory_peak"] / 1e6}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limit", type=float, default=60.)
    parser.add_argument("--program", default=program.PROGRAM)
    parser.add_argument("--within", type=float, metavar="FACTOR")
    parser.add_argument("--fit", action="store_true")
    parser.add_argument("files", nargs="*")
    words = parser.parse_args()
    every = sorted(program.REPOSITORY.glob("prm/**/*.prm"))
    files = words.files or [file.relative_to(program.REPOSITORY) for file in every if file.parent.name != "studies"]

    print("| file | run until (ms) | CPU time predicted (s) | taken (s) | predicted / taken | memory predicted (MB) | taken (MB) |")
    print("|---|---|---|---|---|---|---|")
    off, changes = [], []

    def is_off(ratio):
        return words.within and not 1. / words.within <= ratio <= words.within

    for file in files:
        for _ in range(3 if words.within else 1):
            row = compare(file, words.limit, words.program)
            ratio = row["predicted"] / row["took"]
            if not is_off(ratio):
                break
        print(f"| {pathlib.Path(file).stem} | {row['until'] or 'its end'} | {row['predicted']:.3g} | {row['took']:.3g} | {ratio:.2f} "
              f"| {row['memory predicted']:.0f} | {row['memory']:.0f} |", flush=True)
        changes += [row["change"]] if row["change"] else []
        if is_off(ratio):
            off.append(f"{file}: {ratio:.2f} of what it took")
    if words.fit and changes:
        print(f"\nchange_of_elastic: {sum(changes) / len(changes):.3f}, of single runs "
              + ", ".join(f"{change:.2f}" for change in sorted(changes)))
    sys.exit("\n".join(off) or 0)


if __name__ == "__main__":
    main()
