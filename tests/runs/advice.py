# SPDX-License-Identifier: LGPL-2.1-or-later
"""advice.py CASE PROGRAM: what the program advises is an answer to what was asked, and works.

accuracy: the first line of `plan --accuracy` is the cheapest model, its error and its time, or that there is no answer.
entries: what doc/not-modelled.md lists is said of such entries; numbers in other units are converted, or said to be others; no
entry is advised that means something else.
overload: a run that has pressed rollers harder than its step is for says what suffices, and is quiet once it has that.
options: a command refuses options that it has no use for; of a template every value that cannot be is refused by its name.
followed [KIND...]: what advice_cases.py lists, or some kinds of it, is said, and who does what it says is not told so again."""
import concurrent.futures
import os
import pathlib
import re
import sys
import tempfile

import advice_cases
import fuzz
import program

CASE, PROGRAM = sys.argv[1:3]
SIMPLE = "prm/paper/simple.prm"
SHORT = {"Time/End time in ms": 1, "Output/Window start in ms": 0.5}
LONG = ("Time/End time in ms=300", "Output/Window start in ms=10")  # some 80 pitches


def accuracy():
    def plan(*words):
        return program.start([str(PROGRAM), "plan", str(program.REPOSITORY / SIMPLE), *words])

    def first(wanted, *changes):
        words = [word for change in (*(f"{k}={v}" for k, v in SHORT.items()), *changes) for word in ("--set", change)]
        done = plan("--accuracy", wanted, *words)
        program.check(done.returncode == 0, f"{wanted}: {done.stderr}")
        return next(line for line in done.stdout.splitlines() if line.startswith("Accuracy"))

    rows = [row.split("\t") for row in (program.REPOSITORY / "source/accuracy.tsv").read_text().splitlines()]
    error = float(next(row[4] for row in rows if row[:4] == ["fidelity", "simple", "exact", "tight_tension_mean"]))
    line = first("tight_tension_mean=5", *LONG)
    found = re.search(r"within 5 %: simple of study fidelity, against exact ([+-][0-9.]+) %.* s here; Model/Fidelity=simple", line)
    program.check(found and abs(float(found[1]) / error - 1) < 0.06,
                  f"no answer in: {line}")
    program.check("Time/End time" in first("tight_tension_mean=5"), "half a millisecond is window enough")
    line = first("tight_tension_mean=0.001")
    program.check("within 0.001 %: no model; the best is" in line, line)
    for change in ("Drive/Number of links=120", "Loads/Resisting torque in N m=75"):  # of nobody, but between others
        line = first("tight_tension_mean=10", *LONG, change, "Drive/Layout/Centre distance from=slack")
        program.check("within 10 %: layered, as other drives let expect, against exact " in line and " s here; Model/Fidelity=layered" in line, f"{change}: {line}")
        line = first("tight_tension_mean=0.1", change, "Drive/Layout/Centre distance from=slack")
        program.check("no answer for this drive" in line and "chaindrive calibrate" in line and f'--set "{change}"' in line, f"{change}: {line}")
    line = first("tight_tension_mean=100", "Loads/Driver speed in rad/s=6")  # like none
    program.check("no answer for this drive" in line and "Not measured on a drive like this: " in line and "resonance" in line and " there. This finds one" in line, line)


def said_of(pairs):
    """{entry: what is said of it}, of entries that do not exist; all mistakes are said at once."""
    sets = {f"{entry}={value}": entry for entry, value in pairs}
    done = program.start([str(PROGRAM), "plan", str(program.REPOSITORY / SIMPLE), *(w for text in sets for w in ("--set", text))])
    program.check(done.returncode == 2, f"status {done.returncode}\n{done.stdout}")
    said = {entry: line for line in done.stderr.splitlines() for text, entry in sets.items() if f'--set "{text}"' in line}
    program.check(len(said) == len(sets), f"not all are refused:\n{done.stderr}")
    return said


def entries():
    rows = re.findall(r"^\| (`.*`) \|", (program.REPOSITORY / "doc/not-modelled.md").read_text(), re.MULTILINE)
    program.check(len(rows) > 5, "no rows in doc/not-modelled.md")
    names = re.findall("`([^`]+)`", " ".join(rows))
    for entry, said in said_of((f"Drive/Layout/{name}", 5) for name in names).items():
        program.check("not modelled" in said and "Did you mean" not in said, f"{entry}: {said}")
    cases = (
            ("Drive/Layout/Sag in mm", "3", "Sag in percent', which is in percent, not in mm"),
            ("Drive/Layout/Pretension in kN", "0.2", "Pretension in N'? 0.2 kN are 200 N."),
            ("Time/End time in s", "0.03", "End time in ms'? 0.03 s are 30 ms."),
            ("Time/End time in us", "auto", "End time in ms'? It is in ms, not in us."),
            ("Drive/Chain/Pitch in inch", "0.625", "Pitch in mm'? 0.625 inch are 15.875 mm."),
            ("Drive/Layout/Driver bore in cm", "3", "'Drive/Sprockets/Driver bore in mm'? 3 cm are 30 mm."),
            ("Loads/Power in W", "1500", "Power in kW'? 1500 W are 1.5 kW."),
            ("Loads/Ramp tiem in s", "1", "Ramp time in ms'? It is in ms, not in s."))
    said = said_of((entry, value) for entry, value, _ in cases)
    for entry, _, wanted in cases:
        program.check(wanted in said[entry], f"{entry}: {said[entry]}")
    no_advice = ("Model/Driver inertia in kg m2", "Drive/Layout/Stop", "Loads/Flux", "Time/Length", "Drive/Chain/Inner width in mm")
    for entry, said in said_of((entry, 5) for entry in no_advice).items():
        program.check("Did you mean" not in said, f"{entry}: {said}")


def options():
    def said(*words):
        return program.start([str(PROGRAM), *words])

    for words in (("template", "--set", "Time/End time in ms=5"), ("template", "--output", "there"), ("document", "--quiet"),
                  ("parts", SIMPLE, "--output", "there"), ("parts", SIMPLE, "--resume", "auto"), ("template", "--plan"),
                  ("study", "any.prm", "--plan"), ("noise", "any", "--plan"), ("document", "--resume", "auto")):
        done, option = said(*words), next(word for word in words if word.startswith("--"))
        program.check(done.returncode == 2 and f"The option {option} belongs to" in done.stderr, f"{words}: {done}")

    good = {"--chain": "10B", "--teeth": "21/63", "--centre": "500", "--rpm": "1450", "--kW": "3"}
    for option, value in (("--rpm", "0"), ("--rpm", "1e-9"), ("--rpm", "nan"), ("--rpm", "1e6"), ("--kW", "0"), ("--centre", "0"),
                          ("--teeth", ""), ("--chain", "")):
        done = said("template", *(word for pair in {**good, option: value}.items() for word in pair))
        program.check(done.returncode == 2 and f"The option {option}" in done.stderr and "takes all of" not in done.stderr,
                      f"{option} {value}: {done}")
    done = said("template", "--chain", "10B", "--teeth", "21/63")
    program.check(done.returncode == 2 and "takes all of" in done.stderr, str(done))


def overload():
    fast = {**advice_cases.REDUCED, "Drive/Driver teeth": 9, "Drive/Driven teeth": 9, "Drive/Number of links": 22,
            "Model/Symmetry model": "true", "Loads/Driver speed in rad/s": 600, "Loads/Ramp time in ms": 0.2,
            "Loads/Resisting torque in N m": 30, "Time/End time in ms": 0.4, "Output/Window start in ms": 0, "Output/Field interval in ms": 0}
    pathlib.Path("fast.prm").write_text(BASE)

    def said(**more):
        sets = [word for name, value in {**fast, **more}.items() for word in ("--set", f"{name}={value}")]
        done = program.start([str(PROGRAM), "fast.prm", "--output", "fast", *sets])
        program.check(done.returncode == 0, f"{done.stdout}{done.stderr}")
        return re.search(r"has carried up to ([0-9.]+) kN.* for forces of up to ([0-9.]+) kN. Choose (Time/Safety factor) = ([0-9.]+)",
                         " ".join((done.stdout + done.stderr).split()))

    found = said()
    program.check(found and float(found[1]) > float(found[2]), "an overload is not said")
    program.check(not said(**{found[3]: found[4]}), "it is said of a step that suffices")


# quickly planned: no parts are solved, none is meshed for pictures
BASE = "subsection Model\n  set Stiffness from = dimensions\nend\nsubsection Output\n  set Field interval in ms = 0\nend\n"


def planned(server, entries):
    """Status of a plan of a drive with `entries`, and what is said in one line."""
    sets = [word for name, value in entries.items() if value is not None for word in ("--set", f"{name}={value}")]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "base.prm").write_text(BASE)
        status, _ = server(["plan", "base.prm", *sets], folder)
        return status, " ".join(((folder / "stdout").read_text() + (folder / "stderr").read_text()).split())


def filled(template, found):
    """A name or value of the table with the groups of the message."""
    if callable(template):
        return template(*found.groups())
    return found.expand(template) if isinstance(template, str) else template


def faults_of(server, row):
    """What is wrong with the advice of a row of the table."""
    message, entries, followed = row
    status, said = planned(server, entries)
    found = re.search(message, said)
    if not found:
        return [f"nothing like '{message}' of {entries}: status {status}: {said[-700:]}"]
    faults = []
    for change in followed:
        change, then = dict(change), change.get("then")
        change.pop("then", None)
        change = {filled(name, found): filled(value, found) for name, value in change.items()}
        status, after = planned(server, {**entries, **change})
        again = re.search(message, after)
        if again or status != (2 if then else 0) or not re.search(then or "", after):
            faults.append(f"of {entries}:\n  {found[0][-300:]}\n  but with {change}:\n  status {status}: "
                          f"{again[0][-300:] if again else after[-500:]}")
    return faults


def followed():
    server = fuzz.Server(pathlib.Path(PROGRAM), 300, 0)
    tables = {kind.__name__: kind for kind in advice_cases.TABLES}
    kinds = [tables[name] for name in sys.argv[3:] or tables]
    rows = [row for kind in kinds for row in kind()]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = [fault for found in pool.map(lambda row: faults_of(server, row), rows) for fault in found]
    tried = sum(len(row[2]) for row in rows)
    print(f"{len(rows)} messages, {tried} pieces of advice, {len(faults)} do not hold")
    program.check(not faults, "\n".join(faults))


{"followed": followed, "options": options, "accuracy": accuracy, "entries": entries, "overload": overload}[CASE]()
