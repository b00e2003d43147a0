# SPDX-License-Identifier: LGPL-2.1-or-later
"""tutorial_drives.py timing|motorcycle|elevator RUN... [--pictures FOLDER]: a table, and with --pictures a chart, of runs of one of the
drives in doc/tutorial-drives.md. Needs python3-h5py, python3-pandas and python3-matplotlib."""
import argparse
import pathlib

import matplotlib
import numpy as np

import chaindrive

matplotlib.use("Agg")
matplotlib.rcParams.update({"font.size": 8, "axes.titlesize": 9})
import matplotlib.pyplot as plt

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7")  # Okabe and Ito
GRAVITY = 9.81
BLADE = "guides/driver_to_driven_travel"


def inside(run, path):
    return run.values(path, *run.window)


def power(run, word):
    """What interfaces with this word in their names have taken in the window, W."""
    return sum(loss["power"] for name, loss in run.summary["losses"].items() if word in name)


def leak(run):
    return run.parameter("Drive/Wheels/driver/Guide/Arm/Retracting damping in N m s/rad")


def timing(run):
    return {
        "leak damping (N m s/rad)": leak(run),
        "the blade moves by (degrees)": np.degrees(np.ptp(inside(run, BLADE))),
        "mean tension at the blade (N)": run.summary["slack_tension_mean"],
        "mean tension of the other span (N)": run.summary["tight_tension_mean"],
        "friction on the guides (W)": power(run, "guide"),
        "mean impact on the crank's sprocket (N)": run.summary["impacts"]["driver"]["peak_force"]["mean"],
    }


def draw_timing(runs, axes):
    orders, crank = np.arange(0.5, 8.1, 0.5), runs[0].drive["sprockets"][0]["speed"] / (2 * np.pi)
    for run, colour in zip(runs, COLOURS):
        rows = run.rows(*run.window)
        axes[0].plot(1e3 * run.time[rows], np.degrees(inside(run, BLADE)), color=colour, label=f"{leak(run):g} N m s/rad")
        tension = inside(run, "spans/tight_tension")
        time = run.time[rows]
        waves = [2 * abs(np.mean(tension * np.exp(-2j * np.pi * order * crank * time))) for order in orders]
        axes[1].plot(orders, waves, "o-", ms=3, color=colour)
    axes[0].set(title="travel of the blade", xlabel="time (ms)", ylabel="degrees")
    axes[0].legend(title="leak damping")
    axes[1].set(title="tension of the tight span", xlabel="order of the crank", ylabel="amplitude (N)", ylim=(0, None))


def motorcycle(run):
    load = np.hypot(inside(run, "hubs/driven_load_x"), inside(run, "hubs/driven_load_y"))
    return {
        "slack at the start (mm)": 1e3 * max(span["slack"] for span in run.drive["spans"]),
        "largest tension (N)": np.max(inside(run, "spans/tight_tension")),
        "largest load of the axle (N)": np.max(load),
        "losses in the joints (W)": power(run, "bush-pin"),
        "safety of the plates": run.summary["life"]["simulated_plate_safety"],
    }


def draw_motorcycle(runs, axes):
    for run, colour in zip(runs, COLOURS):
        time = 1e3 * run.time[run.rows(*run.window)]
        axes[0].plot(time, 1e-3 * inside(run, "spans/slack_tension"), color=colour, lw=0.8,
                     label=f"{motorcycle(run)['slack at the start (mm)']:.1f} mm")
        axes[1].plot(time, inside(run, "hubs/driven_speed"), color=colour, lw=0.8)
    axes[0].set(title="tension of the lower span", xlabel="time (ms)", ylabel="kN")
    axes[0].legend(title="slack at the start")
    axes[1].set(title="speed of the wheel", xlabel="time (ms)", ylabel="rad/s")
    arm = axes[1].twinx()
    arm.plot(time, np.degrees(inside(runs[0], "hubs/driven_swing")), color="0.6", ls="--")
    arm.set_ylabel("arm (degrees, dashed)")


def along(run):
    """Heights over the axis of the driver [m] and tensions over the window [N] of the links on the way up, and on the way down."""
    rows = run.rows(*run.window)
    tension, passed = run.dataset("links/tension")[rows], run.dataset("rollers/position_y")[rows]
    x = run.dataset("rollers/position_x")[rows]
    top, bottom = np.max(passed), np.min(passed)
    bins = np.linspace(bottom + 0.5, top - 0.5, 40)
    sides = []
    for right in (True, False):
        chosen = (x > np.mean(x)) == right
        part = np.digitize(passed[chosen], bins)
        sides.append((0.5 * (bins[1:] + bins[:-1]), np.array([np.mean(tension[chosen][part == i]) for i in range(1, len(bins))])))
    return sides


def elevator(run):
    up, down = (np.polyfit(height, tension, 1) for height, tension in along(run))
    return {
        "rise of tension on the way up (N/m)": up[0],
        "on the way down (N/m)": down[0],
        "weight of the chain (N/m)": GRAVITY * run.drive["mass_per_metre"],
        "up less down, half-way (N)": np.polyval(up, -8.9) - np.polyval(down, -8.9),
        "pull of the load (N)": run.drive["effective_tension"],
    }


def draw_elevator(runs, axes):
    for run, colour in zip(runs, COLOURS):
        for ax, (height, tension) in zip(axes, along(run)):
            ax.plot(tension, height, color=colour, label=run.parameters["Model/Fidelity"])
            line = GRAVITY * run.drive["mass_per_metre"] * (height - np.mean(height)) + np.mean(tension)
            ax.plot(line, height, color="0.5", ls="--", lw=0.8)
    for ax, title in zip(axes, ("way up", "way down")):
        ax.set(title=title, xlabel="mean tension (N); dashed: weight", ylabel="height (m)")
    axes[0].legend()


DRIVES = {"timing": (timing, draw_timing), "motorcycle": (motorcycle, draw_motorcycle), "elevator": (elevator, draw_elevator)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("drive", choices=DRIVES)
    parser.add_argument("runs", nargs="+")
    parser.add_argument("--pictures", type=pathlib.Path)
    options = parser.parse_args()
    figures, draw = DRIVES[options.drive]
    runs = [chaindrive.open(folder) for folder in options.runs]
    columns = [figures(run) for run in runs]
    print("|  | " + " | ".join(pathlib.Path(folder).name for folder in options.runs) + " |")
    print("|---" * (1 + len(runs)) + "|")
    for what in columns[0]:
        print(f"| {what} | " + " | ".join(f"{column[what]:.4g}" for column in columns) + " |")
    if options.pictures:
        figure, axes = plt.subplots(1, 2, figsize=(7, 2.6), layout="constrained")
        draw(runs, axes)
        options.pictures.mkdir(parents=True, exist_ok=True)
        figure.savefig(options.pictures / f"{options.drive}.png", dpi=90)


if __name__ == "__main__":
    main()
