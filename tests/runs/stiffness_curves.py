# SPDX-License-Identifier: LGPL-2.1-or-later
"""stiffness_curves.py PROGRAM: runs whose contacts follow elastic solutions over load and place, which they do without being told.
Restart is bit by bit, two ranks agree to round-off, energy balances, also with oval rollers; a stiffness that is given stands; where all
are given, or the model cannot, the entry is refused in words. In an empty folder."""
import re
import subprocess
import sys

from out_of_line_run import difference, run
from program import REPOSITORY, check
from small_drives import RIGID

PROGRAM = sys.argv[1]
DRIVE = {**RIGID, "Model/Fidelity": "layered", "Loads/Driver speed in rad/s": 240, "Loads/Ramp time in ms": 0.2, "Time/End time in ms": 2,
         "Output/Field interval in ms": 0, "Output/History interval in us": 10, "Output/Checkpoint interval in ms": 0.7}
CURVES, SECANTS = {}, {"Effects/Stiffness curves": "off"}  # auto is on
TOOTH, BUSH, PITCH = "Contact/Roller-tooth stiffness in N/m", "Contact/Roller-bush stiffness in N/m", "Model/Stiffness per pitch in N/m"


def refused(changes, said):
    words = [word for entry in {**DRIVE, "Effects/Stiffness curves": "on", **changes}.items() for word in ("--set", "=".join(map(str, entry)))]
    done = subprocess.run([PROGRAM, "plan", str(REPOSITORY / "prm/verification/hard.prm"), *words], text=True, capture_output=True)
    check(done.returncode == 2 and "Effects/Stiffness curves = on is not possible" in done.stderr and said in done.stderr,
          f"{changes}: {done.stderr}")


def log(name):
    with open(f"{name}/log.txt", encoding="utf-8") as file:
        return file.read()


def main():
    secants, before = run(DRIVE, PROGRAM, "secant", SECANTS)
    curves, whole = run(DRIVE, PROGRAM, "curves", CURVES)
    check(difference(curves, secants, ["spans/tight_tension"]) > 1e-4, "curves change nothing")
    lost = [summary["energy_imbalance_max"] for summary in (before, whole)]
    check(lost[1] < 2. * lost[0] + 1e-5, f"energy imbalance {lost}")
    # teeth at the end of the seat are softer than at its bottom
    softer = re.findall(r"(\d+) teeth ([\d.]+) to [\d.]+ at the bottom of a gap, ([\d.]+) to", log("curves"))
    check(len(softer) == 2 and all(0.3 < float(end) / float(bottom) < 0.9 for _, bottom, end in softer), f"{softer}")

    # with two of three given the third alone is a curve, and the limits of the steps of the two stay
    given = {TOOTH: 2e8, PITCH: 1e8}
    run(DRIVE, PROGRAM, "given", {**given, **SECANTS})
    run(DRIVE, PROGRAM, "bush", {**given, **CURVES})
    limits = [dict(re.findall(r"(roller-driver|bush-pin|roller-bush) ([\d.]+)", log(name).split("Critical time step")[1]))
              for name in ("given", "bush")]
    check(all(limits[0][name] == limits[1][name] for name in ("roller-driver", "bush-pin")), f"{limits}")
    check(float(limits[1]["roller-bush"]) < float(limits[0]["roller-bush"]), f"{limits}")

    run({**DRIVE, "Time/End time in ms": 1.1}, PROGRAM, "again", CURVES)
    resumed, _ = run(DRIVE, PROGRAM, "again", {**CURVES, "Output/Resume": "auto"})
    check(all(resumed[name].tobytes() == curves[name].tobytes() for name in curves), "a restart goes another way")
    short = {**DRIVE, "Loads/Ramp time in ms": 1.3, "Time/End time in ms": 0.6, "Effects/Oval rollers": "on"}  # too hard a start is for no oval
    two, _ = run(short, PROGRAM, "two", CURVES, ranks=2)
    one, alone = run(short, PROGRAM, "one", CURVES)
    worst = difference(two, one, ["spans/tight_tension", "hubs/driven_speed"])
    check(worst < 1e-9, f"two ranks differ by {worst}")
    check(alone["energy_imbalance_max"] < 1e-3, f"{alone['energy_imbalance_max']} with ovals")

    refused({"Model/Fidelity": "simple"}, "one lump")
    refused({"Model/Fidelity": "full"}, "elastic")
    refused({"Effects/Planar motion": "off"}, "not planar")
    refused({"Drive/Chain/Rollers": "off"}, "no rollers")
    refused({"Model/Stiffness from": "dimensions"}, "knows no curves")
    refused({**given, BUSH: 1e8}, "all stiffnesses are given")
    refused({"Contact/Oil viscosity in mPa s": 100}, "oil films")


if __name__ == "__main__":
    main()
