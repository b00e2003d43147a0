# SPDX-License-Identifier: LGPL-2.1-or-later
"""separate_strands.py CASE PROGRAM: strands of a chain of several that are bodies of their own.

  line      In line two and three separate strands are, to round-off, one strand with its share; springs of shafts and tensioners too
  leaning   At rest a wheel that leans by theta along the line of centres pulls two strands that are p_t apart by the difference D. The
            moment of strands balances the tension T on links that are askew by phi: B phi'' = T phi, with B = k p sum(z^2 + l^2 / 12 +
            kappa r^2) on a span of the length L. The middle w = 0.3 L, over which tensions are means, is then bent by theta / w sinh(w
            / 2 lambda) / sinh(L / 2 lambda) in the mean, lambda^2 = B / T, and D is k p p_t times that. Seats on wheels give too: the
            length that D tells is greater, by the same for spans of other lengths, and does not matter to the difference of two. Strands
            together carry the torque; a lean across pulls none
  beam      At rest the side force on wheels that are offset is that of a beam that strands on common pins are, of the bending
            stiffness k p sum(z^2 + l^2 / 12) under the tension of them all: see out_of_line.py
  mirrored  A lean against the other one: strands change places
  resume    Goes on bit by bit, and is the same on two ranks
  hard      Two to six strands, three other chains, the largest lean that is accepted, a bush chain, coupling and bearing: energy and
            momentum balance, no guard trips
  fields    Field output shows all strands: of three, three times the cells of one, at the places of the strands
  words     What plan, log and refusals say
"""
import functools
import math
import pathlib
import re
import shutil
import sys
import zlib

import h5py
import numpy as np

import out_of_line_run
import program
from drive_run import below, near
from out_of_line_run import AT_REST, BUSH_LENGTH, DIRECTION, OFFSET, TILT, difference
from program import check

CASE, PROGRAM = sys.argv[1:3]
DRIVE = {**out_of_line_run.DRIVE, "Drive/Chain/Strands": 2, "Model/Driven inertia in kg m2": 4e-3, "Loads/Resisting torque in N m": 80}
STRANDS, LINKS, STIFFNESS = "Drive/Chain/Strands", "Drive/Number of links", "Model/Stiffness per pitch in N/m"
PIN_RADIUS, TANGENTIAL = 2.62e-3, 0.8  # m; Contact/Tangential ratio
TIGHT = "spans/driven_to_driver_tension_by_strand"

run = functools.partial(out_of_line_run.run, DRIVE, PROGRAM)


def line():
    # a while in which round-off has not grown; no dashpots, which act at once where round-off says that surfaces touch
    short = {"Time/End time in ms": 0.5, "Time/Time step in us": 0.25, "Contact/Damping ratio": 0, "Effects/Planar motion": "off"}
    for strands in (2, 3):
        entries = {**short, STRANDS: strands}
        one, of_one = run("one", {**entries, "Effects/Separate strands": "off"})
        several, of_several = run("several", {**entries, "Effects/Separate strands": "on"})
        names = [name for name, values in one.items() if values.dtype.kind == "f" and np.nanmax(np.abs(values), initial=0) > 0
                 and name.startswith(("hubs/", "spans/", "rollers/position", "rollers/velocity", "links/tension", "joints/", "teeth/", "energy/"))
                 and not name.endswith(("_gap", "imbalance", "peak"))]
        check(len(names) > 25, f"only {names}")
        below(f"{strands} strands: histories off those of one with its share", difference(several, one, names), 1e-6)
        tension = several[TIGHT]
        check(tension.shape[1] == strands, f"{tension.shape}")
        below("tensions of strands off each other, of them", np.ptp(tension, axis=1).max() / tension.max(), 1e-6)
        for name in ("drive_work", "resisting_work"):
            near(f"{name} of all strands over that of one strand's run", of_several[name] / of_one[name], 1, 1e-6)
    # springs of a tensioner, a coupling and a bearing, a load that grows with the speed
    yielding = {**short, "Model/Fidelity": "layered", "Output/History precision": "double", "Output/History interval in us": 20,
                "Output/Window start in ms": 0,
                "Drive/Wheels/driven/Coupling/Stiffness in N m/rad": 2e4, "Drive/Wheels/driver/Bearing/Stiffness in N/m": 1e8,
                "Loads/driven/Of speed/Linear in N m s": 0.01}
    found = []
    for separate in ("off", "on"):
        program.run("prm/drives/duplex.prm", {**yielding, "Effects/Separate strands": separate}, "--output", separate, program=PROGRAM)
        with h5py.File(f"{separate}/histories.h5") as file:
            found.append({f"{group}/{name}": file[group][name][:] for group in ("hubs", "spans") for name in file[group]
                          if not name.endswith("_by_strand")})
    names = [name for name, values in found[0].items() if np.abs(values).max() > 0]
    springs = {"hubs/idler_tensioner_moment", "hubs/driven_coupling_moment", "hubs/driver_bearing_force_x"}
    check(springs <= set(names), f"no {springs - set(names)}")
    for name in names:
        below(f"{name}: off that of one strand", difference(found[1], found[0], [name]), 1e-6)


def lean(links, direction=0, changes=()):
    """Tension of each strand and the summary with a lean of 1 degree."""
    entries = {TILT: 1, DIRECTION: direction, LINKS: links, STIFFNESS: 1e7, "Loads/Resisting torque in N m": 40, "Loads/Drag in 1/s": 400,
               "Time/End time in ms": 45, "Output/Window start in ms": 42, "Output/Quantities": "speeds, tensions", **dict(changes)}
    _, summary = run("lean", {**AT_REST, **entries})
    tensions = [summary["statistics"][f"strand_{strand}_tension"]["mean"] for strand in (1, 2)]
    print(f"{links} links: {tensions} N")
    return tensions, summary


def decay_of(stiffness, pitch, tension, places):
    """lambda, m. Bushes hold an inner link in its strand by their own length alone, so that it is askew by 1 / (1 + q) of the mean of
    its neighbours; and pins slide along their bushes by the springs of friction that sticks: both lessen what the tension bends by."""
    own = BUSH_LENGTH**2 / 12 + TANGENTIAL * PIN_RADIUS**2
    q = tension * pitch / (2 * len(places) * stiffness * own)
    sliding = tension / (len(places) * TANGENTIAL * stiffness * pitch)
    return math.sqrt(stiffness * pitch * sum(z**2 + own for z in places) / (0.5 * (1 + 1 / (1 + q)) * (1 - sliding) * tension))


def length_of(tensions, summary):
    """The length that the span has by the difference of its strands, m: by bisection."""
    stiffness, tension = 1e7, sum(tensions)
    span, pitch, places = summary["drive"]["spans"][-1], summary["drive"]["pitch"], summary["strands"]["z"]
    decay = decay_of(stiffness, pitch, tension, places)
    middle = 0.3 * span["length"]
    bent = abs(tensions[1] - tensions[0]) / (stiffness * pitch * (places[1] - places[0]))
    low, high = 0, 4 * span["length"]
    for _ in range(60):
        length = 0.5 * (low + high)
        is_longer = math.radians(1) / middle * math.sinh(0.5 * middle / decay) / math.sinh(0.5 * length / decay) > bent
        low, high = (length, high) if is_longer else (low, length)
    return low


def leaning():
    lengths, spans = [], []
    for links in (40, 60):
        tensions, summary = lean(links)
        lengths.append(length_of(tensions, summary))
        spans.append(summary["drive"]["spans"][-1]["length"])
        check(tensions[1] > tensions[0], "the strand of the longer way pulls less")
        check(summary["strands"]["shown"] == 2, "another strand is shown than that which pulls most")
        near("uneven", summary["strands"]["uneven"], 2 * max(tensions) / sum(tensions), 1e-9)
        driven = summary["drive"]["sprockets"][1]
        pull = sum(tensions) - 2 * summary["spans"]["driver_to_driven"]["tension_mean"]
        near("torque of all strands, N m", pull * 0.5 * driven["pitch_diameter"], 40, 2)
    pitch = summary["drive"]["pitch"]
    more = [(length - span) / pitch for length, span in zip(lengths, spans)]
    check(all(0 < pitches < 3 for pitches in more), f"spans act as longer by {more} pitches")
    near("length of the longer span less that of the shorter one, by their strands", (lengths[1] - lengths[0]) / (spans[1] - spans[0]), 1, 0.04)
    (first, second), _ = lean(40, 90, {"Drive/Driver teeth": 20})  # the span is along the line of centres
    below("strands off each other with a lean across, of their tension", abs(second - first) / first, 0.01)


def beam():
    strands, stiffness = 2, 4e6
    histories, summary = run("beam", {
        **AT_REST, STRANDS: strands, OFFSET: 3, STIFFNESS: stiffness, "Loads/Resisting torque in N m": 40 * strands,
        "Time/End time in ms": 60, "Output/Window start in ms": 56, "Output/Quantities": "speeds, tensions, tooth forces, roller motion"})
    n = DRIVE[LINKS]
    places = summary["strands"]["z"]
    links = summary["drive"]["spans"][-1]["links"]
    tension = sum(summary["statistics"][f"strand_{strand + 1}_tension"]["mean"] for strand in range(strands))
    side = {wheel: summary["statistics"][f"{wheel}_side_force"]["mean"] for wheel in ("driver", "driven")}
    x, y = (histories[f"rollers/position_{axis}"][-1] for axis in "xy")
    z = histories["links/position_z"][-1].copy()
    z[::2] -= places[summary["strands"]["shown"] - 1]  # inner links, those of one strand
    span = list(range(n - links, n))
    length = math.hypot(x[0] - x[n - links], y[0] - y[n - links])
    at = length * (np.arange(links) + 0.5) / links - 0.5 * length
    decay = decay_of(stiffness, length / links, tension, places)
    inside = slice(2, -2)
    basis = np.stack([np.ones(links), at, np.cosh(at / decay), np.sinh(at / decay)], axis=1)
    rate = np.linalg.lstsq(basis[inside], z[span][inside], rcond=None)[0]
    fit = basis @ rate
    print(f"{strands} strands: tension {tension:.5g} N, side forces {side}, lambda {1e3 * decay:.4g} mm of {1e3 * length:.4g}")
    below("deflection off that of a beam, of its range", np.abs(fit - z[span])[inside].max() / np.ptp(z[span]), 0.02)
    near("side force over that of the beam", side["driver"] / abs(tension * rate[1]), 1, 0.03)
    near("side force of the driven sprocket over that of the driver", side["driven"] / side["driver"], -1, 0.01)


def mirrored():
    short = {"Time/End time in ms": 0.3}
    for entry, value in ((OFFSET, 2), (TILT, 0.5)):
        one, _ = run("one", {**short, entry: value, STRANDS: 3})
        other, _ = run("other", {**short, entry: -value, STRANDS: 3})
        sides = "hubs/driven_side_force_by_strand"
        check(np.abs(one[sides]).max() > 1, "nothing pushes sideways")
        below(f"{entry}: tension of strands off its mirror image", np.abs(one[TIGHT] - other[TIGHT][:, ::-1]).max() / one[TIGHT].max(), 1e-6)
        below(f"{entry}: side force off its mirror image, N", np.abs(one[sides] + other[sides][:, ::-1]).max(), 1e-2)
        together = one[sides].sum(axis=1) - one["hubs/driven_side_force"]
        below(f"{entry}: side forces of strands off that of all, N", np.abs(together).max(), 1e-6)


def resume():
    entries = {OFFSET: 4, TILT: 0.3, STRANDS: 3, "Time/End time in ms": 3}
    middle = 2
    for directory in ("whole", "parts", "two"):
        shutil.rmtree(directory, ignore_errors=True)
    whole, summary = run("whole", entries)
    run("parts", {**entries, "Time/End time in ms": middle, "Output/Checkpoint interval in ms": middle})
    parts, resumed = run("parts", entries, ("--resume", "auto"), says=f"Resumed from .* at {middle}")
    two, _ = run("two", entries, ranks=2)
    for name, values in whole.items():
        check(values.tobytes() == parts[name].tobytes(), f"{name} is not the same after going on")
        check(np.array_equal(values, two[name], equal_nan=True), f"{name} is not the same on two ranks")
    check(summary["strands"] == resumed["strands"], f"{summary['strands']}, {resumed['strands']}")
    print(f"{len(whole)} histories are the same")


def hard():
    small = {"Drive/Chain/Designation": "06B", "Drive/Driver teeth": 13, "Drive/Driven teeth": 19, LINKS: 60, "Loads/Driver speed in rad/s": 314,
             "Loads/Resisting torque in N m": 20, "Model/Driven inertia in kg m2": 0.002}
    slow = {"Drive/Chain/Designation": "16A", STRANDS: 3, "Drive/Driver teeth": 11, "Drive/Driven teeth": 17, LINKS: 60,
            "Loads/Driver speed in rad/s": 8, "Loads/Resisting torque in N m": 2400, "Model/Driven inertia in kg m2": 0.5}
    heavy = {"Drive/Chain/Designation": "08B", "Drive/Driver teeth": 19, "Drive/Driven teeth": 38, LINKS: 80,
             "Loads/Driver speed in rad/s": 100, "Loads/Resisting torque in N m": 80, "Model/Driven inertia in kg m2": 0.15}
    for name, changes in {
        "06B-2, 3000 rpm": {**small, TILT: 0.5, OFFSET: 1},
        "16A-3, slow": {**slow, TILT: 0.5},
        "08B-2, heavy": {**heavy, TILT: -0.5, OFFSET: -1},
        "six strands": {STRANDS: 6, TILT: 0.3, "Loads/Resisting torque in N m": 240},
        "the largest lean": {TILT: 2.9},
        "a lean across": {TILT: 4.9, DIRECTION: 90, STRANDS: 4},
        "bush chain": {"Drive/Chain/Designation": "06C", TILT: 0.4, "Loads/Resisting torque in N m": 10},
        "coupling, bearing": {TILT: 0.4, "Drive/Wheels/driven/Coupling/Stiffness in N m/rad": 2e4,
                              "Drive/Wheels/driver/Bearing/Stiffness in N/m": 1e8},
    }.items():
        _, summary = run("hard", {**changes, "Time/End time in ms": 10})
        print(f"{name}: energy imbalance {summary['energy_imbalance_max']:.2g}, uneven {summary['strands']['uneven']:.3f}")
        below("energy imbalance", summary["energy_imbalance_max"], 5e-3)
        below("momentum imbalance", summary["momentum_imbalance_max"], 1e-9)
        check(not summary["events"], f"{summary['events']}")


def fields():
    found = {}
    for strands, separate in ((1, "auto"), (3, "on")):
        _, summary = run("fields", {STRANDS: strands, "Effects/Separate strands": separate, "Time/End time in ms": 0.1, "Output/Field interval in ms": 0.1})
        vtu = pathlib.Path("fields/fields/bodies_000000.vtu").read_bytes()
        head, data = vtu[:vtu.find(b"<AppendedData")], vtu[vtu.find(b"_", vtu.find(b"<AppendedData")) + 1:]
        points, cells = (int(re.search(rb"NumberOf%s=\"(\d+)\"" % what, head)[1]) for what in (b"Points", b"Cells"))
        blocks = int(np.frombuffer(data, "<u8", 1)[0])  # of the first array, the positions
        sizes = np.frombuffer(data, "<u8", blocks, 24)
        starts = 24 + 8 * blocks + np.concatenate([[0], np.cumsum(sizes)]).astype(int)
        position = b"".join(zlib.decompress(data[start:start + int(size)]) for start, size in zip(starts, sizes))
        z = np.frombuffer(position, "<f4").reshape(points, 3)[:, 2]
        found[strands] = cells, points, z.max(), summary.get("strands", {}).get("z", [0])
    cells, points, half, _ = found[1]
    check(found[3][:2] == (3 * cells, 3 * points), f"{found[3]} of three strands, {found[1]} of one")
    near("end of the last strand less its place over that of a single one", (found[3][2] - found[3][3][-1]) / half, 1, 1e-5)


def words():
    def plan(changes, status=0):
        file, sets = program.REPOSITORY / "prm/verification/hard.prm", {**DRIVE, **changes}.items()
        done = program.start([PROGRAM, "plan", str(file), *(word for name, value in sets for word in ("--set", f"{name}={value}"))])
        check(done.returncode == status, f"status {done.returncode}: {done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    said = plan({TILT: 1})
    for sentence in (r"separate strands +on +wheels are out of line and pull strands unevenly", r"planar motion +off",
                     r"120 rollers: rigid", r"60 inner links: rigid", r"30 outer links: rigid", r"17\.44 mm apart, on common pins"):
        check(re.search(sentence, said), f"no {sentence}:\n{said}")
    check("share the load equally" not in said, said)
    check("share the load equally" in plan({}), "strands in line")
    check(re.search(r"separate strands +off +switched off", plan({TILT: 1, "Effects/Separate strands": "off"})), "switched off")
    for changes, sentence in (({TILT: 1, "Model/Fidelity": "reduced"}, "Effects/Separate strands = off"),
                              ({"Model/Fidelity": "simple", "Effects/Separate strands": "on"}, "Separate strands = on is not possible"),
                              ({STRANDS: 1, "Effects/Separate strands": "on"}, "Separate strands = on is not possible"),
                              ({"Drive/Chain/Transverse pitch in mm": 11}, "Transverse pitch = 11 mm")):
        refused = plan(changes, status=2)
        check(sentence in refused, f"no {sentence}:\n{refused}")
    print("OK")


{"line": line, "leaning": leaning, "beam": beam, "mirrored": mirrored, "resume": resume, "hard": hard, "fields": fields, "words": words}[CASE]()
