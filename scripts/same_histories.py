#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""same_histories.py OLD NEW [CASE]...: checks whether two builds of chaindrive give bit-identical histories.

For changes of the code that must not change a result. OLD and NEW are programs; each runs a simple, a layered and some small
full and reduced drives on one and on two ranks, and every dataset of histories.h5 of OLD, in double precision, is compared byte
by byte with that of NEW, which may have more. Takes two minutes for each program on two cores. Needs Debian's python3-h5py and
python3-pandas.
"""
import pathlib
import sys
import tempfile

import h5py

import program
import chaindrive
from small_drives import ELASTIC, IMPORTED, TOUCHING_PLATES

END = "Time/End time in ms"
ALWAYS = {
    "Output/Window start in ms": 0,
    "Output/Field interval in ms": 0,
    "Output/Checkpoint interval in ms": 0,
    "Output/History precision": "double",
}
# below 110 kHz contact has a penalty, as it had before there was another one
REDUCED = {"Model/Fidelity": "reduced", "Reduction/Modes up to in kHz": 60}
SETTLED = {"Drive/Layout/Start": "settled", "Loads/Resisting torque in N m": 30}
CASES = {
    "simple": ("paper/simple", {END: 8}),
    "simple-lower": ("paper/simple", {END: 4, "Drive/Layout/Tight span": "lower"}),
    "layered": ("paper/layered", {END: 4}),
    "layered-pretension": (
        "tutorial/06b-25-25",
        {END: 2, "Drive/Layout/Start": "taut", "Drive/Layout/Centre distance from": "pretension"},
    ),
    "layered-settled": ("tutorial/06b-25-25", {END: 2}),
    "full": ("verification/hard", {**ELASTIC, **TOUCHING_PLATES}),
    "full-half-imported": ("verification/hard", {**ELASTIC, **IMPORTED, "Model/Symmetry model": "true"}),
    "full-imported-rigid": ("verification/hard", {**ELASTIC, **IMPORTED, "Model/Elastic sprockets": "off"}),
    "full-arriving": ("verification/hard", {**ELASTIC, "Model/Elastic links": "region of interest"}),
    "full-settled": ("verification/hard", {**ELASTIC, **SETTLED}),
    "reduced": ("verification/hard", {**ELASTIC, **REDUCED}),
    "reduced-settled": ("verification/hard", {**ELASTIC, **REDUCED, **SETTLED}),
    "mixed-half": (
        "verification/hard",
        {**ELASTIC, "Model/Elastic links": "region of interest", "Model/Other links": "reduced", "Model/Symmetry model": "true"},
    ),
}


def run(which, case, ranks, directory):
    """The folder of one run of the program `which`."""
    name, entries = CASES[case]
    output = directory / f"{case}-{ranks}"
    program.run(f"prm/{name}.prm", {**ALWAYS, **entries}, "--quiet", "--output", output, program=which, ranks=ranks)
    return output


def rows_of(path):
    """Every dataset as its type, shape and bytes."""
    rows = {}
    with chaindrive.open(path) as run:
        run.file.visititems(
            lambda name, item: rows.update({name: (item.dtype, item.shape, item[()].tobytes())})
            if isinstance(item, h5py.Dataset)
            else None
        )
    return rows


def main(arguments):
    if len(arguments) < 2:
        sys.exit(__doc__)
    programs, chosen = [str(pathlib.Path(p).resolve()) for p in arguments[:2]], arguments[2:] or list(CASES)
    if unknown := [case for case in chosen if case not in CASES]:
        sys.exit(f"There is no case {unknown[0]}; there are {', '.join(CASES)}.")
    different = 0
    with tempfile.TemporaryDirectory() as folder:
        for case in chosen:
            for ranks in (1, 2):
                old, new = (
                    rows_of(run(which, case, ranks, pathlib.Path(folder) / name))
                    for which, name in zip(programs, ("old", "new"))
                )
                unlike = sorted(name for name in old if old[name] != new.get(name))
                added = sorted(new.keys() - old.keys())
                verdict = f"DIFFERENT: {', '.join(unlike)}" if unlike else f"the same {len(old)} histories"
                verdict += f", and new ones: {', '.join(added)}" if added else ""
                print(f"{case:22} {ranks} rank{'s' if ranks > 1 else ' '}  {verdict}", flush=True)
                different += bool(unlike)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
