#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the verification cases and prints them as a table in Markdown:

    scripts/verification.py [--build build] > doc/validation/verification.md

A case is a test of tests/, whose program prints obtained over expected values. This script reads
these values, compares them with the tolerance of the case, and measures the CPU time. ./check
builds the programs. Exits with 1 if a value is missing or outside its tolerance.
"""
import argparse
import math
import os
import re
import resource
import subprocess
import sys
import tempfile

NUMBER = r"(-?[0-9.]+(?:e[-+]?[0-9]+)?)"


class Figure:
    """One figure of a program's output: the group of `pattern`, with what is expected."""

    def __init__(self, what, pattern, tolerance, expected=1., unit=""):
        self.what, self.pattern, self.tolerance = what, pattern, tolerance
        self.expected, self.unit = expected, unit


class Holds:
    """A statement that the program answers with yes."""

    def __init__(self, what, pattern, bound):
        self.what, self.pattern, self.bound = what, pattern, bound


# id, case, test, figures; the numbers are those of the closed forms in doc/theory.md's references
CASES = [
    ("V1", "elastic bar against a rigid wall, 200 elements", "contact/elastic_wall", [
        Figure("stress over rho c v", r"200 elements(?s:.*?)mean stress: " + NUMBER, 0.03),
        Figure("impulse over 2 m v", r"200 elements(?s:.*?)impulse: " + NUMBER, 0.01),
        Figure("time of contact over 2 L / c", r"200 elements(?s:.*?)duration: " + NUMBER, 0.02)]),
    ("V2", "two equal bars, 200 elements each", "contact/two_bars", [
        Figure("stress over rho c v / 2", r"200 elements(?s:.*?)mean stress: " + NUMBER, 0.03),
        Figure("velocity of the struck bar over v",
               r"200 elements(?s:.*?)struck bar: " + NUMBER, 0.01),
        Holds("momentum kept", r"200 elements(?s:.*?)momentum kept to 1e-10: (\w+)", 1e-10)]),
    ("V3", "a bar against one of twice its length", "contact/two_bars", [
        Figure("velocity of the struck bar over v / 2",
               r"twice as many(?s:.*?)struck bar: " + NUMBER, 0.02),
        Figure("velocity left to the striker over v",
               r"twice as many(?s:.*?)striker: " + NUMBER, 0.02, expected=0.)]),
    ("V4", "frequencies of a bar", "element/bar", [
        Figure("free, over c / 2L", r"enhanced, frequency.*free " + NUMBER, 0.01),
        Figure("held, over c / 4L", r"enhanced, frequency.*at one end " + NUMBER, 0.01)]),
    ("V5, V6", "cylinder between flats, elements of b / 12", "contact/hertz", [
        Figure("load at a given approach over Hertz's", r"cells of b / 12: " + NUMBER, 0.02),
        Figure("the same with ten times the penalty",
               r"ten times the penalty: " + NUMBER, 0.01)]),
    ("V9", "pin in a bore with clearance, 64 columns", "contact/conforming", [
        Figure("greatest pressure over Persson's, half angle 16.6 degrees",
               r"6 um, 64 columns.*Persson's " + NUMBER, 0.03),
        Figure("greatest pressure over Persson's, 38.8 degrees",
               r"30 um, 64 columns.*Persson's " + NUMBER, 0.03)]),
    ("V11", "sliding block, mu 0.1", "contact/friction_slide", [
        Figure("stopping distance", r"stopping distance: " + NUMBER, 1e-3),
        Figure("stopping time", r"stopping time: " + NUMBER, 1e-3)]),
    ("V12", "block on a rotating disc", "contact/rotating_disc", [
        Figure("speed at which it slips, mu 0.1", r"mu = 0.1(?s:.*?)which is: " + NUMBER, 0.01),
        Figure("mu 0.2", r"mu = 0.2(?s:.*?)which is: " + NUMBER, 0.01)]),
    ("V13", "cylinders on an incline", "contact/rolling_incline", [
        Figure("acceleration, solid", r"solid: rolls\n.*?acceleration: " + NUMBER, 1e-3),
        Figure("acceleration, roller", r"annulus: rolls\n.*?acceleration: " + NUMBER, 1e-3)]),
    ("V14", "capstan", "contact/capstan", [
        Figure("ratio of tensions over exp(mu theta)", r"loaded end: " + NUMBER, 0.01)]),
    ("V15", "spinning thin ring", "element/spinning", [
        Figure("hoop stress over rho r^2 w^2", r"enhanced, thin ring.*hoop stress " + NUMBER, 0.01),
        Figure("growth of its radius", r"enhanced, thin ring.*growth " + NUMBER, 0.01)]),
    ("V15", "ten revolutions", "element/rotation", [
        Holds("no stored energy grows", r"enhanced, ten turns.*to 1e-4: (\w+)", 1e-4),
        Holds("angular momentum kept", r"enhanced, ten turns.*kept to 1e-10: (\w+)", 1e-10)]),
    ("V16", "spinning disc", "element/spinning", [
        Figure("hoop stress at the bore", r"enhanced, disc.*at the bore " + NUMBER, 0.02),
        Figure("largest radial stress", r"enhanced, disc.*largest radial " + NUMBER, 0.02)]),
    ("V17", "ovalisation of roller and bush", "element/ring_modes", [
        Figure("roller, 1 x 24 x 4 cells, over 43.04 kHz",
               r"roller 1x24x4, enhanced: over cubic elements " + NUMBER, 0.02),
        Figure("roller, 3 x 48 x 6", r"roller 3x48x6, enhanced: over cubic elements " + NUMBER, 0.02),
        Figure("bush, 1 x 24 x 4, over 65.89 kHz",
               r"bush 1x24x4, enhanced: over cubic elements " + NUMBER, 0.02)]),
    ("V18", "cantilever, one element through it", "element/cantilever", [
        Figure("first frequency over Timoshenko's", r"10x1, enhanced.*Timoshenko's " + NUMBER, 0.03),
        Figure("third frequency",
               r"10x1, enhanced.*Timoshenko's [0-9.]+ [0-9.]+ " + NUMBER, 0.03),
        Figure("deflection over Euler's", r"10x1, enhanced.*over Euler's " + NUMBER, 0.02)]),
    ("V19", "patch of distorted cells", "element/patch", [
        Holds("interior forces vanish", r"enhanced, finite.*forces vanish: (\w+)", 1e-10),
        Holds("stress", r"enhanced, finite.*stress: (\w+)", 1e-10)]),
    ("V19", "roller turned by 0 to 355 degrees", "element/rotation", [
        Holds("strain", r"enhanced, turned.*strain below 1e-12: (\w+)", 1e-12)]),
    ("V20", "pendulum on a pin with clearance", "contact/clearance_pendulum", [
        Figure("frequency over 1.93015 Hz", r"frequency: " + NUMBER, 1e-3)]),
    ("V21", "fall through a clearance", "contact/drop_through_clearance", [
        Figure("time over sqrt(2 c / g)", r"time of the fall: " + NUMBER, 1e-3),
        Figure("speed at the touch", r"speed at the touch: " + NUMBER, 1e-2)]),
    ("V22", "free rotation of an asymmetric body", "dynamics/free_rotation", [
        Holds("angular momentum kept over 1e5 steps",
              r"100000 steps(?s:.*?)kept to 1e-12: (\w+)", 1e-12)]),
    ("V23", "two links pulled, 1 kN", "contact/pull", [
        Figure("extension over the static solution", r"pull 1e\+03.*extension " + NUMBER, 0.01)]),
    ("V24", "slow drive", "runs/slow", [
        Figure("mean speed ratio over 15 / 42", r"mean speed ratio / \(15/42\) = " + NUMBER, 1e-4),
        Figure("first pitch harmonic over the four-bar's",
               r"four-bar = " + NUMBER, 0.03),
        Figure("tooth load over Naji and Marshek's, fourth roller",
               r"roller 4 = " + NUMBER, 0.05)]),
    ("V25", "elastic pieces of statics, hanging nodes", "statics/elastic_piece", [
        Figure("extension of a bar over the exact one", r"the exact one: " + NUMBER, 1e-5),
        Holds("Lame's cylinder, 48 cells: displacement of the bore",
              r"cylinder: 48 cells, error below 2e-3: (\w+)", 2e-3),
        Figure("displacements of a free ring, reciprocal", r"reciprocal " + NUMBER, 1e-4)]),
    ("V26", "pin pressed into a hole by flexibilities", "statics/contact_problem", [
        Holds("pressure on the line, 20 N/mm", r"q 20 N/mm: .*4 percent: (\w+), half", 0.04),
        Holds("pressure on the line, 1000 N/mm", r"q 1000 N/mm: .*4 percent: (\w+), half", 0.04)]),
]

# case, test, what is refined and by how much, figure, its values, what they tend to
SERIES = [
    ("bar impact", "contact/elastic_wall", "50, 100, 200 elements", [2., 2.],
     "time of contact over 2 L / c", r"duration: " + NUMBER, 1.),
    ("ring mode, roller", "element/ring_modes", "1 x 24 x 4, 2 x 32 x 6, 3 x 48 x 6 cells", None,
     "frequency over that of cubic elements",
     r"roller \dx\d+x\d, enhanced: over cubic elements " + NUMBER, 1.),
    ("cantilever", "element/cantilever", "1, 2, 4 elements through it", None,
     "first frequency over Timoshenko's",
     r"(?:10x1|20x2|40x4), enhanced: frequencies over Timoshenko's " + NUMBER, 1.),
    ("conforming contact", "contact/conforming", "32, 64, 96 columns", None,
     "mean error of all pressures, half angle 38.8 degrees",
     r"by 30 um.*all pressures " + NUMBER, 0.),
    ("friction stop", "contact/friction_order", "step 80, 40, 20, 10 us", [2., 2., 2.],
     "error of the distance (per million)", r"distance " + NUMBER, 0.),
    ("impact of two masses", "contact/two_mass_impact", "step 1, 0.5, 0.25, 0.125 us",
     [2., 2., 2.], "error of the peak (per mille)", r"error of the peak " + NUMBER, 0.),
]
ORDERS = [
    ("ring mode, plane strain, in the mesh", "element/ring_modes",
     r"enhanced, plane strain: order of convergence (.*)"),
    ("curved block of general cells, displacements, in the mesh", "element/convergence",
     r"enhanced: .*order in the size of cells (.*)"),
    ("frequency of an element, in the step", "element/time_order",
     r"enhanced: order of the frequency in the step ([0-9. ]*)"),
]

# system, test, its lines: bounded at 0.98 of the limit, blown up at which share of it
N_STEPS = 100000
LIMITS = [
    *[(name, "stability/critical_time_step", name + r": (?s:.*?)bounded at 0.98: (\w+)",
       name + r": (?s:.*?)blows up at (1.02): yes")
      for name in ("two lumps and a bar", "with a dashpot", "chain of 60 lumps",
                   "a stiff bar and a damped one", "a bar and a dashpot", "roller that sticks",
                   "roller between bar and tooth", "two rollers on a light hub")],
    *[(f"{part}, {kind}", "element/critical_time_step",
       f"(?m:^){part}, {kind}: bounded at 0.98 of the limit: (\\w+)",
       f"(?m:^){part}, {kind}: bounded.*blown up at (1.02): yes")
      for part in ("cube", "distorted cube", "eight distorted cubes")
      for kind in ("one point", "enhanced", "full")],
    *[(f"roller shrunk onto a bush: {name}", "stability/closed_contact",
       name + r": bounded at 0.98 of the limit: (\w+)", name + ": blows up at " + NUMBER)
      for name in ("one element through the wall", "three elements through the wall",
                   "three, damped", "three, damped, friction", "three, ten times as stiff",
                   "one, ten times as stiff, damped", "three, finer along than the bush",
                   "three, finer than the bush", "one, coarser than the bush")],
]

LEFT_OUT = """Left out: V7 and V8 (spheres) because a chain drive has none; V10 (half width of contact in an ISO seat)
because its 0.9 mm want elements of 0.1 mm at every tooth, where nothing else of the drive does."""


def run(build, test, arguments=()):
    """Output of the test's program with its digits, and the CPU time of one core [s]."""
    room, name = test.split("/")
    folder = os.path.join(os.path.abspath(build), "tests", room, name + ".release")
    with tempfile.TemporaryDirectory() as here:
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        done = subprocess.run([os.path.join(folder, name + ".release"), *arguments], cwd=here,
                              text=True, stdout=subprocess.PIPE, check=True)
        cost = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        text = done.stdout
        digits = os.path.join(here, "digits")
        if os.path.exists(digits):
            with open(digits, encoding="utf-8") as file:
                text += file.read()
    return text, cost


def row(figure, text):
    """Expected, obtained, error, tolerance as text, and whether it is met."""
    found = re.search(figure.pattern, text)
    if found is None:
        return ["", "not found", "", "", False]
    if isinstance(figure, Holds):
        met = found.group(1) == "yes"
        return ["holds", "yes" if met else "no", "", f"{figure.bound:g}", met]
    value = float(found.group(1))
    error = abs(value - figure.expected)
    return [f"{figure.expected:g}{figure.unit}", f"{found.group(1)}{figure.unit}", f"{error:.1e}",
            f"{figure.tolerance:g}", error <= figure.tolerance]


def convergence(text_of):
    """Lines of the tables of errors and of orders."""
    lines = ["| case | test | refined | figure | values | error | observed order |",
             "|---|---|---|---|---|---|---|"]
    for case, test, refined, factors, figure, pattern, limit in SERIES:
        values = re.findall(pattern, text_of(test))
        errors = [abs(float(v) - limit) for v in values]
        orders = [f"{math.log(a / b) / math.log(f):.1f}"
                  for a, b, f in zip(errors, errors[1:], factors or [])]
        lines.append(f"| {case} | `{test}` | {refined} | {figure} | {', '.join(values)} | "
                     f"{', '.join(f'{e:.2g}' for e in errors)} | {', '.join(orders) or '–'} |")
    for case, test, pattern in ORDERS:
        order = re.search(pattern, text_of(test)).group(1).strip().replace(" ", ", ")
        lines.append(f"| {case} | `{test}` | | | | | {order} |")
    return lines


def critical_time_steps(build):
    """Lines of the table of critical time steps, and whether each limit is safe and sharp."""
    lines = ["| system | test | steps at 0.98 of the limit | blows up at, over the limit |",
             "|---|---|---|---|"]
    texts, good = {}, True
    for system, test, bounded, blow_up in LIMITS:
        if test not in texts:
            texts[test] = run(build, test, [str(N_STEPS)])[0]
        safe = re.search(bounded, texts[test])
        sharp = re.search(blow_up, texts[test])
        safe = safe is not None and safe.group(1) == "yes"
        good = good and safe and sharp is not None and float(sharp.group(1)) < 1 / 0.85
        lines.append(f"| {system} | `{test}` | {N_STEPS if safe else '**unbounded**'} | "
                     f"{sharp.group(1) if sharp else '**not found**'} |")
    return lines, good


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", default="build")
    build = parser.parse_args().build

    outputs, rows = {}, []

    def text_of(test):
        if test not in outputs:
            outputs[test] = run(build, test)
        return outputs[test][0]

    for number, case, test, figures in CASES:
        first = test not in outputs
        text, cost = text_of(test), outputs[test][1]
        for i, figure in enumerate(figures):
            rows.append([number if i == 0 else "", case if i == 0 else "–",
                         f"`{test}`" if i == 0 else "", figure.what, *row(figure, text),
                         f"{cost:.1f}" if first and i == 0 else ""])

    print("# Verification\n\nWritten by `scripts/verification.py`: closed forms beside what "
          "the program gives, from the programs of\n`tests/`. CPU time is that of the whole test "
          "on one core.\n")
    print("| id | case | test | figure | expected | obtained | error | tolerance | met | CPU (s) |\n"
          "|---|---|---|---|---|---|---|---|---|---|")
    for line in rows:
        line[8] = "yes" if line[8] else "**no**"
        print("| " + " | ".join(line) + " |")
    n_met = sum(line[8] == "yes" for line in rows)
    print(f"\n{len(CASES)} cases, {len(rows)} figures, {n_met} met.\n\n{LEFT_OUT}\n")
    print("## Convergence\n\nThe impact of the bar has a penalty that rises with the number of "
          "elements. Ring, cantilever and conforming contact are\ncompared with references that "
          "differ from the limit of the mesh by a per cent or less: no order is given.\n")
    print("\n".join(convergence(text_of)))
    lines, good = critical_time_steps(build)
    print(f"\n## Critical time steps\n\n{len(LIMITS)} systems at small amplitude, contacts held closed. "
          "A share of 1.02 is the smallest that was tried above the limit.\n")
    print("\n".join(lines))
    return 0 if n_met == len(rows) and good else 1


if __name__ == "__main__":
    sys.exit(main())
