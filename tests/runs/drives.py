# SPDX-License-Identifier: LGPL-2.1-or-later
"""drives.py PROGRAM REPOSITORY FILE: a drive of prm/drives runs as it is, and is compared with what is prescribed and with closed forms:

  power split       each load pulls with 2 pi T / (z p) more on the span behind it than on the one before
  an idler          takes no tension and turns by its teeth
  a tensioner       its spring's moment is that of its travel, and in the mean that of the chain on its wheel
                    with elastic links too: without and with penalty, and finite elements
  a coupling        its torque is that of its twist, the motor keeps its speed and feels little of the teeth; a bearing's force
                    is that of its displacement, and that of the chain in the mean and at a settled start; in all fidelities
                    stiff ones change nothing
  a drum            turns as the chain runs on it, with rollers or plates; one that is held still lets the tensions of the spans
                    beside it be in the ratio of Euler and Eytelwein; all fidelities balance energy and momentum
  a blade           its spring's moment is that of its travel, and in the mean that of the chain that lies on it; a shoe likewise;
                    on two ranks and resumed
  guides            the chain keeps half of a plate's height from them, and rubs on them with their coefficient of friction
  an arm            turns as is prescribed, by the moment of the chain on its wheel, which is turned back as the tight span asks
                    with elastic links, on two ranks and resumed too
  wheels out of line  are pulled towards each other by the stretched chain, and plates rub on their teeth
  prescribed        speeds and torques are the functions of time, angle and speed that the file says

and `plan --picture` draws it: every wheel with its name, every roller.
"""
import math
import pathlib
import re
import sys
import xml.etree.ElementTree as tree

import numpy as np

import chaindrive
import program
from drive_run import Drive, below, near

PROGRAM, FOLDER, NAME = sys.argv[1], pathlib.Path(sys.argv[2]) / "prm/drives", sys.argv[3]


def two_loads(drive):
    theta, speed = drive.of("hubs/compressor_angle", False), drive.of("hubs/driven_speed", False)
    stroke = 18 + 12 * np.cos(2 * theta + math.pi / 2)
    below("torque of the compressor off its waves, N m", np.abs(drive.of("hubs/compressor_torque", False) - stroke).max(), 1e-9)
    fan = drive.of("hubs/driven_torque", False)
    below("torque of the fan off the square of its speed, N m", np.abs(fan / (0.00052 * speed**2) - 1).max(), 0.01)
    spans = [drive.tension(name) for name in ("driver_to_driven", "driven_to_compressor", "compressor_to_driver")]
    for i, wheel in enumerate(("driven", "compressor")):
        near(f"tension that the {wheel} takes, N", spans[i + 1] - spans[i], drive.pull(wheel), 0.04 * (spans[2] - spans[0]))
    power = sum(np.mean(drive.of(f"hubs/{wheel}_torque") * drive.of(f"hubs/{wheel}_speed")) for wheel in ("driven", "compressor"))
    kinetic, resisted = drive.of("energy/kinetic"), drive.of("energy/resisting_work")
    # what wheels gain or lose in a window differs from run to run by more than the losses of the chain
    given = np.mean(drive.of("hubs/driver_torque") * drive.of("hubs/driver_speed"))
    gained = (kinetic[-1] - kinetic[0]) / (resisted[-1] - resisted[0]) * power
    near("power of the driver that wheels do not gain, over that of the loads", (given - gained) / power, 1.015, 0.015)


def idler(drive):
    near("speed of the idler over that of the driver", drive.of("hubs/idler_speed").mean() / drive.of("hubs/driver_speed").mean(), 17 / 13, 0.005)
    tight = drive.tension("driven_to_driver")
    near("tension that the idler takes, N", drive.tension("idler_to_driven") - drive.tension("driver_to_idler"), 0, 0.03 * tight)
    near("tension that the load takes, N", tight - drive.tension("idler_to_driven"), drive.pull("driven"), 0.03 * tight)


def tensioner(drive):
    idler(drive)
    travel, moment = drive.of("hubs/idler_travel", False), drive.of("hubs/idler_tensioner_moment", False)
    speed = np.gradient(travel, drive.time)
    below("moment off the law of spring and damper, over that of the damper", rms(moment - (5 - 8 * travel - 0.05 * speed)) / rms(0.05 * speed), 0.05)
    program.check(travel.min() > math.radians(-10) and travel.max() < math.radians(25), "it has met a stop")
    program.check(np.ptp(travel) > 1e-4, "it does not move")
    # counter-clockwise the arm takes up slack; the wheel's weight is 2 % of what its spring presses with
    arm, turned = 1j * (-58 + 115) * 1e-3 + (190 - 120) * 1e-3, drive.of("hubs/idler_travel")
    lever = arm * np.exp(1j * turned)
    load = drive.of("hubs/idler_load_x") + 1j * drive.of("hubs/idler_load_y")
    of_chain = (np.conj(lever) * load).imag
    mean = moment[drive.inside].mean()
    near("mean moment of chain and spring about the pivot, N m", (of_chain.mean() + mean) / mean, 0, 0.03)
    # driven slowly, over four pitches; at 960 rpm waves in the slack span raise it by 6 %
    program.run(FOLDER / f"{NAME}.prm", {"Loads/Driver speed in rpm": 60, "Time/End time in ms": 300, "Output/Window start in ms": 64.7}, "--output", "slow",
                program=PROGRAM)
    slow = program.summary("slow")
    near("tension beside the tensioner over the planned one", slow["spans"]["driver_to_idler"]["tension_mean"] / slow["drive"]["spans"][0]["tension"], 1, 0.03)
    tensioner_in_space()
    tensioner_with_elastic_links()


def tensioner_with_elastic_links():
    """Its law, work and momentum; the arm stands where the chain's own flexibility lets it."""
    file = FOLDER / f"{NAME}.prm"
    program.run(file, {"Model/Fidelity": "layered", "Time/End time in ms": 0.1, "Output/Window start in ms": 0}, "--output", "layered", program=PROGRAM)
    rigid = np.asarray(chaindrive.open("layered")["hubs/idler_travel"])[0]
    for name, end, changes in (("exact", 4, {"Model/Fidelity": "reduced"}), ("penalty", 1, {"Model/Fidelity": "reduced", "Contact/Enforcement": "penalty"}),
                               ("full", 0.2, {"Model/Fidelity": "full", "Elements/Formulation": "one point"})):
        entries = {**changes, "Model/Symmetry model": "true", "Time/End time in ms": end, "Output/Window start in ms": 0, "Output/History precision": "double",
                   "Output/History interval in us": 10}
        program.run(file, entries, "--output", name, program=PROGRAM)
        run, summary = chaindrive.open(name), program.summary(name)
        travel, moment = np.asarray(run["hubs/idler_travel"]), np.asarray(run["hubs/idler_tensioner_moment"])
        speed = np.gradient(travel, run.time)
        below(f"{name}: moment off the law of spring and damper, over that of the damper", rms(moment - (5 - 8 * travel - 0.05 * speed)) / rms(0.05 * speed), 0.05)
        below(f"{name}: travel of the arm at the start off that of rigid links, degrees", math.degrees(abs(travel[0] - rigid)), 1)
        program.check(np.ptp(travel) > 1e-5, f"{name}: the arm does not move")
        below(f"{name}: energy imbalance", summary["energy_imbalance_max"], 1e-4)
        below(f"{name}: momentum imbalance", summary["momentum_imbalance_max"], 1e-11)


def tensioner_in_space():
    """In space, with fields, on two ranks; and resumed: the same histories, those in the plane to round-off."""
    slide = "Drive/Wheels/idler/Slide/"
    layered = {"Output/History precision": "double", "Time/End time in ms": 3, "Output/Window start in ms": 1, "Output/Field interval in ms": 1,
               "Output/Checkpoint interval in ms": 1, "Model/Fidelity": "layered", "Effects/Planar motion": "off", "Drive/Layout/Start": "taut",
               "Drive/Layout/Tight span": "lower", "Drive/Wheels/idler/Held by": "slide", f"{slide}Direction in degrees": -90,
               f"{slide}Force in N": 60, f"{slide}Stiffness in N/m": 1000, "Time/Time step in us": 0.12}
    file = FOLDER / f"{NAME}.prm"
    program.run(file, layered, "--output", "whole", program=PROGRAM)
    program.run(file, layered, "--output", "ranks", program=PROGRAM, ranks=2)
    program.run(file, {**layered, "Time/End time in ms": 2}, "--output", "resumed", program=PROGRAM)
    program.run(file, layered, "--output", "resumed", "--resume", "auto", program=PROGRAM)
    program.run(file, {**layered, "Effects/Planar motion": "auto", **SECANTS}, "--output", "plane", program=PROGRAM)
    whole = chaindrive.open("whole")
    for other in ("ranks", "resumed"):
        run = chaindrive.open(other)
        for history in ("hubs/idler_travel", "hubs/idler_tensioner_force", "hubs/idler_angle", "links/tension", "energy/spring"):
            program.check(np.array_equal(np.asarray(whole[history]), np.asarray(run[history])), f"{history} of {other} differs")
    plane = np.asarray(chaindrive.open("plane")["hubs/idler_travel"])
    below("travel in the plane off that in space, m", np.abs(plane - np.asarray(whole["hubs/idler_travel"])).max(), 1e-9)


#: As in space, where stiffnesses have no curves.
SECANTS = {"Effects/Stiffness curves": "off"}

SOFT = {"Drive/Wheels/driven/Coupling/Stiffness in N m/rad": 2000, "Drive/Wheels/driver/Bearing/Stiffness in N/m": 8e6}


def rms(values):
    return np.sqrt(np.mean(np.square(values[2:-2])))


def laws(what, run, couplings, bearings, within):
    """Torques and forces off those of springs and dampers, over those of the dampers."""
    for name, stiffness, damping in couplings:
        twist, torque = (np.asarray(run[f"hubs/{name}_coupling_{of}"]) for of in ("twist", "moment"))
        viscous = damping * np.gradient(twist, run.time)
        below(f"{what}: torque of the {name}'s coupling off its law", rms(torque - stiffness * twist - viscous) / rms(viscous), within)
    for name, stiffness, damping in bearings:
        for axis in "xy":
            way, force = (np.asarray(run[f"hubs/{name}_{of}_{axis}"]) for of in ("displacement", "bearing_force"))
            viscous = damping * np.gradient(way, run.time)
            below(f"{what}: force of the {name}'s bearing off its law along {axis}", rms(force + stiffness * way + viscous) / rms(viscous), within)


def coupling(drive):
    file = FOLDER / f"{NAME}.prm"
    soft, bearing = [("driver", 300, 2 * 0.1 * math.sqrt(300 * 9e-4))], [("driven", 4e6, 2 * 0.05 * math.sqrt(4e6 * 6))]
    speed = drive.of("hubs/driver_machine_velocity", False)
    below("speed of the motor off 960 rpm, rad/s", np.abs(speed - 960 * math.pi / 30).max(), 1e-9)
    program.run(file, {"Output/History precision": "double", "Output/History interval in us": 5, "Time/End time in ms": 20, "Output/Window start in ms": 0},
                "--output", "dense", program=PROGRAM)
    laws("simple", chaindrive.open("dense"), soft, bearing, 0.05)
    # a settled start is in balance; in the mean the chain's force is that of the bearing
    force, load = (np.array([drive.of(f"hubs/driven_{of}_{axis}", False) for axis in "xy"]) for of in ("bearing_force", "load"))
    below("force of chain and bearing at the start, N", np.abs(force[:, 0] + load[:, 0]).max(), 0.05)
    mean = drive.summary["statistics"]
    near("mean displacement, um", 1e6 * mean["driven_displacement_x"]["mean"], 1e6 * drive.of("hubs/driven_load_x").mean() / 4e6, 2)
    near("mean twist of the coupling, rad", mean["driver_coupling_twist"]["mean"], mean["driver_torque"]["mean"] / 300, 5e-5)
    near("torque at the start over that without losses", drive.of("hubs/driver_coupling_moment", False)[0] / 30, 1, 0.03)
    losses, window = drive.summary["losses"], drive.summary["window_energy"]
    near("losses by name over all", sum(loss["energy"] for loss in losses.values()) / window["lost"], 1, 1e-9)
    program.check(min(losses[of]["energy"] for of in ("coupling of the driver", "bearing of the driven sprocket")) > 0, f"losses: {losses}")
    # what the teeth do to the motor, and what stiff springs do
    rigid = {"Drive/Wheels/driver/Coupling/Stiffness in N m/rad": "rigid"}
    program.run(file, rigid, "--output", "rigid_coupling", program=PROGRAM)
    felt = program.summary("rigid_coupling")["statistics"]["driver_torque"]["harmonics"][0]
    below("first harmonic of the motor's torque over that with a rigid coupling", mean["driver_torque"]["harmonics"][0] / felt, 0.1)
    program.run(file, {**rigid, "Drive/Wheels/driven/Bearing/Stiffness in N/m": "rigid"}, "--output", "rigid", program=PROGRAM)
    stiff = {"Drive/Wheels/driver/Coupling/Stiffness in N m/rad": 1e7, "Drive/Wheels/driven/Bearing/Stiffness in N/m": 1e11}
    program.run(file, stiff, "--output", "stiff", program=PROGRAM)
    one, other = (program.summary(name)["statistics"] for name in ("rigid", "stiff"))
    near("tension with stiff springs over that without", other["tight_tension"]["mean"] / one["tight_tension"]["mean"], 1, 0.006)
    near("first harmonic of the torque with stiff springs over that without", other["driver_torque"]["harmonics"][0] / one["driver_torque"]["harmonics"][0], 1, 0.03)
    first, second = (np.asarray(chaindrive.open(name)["hubs/driven_speed"]) for name in ("rigid", "stiff"))
    n = len(first) // 10
    below("driven speed with stiff springs off that without, over its range", np.abs(first[:n] - second[:n]).max() / np.ptp(first), 0.05)
    shafts_in_all_fidelities(soft, bearing)
    shafts_resumed()


def shafts_in_all_fidelities(soft, bearing):
    """On both wheels; whole and half models agree."""
    file = FOLDER / f"{NAME}.prm"
    for name, end, changes in (("layered", 2, {"Model/Fidelity": "layered"}),
                               ("half", 2, {"Model/Fidelity": "reduced", "Model/Symmetry model": "true"}),
                               ("whole", 0.5, {"Model/Fidelity": "reduced", "Model/Symmetry model": "false"}),
                               ("penalty", 0.5, {"Model/Fidelity": "reduced", "Contact/Enforcement": "penalty"}),
                               ("full", 0.1, {"Model/Fidelity": "full", "Elements/Formulation": "one point", "Model/Symmetry model": "true"})):
        entries = {**SOFT, **changes, "Time/End time in ms": end, "Output/Window start in ms": 0, "Output/History precision": "double",
                   "Output/History interval in us": 2}
        program.run(file, entries, "--output", name, program=PROGRAM)
        run, summary = chaindrive.open(name), program.summary(name)
        before, behind = (wheel["inertia"] for wheel in summary["drive"]["sprockets"])
        program.check(abs(before - 9e-4) < 1e-12, f"inertia {before}")
        machine = ("driven", 2000, 2 * 0.05 * math.sqrt(2000 / (1 / (behind - 0.05) + 1 / 0.05)))
        laws(name, run, [*soft, machine], bearing, 0.05)
        near(f"{name}: torque of the driven coupling at the start, N m", run["hubs/driven_coupling_moment"][0], 60, 1e-6)
        below(f"{name}: energy imbalance", summary["energy_imbalance_max"], 1e-4)
        below(f"{name}: momentum imbalance", summary["momentum_imbalance_max"], 1e-11)
    # elastic bodies begin with forces that are a few percent wrong
    half, whole = (chaindrive.open(name) for name in ("half", "whole"))
    at = [np.interp(0.5e-3, run.time, np.asarray(run["hubs/driven_displacement_x"])) for run in (half, whole)]
    near("displacement of the half model, um", 1e6 * at[0], 1e6 * at[1], 3)


def shafts_resumed():
    """In space and resumed, on one and on two ranks: the same histories; those in the plane to round-off."""
    file = FOLDER / f"{NAME}.prm"
    layered = {**SOFT, "Model/Fidelity": "layered", "Effects/Planar motion": "off", "Output/History precision": "double", "Time/End time in ms": 3,
               "Output/Window start in ms": 1, "Output/Checkpoint interval in ms": 1, "Drive/Layout/Tight span": "lower", "Time/Time step in us": 0.2}
    program.run(file, layered, "--output", "space", program=PROGRAM)
    program.run(file, layered, "--output", "space_ranks", program=PROGRAM, ranks=2)
    program.run(file, {**layered, "Time/End time in ms": 2}, "--output", "resumed", program=PROGRAM)
    program.run(file, layered, "--output", "resumed", "--resume", "auto", program=PROGRAM)
    program.run(file, {**layered, "Effects/Planar motion": "auto", **SECANTS}, "--output", "plane", program=PROGRAM)
    space = chaindrive.open("space")
    histories = ("driver_coupling_twist", "driven_coupling_moment", "driven_machine_velocity", "driver_displacement_y", "driven_bearing_force_x")
    for other in ("space_ranks", "resumed"):
        for history in [f"hubs/{name}" for name in histories] + ["links/tension", "energy/spring", "energy/spring_damping_loss"]:
            same = np.array_equal(np.asarray(space[history]), np.asarray(chaindrive.open(other)[history]))
            program.check(same, f"{history} of {other} differs")
        program.check(program.summary(other)["losses"] == program.summary("space")["losses"], f"losses of {other} differ")
    # impacts let round-off grow
    plane, in_space = (np.asarray(run["hubs/driver_displacement_x"])[space.time < 1e-3] for run in (chaindrive.open("plane"), space))
    below("displacement in the plane off that in space, m", np.abs(plane - in_space).max(), 1e-9)
    # a settled start lets round-off grow while bodies are strained for it
    reduced = {**SOFT, "Model/Fidelity": "reduced", "Drive/Layout/Start": "taut", "Loads/Ramp time in ms": 0.3, "Time/End time in ms": 1,
               "Output/Window start in ms": 0, "Output/History precision": "double"}
    program.run(file, reduced, "--output", "one", program=PROGRAM)
    program.run(file, reduced, "--output", "two", program=PROGRAM, ranks=2)
    for history in histories:
        one, two = (np.asarray(chaindrive.open(name)[f"hubs/{history}"]) for name in ("one", "two"))
        below(f"{history} on two ranks off that on one", np.abs(one - two).max() / np.abs(one).max(), 1e-9)


def circle(points):
    """Centre and radius of the one through three points of the plane, complex numbers."""
    a, b, c = points
    w = (c - a) / (b - a)
    centre = (b - a) * (w - abs(w) ** 2) / (2j * w.imag) + a
    return centre, abs(centre - a)


def distances(run, points, above):
    """By sample those of the joints beside an arc from it, towards the loop, m; infinite of all others."""
    centre, radius = circle(points)
    at = np.asarray(run["rollers/position_x"]) + 1j * np.asarray(run["rollers/position_y"])
    beside = (at.real > min(points.real)) & (at.real < max(points.real)) & ((at.imag > 0) == above)
    inwards = math.copysign(1, abs(centre) - radius)
    return np.where(beside, inwards * (abs(at - centre) - radius), np.inf)


def guides(drive):
    half = 0.5 * 8.26e-3  # of an inner plate of 06B
    arcs = {"driver_to_driven": np.array([30 - 41j, 120 - 54.2j, 210 - 61.8j]) * 1e-3,
            "driven_to_driver": np.array([210 + 57.9j, 120.5 + 46.5j, 31.5 + 37.5j]) * 1e-3}
    behind = {"driver_to_driven": "driver", "driven_to_driver": "driven"}  # the wheel whose section has the guide
    for span, points in arcs.items():
        force, rubbing = (np.asarray(drive.run[f"guides/{span}_{what}"]) for what in ("force", "friction"))
        touched = force > 0
        program.check(touched.any(), f"the guide of {span} is not touched")
        below(f"{span}: friction off 0.1 of the force, over the largest", np.abs(rubbing - 0.1 * force).max() / rubbing.max(), 1e-9)
        beside = distances(drive.run, points, span == "driven_to_driver")
        # all that are in the guide, by its stiffness of 1e7 N/m; its damping leaves as much as it brings
        elastic = 1e7 * np.maximum(half - beside, 0).sum(axis=1)
        near(f"{span}: mean force by the depths of plates in the guide, N", elastic.mean(), force.mean(), 0.1 * force.mean())
        below(f"{span}: depth without force, m", half - beside[~touched].min(), 5e-6)
        # each guide left out by itself, where an engine that turns unevenly makes both spans swing far
        left_out = {"Loads/driver/Harmonics/Amplitudes in percent": "14, 1", f"Drive/Wheels/{behind[span]}/Guide/Points in mm": ""}
        program.run(FOLDER / "guides.prm", {"Output/History precision": "double", **left_out}, "--output", span, program=PROGRAM)
        without = chaindrive.open(span)
        program.check(f"guides/{span}_force" not in without, f"{span} has no guide, but a force of one")
        for other in arcs:
            beyond = half - distances(without, arcs[other], other == "driven_to_driver").min()
            print(f"without the guide of {span}: the chain comes {1e3 * beyond:.3g} mm beyond that of {other}")
            program.check(beyond > 1e-3 if other == span else beyond < 2e-4, f"the guide of {other} does not hold the chain")
    loss = {name: losses["power"] for name, losses in drive.summary["losses"].items()}
    speed = np.hypot(np.asarray(drive.run["rollers/velocity_x"]), np.asarray(drive.run["rollers/velocity_y"]))[drive.inside].mean()
    rubbed = drive.of("guides/driven_to_driver_friction").mean() * speed
    near("power lost at the guide of the tight span, W", loss["guide of driven_to_driver"], rubbed, 0.3 * rubbed)
    guides_of_reduced_links()


def guides_of_reduced_links():
    """As above; links sag less than those of simple on bars, and begin outside of a lower guide."""
    lower = {"Drive/Wheels/driver/Guide/Points in mm": "30, -42.5; 120, -55.7; 210, -63.3"}
    entries = {"Model/Fidelity": "reduced", "Time/End time in ms": 8, "Output/Window start in ms": 0, "Output/Window end in ms": "auto", **lower,
               "Output/History precision": "double", "Output/History interval in us": 10}
    program.run(FOLDER / "guides.prm", entries, "--output", "reduced", program=PROGRAM)
    run, summary = chaindrive.open("reduced"), program.summary("reduced")
    force, rubbing = (np.asarray(run[f"guides/driven_to_driver_{what}"]) for what in ("force", "friction"))
    below("reduced: friction off 0.1 of the force, over the largest", np.abs(rubbing - 0.1 * force).max() / rubbing.max(), 1e-9)
    speed = np.hypot(np.asarray(run["rollers/velocity_x"]), np.asarray(run["rollers/velocity_y"])).mean()
    lost = summary["losses"]["guide of driven_to_driver"]["power"]
    near("reduced: power lost at the guide of the tight span, W", lost, rubbing.mean() * speed, 0.1 * lost)
    program.check(lost > 0.1, "the guide is hardly touched")
    below("reduced: energy imbalance", summary["energy_imbalance_max"], 1e-4)
    below("reduced: momentum imbalance", summary["momentum_imbalance_max"], 1e-11)


def flat_idler(drive):
    """Joints run on 44.5 mm and a roller of 8.51 mm: there is room for z = pi / asin(p / D) of them."""
    seats = math.pi / math.asin(12.7 / (44.5 + 8.51))
    start, mean = (drive.of("hubs/idler_speed", False)[0], drive.of("hubs/idler_speed").mean()) / drive.of("hubs/driver_speed").mean()
    near("speed of the drum at the start over that of the driver", start, 17 / seats, 1e-3)
    # rings keep the spin that the driver's teeth have given them, against the drum: its surface is drawn towards v + r omega
    drawn = (12.7 / (2 * math.sin(math.pi / 17)) + 8.51 / 2) / (44.5 / 2)
    program.check(17 / seats < mean < drawn, f"the drum turns {mean} times as fast as the driver, not between {17 / seats} and {drawn}")
    tight = drive.tension("driven_to_driver")
    near("tension that the drum takes, N", drive.tension("idler_to_driven") - drive.tension("driver_to_idler"), 0, 0.03 * tight)
    program.check("rollers/idler_force" in drive.run and "teeth/idler_force" not in drive.run, "histories of a wheel without teeth")
    still_drum()
    turning_drum()
    drum_in_all_fidelities()


def still_drum():
    """A drum that is too heavy to be turned, in the span that pulls: plates slide on it. Of each joint that it turns by f the tensions
    before and behind are in the ratio (1 + mu tan(f/2)) / (1 - mu tan(f/2)), and all of them make e^(mu theta), to 0.1 % here."""
    mu = 1
    flat = "Drive/Wheels/idler/Flat/"
    entries = {flat + "Diameter in mm": 200, flat + "Runs on": "plates", flat + "Friction coefficient": mu, "Drive/Wheels/idler/Inertia in kg m2": 1e5,
               "Drive/Wheels/Order of travel": "driver, driven, idler", "Drive/Wheels/idler/Centre in mm": "190, 135", "Drive/Layout/Start": "taut", "Loads/Driver speed in rpm": 100, "Loads/Ramp time in ms": 40,
               "Time/End time in ms": 400, "Output/Window start in ms": 200, "Model/Fidelity": "simple"}
    program.run(FOLDER / f"{NAME}.prm", entries, "--output", "still", program=PROGRAM)
    summary = program.summary("still")
    tension = {name: span["tension_mean"] - summary["drive"]["centrifugal_tension"] for name, span in summary["spans"].items()}
    angle = next(wheel["wrap"] for wheel in summary["drive"]["sprockets"] if wheel["name"] == "idler")
    turn = 2 * math.asin(12.7 / (200 + 11.81))
    joint = mu * math.tan(turn / 2)
    wanted = ((1 + joint) / (1 - joint)) ** (angle / turn)
    program.check(abs(wanted / math.exp(mu * angle) - 1) < 1e-3, "the polygon is a circle")
    near("ratio of the tensions beside a drum that stands still", tension["idler_to_driver"] / tension["driven_to_idler"], wanted, 0.02 * wanted)
    program.check(wanted > 1.2, f"{wanted}: nothing to see")
    below("turn of the drum, rad", np.ptp(np.asarray(chaindrive.open("still")["hubs/idler_angle"])), 1e-3)


def turning_drum():
    """Plates bring a drum from rest to the speed of the chain: (D + h)/2 of its axis they have that of the joints."""
    flat = "Drive/Wheels/idler/Flat/"
    entries = {flat + "Runs on": "plates", flat + "Friction coefficient": 0.3, "Drive/Wheels/idler/Inertia in kg m2": 1e-5, "Drive/Layout/Start": "taut", "Loads/Ramp time in ms": 60,
               "Time/End time in ms": 160, "Output/Window start in ms": 120}
    program.run(FOLDER / f"{NAME}.prm", entries, "--output", "turning", program=PROGRAM)
    run = chaindrive.open("turning")
    after = np.asarray(run["time"]) > 0.12
    driver, drum = (np.asarray(run[f"hubs/{wheel}_speed"])[after].mean() for wheel in ("driver", "idler"))
    seats = math.pi / math.asin(12.7 / (44.5 + 11.81))
    # it cannot overtake them, and lags where they hit it: by 1.7 % in the mean over ten start phases, which scatter by 0.9 %
    near("speed of the drum over that of the plates that turn it", drum / driver * seats / 17, 0.975, 0.025)
    summary = program.summary("turning")
    below("energy imbalance", summary["energy_imbalance_max"], 1e-3)


def drum_in_all_fidelities():
    flat = "Drive/Wheels/idler/Flat/"
    for name, end, changes in (("layered", 3, {"Model/Fidelity": "layered", "Effects/Planar motion": "off"}),
                               ("plates", 3, {"Model/Fidelity": "layered", flat + "Runs on": "plates"}),
                               ("exact", 0.4, {"Model/Fidelity": "reduced"}),
                               ("reduced-plates", 0.4, {"Model/Fidelity": "reduced", flat + "Runs on": "plates", "Model/Symmetry model": "true"}),
                               ("penalty", 0.6, {"Model/Fidelity": "reduced", "Contact/Enforcement": "penalty"}),
                               ("full", 0.02, {"Model/Fidelity": "full", "Model/Symmetry model": "true", "Elements/Formulation": "one point"})):
        entries = {**changes, "Time/End time in ms": end, "Output/Window start in ms": 0, "Output/History precision": "double", "Output/History interval in us": 20}
        program.run(FOLDER / f"{NAME}.prm", entries, "--output", name, program=PROGRAM)
        summary = program.summary(name)
        below(f"{name}: energy imbalance", summary["energy_imbalance_max"], 1e-4)
        below(f"{name}: momentum imbalance", summary["momentum_imbalance_max"], 1e-11)
        force, gap = (np.asarray(chaindrive.open(name)[f"rollers/idler_{what}"]) for what in ("force", "gap"))
        # a mesh of a roller with penalty meets a line up to 30 um late
        program.check((np.nan_to_num(force) > 0).any() or (name in ("penalty", "full") and np.nanmin(gap) < 30e-6), f"{name}: nothing lies on the drum")


def blade(drive):
    span = "driver_to_driven"
    travel, moment = drive.of(f"guides/{span}_travel", False), drive.of(f"guides/{span}_tensioner_moment", False)
    speed = np.gradient(travel, drive.time)
    law = 3 - 2 * travel - np.where(speed > 0, 0.02, 1) * speed
    slow = np.abs(np.gradient(speed, drive.time)) * (drive.time[1] - drive.time[0]) < 0.05 * np.abs(speed) + 1e-3  # where the samples resolve it
    slow[[0, -1]] = False
    program.check(slow.mean() > 0.2, f"{slow.mean()} of the samples resolve the motion")
    below("moment off the law of spring and damper where samples resolve it, N m", np.abs(moment - law)[slow].mean(), 0.02 * moment.mean())
    program.check(travel.max() < math.radians(12), "it has met its stop")
    program.check(np.ptp(travel) > math.radians(0.2), "it does not move")
    force, rubbing = (drive.of(f"guides/{span}_{what}", False) for what in ("force", "friction"))
    below("friction off 0.1 of the force, over the largest", (rubbing - 0.1 * force).max() / rubbing.max(), 1e-9)
    # the chain leaves the ends of the span with the same tension, less what turns its own momentum
    flux = drive.summary["drive"]["centrifugal_tension"]
    tension = drive.tension(span) - flux
    mean = moment[drive.inside].mean()
    planned = drive.summary["drive"]["guides"][0]["held"]["travel"]
    print(f"planned travel {math.degrees(planned):.3f} degrees, mean {math.degrees(travel[drive.inside].mean()):.3f}; tension {tension:.4g} N, moment {mean:.4g} N m")
    blade_at_rest()
    blade_in_space()


def blade_at_rest():
    """The drive turned slowly without engine and cams: the moment of the spring is that of the tension planned, and the blade stands."""
    entries = {"Loads/Driver speed in rpm": 30, "Loads/driver/Harmonics/Amplitudes in percent": "0, 0", "Loads/driven/Table/File": "", "Drive/Layout/Start": "taut",
               "Time/End time in ms": 60, "Output/Window start in ms": 40, "Output/Window end in ms": "auto", "Loads/Ramp time in ms": 20,
               "Drive/Wheels/driver/Guide/Plate friction coefficient": 0}
    program.run(FOLDER / f"{NAME}.prm", entries, "--output", "slow", program=PROGRAM)
    run, summary = chaindrive.open("slow"), program.summary("slow")
    after = np.asarray(run["time"]) > 0.04
    travel = np.asarray(run["guides/driver_to_driven_travel"])[after].mean()
    planned = summary["drive"]["guides"][0]["held"]["travel"]
    near("slow: mean travel off the planned one, degrees", math.degrees(travel - planned), 0, 0.3)
    tension = summary["spans"]["driver_to_driven"]["tension_mean"]
    near("slow: tension of the span that the blade presses over the planned one", tension / summary["drive"]["spans"][0]["tension"], 1, 0.05)


def blade_in_space():
    """A shoe on a slide in the mirrored drive, with fields, on two ranks, and resumed: the same histories; in the plane to round-off."""
    guide = "Drive/Wheels/driver/Guide/"
    entries = {"Model/Fidelity": "layered", "Effects/Planar motion": "off", "Drive/Layout/Start": "taut", "Drive/Layout/Tight span": "lower",
               "Drive/Wheels/driven/Guide/Points in mm": "", guide + "Held by": "slide", guide + "Slide/Direction in degrees": 90, guide + "Slide/Force in N": 40,
               guide + "Slide/Stiffness in N/m": 500, guide + "Slide/Damping in N s/m": 20, guide + "Slide/Mass in g": 60,
               "Time/End time in ms": 3, "Output/Window start in ms": 1, "Output/Window end in ms": "auto", "Output/Field interval in ms": 1,
               "Output/Checkpoint interval in ms": 1, "Output/History precision": "double", "Time/Time step in us": 0.1}
    file = FOLDER / f"{NAME}.prm"
    program.run(file, entries, "--output", "whole", program=PROGRAM)
    program.run(file, entries, "--output", "ranks", program=PROGRAM, ranks=2)
    program.run(file, {**entries, "Time/End time in ms": 2}, "--output", "resumed", program=PROGRAM)
    program.run(file, entries, "--output", "resumed", "--resume", "auto", program=PROGRAM)
    program.run(file, {**entries, "Effects/Planar motion": "auto", **SECANTS}, "--output", "plane", program=PROGRAM)
    whole, summary = chaindrive.open("whole"), program.summary("whole")
    below("shoe: energy imbalance", summary["energy_imbalance_max"], 1e-3)
    below("shoe: momentum imbalance", summary["momentum_imbalance_max"], 1e-11)
    names = [f"guides/driver_to_driven_{what}" for what in ("travel", "tensioner_push", "force", "friction")] + ["links/tension", "energy/spring"]
    for other in ("ranks", "resumed"):
        run = chaindrive.open(other)
        for history in names:
            program.check(np.array_equal(np.asarray(whole[history]), np.asarray(run[history])), f"{history} of {other} differs")
    travel = np.asarray(whole["guides/driver_to_driven_travel"])
    program.check(np.ptp(travel) > 1e-6, "the shoe does not move")
    plane = np.asarray(chaindrive.open("plane")["guides/driver_to_driven_travel"])
    # plates hit and leave the shoe, by which round-off grows tenfold in 0.2 ms
    early = np.asarray(whole["time"]) < 1.5e-3
    below("travel in the plane off that in space, m", np.abs(plane - travel)[early].max(), 1e-9)
    program.check(np.ptp(travel[early]) > 1e-5, "the shoe does not move by then")


def emergency_stop(drive):
    begin, length, full = 40e-3, 60e-3, 105
    s = np.clip((drive.time - begin) / length, 0, 1)
    below("speed off half a cosine, rad/s", np.abs(drive.of("hubs/driver_speed", False) - full * 0.5 * (1 + np.cos(math.pi * s))).max(), 1e-9)
    near("angle of the stop, rad", drive.of("hubs/driver_angle", False)[-1], full * (begin + length / 2), 1e-9)
    stopping = (drive.time > begin) & (drive.time < begin + length)
    slack, tight = (drive.of(f"spans/{name}_tension", False) for name in ("driver_to_driven", "driven_to_driver"))
    # the mean of the deceleration asks for this
    asked = (0.4 * full * 17 / 51 / length - 60) * 2 * math.pi / (51 * drive.summary["drive"]["loaded_pitch"])
    below("mean pull that the stop asks for over that of the lower span, N", asked, (slack - tight)[stopping].mean() * 1.2)


def camshaft(drive):
    theta = drive.of("hubs/driver_angle", False)
    speed = drive.of("hubs/driver_speed", False)
    mean = 100 * math.pi
    turned = mean * drive.time
    waves = 0.02 * np.cos(2 * turned) + 0.005 * np.cos(4 * turned + math.radians(40))
    below("speed off its waves, rad/s", np.abs(speed - mean * (1 + waves)).max(), 1e-9)
    phase = math.radians(40)
    angle = turned + 0.01 * np.sin(2 * turned) + 0.00125 * (np.sin(4 * turned + phase) - math.sin(phase))
    below("angle off their integral, rad", np.abs(theta - angle).max(), 1e-9)
    rows = [line.split(",") for line in (FOLDER / "cams.csv").read_text().splitlines() if line[0].isdigit()]
    x, y = (np.array([float(row[i]) for row in rows]) for i in (0, 1))
    cam = np.degrees(drive.of("hubs/driven_angle", False)) % 360
    torque = drive.of("hubs/driven_torque", False) - 1.5
    piece = np.searchsorted(x, cam, side="right") - 1
    low, high = np.minimum(y[piece], y[piece + 1]), np.maximum(y[piece], y[piece + 1])
    below("torque beyond the points beside it, N m", np.maximum(low - torque, torque - high).max(), 1e-9)
    linear = np.interp(cam, x, y)
    below("torque off the chords of the table, N m", np.abs(torque - linear).max(), 1.6)
    program.check(np.abs(torque - linear).max() > 0.1, "a cubic is not a polygon")
    tight, slack = drive.tension("driven_to_driver"), drive.tension("driver_to_driven")
    near("tension that the camshaft takes, N", tight - slack, drive.pull("driven"), 0.1 * drive.of("spans/driven_to_driver_tension").max())


def conveyor(drive):
    tight = drive.tension("driven_to_driver")
    for before, span in (("driver_to_lower_right", "lower_right_to_upper_right"), ("lower_right_to_upper_right", "upper_right_to_driven")):
        near(f"tension of {span} over {before}, N", drive.tension(span) - drive.tension(before), 0, 0.05 * tight)
    near("tension that the load takes, N", tight - drive.tension("upper_right_to_driven"), drive.pull("driven"), 0.05 * tight)
    for wheel in ("lower_right", "upper_right", "driven"):
        near(f"speed of {wheel}, rad/s", drive.of(f"hubs/{wheel}_speed").mean(), 12, 0.12)


def line_of(axes, radii):
    """The direction of the tight span, above the wheels, a complex number, and its length."""
    way = axes[1] - axes[0]
    length = math.sqrt(abs(way) ** 2 - (radii[1] - radii[0]) ** 2)
    return (length + 1j * (radii[1] - radii[0])) / abs(way) ** 2 * way, length


def motorcycle(drive):
    pivot, axle = 75e-3 + 0j, (604.8 - 74.5j) * 1e-3
    ms = 1e3 * drive.time
    raised = 0.5 * (1 - np.cos(math.pi * np.clip((ms - 20) / 60, 0, 1))) - 0.5 * (1 - np.cos(math.pi * np.clip((ms - 80) / 60, 0, 1)))
    swing, moment = drive.of("hubs/driven_swing", False), drive.of("hubs/driven_swing_moment", False)
    below("arm off what is prescribed, rad", np.abs(swing - math.radians(12) * raised).max(), 1e-9)
    load = drive.of("hubs/driven_load_x", False) + 1j * drive.of("hubs/driven_load_y", False)
    of_chain = (np.conj((axle - pivot) * np.exp(1j * swing)) * load).imag
    below("moment off that of the chain about the pivot, N m", np.abs(moment + of_chain).max(), 1e-6)
    radii = [0.5 * drive.summary["drive"]["loaded_pitch"] / math.sin(math.pi / drive.wheels[name]["teeth"]) for name in ("driver", "driven")]
    along, length = line_of((0, axle), radii)
    # three periods of the tight span while the arm stands still
    program.run(FOLDER / f"{NAME}.prm", {"Drive/Wheels/driven/Swing/Times in ms": "200, 300, 400", "Time/End time in ms": 110}, "--output", "still", program=PROGRAM)
    still = chaindrive.open("still")
    late = np.asarray(still["time"]) > 20e-3
    mean = lambda history: np.asarray(still[history])[late].mean()  # noqa: E731
    # the torque of the load acts on the wheel from outside, so that both spans pull at its axle; what keeps the chain on its way round does not
    way, kept = axle / abs(axle), drive.summary["drive"]["centrifugal_tension"]
    pulls = [mean(f"spans/{name}_tension") - kept for name in ("driven_to_driver", "driver_to_driven")]
    force = -pulls[0] * along - pulls[1] * way * np.conj(along / way)
    # the wheel bears what lies on it, and half of what hangs in the spans
    drawn, wheel = drive.summary["drive"], drive.wheels["driven"]
    borne = wheel["wrap"] * wheel["pitch_diameter"] / 2 + sum(span["length"] for span in drawn["spans"]) / 2
    asked = -(np.conj(axle - pivot) * force).imag + 9.81 * drawn["mass_per_metre"] * borne * (axle - pivot).real
    near("mean moment of the arm while it stands still, N m", mean("hubs/driven_swing_moment"), asked, 0.02 * asked)
    # what the wheel has turned, where the arm is highest: the span ends elsewhere on both wheels, and is shorter
    high = np.abs(ms - 80) < 3.5
    turned, given = (drive.of(f"hubs/{name}_angle", False)[high].mean() for name in ("driven", "driver"))
    other, shorter = line_of((0, pivot + (axle - pivot) * np.exp(1j * math.radians(12))), radii)
    tilt = np.angle(other / along)
    arcs = [drawn["loaded_pitch"] * drive.wheels[name]["teeth"] / (2 * math.pi) for name in ("driver", "driven")]  # of chain per rad
    asked = tilt + (arcs[0] * (given - tilt) + shorter - length) / arcs[1]
    ratio = arcs[0] / arcs[1] * given
    near("angle by which the arm has turned the wheel on, degrees", math.degrees(turned - ratio), math.degrees(asked - ratio), 0.4)
    work = np.trapz(drive.of("hubs/driver_torque", False) * drive.of("hubs/driver_speed", False), drive.time) + np.trapz(moment, swing)
    near("work of driver and arm, J", drive.summary["drive_work"], work, 2e-3 * work)
    below("energy imbalance", drive.summary["energy_imbalance_max"], 1e-4)
    motorcycle_otherwise()


def motorcycle_otherwise():
    """On two ranks, resumed, mirrored, and with elastic links."""
    entries = {"Output/History precision": "double", "Time/End time in ms": 3, "Output/Window start in ms": 0, "Output/Checkpoint interval in ms": 1}
    entries["Drive/Wheels/driven/Swing/Times in ms"] = "1, 3, 5"
    file = FOLDER / f"{NAME}.prm"
    program.run(file, entries, "--output", "whole", program=PROGRAM)
    program.run(file, entries, "--output", "ranks", program=PROGRAM, ranks=2)
    program.run(file, {**entries, "Time/End time in ms": 2}, "--output", "resumed", program=PROGRAM)
    program.run(file, entries, "--output", "resumed", "--resume", "auto", program=PROGRAM)
    whole = chaindrive.open("whole")
    histories = ("hubs/driven_swing", "hubs/driven_swing_moment", "hubs/driven_angle", "links/tension")
    for other in ("ranks", "resumed"):
        run = chaindrive.open(other)
        for history in histories:
            program.check(np.array_equal(np.asarray(whole[history]), np.asarray(run[history])), f"{history} of {other} differs")
    program.run(file, {**entries, "Drive/Layout/Tight span": "lower", "Loads/Gravity in m/s2": 0}, "--output", "lower", program=PROGRAM)
    program.run(file, {**entries, "Loads/Gravity in m/s2": 0}, "--output", "upper", program=PROGRAM)
    upper, lower = (np.asarray(chaindrive.open(name)["hubs/driven_swing_moment"]) for name in ("upper", "lower"))
    below("moment of the mirrored drive off the other, over the largest", np.abs(upper + lower)[:20].max() / np.abs(upper).max(), 1e-5)
    elastic = {"Model/Fidelity": "reduced", "Model/Symmetry model": "true", "Time/End time in ms": 1.5, "Time/Time step in us": 0.4, "Output/Checkpoint interval in ms": 0}
    program.run(file, {**entries, **elastic}, "--output", "reduced", program=PROGRAM)
    summary, moment = program.summary("reduced"), np.asarray(chaindrive.open("reduced")["hubs/driven_swing_moment"])
    below("with elastic links: energy imbalance", summary["energy_imbalance_max"], 3e-5)
    below("with elastic links: momentum imbalance", summary["momentum_imbalance_max"], 1e-11)
    rigid = np.asarray(whole["hubs/driven_swing_moment"])[: moment.size].mean()
    near("with elastic links: mean moment over that of rigid ones", moment.mean() / rigid, 1, 0.2)


def out_of_line(drive):
    side = {wheel: drive.summary["statistics"][f"{wheel}_side_force"]["mean"] for wheel in ("driver", "driven")}
    # a string between the wheels, less the play between plates and teeth, has the least, a beam with clamped ends twice as much at most
    pull = drive.tension("driven_to_driver") / 0.597
    print(f"side forces {side}, N for each mm {1e-3 * pull:.4g}")
    program.check(1.4e-3 * pull < side["driver"] < 4e-3 * pull, f"side force on the driver: {side['driver']} N")
    # what the spans gain of momentum across is small in the mean
    near("side force of the driven sprocket over that of the driver", side["driven"] / side["driver"], -1, 0.2)
    losses = drive.summary["losses"]
    program.check(losses["plate-driver"]["power"] > 10 * losses["roller-plate"]["power"] > 0, f"losses: {losses}")
    below("energy imbalance", drive.summary["energy_imbalance_max"], 1e-3)
    below("offset of links from where wheels are, mm", 1e3 * drive.of("links/position_z").max() - 2, 0.8)


def picture(drive):
    """Every wheel with its name, every roller within the frame."""
    said = program.run(f"{FOLDER / NAME}.prm", {}, "--plan", "--picture", "drive.svg", program=PROGRAM)
    program.check("drive.svg" in said, said)
    root = tree.parse("drive.svg").getroot()
    space = "{http://www.w3.org/2000/svg}"
    left, top, width, height = map(float, root.get("viewBox").split())
    names = {text.text for text in root.iter(space + "text")}
    program.check(set(drive.wheels) <= names, f"names: {names}")
    rollers = [circle for circle in root.iter(space + "circle") if circle.get("class") == "chain"]
    program.check(len(rollers) == drive.summary["drive"]["links"], f"{len(rollers)} rollers")
    for circle in rollers:
        x, y = float(circle.get("cx")), float(circle.get("cy"))
        program.check(left < x < left + width and top < y < top + height, f"a roller outside of the frame: {x} {y}")
    at = re.findall(r"-?[\d.]+", next(root.iter(space + "path")).get("d"))
    program.check(len(at) > 100, "a wheel without teeth")


drive = Drive(PROGRAM, FOLDER / f"{NAME}.prm")
globals()[NAME.replace("-", "_")](drive)
picture(drive)
