# SPDX-License-Identifier: LGPL-2.1-or-later
"""ranks.py CASE PROGRAM: the same drive on 1, 2 and 4 ranks, with elastic rims also on 3. A small drive of
elastic bodies, brought to full speed in 10 us, runs until its spans pull. Every column of every history must be
the same on all numbers of ranks, to 1e-8 of the largest value of its unit in its group; every rank leaves its
piece of the pictures; and a run on two ranks that goes on from a checkpoint gives the same CSV files, bit by
bit, and with rims the same columns on three. Reduced bodies, whose nodes are placed where contact reads them,
move as they do where it reads all of them at every step.

  whole      all bodies elastic, with so little between their plates that they touch
  imported   all bodies elastic, the driver read from a mesh
  half       half of that
  arriving   elastic links among rigid ones
  reduced    all rollers and links reduced
  exact-joints  the same, and no penalty in their joints
  inertia    the same, on rims with inertia
  mixed      halves of elastic links among reduced ones
  settled    halves of them, from a settled start
  settled-reduced  reduced bodies from a settled start
  rigid      the layered model: of two ranks one computes, and both end
  refuse     bad input on two ranks: one sentence and its status
"""
import csv
import math
import os
import pathlib
import re
import shutil
import sys

import program
import small_drives
from program import check
from small_drives import IMPORTED, RIGID, TOUCHING_PLATES

CASE, PROGRAM = sys.argv[1:3]

OUTPUT = {"Output/CSV": "true", "Output/History precision": "double"}
ELASTIC = {**OUTPUT, **small_drives.ELASTIC, "Output/Field interval in ms": 1, "Output/Checkpoint interval in ms": 0.08}
CASES = {
    "whole": TOUCHING_PLATES,
    "imported": IMPORTED,
    "half": {**IMPORTED, "Model/Symmetry model": "true"},
    "arriving": {"Model/Elastic links": "region of interest"},
    "reduced": {"Model/Fidelity": "reduced", "Contact/Enforcement": "penalty"},
    "exact-joints": {"Model/Fidelity": "reduced", "Contact/Enforcement": "exact joints"},
    "exact": {"Model/Fidelity": "reduced"},
    "inertia": {"Model/Fidelity": "reduced", "Effects/Tooth inertia": "on"},
    "mixed": {"Model/Elastic links": "region of interest", "Model/Other links": "reduced", "Model/Symmetry model": "true"},
    "settled-reduced": {"Model/Fidelity": "reduced", "Drive/Layout/Start": "settled", "Loads/Resisting torque in N m": 30},
    "settled": {
        "Model/Elastic links": "region of interest",
        "Model/Symmetry model": "true",
        "Drive/Layout/Start": "settled",
        "Loads/Resisting torque in N m": 30,
    },
}


WITH_RIMS = ("whole", "imported", "half")  # whose teeth meet elastic rollers of other ranks


def run(directory, entries, ranks, options=(), status=0):
    words = ("--quiet", "--output", directory, *options)
    return program.run("prm/verification/hard.prm", entries, *words, program=PROGRAM, ranks=ranks, status=status)


def files(directory):
    """Histories as they are written."""
    return {file.name: file.read_bytes() for file in sorted(pathlib.Path(directory).glob("histories_*.csv"))}


def columns(directory):
    """All columns by group and name: unit and numbers."""
    result = {}
    for name, text in files(directory).items():
        rows = list(csv.reader(text.decode().splitlines()))
        for number, title in enumerate(rows[0]):
            label, unit = re.fullmatch(r"(.*) \[(.*)\]", title).groups()
            result[name[10:-4], label] = unit, [float(row[number]) for row in rows[1:]]
    return result


def same(expected, got, where, within=1e-8):
    check(expected.keys() == got.keys(), f"{where}: other columns")
    scale = {}
    for (group, _), (unit, values) in expected.items():
        known = [abs(value) for value in values if not math.isnan(value)]  # a gap has none at the start
        scale[group, unit] = max([scale.get((group, unit), 0), *known])
    worst = 0, ""
    for (group, label), (unit, values) in expected.items():
        others = got[group, label][1]
        check(len(values) == len(others), f"{where}: {group} {label} has {len(others)} rows, not {len(values)}")
        for a, b in zip(values, others):
            # round-off decides whether what just touches has a gap of 1e-17 m or none that is known
            difference = abs((0 if math.isnan(a) else a) - (0 if math.isnan(b) else b))
            error = difference / scale[group, unit] if difference > 0 else 0
            check(error <= within, f"{where}: {group} {label} is {b} {unit} instead of {a}")
            worst = max(worst, (error, f"{group} {label}"))
    print(f"{where}: {len(expected)} columns of {len(values)} rows differ by at most {worst[0]:.1e} ({worst[1]})")


def elastic(entries):
    numbers = (1, 2, 3, 4) if CASE in WITH_RIMS else (1, 2, 4)
    for ranks in numbers:
        shutil.rmtree(f"ranks{ranks}", ignore_errors=True)
        run(f"ranks{ranks}", entries, ranks)
        pieces = len(list(pathlib.Path(f"ranks{ranks}/fields").glob("bodies_000000.*vtu")))
        check(pieces == (1 if ranks == 1 else ranks + 1), f"{pieces} files of a picture on {ranks} ranks")
    one = columns("ranks1")
    for group, unit, least in (("spans", "N", 1e3), ("hubs", "N m", 20), ("rollers", "N", 500), ("joints", "N", 1e3)):
        largest = max(max(values) for (g, _), (u, values) in one.items() if (g, u) == (group, unit))
        check(largest > least, f"nothing has happened: {largest} {unit} is the most in {group}")
    if "Contact/Plate faces" in entries:
        deepest = program.summary("ranks1")["penetration_max"]["plate faces"]
        check(deepest > 1e-7, f"plates do not touch: {deepest} m")
    for ranks in numbers[1:]:
        same(one, columns(f"ranks{ranks}"), f"{ranks} ranks")
    if "Model/Fidelity" in entries:  # nodes that nobody reads are not placed, unless all are searched
        run("always", {**entries, "Contact/Search": "every step"}, 1)
        searched, always = [
            {name: column for name, column in of_run.items() if "gap" not in name[1]}  # gaps are of the last visit
            for of_run in (one, columns("always"))
        ]
        # between two searches a node may slide past the end of the facet that it is projected on
        same(searched, always, "a search at every step", 1e-3)

    undisturbed = files("ranks2")
    older = min(pathlib.Path("ranks2").glob("checkpoint-*.ckpt"))  # the other is that of the end
    resumed = {"ranks2": 2}
    if CASE in WITH_RIMS:
        shutil.copytree("ranks2", "others", dirs_exist_ok=True)
        resumed["others"] = 3
    for directory, ranks in resumed.items():
        for name in undisturbed:
            os.remove(f"{directory}/{name}")
        checkpoint = pathlib.Path(directory, older.name)
        run(directory, entries, ranks, ["--resume", str(checkpoint)])
        log = pathlib.Path(directory, "log.txt").read_text()
        check(f"Resumed from '{checkpoint}'" in log, "it has not gone on from the checkpoint")
    check(files("ranks2") == undisturbed, "resumed on two ranks: not as it is undisturbed")
    if CASE in WITH_RIMS:
        same(one, columns("others"), "resumed on three ranks")


def rigid():
    entries = {**OUTPUT, **RIGID, "Model/Fidelity": "layered", "Time/End time in ms": 1.5}
    for ranks in (1, 2):
        run(f"ranks{ranks}", entries, ranks)
    check(files("ranks1") == files("ranks2") != {}, "two ranks do not give what one gives")


def refuse():
    for text, change in (
        ("Driver teeth", {"Drive/Driver teeth": 8}),
        ("critical time step", {"Time/Time step in us": 50}),
        ("teeth", {**IMPORTED, "Drive/Driver teeth": 16}),
    ):
        said = run("refused", {**ELASTIC, **change}, 2, status=2)
        check(said.count("chaindrive: ") == 1 and text in said, f"not one sentence with '{text}':\n{said}")
        check(not pathlib.Path("refused").exists(), "a refused run has written something")


{"rigid": rigid, "refuse": refuse}.get(CASE, lambda: elastic({**ELASTIC, **CASES[CASE]}))()
