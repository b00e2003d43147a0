# SPDX-License-Identifier: LGPL-2.1-or-later
"""distributions.py DIRECTORY: whether engagements with the driver differ from those of a study's reference, as a table in
Markdown: of each variant, all engagements of all phases together, their number, the probability that peaks and impulses
that are drawn from one distribution differ so much (two-sample test of Kolmogorov and Smirnov), and the largest
difference of the third octaves of the velocities of rollers, in dB. Needs python3-h5py, python3-pandas and
python3-scipy."""
import argparse
import json
import pathlib
import sys

import numpy as np
import scipy.stats

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))  # program.py

import outputs  # noqa: E402


def samples(directory, variant):
    """Peaks [N], impulses [N s] and third octaves of one variant, {band: mean square [m2/s2]}; none without runs."""
    peaks, impulses, bands = [], [], []
    for run in variant["runs"]:
        end = directory / run["folder"] / "result.json"
        if not end.exists() or json.loads(end.read_text())["status"] != 0:
            continue
        one = outputs.Run(directory / run["folder"])
        peaks += [e["peak_force"] for e in one.engaged("driver")]
        impulses += [e["impulse"] for e in one.engaged("driver")]
        power, frequency = one.power(False)
        if power is not None:
            bands.append(outputs.third_octaves(power, frequency))
    mean = {band: float(np.mean([b[band] ** 2 for b in bands])) for band in bands[0]} if bands else {}
    return peaks, impulses, mean


def difference(bands, reference):
    """The largest difference of levels, as "+1.2 dB at 2000 Hz"."""
    levels = {band: 10 * np.log10(bands[band] / reference[band]) for band in bands if band in reference}
    if not levels:
        return "-"
    band = max(levels, key=lambda b: abs(levels[b]))
    return f"{levels[band]:+.1f} dB at {band} Hz"


def table(directory):
    """The lines of the table."""
    study = json.loads((directory / "study.json").read_text())
    found = {variant["name"]: samples(directory, variant) for variant in study["variants"]}
    peaks, impulses, bands = found[study["reference"]]
    lines = ["| variant | engagements | peaks alike, probability | impulses alike, probability | third octaves, largest |",
             "|---|---|---|---|---|"]
    for name, (own_peaks, own_impulses, own_bands) in found.items():
        if not own_peaks or not peaks:
            lines.append(f"| {name} | {len(own_peaks)} | - | - | - |")
            continue
        p = [scipy.stats.ks_2samp(a, b).pvalue for a, b in ((own_peaks, peaks), (own_impulses, impulses))]
        same = name == study["reference"]
        lines.append(f"| {name} | {len(own_peaks)} | " + ("the reference | - | - |" if same else
                     f"{p[0]:.2g} | {p[1]:.2g} | {difference(own_bands, bands)} |"))
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=pathlib.Path)
    print("\n".join(table(parser.parse_args().directory)))


if __name__ == "__main__":
    main()
