#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How loud ring vibration of elastic rollers is relative to their rigid-body oscillation:

    scripts/ring_sound.py DIR

DIR is that of a run of the full model with surface velocities. For rollers that meet the driver in the window, by octaves: the acceleration
of a point of the surface along the span normal, less that of the centre, over that of the centre (deviation over deviation); how
much less a long cylinder radiates that ovalises than one that moves as a whole with the same velocity, at 0.4 m (Hankel functions of
orders 2 and 1); and both together, in dB. An upper bound: it counts all motion of the point as ovalisation, including roller rotation.
Debian packages: python3-h5py, python3-pandas, python3-scipy.
"""
import sys

import numpy as np
from scipy.special import h1vp, hankel1

import chaindrive

OCTAVES = (1e3, 2e3, 4e3, 8e3, 16e3)
SPEED_OF_SOUND, DISTANCE = 343.2, 0.4


def radiation(frequency, radius):
    """Pressure of an ovalising cylinder over that of an oscillating one, both with the same velocity at the loudest place, dB."""
    k = 2 * np.pi * frequency / SPEED_OF_SOUND
    order = [abs(hankel1(m, k * DISTANCE) / h1vp(m, k * radius)) for m in (1, 2)]
    return 20 * np.log10(order[1] / order[0])


def accelerations(run):
    """Power over frequency in Hz of the centre, and of the point less the centre; means over the rollers that meet the driver."""
    met = {e["roller"] for e in run.summary["engagements"] if e["sprocket"] == "driver" and run.start <= e["time"] <= run.end}
    point = run.values("rollers/surface_velocity_normal", run.start, run.end)
    labels, all_labels = run.labels("rollers/surface_velocity_normal"), run.labels("rollers/velocity_x")
    centre = sum(run.outward[d] * run.values(f"rollers/velocity_{'xy'[d]}", run.start, run.end) for d in (0, 1))
    frequency = np.fft.rfftfreq(len(point), (run.end - run.start) / len(point))

    def power(velocity):
        return np.abs(frequency * np.fft.rfft((velocity - velocity.mean()) * np.hanning(len(velocity)))) ** 2

    pairs = [(centre[:, all_labels.index(label)], point[:, labels.index(label)]) for label in met if label in labels]
    return frequency, sum(power(c) for c, _ in pairs), sum(power(p - c) for c, p in pairs)


def main(folder):
    with chaindrive.open(folder) as run:
        frequency, centre, ring = accelerations(run)
        radius = 5e-4 * run.parameter("Drive/Chain/Roller diameter in mm")
    print("| octave, kHz | point less centre over centre, dB | radiation, dB | both, dB |\n|---|---|---|---|")
    for middle in OCTAVES:
        inside = (frequency > middle / np.sqrt(2)) & (frequency < middle * np.sqrt(2))
        ratio, radiates = 10 * np.log10(ring[inside].sum() / centre[inside].sum()), radiation(middle, radius)
        print(f"| {middle / 1e3:g} | {ratio:.0f} | {radiates:.0f} | {ratio + radiates:.0f} |")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        main(sys.argv[1])
    except chaindrive.RunError as error:
        print(f"ring_sound.py: {error}", file=sys.stderr)
        sys.exit(2)
