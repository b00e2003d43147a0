# SPDX-License-Identifier: LGPL-2.1-or-later
"""channels.py CASE PROGRAM: every history of a small drive that runs at speed; CASE is a fidelity, or layered-curves.

Each is finite wherever it has a value, moves with time unless this file says why it does not, and equals what can
be computed again from others: velocities are slopes of positions, accelerations of velocities, speeds of angles;
forces on teeth sum to those on rollers, none is above its peak, and it is there where bodies overlap; works are those
of the torques; terms of energy sum to the imbalance; spans are what their links do; and the outside of an elastic
roller moves with its centre and its spin. Of the simple model, whose masses are in its joints, there are also the
tension of each bar, kinetic and potential energy, and the balance of momentum and of angular momentum of the chain,
in which the loads on the shafts and the driver's torque are. Elsewhere pins and plates bear the tension.
"""
import pathlib
import re
import sys
import warnings

import h5py
import numpy as np

import program
from program import check
from small_drives import RIGID

CASE, PROGRAM = sys.argv[1:3]
# the law of forces of rigid bodies is that of a spring and a damper without stiffness curves only
FIDELITY = CASE.removesuffix("-curves")
CURVES = CASE == "layered-curves"
# what may stand still: nothing in these drives makes it move
STILL = {
    "hubs/driver_speed": "prescribed",
    "hubs/load_torque": "constant at speed",
    "hubs/driven_torque": "constant at speed",
}
# of prm/verification/hard.prm
GRAVITY, DENSITY = 9.81, 7600
WAIST = {"inner": 0.7 * 15.09e-3 * 2e-3, "outer": 0.7 * 13.02e-3 * 2e-3}  # m2, of a plate
ROLLER = {"outside": 10.16e-3, "bore": 7.52e-3, "length": 7e-3}


def run():
    """Runs the drive from a settled start at speed; returns its histories by name, and their attributes."""
    entries = {
        **RIGID,
        "Model/Fidelity": FIDELITY,
        "Drive/Layout/Start": "settled",
        "Time/End time in ms": 0.6 if FIDELITY in ("reduced", "full") else 1,
        "Output/History interval in us": 0.5,
        "Output/History precision": "double",
        "Contact/Friction coefficient": 0.1,
    }
    if FIDELITY == "layered":
        entries["Effects/Stiffness curves"] = "on" if CURVES else "off"
    if FIDELITY != "full":
        entries["Time/Time step in us"] = 0.25 if FIDELITY == "reduced" else 0.125  # several between two samples
    program.run("prm/verification/hard.prm", entries, "--output", "results", program=PROGRAM)
    histories, attributes = {}, {}
    with h5py.File("results/histories.h5") as file:
        file.visititems(lambda name, item: histories.update({name: item[:]}) if isinstance(item, h5py.Dataset) else None)
        attributes.update(file.attrs)
    return histories, attributes


def near(what, value, expected, tolerance):
    """Compares the root of the mean square of the difference with that of what is expected."""
    rms = lambda x: np.sqrt(np.nanmean(np.square(x)))  # noqa: E731
    error = rms(value - expected) / rms(expected)
    print(f"{what}: apart by {error:.2g}")
    check(error < tolerance, f"{what}: apart by {error:.3g}, at most {tolerance} expected")


def forces(histories):
    """Peaks, and forces and gaps. Where a force is above its peak, or acts at a distance, something is wrong."""
    for name in histories:
        if name.endswith("_peak"):
            below = histories[name] - histories[name.removesuffix("_peak")]
            scale = np.nanmax(np.abs(histories[name]))
            check(np.nanmin(below) >= -1e-12 * scale, f"{name} is {-np.nanmin(below):g} below the force itself")
            # between two samples there are one or two steps
            force = histories[name.removesuffix("_peak")]
            near(f"{name} and samples around it", histories[name][1:], np.maximum(force[1:], force[:-1]), 0.03)
        if name.endswith("_gap"):
            force, gap = histories[name.replace("_gap", "_force")], histories[name]
            where = force > 0
            # a contact that opens fast lets go before the bodies do, none takes hold before they touch
            check(np.all(gap[where] <= 0), f"{name}: up to {np.nanmax(gap[where]):g} m where a force acts")
            deep = gap < 0.3 * np.nanmin(gap)
            check(np.mean(where[deep]) > 0.9, f"{name}: no force in {np.mean(~where[deep]):.0%} of the deep overlaps")


def law_of_force(histories, slope):
    """The normal force of each contact of bodies that are rigid: a spring and a damper that never pull."""
    for channel, interface in (("rollers/driver", "roller-driver"), ("rollers/driven", "roller-driven"), ("joints/roller_bush", "roller-bush"), ("joints/bush_pin", "bush-pin")):
        found = re.search(rf"(\d+) points {interface}\b.*? k (\S+) N/m, c (\S+) N s/m", pathlib.Path("results/log.txt").read_text())
        if found is None:
            check(FIDELITY == "simple" and channel.startswith("joints"), f"no {interface} in the log")
            continue
        force, gap = histories[f"{channel}_force"], histories[f"{channel}_gap"]
        points, stiffness, damping = int(found[1]) / gap.shape[1], float(found[2]), float(found[3])
        where = force[1:-1] > 0
        expected = -points * (stiffness * gap[1:-1] + damping * slope(gap))
        near(f"force and overlap of {interface}", force[1:-1][where], np.maximum(expected[where], 0), 0.02)


def spans(histories, attributes, drive):
    """What spans are, from links and rollers, for sprockets of one size: those of their middles."""
    x, y, u, v = (histories[f"rollers/{name}"] for name in ("position_x", "position_y", "velocity_x", "velocity_y"))
    along, normal = (np.array(str(attributes[f"span_{axis}"]).split(), dtype=float) for axis in ("direction", "normal"))
    following = lambda values: np.roll(values, -1, axis=1)  # noqa: E731
    distance, middle = drive["centre_distance"], 0.5 * (x + following(x))
    inside = np.abs(middle - 0.5 * distance) < max(0.15 * distance, 0.51 * drive["pitch"])
    tight = inside & ((following(x) - x) * along[0] + (following(y) - y) * along[1] > 0)
    slack = inside & ~tight
    mean = lambda values, where: np.where(where, values, 0).sum(axis=1) / where.sum(axis=1)  # noqa: E731
    speed = u * along[0] + v * along[1]
    for name, values, where in (
        ("tight_tension", histories["links/tension"], tight),
        ("slack_tension", histories["links/tension"], slack),
        ("tight_speed", 0.5 * (speed + following(speed)), tight),
        ("tight_offset", x * normal[0] + y * normal[1], tight),
        ("slack_offset", -x * normal[0] + y * normal[1], slack),
    ):
        near(f"{name} and its links", histories[f"spans/{name}"], mean(values, where), 1e-9)


def links(histories):
    """Joints and plates: pins bear the tension of the links beside them, and two plates of a waist each link's."""
    tension = histories["links/tension"]
    if "joints/bush_pin_force" in histories:
        force = histories["joints/bush_pin_force"]
        near("pin forces and tension", 0.5 * (force + np.roll(force, -1, axis=1)), tension, 0.1)
    if "plates/axial_stress" in histories:
        for kind, section in enumerate((WAIST["inner"], WAIST["outer"])):
            pull, of_link = (2 * section * histories["plates/axial_stress"])[:, kind::2], tension[:, kind::2]
            share = np.sum(pull * of_link) / np.sum(of_link**2)  # links are not in balance, so on average only
            print(f"pull of plates over tension: {share:.4f}")
            check(abs(share - 1) < 0.03, f"pull of plates over tension: {share:.4f}")
        check(np.all(histories["plates/principal_1"] >= histories["plates/principal_2"]), "the smaller principal stress is the larger one")


def simple(histories, drive, slope):
    """The bars, masses and shafts of the simple model: the chain is a ring of points that spin."""
    x, y, u, v, a, b = (histories[f"rollers/{name}_{axis}"] for name in ("position", "velocity", "acceleration") for axis in "xy")
    spin, speed = histories["rollers/spin"], histories["hubs/driven_speed"]
    stiffness, damping = map(float, re.search(r"bars: k (\S+) N/m, c (\S+) N s/m", pathlib.Path("results/log.txt").read_text()).groups())
    mass, pitch, distance, driven = drive["mass_per_metre"] * drive["pitch"], drive["loaded_pitch"], drive["centre_distance"], drive["driven_inertia"]
    inertia = DENSITY * np.pi / 32 * (ROLLER["outside"] ** 4 - ROLLER["bore"] ** 4) * ROLLER["length"]

    following = lambda values: np.roll(values, -1, axis=1) - values  # noqa: E731
    length = np.hypot(following(x), following(y))
    rate = (following(x) * following(u) + following(y) * following(v)) / length
    near("tension of bars", histories["links/tension"], stiffness * (length - pitch) + damping * rate, 1e-3)
    near("energy of bars", histories["energy/bar"], 0.5 * stiffness * np.sum((length - pitch) ** 2, axis=1), 1e-3)
    near("potential energy", histories["energy/potential"], mass * GRAVITY * np.sum(y - y[0], axis=1), 1e-9)
    kinetic = 0.5 * (np.sum(mass * (u**2 + v**2) + inertia * spin**2, axis=1) + driven * speed**2)
    near("kinetic energy", histories["energy/kinetic"], kinetic, 1e-9)

    loads = {axis: histories[f"hubs/driver_load_{axis}"] + histories[f"hubs/driven_load_{axis}"] for axis in "xy"}
    near("loads on both shafts, along x", loads["x"], -mass * np.sum(a, axis=1), 1e-9)
    near("loads on both shafts, along y", loads["y"], -mass * np.sum(b + GRAVITY, axis=1), 1e-9)
    # about the driver's axis, in the sense of the drive: the chain, and the driven hub, which turns about its own
    moment = np.sum(mass * (x * b - y * a + GRAVITY * x), axis=1)[1:-1] + inertia * slope(spin).sum(axis=1)
    of_driven = driven * slope(speed) + histories["hubs/load_torque"][1:-1] + distance * histories["hubs/driven_load_y"][1:-1]
    near("torque of the driver", histories["hubs/driver_torque"][1:-1], moment + of_driven, 0.01)


def main():
    histories, attributes = run()
    drive = program.summary("results")["drive"]
    time = histories.pop("time")
    print(f"{CASE}: {len(histories)} histories, {len(time)} samples")
    for name, values in sorted(histories.items()):
        columns = values.reshape(len(time), -1)
        known = ~np.isnan(columns)
        check(np.all(np.isfinite(columns[known])), f"{name} is infinite")
        check(known.any(), f"{name} has no value at all")
        if name not in STILL:
            with warnings.catch_warnings():  # a column may have no value, as the gap of a roller far from all teeth
                warnings.simplefilter("ignore", RuntimeWarning)
                moves = np.nanmax(columns, axis=0) > np.nanmin(columns, axis=0)
            check(moves.any(), f"{name} is {np.nanmax(columns):g} throughout")
            if name.startswith("rollers/position"):
                check(moves.all(), f"{name} stands still in columns {np.flatnonzero(~moves)}")
        else:
            check(np.ptp(columns) == 0, f"{name} moves, which it should not: {STILL[name]}")

    step = time[2:] - time[:-2]
    slope = lambda values: (values[2:] - values[:-2]) / step.reshape(-1, *[1] * (values.ndim - 1))  # noqa: E731
    inside = lambda name: histories[name][1:-1]  # noqa: E731
    for axis in "xy":
        near(f"velocity_{axis} and slope of position", inside(f"rollers/velocity_{axis}"), slope(histories[f"rollers/position_{axis}"]), 0.01)
        near(f"acceleration_{axis} and slope of velocity", inside(f"rollers/acceleration_{axis}"), slope(histories[f"rollers/velocity_{axis}"]), 0.15)
    for hub in ("driver", "driven"):
        near(f"{hub}_speed and slope of angle", inside(f"hubs/{hub}_speed"), slope(histories[f"hubs/{hub}_angle"]), 0.01)
        near(f"{hub}_force on rollers and in gaps", histories[f"rollers/{hub}_force"].sum(axis=1), histories[f"teeth/{hub}_force"].sum(axis=1), 1e-9)
    near("drive_work and its power", slope(histories["energy/drive_work"]), inside("hubs/driver_torque") * inside("hubs/driver_speed"), 0.02)
    near("resisting_work and its power", slope(histories["energy/resisting_work"]), inside("hubs/load_torque") * inside("hubs/driven_speed"), 1e-3)
    forces(histories)
    spans(histories, attributes, drive)
    links(histories)
    if FIDELITY in ("simple", "layered") and not CURVES:
        law_of_force(histories, slope)
    if FIDELITY == "simple":
        simple(histories, drive, slope)
    terms = {name.split("/")[1]: values for name, values in histories.items() if name.startswith("energy/")}
    imbalance, supplied, taken = terms.pop("imbalance"), terms.pop("drive_work"), terms.pop("resisting_work")
    near("sum of energies and imbalance", sum(terms.values()) - sum(terms.values())[0] + taken - supplied, imbalance, 1e-6)
    if "rollers/surface_velocity_normal" in histories:
        along, normal = (np.array(str(attributes[f"span_{axis}"]).split(), dtype=float) for axis in ("direction", "normal"))
        centre = [histories[f"rollers/velocity_{axis}"] for axis in "xy"]
        relative = histories["rollers/surface_velocity_tangential"] - along[0] * centre[0] - along[1] * centre[1]
        turn = -along[0] * normal[1] + along[1] * normal[0]  # e_z x normal, along the direction of travel
        near("surface of a roller and its spin", np.mean(relative, axis=0), turn * 5.08e-3 * np.mean(histories["rollers/spin"], axis=0), 0.1)


main()
