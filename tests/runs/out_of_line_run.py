# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests of wheels that are out of line share: runs of a drive with some changes, and their histories."""
import re

import h5py
import numpy as np

import program

#: Changes of hard.prm.
DRIVE = {
    "Drive/Number of links": 60,
    "Drive/Driver teeth": 15,
    "Drive/Driven teeth": 20,
    "Drive/Layout/Start": "settled",
    "Drive/Layout/Centre distance from": "slack",
    "Drive/Layout/Slack in mm": 2,
    "Model/Fidelity": "layered",
    "Model/Driven inertia in kg m2": 2e-3,
    "Loads/Driver speed in rad/s": 60,
    "Loads/Resisting torque in N m": 40,
    "Contact/Damping ratio": 0.1,
    "Output/Rollers": "all",
    "Output/History interval in us": 100,
    "Output/History precision": "double",
    "Output/Field interval in ms": 0,
    "Output/Window start in ms": 0,
    "Time/End time in ms": 10,
}
#: Of these, for the chain to come to rest under its torque.
AT_REST = {
    "Loads/Driver speed in rad/s": 0,
    "Loads/Drag in 1/s": 500,
    "Contact/Damping ratio": 0.3,
    "Contact/Friction coefficient": 0,
    "Contact/Bush-pin friction": 0.3,  # joints do not slide along their pins
    "Effects/Gravity": "off",
    "Time/End time in ms": 80,
    "Output/Window start in ms": 75,
}
OFFSET, TILT, DIRECTION = (f"Drive/Wheels/driven/{name}" for name in ("Axial offset in mm", "Tilt in degrees", "Tilt direction in degrees"))
BUSH_LENGTH = 9.94e-3  # of the 525 chain: distance of the mid-surfaces of its plates, m


def run(drive, by, directory, changes, options=(), ranks=1, says=""):
    """Histories {name: values} and summary of hard.prm with the entries of `drive` and `changes`, run by a program."""
    words = ("--output", directory, *options)
    said = program.run("prm/verification/hard.prm", {**drive, **changes}, *words, program=by, ranks=ranks)
    program.check(re.search(says, said), f"it does not say {says}:\n{said}")
    histories = {}
    with h5py.File(f"{directory}/histories.h5") as file:
        file.visititems(lambda name, item: histories.update({name: item[:]}) if isinstance(item, h5py.Dataset) else None)
    return histories, program.summary(directory)


def difference(one, other, names):
    """The largest of the histories with these names, each over the largest value of the other's."""
    return max(np.abs(one[name] - other[name]).max() / np.abs(other[name]).max() for name in names)
