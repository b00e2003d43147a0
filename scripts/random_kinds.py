# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a random drive has besides two sprockets in a plane: further wheels, tensioners, guides, shafts that yield, arms that move,
imperfections, misalignment, strands, loads that change. For random_drives.py --kinds."""
import math

NOT_SIMPLE = ("misalignment",)
NOT_FULL = ("guide", "blade")


class Plane:
    """The drive as random_drives.py draws it, its tight span above: radii of the pitch circles and the distance of the axes, mm."""

    def __init__(self, pitch, radii, links):
        self.pitch, self.radii = pitch, radii
        self.distance = 0.5 * (links * pitch - math.pi * sum(radii))  # roughly: open loop over equal wheels
        slope = math.asin(max(-0.9, min(0.9, (radii[1] - radii[0]) / self.distance)))
        self.along = (math.cos(slope), -math.sin(slope))  # of the slack span, driver to driven
        self.out = (-math.sin(slope), -math.cos(slope))

    def beside(self, part, away, tight=False):
        """The point that divides a span so, seen from the driver, `away` from it outwards (inwards if negative), mm."""
        x = self.radii[0] * self.out[0] + part * self.distance * self.along[0] * self.along[0] + away * self.out[0]
        y = self.radii[0] * self.out[1] + part * self.distance * self.along[0] * self.along[1] + away * self.out[1]
        return x, -y if tight else y


def text(*points):
    return "; ".join(f"{x:.2f}, {y:.2f}" for x, y in points)


def idler(rng, plane, entries, flat=False):
    """A wheel on the slack span; returns where its axis is, or nothing where there is no room."""
    teeth = rng.randint(9, 25)
    radius = 0.5 * plane.pitch / math.sin(math.pi / teeth)
    if plane.distance < sum(plane.radii) + 2 * radius + 6 * plane.pitch:
        return None
    outside = rng.random() < 0.6
    push = rng.uniform(0.01, 0.08) * plane.distance
    at = plane.beside(rng.uniform(0.4, 0.6), radius - push if outside else push - radius)
    wheel = "Drive/Wheels/idler/"
    entries.update({"Drive/Wheels/Order of travel": "driver, idler, driven", f"{wheel}Side": "outside" if outside else "inside",
                    f"{wheel}Centre in mm": text(at), f"{wheel}Teeth": teeth})
    if flat:
        entries[f"{wheel}Flat/Diameter in mm"] = f"{2 * radius:.2f}"
        entries[f"{wheel}Flat/Runs on"] = rng.choice(("rollers", "plates"))
    elif rng.random() < 0.5:
        entries[f"{wheel}Inertia in kg m2"] = f"{10 ** rng.uniform(-5, -2):.3g}"
    return at, -1 if outside else 1


def drum(rng, plane, entries):
    return idler(rng, plane, entries, flat=True)


def spring(rng, section, entries, lever):
    """An arm, or with no lever [mm] a slide, with its spring, dampers and stops."""
    force = 10 ** rng.uniform(0.7, 2.5)
    damping = 10 ** rng.uniform(0, 2.5)
    retracting = rng.choice(("auto", damping * 30))
    if lever:
        arm, l = section + "Arm/", 1e-3 * lever
        entries.update({f"{arm}Moment in N m": f"{force * l:.4g}", f"{arm}Stiffness in N m/rad": f"{10 ** rng.uniform(2, 4) * l * l:.4g}",
                        f"{arm}Damping in N m s/rad": f"{damping * l * l:.4g}", f"{arm}Inertia in kg m2": f"{0.1 * l * l:.3g}",
                        f"{arm}Retracting damping in N m s/rad": retracting if retracting == "auto" else f"{retracting * l * l:.4g}"})
        if rng.random() < 0.5:
            entries[f"{arm}Greatest angle in degrees"] = f"{rng.uniform(1, 40):.2f}"
    else:
        slide = section + "Slide/"
        entries.update({f"{slide}Force in N": f"{force:.4g}", f"{slide}Stiffness in N/m": f"{10 ** rng.uniform(2, 4):.4g}",
                        f"{slide}Damping in N s/m": f"{damping:.4g}", f"{slide}Mass in g": f"{rng.uniform(20, 500):.3g}",
                        f"{slide}Retracting damping in N s/m": retracting if retracting == "auto" else f"{retracting:.4g}"})
        if rng.random() < 0.5:
            entries[f"{slide}Greatest travel in mm"] = f"{rng.uniform(0.5, 40):.2f}"


def tensioner(rng, plane, entries):
    placed = idler(rng, plane, entries, flat=rng.random() < 0.2)
    if placed is None:
        return None
    (x, y), inwards = placed
    wheel, holder = "Drive/Wheels/idler/", rng.choice(("arm", "slide", "eccentric", "slot"))
    entries[f"{wheel}Held by"] = holder
    if holder in ("arm", "eccentric"):
        lever = rng.uniform(2, 6) * plane.pitch
        entries[f"{wheel}Arm/Pivot in mm"] = text((x - rng.choice((-1, 1)) * lever, y))
    else:
        entries[f"{wheel}Slide/Direction in degrees"] = f"{rng.uniform(60, 120):.1f}"
    if holder in ("arm", "slide"):
        spring(rng, wheel, entries, lever if holder == "arm" else 0)
    return placed


def guide(rng, plane, entries):
    """Above the tight span, round towards the chain."""
    clear = (0.6 + 10 ** rng.uniform(-1.3, 0.3)) * plane.pitch
    ends = [clear + rng.uniform(0.1, 0.6) * plane.pitch for _ in range(2)]
    entries["Drive/Wheels/driven/Guide/Points in mm"] = text(plane.beside(0.8, ends[0], True), plane.beside(0.5, clear, True),
                                                             plane.beside(0.2, ends[1], True))
    entries["Drive/Wheels/driven/Guide/Line"] = rng.choice(("arc", "spline"))
    return True


def blade(rng, plane, entries):
    section, holder = "Drive/Wheels/driver/Guide/", rng.choice(("arm", "slide"))
    clear = (0.6 + rng.uniform(0.05, 0.4)) * plane.pitch
    entries[f"{section}Points in mm"] = text(plane.beside(0.2, clear + 0.3 * plane.pitch), plane.beside(0.5, clear),
                                             plane.beside(0.8, clear + rng.uniform(0.2, 1) * plane.pitch))
    entries[f"{section}Held by"] = holder
    entries[f"{section}Stiffness in N/m"] = f"{10 ** rng.uniform(5, 7):.3g}"
    if holder == "arm":
        entries[f"{section}Arm/Pivot in mm"] = text(plane.beside(0.85, clear + 2 * plane.pitch))
        spring(rng, section, entries, 0.35 * plane.distance)
    else:
        entries[f"{section}Slide/Direction in degrees"] = f"{rng.uniform(70, 110):.1f}"
        spring(rng, section, entries, 0)
    return True


def coupling(rng, plane, entries):
    section = f"Drive/Wheels/{rng.choice(('driver', 'driven'))}/Coupling/"
    entries[f"{section}Stiffness in N m/rad"] = f"{10 ** rng.uniform(1.5, 4.5):.3g}"
    entries[f"{section}Damping ratio"] = f"{rng.uniform(0, 0.3):.2f}"
    return True


def bearing(rng, plane, entries):
    section = f"Drive/Wheels/{rng.choice(('driver', 'driven'))}/Bearing/"
    entries[f"{section}Stiffness in N/m"] = f"{10 ** rng.uniform(6, 8.5):.3g}"
    if rng.random() < 0.3:
        entries[f"{section}Stiffness along y in N/m"] = f"{10 ** rng.uniform(6, 8.5):.3g}"
    return True


def swing(rng, plane, entries):
    section = "Drive/Wheels/driven/Swing/"
    entries[f"{section}Pivot in mm"] = text((rng.uniform(-0.1, 0.3) * plane.distance, rng.uniform(-1, 1) * plane.pitch))
    entries[f"{section}Times in ms"] = "0.01, 0.3, 0.6"
    entries[f"{section}Angles in degrees"] = f"0, {rng.uniform(-0.02, 0.02):.4f}, 0"
    return True


def imperfections(rng, plane, entries):
    wheel = f"Drive/Wheels/{rng.choice(('driver', 'driven'))}/"
    entries[f"{wheel}Runout in um"] = f"{rng.uniform(0, 300):.0f}"
    entries[f"{wheel}Index tolerance in um"] = rng.choice((0, f"{rng.uniform(0, 100):.0f}"))
    return True


def misalignment(rng, plane, entries):
    entries["Drive/Wheels/driven/Axial offset in mm"] = f"{rng.uniform(-0.03, 0.03) * plane.distance ** 0.9:.3f}"
    if rng.random() < 0.5:
        entries["Drive/Wheels/driven/Tilt in degrees"] = f"{rng.uniform(-1, 1):.2f}"
        entries["Drive/Wheels/driven/Tilt direction in degrees"] = rng.choice((0, 90))
    return True


def strands(rng, plane, entries):
    entries["Drive/Chain/Strands"] = rng.randint(2, 4)
    return True


def bush_chain(rng, plane, entries):
    entries["Drive/Chain/Rollers"] = "off"
    return True


def loads(rng, plane, entries):
    torque = float(entries["Loads/Resisting torque in N m"])
    entries["Loads/driver/Harmonics/Orders"] = "0.5, 2"
    entries["Loads/driver/Harmonics/Amplitudes in percent"] = f"{rng.uniform(0, 2):.2f}, {rng.uniform(0, 5):.2f}"
    entries["Loads/driver/Harmonics/Phases in degrees"] = "0, 90"
    entries["Loads/driven/Harmonics/Orders"] = "1"
    entries["Loads/driven/Harmonics/Amplitudes in N m"] = f"{rng.uniform(0, 1.5) * torque:.4g}"
    entries["Loads/driven/Harmonics/Phases in degrees"] = f"{rng.uniform(0, 360):.0f}"
    return True


KINDS = (idler, drum, tensioner, guide, blade, coupling, bearing, swing, imperfections, misalignment, strands, bush_chain, loads)
APART = ({"idler", "drum", "tensioner", "blade"}, {"bearing", "swing", "imperfections"}, {"imperfections", "misalignment"})  # of each at most one



def add(rng, fidelity, pitch, radii, entries):
    """Adds one to three kinds to the entries of a drive; returns their names."""
    plane, added = Plane(pitch, radii, entries["Drive/Number of links"]), []
    entries["Drive/Number of links"] = "auto"
    entries["Drive/Layout/Centre distance in mm"] = f"{plane.distance:.1f}"
    for kind in rng.sample(KINDS, len(KINDS)):
        name = kind.__name__
        if any(name in group and group & set(added) for group in APART):
            continue
        if (name in NOT_SIMPLE and fidelity == "simple") or (name in NOT_FULL and fidelity == "full"):
            continue
        if kind(rng, plane, entries):
            added.append(name)
        if name in ("tensioner", "blade"):  # whose springs decide sag and tension
            for other in ("Sag in percent", "Pretension in N"):
                entries.pop(f"Drive/Layout/{other}", None)
            entries["Drive/Layout/Centre distance from"] = "slack"
            entries["Drive/Layout/Slack in mm"] = f"{rng.uniform(0, 0.3) * pitch:.2f}"
        if len(added) == 1 + int(3 * rng.random() ** 1.5):
            break
    if fidelity not in ("simple", "layered") and {"misalignment", "strands"} <= set(added):
        entries["Effects/Separate strands"] = "off"  # else refused
    return added
