# SPDX-License-Identifier: LGPL-2.1-or-later
"""schema.py PROGRAM: what `chaindrive document --schema` prints is what runs write.

Drives of every fidelity, one of which jumps and breaks: each history and each member of their summaries is in the
schema, histories with their unit and description; and nothing is in the schema that none of them has."""
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
    "reduced": (HARD, {**SHORT, "Model/Fidelity": "reduced", "Time/End time in ms": 0.1}),
    "full": (HARD, {**ELASTIC, **TOUCHING_PLATES, "Elements/Formulation": "one point", "Time/End time in ms": 0.03}),
    "jumped": (SIMPLE, {"Drive/Layout/Centre distance from": "slack", "Drive/Layout/Slack in mm": 70,
                        "Loads/Resisting torque in N m": 2000, "Time/End time in ms": 16, "Output/Window start in ms": 8}),
}
# places of events that tests/observe/events.cc has, and none of these drives; plug-ins, and forces that they add: plugin.py
ELSEWHERE = {"events/*/roller", "events/*/span", "energy/spring", "energy/spring_damping_loss"} | {f"plugins/*/{what}" for what in ("name", "version", "path", "checksum")}


def paths(value, path=""):
    """Paths of the numbers, texts and nulls in a summary; a star for each place in a list."""
    if isinstance(value, dict):
        members = value.items()
    elif isinstance(value, list):
        members = (("*", member) for member in value)
    else:
        return {path}
    return {found for name, member in members for found in paths(member, f"{path}/{name}" if path else name)}


def main():
    patterns = {path: re.compile(re.escape(path).replace(r"\*", "[^/]+")) for path in SCHEMA["summary"]}
    unseen = {kind: set(SCHEMA[kind]) for kind in ("histories", "summary")}
    for name, (file, entries) in RUNS.items():
        program.run(file, {**entries, "Output/Field interval in ms": 0}, "--quiet", "--output", name, program=PROGRAM)

        def compare(path, item):
            if isinstance(item, h5py.Dataset):
                described = {what: item.attrs[what] for what in ("unit", "description") if what in item.attrs}
                known = {what: SCHEMA["histories"].get(path, {}).get(what) for what in described}
                check(path in SCHEMA["histories"] and described == known, f"{name}: {path} is {described}, and in the schema {known}")
                unseen["histories"].discard(path)

        with h5py.File(f"{name}/histories.h5") as histories:
            histories.visititems(compare)
        for path in paths(program.summary(name)):
            fitting = {known for known, pattern in patterns.items() if pattern.fullmatch(path)}
            check(len(fitting) == 1, f"{name}: {len(fitting)} entries of the schema fit the member {path} of the summary")
            unseen["summary"] -= fitting
    for kind in unseen:
        unseen[kind] -= ELSEWHERE
    check(not any(unseen.values()), f"in the schema, but in no run: {unseen}")


main()
