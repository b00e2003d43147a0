# SPDX-License-Identifier: LGPL-2.1-or-later
"""waves.py [PROGRAM]: the closed form of the power that a polygon sends into a span as waves (scripts/published_theory.py, for the losses
of doc/validation/published.md) against a row of links whose end follows the polygon, integrated in time, which at its far end absorbs
what arrives: slow, fast with two harmonics below the highest frequency of the row, one, and none. And of two sprockets and two spans it
is the sum."""
import math
import types

import numpy as np

from program import check
from published_theory import power_of_waves, radius

PITCH, MASS, TEETH = 19.05e-3, 1.42, 15


def theory(tight, slack, pitch_time, sprockets=(TEETH,)):
    return power_of_waves(types.SimpleNamespace(drive={"mass_per_metre": MASS, "pitch": PITCH}, pitch_time=pitch_time, sprockets=sprockets,
                                                summary={"tight_tension_mean": tight, "slack_tension_mean": slack}))


def integrated(tension, pitch_time, n=500, settle=12, periods=8):
    """Mean power, W, at the end of a row of `n` links; the far half takes more and more of what passes."""
    tension_over_pitch, mass = tension / PITCH, MASS * PITCH
    cut = math.sqrt(tension / MASS) / math.pi / PITCH
    steps = math.ceil(40 * cut * pitch_time)
    dt = pitch_time / steps
    damping = np.zeros(n)
    damping[n // 2:] = cut * mass * np.linspace(0, 1, n - n // 2) ** 3
    r = radius(TEETH, PITCH)

    def height(step):  # of the end that runs round the polygon
        return r * (math.cos(math.pi / TEETH * (2 * ((step / steps) % 1) - 1)) - math.cos(math.pi / TEETH))

    place, velocity, work = np.zeros(n), np.zeros(n), 0.
    before = height(0)
    for step in range(1, (settle + periods) * steps + 1):
        force = tension_over_pitch * np.diff(np.concatenate([[before], place, [0.]]))
        velocity += dt / mass * (force[1:] - force[:-1] - damping * velocity)
        place += dt * velocity
        now = height(step)
        pull = -0.5 * tension_over_pitch * (place[0] - now + (place[0] - dt * velocity[0] - before))
        work += pull * (now - before) if step > settle * steps else 0.
        before = now
    return work / (periods * pitch_time)


def main():
    for tension, frequency, harmonics in ((3200., 100., 7), (3300., 300., 2), (3300., 500., 1), (200., 300., 0)):
        found, expected = integrated(tension, 1 / frequency), theory(tension, 0., 1 / frequency)
        cut = math.sqrt(tension / MASS) / math.pi / PITCH
        check(math.floor(cut / frequency) == harmonics, f"{tension} N: {cut} Hz")
        check(abs(found - expected) < 0.02 * expected + 0.02, f"{tension} N, {frequency} Hz: {found} W, closed form {expected} W")
    one = theory(3300., 0., 1 / 300)
    check(one > 20 and abs(theory(3300., 3300., 1 / 300, (TEETH, TEETH)) - 4 * one) < 1e-9 * one, "two spans between two sprockets")


if __name__ == "__main__":
    main()
