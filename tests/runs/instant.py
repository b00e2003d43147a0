# SPDX-License-Identifier: LGPL-2.1-or-later
"""instant.py PROGRAM: plan and run begin with the design data of the drive, before any part is solved.

With an empty cache the block is there after little CPU time, and the parts that are solved next are named. Where nothing has to be
solved, nothing is said of it, and the block is printed once.
"""
import os
import pathlib
import subprocess
import sys

import program
from program import check

PROGRAM = sys.argv[1]
LAST = "  usual limits"
MOST = 1.5  # s of CPU time, start of the program and its libraries included


def cpu_seconds(process):
    """CPU time that the running `process` has taken, s."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def first_lines(words):
    """Starts `words` with an empty cache; what it says until it solves a part, and the CPU time until the block was complete."""
    environment = {**os.environ, "CHAINDRIVE_CACHE": str(pathlib.Path("empty").absolute())}
    said, seconds = [], None
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment) as process:
        for line in process.stdout:
            said.append(line)
            if line.startswith(LAST):
                seconds = cpu_seconds(process)
            if line.startswith("Solving"):
                break
        process.kill()
    return said, seconds


words = program.command("prm/paper/simple-auto.prm", program=PROGRAM)
for command in ("plan", "run"):
    said, seconds = first_lines([words[0], command, *words[1:], "--output", "results"])
    check(said and said[0] == "Drive\n", f"{command} begins with:\n{''.join(said[:3])}")
    check(seconds is not None, f"{command} solves before it has printed the block:\n{''.join(said)}")
    check(said[-1].startswith("Solving the inner link"), f"{command} does not say what it solves:\n{''.join(said)}")
    check(seconds < MOST, f"{command} takes {seconds} s of CPU time until the block is complete")
check(not any(pathlib.Path("empty").glob("*.json")), "a part was solved before it was named")

said = program.run("prm/paper/simple.prm", {}, "--plan", program=PROGRAM)
check("Solving" not in said and "parts solved" not in said, f"all stiffnesses are given, but:\n{said}")
check(said.count("  centre distance") == 1, f"the block is not there once:\n{said}")
print("OK")
