# SPDX-License-Identifier: LGPL-2.1-or-later
"""asked.py CASE PROGRAM: small drives that are asked for some quantities or have some effects switched.

  outputs      what is asked for is the same, bit by bit, whatever else is; what is not leaves nothing behind
  irrelevant   an effect that is on but cannot act gives what it gives when it is off
  mixed        elastic rollers on rigid links and the reverse, one elastic sprocket: sound, and near to each other
  settled      the window opens by itself; also in a run that was interrupted
"""
import math
import os
import pathlib
import shutil
import sys

import program
from program import check
from small_drives import ELASTIC, RIGID

CASE, PROGRAM = sys.argv[1:3]

OUTPUT = {"Output/CSV": "true"}
ELASTIC = {**ELASTIC, **OUTPUT, "Output/Field interval in ms": 0}
LAYERED = {**RIGID, **OUTPUT, "Model/Fidelity": "layered", "Time/End time in ms": 2, "Loads/Ramp time in ms": 0.5, "Output/Field interval in ms": 0.5}


def run(directory, entries, ranks=1, options=()):
    """Runs a small drive; returns what it says."""
    if not options:
        shutil.rmtree(directory, ignore_errors=True)
    return program.run("prm/verification/hard.prm", entries, "--output", directory, *options, program=PROGRAM, ranks=ranks)


def histories(directory):
    return {file.name[10:-4]: file.read_bytes() for file in sorted(pathlib.Path(directory).glob("histories_*.csv"))}


def columns(text):
    """Columns of a CSV file by their titles."""
    return {words[0]: words[1:] for words in zip(*(line.split(b",") for line in text.splitlines()))}


def numbers(directory):
    summary = program.summary(directory)
    return {name: value for name, value in summary.items() if name not in ("wall_seconds", "cpu_seconds", "memory_peak", "ranks")}


GROUPS = {  # of histories, by what a run is asked for
    "speeds": {"hubs"},
    "tensions": {"links", "spans"},
    "tooth forces": {"hubs", "rollers", "teeth"},
    "joint forces": {"joints"},
    "roller motion": {"rollers"},
    "engagements": set(),
    "energy": {"energy"},
    "tensions, speeds": {"hubs", "links", "spans"},
}


def outputs():
    run("all", LAYERED)
    everything, summary = histories("all"), numbers("all")
    for asked, groups in GROUPS.items():
        run("some", {**LAYERED, "Output/Quantities": asked})
        some = histories("some")
        check(set(some) - {"time"} == groups, f"{asked}: the histories {sorted(some)} instead of {sorted(groups)}")
        for group in groups:  # hubs and rollers have two sources
            expected = columns(everything[group])
            for name, values in columns(some[group]).items():
                check(values == expected[name], f"{asked}: another {name} of {group} than in a run asked for all")
        for name, value in numbers("some").items():
            expected = {part: summary[name][part] for part in value} if isinstance(value, dict) else summary[name]
            check(value == expected, f"{asked}: another {name} in the summary")
        check(not os.path.exists("some/fields"), f"{asked}: there are pictures")
        check(("engagements" in numbers("some")) == (asked == "engagements"), f"{asked}: engagements in the summary")

    # an elastic model in the effects that tensions have by themselves
    off = {f"Effects/Elastic {body}": "off" for body in ("rollers", "driver", "driven")}
    run("all", {**ELASTIC, **off})
    run("some", {**ELASTIC, "Output/Quantities": "tensions"})
    for group in ("links", "spans"):
        check(histories("some")[group] == histories("all")[group], f"full: other {group} than in a run asked for all")


def irrelevant():
    step = {"Time/Time step in us": 0.05}
    layered = {**LAYERED, "Time/Time step in us": 0.05, "Time/End time in ms": 1, "Output/Field interval in ms": 0}
    for entries, on, off in (
        (layered, {"Loads/Gravity in m/s2": 0}, {"Effects/Gravity": "off"}),
        (layered, {"Contact/Friction coefficient": 0}, {"Effects/Friction": "off"}),
        (layered, {"Contact/Damping ratio": 0}, {"Effects/Contact damping": "off"}),
        ({**ELASTIC, **step, "Model/Symmetry model": "false", "Time/End time in ms": 0.05}, {"Contact/Plate faces": "on"}, {"Contact/Plate faces": "off"}),
    ):
        run("on", {**entries, **on})
        run("off", {**entries, **off})
        for group, text in histories("off").items():
            if group == "energy":  # has a column less
                continue
            check(text == histories("on")[group], f"{on}: other {group} than with {off}")

    # play of a picometre, which changes the mean pitch by as much
    play = {"Drive/Chain/Bush diameter in mm": 7.43, "Drive/Chain/Roller bore in mm": 7.430000002}
    play.update({"Drive/Chain/Pin diameter in mm": 5.24, "Drive/Chain/Bush bore in mm": 5.240000002})
    clearances = ("Effects/Roller-bush clearance", "Effects/Bush-pin clearance")
    short = {**layered, "Time/End time in ms": 0.4}
    run("on", {**short, **play})
    run("off", {**short, **dict.fromkeys(clearances, "off")})
    on, off = numbers("on"), numbers("off")
    for name in ("driven_angle_end", "tight_tension_mean", "drive_work"):
        check(abs(on[name] / off[name] - 1) < 1e-4, f"no play: {name} {off[name]} instead of {on[name]}")
    run("play", short)
    check(abs(numbers("play")["drive_work"] / off["drive_work"] - 1) > 1e-3, "play makes no difference")


def elastic_off(*bodies):
    return {f"Effects/Elastic {body}": "off" for body in bodies}


MIXED = {
    "all elastic": {},
    "rigid links": elastic_off("links"),
    "rigid rollers": elastic_off("rollers", "driver", "driven"),
    "rigid driver": elastic_off("driver"),
    "rigid driven": elastic_off("driven"),
    "rigid sprockets": elastic_off("driver", "driven"),
    # a shorter step than auto takes, for a sharp balance
    "all rigid": {**elastic_off("links", "rollers", "driver", "driven"), "Time/Safety factor": 0.1},
    "flat plates": {"Effects/Plate bending": "off"},
    "no play": {"Effects/Roller-bush clearance": "off", "Effects/Bush-pin clearance": "off"},
}


def mixed():
    entries = {**ELASTIC, "Loads/Ramp time in ms": 0.1, "Time/End time in ms": 0.5, "Output/Window start in ms": 0.2}
    tension = {}
    for what, switches in MIXED.items():
        run("mixed", {**entries, **switches})
        s = numbers("mixed")
        tension[what] = s["tight_tension_mean"]
        print(f"{what}: tight tension {tension[what]:.4g} N, energy imbalance {s['energy_imbalance_max']:.2g}", flush=True)
        check(s["energy_imbalance_max"] < 1e-3, f"{what}: energy imbalance {s['energy_imbalance_max']}")
        check(s["momentum_imbalance_max"] < 1e-12, f"{what}: momentum imbalance {s['momentum_imbalance_max']}")
        check(s.get("contacts_missed", 0) == 0, f"{what}: contacts were missed")
    # the tension that a driven sprocket set in motion within 0.1 ms asks for grows with the root of the stiffness
    for what, value in tension.items():
        check(0.8 < value / tension["all elastic"] < 1.25, f"{what}: tension {value} N, all elastic {tension['all elastic']} N")
    for stiffer in ("rigid links", "rigid driver", "rigid driven", "rigid sprockets", "flat plates"):
        check(tension[stiffer] > tension["all elastic"], f"{stiffer}: less tension than with all elastic")


def same(one, other):
    for group, text in histories(one).items():
        check(text == histories(other)[group], f"{other}: other {group} than in {one}")
    check(numbers(one) == numbers(other), f"{other}: another summary than {one}")


def settled():
    pitch_time = 2 * math.pi / 120.74 / 9
    ramp = 2e-3
    entries = {**RIGID, **OUTPUT, "Loads/Ramp time in ms": 1e3 * ramp, "Output/Field interval in ms": 0}
    entries.update({"Time/End time in ms": 400, "Output/Window start in ms": "settled", "Output/Window length in pitches": 5})
    said = run("through", entries)
    s = numbers("through")
    begin, end = s["window"]["start"], s["window"]["end"]
    pitches = (begin - ramp) / pitch_time
    check(s["window"]["settled"], f"it does not settle: {s['window']}")
    check(abs(pitches - round(pitches)) < 1e-9 and 6 <= pitches < 40, f"the window begins after {pitches} pitch times")
    check(abs((end - begin) / pitch_time - 5) < 1e-9, f"the window is {(end - begin) / pitch_time} pitch times long")
    check(0 <= s["steps"] * s["time_step"] - end < s["time_step"] * 1.01, "the run does not end with its window")
    check("Means from" in said and "after the drive had settled" in said, said)

    # the same window, given: the same means
    given = {"Output/Window start in ms": repr(1e3 * begin), "Output/Window end in ms": repr(1e3 * end)}
    given["Time/End time in ms"] = repr(1e3 * s["steps"] * s["time_step"])
    run("given", {**entries, **given})
    for name, value in numbers("given").items():
        if name.endswith("_mean"):
            check(abs(value / s[name] - 1) < 1e-9, f"{name} {s[name]}, and {value} over the same window, given")

    # a driven inertia that swings slower than the tooth frequency: over whole swings, and one decision
    heavy = {**entries, "Model/Driven inertia in kg m2": 0.04, "Drive/Layout/Start": "settled", "Time/End time in ms": 1000}
    said = run("heavy", heavy)
    s = numbers("heavy")
    swing = s["drive"]["tooth_frequency"] / s["drive"]["driven_frequency"]
    judged = s["window"]["judged_pitches"]
    check(swing > 1.5 and judged == 6 * math.ceil(swing), f"judged over {judged} pitch times, and a swing takes {swing}")
    first, last = (s["window"][which] / pitch_time for which in ("start", "end"))
    check(abs(first / math.ceil(swing) - round(first / math.ceil(swing))) < 1e-6, f"the window begins after {first} pitch times")
    check(abs(last - first - judged) < 1e-6, f"a window of {last - first} pitch times")
    check(s["statistics"]["settled"] is True and "not settled" not in said and f"had settled over {judged} pitch times" in said, said)
    said = run("heavy", {**heavy, "Time/End time in ms": 20})
    check(f"judged over {judged} pitch times, so that the window can be full at" in said, said)
    check(numbers("heavy")["statistics"]["settled"] is False, "settled without a window")

    # too short: before it has settled, and before the window is full; then they go on
    for stop in (1e3 * begin - 3, 1e3 * begin + 7):
        short = {"Time/End time in ms": stop, "Output/Checkpoint interval in ms": 2}
        shutil.rmtree("resumed", ignore_errors=True)
        said = run("resumed", {**entries, **short})
        sentence = "is not full" if stop > 1e3 * begin else "The drive has not settled"
        check(sentence in said, f"it does not say '{sentence}':\n{said}")
        check((numbers("resumed")["tight_tension_mean"] is None) == (stop < 1e3 * begin), "means without a window")
        words = ("prm/verification/hard.prm", {**entries, "Output/Window start in ms": 5}, "--output", "resumed", "--resume", "auto")
        said = program.run(*words, program=PROGRAM, status=2)
        check("leave Output/Window start in ms" in said, said)
        run("resumed", entries, options=("--resume", "auto"))
        same("through", "resumed")


if CASE not in ("outputs", "irrelevant", "mixed", "settled"):
    sys.exit(__doc__)
globals()[CASE]()
print("as expected")
