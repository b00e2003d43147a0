# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's statements about its two models, as numbers with the range in which they agree with it.
One run does not determine the scatter between rollers: use several start phases."""
import numpy as np

import chaindrive
from chaindrive import comparison

TENSION = 150. / 0.1062156  # N: torque over the pitch radius of 42 teeth
JUMP = 1.9167  # m/s: pitch times driver speed


class Table:
    """Numbers of one or more pairs of runs, with what is accepted."""

    def __init__(self):
        self.rows = {}

    def add(self, name, value, low=None, high=None, digits=3):
        self.rows.setdefault(name, (low, high, digits, []))[3].append(value)

    def print(self):
        """Of several runs the mean, which is judged, and the range."""
        print(f"{'':<70}{'value':>9}  {'accepted':<16}{'met':<5}range")
        for name, (low, high, digits, values) in self.rows.items():
            values = [value for value in values if np.isfinite(value)]
            if not values:
                print(f"{name:<70}{'-':>9}")
                continue
            mean, accepted, verdict, spread = np.mean(values), "", "", ""
            if low is not None or high is not None:
                accepted = " ... ".join("" if x is None else f"{x:.4g}" for x in (low, high))
                verdict = "yes" if (low is None or mean >= low) and \
                    (high is None or mean <= high) else "no"
            if len(values) > 1:
                spread = f"{min(values):.{digits}f} ... {max(values):.{digits}f}"
            print(f"{name:<70}{mean:>9.{digits}f}  {accepted:<16}{verdict:<5}{spread}".rstrip())


def steady(table, run, name):
    """R9: tensions pitch time by pitch time from 8 ms on, and the driven speed."""
    difference = run["spans/tight_tension"] - run["spans/slack_tension"]
    start, means = 8e-3, []
    while start + run.pitch_time <= run.time[-1]:
        means.append(run.mean(difference, start, start + run.pitch_time))
        start += run.pitch_time
    for what, value in (("least", min(means)), ("largest", max(means))):
        table.add(f"R9  {name}: {what} tight less slack tension in a pitch time (N)", value,
                  0.9 * TENSION, 1.1 * TENSION, 0)
    table.add(f"R9  {name}: driven speed (rad/s)", run.summary["driven_speed_mean"], 42.69, 43.55)


def cpu(table, simple, full):
    """R10: shares of CPU time and their ratio."""
    for run, name in ((simple, "simple"), (full, "full")):
        seconds = run.summary["cpu_seconds"]
        for phase in ("internal_force", "time_integration", "contact_algorithm"):
            table.add(f"R10 {name}: {phase.replace('_', ' ')} (% of CPU time)",
                      100 * seconds.get(phase, 0.) / seconds["total"], digits=1)
    table.add("R10 CPU time full over simple", full.summary["cpu_seconds"]["total"] /
              simple.summary["cpu_seconds"]["total"], 20, 500, 0)


def spread(run, surface):
    """Largest difference between two of the rollers and least correlation, along the span and
    normal to it. Rollers are laid over each other by whole pitch times, from one pitch time before
    the first touch to one after it or the end of the run. Differences are r.m.s. over the r.m.s.
    velocity."""
    rollers = run.arrivals()
    first = rollers[0][1]
    end = min(run.pitch_time, run.time[-1] - first - (len(rollers) - 1) * run.pitch_time)
    result = []
    for direction in (0, 1):
        curves = [run.aligned(run.velocity(roller, surface)[direction], first - run.pitch_time,
                              first + end, i * run.pitch_time)
                  for i, (roller, _, _) in enumerate(rollers)]
        scale = np.sqrt(np.mean(np.square(curves)))
        pairs = [(a, b) for i, a in enumerate(curves) for b in curves[:i]]
        result.append((max(np.sqrt(np.mean((a - b) ** 2)) / scale for a, b in pairs),
                       min(np.corrcoef(a, b)[0, 1] for a, b in pairs)))
    return result


def fast_energy(run, surface, above=2000.):
    """Mean square of the velocity above a frequency [Hz], mean of both directions and all rollers,
    within a pitch time of the touch. m2/s2"""
    total = []
    for roller, touch, _ in run.arrivals():
        end = min(touch + run.pitch_time, run.time[-1])
        for curve in run.velocity(roller, surface):
            values = run.aligned(curve, touch - run.pitch_time, end, 0., 4096)
            line = np.linspace(values[0], values[-1], len(values))  # a period without a jump
            spectrum = np.fft.rfft(values - line)
            frequency = np.fft.rfftfreq(len(values), (end - touch + run.pitch_time) / len(values))
            total.append(2 * np.sum(np.abs(spectrum[frequency > above]) ** 2) / len(values) ** 2)
    return np.mean(total)


def seating(table, run, name):
    """R12: the velocity that a roller takes on, from straight lines through 0.02 to 0.5 ms before
    the touch and 1 to 2 ms after it, when it has come to rest in its seat, both continued to the
    touch."""
    jumps, speeds, ripples = [], [], []
    for roller, touch, _ in run.arrivals():
        along, normal = run.velocity(roller, surface=False)
        before = run.between(touch - 0.5e-3, touch - 0.02e-3)
        after = run.between(touch + 1e-3, touch + 2e-3)
        values = [np.polyval(np.polyfit(run.time[w] - touch, normal[w], 1), 0.)
                  for w in (before, after)]
        jumps.append(values[1] - values[0])
        spectrum = np.fft.rfft(run.aligned(along, -run.pitch_time, 0., touch, 1024)[:-1])
        speeds.append(spectrum[0].real / 1023)
        spectrum[4:] = 0.
        pitch = np.fft.irfft(spectrum, 1023)
        ripples.append((np.max(pitch) - np.min(pitch)) / np.max(pitch) * 100)
    for what, jump in (("least", min(jumps)), ("largest", max(jumps))):
        table.add(f"R12 {name}: {what} jump of the normal velocity (m/s)",
                  jump, 0.8 * JUMP, 1.2 * JUMP)
    table.add(f"R12 {name}: velocity along the span before the touch (m/s)",
              np.mean(speeds), 4.534, 4.626)
    table.add(f"R12 {name}: its ripple in three harmonics of the pitch (%)",
              np.mean(ripples), 1.2, 3.2)


def tensions(table, run, name):
    """R14: the bar behind each roller, a pitch time before and after the touch. The decay that goes
    with a pressure angle is judged in the slow run, where the angle is measured."""
    before, ratio = [], []
    for roller, touch, _ in run.arrivals():
        tension = run.column("links/tension", run.link_behind(roller))
        before.append(run.mean(tension, touch - run.pitch_time, touch))
        if touch + 2 * run.pitch_time <= run.time[-1]:
            ratio.append(run.mean(tension, touch + run.pitch_time, touch + 2 * run.pitch_time) /
                         before[-1])
    slack = run.summary["slack_tension_mean"]
    for what, value in (("least", min(before)), ("largest", max(before))):
        table.add(f"R14 {name}: {what} tension before engagement less slack (N)", value - slack,
                  0.7 * 1413, 1.3 * 1413, 0)
    table.add(f"R14 {name}: tension after one tooth over that before",
              np.mean(ratio) if ratio else np.nan)


def plates(table, run):
    """R15: pull and bending of the plates behind the engaging rollers. Nominal stresses: 1413 N
    over both waists of a link, 0.7 times the plates' heights wide and 2 mm thick."""
    if "plates/axial_stress" not in run:
        return
    rollers = run.arrivals()
    slack = run.summary["slack_tension_mean"] / run.summary["tight_tension_mean"]
    for parity, name, nominal in ((0, "inner", 33.442), (1, "outer", 38.759)):
        axial, plane, out, peak = [], [], [], []
        for roller, touch, _ in rollers:
            link = run.link_behind(roller)
            if link % 2 != parity:
                continue
            window = run.between(touch - run.pitch_time, touch + run.pitch_time)
            in_plane = run.column("plates/bending_in_plane", link)[window] * 1e-6
            across = run.column("plates/bending_out_of_plane", link)[window] * 1e-6
            axial.append(run.mean(run.column("plates/axial_stress", link),
                                  touch - run.pitch_time, touch) * 1e-6)
            plane.append(np.sqrt(np.mean(in_plane ** 2)))
            out.append(np.sqrt(np.mean(across ** 2)))
            peak.append(np.max(np.abs(in_plane)))
        if axial:
            table.add(f"R15 {name} plates: axial stress before engagement, no slack (MPa)",
                      np.mean(axial) * (1 - slack), 0.8 * nominal, 1.2 * nominal, 1)
            table.add(f"R15 {name} plates: bending in the plane, r.m.s. over axial",
                      np.mean(plane) / np.mean(axial), 0.05)
            table.add(f"R15 {name} plates: bending in the plane, largest over axial",
                      np.max(peak) / np.mean(axial))
            table.add(f"R15 {name} plates: bending out of the plane, r.m.s. over axial",
                      np.mean(out) / np.mean(axial))


def print_plates(runs):
    """Fig. 9: the plates behind the engaging rollers of each run in the pitch time before, in MPa, and
    the means of inner and outer ones over the nominal stress."""
    columns = ["nominal", "axial", "in_plane", "out_of_plane", "principal_1", "principal_2"]
    print(f"{'':24}{'link':>6}{'':7}" + "".join(f"{name:>14}" for name in columns) + "   MPa")
    for name, run in zip(comparison.names(runs), runs):
        frame = chaindrive.plate_stresses(run)
        for link, row in frame.iterrows():
            values = "".join(f"{1e-6 * row[column]:14.1f}" for column in columns)
            print(f"{name:24}{link:6} {row['kind']:6}{values}")
        for kind, rows in frame.groupby("kind"):
            means = rows[columns].mean()
            values = "".join(f"{means[column] / means['nominal']:14.3f}" for column in columns)
            print(f"{name:24}{'mean':>6} {kind:6}{values}   of nominal")


def peaks(table, simple, full):
    """R16, R17: largest contact forces of the engaging rollers."""
    variation = {}
    for run, name in ((simple, "simple"), (full, "full")):
        force = np.array([peak for _, _, peak in run.arrivals()]) * 1e-3
        relative = (force.max() - force.min()) / force.max()
        variation[name] = force.std(ddof=1) / force.mean()
        if name == "full":
            table.add("R16 full: largest peak force (kN)", force.max(), 1.2, 2.8)
            table.add("R16 full: smallest peak force (kN)", force.min(), 0.7, 1.6)
            table.add("R16 full: (largest - smallest) / largest", relative, 0.2, 0.6)
        else:
            table.add("R17 simple: (largest - smallest) / largest", relative, None, 0.1)
            table.add("R17 simple: coefficient of variation", variation[name], None, 0.05)
    table.add("R17 coefficient of variation full over simple",
              variation["full"] / variation["simple"], 3)


def pulses(table, run, name, low, high):
    """R18: maxima of the contact force within 0.15 ms of the touch that stand out by a fifth of the
    largest; mean of the rollers. Left out where samples are more than 5 us apart."""
    if np.median(np.diff(run.time)) > 5.1e-6:
        return
    counts = []
    for roller, touch, _ in run.arrivals():
        force = run.column("rollers/driver_force_peak", roller)
        force = force[run.between(touch - 5e-6, touch + 0.15e-3)]
        count, low_since, high_since = 0, 0., 0.
        for f in np.append(force, 0.):  # up by a fifth and down again by a fifth: one pulse
            high_since = max(high_since, f)
            if high_since - f > 0.2 * force.max() and high_since - low_since > 0.2 * force.max():
                count, low_since, high_since = count + 1, f, f
            if f < low_since:
                low_since = high_since = f
        counts.append(count)
    table.add(f"R18 {name}: pulses within 0.15 ms of the touch", np.mean(counts), low, high, 1)


def add_pair(table, simple, full):
    for run, name in ((simple, "simple"), (full, "full")):
        steady(table, run, name)
    cpu(table, simple, full)
    smooth, rough = spread(simple, False), spread(full, True)
    for direction, s, f in zip(("along the span", "normal to it"), smooth, rough):
        table.add(f"R11 simple: rollers differ {direction} (r.m.s. over r.m.s.)", s[0], None, 0.05)
        table.add(f"R11 simple: least correlation {direction}", s[1], 0.99)
        table.add(f"R13 full: rollers differ {direction}, surface, over simple", f[0] / s[0], 3)
    for surface, name in ((True, "surface"), (False, "centre of mass")):
        table.add(f"R13 energy of velocity above 2 kHz, {name}, full over simple",
                  fast_energy(full, surface) / fast_energy(simple, surface), 3, None, 1)
    for run, name in ((simple, "simple"), (full, "full")):
        seating(table, run, name)
    for run, name in ((simple, "simple"), (full, "full")):
        tensions(table, run, name)
    plates(table, full)
    peaks(table, simple, full)
    pulses(table, simple, "simple", 1, 1)
    pulses(table, full, "full", 2, None)


def report(pairs):
    """Prints what (simple, full) runs give."""
    table = Table()
    for simple, full in pairs:
        add_pair(table, simple, full)
    table.print()
