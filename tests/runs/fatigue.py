# SPDX-License-Identifier: LGPL-2.1-or-later
"""fatigue.py PROGRAM: what a run says of the fatigue of its plates and of its impacts, computed again from its histories.

Of windows shorter than a turn of the chain, and longer than one: turns from histories of links one behind the other, ranges
by the four-point algorithm (ISO 12110-2; the program has the three points of ASTM E1049), which finds the same cycles in a turn
that repeats. A light load does no
damage, and less than two pitches are no turn.
"""
import math
import sys

import h5py
import numpy as np

import program
from program import check

PROGRAM = sys.argv[1]
DRIVE = {
    "Drive/Number of links": 22,
    "Drive/Driver teeth": 9,
    "Drive/Driven teeth": 9,
    **{f"Drive/Sprockets/{wheel} {what} in mm": "auto" for wheel in ("Driver", "Driven")
       for what in ("outside diameter", "hub diameter", "bore")},
    "Drive/Layout/Centre distance from": "slack",
    "Drive/Layout/Slack in mm": 0.1,
    "Drive/Layout/Start": "settled",
    "Model/Driven inertia in kg m2": 1e-4,
    "Model/Stiffness from": "dimensions",
    "Loads/Driver speed in rad/s": 600,
    "Loads/Resisting torque in N m": 250,
    "Time/Time step in us": 1,
    "Output/Window start in ms": 2,
    "Output/Field interval in ms": 0,
    "Output/History interval in us": 1,
    "Output/History precision": "double",
    "Output/Quantities": "speeds, tensions, engagements, energy",
}
SLOPE, CYCLES, LIMIT, SCATTER = 10., 3e6, 1e7, 0.05


def run(name, **entries):
    changes = {key.replace("__", "/").replace("_", " ").replace("rad per s", "rad/s"): value for key, value in entries.items()}
    program.run("prm/paper/simple.prm", {**DRIVE, **changes}, "--output", name, program=PROGRAM)
    with h5py.File(f"{name}/histories.h5") as file:
        return program.summary(name), {path: file[path][:] for path in ("time", "links/tension", "hubs/driver_angle")}


def cycles_of(turn):
    """(least, most) of each cycle of a turn that repeats, by four points."""
    turn = np.roll(turn, -int(np.argmax(turn)))
    turn = np.append(turn, turn[0])
    turn = turn[np.append(True, np.diff(turn) != 0)]
    inner = (turn[1:-1] - turn[:-2]) * (turn[2:] - turn[1:-1]) < 0
    found, stack = [], []
    for value in np.concatenate([turn[:1], turn[1:-1][inner], turn[-1:]]):
        stack.append(value)
        while len(stack) > 3:
            a, b, c, d = stack[-4:]
            if not (min(a, d) <= min(b, c) and max(b, c) <= max(a, d)):
                break
            found.append((min(b, c), max(b, c)))
            del stack[-3:-1]
    if len(stack) > 2:  # the largest cycle
        found.append((min(stack), max(stack)))
    return found


def expected(summary, histories):
    """What `life` should have."""
    strength, breaking = summary["life"]["dynamic_strength"], summary["drive"]["tensile_strength"]
    time, tension = histories["time"], histories["links/tension"]
    inside = (time >= summary["window"]["start"] - 1e-12) & (time <= summary["window"]["end"] + 1e-12)
    tension, angle = tension[inside], histories["hubs/driver_angle"][inside]
    way = (angle - angle[0]) * 9 / (2 * math.pi)
    way *= np.sign(way[-1])
    n = tension.shape[1]
    pitches = 2 * int(way[-1] / 2)
    pitches = pitches if pitches < n else pitches // n * n
    at = [int(np.argmax(way >= i)) for i in range(pitches + 1)]

    def force(least, most):
        return (most - least) / (1 - (max(least, 0.) / breaking if breaking else 0.))

    def part(cycles, weak):
        sizes = [force(*cycle) / (weak * strength) for cycle in cycles]
        return sum(size ** SLOPE / CYCLES for size in sizes if size > (CYCLES / LIMIT) ** (1 / SLOPE))

    damage, early, late, forces, worst, step = [], [], [], [], (0., 0.), 0.
    for k in range(min(n, pitches)):
        pieces, done = [], 0
        while done < max(n, pitches):
            link, length = (k + done) % n, min(pitches, max(n, pitches) - done)
            pieces.append(tension[at[0]:at[length] + 1, link])
            if length == pitches:
                step = max(step, abs(tension[at[length], link] - tension[at[0], (link + pitches) % n]))
            done += pitches
        turn = np.concatenate(pieces)
        cycles = cycles_of(turn)
        turns = max(1, pitches // n)
        forces.append(max(force(*cycle) for cycle in cycles))
        if forces[-1] == max(forces):
            worst = (turn.min(), turn.max())
        damage.append(part(cycles, 1.) / turns)
        early.append(part(cycles, 1. - 2 * SCATTER) / turns)
        late.append(part(cycles, 1. + 2 * SCATTER) / turns)
    per_hour = 3600 * way[-1] / n / (time[inside][-1] - time[inside][0])
    return {"pitches": pitches, "mean": np.mean(forces), "largest": max(forces), "least": worst[0], "most": worst[1],
            "step": step / (worst[1] - worst[0]), "damage": np.mean(damage), "hours": 1 / np.mean(damage) / per_hour if any(damage) else None,
            "early": 1 / np.mean(early) / per_hour if any(early) else None, "late": 1 / np.mean(late) / per_hour if any(late) else None,
            "damages": damage,
            "safety": strength * (CYCLES / LIMIT) ** (1 / SLOPE) / max(forces)}


def half_width(values):
    """Of the 95 % interval of the mean of 10 values, each a batch: Student's distribution, and an autoregressive process of first order."""
    values = np.array(values)
    assert len(values) == 10
    off = values - values.mean()
    found = (off[1:] @ off[:-1]) / (off @ off)
    correlation = min(max(found + (1 + 3 * found) / 10, 0), 0.9)
    return 2.262157 * math.sqrt(off @ off / 9 / 10 * (1 + correlation) / (1 - correlation))


def compare(name, summary, histories, pitches):
    life = summary["life"]
    fatigue, should = life["fatigue"], expected(summary, histories)
    check(fatigue["pitches"] == pitches == should["pitches"], f"{name}: {fatigue['pitches']} pitches, not {pitches}, {should['pitches']}")
    found = {"mean": fatigue["force"]["mean"], "largest": fatigue["force"]["largest"], "least": fatigue["least"], "most": fatigue["most"],
             "step": fatigue["step"], "damage": fatigue["damage"], "hours": life.get("simulated_plate_hours"),
             "early": life.get("early_plate_hours"), "late": life.get("late_plate_hours"), "safety": life["simulated_plate_safety"]}
    for what, value in found.items():
        if should[what] is None or value is None:
            check(should[what] is None and value is None, f"{name}: {what} = {value}, not {should[what]}")
        else:
            check(abs(value - should[what]) <= 1e-3 * abs(should[what]) + 1e-12, f"{name}: {what} = {value}, not {should[what]}")
    check(fatigue["turns"] == min(pitches, 22), f"{name}: {fatigue['turns']} turns")
    check((fatigue["force"]["uncertainty"] is None) == (fatigue["turns"] < 4), f"{name}: an interval of {fatigue['turns']} turns")
    # stresses of closed forms are those of the tension in the tight span
    most = max(span["tension"] for span in summary["drive"]["spans"])
    for plate in ("inner_plate", "outer_plate"):
        for place in ("waist", "hole"):
            stress = life[plate][place] * (fatigue["most"] - fatigue["least"]) / most
            check(abs(fatigue[plate][place] / stress - 1) < 1e-9, f"{name}: {place} of {plate}")
    return life


short, of_short = run("short", Time__End_time_in_ms=26, Loads__Driver_speed_in_rad_per_s=300, Loads__Resisting_torque_in_N_m=100)
life = compare("a window of half a turn", short, of_short, 10)
check("simulated_plate_hours" in life and life["early_plate_hours"] < 0.7 * life["simulated_plate_hours"], "plates are not overloaded")
spread = math.log1p(half_width(expected(short, of_short)["damages"]) / life["fatigue"]["damage"])
check(abs(life["certainty"]["plates"]["batches"] / math.expm1(spread) - 1) < 1e-4, f"{life['certainty']}, not {math.expm1(spread)} of the run")
for end, other in (("low", "early_plate_hours"), ("high", "late_plate_hours")):
    wide = math.hypot(spread, math.log(life[other] / life["simulated_plate_hours"]))
    check(abs(abs(math.log(life["certainty"]["plates"][end] / life["simulated_plate_hours"])) / wide - 1) < 1e-4, f"{end}: {life['certainty']}, not {wide}")
check("rollers" not in life["certainty"], f"an interval of fewer than four groups of impacts: {life['certainty']}")
peaks = [e["peak_force"] for e in short["engagements"] if e["sprocket"] == "driver" and e["complete"] and e["time"] >= 2e-3]
peak = np.mean(np.power(peaks, 2.5)) ** 0.4
check(abs(life["impacts"]["peak"] / peak - 1) < 1e-9, f"peaks: {life['impacts']['peak']}, not {peak}")
capacity = (life["roller_hours"] / (15000 * 0.22)) ** 0.4
pull, phi = max(span["tension"] for span in short["drive"]["spans"]) - short["drive"]["centrifugal_tension"], math.radians(35 - 120 / 9)
seat = pull * math.sin(2 * math.pi / 9) / math.sin(2 * math.pi / 9 + phi)
rated = min(np.mean(peaks) + (capacity - 1) * seat, capacity * np.mean(peaks))
check(abs(life["impacts"]["rated_peak"] / rated - 1) < 1e-6, f"rated peak: {life['impacts']['rated_peak']}, not {rated}")
hours = 15000 * 0.22 * (rated / peak) ** 2.5
check(abs(life["simulated_roller_hours"] / hours - 1) < 1e-5, f"{life['simulated_roller_hours']} h, not {hours}")
check(hours < life["roller_hours"], "peaks that scatter last longer than the rating")

whole, of_whole = run("whole", Time__End_time_in_ms=30)
compare("a window of more than a turn", whole, of_whole, 22)

few, of_few = run("few", Time__End_time_in_ms=40, Loads__Driver_speed_in_rad_per_s=50, Loads__Resisting_torque_in_N_m=10)
life = compare("a window of two pitches", few, of_few, 2)
check("certainty" not in life, f"an interval of two turns: {life}")
check("simulated_plate_hours" not in life and "impacts" not in life, f"hours of light loads, or of two impacts: {life}")

none, _ = run("none", Time__End_time_in_ms=3)
check("fatigue" not in none["life"] and "simulated_plate_safety" not in none["life"], "fatigue from less than two pitches")
print("OK", life["simulated_plate_safety"])
