# SPDX-License-Identifier: LGPL-2.1-or-later
"""scatter.py PROGRAM FOLDER [--write]: by how much single runs differ that start in different phases, on the drives that errors are known of.

    python3 scripts/study/scatter.py build/source/chaindrive results/scatter            tables in Markdown, for doc/accuracy-and-cost.md
    python3 scripts/study/scatter.py build/source/chaindrive results/scatter --write    and the rows "scatter" of source/accuracy.tsv anew

Runs the rigid models of each drive from four start phases, settled, as `chaindrive calibrate` does, a quarter of an hour in all; what
FOLDER has of an earlier call is not run again. The scatter of the reference follows from the interval of its mean in source/accuracy.tsv.
The first table is the scatter in a window of one pitch, all drives together; the second says how many single runs of drives that were
left out of everything lie in the interval that is expected of them; the third whether the scatter falls with the root of the window."""
import collections
import json
import math
import pathlib
import statistics
import subprocess
import sys

import scipy.stats

import accuracy_fit
import outputs
from chaindrive.certainty import student

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "source/accuracy.tsv"
OUTPUTS = ("tight_tension_mean", "slack_tension_mean", "tight_tension_ripple", "driver_peak_mean", "driver_impulse_mean",
           "driver_normal_speed_mean", "driven_peak_mean", "driven_impulse_mean", "roller_velocity_rms", "losses")
FILES = {**{file.stem: file for file in sorted((ROOT / "prm/twelve").glob("*.prm"))}, "fidelity": ROOT / "prm/paper/layered-auto.prm",
         **{name: ROOT / f"prm/{folder}/{name}.prm" for folder, name in
            (("tutorial", "06b-25-25"), ("tutorial", "08b-19-57"), ("tutorial", "525-14-41"), ("drives", "two-loads"), ("drives", "idler"))}}
MODELS = {"simple": ("Model/Fidelity=simple", "Effects/Oval rollers=off"), "layered": ("Model/Fidelity=layered", "Effects/Oval rollers=off"),
          "oval": ("Model/Fidelity=layered", "Effects/Oval rollers=on")}
PHASES, RUN_IN, SHORTEST = 4, 3, 6  # as source/calibrate_command.cc
LONG, LONGER = ("06b-13-19", "08b-19-21", "fidelity"), 8  # windows so many times as long


def run(program, file, folder, *entries):
    words = [word for entry in ("Drive/Layout/Start=settled", "Time/Start time in ms=0", "Time/Time step in us=auto", "Output/Window end in ms=auto",
                                "Output/Field interval in ms=0", "Output/Until=", *entries) for word in ("--set", entry)]
    subprocess.run([program, "run", str(file), "--quiet", "--output", str(folder), *words], check=True, stderr=subprocess.DEVNULL)
    return json.loads((folder / "summary.json").read_text())


def mean_in(history, begin, end):
    time, values = history
    return float(values[(time >= begin) & (time < end)].mean())


def windows(folder, summary, begin, length, n):
    """Means of the peaks at the driver and of the tight tension in n windows behind each other."""
    with outputs.Run(folder) as found:
        tension = found.time, found["spans/tight_tension"]
        for i in range(n):
            since, until = begin + i * length, begin + (i + 1) * length
            peaks = [e["peak_force"] for e in summary["engagements"] if e["sprocket"] == "driver" and e["complete"] and since <= e["time"] < until]
            yield statistics.mean(peaks), mean_in(tension, since, until)


def measure(program, folder, drive, model, longer):
    """{"pitches", "runs": [{output: value}], "windows": {times longer: [[of each run]]}} of a model."""
    kept = folder / f"{drive}-{model}-{longer}.json"
    if kept.exists():
        return json.loads(kept.read_text())
    scratch = folder / "run"
    facts = run(program, FILES[drive], scratch, *MODELS["simple"], "Time/End time in ms=0.1", "Output/Window start in ms=0")["drive"]
    pitch, swings = facts["pitch_time"], facts["tooth_frequency"] / facts["driven_frequency"]
    pitches = max(SHORTEST, math.ceil(swings) if swings > 1 else 1)
    found = {"pitches": pitches, "runs": [], "windows": {times: [] for times in (1, 2, 4, 8) if times <= longer}}
    for phase in range(PHASES):
        summary = run(program, FILES[drive], scratch, *MODELS[model], "Output/Quantities=all",
                      f"Output/History interval in us={1e6 * min(20e-6, 2e-3 * pitch):.3g}", f"Drive/Layout/Start phase={phase / PHASES}",
                      f"Time/End time in ms={1e3 * (RUN_IN + longer * pitches) * pitch:.8g}", f"Output/Window start in ms={1e3 * RUN_IN * pitch:.8g}")
        found["runs"].append(outputs.of_run(scratch, OUTPUTS))
        for times, known in found["windows"].items():
            if longer > 1:
                known.append(list(windows(scratch, summary, RUN_IN * pitch, times * pitches * pitch, longer // times)))
    kept.write_text(json.dumps(found))
    return found


def short(value):
    """Two digits, or all before the point."""
    return f"{value:.2g}" if value < 99.5 else f"{value:.0f}"


def relative(values):
    return statistics.stdev(values) / abs(statistics.mean(values))


def values_of(measured):
    """{(drive, model): (pitches, {output: values of all runs})}, of outputs that all runs have."""
    found = {}
    for key, one in measured.items():
        values = {output: [run.get(output, math.nan) for run in one["runs"]] for output in OUTPUTS}
        found[key] = one["pitches"], {output: all_ for output, all_ in values.items() if all(map(math.isfinite, all_)) and statistics.mean(all_)}
    return found


def table():
    """The rows of source/accuracy.tsv."""
    return [line.split("\t") for line in TABLE.read_text().splitlines()]


def known_models():
    """(drive, model) of which errors are known: ovals are not of drives whose load is too large for them."""
    rows = {tuple(row[:2]) for row in table()}
    return [(drive, model) for drive in FILES for model in MODELS if (drive, model) in rows]


def rows_of(found):
    """Those of source/accuracy.tsv."""
    rows = table()
    for drive in FILES:
        for model in (model for model in MODELS if (drive, model) in found):
            pitches, outputs_ = found[drive, model]
            for output, values in outputs_.items():
                yield ["scatter", drive, model, output, f"{100 * relative(values):.4g}", f"{pitches}", f"{len(values)}"]
        # the interval of the mean is Student's; the study of the paper's drive has more runs
        n, window = (8, 16e-3 * 1153 / 60 * 15) if drive == "fidelity" else (PHASES, found[drive, "layered"][0])
        for row in rows:
            if len(row) > 9 and row[0] == drive and row[1] == row[2] == "exact" and row[3] in OUTPUTS:
                half = 0.5 * (float(row[6]) - float(row[5]))
                yield ["scatter", drive, "exact", row[3], f"{half / student(n - 1) * math.sqrt(n):.4g}", f"{window:.3g}", f"{n}"]


def of_a_pitch(found, model, output, without=None):
    """Pooled scatter in a window of one pitch, and its degrees of freedom."""
    known = [(pitches, values[output]) for (drive, one), (pitches, values) in found.items()
             if one == model and drive != without and len(values.get(output, ())) > 1]
    degrees = sum(len(values) - 1 for _, values in known)
    return math.sqrt(sum((len(values) - 1) * pitches * relative(values) ** 2 for pitches, values in known) / degrees), degrees


def covered(found):
    """{output: [runs within what the model lets expect, within this and what a run scatters by, all]} of drives that were left out."""
    errors, groups = accuracy_fit.read(TABLE)
    counts = collections.defaultdict(lambda: [0, 0, 0])
    for (model, output), of_drive in errors.items():
        drives = [drive for drive, error in of_drive.items() if error > -1. and output in found.get((drive, model), (0, {}))[1]]
        if len(drives) < accuracy_fit.LEAST:
            continue
        y = [math.log1p(of_drive[drive]) for drive in drives]
        names = [name for name in groups[drives[0]] if all(groups[drive].get(name, 0.) > 0. for drive in drives)]
        x = {name: [math.log(groups[drive][name]) for drive in drives] for name in names}
        for i, drive in enumerate(drives):
            others = {name: accuracy_fit.without(values, i) for name, values in x.items()}
            name = accuracy_fit.choose(others, accuracy_fit.without(y, i))
            line, at = accuracy_fit.Line(others.get(name), accuracy_fit.without(y, i)), x[name][i] if name else 0.
            middle, low, high = (math.expm1(line.at(at) + side * line.half(at)) for side in (0, -1, 1))
            pitches, values = found[drive, model]
            scatter, degrees = of_a_pitch(found, model, output, drive)
            half = (1 + middle) * scipy.stats.t.ppf(0.975, degrees) * scatter / math.sqrt(pitches)
            truth = statistics.mean(values[output]) / (1 + of_drive[drive])
            for value in values[output]:
                error, count = value / truth - 1, counts[output]
                count[0] += low <= error <= high
                count[1] += middle - math.hypot(middle - low, half) <= error <= middle + math.hypot(high - middle, half)
                count[2] += 1
    return counts


def long_windows(program, folder):
    print("| drive | windows (pitches) | peaks, driver | tight tension |\n| --- | --- | --- | --- |")
    for drive in LONG:
        found = measure(program, folder, drive, "layered", LONGER)
        cells, sizes = [], [times * found["pitches"] for times in map(int, found["windows"])]
        for which in range(2):
            ratios = []
            for of_runs in found["windows"].values():
                values = [window[which] for one in of_runs for window in one]
                ratios.append(100 * relative(values))
            cells.append(", ".join(f"{ratio:.2g}" for ratio in ratios) + f" % (root: {ratios[0] / math.sqrt(sizes[-1] / sizes[0]):.2g})")
        print(f"| {drive} | {', '.join(map(str, sizes))} | " + " | ".join(cells) + " |")


def main():
    write = sys.argv[3:] == ["--write"]
    if len(sys.argv) != 3 + write:
        sys.exit(__doc__)
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    found = values_of({(drive, model): measure(program, folder, drive, model, 1) for drive, model in known_models()})
    print("| output | " + " | ".join(MODELS) + " |\n|" + " --- |" * (1 + len(MODELS)))
    for output in OUTPUTS:
        print(f"| {output.replace('_', ' ')} | " + " | ".join(f"{short(100 * of_a_pitch(found, model, output)[0])} %" for model in MODELS) + " |")
    counts = covered(found)
    alone, both, runs = (sum(count[i] for count in counts.values()) for i in range(3))
    print(f"\nOf {runs} single runs of drives that were left out {both} lie in the interval with the scatter of runs ({100 * both / runs:.0f} %; "
          f"of each output {100 * min(c[1] / c[2] for c in counts.values()):.0f} to {100 * max(c[1] / c[2] for c in counts.values()):.0f} %), "
          f"{alone} in that of models alone ({100 * alone / runs:.0f} %).\n")
    long_windows(program, folder)
    if write:
        lines = [line for line in TABLE.read_text().splitlines() if not line.startswith("scatter\t")]
        at = next(i for i, line in enumerate(lines) if line.startswith("fit\t"))
        TABLE.write_text("\n".join([*lines[:at], *("\t".join(row) for row in rows_of(found)), *lines[at:]]) + "\n")


if __name__ == "__main__":
    main()
