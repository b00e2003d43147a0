# SPDX-License-Identifier: LGPL-2.1-or-later
"""distributions.py DIRECTORY: whether engagements with the driver differ from those of a study's reference, as tables in
Markdown: for each variant, the number of engagements of all phases, and the probability that peaks and impulses from one
distribution differ as much (two-sample Kolmogorov-Smirnov test), the mean peak, and the mean of the largest running means of
the force over 40 and 60 us, in a pitch time from the touch, where histories have a row each 20 us or less; and the difference
in dB of the third octaves of roller velocities from the reference, with 95 % confidence intervals over the phases of both.
Needs python3-h5py, python3-pandas and python3-scipy."""
import argparse
import json
import pathlib

import numpy as np
import scipy.stats

import outputs
import stats


MEANS = (40e-6, 60e-6)  # s, over which forces are averaged


def slower_peaks(run):
    """Of each engagement with the driver the largest means of the force [N] over MEANS; none where rows are too far apart."""
    interval = np.median(np.diff(run.time))
    if "rollers/driver_force" not in run or interval > 1.05 * MEANS[0] / 2:
        return []
    force, found = run["rollers/driver_force"], []
    for e in run.engaged("driver"):
        first = np.searchsorted(run.time, e["time"])
        of_one = force[first:first + int(run.pitch_time / interval), run.labels("rollers/driver_force").index(e["roller"])]
        lengths = [round(length / interval) for length in MEANS]
        if len(of_one) >= lengths[-1]:
            found.append([np.convolve(of_one, np.full(n, 1. / n), "valid").max() for n in lengths])
    return found


def samples(directory, variant):
    """Peaks [N], impulses [N s], slower peaks and, of each phase, third octaves {band: mean square [m2/s2]} of one variant;
    none without runs, or where the window of one is not valid."""
    peaks, impulses, slower, bands = [], [], [], {}
    for run in variant["runs"]:
        if outputs.end_of_run(directory / run["folder"])["status"] != 0:
            continue
        one = outputs.Run(directory / run["folder"])
        if one.window_is_valid is False:
            return [], [], [], {}
        peaks += [e["peak_force"] for e in one.engaged("driver")]
        impulses += [e["impulse"] for e in one.engaged("driver")]
        slower += slower_peaks(one)
        power, frequency = one.power(False)
        if power is not None:
            bands[run["phase"]] = {band: rms ** 2 for band, rms in outputs.third_octaves(power, frequency).items()}
    return peaks, impulses, slower, bands


def levels_above(bands, reference, study):
    """{band: (difference of levels in dB, its interval)}, of the phases that both have."""
    phases = [phase for phase in bands if phase in reference]
    found = {}
    for band in bands[phases[0]] if phases else ():
        ratio = stats.error_interval([bands[p][band] for p in phases], [reference[p][band] for p in phases])
        found[band] = 10. * np.log10(1. + np.array(ratio) / 100.)
    return found


def tables(directory):
    """The lines of both tables."""
    study = json.loads((directory / "study.json").read_text())
    found = {variant["name"]: samples(directory, variant) for variant in study["variants"]}
    peaks, impulses, _, bands = found[study["reference"]]
    engagements = ["| variant | engagements | peaks alike, probability | impulses alike, probability | peaks (N) | "
                   + " | ".join(f"of means over {1e6 * length:.0f} us (N)" for length in MEANS) + " |", "|---" * 7 + "|"]
    levels = {}
    for name, (own_peaks, own_impulses, own_slower, own_bands) in found.items():
        verdict = "- | -"
        if name == study["reference"]:
            verdict = "the reference | -"
        elif own_peaks and peaks:
            verdict = " | ".join(f"{scipy.stats.ks_2samp(a, b).pvalue:.2g}"
                                 for a, b in ((own_peaks, peaks), (own_impulses, impulses)))
            levels[name] = levels_above(own_bands, bands, study)
        means = [np.mean(own_peaks)] if own_peaks else []
        means += list(np.mean(own_slower, axis=0)) if own_slower else []
        means = [f"{mean:.4g}" for mean in means] + ["-"] * (3 - len(means))
        engagements.append(f"| {name} | {len(own_peaks)} | {verdict} | {' | '.join(means)} |")
    octaves = [f"| third octave (Hz) | {' | '.join(levels)} |", "|---" * (len(levels) + 1) + "|"]
    octaves += [f"| {band} | " + " | ".join("{:+.1f} dB ({:+.1f} ... {:+.1f})".format(*own[band]) if band in own else "-"
                                            for own in levels.values()) + " |" for band in outputs.NOMINAL]
    return engagements + ["", *octaves]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=pathlib.Path)
    print("\n".join(tables(parser.parse_args().directory)))


if __name__ == "__main__":
    main()
