# SPDX-License-Identifier: LGPL-2.1-or-later
"""statistics.py PROGRAM: what summary.json says of the window of a run, against its histories and closed forms.

The paper's drive as a simple model with a settled start. With a sample at every step: mean, deviation, least and largest value of
each signal, and its harmonics by a least-squares fit over the same tooth periods. The energy of the window closes and is that of the
histories, and the losses of interfaces add up to it. The chain pulls at both shafts with the tensions of the spans less what its own
motion needs, T1 + T2 - 2 m v^2. Impacts are the engagements in the window. A layered model has losses in its joints.
"""
import sys

import h5py
import numpy as np

import program
from program import check

PROGRAM = sys.argv[1]
ENTRIES = {
    "Drive/Layout/Start": "settled",
    "Time/Time step in us": 2,
    "Time/End time in ms": 30,
    "Output/Window start in ms": 11.1115,
    "Output/Window end in ms": 28.2347,
    "Output/Field interval in ms": 0,
}
TEETH = 15
WAVES = 4


def near(what, value, expected, within):
    check(abs(value - expected) <= within, f"{what}: {value:.8g} instead of {expected:.8g}, within {within:.2g}")


def harmonics(angle, values, periods):
    """Amplitudes of the harmonics of `angle` in `values` over so many of its periods, by the trapezoidal rule."""
    inside = angle < 2 * np.pi * periods
    uniform = np.linspace(0, 2 * np.pi * periods, 100001)
    x = np.interp(uniform, angle, values)
    check(inside.sum() > 1000, "too few samples")
    return [2 * abs(np.mean((x * np.exp(1j * n * uniform))[:-1])) for n in range(1, WAVES + 1)]


program.run("prm/paper/simple.prm", {**ENTRIES, "Output/Quantities": "speeds, tensions, energy", "Output/History interval in us": 0.1},
            "--output", "every", program=PROGRAM)
summary = program.summary("every")
start, end = summary["window"]["start"], summary["window"]["end"]
statistics = summary["statistics"]
with h5py.File("every/histories.h5", "r") as file:
    time = file["time"][:]
    step = time[1] - time[0]
    duration = np.clip(np.minimum(time, end) - np.maximum(time - step, start), 0, None)  # a value stands for the step before it
    tooth = TEETH * file["hubs/driver_angle"][:]
    angle = tooth - np.interp(start, time, tooth)
    check(statistics["tooth_periods"] == int(np.interp(end, time, angle) / (2 * np.pi)), f"{statistics['tooth_periods']} tooth periods")
    for name, path in (("driven_speed", "hubs/driven_speed"), ("driver_torque", "hubs/driver_torque"),
                       ("span_speed", "spans/tight_speed"), ("tight_tension", "spans/tight_tension"),
                       ("slack_tension", "spans/slack_tension"), ("tight_offset", "spans/tight_offset"),
                       ("slack_offset", "spans/slack_offset")):
        values, found = file[path][:], statistics[name]
        mean = np.average(values, weights=duration)
        deviation = np.sqrt(np.average((values - mean) ** 2, weights=duration))
        near(f"mean of {name}", found["mean"], mean, 1e-9 * abs(mean))
        near(f"deviation of {name}", found["deviation"], deviation, 1e-6 * deviation)
        near(f"least {name}", found["least"], values[duration > 0].min(), 0)
        near(f"largest {name}", found["largest"], values[duration > 0].max(), 0)
        for n, (got, expected) in enumerate(zip(found["harmonics"], harmonics(angle[angle >= 0], values[angle >= 0], statistics["tooth_periods"]))):
            near(f"harmonic {n + 1} of {name}", got, expected, 0.003 * max(expected, 0.1 * deviation))
    near("mean of tension", summary["tight_tension_mean"], statistics["tight_tension"]["mean"], 0)
    check(statistics["driven_speed"]["harmonics"][0] > 1e-3 * statistics["driven_speed"]["mean"], "there is no polygon effect to find")

    energy, losses = summary["window_energy"], summary["losses"]
    change = {name: np.diff(np.interp([start, end], time, file["energy/" + name][:]))[0]
              for name in ("drive_work", "resisting_work", "friction_loss", "contact_damping_loss", "chain_damping_loss")}
    scale = change["drive_work"]
    for name in ("drive_work", "resisting_work"):
        near(name, energy[name], change[name], 1e-9 * scale)
    near("friction", sum(loss.get("friction", 0) for loss in losses.values()), change["friction_loss"], 1e-9 * scale)
    near("damping", sum(loss.get("damping", 0) for loss in losses.values()), change["contact_damping_loss"], 1e-9 * scale)
    near("damping of bars", losses["chain damping"]["energy"], change["chain_damping_loss"], 1e-9 * scale)
    check(min(losses["roller-driver"]["friction"], losses["roller-driven"]["friction"]) > 0, f"no friction on teeth: {losses}")
    near("losses together", sum(loss["energy"] for loss in losses.values()), energy["lost"], 1e-9 * scale)
    near("balance of the window", energy["drive_work"], energy["resisting_work"] + energy["lost"] + energy["stored"], 1e-3 * scale)
    near("power", losses["roller-driver"]["power"], losses["roller-driver"]["energy"] / (end - start), 1e-9 * scale / (end - start))
    near("efficiency by the ledger", summary["efficiency"], energy["resisting_work"] / (energy["drive_work"] - energy["stored"]), 1e-12)
    check(abs(energy["stored"]) > 1e-6 * scale, "nothing is stored in the window")
    near("efficiency", summary["efficiency"], energy["resisting_work"] / (energy["resisting_work"] + energy["lost"]), 1e-3)
    check(0.9 < summary["efficiency"] < 1, f"efficiency {summary['efficiency']}")

said = program.run("prm/paper/layered.prm", {**ENTRIES, "Time/Time step in us": "auto"}, "--output", "layered", program=PROGRAM)
summary = program.summary("layered")
start, end = summary["window"]["start"], summary["window"]["end"]
statistics, drive = summary["statistics"], summary["drive"]
with h5py.File("layered/histories.h5", "r") as file:
    inside = (file["time"][:] >= start) & (file["time"][:] <= end)
    for sprocket, side in (("driver", 1), ("driven", -1)):
        x, y = (file[f"hubs/{sprocket}_load_{axis}"][:][inside] for axis in "xy")
        near(f"mean load on the {sprocket}", np.hypot(x, y).mean(), statistics[f"{sprocket}_load"]["mean"],
             0.2 * statistics[f"{sprocket}_load"]["deviation"])
        check((side * x).mean() > 0, f"the chain pushes the {sprocket} away")
        pull = statistics["tight_tension"]["mean"] + statistics["slack_tension"]["mean"] - 2 * drive["centrifugal_tension"]
        near(f"load on the {sprocket} from the tensions of spans", (side * x).mean(), pull, 0.06 * pull)
        direction = np.arctan2(y, side * x)
        near(f"direction on the {sprocket}", direction.mean(), statistics[f"{sprocket}_load_direction"]["mean"],
             0.2 * statistics[f"{sprocket}_load_direction"]["deviation"])
    for path in ("rollers/position_x", "links/tension"):
        check(file[path].dtype == np.float32 and file[path].compression == "gzip", f"{path} is {file[path].dtype}, {file[path].compression}")
    check(file["hubs/driver_angle"].dtype == np.float64, "a single channel has lost digits")
for sprocket in ("driver", "driven"):
    chosen = [e for e in summary["engagements"] if e["sprocket"] == sprocket and e["complete"] and start <= e["time"] <= end]
    found = summary["impacts"][sprocket]
    check(found["number"] == len(chosen) > 3, f"{found['number']} impacts instead of {len(chosen)}")
    for name in ("peak_force", "impulse", "normal_speed"):
        values = np.array([e[name] for e in chosen])
        near(f"mean {name}", found[name]["mean"], values.mean(), 1e-9 * abs(values).max())
        near(f"deviation of {name}", found[name]["deviation"], values.std(ddof=1), 1e-9 * abs(values).max())
        near(f"largest {name}", found[name]["largest"], values.max(), 0)
losses = summary["losses"]
check(min(losses[name]["power"] for name in ("roller-bush", "bush-pin")) > 0, f"joints lose nothing: {losses}")
near("losses together", sum(loss["energy"] for loss in losses.values()), summary["window_energy"]["lost"], 1e-9 * summary["window_energy"]["drive_work"])
for words in ("driver shaft load", "harmonics over 4 whole tooth periods", "loss in bush-pin", "impacts on the driven"):
    check(words in said, f"the log does not say: {words}\n{said}")
check(("The drive had" in said) == (statistics["settled"] is not None), "the log is silent on whether the drive had settled")
