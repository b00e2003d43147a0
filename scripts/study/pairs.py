# SPDX-License-Identifier: LGPL-2.1-or-later
"""pairs.py [--against ENTRIES] CHANGES [FILE.prm]...: errors of the layered model with some entries changed.

    python3 scripts/study/pairs.py "Effects/Stiffness curves=off"
    python3 scripts/study/pairs.py "Effects/Stiffness curves=off,Effects/Oval rollers=on" prm/twelve/06b-13-19.prm
    python3 scripts/study/pairs.py --against "Effects/Tooth compliance over place=off" "Effects/Stiffness curves=off" prm/twelve/06b-13-19.prm

Runs each drive of source/accuracy.tsv, or those that are given, from the start phases and over the window of its calibration, without
the changes and with them, and multiplies what the outputs become by with the errors that the calibration has found without them. The
program is build/source/chaindrive; runs stand in results/pairs and are taken from there if they are there. A table in Markdown.

With --against the reference is not that of the calibrations: contact without penalty runs from the same start phases with these entries
(none: ""), errors are against that, with half of their 95 % interval from the ratios of the phases, and a first table says what the
layered model without changes has. Tens of seconds a run."""
import json
import math
import pathlib
import statistics
import subprocess
import sys

import outputs
from accuracy_fit import SHOWN, percent
from chaindrive.certainty import student
from scatter import FILES, OUTPUTS

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "source/accuracy.tsv"
PHASES, RUN_IN, SHORTEST = 4, 3, 6  # as of source/calibrate_command.cc

LAYERED = {"Model/Fidelity": "layered"}
EXACT = {"Model/Fidelity": "reduced", "Model/Symmetry model": "auto", "Contact/Enforcement": "exact", "Model/Mass per pitch in g": "auto",
         "Model/Stiffness per pitch in N/m": "auto", "Contact/Roller-tooth stiffness in N/m": "auto",
         "Contact/Roller-bush stiffness in N/m": "auto", "Mesh/Refinement": "1"}


def known_drives():
    """{name: (file, pitch time [s], pitches in the window, {output: row of layered})} of the table."""
    errors, groups, drives = {}, {}, {}
    for row in (line.split("\t") for line in TABLE.read_text(encoding="utf-8").splitlines()):
        if row[0] == "groups":
            groups[row[1]] = dict(cell.split("=") for cell in row[2:])
        elif row[0] == "drive":
            drives[row[1]] = dict(cell.split("=") for cell in row[2:])
        elif len(row) > 9 and row[1:3] == ["layered", "exact"]:
            errors.setdefault(row[0], {})[row[3]] = row
    return {name: (FILES[name], 60. / float(drives[name]["driver teeth"]) / float(drives[name]["driver speed in rpm"]),
                   max(SHORTEST, math.ceil(float(groups[name]["resonance"]))), errors[name]) for name in groups}


def measure(file, pitch_time, window, changes, folder):
    """{output: values from all start phases} of a model of a drive, and its CPU times [s]."""
    found = {}
    for phase in range(PHASES):
        run = folder / f"phase-{phase / PHASES:g}"
        if not (run / "summary.json").exists():
            entries = {"Output/Quantities": "all", "Output/Field interval in ms": 0, "Output/CSV": "false",
                       "Output/Until": "", "Output/History interval in us": f"{min(20., 2e3 * pitch_time):.3g}",
                       "Drive/Layout/Start": "settled", "Drive/Layout/Start phase": phase / PHASES, "Time/Start time in ms": 0,
                       "Time/End time in ms": f"{1e3 * (RUN_IN + window) * pitch_time:.6g}",
                       "Output/Window start in ms": f"{1e3 * RUN_IN * pitch_time:.6g}", "Output/Window end in ms": "auto", **changes}
            words = [word for name, value in entries.items() for word in ("--set", f"{name}={value}")]
            subprocess.run([ROOT / "build/source/chaindrive", "run", file, "--quiet", "--output", run, *words], check=True, stderr=subprocess.DEVNULL)
        opened = outputs.Run(run)
        for name in {*SHOWN, *OUTPUTS}:
            value = outputs.OUTPUTS[name](opened) if name in outputs.OUTPUTS else opened.summary.get(name)
            found.setdefault(name, []).append(value)
        seconds = json.loads((run / "summary.json").read_text(encoding="utf-8"))["cpu_seconds"]
        found.setdefault("cpu", []).append(seconds["total"] - seconds["initiation_and_rest"])
    return {name: None if None in values else values for name, values in found.items()}


def ratio(found, over, name):
    return sum(found[name]) / sum(over[name]) if found.get(name) and over.get(name) and sum(over[name]) else None


def log_half(values, over):
    """Half of the 95 % interval of the mean over start phases of ln(value / over), by Student's t."""
    return student(PHASES - 1) * statistics.stdev(math.log(a / b) for a, b in zip(values, over)) / math.sqrt(PHASES)


def entries_of(text):
    return dict(one.split("=", 1) for one in text.split(",") if one)


def folder_of(file, text):
    return ROOT / "results/pairs" / file.stem / (text.replace("/", " ") or "without")


def print_table(errors_of, files):
    """A row for each file, of what `errors_of` gives for it: {output: error}, {output: half of its 95 % interval}, and CPU time."""
    print("| drive | " + " | ".join(name.removesuffix("_mean").replace("_", " ") for name in SHOWN) + " | CPU time, times |")
    print("|" + " --- |" * (len(SHOWN) + 2))
    columns = {name: [] for name in SHOWN}
    for file in files:
        errors, halves, cpu = errors_of(file)
        for name in SHOWN:
            columns[name] += [errors[name]] if errors.get(name) is not None else []
        cells = ["-" if errors.get(name) is None else f"{percent(errors[name])} %" + (f" (±{100 * halves[name]:.0f})" if name in halves else "")
                 for name in SHOWN]
        print(f"| {file.stem} | " + " | ".join(cells) + f" | {cpu:.2f} |", flush=True)
    within = (f"{sum(abs(e) <= 0.1 for e in column)} of {len(column)}" for column in columns.values())
    print("| within 10 % | " + " | ".join(within) + " | |")
    means = (f"{percent(statistics.mean(column))} %" if column else "-" for column in columns.values())
    print("| mean | " + " | ".join(means) + " | |")


def pair(drive, text):
    """{output: values} of the layered model without the changes and with them."""
    file, pitch_time, window, _ = drive
    return [measure(file, pitch_time, window, {**LAYERED, **entries_of(one)}, folder_of(file, one)) for one in ("", text)]


def main():
    words = sys.argv[1:]
    value = words[1] if len(words) > 2 and words[0] == "--against" else None
    words = words[2:] if value is not None else words
    if not words or words[0].startswith("--"):
        sys.exit(__doc__)
    text, drives = words[0], known_drives()
    by_file = {drive[0].resolve(): name for name, drive in drives.items()}
    chosen = {by_file[pathlib.Path(path).resolve()]: None for path in words[1:]} or drives
    drives = {name: drives[name] for name in chosen}
    of_file = {drive[0]: drive for drive in drives.values()}

    def by_ratios(file):
        without, changed = pair(of_file[file], text)
        known = {name: row for name, row in of_file[file][3].items() if ratio(changed, without, name)}
        errors = {name: (1 + 0.01 * float(row[4])) * ratio(changed, without, name) - 1 for name, row in known.items()}
        return errors, {}, ratio(changed, without, "cpu")

    def against(file, changes):
        _, pitch_time, window, _ = of_file[file]
        reference = measure(file, pitch_time, window, {**EXACT, **entries_of(value)}, folder_of(file, "exact " + value))
        found = measure(file, pitch_time, window, {**LAYERED, **entries_of(changes)}, folder_of(file, changes))
        errors = {name: ratio(found, reference, name) and ratio(found, reference, name) - 1 for name in SHOWN}
        halves = {name: (1 + error) * log_half(found[name], reference[name]) for name, error in errors.items() if error is not None}
        return errors, halves, ratio(found, reference, "cpu")

    if value is None:
        return print_table(by_ratios, of_file)
    for changes in ("", text):
        print(f"{changes or 'without changes'}, against {value or 'contact without penalty'}")
        print_table(lambda file: against(file, changes), of_file)  # pylint: disable=cell-var-from-loop


if __name__ == "__main__":
    main()
