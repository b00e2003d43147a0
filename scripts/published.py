#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""published.py [--program PROGRAM] [TOPIC...]: compares chaindrive with published results.

Runs the files of prm/published with the variations that the tables need, computes the published closed forms, and prints
doc/validation/published.md, or these of its topics:

    /usr/bin/python3 scripts/published.py > doc/validation/published.md

Takes two to three minutes on one core. Results go to a temporary folder. Needs python3-h5py and python3-pandas.
"""
import argparse
import math
import pathlib
import tempfile
import textwrap

import numpy as np

import chaindrive
import program
from published_theory import (articulation_losses, articulation_of, four_bar, harmonic_of_period, path_stretch, power_of_waves, pressure_angle,
                              radius, tooth_ratio)

PITCH = {"40": 12.7e-3, "60": 19.05e-3}
CENTRE = "Drive/Layout/Centre distance in mm"
SPEED = "Loads/Driver speed in rad/s"
TORQUE = "Loads/Resisting torque in N m"
LAYERED = {"Model/Fidelity": "layered"}
SIMPLE = {"Model/Fidelity": "simple"}
HORSEPOWER = 745.7


class Runs:
    """Runs of the files in prm/published, each once."""

    def __init__(self, which, folder):
        self.which, self.folder, self.done = which, pathlib.Path(folder), {}

    def __call__(self, name, entries=()):
        key = name, tuple(sorted(dict(entries).items()))
        if key not in self.done:
            folder = self.folder / str(len(self.done))
            program.run(f"prm/published/{name}.prm", entries, "--quiet", "--output", folder, program=self.which)
            self.done[key] = chaindrive.open(folder)
        return self.done[key]


def equal_teeth(z):
    return {"Drive/Driver teeth": z, "Drive/Driven teeth": z}


# ---- what a run gave


def ratio_harmonic(run, order=1):
    """Harmonic of the teeth of the speed ratio over its mean, from the angles over the whole pitches before the window's end."""
    z1, z2 = run.sprockets
    rows = run.rows(run.start, run.end)
    driver, driven = run["hubs/driver_angle"][rows], run["hubs/driven_angle"][rows]
    pitches = int((driver[-1] - driver[0]) * z1 / 2 / math.pi)
    angle = driver[-1] - 2 * math.pi / z1 * pitches * (1 - np.arange(400 * pitches) / (400 * pitches))
    ahead = np.interp(angle, driver, driven) - z1 / z2 * angle
    return 2 * abs(np.mean((ahead - ahead[0]) * np.exp(-1j * order * z1 * angle))) * order * z2


def harmonics(run, path):
    """Amplitudes of the first three harmonics of the teeth, over the whole pitches before the end of the window."""
    pitches = int((run.end - run.start) / run.pitch_time * (1 + 1e-9))
    time = run.end - run.pitch_time * pitches * (1 - np.arange(64 * pitches) / (64 * pitches))
    values = np.interp(time, run.time, run[path])
    values -= values.mean()
    return [2 * abs(np.mean(values * np.exp(-2j * np.pi * order * (time - time[0]) / run.pitch_time))) for order in (1, 2, 3)]


def strongest(time, values, lowest, highest):
    """Frequency of the largest line between two frequencies, Hz, with a Hann window, between lines by padding."""
    even = np.linspace(time[0], time[-1], len(time))
    values = np.interp(even, time, values)
    values = (values - values.mean()) * np.hanning(len(values))
    amplitude = np.abs(np.fft.rfft(values, 16 * len(values)))
    frequency = np.fft.rfftfreq(16 * len(values), even[1] - even[0])
    inside = (frequency > lowest) & (frequency < highest)
    return frequency[inside][np.argmax(amplitude[inside])]


def tooth_ratio_of(run, sprocket, places=4):
    """Tension behind over that before the second to fifth roller on a sprocket, all samples of the window together."""
    forces = run.values(f"rollers/{sprocket}_force", run.start, run.end)
    tensions = run.values("links/tension", run.start, run.end)
    n = forces.shape[1]
    step = 1 if sprocket == "driver" else -1  # away from the tight span
    before = behind = 0
    for force, tension in zip(forces, tensions):
        ahead = np.roll(tension, 1)  # of the link from the roller in front
        tight, slack = (ahead, tension) if step == 1 else (tension, ahead)
        first = int(np.argmax(force))
        while force[(first - step) % n] > 0:
            first = (first - step) % n
        rollers = [(first + step * (place + 1)) % n for place in range(places)]
        before, behind = before + tight[rollers].sum(), behind + slack[rollers].sum()
    return behind / before


def angle_of(ratio, z):
    """The pressure angle, degrees, at which a tooth leaves `ratio` of the tension."""
    turn = 2 * math.pi / z
    return math.degrees(math.atan2(ratio * math.sin(turn), 1 - ratio * math.cos(turn)))


# ---- tables


def verdict(deviation):
    return "holds" if abs(deviation) <= 0.05 else "near" if abs(deviation) <= 0.2 else "differs"


def row(what, expected, obtained, form="{:.3g}", judged=None):
    """A line of a table with the deviation in percent."""
    deviation = obtained / expected - 1
    return [what, form.format(expected), form.format(obtained), f"{100 * deviation:+.1f} %", judged or verdict(deviation)]


def table(first, rows, expected="published / theory", more=()):
    head = [first, expected, "chaindrive", "deviation", "verdict", *more]
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def prose(text):
    """Paragraphs of at most 100 columns."""
    return "\n\n".join(textwrap.fill(" ".join(part.split()), 100, break_long_words=False, break_on_hyphens=False)
                       for part in text.split("\n\n"))


def page(title, file, *parts):
    return "\n\n".join([f"## {title}", f"`prm/published/{file}.prm`", *(part if part.startswith("|") else prose(part) for part in parts)])


def ratio_topic(runs):
    rows = []
    drives = [((17, 17), 60, 12, (20.0, 20.125, 20.25, 20.375, 20.5)), ((15, 45), 94, 36, (30.0, 30.25, 30.5)),
              ((11, 13), 64, 9, (25.0, 25.5))]

    def entries(teeth, links, torque, span):
        centre = math.hypot(span, radius(teeth[0]) - radius(teeth[1]))
        return {"Drive/Driver teeth": teeth[0], "Drive/Driven teeth": teeth[1], "Drive/Number of links": links, TORQUE: torque,
                CENTRE: f"{12.7 * centre:.4f}"}

    for teeth, links, torque, spans in drives:
        for span in spans:
            ratios = four_bar(span, teeth)
            expected = harmonic_of_period(ratios) / ratios.mean()
            obtained = ratio_harmonic(runs("four-bar", entries(teeth, links, torque, span)))
            what = f"{teeth[0]}/{teeth[1]} teeth, span of {span:g} pitches"
            if expected < 1e-6:
                rows.append([what, "0.000", f"{100 * obtained:.3f}", "-", "holds" if obtained < 5e-4 else "differs"])
            else:
                rows.append(row(what, 100 * expected, 100 * obtained, "{:.3f}"))
    setup = entries((17, 17), 60, 12, 20.25)
    ratios = four_bar(20.25, (17, 17))
    expected = 100 * harmonic_of_period(ratios) / ratios.mean()
    layered = 100 * ratio_harmonic(runs("four-bar", {**setup, **LAYERED}))
    rows.append(row("17/17, 20.25, layered", expected, layered, "{:.3f}"))
    soft = {"Model/Stiffness per pitch in N/m": 1e8, "Contact/Roller-tooth stiffness in N/m": 1e8, TORQUE: 40,
            "Drive/Number of links": 58}
    rows.append(row("17/17, 20.25, real stiffness and load", expected, 100 * ratio_harmonic(runs("four-bar", {**setup, **soft})), "{:.3f}"))
    return page("Speed ratio", "four-bar", """First pitch harmonic of the speed ratio over its mean, in percent, at 6 rad/s without
        friction. Two polygons joined by a rigid common tangent, a four-bar linkage: G. Bouillon, G. V. Tordion, J. Eng. Ind. 87
        (1965); C. K. Chen, F. Freudenstein, J. Mech. Transm. Autom. Des. 110 (1988) 269; N. Fuglede, J. J. Thomsen (2016). The theory
        is evaluated here without approximation.""",
                table("drive", rows),
                """The theory has rigid links and teeth. In all rows but the last, elastic deflections are 1 um; in the last, with 1e8
        N/m for each link and each contact and a tension of 1.16 kN, they are 12 um. The driven sprocket turns by as much when links
        and teeth take up load, and this too repeats with each tooth; with the tenth of the deflections the deviation is gone.""")


def tooth_topic(runs):
    rows = []

    def setup(z, links):
        return {**equal_teeth(z), "Drive/Number of links": links, TORQUE: 3 * z}

    for z, links in ((11, 42), (20, 60), (40, 80)):
        obtained = tooth_ratio_of(runs("tooth-loads", setup(z, links)), "driver")
        rows.append([f"{z} teeth: pressure angle (degrees)", f"{math.degrees(pressure_angle(z)):.1f} at most",
                     f"{angle_of(obtained, z):.1f}", f"{angle_of(obtained, z) - math.degrees(pressure_angle(z)):+.1f}",
                     "holds" if -1.5 < angle_of(obtained, z) - math.degrees(pressure_angle(z)) <= 0 else "differs"])
        rows.append(row(f"{z} teeth: tension behind a roller over that before it", tooth_ratio(z), obtained))
    base = setup(20, 60)
    plain = tooth_ratio_of(runs("tooth-loads", base), "driver")
    rows.append(row("20 teeth, layered", tooth_ratio(20), tooth_ratio_of(runs("tooth-loads", {**base, **LAYERED}), "driver")))
    soft = {**base, "Model/Stiffness per pitch in N/m": 1e7, "Contact/Roller-tooth stiffness in N/m": 1e7}
    rows.append(row("20 teeth, links and teeth ten times softer: no influence", plain, tooth_ratio_of(runs("tooth-loads", soft), "driver")))
    rough = runs("tooth-loads", {**base, **LAYERED, "Contact/Friction coefficient": 0.1})
    driver, driven = (tooth_ratio_of(rough, sprocket) for sprocket in ("driver", "driven"))
    rows.append(["20 teeth, layered, friction 0.1: driver and driven sprocket differ", "they differ", f"{driver:.3f}, {driven:.3f}", "-",
                 "holds" if abs(driver - driven) > 0.01 else "differs"])
    smooth = tooth_ratio_of(runs("tooth-loads", {**base, **LAYERED}), "driver")
    rows.append(row("the same, driver: lubrication (friction 0.1 instead of 0) without influence", smooth, driver))
    return page("Tension from tooth to tooth", "tooth-loads", """Equal sprockets with 180 degrees of wrap, tooth form of ANSI B29.1,
        without friction unless said otherwise; the second to fifth roller from the tight span. ANSI/ASME B29.1 (recalled): a pressure
        angle phi of 35 - 120/z degrees at most, and sin(phi) / sin(phi + 360/z) of the tension left behind each roller. The three
        statements on influences are those that S. M. Eldiwany and K. M. Marshek (1983) draw from measurements with 20 teeth, after the
        abstract.""",
                table("case", rows),
                f"""The rollers bear a little deeper than at the end of the seat, where the largest angle is. Rollers of the simple model
        turn without friction on their bushes, so that friction acts in the layered model alone; with {driver:.3f} instead of
        {smooth:.3f} the coefficient of friction has a small influence there. Their fourth statement, that a larger pitch of the
        sprocket raises the tension, is left out: a sprocket of another pitch than the chain's cannot be set up.""")


def resonance_topic(runs):
    teeth, inertia, span = (17, 17), 0.005, 20.45
    ratios = four_bar(span, teeth)
    wave = [harmonic_of_period(ratios, order) / ratios.mean() for order in (1, 2, 3)]
    loaded = runs("four-bar", {CENTRE: span * 12.7, "Drive/Number of links": 58, TORQUE: 60, "Model/Stiffness per pitch in N/m": 1e8,
                               "Contact/Roller-tooth stiffness in N/m": 1e8, "Contact/Friction coefficient": 0.1})
    elastic = [ratio_harmonic(loaded, order) for order in (1, 2, 3)]
    r = radius(17, PITCH["40"])

    def theory(speed, natural, order=1):
        """Amplitude of the tension: T1 = (J / R^2) W^2 x1 / |1 - (W / Wn)^2|, x1 that of the path that polygons add."""
        frequency = 17 * speed * order  # rad/s
        path = wave[order - 1] * speed * r / frequency  # amplitude
        return inertia / r ** 2 * frequency ** 2 * path / abs(1 - (frequency / 2 / math.pi / natural) ** 2)

    free = runs("resonance", {SPEED: 90})
    planned = free.drive["driven_frequency"]
    settled = free.rows(free.start, free.end)
    seen = strongest(free.time[settled], free["spans/tight_tension"][settled], 0.8 * planned, 1.1 * planned)

    def at(speed, more=()):
        return runs("resonance", {SPEED: speed, "Output/Window end in ms": 499, **dict(more)})

    rows = []
    for order, speeds in ((1, (40, 50, 60, 70, 75, 80, 85, 90, 100, 130, 160)), (2, (25, 30, 35)), (3, (16, 20, 24))):
        obtained = {speed: harmonics(at(speed), "spans/tight_tension")[order - 1] for speed in speeds}
        for speed in speeds:
            frequency = 17 * speed * order / 2 / math.pi
            what = f"{speed} rad/s, {frequency:.0f} Hz: {['', 'first', 'second', 'third'][order]} harmonic (N)"
            if abs(frequency / seen - 1) < 0.05:
                peak = obtained[speed] == max(obtained.values())
                rows.append([what, "resonance", f"{obtained[speed]:.0f}", "-", "holds" if peak else "differs", "-"])
            else:
                expected = theory(speed, seen, order)
                better = expected * elastic[order - 1] / wave[order - 1]
                rows.append([*row(what, expected, obtained[speed], "{:.0f}"),
                             f"{better:.0f} ({100 * (obtained[speed] / better - 1):+.0f} %)"])

    moved = []
    for mass, speed in ((5.5, 80), (10, 80), (6, 87), (10, 70)):
        run = at(speed, {"Model/Mass per pitch in g": mass})
        second = math.sqrt(run.summary["tight_tension_mean"] / mass * 1e3 * PITCH["40"]) / (span * PITCH["40"])
        moved.append(row(f"{mass:g} g per pitch, {speed} rad/s, {17 * speed / 2 / math.pi:.0f} Hz; two half waves {second:.0f} Hz",
                         theory(speed, seen) * elastic[0] / wave[0], harmonics(run, "spans/tight_tension")[0], "{:.0f}"))
    dip = at(80)
    lines = dip.spectrum("spans/tight_offset", start=dip.start, end=dip.end)["mean_square"]
    second = math.sqrt(dip.summary["tight_tension_mean"] / dip.drive["mass_per_metre"]) / (span * PITCH["40"])
    return page("Dynamic tension through resonance", "resonance", f"""17/17 teeth, No. 40, span of {span} pitches, driven inertia 0.005
        kg m2, 1e8 N/m for each link and contact, 60 N m. S. Mahalingam (1958): the tension varies as in a forced vibration of the driven
        inertia on the tight span, which the polygons excite, T1 = (J/R^2) W^2 x1 / abs(1 - (W/Wn)^2); x1 is the harmonic of the exact
        four-bar linkage, as in the first table. The natural frequency is {seen:.1f} Hz, as free vibration has it in the spectrum at 90
        rad/s; the plan's {planned:.1f} Hz is {100 * (planned / seen - 1):.1f} % higher.""",
                table("speed, frequency", rows, more=("theory, elastic",)),
                f"""Resonance is where the theory has it, also with the second and third harmonic at a half and a third of the speed
        (superharmonics). The theory has rigid links and teeth; under this load they are deflected by 18 um, which changes the excitation.
        At 6 rad/s and under the same load the first three harmonics of the speed ratio are {elastic[0] / wave[0]:.2f},
        {elastic[1] / wave[1]:.2f} and {elastic[2] / wave[2]:.2f} times those of rigid polygons. With these the formula gives the last
        column, where in brackets is the deviation of the run from it, and most of the differences are gone, but for those at 75 and 80
        rad/s, and of 1 or 2 N.

        At these speeds the tight span swings across: a string of its tension, length and mass has {second:.0f} Hz in two half
        waves. (That it has {second / 2:.0f} Hz in one may be the reason for the deviation at 40 rad/s.) The middle of the span moves at
        {lines.iloc[1:].idxmax():.0f} Hz at 80 rad/s, the span stretches twice in each swing, and the first
        harmonic becomes smaller. The theory has no transverse vibration. If this is the reason, the speed of the dip must depend on the
        mass of the chain, which hardly changes the natural frequency of the inertia (theory with the elastic excitation):""",
                table("mass of the chain, speed, frequency", moved, "theory, elastic"),
                """It does: at 80 rad/s a lighter and a heavier chain agree, and with 6 and 10 g the dip is found where the tooth frequency
        meets two half waves again. Start phase, gravity, friction, and ten times the damping of the chain do not change it.""")


def tight_topic(runs):
    rows = []
    for z, links, span in ((17, 58, 20.5), (11, 52, 20.5), (18, 58, 20.0)):
        entries = {**equal_teeth(z), "Drive/Number of links": links}
        run = runs("tight-spans", entries)
        low, high = (runs("tight-spans", {**entries, "Drive/Layout/Pretension in N": force, "Time/End time in ms": 0.5,
                                          "Output/Window start in ms": 0, "Output/Window end in ms": "auto"}) for force in (500, 700))
        stiffness = 200 / 2 / (high.drive["centre_distance"] - low.drive["centre_distance"])
        stretch = path_stretch(span, z, links)
        expected = stiffness * PITCH["40"] * harmonic_of_period(stretch)
        obtained = harmonics(run, "spans/tight_tension")[0]
        what = f"{z}/{z} teeth, {links} links, spans of {span} pitches: first harmonic (N)"
        rows.append(row(what, expected, obtained, "{:.1f}") if expected > 1 else
                    [what, f"{expected:.1f}", f"{obtained:.1f}", "-", "holds" if obtained < 5 else "differs"])
    return page("Two tight spans", "tight-spans", """No. 40, pre-tension 600 N, no load, 6 rad/s. With a constant centre distance the path
        round two polygons varies in length over a tooth, and the tension with it: N. Fuglede and J. J. Thomsen (2016), as a statement;
        the amount is computed here from the kinematics of the polygons, times the stiffness of the drive: pre-tension over twice the
        centre distance, of drives at rest.""",
                table("drive", rows), """The stiffness comes from the program, the variation of the path does not.""")


def string_topic(runs):
    rows = []
    for speed in (2, 10, 20, 30):
        omega = 2 * math.pi * speed / (30 * PITCH["40"])
        run = runs("string", {SPEED: f"{omega:.5f}"})
        wave = math.sqrt(run.summary["tight_tension_mean"] / run.drive["mass_per_metre"])
        expected = (wave ** 2 - speed ** 2) / (2 * run.drive["spans"][1]["length"] * wave)
        rows.append(row(f"{speed} m/s, {run.summary['tight_tension_mean']:.0f} N (Hz)", expected,
                        strongest(run.time, run["spans/tight_offset"], 0.6 * expected, 1.6 * expected), "{:.2f}"))
    return page("String in motion", "string", """30/30 teeth, No. 40, spans of 40 pitches, 90 N m. S. Mahalingam, J. Franklin Inst. (1957;
        recalled): lowest frequency of the tight span (c^2 - v^2) / (2 L c) with c^2 = T / m'; T is the mean tension of the run, with
        the centrifugal one.""",
                table("chain speed, tension", rows),
                "The frequency is that of the largest line of the motion of the middle of the span.")


def articulation_cases():
    """Teeth, rpm, links, torque, entries of the time."""
    for z2, links, torque, speeds in ((15, 60, 142, (150, 600, 1200)), (45, 90, 424, (200, 600))):
        for rpm in speeds:
            pitch_time = 1e3 * 60 / rpm / 15
            end = (12 if rpm < 300 else 32) * pitch_time
            yield z2, rpm, {"Drive/Driven teeth": z2, "Drive/Number of links": links, TORQUE: torque, "Loads/Driver speed in rpm": rpm,
                            "Time/End time in ms": f"{end + 0.05:.4f}", "Output/Window start in ms": f"{2 * pitch_time:.4f}",
                            "Output/Window end in ms": f"{end:.4f}"}


def losses_topic(runs):
    rows = []
    for z2, rpm, entries in articulation_cases():
        run = runs("articulation", entries)
        pins, rollers = articulation_losses(run, 0.1, 5.94e-3, 8.71e-3)
        losses = run.summary["losses"]
        rows.append(row(f"No. 60, 15/{z2} teeth, {rpm} rpm: pins (W)", pins, losses["bush-pin"]["power"]))
        rows.append(row("the same: rollers (W)", rollers, losses["roller-bush"]["power"]))
    bicycle = runs("bicycle")
    efficiency = 100 * bicycle.summary["efficiency"]
    rows += [row("bicycle, 44/13 teeth, 90 rpm, 200 W: efficiency (%)", 98.6, efficiency),
             row("the same: losses (W)", 2.8, 2 * (100 - efficiency)),
             row("the same: pins, closed form (W)", articulation_losses(bicycle, 0.1, 3.6e-3, 5.68e-3)[0],
                 bicycle.summary["losses"]["bush-pin"]["power"])]
    # with what the polygons send into the spans, of shorter and longer ones and with more and less friction
    spans = []
    fast = {"Loads/Driver speed in rpm": 1200, "Time/End time in ms": 80, "Output/Window start in ms": 20, "Output/Window end in ms": 80}
    cases = [(f"15/{z2} teeth, {rpm} rpm", entries, 0.1) for z2, rpm, entries in articulation_cases() if rpm < 1000]
    for links, mu in ((32, 0.1), (40, 0.1), (60, 0.1), (100, 0.1), (140, 0.1), (60, 0.05), (100, 0.05), (60, 0.2), (100, 0.2)):
        cases.append((f"1200 rpm, {links} links" + (f", friction {mu}" if mu != 0.1 else ""),
                      {**fast, "Drive/Number of links": links, **({"Contact/Friction coefficient": mu} if mu != 0.1 else {})}, mu))
    for changes, words in (({"Effects/Bush-pin clearance": "off"}, "no clearance of pins"), ({"Contact/Damping ratio": 1}, "contact damping ratio 1"),
                           ({"Model/Driven inertia in kg m2": 1}, "1 kg m2")):
        cases.append((f"1200 rpm, 60 links, {words}", {**fast, "Drive/Number of links": 60, **changes}, 0.1))
    found = [(words, runs("articulation", entries), mu, (5.94e-3, 8.71e-3)) for words, entries, mu in cases]
    for words, run, mu, diameters in [*found, ("bicycle", bicycle, 0.1, (3.6e-3, 5.68e-3))]:
        (turned, rolled), waves = articulation_of(run, mu, *diameters), power_of_waves(run)
        lost, in_rollers = (run.summary["losses"][where]["power"] for where in ("bush-pin", "roller-bush"))
        deviation = lost / (turned + waves) - 1
        spans.append(f"| {words} | {turned:.3g} | {waves:.3g} | {lost:.3g} | {lost - turned:.3g} | {100 * deviation:+.1f} % | {verdict(deviation)} | "
                     f"{in_rollers - rolled:.2g} | {run.summary['tight_tension_mean']:.4g}, {run.summary['slack_tension_mean']:.3g} |")
    return page("Losses", "articulation", """The closed form has each joint turn by 360/z degrees under load as it meets and as it leaves
        a sprocket, with friction 0.1 between pin and bush and between bush and roller: after N. E. Hollingworth and D. A. Hills (1986)
        and C. J. Lodge and S. C. Burgess (2002); evaluated with the pressure angle of ANSI B29.1 and the tensions of the plan. The
        efficiency is that which J. B. Spicer et al. (2000, 2001) measured at a tension of 305 N; D. G. Wilson, Bicycling Science, and
        others have about 99 % for a single speed.""",
                table("drive", rows),
                """The tensions of the closed form are those of the plan, and its spans do not swing. They do: each end of a span follows
        the polygon, r (1 - cos(180/z)) = 1 mm up and down with each tooth, and sends waves into the chain, which friction in the joints
        takes up. The power of these waves follows from the polygon, the tension and the mass per metre alone: sqrt(T m) (w A)^2 / 2 at
        each end for each harmonic of the tooth frequency up to the highest frequency that a row of links transmits, 800 Hz in the tight
        span, 130 to 250 Hz in the slack one (`power_of_waves()` in `scripts/published_theory.py`, test `runs/waves`). Pins, with the closed form at
        the tensions of the run:""",
                "\n".join(["| drive, 15/15 teeth unless said otherwise | articulation (W) | waves (W) | chaindrive (W) | less articulation (W) | deviation from both | verdict | "
                           "rollers: less articulation (W) | tight, slack tension (N) |", "| --- | --- | --- | --- | --- | --- | --- | --- | --- |", *spans]),
                """That is the reason, as two variations show. What is lost beside the articulation does not depend on the coefficient of
        friction, with which articulation grows: friction takes what the waves bring, be it large or small. And it does not grow with the
        number of links beyond 40: where joints near the sprockets have taken up the waves, others have nothing left. So 100 links lose
        no more than 60, and 32 links, with 9 joints in each span, a third less. Waves grow with the square of the speed and more
        slowly than that where their harmonics pass the highest frequency. Up to 600 rpm, and on the bicycle, both together hold, but for
        15/45 teeth at 600 rpm (11 %). What is missing at 1200 rpm, 14 to 55 W, is alike with all coefficients of friction, too: waves that come back from the other end and meet the next
        tooth are not in the formula, nor are impacts. Neither the clearance of pins nor their damping nor the inertia of the driven
        sprocket is the reason. Spans that swing pull more at both sides than the plan has. What rollers lose on bushes beyond their articulation, 11 to
        18 W where spans swing, is alike with all coefficients of friction, too: most likely it is what impacts bring.

        The measured bicycle had a derailleur, which `prm/published/bicycle.prm` has not.""")


def seating_topic(runs):
    rows, driven = [], []
    for z2, rpm, entries in articulation_cases():
        expected = PITCH["60"] * rpm * math.pi / 30 * math.sin(pressure_angle(15) + 2 * math.pi / 15)
        impacts = runs("articulation", entries).summary["impacts"]
        speed = impacts["driver"]["normal_speed"]
        line = row(f"15/{z2} teeth, {rpm} rpm (m/s)", expected, speed["mean"])
        line[2] += f" ± {speed['uncertainty']:.2g}"
        rows.append(line)
        driven.append(impacts["driven"]["normal_speed"]["mean"] / speed["mean"])
        if z2 == 15 and rpm < 1000:
            rows.append(row("the same, simple", expected, runs("articulation", {**entries, **SIMPLE}).summary["impacts"]["driver"]
                            ["normal_speed"]["mean"]))
    return page("Speed at which rollers meet the teeth", "articulation", """Normal speed of rollers that meet the driver, mean over 10
        rollers at 150 and 200 rpm, else 30. R. C. Binder and W. G. Covert, J. Franklin Inst. 245(4) (1948) 319-329: p w sin(phi +
        360/z), with phi = 35 - 120/z degrees. Layered model unless said otherwise; ± is half of the 95 % confidence interval.""",
                table("drive", rows),
                f"""In the formula the roller comes to rest in its seat at the pressure angle, and the arriving link does not vibrate.
        Rollers of the layered model move in their clearance and rebound, so that single ones scatter. In the simple model, roller,
        bush and pin are one mass without clearance; why it meets the teeth so much faster is not explained. A chain damping ratio of 0.5
        or a contact damping ratio of 1 does not change it. On the driven
        sprocket, where rollers come from the slack span, the speed is {min(driven):.2f} to {max(driven):.2f} of that on the
        driver.""")


def catalogue_topic(runs):
    masses = {"05B": .18, "06B": .41, "08B": .70, "10B": .91, "12B": 1.18, "16B": 2.68, "20B": 3.50, "24B": 6.80, "28B": 8.50, "32B": 10.5}
    areas = {"05B": 11, "06B": 28, "08B": 50, "10B": 67, "12B": 89, "16B": 210, "20B": 295, "24B": 554, "28B": 740, "32B": 810}
    powers = {("40", 50): .37, ("40", 1200): 6.45, ("60", 50): 1.24, ("60", 1600): 14.8}

    def drive(chain, rpm=50):
        return runs("catalogue", {"Drive/Chain/Designation": chain, "Loads/Driver speed in rpm": rpm}).drive

    def straight(chain):
        return runs("catalogue", {"Drive/Chain/Designation": chain, "Loads/Driver speed in rpm": 50, "Drive/Chain/Waist ratio": 1}).drive

    rows = [row(f"{chain}: mass (kg/m)", mass, drive(chain)["mass_per_metre"]) for chain, mass in masses.items()]
    rows += [row(f"{chain}, straight plates: mass (kg/m)", masses[chain], straight(chain)["mass_per_metre"]) for chain in ("05B", "06B")]
    rows += [row(f"{chain}: bearing area (mm2)", area, 1e6 * drive(chain)["bearing_area"]) for chain, area in areas.items()]
    rows += [row(f"No. {chain}, 17 teeth, {rpm} rpm: rated power (hp)", power, drive(chain, rpm)["rated_power"] / HORSEPOWER)
             for (chain, rpm), power in powers.items()]
    return page("Masses, bearing areas, ratings", "catalogue", """Masses per metre of catalogues of chain makers; bearing areas of DIN 8187
        (recalled); rated powers of R. G. Budynas and J. K. Nisbett, Shigley's Mechanical Engineering Design, table 17-20 (recalled).""",
                table("chain", rows),
                """Masses here are those of the solids of the model (`Mass from = dimensions`) with a density of 7600 kg/m3,
        3 % below that of most steels; dimensions that no table has, such as pins' ends and the waists of plates, are
        estimates. Makers give 05B and 06B straight plates (recalled): with these 05B holds, and 06B is 9 % too light
        but for the density. Why it is so, and 32B, is not explained. `Mass from = catalogue`, the default, takes a
        catalogue's value.""")


def sagging(run, case):
    """Lines for both vibrations of the slack span, its mean tension, and lambda squared."""
    span = run.drive["spans"][0]
    length, mass = span["length"], run.drive["mass_per_metre"]
    tension = run.summary["slack_tension_mean"]
    string = math.sqrt(tension / mass) / 2 / length
    links = run.drive["spans"][0]["links"] + run.drive["spans"][1]["links"]
    parameter = (mass * 9.81 * length / tension) ** 2 * length * 1e8 / (links * tension)
    x = np.linspace(math.pi / 2 + 1e-6, 3 * math.pi / 2 - 1e-6, 200001)
    left = np.tan(x) - x + 4 * x ** 3 / parameter
    symmetric = string * 2 * x[np.argmin(np.abs(left))] / math.pi

    begin, end = np.array(span["begin"]), np.array(span["end"])
    along = (end - begin) / length
    place = (run["rollers/position_x"] - begin[0]) * along[0] + (run["rollers/position_y"] - begin[1]) * along[1]
    height = (run["rollers/position_y"] - begin[1]) * along[0] - (run["rollers/position_x"] - begin[0]) * along[1]

    def quarter(part):
        values = []
        for one, other in zip(place, height):
            inside = (one > -0.02) & (one < length + 0.02) & (np.abs(other) < 0.03)
            order = np.argsort(one[inside])
            values.append(np.interp(part * length, one[inside][order], other[inside][order]))
        return np.array(values)

    first, third = quarter(0.25), quarter(0.75)
    return [[f"antisymmetric, two half waves{case} (Hz)", 2 * string, strongest(run.time, first - third, 1.5 * string, 3 * string)],
            [f"symmetric{case} (Hz)", symmetric, strongest(run.time, first + third, 0.8 * string, 3 * string)]], tension, parameter


def sag_topic(runs):
    run = runs("sag")
    (one, tension, parameter), (other, *_) = sagging(run, ""), sagging(runs("sag", {"Model/Driven inertia in kg m2": 1}), ", 1 kg m2")
    return page("Sagging span", "sag", f"""19/57 teeth, 08B, sag 1 %, 100 rpm. H. M. Irvine and T. K. Caughey, Proc. R. Soc. A 341 (1974)
        299: twice the frequency of a string in antisymmetric vibration; in symmetric vibration 2x/pi of it, tan x = x - 4 x^3 / lambda^2,
        here with lambda^2 = {parameter:.0f} from the links of both spans. Both with the mean tension of the run; frequencies are those of
        the largest lines of the difference and of the sum of the motions at a quarter and at three quarters of the span.""",
                table("vibration", [row(*line) for line in one + other]),
                f"""The cable of the theory has fixed ends, but the driven sprocket alone is light and turns with the span: with an inertia
        of 1 kg m2 the symmetric frequency is nearer. The rest is not explained; ten times stiffer teeth and fifty times the damping of
        the chain do not change it. The mean tension of the run, {tension:.1f} N, is above that of the plan,
        {run.drive['spans'][0]['tension']:.1f} N, and grows with speed in the simple model; why is not explained.""")


def sound_topic(runs):
    layered, simple = runs("rs80"), runs("rs80", SIMPLE)
    oiled = {viscosity: runs("rs80", {"Contact/Oil viscosity in mPa s": viscosity}) for viscosity in (30, 100, 300)}
    damped, oval = runs("rs80", {"Contact/Damping ratio": 0.5}), runs("rs80", {"Effects/Oval rollers": "on"})

    def level(run):
        return run.acoustics["observers"][0]["level_a"]

    bands = [(band, value) for band, value in zip(layered.acoustics["third_octaves"], layered.acoustics["observers"][0]["third_octaves"])
             if value is not None]
    low, all_of_them = (10 * math.log10(sum(10 ** (value / 10) for band, value in bands if band < limit)) for limit in (5500, 1e6))
    rows = [[what, f"{expected}", f"{obtained:.1f}", f"{obtained - expected:+.1f} dB",
             "holds" if abs(obtained - expected) <= 3 else "differs"]
            for what, expected, obtained in (("dry, layered (dB(A))", 65, level(layered)), ("dry, simple (dB(A))", 65, level(simple)),
                                             ("dry, layered, contact damping ratio 0.5 (dB(A))", 65, level(damped)),
                                             ("dry, layered, oval rollers (dB(A))", 65, level(oval)),
                                             *((f"oil of {viscosity} mPa s, layered (dB(A))", 57, level(run)) for viscosity, run in oiled.items()))]
    quieter = [level(layered) - level(run) for run in oiled.values()]
    return page("Sound", "rs80", """RS80 (No. 80), 16 teeth, 123 rpm, at 0.3 m: U.S. Tsubaki, The Complete Guide to Chain (1997). The load
        and the number of links are not published; 100 N m and 60 links are assumed, and 16 teeth on both sprockets.""",
                table("case", rows),
                f"""Oil is not specified; chain oils have 30 to 300 mPa s. With oil the drive of the model is {min(quieter):.0f} to {max(quieter):.0f} dB
        quieter, where the measured one is by 8 dB: the film (effect `oil film`) takes the bouncing of rollers between bush and tooth, and what
        remains is {level(oiled[100]) - 57:.0f} dB too loud with 100 mPa s. Without oil rollers and links are rigid and their contacts short: third
        octaves rise up to 20 kHz. Of the unweighted {all_of_them:.0f} dB those up to 5 kHz make {low:.0f} dB, so that most of the excess is in
        bands in which a real roller rings, deforms and is damped; how much of its grease the chain called dry had is not known. A contact damping
        ratio of 0.5 instead of 0.1 takes {level(layered) - level(damped):.0f} dB, rollers that ring add {level(oval) - level(layered):.0f}. Elastic bodies
        alone do not mend it: `./run prm/published/rs80.prm --set "Model/Fidelity=reduced"`, which takes four minutes and is not among the runs of
        this page, gives 86.5 dB(A), with rollers and links that deform, touch without penalty and are not damped. What a level is worth: it orders
        drives and lubrications; what oil does is known within 10 dB; as an absolute value it is 5 to 16 dB too high here.""")


TOPICS = {"ratio": ratio_topic, "teeth": tooth_topic, "resonance": resonance_topic, "tight": tight_topic, "string": string_topic,
          "sag": sag_topic, "losses": losses_topic, "seating": seating_topic, "catalogue": catalogue_topic, "sound": sound_topic}
INTRO = """# Published results

{prose}

    /usr/bin/python3 scripts/published.py > doc/validation/published.md"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("topics", nargs="*", metavar="TOPIC", help=", ".join(TOPICS))
    parser.add_argument("--program", default=program.PROGRAM)
    words = parser.parse_args()
    program.check(set(words.topics) <= set(TOPICS), f"published.py: topics are {', '.join(TOPICS)}")
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(words.program, folder)
        pages = [topic(runs) for name, topic in TOPICS.items() if not words.topics or name in words.topics]
    print(INTRO.format(prose=prose("""What others have published, as formulas or measurements, beside what chaindrive gives. Each table has
        a parameter file; the variations of it, such as other teeth or speeds, and the published formulas are in
        `scripts/published.py`, which writes this page in four minutes. A result *holds* within 5 %, is *near* within 20 %, and
        *differs* beyond. *Recalled* marks what is quoted from memory and was not read again.""")))
    for text in pages:
        print(f"\n{text}")


if __name__ == "__main__":
    main()
