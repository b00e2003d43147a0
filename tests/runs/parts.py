# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `chaindrive parts` prints of a drive with two equal sprockets: parts in series, stiffness over load and pressure
angle, the values that a run takes, all of it from the cache at the second time, and nothing written."""
import os
import pathlib
import re
import sys

import program
from program import check

PROGRAM = pathlib.Path(sys.argv[1])
DRIVE = {
    "Drive/Driven teeth": 15,
    "Drive/Sprockets/Driven outside diameter in mm": 81.8,
    "Drive/Sprockets/Driven hub diameter in mm": 33,
    "Drive/Layout/Centre distance from": "slack",
    "Loads/Resisting torque in N m": 54,
}
NUMBER = re.compile(r"(?<!\S)\d+(?:\.\d+)?(?:e[+-]\d+)?(?!\S)")


def said_by(command, **entries):
    """Standard output of a command; `entries` of section Drive/Chain or Model, with _ for a space."""
    own = {f"{'Model' if name.startswith('Stiffness') else 'Drive/Chain'}/{name.replace('_', ' ')}": value
           for name, value in entries.items()}
    words = program.command("prm/paper/layered-auto.prm", {**DRIVE, **own}, program=PROGRAM)
    done = program.start([words[0], command, *words[1:]])
    check(done.returncode == 0, f"{command}: status {done.returncode}\n{done.stderr}")
    return done.stdout


def table(text, heading):
    """The rows of numbers of the table whose title begins with `heading`."""
    lines = text[text.index(heading):].split("\n\n")[0].splitlines()
    return [[float(word) for word in NUMBER.findall(line)] for line in lines[2:]]


def near(value, expected, share, what):
    """Ends the script unless `value` is that near to `expected`."""
    check(abs(value / expected - 1) < share, f"{what}: {value} instead of {expected}")


def rising(values, what):
    """Ends the script unless each value is above the last."""
    check(all(a < b for a, b in zip(values, values[1:])), f"{what}: {values} do not rise")


text = said_by("parts")
again = said_by("parts")
results = [said[:said.index("\nElastic solutions")] for said in (text, again)]
check(results[0] == results[1], "the cache changes what is printed")
parts = again[again.index("\nElastic solutions"):].strip().splitlines()[2:]
check(len(parts) > 9 and all("cached" in line for line in parts), f"not everything comes from the cache:\n{again}")
check(os.listdir() == [], f"it writes {os.listdir()}")

roller, inner, outer, pitch = (row[0] for row in table(text, "Masses"))
near(pitch, roller + 0.5 * (inner + outer), 1e-3, "mass per pitch")

pull = table(text, "Two links pulled")
for load, stiffness, total, of_inner, of_outer, _ in pull:
    near(load / stiffness, total, 2e-3, "extension (um)")
    check(0.7 * total < of_inner + of_outer < total, f"links alone {of_inner} and {of_outer} of {total} um")
rising([row[1] for row in pull], "stiffness per pitch over the load")

pressed = table(text, "Roller pressed")
for row in pressed:
    near(1 / row[2] + 1 / row[3], 1 / row[4], 2e-3, "compliance of tooth and bush in series")
    check(row[2] < row[5], f"the tooth with its contact, {row[2]}, is stiffer than without, {row[5]}")
rising([row[4] for row in pressed[:4]], "pressed roller over the load")
rising([-row[5] for row in pressed if row[0] == pressed[2][0]], "softness of the tooth over the pressure angle")

for factor, howland, _ in table(text, "Side plates"):
    check(1.5 * howland < factor < 2.5 * howland, f"plates: factor {factor}, without pin {howland}")

# the first is the ovalisation of a ring, 42.09 kHz in plane stress and 44.03 kHz in plane strain, in two modes
vibrations = table(text, "Vibration of parts")
check(42 < vibrations[0][3] < 45 and vibrations[0][0] >= 2, f"roller: {vibrations[0]}")
for natural, attached, stiff, *frequencies in vibrations:
    check(natural >= len(frequencies) and attached > 10 and stiff < 4, f"basis of {natural} + {attached}, {stiff} %")
    rising(frequencies, "natural frequencies")
check(10 < vibrations[2][3] < vibrations[1][3] < 30, "the outer link is the longer and softer one")

# a run takes these
planned = said_by("plan")
for said, value in (("Stiffness per pitch", pull[2][1]), ("Roller-tooth stiffness", pressed[2][2]), ("Roller-bush stiffness", pressed[2][3])):
    near(1e-6 * float(re.search(said + r" (\S+) N/m", planned).group(1)), value, 1e-3, said)

# parts that have no solution, hollow pins of half a millimetre: estimates, and the log says so
thin = {"Pin_diameter_in_mm": 0.5, "Pin_bore_in_mm": 0.4}
estimated, asked = said_by("plan", **thin), said_by("plan", **thin, Stiffness_from="dimensions")
check("The parts could not be solved with these dimensions" in estimated, f"no word of estimates:\n{estimated}")
values = [re.findall(r"(\S+ stiffness|Stiffness per pitch) (\S+) N/m", said) for said in (estimated, asked)]
check(len(values[0]) > 2 and values[0] == values[1], f"estimates differ: {values}")
print("as expected")
