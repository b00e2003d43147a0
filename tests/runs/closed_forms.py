# SPDX-License-Identifier: LGPL-2.1-or-later
"""closed_forms.py tutorials | forms PROGRAM REPOSITORY: every drive of prm/tutorial, or one with each other tooth form, against
what any chain drive gives on average over whole pitches, whatever happens within one:

  speed ratio                  z1 / z2
  speed of the tight span      z1 p w1 / 2 pi
  tight less slack tension     2 pi T2 / (z2 p)

They run as simple models that start settled, at full speed and under load, and without friction: the averages mean something after
five pitches. A small driven inertia, where one is given below, swings fast enough on the tight span to average out. Speeds must be
right to 0.3 %, tensions to the percentage below. With its own model and start each file runs its first 2 ms;
the chain of a bicycle under a heavy rider, 200 N m, must stay on its teeth.
"""
import math
import pathlib
import re
import sys

import program

CASE, PROGRAM, TUTORIALS = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]) / "prm/tutorial"
PITCH = {"06B": 9.525e-3, "08B": 12.7e-3, "12A": 19.05e-3, "525": 15.875e-3}  # ISO 606; motorcycle

# step in us, pitches in the window, accuracy of the tension in %, changes. At 11 m/s with little torque impacts take some per
# cent of the power of the 06B chain, half of it at the driven sprocket.
DRIVES = {
    "06b-25-25": (1.6, 25, 8, {}),
    "08b-19-57": (2, 19, 1.5, {"Model/Driven inertia in kg m2": 4e-3}),
    "12a-11-23-low-speed": (5, 2, 1.5, {"Model/Driven inertia in kg m2": 5e-3}),
    "525-14-41": (2.4, 14, 1.5, {"Model/Driven inertia in kg m2": 5e-3}),
}
FORMS = ("iso mid", "iso max", "ansi")  # the tutorials have iso min


def run(name, entries):
    entries = {"Output/Field interval in ms": 0, **entries}
    program.run(TUTORIALS / f"{name}.prm", entries, "--quiet", "--output", "results", program=PROGRAM)
    return program.summary("results")


def compare(name, form):
    """Prints the means over the closed forms and says whether they are right."""
    text = (TUTORIALS / f"{name}.prm").read_text()

    def given(entry):
        return re.search(rf"set {entry}\s*=\s*(\S+)", text)[1]

    pitch, z1, z2 = PITCH[given("Designation")], int(given("Driver teeth")), int(given("Driven teeth"))
    speed, torque = float(given("Driver speed in rad/s")), float(given("Resisting torque in N m"))
    step, pitches, accuracy, changes = DRIVES[name]
    pitch_time = 2 * math.pi / (z1 * speed)
    first = 1 if speed < 10 else 5  # a slow drive has settled sooner
    window = 1e3 * first * pitch_time, 1e3 * (first + pitches) * pitch_time
    got = run(
        name,
        {
            "Model/Fidelity": "simple",
            "Drive/Sprockets/Tooth form": form,
            "Drive/Layout/Start": "settled",
            "Effects/Friction": "off",
            "Time/Time step in us": step,
            "Time/End time in ms": window[1],
            "Output/Window start in ms": window[0],
            "Output/Window end in ms": window[1],
            "Output/Rollers": 0,
            "Output/History interval in us": 1000,
            **changes,
        },
    )
    good = True
    for what, value, closed_form, percent in (
        ("speed ratio", got["driven_speed_mean"] / speed, z1 / z2, 0.3),
        ("speed of the tight span", got["span_speed_mean"], z1 * pitch * speed / (2 * math.pi), 0.3),
        ("tight less slack tension", got["tight_tension_mean"] - got["slack_tension_mean"], 2 * math.pi * torque / (z2 * pitch), accuracy),
    ):
        right = abs(value / closed_form - 1) <= percent / 100
        good = good and right
        print(f"{name}, {form}: {what} {value:.6g}, {value / closed_form:.5f} of it{'' if right else f': not within {percent} %'}")
    return good


def bicycle():
    """Whether a bicycle's chain carries 200 N m at a chainwheel of 44 teeth, rollers on the teeth and not in or beyond them."""
    design = ("--chain", "085", "--teeth", "44/16", "--centre", "430", "--rpm", "60", "--kW", "1.2566")
    made = program.start([PROGRAM, "template", *design])
    pathlib.Path("bicycle.prm").write_text(made.stdout)
    changes = {"Output/Field interval in ms": 0, "Time/End time in ms": 60, "Output/Window start in ms": 0}
    program.run(pathlib.Path("bicycle.prm").resolve(), changes, "--quiet", "--output", "bicycle", program=PROGRAM)
    got = program.summary("bicycle")
    overlap = max(got["penetration_max"].values()) / 3.885e-3  # over the roller's radius
    ratio, torque = got["driven_speed_mean"] / (2 * math.pi * 44 / 16), got["driver_torque_mean"] / 200
    good = 0 < overlap < 0.01 and abs(ratio - 1) < 0.003 and abs(torque - 1) < 0.01
    print(f"bicycle: overlap {overlap:.2g} of the roller's radius, ratio {ratio:.5f}, torque {torque:.5f}{'' if good else ': WRONG'}")
    return good


def tutorials():
    there = {file.stem for file in TUTORIALS.glob("*.prm")}
    if there != DRIVES.keys():
        sys.exit(f"only in prm/tutorial or here: {sorted(there ^ DRIVES.keys())}")
    wrong = [name for name in DRIVES if not compare(name, "iso min")]
    for name in DRIVES:
        run(name, {"Time/End time in ms": 2, "Output/Window start in ms": 0})
    return wrong if bicycle() else [*wrong, "bicycle"]


def main():
    wrong = tutorials() if CASE == "tutorials" else [form for form in FORMS if not compare("525-14-41", form)]
    sys.exit(f"wrong: {wrong}" if wrong else 0)


main()
