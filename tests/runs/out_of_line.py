# SPDX-License-Identifier: LGPL-2.1-or-later
"""out_of_line.py CASE PROGRAM: wheels that are out of line.

  static    At rest the side force is that of the stretched chain between the planes of the wheels: a beam, since pins that are askew
            in their bushes bear a moment, of the bending stiffness k l^2 p under the tension T. Its deflection is a + b x + c cosh(x /
            lambda) + d sinh(x / lambda) with lambda^2 = k l^2 p / T, and the side force T b: between that of a string, T d / L, and
            that of a beam with clamped ends, T d / (L - 2 lambda tanh(L / (2 lambda)))
  line      All wheels offset by the same, or by next to nothing: as in line, and plates touch no teeth
  mirrored  An offset against the other one: the mirror image
  tilted    Tilts along and across the line of centres: energy and momentum balance, plates hold the chain on the wheels
  resume    Goes on bit by bit, and is the same on two ranks
  hard      Worn, fast, at the largest offset that is accepted: no guard trips
"""
import functools
import math
import shutil
import sys

import numpy as np

import out_of_line_run
from drive_run import below, near
from out_of_line_run import AT_REST, BUSH_LENGTH, DIRECTION, DRIVE, OFFSET, TILT, difference
from program import check

CASE, PROGRAM = sys.argv[1:3]
run = functools.partial(out_of_line_run.run, DRIVE, PROGRAM)


def static():
    for stiffness in (4e6, 3e7):
        at_rest = {**AT_REST, OFFSET: 3, "Model/Stiffness per pitch in N/m": stiffness}
        histories, summary = run("static", at_rest)
        n, drive = DRIVE["Drive/Number of links"], summary["drive"]
        links = drive["spans"][-1]["links"]
        tension = summary["spans"]["driven_to_driver"]["tension_mean"]
        side = {wheel: summary["statistics"][f"{wheel}_side_force"]["mean"] for wheel in ("driver", "driven")}
        x, y = (histories[f"rollers/position_{axis}"][-1] for axis in "xy")
        z = histories["links/position_z"][-1]
        span = list(range(n - links, n))
        length = math.hypot(x[0] - x[n - links], y[0] - y[n - links])
        at = length * (np.arange(links) + 0.5) / links - 0.5 * length  # of the links' centres, from the middle
        decay = math.sqrt(stiffness * BUSH_LENGTH**2 / 12 * length / links / tension)
        inside = slice(2, -2)
        basis = np.stack([np.ones(links), at, np.cosh(at / decay), np.sinh(at / decay)], axis=1)
        rate = np.linalg.lstsq(basis[inside], z[span][inside], rcond=None)[0]
        fit = basis @ rate
        print(f"stiffness {stiffness:g} N/m: tension {tension:.5g} N, side forces {side}, lambda {1e3 * decay:.4g} mm of {1e3 * length:.4g}")
        below("deflection off that of a beam, of its range", np.abs(fit - z[span])[inside].max() / np.ptp(z[span]), 0.02)
        near("side force over that of the beam", side["driver"] / abs(tension * rate[1]), 1, 0.03)
        near("side force of the driven sprocket over that of the driver", side["driven"] / side["driver"], -1, 0.01)
        rise = abs(z[span[0]] - z[span[-1]]) / (links - 1) * links
        string = tension * rise / length
        clamped = string / (1 - 2 * decay / length * math.tanh(0.5 * length / decay))
        print(f"string {string:.4g} N, clamped beam {clamped:.4g} N")
        check(string < side["driver"] < clamped, f"side force {side['driver']} is not between {string} and {clamped}")
        play = 3e-3 - np.ptp(z)
        check(0 < play < 0.6e-3, f"the chain has taken up {play} m of 3 mm")
        near("force of plates on teeth over the side force", summary["statistics"]["driver_plate_force"]["mean"] / side["driver"], 1, 0.02)


def line():
    # a while in which round-off has not grown, with one step for all: faces that may touch shorten that of auto; and no dashpots, which
    # act at once where round-off says that surfaces touch
    short = {"Time/End time in ms": 0.5, "Time/Time step in us": 0.25, "Contact/Damping ratio": 0}
    in_space, _ = run("line", {**short, "Effects/Planar motion": "off"})
    names = [name for name in in_space if name.startswith(("hubs/", "spans/", "rollers/position", "rollers/velocity", "links/tension"))]
    names = [name for name in names if np.abs(in_space[name]).max() > 0]
    for what, changes in (
        ("offset together", {OFFSET: 7, "Drive/Wheels/driver/Axial offset in mm": 7}),
        ("offset by a picometre", {OFFSET: 1e-9}),
    ):
        moved, summary = run("moved", {**short, **changes})
        below(f"{what}: histories off those in line", difference(moved, in_space, names), 1e-6)
        for wheel in ("driver", "driven"):
            below(f"{what}: plates on the {wheel}'s teeth, N", summary["statistics"][f"{wheel}_plate_force"]["largest"], 0)


def mirrored():
    short = {"Time/End time in ms": 0.5}
    for entry, value in ((OFFSET, 2), (TILT, 0.5)):
        one, _ = run("one", {**short, entry: value})
        other, _ = run("other", {**short, entry: -value})
        z, force = "links/position_z", "hubs/driven_side_force"
        check(np.abs(one[z]).max() > 1e-4 and np.abs(one[force]).max() > 1, "nothing is out of line")
        below(f"{entry}: z off its mirror image, m", np.abs(one[z] + other[z]).max(), 1e-10)
        below(f"{entry}: side force off its mirror image, N", np.abs(one[force] + other[force]).max(), 1e-2)
        below(f"{entry}: tension off", difference(one, other, ["spans/driven_to_driver_tension"]), 1e-6)


def tilted():
    for direction in (0, 90):
        histories, summary = run("tilted", {TILT: 1, DIRECTION: direction, "Time/End time in ms": 60, "Output/Window start in ms": 20})
        below("energy imbalance", summary["energy_imbalance_max"], 1e-3)
        below("momentum imbalance", summary["momentum_imbalance_max"], 1e-9)
        losses = summary["losses"]
        check(losses["plate-driven"]["power"] > 0, f"plates do not rub on teeth: {losses}")
        check(not summary["events"], f"{summary['events']}")
        shares = {wheel: summary["statistics"][f"{wheel}_side_force"] for wheel in ("driver", "driven")}
        print(f"towards {direction} degrees: side forces {shares}")
        # chain, wheel and play: nothing leaves the wheels
        below("links off the plane of the drive, m", np.abs(histories["links/position_z"]).max(), 0.5e-3 + math.sin(math.radians(1)) * 70e-3)


def resume():
    entries = {OFFSET: 8, TILT: 0.3, "Time/End time in ms": 3}
    middle = 2
    for directory in ("whole", "parts", "two"):
        shutil.rmtree(directory, ignore_errors=True)
    whole, _ = run("whole", entries)
    touching = np.abs(whole["time"] - 1e-3 * middle) < 0.15e-3
    check(whole["hubs/driver_plate_force"][touching].min() > 0, "plates do not touch teeth where the run goes on")
    run("parts", {**entries, "Time/End time in ms": middle, "Output/Checkpoint interval in ms": middle})
    parts, _ = run("parts", entries, ("--resume", "auto"), says=f"Resumed from .* at {middle}")
    two, _ = run("two", entries, ranks=2)
    for name, values in whole.items():
        check(values.tobytes() == parts[name].tobytes(), f"{name} is not the same after going on")
        check(np.array_equal(values, two[name], equal_nan=True), f"{name} is not the same on two ranks")
    print(f"{len(whole)} histories are the same")


def hard():
    for name, changes in {
        "few teeth, worn": {"Drive/Driver teeth": 11, "Drive/Chain/Elongation in percent": 1, OFFSET: 5},
        "fast": {"Loads/Driver speed in rad/s": 400, OFFSET: -4, TILT: 1},
        "no friction, no damping": {"Contact/Friction coefficient": 0, "Contact/Damping ratio": 0, OFFSET: 3},
        "sharp teeth": {"Drive/Sprockets/Side relief in mm": 0, OFFSET: 1},
        "teeth as wide as they may be": {"Drive/Sprockets/Width in mm": 7.9, OFFSET: 2},
        "nearly askew by 3 degrees": {OFFSET: 15},
    }.items():
        _, summary = run("hard", {**changes, "Time/End time in ms": 20})
        print(f"{name}: energy imbalance {summary['energy_imbalance_max']:.2g}")
        below("energy imbalance", summary["energy_imbalance_max"], 5e-3)
        below("momentum imbalance", summary["momentum_imbalance_max"], 1e-9)
        below("penetration on teeth, m", max(summary["penetration_max"][f"plate-{wheel}"] for wheel in ("driver", "driven")), 1e-3)


{"static": static, "line": line, "mirrored": mirrored, "tilted": tilted, "resume": resume, "hard": hard}[CASE]()
