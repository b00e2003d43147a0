# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries of small drives that run in a second, to be set over prm/verification/hard.prm."""
from program import REPOSITORY

RIGID = {
    "Drive/Number of links": 22,
    "Drive/Driver teeth": 9,
    "Drive/Driven teeth": 9,
    "Model/Driven inertia in kg m2": 1e-4,
    "Loads/Resisting torque in N m": 20,
    "Loads/Torque ramp angle in rad": 0.01,
    "Output/Window start in ms": 0,
}
ELASTIC = {
    **RIGID,
    "Model/Fidelity": "full",
    "Loads/Ramp time in ms": 0.01,
    "Time/End time in ms": 0.12,
    "Output/History interval in us": 2,
}
# the driver from a mesh, to be set over one of the others
IMPORTED = {
    "Drive/Number of links": 28,
    "Drive/Driver teeth": 15,
    "Drive/Sprockets/Driver outside diameter in mm": 81.8,
    "Drive/Sprockets/Driver hub diameter in mm": 33,
    "Drive/Sprockets/Driver bore in mm": 25,
    "Drive/Sprockets/Driver mesh": REPOSITORY / "meshes/sprocket-15.msh",
}
# plates so near to each other that they touch. At phase 0 round-off decides something there: 1e-8 after 0.04 ms on four ranks
TOUCHING_PLATES = {
    "Contact/Plate faces": "on",
    "Drive/Chain/Pin length in mm": 13.9402,
    "Drive/Layout/Start phase": 0.3,
}
