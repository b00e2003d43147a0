#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the hard cases of hard_cases.py and checks energy, momentum, penetration and time step.

Simple models run with the time step of auto, others with larger ones, see STEP. A case passes if all its results are
finite, energy and momentum balance, no contact is missed or too deep, and its results are those of
hard.baseline as far as a chaotic motion is repeatable. A case that cannot pass must be refused before
it runs.
"""

import argparse
import csv
import math
import re
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import program
from hard_cases import CASES, ELASTIC, SMALL, SOON, VARIANTS
from program import start

HERE = Path(__file__).resolve().parent
MODELS = {"s": "simple", "l": "layered", "f": "full", "h": "shell", "m": "membrane", "r": "reduced", "e": "exact"}
STEP = {"s": 0.26, "l": 0.26, "f": 0.9, "h": 0.9, "m": 0.9, "r": 0.9, "e": 0.9}  # over the critical one
MOMENTUM = 1e-9  # largest imbalance, over the momentum of all bodies
TURNS = 5e-4  # rad, least angle of the driven sprocket: a drive in which nothing happens holds nothing

# How far figures may be from the baseline, as a ratio; they scatter with compiler and machine.
ALLOWED = {"steps": 1.05, "overlap_um": 2.0, "drive_work": 1.2, "driven_angle": 1.1}


def models_of(case):
    """Letters of the models that are to hold a case: those of shells and reduced ones where full ones are."""
    without_penalty = "" if "Contact/Penalty factor" in case.of_model.get("f", {}) else "e"
    return case.models.replace("f", "fhmr" + without_penalty)


def entries(case, model, directory, quick):
    """What is changed in hard.prm."""
    variant = VARIANTS.get(model, {"Model/Fidelity": MODELS[model]})
    changes = {"Output/Directory": directory, **variant}
    changes["Model/Stiffness from"] = "dimensions"  # each chain would take seconds more
    changes |= (SMALL if model in ELASTIC else {}) | case.changes | case.of_model.get("f" if model in ELASTIC else model, {})
    if quick and changes.get("Time/End time in ms", 10) > SOON["Time/End time in ms"]:
        changes |= SOON
    return changes


def not_finite(summary, name=""):
    """Names of the numbers in a summary that are none. A mean over nothing is null by
    definition, and so are whether a drive has settled that nobody waits for, the strength of a
    chain whose parts are not those of its table, and how certain a mean of few pitches is."""
    if isinstance(summary, dict):
        return [bad for key, value in summary.items() for bad in not_finite(value, key)]
    nothing = summary is None and name not in ("pitch_time_mean", "settled", "tensile_strength", "safety") and not name.endswith("uncertainty")
    return [name] if nothing or (isinstance(summary, float) and not math.isfinite(summary)) else []


def figures(summary):
    return {
        "steps": summary["steps"],
        "step_us": 1e6 * summary["time_step"],
        "imbalance": summary["energy_imbalance_max"],
        "momentum": summary.get("momentum_imbalance_max", 0.0),
        "overlap_um": 1e6 * max(summary["penetration_max"].values()),
        "drive_work": summary["drive_work"],
        "driven_angle": summary["driven_angle_end"],
        "cpu_s": summary["cpu_seconds"]["total"],
    }


def complaints(case, summary, found, expected):
    """What is wrong with a run, in words; nothing when it holds."""
    # what short windows may lack: a second impact, a whole tooth period, work
    partial = ["engagements", "impacts", "statistics", "efficiency"]
    if any(event["kind"] == "above breaking" for event in summary["events"]):
        partial.append("life")  # plates that break at once have no cycles
    if bad := not_finite({k: v for k, v in summary.items() if k not in partial}):
        return ["not a number: " + ", ".join(bad)]
    said = []
    if found["imbalance"] > case.imbalance:
        said.append(f"imbalance above {case.imbalance:g}")
    if found["momentum"] > MOMENTUM:
        said.append(f"momentum {found['momentum']:.1e}")
    if found["overlap_um"] > 1e3 * case.overlap:
        said.append(f"overlap above {1e3 * case.overlap:g} um")
    if summary.get("contacts_missed"):
        said.append(f"{summary['contacts_missed']} contacts missed")
    for name, ratio in ALLOWED.items() if expected else ():
        a, b = found[name], expected[name]
        if a != b and not 1 / ratio <= (a / b if b else math.inf) <= ratio:
            said.append(f"{name} {a:.4g} instead of {b:.4g}")
    return said


def run(which, case, model, folder, expected, quick):
    """(figures or None, what is wrong, remark) of one case and model."""
    directory = str(folder / f"{case.name} {MODELS[model]}".replace(" ", "_").replace("%", "percent"))
    command = program.command("prm/verification/hard.prm", entries(case, model, directory, quick), program=which)
    plan = start([*command, "--plan"])
    if case.refusal or plan.returncode:
        said = " ".join(plan.stderr.removeprefix("chaindrive: ").split())
        clear = plan.returncode == 2 and case.refusal and re.search(case.refusal, said)
        return None, [] if clear else [f"status {plan.returncode}: {said}"], "refused: " + said
    limit = float(re.search(r"all coupled ([\d.e+-]+)", plan.stdout)[1])
    step = 0.9995 * (case.step or STEP[model]) * limit  # the plan rounds
    result = start([*command, "--quiet", "--set", f"Time/Time step in us={step:.6g}"])
    if result.returncode:
        return None, [f"status {result.returncode}: {' '.join(result.stderr.split())}"], ""
    summary = program.summary(directory)
    found = figures(summary)
    wrong = complaints(case, summary, found, expected)
    if not quick and found["driven_angle"] < TURNS:  # the first milliseconds may be too short for it
        wrong.append("the driven sprocket does not turn")
    if case.long_run and grows(Path(directory, "histories_energy.csv")):
        wrong.append("the imbalance grows")
    return found, wrong, ""


def grows(table):
    """Whether the imbalance over the drive work is larger in the last half of a run than in the first."""
    with open(table, newline="") as file:
        rows = list(csv.reader(file))
    column = {name.split(" [")[0]: i for i, name in enumerate(rows[0])}
    shares = [abs(float(row[column["imbalance"]]) / float(row[column["drive_work"]])) for row in rows[2:]]
    middle = len(shares) // 2
    return max(shares[middle:]) > max(shares[:middle])


def read_baseline(path):
    lines = [line.split("|") for line in path.read_text().splitlines() if line and line[0] != "#"]
    names = [name.strip() for name in lines[0][2:]]
    return {
        (line[0].strip(), line[1].strip()): dict(zip(names, map(float, line[2:]))) for line in lines[1:]
    }


def write_baseline(path, baseline):
    known = [(case.name, MODELS[model]) for case in CASES for model in models_of(case)]
    baseline = {key: baseline[key] for key in known if key in baseline}
    rows = [f"{'case':28}|{'model':8}|" + "|".join(f"{name:>12}" for name in ALLOWED)]
    rows += [
        f"{case:28}|{model:8}|" + "|".join(f"{value[name]:12.6g}" for name in ALLOWED)
        for (case, model), value in baseline.items()
    ]
    head = "# SPDX-License-Identifier: LGPL-2.1-or-later\n# Figures that hard.py compares with; hard.py --record writes them.\n"
    path.write_text(head + "\n".join(rows) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help="only cases whose names contain one of these")
    parser.add_argument("--models", default="slfhmre",
                        help="s: simple, l: layered, f: full, h: full with shells, m: with membranes, r: reduced, e: reduced without penalty; default: slfhmre")
    parser.add_argument("--program", type=Path, default=program.PROGRAM)
    parser.add_argument("--results", type=Path, default=Path("results/hard"))
    parser.add_argument("--jobs", type=int, default=1, help="number of cases to run at a time")
    parser.add_argument(
        "--quick", action="store_true", help="2.5 ms of all except full models, of these one each with shells and membranes, without the baseline: a minute or two"
    )
    parser.add_argument("--record", action="store_true", help="write the results as the new baseline")
    options = parser.parse_args()

    path = HERE / "hard.baseline"
    baseline = read_baseline(path) if path.exists() else {}
    compare = not (options.quick or options.record)
    chosen = [
        (case, model)
        for case in CASES
        for model in models_of(case)
        if model in options.models and any(name in case.name for name in options.names or [""])
        if not (options.quick and (model in case.long or model in "fhm" and model not in case.soon))
    ]
    print(f"{'case':28}{'model':9}{'steps':>8}{'step us':>9}{'imbalance':>10}{'overlap um':>11}{'CPU s':>7}  verdict")
    failed = 0
    with ThreadPoolExecutor(options.jobs) as pool:

        def of(pair):
            expected = baseline.get((pair[0].name, MODELS[pair[1]])) if compare else None
            return run(str(options.program.resolve()), *pair, options.results, expected, options.quick)

        for (case, model), (found, wrong, remark) in zip(chosen, pool.map(of, chosen)):
            key = (case.name, MODELS[model])
            numbers = " " * 45
            if found:
                numbers = f"{found['steps']:8}{found['step_us']:9.3g}{found['imbalance']:10.1e}"
                numbers += f"{found['overlap_um']:11.3g}{found['cpu_s']:7.1f}"
                if options.record:
                    baseline[key] = found
                    write_baseline(path, baseline)  # what follows may be interrupted
                elif compare and key not in baseline:
                    wrong.append("not in the baseline")
            failed += bool(wrong)
            print(f"{key[0]:28}{key[1]:9}{numbers}  {'FAILED: ' + '; '.join(wrong) if wrong else remark or 'holds'}", flush=True)
    print(f"{len(chosen)} cases, {failed} failed")
    sys.exit(bool(failed) or not chosen)


if __name__ == "__main__":
    main()
