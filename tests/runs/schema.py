# SPDX-License-Identifier: LGPL-2.1-or-later
"""schema.py PROGRAM: what `chaindrive document --schema` prints is what runs write.

Drives of every fidelity, one of which jumps and breaks: each history and each member of their summaries is in the
schema, histories with their unit and description; and nothing is in the schema that none of them has. The histories
of drives with guides, tensioners, shafts that yield, arms that move and three wheels, also out of line, have other names,
for which there is a star in the schema."""
import json
import re
import subprocess
import sys

import h5py

import program
from program import check
from small_drives import ELASTIC, RIGID, TOUCHING_PLATES

PROGRAM = sys.argv[1]
SCHEMA = json.loads(subprocess.run([PROGRAM, "document", "--schema"], capture_output=True, text=True, check=True).stdout)
HARD, SIMPLE = "prm/verification/hard.prm", "prm/paper/simple.prm"
SHORT = {**RIGID, "Drive/Layout/Start": "settled", "Time/End time in ms": 0.3}
RUNS = {
    "simple": (HARD, {**SHORT, "Model/Fidelity": "simple", "Loads/Drag in 1/s": 1, "Output/Until": "tight_tension_mean=5"}),
    "layered": (HARD, {**SHORT, "Model/Fidelity": "layered"}),
    "out of line": (HARD, {**SHORT, "Model/Fidelity": "layered", "Drive/Wheels/driven/Axial offset in mm": 1, "Drive/Chain/Strands": 6}),
    "reduced": (HARD, {**SHORT, "Model/Fidelity": "reduced", "Time/End time in ms": 0.1}),
    "full": (HARD, {**ELASTIC, **TOUCHING_PLATES, "Elements/Formulation": "one point", "Time/End time in ms": 0.03}),
    "jumped": (SIMPLE, {"Drive/Layout/Centre distance from": "slack", "Drive/Layout/Slack in mm": 70,
                        "Loads/Resisting torque in N m": 2000, "Time/End time in ms": 16, "Output/Window start in ms": 8}),
    "impacts": (SIMPLE, {"Time/End time in ms": 36, "Output/Window start in ms": 14, "Output/Field interval in ms": 0}),
    "shafts": ("prm/drives/coupling.prm", {"Time/End time in ms": 0.3, "Output/Window start in ms": 0}),
}
MOVED = {"Time/End time in ms": 0.3, "Output/Window start in ms": 0, "Output/Window end in ms": "auto"}
SLIDE = {"Drive/Wheels/idler/Held by": "slide", "Drive/Wheels/idler/Slide/Direction in degrees": 90,
         "Drive/Wheels/idler/Slide/Force in N": 80}
SHOE = {"Drive/Wheels/driver/Guide/Held by": "slide", "Drive/Wheels/driver/Guide/Slide/Direction in degrees": 90,
        "Drive/Wheels/driver/Guide/Slide/Force in N": 40, "Drive/Wheels/driver/Guide/Slide/Mass in g": 60}
NAMED = {"blade": ("prm/drives/blade.prm", {}), "shoe": ("prm/drives/blade.prm", SHOE), "drum": ("prm/drives/flat-idler.prm", {}), "guides": ("prm/drives/guides.prm", {}), "swing": ("prm/drives/motorcycle.prm", {}),
         "arm": ("prm/drives/tensioner.prm", {}), "slide": ("prm/drives/tensioner.prm", SLIDE),
         "three": ("prm/drives/two-loads.prm", {}),
         "three out of line": ("prm/drives/two-loads.prm", {"Model/Fidelity": "layered", "Drive/Wheels/compressor/Axial offset in mm": 1,
                                                            "Drive/Chain/Strands": 2}),
         "elastic": ("prm/drives/two-loads.prm", {"Model/Fidelity": "reduced", "Mesh/Refinement": 0, "Time/End time in ms": 0.02,
                                                  "Output/Field interval in ms": 0})}
# places of events that tests/observe/events.cc has, and none of these drives; plug-ins, and forces that they add: plugin.py;
# errors of a calibrated drive: calibrate.py
ELSEWHERE = {"events/*/roller", "events/*/span", "energy/spring", "energy/spring_damping_loss"} | {f"plugins/*/{what}" for what in ("name", "version", "path", "checksum")} | {
    f"accuracy/*/{what}" for what in ("error", "low", "high")}


def paths(value, path=""):
    """Paths of the numbers, texts and nulls in a summary; a star for each place in a list."""
    if isinstance(value, dict):
        members = value.items()
    elif isinstance(value, list):
        members = (("*", member) for member in value)
    else:
        return {path}
    return {found for name, member in members for found in paths(member, f"{path}/{name}" if path else name)}


def pattern_of(path):
    """What a path of the schema stands for."""
    return re.compile(re.escape(path).replace(r"\*", "([^/]+)"))


def described(path):
    """What the schema says of a history and where: by its name, else by the only pattern that fits."""
    if path in SCHEMA["histories"]:
        return path, SCHEMA["histories"][path]
    found = [(known, match) for known in SCHEMA["histories"] if "*" in known and (match := pattern_of(known).fullmatch(path))]
    check(len(found) == 1, f"{path}: {[known for known, _ in found]} of the schema fit")
    known, match = found[0]
    about = dict(SCHEMA["histories"][known])
    for name in match.groups():
        about["description"] = about["description"].replace("*", name.replace("_", " "), 1)
    return known, about


def main():
    patterns = {path: pattern_of(path) for path in SCHEMA["summary"]}
    unseen = {kind: set(SCHEMA[kind]) for kind in ("histories", "summary")}
    for name, (file, entries) in {**RUNS, **{name: (file, {**MOVED, **more}) for name, (file, more) in NAMED.items()}}.items():
        program.run(file, {**entries, "Output/Field interval in ms": 0}, "--quiet", "--output", name, program=PROGRAM)

        def compare(path, item):
            if isinstance(item, h5py.Dataset):
                known, about = described(path)
                for what in ("unit", "description"):
                    said = item.attrs.get(what, about[what])
                    check(said in about[what].split(" or ") if what == "unit" else said == about[what],
                          f"{name}: the {what} of {path} is {said}, and in the schema {about[what]}")
                unseen["histories"].discard(known)

        with h5py.File(f"{name}/histories.h5") as histories:
            histories.visititems(compare)
        for path in paths(program.summary(name)):
            fitting = {known for known, pattern in patterns.items() if pattern.fullmatch(path)}
            # statistics of other wheels have names that the schema does not list
            check(len(fitting) == 1 or name in NAMED, f"{name}: {len(fitting)} entries of the schema fit the member {path} of the summary")
            unseen["summary"] -= fitting
    for kind in unseen:
        unseen[kind] -= ELSEWHERE
    check(not any(unseen.values()), f"in the schema, but in no run: {unseen}")


main()
