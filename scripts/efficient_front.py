#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots the errors in source/accuracy.tsv against CPU time for several studies, with a panel for each output.
The time is that of a variant over that of its reference, since studies may have run on different machines.

    scripts/efficient_front.py PICTURE [STUDY]... [--outputs NAME,...]

The studies must share one reference and one chain; by default they are fidelity and reduced. Prints the efficient
variants of each output: no other is both cheaper and more accurate. Debian package: python3-matplotlib.
"""
import argparse
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from study import stats

HERE = pathlib.Path(__file__).resolve().parent
OUTPUTS = "tight_tension_mean,driver_peak_mean,driver_impulse_mean,roller_velocity_rms,plate_stress_max,losses"


def read(studies):
    """{output: {variant: (CPU time over that of the reference, error, low, high in percent)}} of all but the references."""
    found = {}
    for line in (HERE.parent / "source/accuracy.tsv").read_text(encoding="utf-8").splitlines():
        columns = line.split("\t")
        if columns[0] not in studies:
            continue
        _, variant, reference, output, error, low, high, cpu, of_reference = columns[:9]
        if variant != reference:
            found.setdefault(output, {})[variant] = (float(cpu) / float(of_reference), float(error), float(low), float(high))
    return found


def draw(axis, output, variants):
    """One output; returns the names of the efficient variants, cheapest first."""
    efficient = stats.efficient([(cpu, abs(error)) for cpu, error, _, _ in variants.values()])
    front = sorted((values[0], max(abs(values[1]), 0.01), name)
                   for (name, values), is_efficient in zip(variants.items(), efficient) if is_efficient)
    axis.plot([cpu for cpu, _, _ in front], [error for _, error, _ in front], color="C3", linewidth=1)
    beside = 0.0  # the last label of those at the right, which would cover each other
    for name, (cpu, error, low, high) in sorted(variants.items(), key=lambda item: abs(item[1][1])):
        shown, at_right = max(abs(error), 0.01), cpu > 0.5
        if at_right:
            beside = max(shown, 1.6 * beside)
        axis.annotate(name, (cpu, beside if at_right else shown), xytext=(-5 if at_right else 4, 3), ha="right" if at_right else "left",
                      textcoords="offset points", fontsize=7)
        # The interval of a magnitude: it begins at zero when that lies within.
        ends = (0.01 if low * high <= 0 else min(abs(low), abs(high))), max(abs(low), abs(high), 0.01)
        colour = "C3" if any(name == other for _, _, other in front) else "0.4"
        axis.plot([cpu, cpu], ends, color=colour, linewidth=1, alpha=0.5)
        axis.plot(cpu, shown, "o", color=colour, markersize=5)
    axis.set(xscale="log", yscale="log", ylim=(0.008, 200), xlim=(0.0015, 5), title=output.replace("_", " "))
    axis.grid(alpha=0.3)
    return [name for _, _, name in front]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture")
    parser.add_argument("studies", nargs="*", default=["fidelity", "reduced"])
    parser.add_argument("--outputs", default=OUTPUTS)
    options = parser.parse_args()
    found = read(options.studies)
    outputs = options.outputs.split(",")
    unknown = [name for name in outputs if name not in found]
    if unknown:
        parser.error(f"no study of {', '.join(options.studies)} judges {', '.join(unknown)}; there are: {', '.join(found)}")
    figure, axes = plt.subplots((len(outputs) + 2) // 3, min(3, len(outputs)), figsize=(11, 3.4 * ((len(outputs) + 2) // 3)),
                                squeeze=False, sharex=True, sharey=True)
    for axis, output in zip(axes.flat, outputs):
        print(f"{output}: {', '.join(draw(axis, output, found[output]))}")
    for axis in axes[-1]:
        axis.set_xlabel("CPU time over that of the reference")
    for axis in axes[:, 0]:
        axis.set_ylabel("error (%)")
    figure.tight_layout()
    figure.savefig(options.picture, dpi=100)


if __name__ == "__main__":
    main()
