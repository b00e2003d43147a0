# SPDX-License-Identifier: LGPL-2.1-or-later
"""channels.py FIDELITY PROGRAM: every history of a small drive that runs at speed.

Each is finite wherever it has a value, moves with time unless this file says why it does not, and equals what can
be computed again from others: velocities are slopes of positions, accelerations of velocities, speeds of angles;
forces on teeth sum to those on rollers; terms of energy sum to the imbalance; and the outside of an elastic roller
moves with its centre and its spin.
"""
import sys
import warnings

import h5py
import numpy as np

import program
from program import check
from small_drives import RIGID

FIDELITY, PROGRAM = sys.argv[1:3]
# what may stand still: nothing in these drives makes it move
STILL = {
    "hubs/driver_speed": "prescribed",
    "hubs/load_torque": "constant at speed",
    "energy/gravity": "its work is of round-off on a closed chain that turns",
}


def run():
    """Runs the drive from a settled start at speed; returns its histories by name, and their attributes."""
    entries = {
        **RIGID,
        "Model/Fidelity": FIDELITY,
        "Drive/Layout/Start": "settled",
        "Time/End time in ms": 0.6 if FIDELITY in ("reduced", "full") else 1,
        "Output/History interval in us": 0.5,
        "Output/History precision": "double",
        "Contact/Friction coefficient": 0.1,
    }
    program.run("prm/verification/hard.prm", entries, "--output", "results", program=PROGRAM)
    histories, attributes = {}, {}
    with h5py.File("results/histories.h5") as file:
        file.visititems(lambda name, item: histories.update({name: item[:]}) if isinstance(item, h5py.Dataset) else None)
        attributes.update(file.attrs)
    return histories, attributes


def near(what, value, expected, tolerance):
    """Compares the root of the mean square of the difference with that of what is expected."""
    rms = lambda x: np.sqrt(np.nanmean(np.square(x)))  # noqa: E731
    error = rms(value - expected) / rms(expected)
    print(f"{what}: apart by {error:.2g}")
    check(error < tolerance, f"{what}: apart by {error:.3g}, at most {tolerance} expected")


def main():
    histories, attributes = run()
    time = histories.pop("time")
    print(f"{FIDELITY}: {len(histories)} histories, {len(time)} samples")
    for name, values in sorted(histories.items()):
        columns = values.reshape(len(time), -1)
        known = ~np.isnan(columns)
        check(np.all(np.isfinite(columns[known])), f"{name} is infinite")
        check(known.any(), f"{name} has no value at all")
        if name not in STILL:
            with warnings.catch_warnings():  # a column may have no value, as the gap of a roller far from all teeth
                warnings.simplefilter("ignore", RuntimeWarning)
                moves = np.nanmax(columns, axis=0) > np.nanmin(columns, axis=0)
            check(moves.any(), f"{name} is {np.nanmax(columns):g} throughout")
            if name.startswith("rollers/position"):
                check(moves.all(), f"{name} stands still in columns {np.flatnonzero(~moves)}")

    step = time[2:] - time[:-2]
    slope = lambda values: (values[2:] - values[:-2]) / step.reshape(-1, *[1] * (values.ndim - 1))  # noqa: E731
    inside = lambda name: histories[name][1:-1]  # noqa: E731
    for axis in "xy":
        near(f"velocity_{axis} and slope of position", inside(f"rollers/velocity_{axis}"), slope(histories[f"rollers/position_{axis}"]), 0.01)
        near(f"acceleration_{axis} and slope of velocity", inside(f"rollers/acceleration_{axis}"), slope(histories[f"rollers/velocity_{axis}"]), 0.3)
    for hub in ("driver", "driven"):
        near(f"{hub}_speed and slope of angle", inside(f"hubs/{hub}_speed"), slope(histories[f"hubs/{hub}_angle"]), 0.01)
        near(f"{hub}_force on rollers and in gaps", histories[f"rollers/{hub}_force"].sum(axis=1), histories[f"teeth/{hub}_force"].sum(axis=1), 1e-9)
    terms = {name.split("/")[1]: values for name, values in histories.items() if name.startswith("energy/")}
    imbalance, supplied, taken = terms.pop("imbalance"), terms.pop("drive_work"), terms.pop("resisting_work")
    near("sum of energies and imbalance", sum(terms.values()) - sum(terms.values())[0] + taken - supplied, imbalance, 1e-6)
    if "rollers/surface_velocity_normal" in histories:
        along, normal = (np.array(str(attributes[f"span_{axis}"]).split(), dtype=float) for axis in ("direction", "normal"))
        centre = [histories[f"rollers/velocity_{axis}"] for axis in "xy"]
        relative = histories["rollers/surface_velocity_tangential"] - along[0] * centre[0] - along[1] * centre[1]
        turn = -along[0] * normal[1] + along[1] * normal[0]  # e_z x normal, along the direction of travel
        near("surface of a roller and its spin", np.mean(relative, axis=0), turn * 5.08e-3 * np.mean(histories["rollers/spin"], axis=0), 0.1)


main()
