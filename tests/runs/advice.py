# SPDX-License-Identifier: LGPL-2.1-or-later
"""advice.py CASE PROGRAM: what the program advises is an answer to what was asked, and works.

accuracy: the first line of `plan --accuracy` is the cheapest model, its error and its time, or that there is no answer."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import program  # noqa: E402

CASE, PROGRAM = sys.argv[1:3]
SIMPLE = "prm/paper/simple.prm"
SHORT = {"Time/End time in ms": 1, "Output/Window start in ms": 0.5}


def accuracy():
    def plan(*words):
        return program.start([str(PROGRAM), "plan", str(program.REPOSITORY / SIMPLE), *words])

    def first(wanted, *changes):
        words = [word for change in (*(f"{k}={v}" for k, v in SHORT.items()), *changes) for word in ("--set", change)]
        done = plan("--accuracy", wanted, *words)
        program.check(done.returncode == 0, f"{wanted}: {done.stderr}")
        return next(line for line in done.stdout.splitlines() if line.startswith("Accuracy"))

    line = first("tight_tension_mean=5")
    program.check(re.search(r"within 5 %: simple\S* of study fidelity, against full \+0\.\d+ %.* s here; Model/Fidelity=simple", line),
                  f"no answer in: {line}")
    line = first("tight_tension_mean=0.001")
    program.check("within 0.001 %: no model; the best is" in line, line)
    for change, name in (("Drive/Number of links=120", "links"), ("Loads/Driver speed in rad/s=60", "driver speed"),
                         ("Loads/Resisting torque in N m=75", "driven torque")):
        line = first("tight_tension_mean=5", change, "Drive/Layout/Centre distance from=slack")
        program.check("no answer for this drive" in line and name in line, f"{change}: {line}")


{"accuracy": accuracy}[CASE]()
