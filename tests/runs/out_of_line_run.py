# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests of wheels that are out of line share: runs of a drive with some changes, and their histories."""
import re

import h5py
import numpy as np

import program


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
