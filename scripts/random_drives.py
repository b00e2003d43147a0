# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs random drives within the ranges of the entries, each for a short time: 0.3 ms.

    random_drives.py [-n 200] [--seed 0] [--fidelities simple,layered] [--kinds] [--refusals] [--record FILE] [--program PROGRAM]

Fidelity `exact` stands for `reduced` without penalty. With --kinds drives have what random_kinds.py adds, and run 0.5 ms.

A drive must run to its end with energy and momentum balanced, be refused by a sentence that names an entry, or be stopped by a
guard with advice, which is printed; anything else is an error: a signal, a hang, a stop without advice. Prints a line for each drive that did not run, with the message of
the program, and how many of each fidelity ran; 200 of rigid chains take three minutes on one core. Drive k of a seed is
always the same: --only k runs it alone and keeps its results. With --record each drive adds a line to a file, what it is and
what became of it as JSON; drives that stand there are not run again, so that an interrupted search goes on, and a longer one
adds to it. The largest imbalances of energy over the energy turned over are printed last.
"""
import argparse
import collections
import json
import math
import pathlib
import random
import re
import resource
import signal
import subprocess
import tempfile
import time

import program
import random_kinds

PITCH = {"06B": 9.525, "08B": 12.7, "10B": 15.875, "12B": 19.05, "16A": 25.4, "40": 12.7, "60": 19.05, "428": 12.7, "525": 15.875}
ELASTIC = ("reduced", "exact", "full")


def draw(rng, fidelity, kinds=False):
    """Entries of a drive, and what kinds of things it has besides two sprockets. The chains of elastic ones are few, since a new chain has to be solved first."""
    elastic = fidelity in ELASTIC
    chain = rng.choice(("525", "08B") if elastic else sorted(PITCH))
    driver, driven = rng.randint(9, 19 if elastic else 40), rng.randint(9, 19 if elastic else 90)
    pitch = PITCH[chain]
    radii = [0.5 * pitch / math.sin(math.pi / teeth) for teeth in (driver, driven)]
    links = 2 * math.ceil(0.5 * (0.5 * (driver + driven) + rng.uniform(1.2, 2 if elastic else 6) * sum(radii) / pitch * 2))
    pull = rng.choice((0, 1)) * 10 ** rng.uniform(0, 1.3) * pitch**2  # N: up to a tenth of what breaks such chains
    rpm = rng.choice((0, 1, 1, 1, 1)) * 10 ** rng.uniform(0, 3.5)
    entries = {
        "Drive/Chain/Designation": chain,
        "Drive/Number of links": links,
        "Drive/Driver teeth": driver,
        "Drive/Driven teeth": driven,
        "Drive/Sprockets/Tooth form": rng.choice(("iso min", "iso mid", "iso max")),
        "Drive/Chain/Elongation in percent": rng.choice((0, 0, 0, 0.5, 1.5)),
        "Drive/Layout/Tight span": rng.choice(("upper", "lower")),
        "Drive/Layout/Start phase": round(rng.random(), 3) % 1,
        "Drive/Layout/Start": rng.choice(("settled", "settled", "settled", "taut")),
        "Model/Fidelity": "reduced" if fidelity == "exact" else fidelity,
        "Model/Stiffness from": "dimensions",
        "Model/Driven inertia in kg m2": f"{10 ** rng.uniform(-4, -0.5):.3g}",
        "Loads/Driver speed in rad/s": f"{rpm * math.pi / 30:.4g}",
        "Loads/Resisting torque in N m": f"{1e-3 * radii[1] * pull:.4g}",
        "Loads/Ramp time in ms": rng.choice((1, 5, 50)),
        "Contact/Friction coefficient": rng.choice((0, 0.1, 0.3)),
        "Contact/Damping ratio": rng.choice((0, 0.1, 1)),
        "Time/End time in ms": 0.3,
        "Output/Window start in ms": 0,
    }
    ways = [("slack", f"{rng.uniform(0, 0.5):.2f}"), ("sag", f"{rng.uniform(0.2, 5):.2f}"), ("pretension", f"{rng.uniform(50, 2000):.0f}")]
    kind, value = rng.choice(ways[:2] if elastic else ways)  # elastic parts cannot be stretched before the start
    entries["Drive/Layout/Centre distance from"] = kind
    entries[{"slack": "Drive/Layout/Slack in mm", "sag": "Drive/Layout/Sag in percent", "pretension": "Drive/Layout/Pretension in N"}[kind]] = value
    if elastic:
        entries["Mesh/Refinement"] = 0
        entries["Model/Symmetry model"] = rng.choice(("auto", "false"))
        entries["Contact/Plate faces"] = rng.choice(("auto", "on")) if fidelity == "full" and entries["Model/Symmetry model"] == "false" else "auto"
        entries["Effects/Tooth compliance"] = rng.choice(("auto", "on", "off"))
        entries["Time/End time in ms"] = 0.05
        entries["Model/Stiffness from"] = "parts"
    if fidelity == "reduced":
        entries["Contact/Enforcement"] = "penalty"
    if fidelity == "exact":
        entries["Time/End time in ms"] = 0.3
        entries["Effects/Tooth inertia"] = rng.choice(("auto", "on")) if entries["Effects/Tooth compliance"] != "off" else "auto"
    if fidelity == "full":
        for body in ("links", "rollers", "driver", "driven"):
            entries[f"Effects/Elastic {body}"] = rng.choice(("auto", "off"))
        entries["Elements/Plates"] = rng.choice(("solid", "solid-shell", "membrane"))
        entries["Elements/Bushes"] = rng.choice(("solid", "solid-shell"))
    if kinds:
        entries["Time/End time in ms"] = 0.05 if fidelity == "full" else 0.5
        return entries, random_kinds.add(rng, fidelity, pitch, radii, entries)
    return entries, []


def outcome(entries, directory, path, limit, refusals):
    """What became of a drive, what is wrong with that or an empty text, its imbalance of energy if it ran or None, and the sentence
    it was refused with; that is printed after the name of the drive, if any."""
    words = program.command("prm/verification/hard.prm", entries, "--output", directory, program=path)
    try:
        done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", timeout=50 * limit,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(limit), math.ceil(limit) + 5)))
    except subprocess.TimeoutExpired:
        return "hangs", f"does not end, without computing, within {50 * limit} s", None, ""
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return "hangs", f"still computes after {limit} s", None, ""
    said = " ".join(done.stdout.split()[-80:])
    if done.returncode == 0:
        summary = program.summary(directory)
        energy, momentum = summary["energy_imbalance_max"], summary["momentum_imbalance_max"]
        # with a light load so little energy is turned over within 0.3 ms that round-off counts
        wrong = not (energy < 0.01 and momentum < 1e-8)
        return "runs", f"imbalance of energy {energy:.2g}, of momentum {momentum:.2g}" if wrong else "", energy, ""
    sentence = re.search(r"chaindrive: (.*)", done.stdout, re.S)
    named = sentence and re.search(r"[A-Z][a-z-]+/|Start|Step|Slack|Sag|teeth|links", sentence[1])
    if done.returncode == 2 and named:
        if refusals:
            print(f"{refusals} is refused: {sentence[1].splitlines()[0]}", flush=True)
        return "refused", "", None, sentence[1].splitlines()[0]
    if done.returncode == 3 and re.search(r"\b([Tt]ry|[Cc]hoose) ", done.stdout):
        print(f"{' '.join(map(str, words[1:]))}\nstops with advice: {said}", flush=True)
        return "stops with advice", "", None, said
    return f"status {done.returncode}", said, None, ""


def recorded(path, seed):
    """{number: what a line of the file says} of the drives of this seed that have been run."""
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    return {line["drive"]: line for line in map(json.loads, lines) if line["seed"] == seed}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("-n", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--fidelities", default="simple,layered")
    parser.add_argument("--limit", type=float, default=120, help="most CPU time that a drive may take, in seconds")
    parser.add_argument("--only", type=int)
    parser.add_argument("--kinds", action="store_true", help="drives with more than two sprockets in a plane")
    parser.add_argument("--refusals", action="store_true", help="print why drives are refused")
    parser.add_argument("--record", type=pathlib.Path, help="file with a line for each drive, which need not be run again")
    parser.add_argument("--program", default=program.PROGRAM)
    options = parser.parse_args()
    fidelities, counts, of_kinds, wrong, imbalances = options.fidelities.split(","), collections.Counter(), collections.Counter(), 0, []
    done = recorded(options.record, options.seed) if options.record else {}
    with tempfile.TemporaryDirectory() as scratch:
        for k in range(options.n) if options.only is None else (options.only,):
            fidelity = fidelities[k % len(fidelities)]
            entries, kinds = draw(random.Random(f"{options.seed} {k}"), fidelity, options.kinds)
            directory = pathlib.Path(scratch) / str(k) if options.only is None else pathlib.Path(f"results/random-{k}")
            if k in done and done[k]["entries"] == entries:
                became, fault, imbalance = (done[k][what] for what in ("became", "fault", "imbalance"))
            else:
                began = time.monotonic()
                became, fault, imbalance, sentence = outcome(entries, directory, options.program, options.limit, f"drive {k}" if options.refusals else "")
                if options.record:
                    line = {"seed": options.seed, "drive": k, "fidelity": fidelity, "kinds": kinds, "became": became, "fault": fault, "said": sentence,
                            "imbalance": imbalance,
                            "seconds": round(time.monotonic() - began, 1), "entries": entries}
                    with open(options.record, "a", encoding="utf-8") as file:
                        file.write(json.dumps(line) + "\n")
            counts[fidelity, became] += 1
            for kind in kinds:
                of_kinds[kind, became] += 1
            if imbalance is not None:
                imbalances.append((imbalance, k))
            if fault:
                wrong += 1
                sets = " ".join(f'--set "{name}={value}"' for name, value in entries.items())
                print(f"drive {k} of seed {options.seed}: {became}: {fault}\n  prm/verification/hard.prm {sets}", flush=True)
            elif became != "runs" and options.only is not None:
                print(f"drive {k}: {became}")
    for (fidelity, became), count in sorted(counts.items()):
        print(f"{fidelity}: {count} {became}")
    for kind in sorted({kind for kind, _ in of_kinds}):
        print(f"  with {kind}: " + ", ".join(f"{count} {became}" for (what, became), count in sorted(of_kinds.items()) if what == kind))
    largest = sorted(imbalances, reverse=True)[:5]
    print("largest imbalances: " + ", ".join(f"{value:.2g} (drive {k})" for value, k in largest))
    runs = sum(count for (_, became), count in counts.items() if became == "runs")
    program.check(not wrong, f"{wrong} drives ended as none should")
    program.check(runs > 0.5 * sum(counts.values()), "most drives were refused: nothing was tried")


if __name__ == "__main__":
    main()
