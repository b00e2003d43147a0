# SPDX-License-Identifier: LGPL-2.1-or-later
"""oil_film.py PROGRAM: oil between rollers, bushes and teeth (Contact/Oil viscosity in mPa s) in three drives that are unlike each other.

The energy balances, losses are told and add up, what pulls is as in the dry drive, the step is as well, and half of it gives the
same; oil that is switched off is none; a resumed run and one on two ranks are the same as one in one piece; what cannot have a film
is refused.
"""
import shutil
import sys

import h5py
import numpy as np

import program
from program import check

PROGRAM = sys.argv[1]
COMMON = {"Model/Stiffness from": "dimensions", "Output/History interval in us": 20, "Output/History precision": "double",
          "Output/Quantities": "speeds, tensions, engagements, energy", "Acoustics/Noise": "off", "Contact/Oil viscosity in mPa s": 100}
DRIVES = {
    "fast": {"Drive/Chain/Designation": "06B", "Drive/Driver teeth": 13, "Drive/Driven teeth": 19, "Loads/Driver speed in rpm": 3000,
             "Loads/Resisting torque in N m": 4, "Time/End time in ms": 26, "Output/Window start in ms": 6, "Output/Window end in ms": 26},
    "heavy": {"Drive/Chain/Designation": "16A", "Drive/Driver teeth": 11, "Drive/Driven teeth": 17, "Loads/Driver speed in rpm": 150,
              "Loads/Resisting torque in N m": 400, "Time/End time in ms": 60, "Output/Window start in ms": 20, "Output/Window end in ms": 60},
    "inert": {"Drive/Chain/Designation": "08B", "Drive/Driver teeth": 19, "Drive/Driven teeth": 38, "Drive/Number of links": 92,
              "Model/Driven inertia in kg m2": 0.15, "Loads/Driver speed in rpm": 900, "Loads/Resisting torque in N m": 40,
              "Time/End time in ms": 35, "Output/Window start in ms": 10, "Output/Window end in ms": 35},
}


def run(name, *options, status=0, ranks=1, **drive):
    said = program.run("prm/published/rs80.prm", {**COMMON, **drive}, "--output", name, *options, program=PROGRAM, status=status, ranks=ranks)
    return said if status else program.summary(name)


def histories(name):
    found = {}
    with h5py.File(f"{name}/histories.h5") as file:
        file.visititems(lambda path, item: found.update({path: item[:]}) if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" else None)
    return found


for name, drive in DRIVES.items():
    oiled, dry = run(name, **drive), run(name + "-dry", **{**drive, "Contact/Oil viscosity in mPa s": 0})
    check(oiled["energy_imbalance_max"] < 1e-3, f"{name}: energy imbalance {oiled['energy_imbalance_max']}")
    check(oiled["time_step"] == dry["time_step"], f"{name}: a step of {oiled['time_step']}, dry {dry['time_step']}")
    check("oil film" not in dry["losses"] and oiled["losses"]["oil film"]["energy"] > 0, f"{name}: {oiled['losses']}")
    lost = sum(one["energy"] for one in oiled["losses"].values())
    check(abs(lost / oiled["window_energy"]["lost"] - 1) < 1e-6, f"{name}: losses add up to {lost} J of {oiled['window_energy']['lost']}")
    damping = [summary["losses"]["roller-bush"]["damping"] + sum(summary["losses"][f"roller-{wheel}"]["damping"] for wheel in ("driver", "driven"))
               for summary in (oiled, dry)]
    check(damping[0] < 0.5 * damping[1], f"{name}: dashpots of contacts lose {damping[0]} J under oil, {damping[1]} J without")
    # what pulls is the torque over the radius; tensions of both spans together still swing in windows as short
    means = [summary["statistics"]["tight_tension"]["mean"] - summary["statistics"]["slack_tension"]["mean"] for summary in (oiled, dry)]
    check(abs(means[0] / means[1] - 1) < 0.03, f"{name}: effective tensions of {means}")
    half = run(name + "-half", **{**drive, "Time/Time step in us": 0.5e6 * oiled["time_step"]})
    share = half["losses"]["oil film"]["energy"] / oiled["losses"]["oil film"]["energy"]
    check(0.9 < share < 1.1, f"{name}: with half of the step the film loses {share} times as much")
    print(name, oiled["losses"]["oil film"]["power"], share, damping, means)

fast = DRIVES["fast"]
run("off", **{**fast, "Effects/Oil film": "off"})
for path, values in histories("fast-dry").items():
    check(np.array_equal(values, histories("off")[path], equal_nan=True), f"{path} is not that of the dry drive")

short = {**fast, "Time/End time in ms": 1, "Output/Window start in ms": 0, "Output/Window end in ms": 0.5, "Output/Checkpoint interval in ms": 0.4}
run("whole", **short)
run("two", ranks=2, **short)
run("parts", **{**short, "Time/End time in ms": 0.5})
run("parts", "--resume", "auto", **short)
whole, parts, two = histories("whole"), histories("parts"), histories("two")
check(len(whole) > 20, f"only {len(whole)} histories")
for path, values in whole.items():
    check(np.array_equal(values, parts[path], equal_nan=True), f"{path} is another one after resuming")
    check(np.allclose(values, two[path], rtol=1e-6, atol=1e-9 * np.nanmax(np.abs(values), initial=0.), equal_nan=True), f"{path} is another one on two ranks")
shutil.rmtree("parts")

for entries, sentence in (({"Model/Fidelity": "simple"}, "needs rigid rollers on bushes"), ({"Model/Fidelity": "reduced"}, "needs rigid rollers on bushes"),
                          ({"Drive/Chain/Rollers": "off"}, "is for rollers"), ({"Effects/Roller-bush clearance": "off"}, "needs room for oil"),
                          ({"Drive/Wheels/driven/Axial offset in mm": 1}, "in the plane of the drive"),
                          ({"Effects/Oil film": "on", "Contact/Oil viscosity in mPa s": 0}, "contradicts Contact/Oil viscosity in mPa s = 0"),
                          ({"Contact/Oil viscosity in mPa s": -1}, "Contact/Oil viscosity in mPa s")):
    said = run("refused", status=2, **{**fast, **entries})
    check(sentence in said, f"{entries}: {said}")
