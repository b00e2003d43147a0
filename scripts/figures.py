#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the figures of the paper, simple and full model side by side, and prints its statements
about them as numbers:

    scripts/figures.py [--simple DIR...] [--full DIR...] [--output DIR]
    scripts/figures.py --plates DIR...

The first runs are drawn; the numbers are means over all of them, for example over start phases.
With --plates it prints only the stresses of Fig. 9 of these runs, side by side.
velocities.png: its Fig. 5 and 7, link_forces.png: 8 and 9, contact_forces.png: 13 and 12. Debian
packages: python3-h5py, python3-matplotlib, python3-pandas, python3-pil.
"""
import argparse
import os
import sys

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot
import numpy as np
from PIL import Image

import criteria
import program
import chaindrive

COLORS = ["#1b4f8f", "#c7522a", "#3c8d5a", "#8a5aa8", "#b8962e"]
pyplot.rcParams.update({"font.size": 8, "legend.fontsize": 7, "lines.linewidth": 0.7,
                        "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False,
                        "axes.spines.right": False, "figure.dpi": 110})


def panels(rows, titles, height):
    figure, axes = pyplot.subplots(rows, 2, figsize=(9., height), sharex=True, sharey="row",
                                   squeeze=False, constrained_layout=True)
    for axis, title in zip(axes[0], titles):
        axis.set_title(title)
    for axis in axes[-1]:
        axis.set_xlabel("time (ms)")
    return figure, axes


def finish(figure, axes, run, folder, name):
    axes[0][0].set_xlim(1e3 * run.start, 1e3 * run.time[-1])
    figure.get_layout_engine().set(rect=(0., 0., 1., 1. - 0.25 / figure.get_figheight()))
    figure.legend(*axes[0][0].get_legend_handles_labels(), loc="upper center", ncol=5,
                  frameon=False)
    figure.canvas.draw()
    picture = Image.fromarray(np.asarray(figure.canvas.buffer_rgba())).convert("RGB")
    picture.quantize(64).save(os.path.join(folder, name), optimize=True)
    pyplot.close(figure)


def curve(axis, run, values, number, label=None, **style):
    window = run.between(run.start, run.time[-1])
    axis.plot(1e3 * run.time[window], values[window], color=COLORS[number], label=label, **style)


def velocities(simple, full, folder):
    surface = "rollers/surface_velocity_normal" in full
    figure, axes = panels(2, ("simple model, centre of the roller", "full model, " +
                              ("surface of the roller" if surface else "centre of the roller")), 5.)
    for column, run in enumerate((simple, full)):
        for i, (roller, _, _) in enumerate(run.arrivals()):
            for row, values in enumerate(run.velocity(roller)):
                curve(axes[row][column], run, values, i, f"roller #{i + 1}")
    axes[0][0].set_ylabel("along the span (m/s)")
    axes[1][0].set_ylabel("normal to the span (m/s)")
    finish(figure, axes, full, folder, "velocities.png")


def link_forces(simple, full, folder):
    figure, axes = pyplot.subplots(2, 2, figsize=(9., 5.), sharex=True, constrained_layout=True)
    for i, (roller, _, _) in enumerate(simple.arrivals()):
        tension = simple.column("links/tension", simple.link_behind(roller))
        curve(axes[0][0], simple, 1e-3 * tension, i, f"behind roller #{i + 1}")
    for i, (roller, _, _) in enumerate(full.arrivals()):
        link = full.link_behind(roller)
        curve(axes[1][0], full, 1e-3 * full.column("links/tension", link), i)
        if "plates/axial_stress" in full:
            axial = 1e-6 * full.column("plates/axial_stress", link)
            bending = 1e-6 * full.column("plates/bending_in_plane", link)
            curve(axes[0][1], full, axial, i)
            curve(axes[1][1], full, bending, i)
    for axis, title, unit in (
            (axes[0][0], "simple model, bars", "force (kN)"),
            (axes[1][0], "full model, links", "force (kN)"),
            (axes[0][1], "full model, plates: pull", "stress (MPa)"),
            (axes[1][1], "full model, plates: bending in the plane", "stress (MPa)")):
        axis.set_title(title)
        axis.set_ylabel(unit)
    for axis in axes[1]:
        axis.set_xlabel("time (ms)")
    finish(figure, axes, full, folder, "link_forces.png")


def contact_forces(simple, full, folder):
    figure, axes = panels(1, ("simple model", "full model"), 3.)
    for column, run in enumerate((simple, full)):
        for i, (roller, _, _) in enumerate(run.arrivals()):
            force = 1e-3 * run.column("rollers/driver_force_peak", roller)
            curve(axes[0][column], run, np.where(force > 0., force, np.nan), i, f"roller #{i + 1}")
    axes[0][0].set_ylabel("contact force (kN)")
    axes[0][0].set_ylim(bottom=0.)
    finish(figure, axes, full, folder, "contact_forces.png")


def open_run(folder):
    """The run in `folder`, with rollers that arrive in its window."""
    run = chaindrive.open(folder)
    if len(run.arrivals()) < 2:
        raise chaindrive.RunError(f"In the run in '{folder}' fewer than two rollers meet the driver after Output/Window start in ms and 1 ms "
                                  "before the end: the figures need more. Choose a later Time/End time in ms.")
    return run


def main():
    root = program.REPOSITORY
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--simple", nargs="+", default=[os.path.join(root, "results/simple")])
    parser.add_argument("--full", nargs="+", default=[os.path.join(root, "results/full")])
    parser.add_argument("--output", default=os.path.join(root, "doc/pictures"))
    parser.add_argument("--plates", nargs="+", metavar="DIR", help="print the plate stresses of these runs")
    arguments = parser.parse_args()
    if arguments.plates:
        criteria.print_plates([open_run(folder) for folder in arguments.plates])
        return
    simple = [open_run(folder) for folder in arguments.simple]
    full = [open_run(folder) for folder in arguments.full]
    os.makedirs(arguments.output, exist_ok=True)
    for draw in (velocities, link_forces, contact_forces):
        draw(simple[0], full[0], arguments.output)
    pairs = max(len(simple), len(full))
    criteria.report([(simple[i % len(simple)], full[i % len(full)]) for i in range(pairs)])


if __name__ == "__main__":
    try:
        main()
    except (chaindrive.RunError, OSError) as error:
        print(f"figures.py: {error}", file=sys.stderr)
        sys.exit(2)
