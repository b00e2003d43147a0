# SPDX-License-Identifier: LGPL-2.1-or-later
"""tutorial.py PROGRAM REPOSITORY: the commands of doc/tutorial.md, in its order and in an empty folder, in a quick form: runs take 10
pitches after 20, studies --quick. What the tutorial says of 17 and 25 teeth must hold, its pictures must be made, and what it prints
of the plan must be in the plan."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from program import check

PROGRAM, REPOSITORY = sys.argv[1], pathlib.Path(sys.argv[2])
os.environ.pop("PYTHONPATH", None)  # what is started finds its modules by itself

if shutil.which("snakemake") is None or subprocess.run(
        ["/usr/bin/python3", "-c", "import h5py, jinja2, matplotlib, pandas"], stderr=subprocess.DEVNULL).returncode != 0:
    sys.exit(77)

TEXT = (REPOSITORY / "doc/tutorial.md").read_text()
QUICK = {"17": (73.02, 48.68), "25": (49.65, 33.1)}  # end and begin of the window, ms


def quick(words):
    """The words of a command of the tutorial as they are run here."""
    if words[0] == "./study":
        return [PROGRAM, "study", str(REPOSITORY / words[1]), *words[2:], "--quick", "--quiet"]
    if words[0] != "./run":
        return ["/usr/bin/python3", "-B", str(REPOSITORY / words[1]), *words[2:]]
    if not words[1].endswith(".prm"):
        return [PROGRAM, *words[1:]]
    end, begin = QUICK[re.search(r"z(\d+)", words[1])[1]]
    return [PROGRAM, *words[1:], "--set", f"Time/End time in ms={end}", "--set", f"Output/Window start in ms={begin}",
            "--set", "Output/Field interval in ms=0", "--quiet"]


def do(line):
    """Runs a command; returns what it prints."""
    command, _, file = line.partition(" > ")
    done = subprocess.run(quick(shlex.split(command)), capture_output=True, text=True)
    check(done.returncode == 0, f"{line}: status {done.returncode}\n{done.stdout}{done.stderr}")
    if file:
        pathlib.Path(file).write_text(done.stdout)
    return done.stdout


for old in ("results", "pictures"):
    shutil.rmtree(old, ignore_errors=True)
commands = [line.strip() for line in TEXT.splitlines() if re.match(r"(    )?(\./run|\./study|python3) ", line)]
check(len(commands) >= 7, f"commands: {commands}")
said = {line: do(line) for line in commands}

plan = next(text for line, text in said.items() if line.startswith("./run plan"))
for line in re.search(r"```\n(Drive\n.*?)```", TEXT, re.DOTALL)[1].splitlines():
    check(line in plan.splitlines(), f"the plan does not say: {line}\n{plan[:3000]}")


def table(text):
    """{what: (17 teeth, 25 teeth)} of the first table with these columns."""
    lines = text[text.index("|  | 17 teeth | 25 teeth |"):].split("\n\n")[0].splitlines()[2:]
    rows = [[cell.strip() for cell in line.strip("| ").split("|")] for line in lines]
    return {what: (float(first), float(second)) for what, first, second in rows}


found = table(next(text for line, text in said.items() if "tutorial.py" in line))
told = table(TEXT)
check(list(found) == list(told), f"{list(found)} and {list(told)}")
# means over pitches are those of the tutorial, single impacts are chaotic: their order and a range
for what, tolerance in (("tight span (N)", 0.25), ("polygon effect of the driver (%)", 0.01), ("losses (W)", 0.4),
                        ("shaft load (N)", 0.01), ("joint pressure (MPa)", 0.01), ("tooth frequency (Hz)", 0.01)):
    for value, expected in zip(found[what], told[what]):
        check(abs(value / expected - 1) <= tolerance, f"{what}: {value}, not {expected}")
for what in ("impact: normal speed (m/s)", "impact: peak force (N)", "tight span (N)", "shaft load (N)"):
    check(found[what][0] > found[what][1], f"{what}: 17 teeth {found[what][0]}, 25 teeth {found[what][1]}")
    check(0.5 < found[what][0] / told[what][0] < 1.6, f"{what}: {found[what][0]} instead of {told[what][0]}")

for picture in pathlib.Path(REPOSITORY, "doc/tutorial").glob("*.png"):
    made = pathlib.Path("pictures", picture.name)
    check(picture.stat().st_size < 60e3, f"{picture} has {picture.stat().st_size} bytes")
    check(picture.name.startswith("teeth") or made.stat().st_size > 5e3, f"{made} was not drawn")
page = pathlib.Path("results/teeth-quick/study.md").read_text()
check(len(re.findall(r"^\| (17|25) \| ", page, re.MULTILINE)) == 4, f"the page of the study:\n{page}")
