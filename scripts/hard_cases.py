# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hard cases: what is changed in hard.prm, and which models are to hold it."""

from typing import NamedTuple

# What full and reduced models are made of in these cases: a small drive, or they would take hours. It
# turns until the next roller has come in.
SMALL = {
    "Drive/Number of links": 22,
    "Drive/Driver teeth": 9,
    "Drive/Driven teeth": 9,
    "Drive/Layout/Slack in mm": 0.1,
    "Model/Symmetry model": "true",
    "Model/Driven inertia in kg m2": 1e-4,
    "Mesh/Refinement": 0,
    "Loads/Resisting torque in N m": 20,
    "Loads/Torque ramp angle in rad": 0.01,
    "Loads/Ramp time in ms": 0.5,
    "Time/End time in ms": 6,
    "Output/Window start in ms": 3,
}


# Full models with side plates and bushes of solid-shells, and as prm/paper/full-shell.prm has them; reduced ones without
# penalty.
VARIANTS = {
    "h": {"Model/Fidelity": "full", "Elements/Plates": "solid-shell", "Elements/Bushes": "solid-shell"},
    "m": {"Model/Fidelity": "full", "Elements/Plates": "membrane", "Elements/Bushes": "solid-shell", "Effects/Plate bending": "off"},
    "r": {"Model/Fidelity": "reduced", "Contact/Enforcement": "penalty"},
    "e": {"Model/Fidelity": "reduced"},
}
ELASTIC = "fhmre"


# With --quick: an end before which all cases have begun to be hard.
SOON = {"Time/End time in ms": 2.5, "Output/Window start in ms": 1}


# Where the step is small.
SHORT = {"Time/End time in ms": 1, "Output/Window start in ms": 0.5, "Loads/Ramp time in ms": 0.5}


def for_long(ms):
    """Energies at every 0.1 ms, and little else."""
    history = {"Output/CSV": "true", "Output/Rollers": 0, "Output/History interval in us": 100}
    return {"Time/End time in ms": ms, **history}


class Case(NamedTuple):
    name: str
    models: str  # s: simple, l: layered, f: full, and with the same changes full of solid-shells or membranes, and reduced, with and without penalty
    changes: dict  # of hard.prm, for all models
    of_model: dict = {}  # {model letter: further changes}
    refusal: str = ""  # a regular expression in what the program must say instead of running
    overlap: float = 0.5  # largest, in mm: a tenth of a roller's radius
    imbalance: float = 0.01  # largest, over the energy turned over
    long: str = ""  # models that --quick leaves out
    soon: str = ""  # full models that it does not leave out
    long_run: bool = False  # the imbalance over the drive work must not grow
    step: float = 0.0  # over the critical one, instead of that in hard.py


def slack(mm, full=None):
    """Of the slack span; of the small drive's, which is a quarter as long, @p full."""
    return {"s": slack_is(mm), "l": slack_is(mm), "f": slack_is(full)}


def slack_is(mm):
    return {"Drive/Layout/Slack in mm": mm}


def penalty(factor):
    return {
        "s": {"Contact/Roller-tooth stiffness in N/m": 2.12e7 * factor},
        "l": {
            "Contact/Roller-tooth stiffness in N/m": 2.12e7 * factor,
            "Contact/Roller-bush stiffness in N/m": 5.73e8 * factor,
        },
        "f": {"Contact/Penalty factor": 0.5 * factor, "Loads/Ramp time in ms": 0.5},
    }


def clearance(mm):
    """Of both cylinders, on the radius; the 525 chain has 0.045 mm."""
    return {"Drive/Chain/Roller bore in mm": 7.43 + 2 * mm, "Drive/Chain/Pin diameter in mm": 5.33 - 2 * mm}


def torque_becomes(torque):
    """In one step, when the load is on."""
    whole = {"Loads/Torque step time in ms": 1.5, "Loads/Torque after step in N m": torque}
    return {"s": whole, "l": whole, "f": {**whole, "Loads/Torque after step in N m": torque * 20 / 150}}


LOW_TEETH = {"Drive/Sprockets/Driver outside diameter in mm": 77, "Drive/Sprockets/Driven outside diameter in mm": 214}

CASES = [
    Case("base", "slf", {}, soon="hm"),
    Case("largest step", "s", {}, step=0.9),  # full: base
    Case("largest step", "l", {}, step=0.5),  # beyond, impacts cost more energy than the guard accepts
    Case("penalty x100", "slf", {}, penalty(100), long="l"),
    Case("penalty x0.1", "slf", {"Loads/Ramp time in ms": 5}, penalty(0.1), overlap=1.25),
    Case("penalty x0.01", "sl", {}, penalty(0.01), refusal="Roller-tooth stiffness.*quarter of its radius"),
    Case("penalty x0.01", "f", {}, penalty(0.01)),
    Case("clearance 0", "lf", clearance(0), refusal="leave a radial clearance"),
    Case("clearance 1 um", "lf", clearance(0.001)),
    Case("clearance 0.5 mm", "lf", clearance(0.5), overlap=1),
    Case("friction 0", "slf", {"Contact/Friction coefficient": 0}),
    Case("friction 0.05", "slf", {"Contact/Friction coefficient": 0.05}),
    Case("friction 0.8", "slf", {"Contact/Friction coefficient": 0.8}),
    Case("undamped", "slf", {"Contact/Damping ratio": 0, "Model/Chain damping ratio": 0}),
    Case("10 times the speed", "sl", {"Loads/Driver speed in rad/s": 1207.4, "Drive/Layout/Start": "settled"}, overlap=2),
    Case("10 times the speed", "f", {"Loads/Driver speed in rad/s": 1207.4}),
    Case("torque reversed", "slf", {}, torque_becomes(-150)),
    Case("torque removed", "slf", {}, torque_becomes(0)),
    Case("ramp of 0.1 ms", "slf", {"Loads/Ramp time in ms": 0.1}),
    Case("start at full speed", "slf", {"Loads/Ramp time in ms": 0}),
    Case("slack", "slf", {}, slack(20, 3)),
    Case("much slack", "slf", {"Time/End time in ms": 20}, slack(70, 9)),
    Case("too much slack", "sl", {}, slack(100), refusal="no route around these sprockets"),
    # rings of lumped rollers roll over the teeth and jam at 1200 N m, as without friction
    Case("jumps a tooth", "sl", {"Time/End time in ms": 40, **LOW_TEETH}, {
        "s": {"Drive/Layout/Slack in mm": 70, "Loads/Resisting torque in N m": 600},
        "l": {"Drive/Layout/Slack in mm": 70, "Loads/Resisting torque in N m": 1200},
    }, overlap=1.25),
    Case("whipping", "slf", {"Loads/Resisting torque in N m": 0.5, "Time/End time in ms": 30}, slack(10, 2)),
    Case("worn by 2.5 %", "slf", {"Drive/Chain/Elongation in percent": 2.5}),
    Case("9 and 114 teeth", "slf", {"Drive/Driver teeth": 9, "Drive/Driven teeth": 114, "Drive/Number of links": 160},
         {"f": {"Model/Driven inertia in kg m2": "auto", "Loads/Ramp time in ms": 5,
                "Time/End time in ms": 3, "Output/Window start in ms": 1}}),
    Case("20 links", "slf", {"Drive/Driver teeth": 9, "Drive/Driven teeth": 9, "Drive/Number of links": 20}),
    Case("600 links", "sl", {"Drive/Number of links": 600}),
    Case("stiffness jump 1e4", "sl", SHORT, {
        "s": {"Model/Stiffness per pitch in N/m": 2.12e11},
        "l": {"Contact/Roller-bush stiffness in N/m": 2.12e11},
    }, overlap=1, long="sl"),
    Case("nu 0.495", "f", {"Material/Poisson's ratio": 0.495}),
    Case("1 s", "s", for_long(1000), long="s", long_run=True, step=0.16),
    Case("0.2 s", "l", for_long(200), long="l", long_run=True, step=0.28),
]
