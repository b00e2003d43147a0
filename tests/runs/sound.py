#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""sound.py PROGRAM REPOSITORY: drives that are sound must run to their end, however slow they are, and
with any step that is accepted: as large a share of the critical time step as stated, or auto."""

import re
import sys
from pathlib import Path

from program import command, start, summary

HARD, SLOW, LOW = "prm/verification/hard.prm", "prm/verification/slow.prm", "prm/tutorial/12a-11-23-low-speed.prm"
LAYERED = {"Model/Fidelity": "layered"}
STILL = {"Loads/Driver speed in rad/s": 0}
FRICTIONLESS = {"Contact/Friction coefficient": 0}
UNDAMPED = {"Contact/Damping ratio": 0}
WHIPPING = {"Loads/Resisting torque in N m": 0.5, "Drive/Layout/Slack in mm": 10}

# name, file, changes, milliseconds, share of the critical time step (0: auto)
CASES = [
    ("stands still", HARD, STILL, 1, 0),
    ("stands still without gravity", HARD, {**STILL, "Loads/Gravity in m/s2": 0}, 1, 0),
    ("stands still without gravity, layered", HARD, {**LAYERED, **STILL, "Loads/Gravity in m/s2": 0}, 0.5, 0),
    ("1 rad/s", LOW, {"Model/Fidelity": "simple", "Loads/Driver speed in rad/s": 1}, 5, 0),
    ("worn by 3 %", HARD, {"Drive/Chain/Elongation in percent": 3}, 2, 0),
    ("6 rad/s, ANSI teeth", SLOW, {"Drive/Sprockets/Tooth form": "ansi"}, 6, 0.36),
    ("6 rad/s, layered", SLOW, LAYERED, 6, 0),
    ("large step", HARD, WHIPPING, 20, 0.9),
    ("large step, layered", HARD, LAYERED, 5, 0.7),
    ("starts at full speed, large step", HARD, {"Loads/Ramp time in ms": 0}, 3, 0.5),
    ("stiff teeth without friction and damping", "prm/paper/simple.prm",
     {**FRICTIONLESS, **UNDAMPED, "Contact/Roller-tooth stiffness in N/m": 1.1e9}, 3, 0.89),
    ("light load without friction", HARD, {**FRICTIONLESS, "Model/Driven inertia in kg m2": 1e-4}, 2, 0.89),
    ("lighter load without friction", HARD, {**FRICTIONLESS, "Model/Driven inertia in kg m2": 1e-6}, 1, 0),
]  # fmt: skip


def run(program, directory, case):
    name, file, changes, end, share = case
    changes = {
        "Output/Directory": directory,
        "Output/Field interval in ms": 0,
        "Output/History interval in us": 100,
        "Output/Window start in ms": 0,
        "Output/Window end in ms": "auto",
        "Time/End time in ms": end,
        "Time/Time step in us": "auto",
        **changes,
    }
    if share:
        plan = start(command(file, changes, "--plan", program=program))
        limit = float(re.search(r"all coupled ([\d.e+-]+)", plan.stdout)[1])
        changes["Time/Time step in us"] = f"{0.9995 * share * limit:.6g}"  # the plan rounds
    result = start(command(file, changes, "--quiet", program=program))
    if result.returncode:
        return f"status {result.returncode}: {' '.join(result.stderr.split())[:300]}"
    found = summary(directory)
    if not 0 <= found["energy_imbalance_max"] < 0.02 or not found.get("energy_turned_over", 0) > 0:
        return f"imbalance {found['energy_imbalance_max']} of {found.get('energy_turned_over')} J"
    return ""


def main():
    program = Path(sys.argv[1]).resolve()
    failed = 0
    for number, case in enumerate(CASES):
        wrong = run(program, f"sound-{number}", case)
        print(f"{case[0]}: {wrong or 'runs'}", flush=True)
        failed += bool(wrong)
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
