# SPDX-License-Identifier: LGPL-2.1-or-later
"""entries.py PROGRAM: entries that are found from others, as parameters.prm and summary.json of short runs have them.

Number of links = auto is the even number whose length is nearest to the centre distance; where that is given, the smallest that
reaches. Worn chain = shafts kept leaves the shafts where the new chain had them, and the wear of all links becomes slack.
Field interval in ms = auto is a tenth of the pitch time.
"""
import math
import pathlib
import re
import sys

import program
from program import check

PROGRAM = sys.argv[1]
SHORT = {"Time/End time in ms": 0.5, "Output/Window start in ms": 0, "Output/Field interval in ms": 0}
FROM, DISTANCE = "Drive/Layout/Centre distance from", "Drive/Layout/Centre distance in mm"
PITCH = 15.875e-3


def run(name, entries, status=0):
    return program.run("prm/paper/simple.prm", {**SHORT, **entries}, "--output", name, program=PROGRAM, status=status)


def used(name, entry):
    return float(re.search(rf"set {re.escape(entry)} += (\S+)", pathlib.Path(name, "parameters.prm").read_text())[1])


def drive(name):
    return program.summary(name)["drive"]


def length(links):
    """What so many links measure round sprockets of 15 and 42 teeth less what the spans do not need: the distance of the shafts."""
    radius = [PITCH / 2 / math.sin(math.pi / teeth) for teeth in (15, 42)]
    low, high = 0.2, 5.0
    while high - low > 1e-9:
        c = (low + high) / 2
        a = math.asin((radius[1] - radius[0]) / c)
        low, high = (c, high) if 2 * c * math.cos(a) / PITCH + 28.5 + 27 * a / math.pi < links else (low, c)
    return low


for links, distance, choice in ((110, length(110) + 0.7e-3, "slack"), (112, length(110) + 0.99 * PITCH, "sag"),
                                (110, length(110) - 0.45 * PITCH, "slack"), (112, length(110) + 0.6e-3, "given")):
    said = run("links", {"Drive/Number of links": "auto", FROM: choice, DISTANCE: f"{1e3 * distance:.6g}"})
    check(used("links", "Number of links") == links == drive("links")["links"], f"{drive('links')['links']} links instead of {links}")
    check(f"Number of links = auto: {links} for a centre distance of" in said, f"the log does not say how many links:\n{said}")
    check(DISTANCE not in re.sub(r"auto: .*|Take fewer links or a larger .*", "", said), f"the centre distance is said to be without effect:\n{said}")
check(abs(drive("links")["centre_distance"] - distance) < 1e-5, "a given distance was not kept")
said = run("refused", {"Drive/Number of links": "auto", DISTANCE: 100}, status=2)
check("Centre distance in mm = 100: the sprockets overlap" in said, said)

new = {FROM: "slack"}
worn = {**new, "Drive/Chain/Elongation in percent": 0.5}
run("new", new)
run("adjusted", worn)
run("kept", {**worn, "Drive/Layout/Worn chain": "shafts kept"})
distance = {name: drive(name)["centre_distance"] for name in ("new", "adjusted", "kept")}
check(distance["kept"] == distance["new"] < distance["adjusted"] - 2e-3, f"shafts were moved: {distance}")
slack = {name: sum(span["slack"] for span in drive(name)["spans"]) for name in distance}
check(abs(slack["adjusted"] - slack["new"]) < 0.1e-3, f"an adjusted chain has another slack: {slack}")
# what lies on the sprockets rides up their flanks and takes up a part of its own wear
check(0.6 < (slack["kept"] - slack["new"]) / (0.005 * 110 * PITCH) < 1.05, f"wear is no slack: {slack}")
said = run("refused", {**worn, "Drive/Layout/Worn chain": "shafts kept", FROM: "pretension"}, status=2)
check("Worn chain = shafts kept" in said and "pretension" in said, said)

run("pictures", {"Output/Field interval in ms": "auto", "Time/End time in ms": 1.2})
interval = used("pictures", "Field interval in ms")
check(abs(interval / (100 * drive("pictures")["pitch_time"]) - 1) < 1e-6, f"pictures are {interval} ms apart")
number = len(list(pathlib.Path("pictures/fields").glob("bodies_*.vtu")))
check(number == int(1.2 / interval) + 1, f"{number} pictures")
said = program.start([PROGRAM, "plan", str(program.REPOSITORY / "prm/paper/imported-sprocket.prm")]).stdout
meshes = said.find("\nMeshes\n")
check(said.startswith("Drive\n") and meshes > said.find("\nCost: ") > 0, f"meshes are not last in the plan:\n{said}")
check(said[meshes:].count("\n") < 10, f"meshes are not short:\n{said[meshes:]}")
