# SPDX-License-Identifier: LGPL-2.1-or-later
"""sprocket.py PROGRAM: sprockets as files for CAD, read by others.

A library for DXF finds a closed outline with the root and outside diameters and, between a roller in one gap and one in the opposite
gap, the distance over pins that the program prints; triangles of the STL file are closed and hold the volume of that outline; a
cylinder of the STEP file belongs to each arc; table and picture have the same pieces. Bad names are refused, and leave no file.
"""
import collections
import csv
import math
import pathlib
import re
import sys

import ezdxf

import program
from program import check

PROGRAM = sys.argv[1]
FORMATS = (".csv", ".dxf", ".svg", ".step", ".stl")
CASES = {  # teeth are those of the file
    "iso": ("prm/paper/simple.prm", "driver", []),
    "even": ("prm/paper/simple.prm", "driven", ["--set", "Drive/Sprockets/Tooth form=iso max"]),
    "ansi": ("prm/tutorial/06b-25-25.prm", "driver", ["--set", "Drive/Sprockets/Tooth form=ansi"]),
    "chords": ("prm/paper/simple.prm", "driver", ["--set", "Drive/Sprockets/Facets per tooth=16"]),
}


def draw(file, wheel, sets, path):
    """Writes the sprocket to `path`."""
    words = [PROGRAM, "sprocket", str(program.REPOSITORY / file), "--wheel", wheel, "--output", path]
    return program.start([*words, *sets])


class Piece:
    """An arc or a line of a DXF file, in mm, as a function of t from 0 to 1, counter-clockwise for arcs."""

    def __init__(self, entity):
        self.is_arc = entity.dxftype() == "ARC"
        if self.is_arc:
            self.centre, self.radius = entity.dxf.center, entity.dxf.radius
            self.first = math.radians(entity.dxf.start_angle)
            self.sweep = math.radians((entity.dxf.end_angle - entity.dxf.start_angle) % 360)
        else:
            self.start, self.end = entity.dxf.start, entity.dxf.end

    def at(self, t):
        if self.is_arc:
            angle = self.first + t * self.sweep
            return self.centre.x + self.radius * math.cos(angle), self.centre.y + self.radius * math.sin(angle)
        return self.start.x + t * (self.end.x - self.start.x), self.start.y + t * (self.end.y - self.start.y)

    def distance(self, p):
        """Of a point from the piece."""
        nearest = min(math.dist(p, self.at(0)), math.dist(p, self.at(1)))
        if self.is_arc:
            angle = math.atan2(p[1] - self.centre.y, p[0] - self.centre.x)
            if (angle - self.first) % (2 * math.pi) <= self.sweep:
                return abs(math.dist(p, (self.centre.x, self.centre.y)) - self.radius)
            return nearest
        d = (self.end.x - self.start.x, self.end.y - self.start.y)
        t = ((p[0] - self.start.x) * d[0] + (p[1] - self.start.y) * d[1]) / (d[0] ** 2 + d[1] ** 2)
        return math.dist(p, self.at(t)) if 0 <= t <= 1 else nearest


def area(pieces):
    """Within the closed pieces, which may be in any order and sense, by sorting them end to end."""
    rest, total = list(pieces), 0.0
    here = rest[0].at(0)
    while rest:
        i, backwards = min(((i, b) for i in range(len(rest)) for b in (0, 1)), key=lambda ib: math.dist(here, rest[ib[0]].at(ib[1])))
        piece = rest.pop(i)
        check(math.dist(here, piece.at(backwards)) < 1e-6, f"the outline is open at {here}")
        n = 4000 if piece.is_arc else 1
        points = [piece.at(abs(backwards - k / n)) for k in range(n + 1)]
        total += sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:])) / 2
        here = points[-1]
    return total


def over_pins(pieces, teeth, pin):
    """The distance over two pins that lie as deep as they can in opposite gaps."""
    deepest, outside = min(math.hypot(*piece.at(0.5)) for piece in pieces), max(math.hypot(*piece.at(0.5)) for piece in pieces) + pin
    while outside - deepest > 1e-10:
        c = 0.5 * (deepest + outside)
        if min(piece.distance((c, 0.0)) for piece in pieces) < 0.5 * pin - 1e-9:
            deepest = c
        else:
            outside = c
    return 2 * deepest * (1 if teeth % 2 == 0 else math.cos(0.5 * math.pi / teeth)) + pin


for name, (file, wheel, sets) in CASES.items():
    for suffix in FORMATS:
        done = draw(file, wheel, sets, name + suffix)
        check(done.returncode == 0, f"{name}{suffix}: {done.stderr}")
    said = done.stdout
    value = {key: float(re.search(rf"{key} +([\d.]+) mm", said)[1]) for key in ("root diameter", "outside diameter", "bore")}
    teeth = int(re.search(r"(\d+) teeth", said)[1])
    width = float(re.search(r"width ([\d.]+) mm", said)[1])
    pin, pins = map(float, re.search(r"over pins of ([\d.]+) mm: ([\d.]+) mm", said).groups())

    drawing = ezdxf.readfile(name + ".dxf")
    check(not drawing.audit().errors and drawing.units == 4, f"{name}: the drawing has errors")
    pieces = [Piece(entity) for entity in drawing.modelspace() if entity.dxf.layer == "PROFILE"]
    circles = {entity.dxf.layer: 2 * entity.dxf.radius for entity in drawing.modelspace().query("CIRCLE")}
    check(abs(circles["BORE"] - value["bore"]) < 1e-5, f"{name}: bore {circles}")
    radii = [math.hypot(*piece.at(t / 20)) for piece in pieces for t in range(21)]
    check(abs(2 * max(radii) - value["outside diameter"]) < 1e-5, f"{name}: outside diameter {2 * max(radii)}")
    if name != "chords":
        check(abs(2 * min(radii) - value["root diameter"]) < 1e-5, f"{name}: root diameter {2 * min(radii)}")
        check(abs(over_pins(pieces, teeth, pin) - pins) < 2e-5, f"{name}: {over_pins(pieces, teeth, pin)} over pins, not {pins}")
    inside = area(pieces)
    check(inside > 0, f"{name}: the outline is run through clockwise")

    numbers = list(map(float, re.findall(r"[-+]?\d[\d.e+-]*", " ".join(re.findall(r"vertex (.*)", pathlib.Path(name + ".stl").read_text())))))
    corners = list(zip(*[iter(numbers)] * 3))
    triangles = list(zip(*[iter(corners)] * 3))
    volume = sum(
        (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        for a, b, c in triangles
    )
    exact = (inside - math.pi / 4 * value["bore"] ** 2) * width
    check(abs(volume / exact - 1) < 1e-3, f"{name}: {volume} mm3 in triangles, {exact} in the drawing")
    edges = collections.Counter((t[i], t[(i + 1) % 3]) for t in triangles for i in range(3))
    check(all(edges[b, a] == n for (a, b), n in edges.items()), f"{name}: the surface is not closed")

    arcs = [piece for piece in pieces if piece.is_arc]
    text = re.sub(r"\s+", "", pathlib.Path(name + ".step").read_text())
    cylinders = re.findall(r"CYLINDRICAL_SURFACE\('',#\d+,([\d.E+-]+)\)", text)
    check("CLOSED_SHELL" in text and len(cylinders) >= len(arcs) + 1, f"{name}: {len(cylinders)} cylinders for {len(arcs)} arcs")
    check({round(float(r), 6) for r in cylinders} == {round(r, 6) for r in [p.radius for p in arcs] + [value["bore"] / 2]}, f"{name}: radii")
    rows = list(csv.DictReader(open(name + ".csv", encoding="utf-8")))
    check({round(float(row["radius (mm)"]), 6) for row in rows if row["radius (mm)"]} == {round(p.radius, 6) for p in arcs}, f"{name}: table")
    path = re.search(r'd="([^"]*)"', pathlib.Path(name + ".svg").read_text())[1]
    check(len(re.findall("[AL]", path)) == len(pieces), f"{name}: picture")

for path, words in {"a.png": "ends in one of", "nowhere/a.step": "annot", "nowhere/a.dxf": "annot", "nowhere/a.stl": "annot"}.items():
    done = draw("prm/paper/simple.prm", "driver", [], path)
    check(done.returncode != 0 and words in done.stderr, f"{path}: {done.returncode} {done.stderr}")
    check(not list(pathlib.Path(".").glob("a.*")), f"{path}: something is left")
done = draw("prm/paper/simple.prm", "idler", [], "a.dxf")
check(done.returncode == 2 and "driver, driven" in done.stderr, done.stderr)
print(f"{len(CASES)} sprockets in {len(FORMATS)} kinds of files")
