#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fraction of the internal energy of a small full model in hourglass modes, by mesh and element
formulation; prints the table in doc/validation.md. With enhanced elements these modes are bending.

    hourglass.py      about two minutes
"""

import tempfile

import program
from hard_cases import SMALL

EVERYWHERE_4 = {
    "Mesh/Roller/Cells through wall": 4,
    "Mesh/Inner link/Cells through wall": 4,
    "Mesh/Inner link/Cells through plate": 4,
    "Mesh/Outer link/Cells through wall": 4,
    "Mesh/Outer link/Cells through plate": 4,
    "Mesh/Sprockets/Refinement": 1,
}
MESHES = {
    "refinement 1": {"Mesh/Refinement": 1},
    "refinement 2": {"Mesh/Refinement": 2},
    "– four elements through all walls and plates": {"Mesh/Refinement": 2, **EVERYWHERE_4},
    "refinement 3, four through all": {"Mesh/Refinement": 3, **EVERYWHERE_4},
}
ELEMENTS = {
    "one point, coefficient 0.1": {"Elements/Formulation": "one point"},
    "one point, 0.01": {"Elements/Formulation": "one point", "Elements/Hourglass coefficient": 0.01},
    "enhanced": {"Elements/Formulation": "enhanced"},
}
SHORT = {"Model/Fidelity": "full", "Time/End time in ms": 0.3, "Output/Window start in ms": 0.15}


def share(changes):
    """Energy of hourglass modes over that of all strain at the end of a run."""
    with tempfile.TemporaryDirectory() as folder:
        program.run("prm/verification/hard.prm", {**SMALL, **SHORT, **changes}, "--quiet", "--output", folder)
        energy = program.summary(folder)["energy"]
    return energy["hourglass"] / (energy["hourglass"] + energy["strain"])


def main():
    print("| mesh |", " | ".join(ELEMENTS), "|")
    print("|---|" + "---|" * len(ELEMENTS))
    for mesh, cells in MESHES.items():
        print(f"| {mesh} |", " | ".join(f"{100 * share({**cells, **e}):.1f} %" for e in ELEMENTS.values()), "|", flush=True)


if __name__ == "__main__":
    main()
