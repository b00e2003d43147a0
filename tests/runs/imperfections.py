# SPDX-License-Identifier: LGPL-2.1-or-later
"""imperfections.py CASE PROGRAM: drives whose links and wheels are not all as drawn, against closed forms of slow drives.

  pitches   With links of their own pitches the driven sprocket is ahead of that of equal links by what the links between the rollers
            that bear are shorter than in the mean, over its radius; and this, and the forces on teeth, repeat with the chain
  index, index-layered
            Tooth gaps that stand off their places by e cos(2 pi k/z) along the pitch circle turn the driven shaft by the sum of
            m_k e_k over its radius, m_k the part that gap k takes of a torque that is added (Castigliano's theorem): one line each
            at the frequency of the shaft
  runout    Wheels with eccentric pitch circles turn the driven shaft by w2 = w1 (r1 + e1 n) / (r2 + e2 n), n the outward normal of
            the tight span: one line each at the frequency of its shaft, of known height and phase
"""
import math
import sys

import h5py
import numpy as np

import program
from program import check

CASE, PROGRAM = sys.argv[1:3]
TEETH, LINKS, PITCH = (15, 20), 60, 15.875e-3  # of the 525 chain of hard.prm; 4 turns of the driver, 3 of the driven sprocket
PITCH_TIME = 10e-3  # s, far below the resonance of the driven inertia
SPEED = 2 * math.pi / (TEETH[0] * PITCH_TIME)
SAMPLES = 40  # in a pitch
INDEX = {"index": {"simple": 1}, "index-layered": {"layered": 4}}  # fidelity and accuracy of the phase in degrees
RADII = [0.5 * PITCH / math.sin(math.pi / z) for z in TEETH]
DRIVE = {
    "Drive/Number of links": LINKS,
    "Drive/Driver teeth": TEETH[0],
    "Drive/Driven teeth": TEETH[1],
    "Drive/Layout/Start": "settled",
    "Drive/Layout/Centre distance from": "slack",
    "Drive/Layout/Slack in mm": 6,
    "Model/Driven inertia in kg m2": 3e-4,
    "Model/Stiffness per pitch in N/m": 2e7,
    "Model/Chain damping ratio": 0.5,
    "Contact/Damping ratio": 0.5,
    "Loads/Driver speed in rad/s": repr(SPEED),
    # rollers under load keep their places in the gaps, where they have some 0.05 mm of room; a brake damps
    "Loads/Resisting torque in N m": 100,
    "Loads/driven/Of speed/Linear in N m s": 0.3,
    "Effects/Friction": "off",
    "Time/Time step in us": 1,
    "Output/History interval in us": 1e6 * PITCH_TIME / SAMPLES,
    "Output/History precision": "double",
    "Output/Window start in ms": 1e3 * PITCH_TIME,
    "Output/Field interval in ms": 0,
}


def run(fidelity, pitches, changes):
    entries = {**DRIVE, "Model/Fidelity": fidelity, "Time/End time in ms": 1e3 * pitches * PITCH_TIME, **changes}
    program.run("prm/verification/hard.prm", entries, "--output", "results", program=PROGRAM)
    histories = {}
    with h5py.File("results/histories.h5") as file:
        file.visititems(lambda name, item: histories.update({name: item[:]}) if isinstance(item, h5py.Dataset) else None)
    return histories, program.summary("results")["drive"]


def near(what, value, wanted, within):
    print(f"{what}: {value:.5g}, wanted {wanted:.5g} +- {within:.2g}")
    check(abs(value - wanted) <= within, f"{what}: {value} instead of {wanted}")


def line(values, number):
    """The complex amplitude of `values`, of the whole chain's way round, at so many periods in it."""
    n = len(values)
    return 2 / n * np.sum(values * np.exp(-2j * math.pi * number * np.arange(n) / n))


def rms(values):
    return math.sqrt(np.mean(np.square(values)))


def weights(drive):
    """How much each link counts for where the driven sprocket is, by its distance from joint 0 against the travel, below 0 on the driver.

    Sprockets stand as their rollers bear on them, and each roller takes the same part of the tension before it, as between the
    tensions of the two spans.
    """
    slack, tight = (drive["spans"][i] for i in (0, -1))
    links = {i: 1.0 for i in range(tight["links"])}
    for teeth, wheel, at in zip(TEETH, drive["sprockets"], (lambda i: -1 - i, lambda i: tight["links"] + i)):
        rollers = round(wheel["wrap"] * teeth / (2 * math.pi)) + 1
        for i in range(rollers):
            links[at(i)] = (slack["tension"] / tight["tension"]) ** ((i + 1) / rollers)
    return links


def pitches():
    # one wave along the chain, which goes on by a link a pitch: joint 0 enters the driver at first, then joint -1
    height = 20e-6
    deviations = [height * math.cos(2 * math.pi * k / LINKS) for k in range(LINKS)]
    listed = {"Drive/Chain/Pitch deviations in um": ", ".join(f"{1e6 * d:.9f}" for d in deviations)}
    for fidelity, turns in (("simple", 2), ("layered", 1)):
        count = turns * LINKS + 4
        equal, _ = run(fidelity, count, {})
        own, drive = run(fidelity, count, listed)
        counting = weights(drive)
        pulled = [sum(weight * deviations[(-1 - i - j) % LINKS] for i, weight in counting.items()) for j in range(4, LINKS + 4)]
        ahead = RADII[1] * (own["hubs/driven_angle"] - equal["hubs/driven_angle"])[::SAMPLES]
        first = ahead[4 : LINKS + 4]
        got, wanted = line(first, 1), line(-np.array(pulled), 1)
        near(f"{fidelity}: driven sprocket ahead by links, um", 1e6 * abs(got), 1e6 * abs(wanted), 0.03e6 * abs(wanted))
        near("its phase, in links", np.angle(got / wanted) * LINKS / (2 * math.pi), 0, 0.5)
        if turns > 1:
            again = ahead[LINKS + 4 : 2 * LINKS + 4]
            near("the same after a turn of the chain, of it", abs(line(again, 1) / got - 1), 0, 0.03)
            # a tooth of the driver meets the same links again after a turn of the chain, and others after its own
            force = own["teeth/driver_force"][1:].reshape(count, SAMPLES, TEETH[0]).mean(1)  # means over pitches, without impacts
            of = lambda begin: force[4 + begin : 4 + begin + 45]  # noqa: E731
            chain, turn = rms(of(LINKS) - of(0)), rms(of(TEETH[0]) - of(0))
            near("forces of teeth after a turn of the chain, of those after one of the driver", chain / turn, 0, 0.2)
            check(turn > 0.01 * rms(of(0)), "the teeth feel no difference")


def runout():
    eccentric, phases = (0.15e-3, 0.2e-3), (40, 250)  # m, degrees
    for fidelity in ("simple", "layered"):
        entries = {}
        for name, e, phase in zip(("driver", "driven"), eccentric, phases):
            entries[f"Drive/Wheels/{name}/Runout in um"] = 2e6 * e
            entries[f"Drive/Wheels/{name}/Runout phase in degrees"] = phase
        found, drive = run(fidelity, LINKS + 4, entries)
        begin, end = (np.array(drive["spans"][-1][name]) for name in ("begin", "end"))
        along = (end - begin) / np.linalg.norm(end - begin)
        normal = math.atan2(-along[0], along[1])  # to the right of travel
        inside = slice(4 * SAMPLES, (LINKS + 4) * SAMPLES)
        speed = found["hubs/driven_speed"][inside]
        mean = SPEED * TEETH[0] / TEETH[1]
        near(f"{fidelity}: mean speed", speed.mean(), mean, 1e-3 * mean)
        for i, name in enumerate(("driver", "driven")):
            number = LINKS // TEETH[i]  # turns
            angle = math.radians(phases[i]) + number * 2 * math.pi * 4 / LINKS - normal
            wanted = (1, -1)[i] * mean * eccentric[i] / RADII[i] * np.exp(1j * angle)
            got = line(speed, number)
            near(f"{name}: line of its shaft, of the mean speed", abs(got) / mean, abs(wanted) / mean, 0.05 * abs(wanted) / mean)
            near("its phase, degrees", math.degrees(np.angle(got / wanted)), 0, 5)
        others = max(abs(line(speed, number)) for number in range(1, 15) if number not in (3, 4))
        near("the highest other line of low order, of the last one", others / abs(wanted), 0, 0.05)


def moments(found, name, wheel):
    """Of the rollers on a wheel, from the tensions of their links, N m by samples and rollers; and the gap of each.

    Rollers that do not bear have none.
    """
    inside = slice(4 * SAMPLES, (LINKS + 4) * SAMPLES)
    at = found["rollers/position_x"][inside] + 1j * found["rollers/position_y"][inside]
    link = np.roll(at, -1, axis=1) - at
    pull = found["links/tension"][inside] * link / abs(link)
    moment = np.imag(np.conj(at - complex(*wheel["centre"])) * (pull - np.roll(pull, 1, axis=1)))
    rollers, teeth = found[f"rollers/{name}_force"][inside], found[f"teeth/{name}_force"][inside]
    gap = np.argmin(abs(rollers[:, :, None] - teeth[:, None, :]), axis=2)  # no two rollers have the same force
    return np.where(rollers > 0, moment, 0), gap


def index():
    heights, torques = (40e-6, 53e-6), (90, 110)
    for fidelity, degrees in INDEX[CASE].items():
        angle, moved = 0, [0, 0]
        for sign in (1, -1):  # half of the difference is free of what all drives do
            own = [[sign * e * math.cos(2 * math.pi * k / teeth) for k in range(teeth)] for e, teeth in zip(heights, TEETH)]
            entries = {f"Drive/Wheels/{name}/Index deviations in um": ", ".join(f"{1e6 * d:.9f}" for d in deviations)
                       for name, deviations in zip(("driver", "driven"), own)}
            runs = [run(fidelity, LINKS + 4, {**entries, "Loads/Resisting torque in N m": torque}) for torque in torques]
            angle = angle + 0.25 * sign * sum(found["hubs/driven_angle"] for found, _ in runs)
            for i, (name, deviations) in enumerate(zip(("driver", "driven"), own)):
                (less, gap), (more, _) = (moments(found, name, drive["sprockets"][i]) for found, drive in runs)
                added = np.where((less != 0) & (more != 0), more - less, 0)
                moved[i] = moved[i] + 0.5 * sign * np.sum(added * np.array(deviations)[gap], axis=1) / np.mean(np.sum(added, axis=1))
        for i, name in enumerate(("driver", "driven")):
            number = LINKS // TEETH[i]
            wanted = (1, -1)[i] * line(moved[i], number) / RADII[1]
            got = line(angle[4 * SAMPLES : (LINKS + 4) * SAMPLES], number)
            near(f"{fidelity}: {name}, angle of the driven shaft at its line, urad", 1e6 * abs(got), 1e6 * abs(wanted), 0.02e6 * abs(wanted))
            near("its phase, degrees", math.degrees(np.angle(got / wanted)), 0, degrees)


{"pitches": pitches, "index": index, "index-layered": index, "runout": runout}[CASE]()
