# SPDX-License-Identifier: LGPL-2.1-or-later
"""tutorial_drives.py PROGRAM REPOSITORY: the commands of doc/tutorial-drives.md, in its order and in an empty folder. Tables must be
those of the page, what the page concludes from them must hold, and its pictures must be made."""
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

if subprocess.run(["/usr/bin/python3", "-c", "import h5py, jinja2, matplotlib, pandas"], stderr=subprocess.DEVNULL).returncode != 0:
    sys.exit(77)

TEXT = (REPOSITORY / "doc/tutorial-drives.md").read_text()


def do(line):
    """Runs a command of the page; returns what it prints."""
    words = [str(REPOSITORY / word) if re.match(r"(prm|scripts)/", word) else word for word in shlex.split(line)]
    if words[0] == "./run":
        words[0] = PROGRAM
        if words[1].endswith(".prm"):
            words.append("--quiet")
    else:
        words[:1] = ["/usr/bin/python3", "-B"]
    done = subprocess.run(words, capture_output=True, text=True)
    check(done.returncode == 0, f"{line}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def table(text):
    """[{what: numbers}] of the tables in a text, without the names of their columns."""
    found = []
    for block in re.findall(r"(?:^\|.*\n)+", text, re.MULTILINE):
        rows = [[cell.strip() for cell in line.strip("| ").split("|")] for line in block.splitlines()[2:]]
        found.append({what: [float(cell) for cell in cells] for what, *cells in rows})
    return found


for old in ("results", "pictures"):
    shutil.rmtree(old, ignore_errors=True)
commands = [line.strip() for line in TEXT.splitlines() if re.match(r"(    )?(\./run|python3) ", line)]
check(len(commands) == 13, f"commands: {commands}")
said = {line: do(line) for line in commands}

arm = re.search(r"^  The arm of .*", TEXT, re.MULTILINE)[0]
check(arm in next(text for line, text in said.items() if line.startswith("./run plan prm/drives/motorcycle.prm")), f"the plan does not say: {arm}")

told = table(TEXT)
found = [table(text)[0] for line, text in said.items() if "tutorial_drives.py" in line]
check([list(each) for each in found] == [list(each) for each in told], f"{found}\nand\n{told}")
# single impacts and the blade's swings are chaotic, the rest are means and what statics decides
for mine, page in zip(found, told):
    for what, values in mine.items():
        near = 0.4 if "impact" in what or "moves" in what else 0.15
        for value, expected in zip(values, page[what]):
            check(abs(value / expected - 1) <= near, f"{what}: {value}, not {expected}")

timing, motorcycle, elevator = found
for what in ("mean tension at the blade (N)", "mean tension of the other span (N)", "friction on the guides (W)"):
    check(timing[what][0] > timing[what][1], f"tight oil does not raise: {what} {timing[what]}")
check(motorcycle["safety of the plates"] == sorted(motorcycle["safety of the plates"], reverse=True), f"{motorcycle}")
for way in ("rise of tension on the way up (N/m)", "on the way down (N/m)"):
    for slope, weight in zip(elevator[way], elevator["weight of the chain (N/m)"]):
        check(abs(slope / weight - 1) < 0.02, f"{way}: {slope}, weight {weight}")
for step, pull in zip(elevator["up less down, half-way (N)"], elevator["pull of the load (N)"]):
    check(abs(step / pull - 1) < 0.02, f"tensions differ by {step}, the load pulls with {pull}")

for name in ("timing", "motorcycle", "elevator"):
    for picture in (REPOSITORY / f"doc/tutorial-drives/{name}.png", pathlib.Path(f"pictures/{name}.png")):
        check(5e3 < picture.stat().st_size < 60e3, f"{picture} has {picture.stat().st_size} bytes")
check("<svg" in pathlib.Path("timing.svg").read_text(), "the plan has drawn nothing")
check(pathlib.Path("motorcycle.html").stat().st_size > 1e5, "no report")
