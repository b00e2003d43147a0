# SPDX-License-Identifier: LGPL-2.1-or-later
"""strands.py CASE PROGRAM: chains of several strands against the chain of one strand with its share.

  simple, layered  The drive of prm/drives/duplex.prm, with a guide and a load that grows with the speed: of two strands with twice
                   the torques, the inertia and the spring every number is that of one strand, bit by bit, or twice as great: by its
                   unit (J, W, N m) or because it is the force on a shaft or guide
  reduced, full    the same of the first steps of a small drive, and of its half model
  resume           a run of three strands that is interrupted and resumed has the histories of one that is not; the number of
                   strands cannot change; and on two ranks a reduced drive of two has those of one rank
  noise            the pressure of two strands is twice that of one, 6 dB
  plan             design data, refusals, the file that select writes
"""
import json
import pathlib
import re
import sys

import h5py
import numpy as np

import program
from program import check

CASE, PROGRAM = sys.argv[1:3]
DUPLEX = "prm/drives/duplex.prm"
SHARES = {"Drive/Wheels/idler/Arm/Moment in N m": 10, "Drive/Wheels/idler/Arm/Stiffness in N m/rad": 16,
          "Drive/Wheels/idler/Arm/Damping in N m s/rad": 0.1, "Drive/Wheels/idler/Arm/Inertia in kg m2": 4e-4,
          "Model/Driven inertia in kg m2": 0.04, "Loads/Resisting torque in N m": 40, "Loads/driven/Of speed/Linear in N m s": 0.01,
          "Loads/Torque after step in N m": 60}
COMMON = {"Loads/Torque step time in ms": 12, "Time/End time in ms": 20, "Output/Window start in ms": 5, "Output/History precision": "double",
          "Drive/Wheels/driven/Guide/Points in mm": "330, 75.8; 200, 61.95; 70, 48.3", "Output/Quantities": "all", "Output/Field interval in ms": 0}
SMALL = {"Drive/Chain/Designation": "06B", "Drive/Number of links": 34, "Drive/Driver teeth": 13, "Drive/Driven teeth": 19,
         "Drive/Layout/Start": "taut", "Time/End time in ms": 0.3, "Output/Window start in ms": 0, "Output/History interval in us": 10,
         "Output/History precision": "double", "Output/Field interval in ms": 0, "Output/Quantities": "speeds, tensions, tooth forces, energy"}
SMALL_SHARES = {"Model/Driven inertia in kg m2": 0.001, "Loads/Resisting torque in N m": 9}
DESIGN = {"checks", "life", "wall_seconds", "cpu_seconds", "memory_peak", "phases", "cost", "ranks", "program", "step", "accuracy"}
FIGURES = {"strands", "tensile_strength", "safety", "rated_power", "highest_speed"}  # closed forms: test drive/strands
WHOLE = {"torque", "inertia", "driven_inertia", "shaft_load", "power"}  # of drive


def of_all(unit, path):
    """Whether a number with this unit is that of all strands."""
    return unit in ("J", "W", "N m") or path.startswith("guides/") or (path.startswith("hubs/") and unit == "N")


def histories(folder):
    found = {}
    with h5py.File(f"{folder}/histories.h5") as file:
        file.visititems(lambda name, item: found.update({name: (item[:], item.attrs.get("unit", ""))})
                        if isinstance(item, h5py.Dataset) else None)
    return found


def compare_histories(several, one, factor):
    check(several.keys() == one.keys(), f"other histories: {several.keys() ^ one.keys()}")
    doubled = 0
    for path, (values, unit) in several.items():
        if values.dtype.kind != "f":
            continue
        unit = unit.decode() if isinstance(unit, bytes) else str(unit)
        whole = of_all(unit, path)
        doubled += whole and bool(np.any(values != 0))
        wanted = one[path][0] * (factor if whole else 1)
        check(np.array_equal(values, wanted, equal_nan=True),
              f"{path} ({unit}) is not {'so many times ' if whole else ''}that of one strand: by {np.nanmax(np.abs(values - wanted)):.3g} "
              f"of {np.nanmax(np.abs(wanted)):.3g}")
    check(doubled >= 6, f"only {doubled} histories are of all strands")
    return doubled


def leaves(value, path=()):
    if isinstance(value, dict):
        for name, item in value.items():
            yield from leaves(item, (*path, name))
    elif isinstance(value, list):
        for number, item in enumerate(value):
            yield from leaves(item, (*path, str(number)))
    else:
        yield path, value


def compare_summaries(several, one, factor):
    several, one = ({path: value for path, value in leaves(all_of) if path[0] not in DESIGN} for all_of in (several, one))
    check(several.keys() == one.keys(), f"other members: {several.keys() ^ one.keys()}")
    doubled = 0
    for path, value in several.items():
        if not isinstance(value, (int, float)) or isinstance(value, bool):
            check(value == one[path], f"{path}: {value}, {one[path]}")
            continue
        if path[0] == "drive" and path[-1] in FIGURES:
            continue
        scalar = re.sub(r"_(mean|min|max|std|rms|amplitude|ripple|p\d+|drift|error|start)\b.*", "", path[-1])
        whole = (path[0] == "drive" and path[-1] in WHOLE) or path[0] in ("energy", "drive_work", "resisting_work", "energy_turned_over") or \
            (path[0] in ("losses", "window_energy") and path[-1] != "duration")
        free = "torque" in path[0] or "_load" in path[0] or path[0] == "statistics" or scalar.endswith(("_load", "driver_torque"))
        if free:  # some are ratios, others directions
            check(value in (one[path], factor * one[path]), f"{path}: {value}, {one[path]}")
        else:
            check(value == one[path] * (factor if whole else 1), f"{path}: {value}, {one[path]}, {whole}")
        doubled += bool(value) and value == factor * one[path]
    check(doubled >= 8, f"only {doubled} members are of all strands")
    return doubled


def pair(file, common, shares, strands=2):
    """The same drive of `strands` and of one."""
    for folder, n, part in (("several", strands, 1), ("one", 1, 1 / strands)):
        entries = {**common, "Drive/Chain/Strands": n, **{name: repr(value * part) for name, value in shares.items()}}
        said = program.run(file, entries, "--output", folder, program=PROGRAM)
        check(("strands share the load equally" in said) == (n > 1), said)
    return compare_histories(histories("several"), histories("one"), strands), \
        compare_summaries(program.summary("several"), program.summary("one"), strands)


if CASE in ("simple", "layered"):
    print("OK", *pair(DUPLEX, {**COMMON, "Model/Fidelity": CASE}, SHARES))
elif CASE in ("reduced", "full"):
    for half in ("false", "true"):
        print("OK", *pair("prm/verification/hard.prm", {**SMALL, "Model/Fidelity": CASE, "Model/Symmetry model": half}, SMALL_SHARES))
elif CASE == "resume":
    entries = {**COMMON, **SHARES, "Drive/Chain/Strands": 3, "Output/Checkpoint interval in ms": 3}
    program.run(DUPLEX, entries, "--output", "whole", program=PROGRAM)
    program.run(DUPLEX, {**entries, "Time/End time in ms": 9}, "--output", "parts", program=PROGRAM)
    said = program.run(DUPLEX, {**entries, "Drive/Chain/Strands": 2}, "--output", "parts", "--resume", "auto", program=PROGRAM, status=2)
    check("Drive/Chain/Strands" in said, said)
    program.run(DUPLEX, entries, "--output", "parts", "--resume", "auto", program=PROGRAM)
    whole, parts = histories("whole"), histories("parts")
    for path, (values, unit) in whole.items():
        check(np.array_equal(values, parts[path][0], equal_nan=values.dtype.kind == "f"), f"{path} is another one after resuming")
    small = {**SMALL, **SMALL_SHARES, "Drive/Chain/Strands": 2, "Model/Fidelity": "reduced"}
    for ranks in (1, 2):
        program.run("prm/verification/hard.prm", small, "--output", f"on-{ranks}", program=PROGRAM, ranks=ranks)
    one, two = histories("on-1"), histories("on-2")
    for path in ("hubs/driver_torque", "hubs/driver_load_x", "energy/kinetic", "energy/drive_work"):
        difference = np.max(np.abs(one[path][0] - two[path][0])) / np.max(np.abs(one[path][0]))
        check(difference < 1e-9, f"{path} differs on two ranks by {difference:.2g}")
    print("OK")
elif CASE == "noise":
    noise = {**COMMON, "Acoustics/Noise": "on", "Output/History interval in us": 20, "Output/Rollers": "all"}
    pair(DUPLEX, noise, SHARES)
    two, one = (json.loads(pathlib.Path(folder, "acoustics.json").read_text()) for folder in ("several", "one"))
    for a, b in zip(two["observers"], one["observers"]):
        more = a["level"] - b["level"]
        check(abs(more - 20 * np.log10(2)) < 1e-6 and abs(a["peak_pressure"] / b["peak_pressure"] - 2) < 1e-9, f"{more} dB more")
    print("OK", more)
elif CASE == "plan":
    plan = program.run(DUPLEX, {"Model/Stiffness from": "dimensions"}, "--plan", program=PROGRAM)
    for line in ("2 strands of 08B", "0.7 kg/m each, break together at 31.1 kN", "of one strand: effective 26", ", 40 N m,", "0.04 kg m2",
                 "2 strands share the load equally", "Mass of the chain 0.7 kg/m, of catalogues"):
        check(line in plan, f"the plan does not say '{line}':\n{plan}")
    turned, moment = map(float, re.search(r"turned by ([\d.]+) degrees and presses with ([\d.]+) N m", plan).groups())
    check(abs(moment - (10 - 16 * np.radians(turned))) < 2e-3, f"the spring of all strands presses with {moment} N m")
    for changes, sentence in (({"Drive/Chain/Strands": 0}, r"Strands = 0"), ({"Drive/Chain/Strands": 7}, r"Strands = 7"),
                              ({"Drive/Chain/Strands": -1}, r"Strands = -1"), ({"Drive/Chain/Strands": 1.5}, r"Strands = 1\.5"),
                              ({"Drive/Chain/Strands": "nan"}, r"Strands = nan"),
                              ({"Drive/Chain/Designation": "08B-2"}, r"Choose Designation = 08B and Strands = 2\."),
                              ({"Model/Mass from": "weight"}, r"Mass from"), ({"Material/Density in kg/m3": 0}, r"Density in kg/m3 = 0"),
                              ({"Duplex": 2}, "share the load equally")):
        said = program.run(DUPLEX, changes, "--plan", program=PROGRAM, status=2)
        check(re.search(sentence, said), f"{changes}: {said}")
    # with the power of all strands, and as many as the table has
    done = program.start([PROGRAM, "select", "--kW", "60", "--rpm", "1000", "--ratio", "2", "--centre", "900", "--output", "best.prm"])
    check(done.returncode == 0, done.stderr)
    first, text = done.stdout.splitlines()[2].split(), pathlib.Path("best.prm").read_text()
    chain, strands = first[0].split("-")
    check(int(strands) > 1, f"the first is {first}")
    for entry in (f"set Designation = {chain}", f"set Strands = {strands}", "set Power in kW = 60"):
        check(entry in text, f"the file has no '{entry}':\n{text}")
    plan = program.run(pathlib.Path("best.prm").absolute(), {"Model/Stiffness from": "dimensions"}, "--plan", program=PROGRAM)
    facts = [line for line in plan.splitlines() if line.startswith("  usual limits")][0]
    rated = float(re.search(r"([\d.]+) kW", facts)[1])
    check(abs(rated / 60 / float(first[7]) - 1) < 0.02, f"rated {rated} kW, the selection says {first[7]} times the power: {facts}")
    done = program.start([PROGRAM, "template", "--chain", "10B", "--teeth", "21/63", "--centre", "500", "--rpm", "1450", "--kW", "3", "--strands", "9"])
    check(done.returncode == 2 and "--strands = 9" in done.stderr, done.stderr)
    print("OK", rated)
else:
    sys.exit(f"no case {CASE}")
