#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""noise.py PROGRAM: `chaindrive noise` on a short run of the paper's drive with lumped rollers.

The levels that it writes are those of its pressures, computed here once more; the pressure at the microphone is that of dipoles at the
recorded places, computed here by simpler means; a run with Acoustics/Noise = on has the same; what cannot be is refused with a
sentence, and nothing is left behind.
"""
import json
import math
import pathlib
import shutil
import sys

import h5py
import numpy as np

import program
from chaindrive.certainty import uncertainty_of_mean

PROGRAM = sys.argv[1]
RUN = {
    "Drive/Layout/Start": "settled",
    "Time/End time in ms": 12,
    "Output/Window start in ms": 3,
    "Output/Field interval in ms": 0,
}
C, DENSITY = 343.2, 1.204
results = []


def verdict(what, holds, found=""):
    print(f"{what}: {'yes' if holds else f'NO {found}'}")
    results.append(bool(holds))


def noise(directory, *options, status=0):
    done = program.start([PROGRAM, "noise", str(directory), *options])
    program.check(done.returncode == status, f"status {done.returncode} instead of {status}: {done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def refused(what, directory, *words, options=()):
    said = noise(directory, *options, status=2)
    verdict(what, all(word in said for word in words) and said.count("\n") == 1, said)


def level(square):
    return 10 * np.log10(square / 4e-10)


def dipoles(directory, observer, time):
    """Pressure at `time` of straight lines between recorded velocities, by differences of small steps: too low by 0.1 dB at 4 kHz."""
    with h5py.File(directory / "histories.h5", "r") as h:
        t = h["time"][:]
        velocity = np.stack([h["rollers/velocity_x"][:], h["rollers/velocity_y"][:]], axis=-1)
        place = np.stack([h["rollers/position_x"][:], h["rollers/position_y"][:]], axis=-1)
    mass = DENSITY * np.pi * 5.08e-3**2 * 7e-3 * (1 + 0.489)
    step = (time[1] - time[0]) / 8
    heard = (time[:, None] + step * np.arange(-3.5, 4)).ravel()
    fine = np.arange(t[0], t[-1], step)
    total = np.zeros_like(heard)
    for k in range(place.shape[1]):
        x = np.stack([np.interp(fine, t, place[:, k, d]) for d in (0, 1)] + [0 * fine], axis=-1)
        acceleration = np.stack([np.gradient(np.interp(fine, t, velocity[:, k, d]), step) for d in (0, 1)] + [0 * fine], axis=-1)
        arm = observer - x
        r = np.linalg.norm(arm, axis=1)
        far = np.sum(arm * acceleration, axis=1) / r**2
        total += np.interp(heard, fine + r / C, mass / 4 / np.pi * (np.gradient(far, step) / C + far / r))
    return total.reshape(len(time), -1).mean(axis=1)


def bands(values, step, highest):
    """Mean square up to `highest`, through Hann's window: what is not periodic in so short a record leaks from above."""
    coefficients = np.fft.rfft(values * np.hanning(len(values))) / len(values) * np.sqrt(8 / 3)
    frequency = np.fft.rfftfreq(len(values), step)
    return 2 * np.sum(np.abs(coefficients[(frequency > 0) & (frequency <= highest)]) ** 2)


run = pathlib.Path("run")
program.run("prm/paper/simple.prm", RUN, "--output", run, program=PROGRAM)
said = noise(run)
verdict("the table names the microphone", "microphone" in said and "point 12" in said and "2 pitch times" in said, said)
found = json.loads((run / "acoustics.json").read_text())
with h5py.File(run / "acoustics.h5", "r") as h:
    time, pressure = h["time"][:], h["pressure"][:]
    frequency, spectrum = h["frequency"][:], h["spectrum"][:]
    names = [name if isinstance(name, str) else name.decode() for name in h["pressure"].attrs["columns"]]
observers = found["observers"]
microphone = observers[0]
verdict("observers as in the table of pressures", names == [o["name"] for o in observers] and len(names) == 13)
verdict("whole pitch times", abs((time[1] - time[0]) * len(time) * found["tooth_frequency"] / found["periods"] - 1) < 1e-9)
verdict("lines add up to mean squares", np.allclose(spectrum.sum(axis=0), (pressure**2).mean(axis=0), rtol=1e-12, atol=0))
below = (frequency > 0) & (frequency <= found["highest_frequency"])
levels = level(spectrum[below].sum(axis=0))
verdict("levels are those of the lines", np.allclose(levels, [o["level"] for o in observers], atol=1e-9))
orders = level(spectrum[found["periods"] :: found["periods"], 0])
verdict("orders are lines", np.allclose(orders[: len(microphone["orders"])], microphone["orders"], atol=1e-9))
peaks = np.abs(pressure[:, 0]).reshape(found["periods"], -1).max(axis=1)
verdict("peaks of pitch times", np.allclose(peaks, microphone["engagement_peaks"], rtol=1e-12))
octaves = sum(10 ** (b / 10) for b in microphone["third_octaves"] if b is not None)
verdict("third octaves add up to the level within 1 dB", abs(10 * np.log10(octaves) - microphone["level"]) < 1, octaves)
verdict("a level that rollers can have", 50 < microphone["level"] < 100, microphone["level"])
driver, driven = (found["contributions"][name] for name in ("driver", "driven"))
verdict("each sprocket has its part", max(driver, driven) > microphone["level"] - 6 and min(driver, driven) < microphone["level"] + 3)
verdict("a level for each roller", [r["roller"] for r in found["rollers"]] == list(range(110)))
verdict("a level for each angle", len(found["directivity"]["angle"]) == len(found["directivity"]["level"]) == 17)

step = time[1] - time[0]
mine, theirs = (bands(p, step, 4e3) for p in (dipoles(run, np.array(microphone["position"]), time), pressure[:, 0]))
difference = abs(10 * np.log10(mine / theirs))
print(f"level up to 4 kHz {level(theirs):.2f} dB, by other means {level(mine):.2f} dB")
verdict("the same to 0.3 dB", difference < 0.3, difference)

verdict("two pitch times tell no interval", all(o[name] is None for o in observers for name in ("level_uncertainty", "level_a_uncertainty")))

long = pathlib.Path("long")
program.run("prm/paper/simple.prm", {**RUN, "Time/End time in ms": 50, "Model/Driven inertia in kg m2": 0.03}, "--output", long, program=PROGRAM)
said = noise(long)
about = json.loads((long / "acoustics.json").read_text())
drive = json.loads((long / "summary.json").read_text())["drive"]
with h5py.File(long / "acoustics.h5", "r") as h:
    step, pressure = h["time"][1] - h["time"][0], h["pressure"][:]
least = math.ceil(drive["tooth_frequency"] / drive["driven_frequency"])


def halves(weight):
    """Half intervals of the levels of all observers, with a weight by frequency."""
    lines, frequency = np.fft.rfft(pressure, axis=0), np.fft.rfftfreq(len(pressure), step)
    lines *= np.where((frequency > 0) & (frequency <= about["highest_frequency"]), weight(frequency), 0)[:, None]
    squares = (np.fft.irfft(lines, len(pressure), axis=0) ** 2).reshape(about["periods"], -1, pressure.shape[1]).mean(axis=1)
    return [10 / math.log(10) * uncertainty_of_mean(column, least) / column.mean() for column in squares.T]


def a_weight(f):
    """Of IEC 61672-1, annex E."""
    s = f**2
    return 10**0.1 * 12194.217**2 * s**2 / ((s + 20.598997**2) * np.sqrt((s + 107.65265**2) * (s + 737.86223**2)) * (s + 12194.217**2))


for which, weight in (("level", np.ones_like), ("level_a", a_weight)):
    mine, theirs = halves(weight), [o[f"{which}_uncertainty"] for o in about["observers"]]
    verdict(f"interval of {which} from {about['periods']} pitch times, at least {least} in a batch, by other means",
            least == 2 and np.allclose(mine, theirs, rtol=1e-3) and min(mine) > 0.1, f"{mine}, not {theirs}")
    verdict("in the table", f" {theirs[0]:.2g} " in next(line for line in said.splitlines() if "microphone" in line), said)

again = pathlib.Path("again")
program.run("prm/paper/simple.prm", {**RUN, "Acoustics/Noise": "on"}, "--output", again, program=PROGRAM)
verdict("a run does it at its end", json.loads((again / "acoustics.json").read_text()) == found)
noise(run, "--set", "Acoustics/Observers=0 0.5 0; 0 1 0.1", "--set", "Acoustics/Finite rollers=on", "--set", "Acoustics/Floor height in m=-0.3")
other = json.loads((run / "acoustics.json").read_text())
verdict("observers as given", [o["position"] for o in other["observers"]] == [[0, 0.5, 0], [0, 1, 0.1]])
verdict("farther is less loud", other["observers"][0]["level"] > other["observers"][1]["level"] + 3)

# what cannot be, before anything is computed
for what, entries, words in [
    ("rollers that are discs", {"Drive/Chain/Roller length in mm": 2}, ["Roller length in mm", "a quarter"]),
    ("a chain as fast as sound", {"Loads/Driver speed in rad/s": 3000, "Acoustics/Speed of sound in m/s": 100}, ["Speed of sound in m/s", "slower"]),
    ("a driver that stands", {"Loads/Driver speed in rad/s": 0}, ["needs pitch times", "Driver speed in rad/s = 0"]),
    ("an observer in the driven sprocket", {"Acoustics/Observers": "0.64 0.02 0"}, ["in a sprocket"]),
]:
    said = program.run("prm/paper/simple.prm", {**RUN, "Acoustics/Noise": "on", **entries}, "--output", "never", program=PROGRAM, status=2)
    verdict(what, all(word in said for word in words) and not pathlib.Path("never").exists(), said)

# what cannot be
refused("no directory", "nowhere", "nowhere", "no directory")
pathlib.Path("empty").mkdir(exist_ok=True)
refused("a foreign directory", "empty", "parameters.prm")
refused("another section", run, "Acoustics", options=("--set", "Loads/Drag in 1/s=1"))
refused("an observer in the chain", run, "point 1", "pitch", options=("--set", "Acoustics/Observers=0 0.04 0"))
refused("an observer in the driver", run, "point 1", "in a sprocket", "allowed", options=("--set", "Acoustics/Observers=0.005 0 0.001"))
refused("a floor above the drive", run, "Floor height", options=("--set", "Acoustics/Floor height in m=0"))
refused("too high a frequency", run, "Highest frequency", "/time", options=("--set", "Acoustics/Highest frequency in kHz=40"))
refused("a point of two numbers", run, "Observers", options=("--set", "Acoustics/Observers=1 2",))
for name, damage, words in [
    ("no summary", lambda d: (d / "summary.json").unlink(), ["summary.json", "end"]),
    ("a window that ends before it begins", lambda d: (d / "summary.json").write_text('{"window": {"start": 0.01, "end": 0.005}}'), ["summary.json", "damaged"]),
    ("a damaged summary", lambda d: (d / "summary.json").write_text("{"), ["summary.json", "damaged"]),
    ("no histories", lambda d: (d / "histories.h5").unlink(), ["histories.h5"]),
    ("histories that are none", lambda d: (d / "histories.h5").write_text("time"), ["histories.h5", "HDF5"]),
]:
    copy = pathlib.Path("copy")
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(run, copy)
    damage(copy)
    refused(name, copy, *words)


def damaged(name, words, change):
    copy = pathlib.Path("copy")
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(run, copy)
    (copy / "acoustics.json").unlink()
    with h5py.File(copy / "histories.h5", "r+") as h:
        change(h)
    refused(name, copy, "histories.h5", *words)
    verdict("nothing is left", not (copy / "acoustics.json").exists())


def replace(h, name, values):
    del h[name]
    h[name] = values


damaged("a missing channel", ["/rollers/velocity_x"], lambda h: h.__delitem__("rollers/velocity_x"))
damaged("unequal samples", ["/time", "equally"], lambda h: h["time"].__setitem__(300, h["time"][300] + 4e-6))
damaged("times that go back", ["/time"], lambda h: h["time"].__setitem__(300, 0))
damaged("rows without numbers", ["/rollers/position_y"], lambda h: h["rollers/position_y"].__setitem__((400, 3), np.nan))
damaged("some of the rollers", ["/rollers/", "110"], lambda h: replace(h, "rollers/position_x", np.zeros((601, 5))))
damaged("too coarse", ["/time", "samples", "needed"], lambda h: h["time"].__setitem__(slice(None), h["time"][:] * 100))

some = program.run("prm/paper/simple.prm", {**RUN, "Output/Rollers": "1, 2", "Acoustics/Noise": "on"}, "--output", "some", program=PROGRAM, status=2)
verdict("a run that could not compute it", "Output/Rollers" in some and "all" in some, some)
sys.exit(not all(results))
