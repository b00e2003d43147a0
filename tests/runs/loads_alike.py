# SPDX-License-Identifier: LGPL-2.1-or-later
"""loads_alike.py PROGRAM: a load with waves over the angle of its shaft, as harmonics and as a table that says the same.

Torques at the angles that the shaft goes through are the waves themselves; the table is off them by its monotone cubic pieces, by less
than a quarter with half of their width. Angles and work of the two runs are the same but for that.
"""
import math
import pathlib
import sys

import numpy as np

import chaindrive
import program
from drive_run import below, near

PROGRAM = sys.argv[1]
RADIUS = 0.5 * 9.525e-3 / math.sin(math.pi / 19)  # of the driven sprocket, m
MEAN, WAVES = 6.0, ((1, 2.0, 30.0), (3, 0.7, -50.0))  # N m; order, amplitude in N m, phase in degrees
ENTRIES = {"Model/Fidelity": "simple", "Drive/Layout/Start": "taut", "Loads/Driver speed in rpm": 3000, "Loads/Ramp time in ms": 4,
           "Time/Time step in us": 1, "Time/End time in ms": 40, "Output/Window start in ms": 10,
           "Output/Field interval in ms": 0, "Output/History precision": "double"}


def waves(angle):
    return sum(amplitude * np.cos(order * angle + math.radians(phase)) for order, amplitude, phase in WAVES)


def off(histories):
    """How far torques are off the waves, N m, where loads have grown to all of themselves."""
    loaded = histories["angle"] > 0.05
    return np.abs(histories["torque"] - MEAN - waves(histories["angle"]))[loaded].max()


def work(histories):
    return np.trapz(histories["torque"], histories["angle"])


def run(name, entries):
    program.run("prm/twelve/06b-13-19.prm", {**ENTRIES, "Loads/Resisting torque in N m": MEAN, **entries}, "--output", name, program=PROGRAM)
    found = chaindrive.open(name)
    return {what: np.asarray(found[f"hubs/driven_{what}"]) for what in ("angle", "torque", "speed")}


def of_table(points):
    rows = [f"{degrees:.12g},{waves(math.radians(degrees)):.17g}" for degrees in np.linspace(0, 360, points + 1)]
    pathlib.Path("waves.csv").write_text("angle in degrees,torque in N m\n" + "\n".join(rows) + "\n")
    return run(f"table-{points}", {"Loads/driven/Table/File": str(pathlib.Path("waves.csv").resolve()),
                                   "Loads/driven/Table/Variable": "angle in degrees", "Loads/driven/Table/Repeats": "true"})


listed = [", ".join(f"{wave[i]:g}" for wave in WAVES) for i in range(3)]
harmonics = run("harmonics", {"Loads/driven/Harmonics/Orders": listed[0], "Loads/driven/Harmonics/Amplitudes in N m": listed[1],
                              "Loads/driven/Harmonics/Phases in degrees": listed[2]})
program.check(np.ptp(harmonics["angle"]) > 2 * math.pi, "the shaft has made less than a turn")
below("harmonics off the waves, N m", off(harmonics), 1e-9)
apart = []
for points in (36, 72):
    table = of_table(points)
    apart.append(off(table))
    print(f"{points} points: off the waves by {apart[-1]:.3g} N m")
    late = len(table["angle"]) // 2
    apart_by = RADIUS * abs((table["angle"] - harmonics["angle"])[late:].mean())  # impacts differ, and with them where slack is
    below("places of the chain with table and with harmonics apart in the mean, mm", 1e3 * apart_by, 0.1)
    near("work of the table over that of the harmonics", work(table) / work(harmonics), 1, 2e-3)
below("twice as many points, of the error", apart[1] / apart[0], 1 / 4)
program.check(apart[0] > 1e-6, "the table is not what was read")
