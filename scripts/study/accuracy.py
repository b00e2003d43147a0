# SPDX-License-Identifier: LGPL-2.1-or-later
"""accuracy.py DIRECTORY...: prints source/accuracy.tsv, which `chaindrive plan FILE.prm --accuracy OUTPUT=PERCENT`
looks up, from the tables of the studies in these directories:

    python3 scripts/study/accuracy.py results/fidelity results/start > source/accuracy.tsv

    python3 scripts/study/accuracy.py --keep DIRECTORY
    python3 scripts/study/accuracy.py --drives PICTURE.png DIRECTORY... [--then DIRECTORY...]

The first of these writes the table of a calibration into the cache, where study.json says, and prints the errors of each model;
the second compares calibrations of several drives, in a picture and in Markdown, for doc/accuracy-and-cost.md, and those of drives
'then' run with their range.

A row for each variant that ran, and each output that has an error and an interval; the reference has the interval of its own
mean. Results of quick forms and of unfinished studies are refused."""
import csv
import json
import math
import os
import pathlib
import re
import sys

import h5py
import numpy as np

import chaindrive

HEAD = """# SPDX-License-Identifier: LGPL-2.1-or-later
# What studies found, by scripts/study/accuracy.py: separated by tabs,
# study, variant, reference, output, error, low, high (percent), CPU time, that of the reference (s), entries of the variant;
# "drive", study, what its errors hold for
# "groups", study, numbers by which drives are alike
# "scatter", study, variant, output, standard deviation of runs from different phases (percent), pitches of their window, runs
# "fit", model, output, group or -, drives, centre, slope, mean and sum of squares of the group's logarithm, factor, coverage:
# of scripts/study/accuracy_fit.py --write"""

END = "# complete, of "  # last line of a calibration, with the name of its file


def fidelity(folder):
    """That of the run in `folder`."""
    return re.search(r"^\s*set Fidelity = (\w+)", (folder / "variant.prm").read_text(), re.MULTILINE)[1]


def drive_of(folder):
    """The drive of the run in `folder`, in the words of drive_in_words() in source/accuracy.cc."""
    facts = chaindrive.open(folder).drive
    driver, driven = (next(one for one in facts["sprockets"] if one["name"] == name) for name in ("driver", "driven"))
    return [f"chain={facts['chain']}", f"links={facts['links']}", f"driver teeth={driver['teeth']}",
            f"driven teeth={driven['teeth']}", f"driver speed in rpm={abs(driver['speed']) * 30 / math.pi:.5g}",
            f"driven torque in N m={abs(driven['torque']):.5g}", f"centre distance in mm={1e3 * facts['centre_distance']:.6g}",
            f"driven inertia in kg m2={facts['driven_inertia']:.4g}"]


def models_of(about):
    """The variants that are ways to compute any drive: with no stiffness of their own where the reference has that of the parts."""
    def stiffness(variant):
        return variant.get("changes", {}).get("Model/Stiffness per pitch in N/m", "auto")
    reference = next(one for one in about["variants"] if one["name"] == about["reference"])
    return [variant for variant in about["variants"] if stiffness(variant) == stiffness(reference)]


def rows_of(directory, name=""):
    """Those of the study in `directory`, under another `name` than that of its file if one is given."""
    about = json.loads((directory / "study.json").read_text())
    with open(directory / "table.csv", encoding="utf-8") as file:
        table = {row["variant"]: row for row in csv.DictReader(file)}
    if about["quick"] or any("not finished" in row["message"].split("; ") for row in table.values()):
        sys.exit(f"{directory}: a study that is quick or has not ended is no ground for an answer")
    study, reference = pathlib.Path(about["file"]).stem, table[about["reference"]]
    study = name or study
    folder = directory / about["variants"][-1]["runs"][0]["folder"]
    yield ["drive", study, *drive_of(folder)]
    yield ["groups", study, *(f"{group}={value:.4g}" for group, value in chaindrive.open(folder).drive.get("groups", {}).items())]
    for variant in models_of(about):
        row = table[variant["name"]]
        entries = {"Model/Fidelity": fidelity(directory / variant["runs"][0]["folder"]), "Time/Time step in us": "auto",
                   **variant.get("changes", {})}
        for column in (name.removesuffix(" error") for name in row if name.endswith(" error")):
            error, low, high = (float(row[f"{column} error{which}"] or "nan") for which in ("", " low", " high"))
            if variant["name"] == about["reference"] and float(row[column]) != 0.:
                low, high = (100. * (float(row[f"{column} {which}"]) / float(row[column]) - 1.) for which in ("low", "high"))
            if column.endswith(" Hz") or not all(map(math.isfinite, (error, low, high))):
                continue
            yield [study, variant["name"], about["reference"], column, f"{error:.4g}", f"{low:.4g}", f"{high:.4g}",
                   f"{float(row['cpu']):.4g}", f"{float(reference['cpu']):.4g}",
                   *(f"{path}={value}" for path, value in entries.items() if not path.startswith("Study/"))]


def scatters_of(directory, name=""):
    """Rows that say by how much the runs of a variant differ from phase to phase, which is what a single run cannot know. None of a
    study of one model."""
    about = json.loads((directory / "study.json").read_text())
    if len({fidelity(directory / variant["runs"][0]["folder"]) for variant in about["variants"]}) == 1:
        return
    study = name or pathlib.Path(about["file"]).stem
    for variant in models_of(about):
        with h5py.File(directory / "table.h5", "r") as file:
            phases = {output: values[:] for output, values in file["by_phase/" + variant["name"]].items() if output not in ("phase", "cpu")}
        for output, values in phases.items():
            values = values[np.isfinite(values)]
            if output.endswith(" Hz") or len(values) < 2 or values.mean() == 0.:
                continue
            one = chaindrive.open(directory / variant["runs"][0]["folder"])
            yield ["scatter", study, variant["name"], output, f"{100 * values.std(ddof=1) / abs(values.mean()):.4g}",
                   f"{(one.end - one.start) / one.drive['pitch_time']:.4g}", str(len(values))]


def percent(text):
    """Two digits, or all before the point."""
    value = float(text)
    return f"{value:+.2g}" if abs(value) < 99.5 else f"{value:+.0f}"


def keep(directory):
    """The file appears complete or not at all: plans and runs may read it now."""
    file = pathlib.Path(json.loads((directory / "study.json").read_text())["calibration"])
    file.parent.mkdir(parents=True, exist_ok=True)
    rows = [*rows_of(directory, "calibration"), *scatters_of(directory, "calibration")]
    part = file.with_suffix(f".part{os.getpid()}")
    part.write_text("\n".join([HEAD, *("\t".join(row) for row in rows), END + file.stem]) + "\n")
    part.replace(file)
    print(f"Errors of the models on this drive, with 95 % intervals, and CPU time of a run; kept in {file}")
    found = {}
    for _, variant, reference, output, error, low, high, cpu, *_ in (row for row in rows[2:] if row[0] != "scatter"):
        if variant != reference:
            found.setdefault((variant, cpu), []).append(f"  {output:26}{percent(error):>8} %  ({percent(low)} ... {percent(high)})")
    for (variant, cpu), lines in found.items():
        print("\n".join([f"{variant}, {float(cpu):.3g} s:", *lines]))
    with open(directory / "table.csv", encoding="utf-8") as table:
        for row in csv.DictReader(table):
            if row["message"]:
                print(f"{row['variant']} is not for this drive: {row['message']}")


SHOWN = {"tight_tension_mean": "tight tension", "slack_tension_mean": "slack tension", "tight_tension_ripple": "ripple",
         "driver_peak_mean": "peaks, driver", "driver_impulse_mean": "impulses, driver", "driven_peak_mean": "peaks, driven",
         "roller_velocity_rms": "roller velocity", "losses": "losses"}


def draw(file, tables):
    """A point for each drive, output and rigid model."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axis = plt.subplots(figsize=(8, 4), layout="constrained")
    for shift, (variant, colour) in zip((-0.13, 0.13), (("layered", "#0072B2"), ("simple", "#D55E00"))):
        for place in range(len(SHOWN)):
            errors = [errors[place] for _, errors in tables[variant] if not math.isnan(errors[place])]
            axis.plot(errors, [place + shift] * len(errors), "o", ms=5, color=colour, alpha=0.6, label=variant if place == 0 else None)
    axis.axvspan(-10, 10, color="0.92", zorder=0)
    axis.axvline(0, color="0.5", lw=0.8)
    axis.set_xscale("symlog", linthresh=20)
    ticks = (-100, -50, -20, -10, 0, 10, 20, 50, 100, 200, 500)
    axis.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axis.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    axis.set_yticks(range(len(SHOWN)), SHOWN.values())
    axis.invert_yaxis()
    axis.set_xlabel("error against contact without penalty (%), a point for each drive; grey: within 10 %")
    axis.legend(loc="lower right", frameon=False)
    axis.grid(axis="x", color="0.92", lw=0.6)
    figure.savefig(file, dpi=110)


def errors_of(directory):
    """({variant: errors as SHOWN}, name, tooth frequency over resonance, {variant: CPU time}) of a calibration."""
    rows = list(rows_of(directory))
    facts = chaindrive.open(next((directory / "exact").glob("phase-*"))).drive
    errors, cpu = {}, {}
    for variant in ("layered", "simple", "exact"):
        found = {row[3]: row for row in rows[2:] if row[1] == variant}
        errors[variant] = [float(found[name][4]) if name in found else math.nan for name in SHOWN]
        cpu[variant] = float(next(iter(found.values()))[7]) if found else math.nan
    return errors, rows[0][1], facts["tooth_frequency"] / facts["driven_frequency"], cpu


def inside(error, others):
    return min(others) <= error <= max(others)


def drives(picture, directories, more):
    """A table for each rigid model: a row for each drive, and how far the range of some drives holds for others."""
    known, new = [errors_of(one) for one in directories], [errors_of(one) for one in more]
    tables = {variant: [((), drive[0][variant]) for drive in known] for variant in ("layered", "simple")}
    draw(picture, tables)
    for variant in tables:
        def row(*cells):
            print("| " + " | ".join(cells) + " |")

        def texts(errors):
            return ["-" if math.isnan(e) else f"{percent(e)} %" for e in errors]

        row(f"{variant} on", "tooth frequency over resonance", *SHOWN.values(), "CPU (s)", "of `exact` (s)")
        print("|" + " --- |" * (len(SHOWN) + 4))
        for errors, name, near, cpu in known:
            row(name, f"{near:.2g}", *texts(errors[variant]), f"{cpu[variant]:.1f}", f"{cpu['exact']:.0f}")
        columns = [[e for e in (drive[0][variant][i] for drive in known) if not math.isnan(e)] for i in range(len(SHOWN))]
        row("least to most", "", *(f"{percent(min(c))} to {percent(max(c))} %" for c in columns), "", "")
        row("within 10 %", "", *(f"{sum(abs(e) <= 10 for e in c)} of {len(c)}" for c in columns), "", "")
        for errors, name, near, cpu in new:
            row(f"*{name}*", f"{near:.2g}", *texts(errors[variant]), f"{cpu[variant]:.1f}", f"{cpu['exact']:.0f}")
        if new:
            found = [[e for e in (drive[0][variant][i] for drive in new) if not math.isnan(e)] for i in range(len(SHOWN))]
            row("*in the range of those above*", "", *(f"{sum(inside(e, c) for e in f)} of {len(f)}" for f, c in zip(found, columns)), "", "")
        print()


def main():
    if len(sys.argv) > 3 and sys.argv[1] == "--drives":
        words = [*sys.argv[3:], "--then"]
        split = words.index("--then")
        return drives(sys.argv[2], *(list(map(pathlib.Path, part)) for part in (words[:split], words[split + 1:-1])))
    if len(sys.argv) == 3 and sys.argv[1] == "--keep":
        return keep(pathlib.Path(sys.argv[2]))
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    print(HEAD)
    for directory in map(pathlib.Path, sys.argv[1:]):
        for row in (*rows_of(directory), *scatters_of(directory)):
            print("\t".join(row))


if __name__ == "__main__":
    main()
