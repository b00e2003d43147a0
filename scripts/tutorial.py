# SPDX-License-Identifier: LGPL-2.1-or-later
"""tutorial.py RUN... [--pictures FOLDER]: compares several runs for doc/tutorial.md: prints a table, and with --pictures draws
impact.png (force of the driver on rollers after first contact), ripple.png (speed and tension over eight pitches) and, if the noise
of the runs has been computed, sound.png (third octaves). Needs python3-h5py, python3-pandas and python3-matplotlib."""
import argparse
import math
import pathlib
import sys

import matplotlib
import numpy as np

import chaindrive

matplotlib.use("Agg")
matplotlib.rcParams.update({"font.size": 8, "axes.titlesize": 9})
import matplotlib.pyplot as plt

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7")  # Okabe and Ito
PITCHES = 8


def name(run):
    return f"{run.drive['sprockets'][0]['teeth']} teeth"


def inside(run, path):
    return run.values(path, *run.window)


def losses(run):
    """Power lost over the whole run, W."""
    return sum(value for key, value in run.summary["energy"].items() if key.endswith("_loss")) / run.time[-1]


def impacts(run):
    """Means over the rollers that meet the driver in the window."""
    engaged = run.engagements("driver", window=True)
    return {f"impact: {what}": engaged[column].mean() for what, column in (
        ("normal speed (m/s)", "normal_speed"), ("peak force (N)", "peak_force"), ("impulse (N s)", "impulse"))}


def ripple(run, path):
    """Standard deviation over mean in the window, percent."""
    values = inside(run, path)
    return 100 * np.std(values) / abs(np.mean(values))


def figures(run):
    """{what: text}, in the units of a designer."""
    drive = run.drive
    found = {
        **(impacts(run) if "engagements" in run.summary else {}),
        "tight span (N)": run.summary["tight_tension_mean"],
        "ripple of the tight span (%)": ripple(run, "spans/tight_tension"),
        "ripple of the driven speed (%)": ripple(run, "hubs/driven_speed"),
        "polygon effect of the driver (%)": 100 * drive["sprockets"][0]["polygon_effect"],
        **({"losses (W)": losses(run)} if "energy" in run.summary else {}),
        "shaft load (N)": drive["shaft_load"],
        "joint pressure (MPa)": 1e-6 * drive["joint_pressure"],
        "tooth frequency (Hz)": drive["tooth_frequency"],
    }
    sound = sound_of(run)
    if sound:
        found["sound at the microphone (dB(A))"] = sound["level_a"]
    return {what: f"{value:.3g}" for what, value in found.items()}


def sound_of(run):
    """The first observer of acoustics.json; none where the noise was not computed."""
    return run.acoustics["observers"][0] if run.acoustics else None


def table(runs):
    columns = [figures(run) for run in runs]
    rows = [["", *map(name, runs)], ["---"] * (len(runs) + 1)]
    rows += [[what, *(column.get(what, "-") for column in columns)] for what in columns[0]]
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def draw_impact(runs, file):
    figure, axis = plt.subplots(figsize=(5, 2.6), layout="constrained")
    for run, colour in zip(runs, COLOURS):
        forces = run.aligned_engagements("driver", before=0.1e-3, after=0.8e-3, units=("ms", "kN"))
        for column in list(forces)[:6]:
            axis.plot(forces.index, forces[column], color=colour, lw=0.4, alpha=0.4)
        axis.plot(forces.index, forces.mean(axis=1), color=colour, lw=2, label=name(run))
    axis.set(title="force of the driver on rollers: six, and the mean", xlabel="time since the touch (ms)", ylabel="force (kN)")
    save(figure, axis, file)


def draw_ripple(runs, file):
    figure, axes = plt.subplots(1, 2, figsize=(7, 2.6), layout="constrained")
    for run, colour in zip(runs, COLOURS):
        of = run.time[run.rows(run.start, run.start + PITCHES * run.pitch_time)]
        for axis, path, what in zip(axes, ("hubs/driven_speed", "spans/tight_tension"), ("driven speed", "tight span's tension")):
            mean = np.mean(inside(run, path))
            axis.plot((of - of[0]) / run.pitch_time, 100 * (run.values(path, of[0], of[-1]) / mean - 1), color=colour, lw=1.2,
                      label=name(run))
            axis.set(title=what, xlabel="time (pitches)", ylabel="deviation from the mean (%)")
    save(figure, axes[0], file)


def draw_sound(runs, file):
    figure, axis = plt.subplots(figsize=(5, 2.6), layout="constrained")
    for i, (run, colour) in enumerate(zip(runs, COLOURS)):
        bands, levels = run.acoustics["third_octaves"], sound_of(run)["third_octaves"]
        known = [(band, level) for band, level in zip(bands, levels) if level is not None and math.isfinite(level)]
        if known:
            axis.step(*zip(*known), where="mid", color=colour, label=name(run))
    axis.set(xscale="log", title="sound at the microphone", xlabel="third octave (Hz)", ylabel="level (dB re 20 uPa)")
    save(figure, axis, file)


def save(figure, axis, file):
    axis.legend(frameon=False)
    for each in figure.axes:
        each.grid(color="0.92", lw=0.6)
    figure.savefig(file, dpi=85)
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="RUN")
    parser.add_argument("--pictures", type=pathlib.Path, metavar="FOLDER")
    words = parser.parse_args()
    try:
        runs = [chaindrive.open(folder) for folder in words.runs]
        print(table(runs))
        if words.pictures:
            words.pictures.mkdir(parents=True, exist_ok=True)
            if all("rollers/driver_force_peak" in run for run in runs):
                draw_impact(runs, words.pictures / "impact.png")
            draw_ripple(runs, words.pictures / "ripple.png")
            if all(map(sound_of, runs)):
                draw_sound(runs, words.pictures / "sound.png")
    except chaindrive.RunError as error:
        sys.exit(f"tutorial.py: {error}")


if __name__ == "__main__":
    main()
