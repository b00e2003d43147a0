# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed forms of published theories of chain drives, for published.py: their sources stand in the page that it writes."""
import math

import numpy as np


def radius(z, pitch=1.0):
    """Of the pitch circle."""
    return pitch / 2 / math.sin(math.pi / z)


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def polygon(centre, z, angle):
    """The corners of one of a side of 1, the first at `angle`."""
    at = angle + 2 * math.pi / z * np.arange(z)
    return np.column_stack([centre + radius(z) * np.cos(at), radius(z) * np.sin(at)])


def tangent(driver, driven, side):
    """Corners of both polygons where their common tangent touches them, the upper one with side = 1."""
    for i in np.argsort(-side * driver[:, 1])[:len(driver) // 2]:
        for j in np.argsort(-side * driven[:, 1])[:len(driven) // 2]:
            span = side * (driver[i] - driven[j])
            if all(cross(span, corners - corner).min() >= -1e-9
                   for corners, corner in ((driver.T, driver[i][:, None]), (driven.T, driven[j][:, None]))):
                return i, j
    raise ValueError("no tangent")


def four_bar(span, teeth, phases=180):
    """Speed ratio, driven over driver, over a tooth of the driver: the upper span, of `span` pitches between the points where it is
    tangent to both pitch circles, is a whole number of rigid links on corners of both polygons."""
    z1, z2 = teeth
    centre = math.hypot(span, radius(z1) - radius(z2))
    normal = math.pi / 2 - math.asin((radius(z1) - radius(z2)) / centre)
    ratios = []
    for phase in np.arange(phases) / phases:
        corners = [normal + (k + phase) * 2 * math.pi / z1 for k in (-2, -1, 0, 1, 2)]
        ratios.append(next(filter(None, (rigid_span(centre, teeth, corner, links) for corner in corners
                                         for links in range(int(span) - 2, int(span) + 4)))))
    return np.array(ratios)


def rigid_span(centre, teeth, angle, links):
    """Speed ratio of a span of `links` pitches that meets the driver's corner at `angle`; None where chain or polygon would bend."""
    z1, z2 = teeth
    start = radius(z1) * np.array([math.cos(angle), math.sin(angle)])
    to = np.array([centre, 0]) - start
    distance = np.hypot(*to)
    if abs(distance - links) > radius(z2):
        return None
    along = (distance ** 2 + links ** 2 - radius(z2) ** 2) / 2 / distance
    across = math.sqrt(max(0, links ** 2 - along ** 2))
    end = start + (along * to + across * np.array([-to[1], to[0]])) / distance
    other = math.atan2(end[1], end[0] - centre)
    span = (start - end) / links
    for z, middle, at, corner in ((z1, 0, angle, start), (z2, centre, other, end)):
        for turn in (-2 * math.pi / z, 2 * math.pi / z):
            next_one = np.array([middle + radius(z) * math.cos(at + turn), radius(z) * math.sin(at + turn)])
            if cross(span, next_one - corner) < -1e-9:
                return None
    return cross(start, span) / cross(end - np.array([centre, 0]), span)


def harmonic_of_period(values, order=1):
    """Amplitude of a harmonic of values that are evenly spaced over a period."""
    return 2 * abs(np.mean(values * np.exp(-2j * np.pi * order * np.arange(len(values)) / len(values))))


def path_stretch(centre, z, links, phases=24):
    """By how many pitches the path round two equal polygons is longer than the chain, over a tooth, when both spans stretch alike."""
    found = []
    for phase in np.arange(phases) / phases:
        driver = polygon(0, z, phase * 2 * math.pi / z)

        def stretches(angle, driver=driver):
            driven = polygon(centre, z, angle)
            (i, j), (k, m) = tangent(driver, driven, 1), tangent(driver, driven, -1)
            upper, lower = np.hypot(*(driver[i] - driven[j])), np.hypot(*(driver[k] - driven[m]))
            free = links - (k - i) % z - (j - m) % z  # links in both spans
            n = round(upper - (upper + lower - free) / 2)
            return upper - n, lower - (free - n)

        def difference(angle):
            upper, lower = stretches(angle)
            return upper - lower

        turn = 2 * math.pi / z / 96
        values = [difference(i * turn) for i in range(97)]
        low = next(i for i in range(96) if values[i] * values[i + 1] <= 0 and abs(values[i] - values[i + 1]) < 0.5)
        a, b = low * turn, (low + 1) * turn
        for _ in range(40):
            middle = (a + b) / 2
            a, b = (a, middle) if difference(a) * difference(middle) <= 0 else (middle, b)
        found.append(sum(stretches(a)))
    return np.array(found)


def pressure_angle(z):
    """The largest of ANSI B29.1, rad."""
    return math.radians(35 - 120 / z)


def tooth_ratio(z):
    """Tension behind a roller over that before it."""
    return math.sin(pressure_angle(z)) / math.sin(pressure_angle(z) + 2 * math.pi / z)


def articulation_losses(run, mu, pin, bush):
    """Power, W, between pins and bushes and between bushes and rollers of the diameters `pin` and `bush`, m: every joint turns by
    360 / z degrees as it meets and as it leaves a sprocket. Where the outer link turns, the pin bears the tension of the span. Where
    the inner link turns, it bears the tension behind the roller, and the bush turns in the roller, with the force of the tooth."""
    spans = {span["label"]: span["tension"] - run.drive["centrifugal_tension"] for span in run.drive["spans"]}
    return articulation_under(spans["tight"], spans["slack"], run, mu, pin, bush)


def articulation_under(tight, slack, run, mu, pin, bush):
    """articulation_losses() under these tensions, without centrifugal ones, N."""
    pins = rollers = 0
    for z in run.sprockets:
        turn = 2 * math.pi / z
        angle = np.linspace(0, turn, 201)
        behind = np.mean(np.sin(pressure_angle(z)) / np.sin(pressure_angle(z) + angle))
        tooth = np.mean(np.sin(angle) / np.sin(pressure_angle(z) + angle))
        pins += mu * pin / 2 * turn * (tight * (1 + behind) / 2 + slack)
        rollers += mu * bush / 2 * turn * tight * tooth / 2
    return pins / run.pitch_time, rollers / run.pitch_time


def articulation_of(run, mu, pin, bush):
    """articulation_losses(), W, with the mean tensions of the run in place of the plan's."""
    tight, slack = (run.summary[f"{label}_tension_mean"] - run.drive["centrifugal_tension"] for label in ("tight", "slack"))
    return articulation_under(tight, slack, run, mu, pin, bush)


def power_of_waves(run):
    """Power, W, that the polygons send into the spans as transverse waves. Each end of a span follows an arc of 360 / z degrees again
    and again, across the span a parabola of the height h = r (1 - cos(180 / z)), whose harmonic n has the amplitude 4 h / (pi n)^2 at
    n times the tooth frequency. With tension T and mass per metre m a string takes sqrt(T m) (w A)^2 / 2 of each, a row of links
    of the pitch p sqrt(1 - (f / f_c)^2) times as much up to the frequency f_c = sqrt(T / m) / (pi p), and nothing above. Waves that
    come back are not counted."""
    mass, pitch, power = run.drive["mass_per_metre"], run.drive["pitch"], 0
    for label in ("tight", "slack"):
        tension = run.summary[f"{label}_tension_mean"]
        cut = math.sqrt(tension / mass) / math.pi / pitch
        for z in run.sprockets:
            height = radius(z, pitch) * (1 - math.cos(math.pi / z))
            for order in range(1, math.ceil(cut * run.pitch_time)):
                frequency = order / run.pitch_time
                speed = 2 * math.pi * frequency * 4 * height / (math.pi * order) ** 2
                power += 0.5 * math.sqrt(tension * mass) * speed ** 2 * math.sqrt(1 - (frequency / cut) ** 2)
    return power
