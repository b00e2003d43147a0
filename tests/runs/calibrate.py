# SPDX-License-Identifier: LGPL-2.1-or-later
"""calibrate.py PROGRAM: what `chaindrive calibrate` finds is what its runs have, and plans, runs and reports use it for this
drive, whatever its model and start, for no other, and not when its file is damaged. In an empty folder.

Without Snakemake, h5py, matplotlib or pandas it ends with 77: left out."""
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

from program import REPOSITORY, check
from small_drives import RIGID

PROGRAM = sys.argv[1]
HARD = REPOSITORY / "prm/verification/hard.prm"
DRIVE = {**RIGID, "Loads/Driver speed in rad/s": 240, "Model/Stiffness from": "dimensions", "Loads/Ramp time in ms": 1.3,
         "Time/End time in ms": 3, "Output/Window start in ms": 1}
FOLDER = pathlib.Path("calibration")
CACHE = pathlib.Path("cache").absolute()  # of this test alone; what parts take is computed once more


def start(command, *words, changes=None, quiet=True, cache=CACHE):
    environment = {**os.environ, "CHAINDRIVE_CACHE": str(cache)} if cache else None
    entries = [word for entry in {**DRIVE, **(changes or {})}.items() for word in ("--set", "=".join(map(str, entry)))]
    return subprocess.run([PROGRAM, command, str(HARD), *entries, *words, *(["--quiet"] if quiet else [])], text=True, capture_output=True,
                          env=environment, timeout=900)


def first_line(changes=None, wanted="driver_peak_mean=90"):
    done = start("plan", "--accuracy", wanted, changes=changes, quiet=False)
    check(done.returncode == 0, f"{changes}: {done.stderr}")
    return done.stdout.splitlines()[0], done


def mean_peak(variant):
    peaks = [json.loads((folder / "summary.json").read_text())["engagements"] for folder in (FOLDER / variant).glob("phase-*")]
    check(len(peaks) == 4, f"{variant} has {len(peaks)} phases")
    about = json.loads(next((FOLDER / variant).glob("phase-*/summary.json")).read_text())["window"]
    chosen = [[e["peak_force"] for e in run if e["sprocket"] == "driver" and e["complete"] and about["start"] <= e["time"] <= about["end"]]
              for run in peaks]
    check(sum(map(len, chosen)) >= 20, f"{variant}: {sum(map(len, chosen))} engagements in all")
    means = [sum(run) / len(run) for run in chosen]
    mean = sum(means) / len(means)
    return mean, math.sqrt(sum((one - mean) ** 2 for one in means) / 3) / mean


def composed(text, rows):
    """A run is one of those that the calibration has had from four phases, with a window of its own: its interval is in the table of a
    plan, and with the window that the plan asks for it is no wider than what was wanted."""
    scatters = {(row[2], row[3]): row for row in (line.split("\t") for line in text.splitlines()) if row[0] == "scatter"}
    _, _, _, _, deviation, pitches, runs = scatters["layered", "driver_peak_mean"]
    check(abs(float(deviation) / (100 * mean_peak("layered")[1]) - 1) < 1e-3 and runs == "4", f"{deviation} of {runs} runs: {mean_peak('layered')}")
    about = json.loads(next((FOLDER / "layered").glob("phase-*/summary.json")).read_text())
    pitch_time, window = about["drive"]["pitch_time"], about["window"]
    check(abs(float(pitches) / ((window["end"] - window["start"]) / pitch_time) - 1) < 1e-3, f"{pitches} pitches: {window}")

    error = 0.01 * float(rows["layered", "driver_peak_mean"][4])
    for end in (3, 9):
        _, done = first_line({"Time/End time in ms": end})
        row = next(line for line in done.stdout.splitlines() if line.startswith("  layered "))
        half = float(re.search(r"\+-([0-9.]+) %", row)[1])
        expected = (1 + error) * 3.18245 * float(deviation) * math.sqrt(float(pitches) * pitch_time / (1e-3 * (end - 1)))
        check(abs(half / expected - 1) < 0.06, f"a run that ends at {end} ms: {half} instead of {expected}: {row}")

    wanted = f"driver_peak_mean={min(100., 2. + max(abs(float(rows['layered', 'driver_peak_mean'][place])) for place in (5, 6)) + 5.):.3g}"
    for fidelity in ("simple", "layered"):
        line, done = first_line({"Model/Fidelity": fidelity, "Time/End time in ms": 1.3}, wanted)
        if "Time/End time in ms=" not in line:
            continue
        end = re.search(r"Time/End time in ms=([0-9.]+)", line)[1]
        check(float(end) > 1.3 and "yes, with a window of " in done.stdout, line)
        longer, done = first_line({"Model/Fidelity": fidelity, "Time/End time in ms": end}, wanted)
        check("Time/End time" not in longer and longer.split(",")[0] == line.split(",")[0], f"{line}, but then {longer}")
        return
    check(False, f"no window is too short for {wanted}: {line}")


def refused(words, *said, changes=None):
    done = start(*words, changes=changes)
    check(done.returncode == 2 and all(word in done.stderr for word in said), f"{words}: {done.returncode}, {done.stderr}")


def main():
    for left in (CACHE / "drives", FOLDER):  # by another version of the program
        shutil.rmtree(left, ignore_errors=True)
    refused(["calibrate", "--quick"], "--quick belongs to studies")
    refused(["calibrate"], "A drive that stands", changes={"Loads/Driver speed in rad/s": 0})
    refused(["calibrate"], "cannot begin", "exact: ", changes={"Drive/Sprockets/Driver mesh": REPOSITORY / "meshes/sprocket-15.msh",
                                                                        "Drive/Driver teeth": 15, "Drive/Number of links": 28})
    for changes, models in (({}, "simple layered oval exact"), ({"Effects/Roller-bush clearance": "off"}, "simple layered exact")):
        done = start("calibrate", "--dry-run", changes=changes, quiet=False, cache=None)
        listed = re.findall(r"^  ([a-z-]+)$", done.stdout, re.MULTILINE)
        check(" ".join(listed) == models, f"{changes}: {listed}, {done.stdout}, {done.stderr}")
    line, _ = first_line()
    check("no answer for this drive" in line and f"chaindrive calibrate {HARD} --set" in line, line)

    done = start("calibrate", "--cores", "2", "--output", str(FOLDER), quiet=False)
    if "are missing" in done.stderr or "not installed" in done.stderr:
        sys.exit(77)
    check(done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:])
    check("All of them take" in done.stdout, "nothing is said of what it takes")
    files = list((CACHE / "drives").glob("*"))
    check(len(files) == 1 and str(files[0]) in done.stdout, f"{files}")
    rows = {(row[1], row[3]): row for row in (line.split("\t") for line in files[0].read_text().splitlines()) if len(row) > 9}
    for variant in ("simple", "layered", "oval"):
        error, expected = float(rows[variant, "driver_peak_mean"][4]), 100 * (mean_peak(variant)[0] / mean_peak("exact")[0] - 1)
        check(abs(error - expected) < 1e-3 * abs(expected) + 1e-3, f"{variant}: {error} instead of {expected}")
    composed(files[0].read_text(), rows)

    # the same drive: another model, another start; nothing is computed again
    simple, layered, oval = (rows[variant, "driver_peak_mean"] for variant in ("simple", "layered", "oval"))
    check(oval[4] != layered[4] and "Effects/Oval rollers=on" in oval, f"{oval}")
    for changes in ({}, {"Model/Fidelity": "layered"}, {"Model/Fidelity": "layered", "Effects/Oval rollers": "on"},
                    {"Drive/Layout/Start": "settled", "Drive/Layout/Start phase": 0.3}):
        line, done = first_line(changes)
        check("calibrated on this drive" in line and "Model/Fidelity=" in line, line)
        row = oval if "Effects/Oval rollers" in changes else layered if "Model/Fidelity" in changes else simple
        said = next(text for text in done.stdout.splitlines() if text.startswith("How wrong this model is"))
        check(f"driver_peak_mean {float(row[4]):+.2g} %" in said, f"{changes}: {said}")
    line, _ = first_line(wanted="driver_peak_mean=0.0001")
    check("no model" in line, line)
    # others
    for changes in ({"Loads/Resisting torque in N m": 21}, {"Contact/Friction coefficient": 0.11}, {"Drive/Chain/Elongation in percent": 0.1}):
        check("no answer for this drive" in first_line(changes)[0], f"{changes}")

    done = start("run", "--output", "run", changes={"Model/Fidelity": "layered"})
    check(done.returncode == 0, done.stderr)
    kept = json.loads(pathlib.Path("run/summary.json").read_text())["accuracy"]["driver_peak_mean"]
    check(all(abs(100 * kept[name] - float(layered[place])) < 1e-9 for name, place in (("error", 4), ("low", 5), ("high", 6))), f"{kept}")
    check("How wrong this model is" in pathlib.Path("run/log.txt").read_text(), "the log says nothing")
    done = subprocess.run([PROGRAM, "report", "run"], text=True, capture_output=True)
    check(done.returncode == 0, done.stderr)
    check("error of the model in" in pathlib.Path("run/report.html").read_text(), "the report says nothing")

    # nothing is known of one stiffness at all loads, but how to leave it
    changes = {"Model/Fidelity": "layered", "Effects/Stiffness curves": "off"}
    advised = 0
    for percent in (2, 5, 10, 20, 40, 90):
        line, done = first_line(changes, f"driver_peak_mean={percent}")
        said = [line.count(entry) for entry in ("Model/Fidelity=layered", "Effects/Stiffness curves=auto")]
        check(said[0] == said[1] and "How wrong this model" not in done.stdout, done.stdout)
        advised += said[0]
    check(advised > 0, "layered is never advised")

    files[0].unlink()  # what the cache has lost comes back from the runs
    again = start("calibrate", "--cores", "2", "--output", str(FOLDER), quiet=False)
    check(again.returncode == 0 and "rule run" not in again.stdout, "runs were repeated")
    whole = files[0].read_text()
    for damaged in (whole.replace(files[0].stem, "0123456789abcdef"), whole[:len(whole) // 2], whole.replace("\t" + layered[4] + "\t", "\tmany\t"), "", "calibration\tx\n"):
        files[0].write_text(damaged)
        line, done = first_line()
        check("is damaged or of another drive, and not used" in done.stdout + done.stderr and "no answer for this drive" in line, f"{damaged[:40]!r}: {line} {done.stderr}")
    done = start("run", "--output", "unknown", changes={"Model/Fidelity": "layered"})
    check(done.returncode == 0 and "is damaged or of another drive" in done.stderr, f"a run says nothing of a damaged calibration: {done.stderr}")
    check("accuracy" not in json.loads(pathlib.Path("unknown/summary.json").read_text()), "a damaged calibration is used")
    # nor may a cache that cannot be looked into keep a run from its end
    done = subprocess.run([PROGRAM, str(HARD), "--set", "Time/End time in ms=0.2", "--set", "Output/Window start in ms=0", "--output", "odd", "--quiet"],
                          text=True, capture_output=True, env={**os.environ, "CHAINDRIVE_CACHE": os.path.abspath(300 * "x")})
    check(done.returncode == 0 and pathlib.Path("odd/summary.json").exists(), f"a cache of no folder: {done.returncode} {done.stderr}")


if __name__ == "__main__":
    main()
