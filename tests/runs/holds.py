# SPDX-License-Identifier: LGPL-2.1-or-later
"""holds.py CASE PROGRAM: what a user relies on without thinking of it.

  rest      a closed chain that nothing drives, under gravity, stays where it lies
  sampling  peaks, engagements and means do not depend on how often histories are sampled
  shorter   a shorter run in the folder of a longer one leaves nothing of that
  readers   histories are read, again and again, while the run writes them
  artificial  energy of hourglass modes is that of the histories, and said where it is large
  reversal  after the load drives, the other span pulls with the torque over the pitch radius
"""
import math
import pathlib
import shutil
import subprocess
import sys
import time

import h5py
import numpy as np

import program
from program import check
from small_drives import ELASTIC, RIGID

CASE, PROGRAM = sys.argv[1:3]
BASE = "prm/verification/hard.prm"


def run(directory, entries):
    return program.run(BASE, entries, "--output", directory, program=PROGRAM)


def histories(directory):
    found = {}
    with h5py.File(f"{directory}/histories.h5") as file:
        file.visititems(lambda name, item: found.update({name: item[:]}) if isinstance(item, h5py.Dataset) else None)
    return found


def files(directory):
    return sorted(str(path.relative_to(directory)) for path in pathlib.Path(directory).rglob("*"))


def rest():
    for fidelity in ("simple", "layered"):
        entries = {
            **RIGID,
            "Model/Fidelity": fidelity,
            "Drive/Layout/Start": "settled",
            "Loads/Driver speed in rad/s": 0,
            "Loads/Resisting torque in N m": 0,
            "Time/End time in ms": 10,
        }
        run("rest", entries)
        found = histories("rest")
        path = np.hypot(*(found[f"rollers/position_{axis}"] - found[f"rollers/position_{axis}"][0] for axis in "xy"))
        # the pitch of the play: what nothing holds may fall within its clearance
        print(f"{fidelity}: no roller moves by more than {1e6 * path.max():.3g} um within 10 ms")
        free_fall = 0.5 * 9.81 * 0.01**2
        check(path.max() < 0.1 * free_fall, f"{fidelity}: a roller has moved by {path.max()} m, free fall {free_fall} m")
        check(path.max() > 0, f"{fidelity}: nothing has been computed")


def sampling():
    for fidelity in ("simple", "layered"):
        summaries, peaks = [], []
        for interval in (1, 37):
            entries = {**RIGID, "Model/Fidelity": fidelity, "Time/End time in ms": 3}
            run("sampled", {**entries, "Output/History interval in us": interval, "Output/History precision": "double"})
            summary = program.summary("sampled")
            summaries.append({key: value for key, value in summary.items() if key.endswith(("_mean", "_max")) or key in ("engagements", "impacts")})
            summaries[-1].pop("memory_peak", None)
            found = histories("sampled")
            peaks.append({name: values.max() for name, values in found.items() if name.endswith("_peak")})
        check(summaries[0] == summaries[1], f"{fidelity}: {summaries[0]}\nwith samples of 37 us: {summaries[1]}")
        check(len(peaks[0]) > 2 and len(summaries[0]) > 5, "there was nothing to compare")
        for name, value in peaks[0].items():
            check(value == peaks[1][name], f"{fidelity}: the largest {name} is {value}, with samples of 37 us {peaks[1][name]}")
        print(f"{fidelity}: {len(peaks[0])} peaks and {len(summaries[0])} members of the summary are the same")


def shorter():
    entries = {**RIGID, "Output/CSV": "true", "Output/Field interval in ms": 0.5, "Output/Checkpoint interval in ms": 0.5}
    for folder, ends in (("twice", (3, 1)), ("once", (1,))):
        shutil.rmtree(folder, ignore_errors=True)
        for end in ends:
            run(folder, {**entries, "Time/End time in ms": end})
    check(files("twice") == files("once"), f"left behind: {sorted(set(files('twice')) ^ set(files('once')))}")
    check(len(files("once")) > 8, "there was nothing to compare")
    one, two = histories("once"), histories("twice")
    check(all(np.array_equal(values, two[name], equal_nan=True) for name, values in one.items()), "other histories")
    print(f"{len(files('once'))} files are the same")


def readers():
    shutil.rmtree("read", ignore_errors=True)
    entries = {**RIGID, "Model/Fidelity": "layered", "Time/End time in ms": 60, "Output/History interval in us": 5}
    words = program.command(BASE, entries, "--output", "read", program=PROGRAM)
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    file, seen = pathlib.Path("read/histories.h5"), set()
    while process.poll() is None:
        if file.exists():
            try:
                with h5py.File(file, "r", locking=False) as opened:
                    rows = int(np.isfinite(opened["time"][:]).sum())
                    tension = opened["spans/tight_tension"][:rows]
                    check(np.isfinite(tension).all(), "a row with a time has no tension")
                    seen.add(rows)
            except (OSError, KeyError):  # between two writes of its head
                pass
        time.sleep(0.05)
    said = process.communicate()[0]
    check(process.returncode == 0, f"status {process.returncode}:\n{said}")
    check(len(seen) > 1, f"rows seen while it ran: {seen}")
    check(np.isfinite(histories("read")["time"]).all(), "rows are missing")
    print("more and more rows were read while the run wrote them")


def artificial():
    entries = {**ELASTIC, "Output/History precision": "double", "Output/History interval in us": 0.1}
    for coefficient in (0.01, 1):
        said = run("one", {**entries, "Elements/Formulation": "one point", "Elements/Hourglass coefficient": coefficient})
        share = program.summary("one")["artificial_energy"]
        found = histories("one")
        strain, hourglass = found["energy/strain"].sum(), found["energy/hourglass"].sum()
        expected = hourglass / (strain + hourglass)
        print(f"coefficient {coefficient}: {share:.3g}, from samples {expected:.3g}")
        check(abs(share / expected - 1) < 0.02, f"{share} is not {expected}")
        check(("stands for nothing" in said) == (share > 0.05), f"share {share}:\n{said}")
    run("one", entries)
    check("artificial_energy" not in program.summary("one"), "bending of enhanced elements is not artificial")


def reversal():
    torque, teeth = -54.7, 42
    entries = {
        "Drive/Layout/Start": "settled",
        "Time/End time in ms": 160,
        "Loads/Torque step time in ms": 5,
        "Loads/Torque after step in N m": torque,
        "Output/Window start in ms": 60,
        "Output/Field interval in ms": 0,
    }
    program.run("prm/paper/simple.prm", entries, "--output", "reversed", program=PROGRAM)
    summary = program.summary("reversed")
    difference = summary["tight_tension_mean"] - summary["slack_tension_mean"]
    pitch_radius = 0.5 * summary["drive"]["pitch"] / math.sin(math.pi / teeth)
    print(f"tight less slack {difference:.1f} N, torque over pitch radius {torque / pitch_radius:.1f} N")
    check(abs(difference * pitch_radius / torque - 1) < 0.03, f"{difference} N")


if CASE not in ("rest", "sampling", "shorter", "readers", "artificial", "reversal"):
    sys.exit(__doc__)
globals()[CASE]()
