# SPDX-License-Identifier: LGPL-2.1-or-later
"""pairs.py CHANGES [FILE.prm]...: errors of the layered model with some entries changed, against exact contact, by ratios.

    python3 scripts/study/pairs.py "Effects/Stiffness curves=on"
    python3 scripts/study/pairs.py "Effects/Stiffness curves=on,Effects/Oval rollers=on" prm/twelve/06b-13-19.prm

Runs each drive of source/accuracy.tsv, or those that are given, from the start phases and over the window of its calibration, without
the changes and with them, and multiplies what the outputs become by with the errors that the calibration has found without them. The
program is build/source/chaindrive; runs stand in results/pairs and are taken from there if they are there. A table in Markdown."""
import json
import math
import pathlib
import subprocess
import sys

import outputs
from accuracy_fit import SHOWN, percent

ROOT = pathlib.Path(__file__).resolve().parents[2]
PHASES, RUN_IN, SHORTEST = 4, 3, 6  # as of source/calibrate_command.cc
PAPER = ("fidelity", "layered-auto")  # how the table and the file name the paper's drive


def known_drives():
    """{name: (pitch time [s], pitches in the window, {output: error of layered})} of the table."""
    errors, groups, drives = {}, {}, {}
    for line in (ROOT / "source/accuracy.tsv").read_text(encoding="utf-8").splitlines():
        row = line.split("\t")
        if row[0] == "groups":
            groups[row[1]] = dict(cell.split("=") for cell in row[2:])
        elif row[0] == "drive":
            drives[row[1]] = dict(cell.split("=") for cell in row[2:])
        elif len(row) > 9 and row[1:3] == ["layered", "exact"]:
            errors.setdefault(row[0], {})[row[3]] = 0.01 * float(row[4])
    return {PAPER[1] if name == PAPER[0] else name:
            (60. / float(drives[name]["driver teeth"]) / float(drives[name]["driver speed in rpm"]),
             max(SHORTEST, math.ceil(float(groups[name]["resonance"]))), errors[name]) for name in groups}


def file_of(name):
    return next(ROOT.glob(f"prm/*/{name}.prm"))


def measure(file, pitch_time, window, changes, folder):
    """{output: mean over start phases} of the layered model of a drive, and its CPU time [s]."""
    found = {}
    for phase in range(PHASES):
        run = folder / f"phase-{phase / PHASES:g}"
        if not (run / "summary.json").exists():
            entries = {"Model/Fidelity": "layered", "Output/Quantities": "all", "Output/Field interval in ms": 0, "Output/CSV": "false",
                       "Output/Until": "", "Output/History interval in us": f"{min(20., 2e3 * pitch_time):.3g}",
                       "Drive/Layout/Start": "settled", "Drive/Layout/Start phase": phase / PHASES, "Time/Start time in ms": 0,
                       "Time/End time in ms": f"{1e3 * (RUN_IN + window) * pitch_time:.6g}",
                       "Output/Window start in ms": f"{1e3 * RUN_IN * pitch_time:.6g}", "Output/Window end in ms": "auto", **changes}
            words = [word for name, value in entries.items() for word in ("--set", f"{name}={value}")]
            subprocess.run([ROOT / "build/source/chaindrive", "run", file, "--quiet", "--output", run, *words], check=True, stderr=subprocess.DEVNULL)
        opened = outputs.Run(run)
        for name in SHOWN:
            value = outputs.OUTPUTS[name](opened) if name in outputs.OUTPUTS else opened.summary.get(name)
            found.setdefault(name, []).append(value)
        seconds = json.loads((run / "summary.json").read_text(encoding="utf-8"))["cpu_seconds"]
        found.setdefault("cpu", []).append(seconds["total"] - seconds["initiation_and_rest"])
    return {name: None if None in values else sum(values) / PHASES for name, values in found.items()}


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    changes = dict(one.split("=", 1) for one in sys.argv[1].split(","))
    drives = known_drives()
    files = [pathlib.Path(path).resolve() for path in sys.argv[2:]] or [file_of(name) for name in drives]
    print("| drive | " + " | ".join(name.removesuffix("_mean").replace("_", " ") for name in SHOWN) + " | CPU time, times |")
    print("|" + " --- |" * (len(SHOWN) + 2))
    columns = {name: [] for name in SHOWN}
    for file in files:
        pitch_time, window, errors = drives[file.stem]
        folder = ROOT / "results/pairs" / file.stem
        without = measure(file, pitch_time, window, {}, folder / "without")
        changed = measure(file, pitch_time, window, changes, folder / sys.argv[1].replace("/", " "))
        cells = []
        for name in SHOWN:
            if name in errors and without[name] and changed[name] is not None:
                columns[name].append((1 + errors[name]) * changed[name] / without[name] - 1)
                cells.append(f"{percent(columns[name][-1])} %")
            else:
                cells.append("-")
        print(f"| {file.stem} | " + " | ".join(cells) + f" | {changed['cpu'] / without['cpu']:.2f} |", flush=True)
    within = (f"{sum(abs(e) <= 0.1 for e in column)} of {len(column)}" for column in columns.values())
    print("| within 10 % | " + " | ".join(within) + " | |")


if __name__ == "__main__":
    main()
