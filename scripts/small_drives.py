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
# what a study of such a drive begins with
STUDY_OF_RIGID = f"""
include {REPOSITORY}/prm/paper/layered-auto.prm
subsection Drive
  set Number of links = 22
  set Driver teeth = 9
  set Driven teeth = 9
  subsection Sprockets
    set Driver outside diameter in mm = auto
    set Driven outside diameter in mm = auto
    set Driver hub diameter in mm = auto
    set Driver bore in mm = auto
    set Driven hub diameter in mm = auto
    set Driven bore in mm = auto
  end
  subsection Layout
    set Centre distance from = slack
    set Slack in mm = 0.1
  end
end
subsection Model
  set Driven inertia in kg m2 = 1e-4
  set Stiffness from = dimensions
end
subsection Loads
  set Ramp time in ms = 0.5
  set Resisting torque in N m = 20
  set Torque ramp angle in rad = 0.01
end
subsection Time
  set End time in ms = 2
  set Time step in us = 0.25
end
subsection Output
  set Field interval in ms = 0
  set Window start in ms = 1
end
"""
