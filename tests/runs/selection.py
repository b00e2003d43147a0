# SPDX-License-Identifier: LGPL-2.1-or-later
"""select.py PROGRAM: which chain the program chooses, and what a plan and a run say of its life.

An example of a textbook is found at once; the file that is written for it can be planned; what has no sense is refused by its name.
The wear rate that a slow layered run has from the friction work of its joints is near that of closed forms.
"""
import math
import pathlib
import re
import resource
import sys
import xml.etree.ElementTree

import program
from program import check

PROGRAM = sys.argv[1]
DEMAND = {"--kW": 5, "--rpm": 1400, "--ratio": 3, "--centre": 500, "--shock": "moderate"}
MOST = 1.5  # s of CPU time
ESTIMATES = {"Model/Stiffness from": "dimensions"}


def said(*options, **changes):
    """Runs the command for DEMAND with `changes` (None: left out) and further options."""
    demand = {**DEMAND, **{f"--{name}": value for name, value in changes.items()}}
    words = [str(word) for pair in demand.items() if pair[1] is not None for word in pair]
    return program.start([PROGRAM, "select", *words, *options])


before = resource.getrusage(resource.RUSAGE_CHILDREN)
done = said("--output", "best.prm")
after = resource.getrusage(resource.RUSAGE_CHILDREN)
seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
check(done.returncode == 0, done.stderr)
check(seconds < MOST, f"select takes {seconds} s of CPU time")
first = done.stdout.splitlines()[2].split()
check(first[:4] == ["08A-1", "21/63", "122", "500.8"], f"the first is {first}")
text = pathlib.Path("best.prm").read_text()
check("set Designation = 08A" in text and "set Number of links = 122" in text, text)
plan = program.run(pathlib.Path("best.prm").absolute(), ESTIMATES, "--plan", program=PROGRAM)
for line in ("  wear ", "  plates ", "  rollers, bushes", "  pins "):
    check(line in plan, f"the plan has no line{line}:\n{plan}")

chart = said("--chart", "chart.svg")
rows = chart.stdout.splitlines()[2:14]
svg = xml.etree.ElementTree.parse("chart.svg").getroot()
bars = [float(one.get("width")) for one in svg.iter("{http://www.w3.org/2000/svg}rect") if one.get("class") in ("bar", "bad")]
words = [one.text for one in svg.iter("{http://www.w3.org/2000/svg}text")]
check(chart.returncode == 0 and len(bars) == 5 * len(rows), f"{len(bars)} bars for {len(rows)} drives: {chart.stderr}")
masses = [float(row.split()[6]) for row in rows]
check(max(abs(bar / bars[2 * len(rows)] - mass / masses[0]) for bar, mass in zip(bars[2 * len(rows):], masses)) < 0.03, f"bars of mass {bars}, {masses}")
check(f"{rows[0].split()[0]}, {rows[0].split()[1]}" in words and rows[0].split()[-2] in words, f"words of the chart: {words}")
for options, sentence in ((("--chart", "chart.png"), "ends in .svg"), (("--chart",), "--chart")):
    done = said(*options)
    check(done.returncode == 2 and sentence in done.stderr, f"{options}: {done.stderr}")
done = program.start([PROGRAM, "plan", "best.prm", "--chart", "chart.svg"])
check(done.returncode == 2 and "--chart belongs to selections" in done.stderr, done.stderr)

nothing = said("--output", "none.prm", kW=4000)
check(nothing.returncode == 2 and "none of the table meets the demand" in nothing.stderr, nothing.stderr)
check("carries only" in nothing.stdout and not pathlib.Path("none.prm").exists(), nothing.stdout)
torque = said(kW=None, Nm=5e3 / (1400 * 3.141592653589793 / 30))
check(torque.stdout.splitlines()[2:] == said().stdout.splitlines()[2:], "the torque is not that of the power")

for changes, sentence in (({"ratio": 20}, r"--ratio = 20 must be a number from 0\.1 to 10"),
                          ({"kW": 0}, "--kW = 0 must be a number"), ({"kW": "much"}, "--kW needs a number"),
                          ({"centre": 20}, "choose a larger --centre"), ({"hours": -1}, "--hours = -1 must be"),
                          ({"shock": "heavier"}, "--shock = heavier must be one of: smooth, moderate, heavy"),
                          ({"lubrication": "oil"}, "--lubrication = oil must be one of: none, manual, drip, bath, forced"),
                          ({"motor": "x"}, "--motor = x must be one of"), ({"strands": 9}, "--strands = 9 must be"),
                          ({"rpm": None}, "A selection takes all of"), ({"Nm": 3}, "--kW and --Nm say the same"),
                          ({"chain": "10B"}, "--chain belongs to template")):
    done = said(**changes)
    check(done.returncode == 2 and re.search(sentence, done.stderr) and not done.stdout, f"{changes}: {done.stdout}{done.stderr}")

RUN = {**ESTIMATES, "Loads/Driver speed in rad/s": 60, "Drive/Layout/Start": "settled", "Time/End time in ms": 90, "Time/Time step in us": 0.8,
       "Output/Window start in ms": 20, "Output/Field interval in ms": 0, "Output/Rollers": 0}
program.run("prm/paper/layered.prm", RUN, "--output", "run", program=PROGRAM)
summary = program.summary("run")
life, lost = summary["life"], summary["losses"]["bush-pin"]
share = life["simulated_wear_rate"] / life["wear_rate"]
check(0.9 < share < 1.2, f"the simulated wear rate is {share} times that of closed forms")
# the interval of wear: by pitches of the run, and a factor of 3
check(0 < lost["uncertainty"] < 0.5 * lost["power"], f"the friction work of pitches: {lost}")
check(abs(life["certainty"]["wear"]["batches"] * lost["power"] / lost["uncertainty"] - 1) < 1e-6, f"{life['certainty']}, {lost}")
wide = math.exp(math.hypot(math.log1p(lost["uncertainty"] / lost["power"]), math.log(3)))
for end, factor in (("low", 1 / wide), ("high", wide)):
    check(abs(life["certainty"]["wear"][end] / factor / life["simulated_wear_hours"] - 1) < 1e-6, f"{end}: {life['certainty']}")
print("OK", share)
