# SPDX-License-Identifier: LGPL-2.1-or-later
"""settled.py PROGRAM N: settled starts of N random drives run for 0.3 ms, and the chain pulls with the load from the first step on."""
import pathlib
import random
import shutil
import sys

import program
from program import check

PROGRAM, N = sys.argv[1], int(sys.argv[2])
CHAINS = {"06B": 9.525, "08B": 12.7, "10B": 15.875, "12A": 19.05, "16B": 25.4}
BASE = pathlib.Path("drive.prm").resolve()
BASE.write_text("subsection Drive\n  subsection Layout\n    set Start = settled\n  end\nend\n")
random.seed(3)
worst = 0.
for number in range(N):
    chain = random.choice(list(CHAINS))
    driver, driven = random.randint(13, 35), random.randint(13, 70)
    links = 2 * ((driver + driven) // 4 + random.randint(20, 50)) + abs(driver - driven) // 10 * 2
    speed = random.choice([0, random.uniform(1, 25)])  # of the chain, m/s
    tension = random.uniform(0.01, 0.08) * CHAINS[chain] ** 2 * 100  # N, below a seventh of what breaks it
    rate = speed / (driver * CHAINS[chain] * 1e-3) * 2 * 3.14159265
    entries = {
        "Drive/Chain/Designation": chain, "Drive/Driver teeth": driver, "Drive/Driven teeth": driven, "Drive/Number of links": links,
        "Drive/Layout/Centre distance from": "sag", "Drive/Layout/Sag in percent": random.uniform(0.5, 3),
        "Drive/Layout/Start phase": random.random(),
        "Drive/Layout/Tight span": random.choice(["upper", "lower"]),
        "Model/Fidelity": random.choice(["simple", "layered"]), "Model/Stiffness from": "dimensions",
        "Model/Driven inertia in kg m2": 10 ** random.uniform(-3, 0),
        "Loads/Driver speed in rad/s": rate, "Loads/Resisting torque in N m": tension * driven * CHAINS[chain] * 1e-3 / 6.2832,
        "Time/End time in ms": 0.3, "Output/Window start in ms": 0, "Output/Field interval in ms": 0,
    }
    if number % 4 == 3:
        entries.update({"Drive/Layout/Centre distance from": "pretension", "Drive/Layout/Pretension in N": 0.7 * tension + 50})
    shutil.rmtree("settled", ignore_errors=True)
    program.run(BASE, entries, "--output", "settled", program=PROGRAM)
    s = program.summary("settled")
    found = s["tight_tension_mean"] - s["slack_tension_mean"]
    error = abs(found - s["drive"]["effective_tension"]) / (tension + s["drive"]["centrifugal_tension"])
    worst = max(worst, error)
    # at speed inertia pulls as well: the run is a part of a tooth period
    check(error < (0.5 if speed else 0.02), f"drive {number} pulls with {found} N instead of {s['drive']['effective_tension']} N: {entries}")
    check(s["energy_imbalance_max"] < 1e-2, f"drive {number}: energy imbalance {s['energy_imbalance_max']}: {entries}")
    print(f"{number}: {chain} {driver}/{driven}, {links} links, {speed:.3g} m/s, {entries['Model/Fidelity']}: pulls with {found:.4g} N, "
          f"the load with {s['drive']['effective_tension']:.4g} N, {error:.2g}", flush=True)
print(f"largest error {worst:.2g}")
