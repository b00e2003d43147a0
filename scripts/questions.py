#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""questions.py [--program PROGRAM]: what a designer asks of a drive, the command that answers it, its line, and how long it takes.

Prints doc/questions.md, in two minutes on one core:

    /usr/bin/python3 scripts/questions.py > doc/questions.md
"""
import argparse
import os
import pathlib
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import textwrap

import program

PLAN, RUN = "chaindrive plan a.prm", "chaindrive a.prm"
SHORT = '--set "Time/End time in ms=70" --set "Output/Window start in ms=20"'
LAYERED = "--set Model/Fidelity=layered " + SHORT
DRIVES = program.REPOSITORY / "prm/drives"
#: Question, command, pattern of the line that answers it, and what it does not know.
QUESTIONS = (
    ("What do the bearings of the shafts carry?", PLAN, r"  loads .*", "closed form; runs have the load over time"),
    ("How hard do rollers hit the teeth at 3000 rpm?", f'{RUN} --set "Loads/Driver speed in rpm=3000" --set "Time/End time in ms=30" --set "Output/Window start in ms=10"',
     r"  impacts on the driver.*", "a power that is given stays, and the torque falls"),
    ("What does friction cost?", f"{RUN} {LAYERED}", r".*efficiency .*", "for the coefficient of friction that is given"),
    ("How long until the chain is worn?", PLAN, r"  wear .*", "within a factor of 3"),
    ("How many teeth?", "chaindrive select --kW 1 --rpm 1000 --ratio 2 --centre 400 --strands 1", r"   chain .*\n.*", "closed forms; a study has the rest"),
    ("How uneven is the speed of the driven shaft?", f"{RUN} {SHORT}", r".*driven speed.*", ""),
    ("How loud is it?", f'{RUN} {LAYERED} --set "Acoustics/Noise=on"', r".*microphone.*", "levels compare drives, see [published results](validation/published.md#sound)"),
    ("At which speeds does it resonate?", PLAN, r"  slack span .*\n.*\n(?:.*\n){2}  driven inertia .*", "within 3 %, of `layered` up to 8 % too low; no waves along the chain"),
    ("What changes with a chain worn by 2 %?", f'{PLAN} --set "Drive/Chain/Elongation in percent=2" --set "Drive/Layout/Worn chain=shafts kept"', r"  slack span .*", ""),
    ("What changes with a sag of 3 % instead of 1 %?", f'{PLAN} --set "Drive/Layout/Sag in percent=3"', r"  slack span .*\n.*\n.*\n  loads .*",
     "of two runs: `chaindrive report A B`, with intervals"),
    ("What does an emergency stop do?", f"chaindrive {DRIVES}/emergency-stop.prm", r".*slack tension.*", "another drive; its table of speeds is that of any"),
    ("The load is thrown off: what then?", f'{RUN} {SHORT} --set "Loads/Torque step time in ms=30" --set "Loads/Torque after step in N m=0"', r".*slack tension.*", ""),
    ("Does the chain jump teeth?", f'chaindrive {program.REPOSITORY}/prm/paper/simple.prm --set "Drive/Layout/Centre distance from=slack" --set "Drive/Layout/Slack in mm=70" '
     '--set "Loads/Resisting torque in N m=600" --set "Time/End time in ms=40"', r".*jumped.*", "another drive; log, summary and report say it of any that does"),
    ("Will the plates break by fatigue?", PLAN, r"  plates .*\n.*\n.*", "runs add the cycles that they count"),
    ("The sprockets are 1 mm out of line?", f'{RUN} {LAYERED} --set "Drive/Wheels/driven/Axial offset in mm=1"', r"  loss in plate-driver.*\n.*", "layered fidelity"),
    ("Which tensioner?", f"chaindrive {DRIVES}/tensioner.prm", r"  The arm of .*", "another drive; `Held by` an arm or a slide"),
    ("A sprocket runs out by 0.2 mm?", f'{RUN} {SHORT} --set "Drive/Wheels/driver/Runout in um=200"', r".*tight tension.*", "a window of several turns shows more"),
    ("The load pulses with the crank?", f'{RUN} {SHORT} --set "Loads/driven/Harmonics/Orders=2" --set "Loads/driven/Harmonics/Amplitudes in N m=10"', r".*tight tension.*", ""),
    ("How sure is each figure?", f"{RUN} {SHORT}", r"  in the window .*\n.*\n.*", "± of the mean; models: `chaindrive calibrate a.prm`"),
    ("How long does it compute?", PLAN, r"Cost: .*", "within 20 % on a machine without other work"),
    ("Special drive: duplex chain", "chaindrive template --chain 08B --strands 2 --teeth 19/38 --centre 400 --rpm 1000 --kW 2", r".*Strands.*", "strands share the load equally"),
    ("Special drive: bicycle", f"chaindrive plan {program.REPOSITORY}/prm/published/bicycle.prm", r"  chain .*", ""),
    ("Special drive: conveyor", f"chaindrive plan {DRIVES}/conveyor.prm", r"  chain .*", "rail friction as a load"),
    ("Special drive: vertical", f'{PLAN} --set "Drive/Layout/Centre distance from=given" --set "Drive/Wheels/driven/Centre in mm=0, 400.5"', r"  centre distance .*", ""),
    ("Special drive: leaf chain, hoist", "chaindrive select --kW 1 --rpm 1000 --ratio 2 --centre 400 --strands 1", "", "not modelled: chains are endless and of rollers or bushes"),
)


def run(words):
    """What a command prints, its status and its CPU time in s."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.stdout + done.stderr, done.returncode, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--program", default=program.PROGRAM)
    options.add_argument("--quick", action="store_true", help="say only which questions have no answer")
    given = options.parse_args()
    folder = tempfile.TemporaryDirectory()
    os.chdir(folder.name)
    design = "chaindrive template --chain 08B --teeth 19/38 --centre 400 --rpm 1000 --kW 1"
    text, status, _ = run([given.program, *shlex.split(design)[1:]])
    pathlib.Path("a.prm").write_text(text)
    rows, lines, missing = [], [], []
    for number, (question, command, pattern, limits) in enumerate(QUESTIONS, 1):
        if not pattern:
            rows.append(f"| {number} | {question} | – | – | {limits} |")
            continue
        text, status, seconds = run([given.program, *shlex.split(command)[1:], *(["--set", "Model/Stiffness from=dimensions"] if "a.prm" in command else [])])
        found = re.search(pattern, text, re.MULTILINE | re.IGNORECASE)
        if not found:
            missing.append(f"{number} {question} status {status}: {command}\n{text[-1500:]}")
        shown = command.replace(str(program.REPOSITORY) + "/", "")
        rows.append(f"| {number} | {question} | `{shown}` | {seconds:.1f} s | {limits} |")
        lines.append(f"**{number}. {question}**\n\n```\n{found[0] if found else '(no answer)'}\n```\n")
    print("\n".join(missing), file=sys.stderr)
    if not given.quick:
        print("# Questions of a designer\n")
        print(textwrap.fill("What is asked first of a chain drive, the command that answers it, and how much CPU time that takes, by scripts/questions.py, which "
                            "runs them all. Where they say a.prm, it is a file made by the command below, run with `Model/Stiffness from = dimensions`, which "
                            "spares half a minute of elastic solutions for a chain that is new.", 100))
        print(f"\n    {design} > a.prm\n\n    /usr/bin/python3 scripts/questions.py > doc/questions.md\n")
        print("| | question | command | CPU time | what it does not know |\n|---|---|---|---|---|")
        print("\n".join(rows) + "\n\n## Answers\n")
        print("\n".join(lines), end="")
    sys.exit(bool(missing))


if __name__ == "__main__":
    main()
