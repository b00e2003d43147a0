# SPDX-License-Identifier: LGPL-2.1-or-later
"""facts.py PROGRAM: what `drive` in summary.json predicts against what a run does.

The paper's drive runs slowly, as a simple model that starts settled, without friction; a step of the torque lets it ring. Means of
tension and speed over its window, the first frequency of the tight span from the motion of its middle, and that of the driven inertia
from the speed of the driven sprocket must be within 3 %. The last one changes with the number of free links, which is one more or
less: the mean of its spectrum counts. Besides, --strict refuses what is warned of, and leaves nothing behind.
"""
import pathlib
import sys

import numpy as np

import program
import chaindrive

PROGRAM = sys.argv[1]
FILE = "prm/paper/simple.prm"
CHANGES = {
    "Drive/Layout/Start": "settled",
    "Loads/Driver speed in rad/s": 20,
    "Loads/Torque step time in ms": 5,
    "Loads/Torque after step in N m": 147,
    "Time/Time step in us": "auto",
    "Time/End time in ms": 250,
    "Output/Window start in ms": 20,
    "Effects/Friction": "off",
    "Output/Rollers": 0,
    "Output/Field interval in ms": 0,
}


def spectrum(run, path, least, most):
    """Frequencies in Hz between these two, and the power of the channel there."""
    time, values = run.time, run[path]
    padded = 16 * len(values)
    power = np.abs(np.fft.rfft((values - values.mean()) * np.hanning(len(values)), padded)) ** 2
    frequencies = np.fft.rfftfreq(padded, (time[-1] - time[0]) / (len(time) - 1))
    inside = (least < frequencies) * (frequencies < most)
    return frequencies[inside], power[inside]


def peak(frequencies, power):
    return frequencies[np.argmax(power)]


def mean(frequencies, power):
    return np.average(frequencies, weights=power)


def compare(name, run, predicted):
    good = abs(run / predicted - 1) < 0.03
    print(f"{name}: {run:.5g}, predicted {predicted:.5g}{'' if good else ': not within 3 %'}")
    return good


said = program.run(FILE, {}, "--strict", "--output", "refused", program=PROGRAM, status=2)
program.check("With --strict" in said and "5.76 pitches" in said, f"refused without a reason: {said}")
program.check(not pathlib.Path("refused/summary.json").exists(), "a refused run has left results behind")

said = program.run(FILE, CHANGES, "--output", "results", program=PROGRAM)
program.check(said.startswith("Drive\n"), "the log does not begin with the drive")
summary = program.summary("results")
drive = summary["drive"]
tight, slack = (next(span for span in drive["spans"] if span["label"] == label) for label in ("tight", "slack"))
names = [check["name"] for check in summary["checks"]]
program.check(not names, f"a sound drive is warned of: {names}")
with chaindrive.open("results") as histories:
    results = [
        compare("tight tension, N", summary["tight_tension_mean"], tight["tension"]),
        compare("difference of tensions, N", summary["tight_tension_mean"] - summary["slack_tension_mean"], drive["effective_tension"]),
        compare("chain speed, m/s", summary["span_speed_mean"], drive["chain_speed"]),
        compare("driver torque, N m", summary["driver_torque_mean"], drive["sprockets"][0]["torque"]),
        compare("tight span as a string, Hz", peak(*spectrum(histories, "spans/tight_offset", 20, 60)), tight["frequency"]),
        compare("driven inertia, Hz", mean(*spectrum(histories, "hubs/driven_speed", 310, 430)), drive["driven_frequency"]),
    ]

# the file that a template for a drive is: 3 kW over a chain at 21 * 15.875 mm * 1450 / min pull 372.4 N
design = ("--chain", "10B", "--teeth", "21/63", "--centre", "500", "--rpm", "1450", "--kW", "3")
made = program.start([PROGRAM, "template", *design])
program.check(made.returncode == 0, made.stderr)
pathlib.Path("drive.prm").write_text(made.stdout)
program.run(pathlib.Path("drive.prm").resolve(), {"Output/Field interval in ms": 0}, "--output", "made", program=PROGRAM)
summary = program.summary("made")
drive = summary["drive"]
results += [
    compare("driven speed, rad/s", summary["driven_speed_mean"], 1450 * np.pi / 30 / 3),
    compare("effective tension, N", drive["effective_tension"], 372.4),
]
program.check(drive["links"] % 2 == 0 and abs(drive["centre_distance"] - 0.5) < 0.5 * 0.015875, f"not the nearest even chain: {drive}")
sys.exit(not all(results))
