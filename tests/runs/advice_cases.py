# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program advises, and what follows it: the table of advice.py.

A row is (message, entries, followed): `message` is a regular expression of what `plan` says of a drive with
`entries`, and each of `followed` changes these as the message advises. \\1 stands for the first group of the
message; a function makes a value of all of them; None leaves the entry out. After each change the message must be
gone and the drive be accepted, unless the change has an entry "then": what is said next, and refused."""
import pathlib

# a short chain, which is meshed quickly
SMALL = {"Drive/Driver teeth": 11, "Drive/Driven teeth": 13, "Drive/Number of links": 30, "Mesh/Refinement": 0,
         "Drive/Layout/Centre distance from": "slack", "Model/Stiffness from": "dimensions"}
FULL = {**SMALL, "Model/Fidelity": "full"}
REDUCED = {**SMALL, "Model/Fidelity": "reduced"}
LAYERED = {**SMALL, "Model/Fidelity": "layered"}
GIVEN = {**SMALL, "Drive/Layout/Centre distance from": "given"}

D, C, S, L = "Drive/", "Drive/Chain/", "Drive/Sprockets/", "Drive/Layout/"
M, E, K, T, O, A = "Model/", "Effects/", "Contact/", "Time/", "Output/", "Acoustics/"
FROM, DISTANCE, LINKS = L + "Centre distance from", L + "Centre distance in mm", D + "Number of links"
FIDELITY = M + "Fidelity"
START, END, STEP = T + "Start time in ms", T + "End time in ms", T + "Time step in us"
WINDOW, WINDOW_END = O + "Window start in ms", O + "Window end in ms"
TORQUE, SPEED = "Loads/Resisting torque in N m", "Loads/Driver speed in rad/s"
RPM, POWER = "Loads/Driver speed in rpm", "Loads/Power in kW"
AFTER, AFTER_TIME = "Loads/Torque after step in N m", "Loads/Torque step time in ms"
MESH = pathlib.Path(__file__).resolve().parents[2] / "meshes/sprocket-15.msh"
MEANT = r"\1"  # the entry that the message names
NUMBER = r"([0-9.e+-]*[0-9])"


def layout():
    too_short = rf"too short; the distance must be at most {NUMBER} mm, or the chain must have at least (\d+) links"
    for links in range(84, 104, 6):
        for fidelity in ("simple", "layered"):
            yield (too_short, {LINKS: links, FROM: "given", DISTANCE: 600, FIDELITY: fidelity},
                   [{DISTANCE: r"\1"}, {LINKS: r"\2"}])
    yield (r"is too short for sprockets .*; it takes at least (\d+) links", {LINKS: 46, FROM: "slack"}, [{LINKS: r"\1"}])
    for links in (56, 60, 64):
        yield (rf"has at most {NUMBER} mm of slack before the sprockets touch; it takes at least (\d+) links",
               {LINKS: links, FROM: "slack", L + "Slack in mm": 1000},
               [{L + "Slack in mm": r"\1", "then": "closes on no route"}, {LINKS: r"\2", "then": "closes on no route"}])
    yield (rf"Centre distance in mm = 100: the sprockets overlap; it must exceed {NUMBER} mm", {FROM: "given", DISTANCE: 100},
           [{DISTANCE: 151.6, "then": "turn back"}])
    yield (rf"the sprockets overlap; for {LINKS} = auto it must exceed {NUMBER} mm", {FROM: "given", DISTANCE: 100, LINKS: "auto"},
           [{DISTANCE: 170}])
    yield (r"so that the slack span would turn back; at most (\d+) links fit", {FROM: "given", DISTANCE: 300}, [{LINKS: r"\1"}])
    for slack in (120, 400):
        yield (rf"the chain closes on no route around these sprockets; choose at most {NUMBER}\.",
               {FROM: "slack", L + "Slack in mm": slack}, [{L + "Slack in mm": r"\1"}])
    lower = {D + "Driver teeth": 9, D + "Driven teeth": 9, L + "Tight span": "lower", FROM: "sag", L + "Sag in percent": 10}
    yield ("hang down onto another one; use fewer links, a greater centre distance, or Tight span = upper",
           {**lower}, [{LINKS: 40}, {L + "Tight span": "upper"}])
    wheels, low, top = D + "Wheels/", D + "Wheels/low/", D + "Wheels/top/"
    pushed = {LINKS: "auto", FROM: "slack", wheels + "Order of travel": "driver, low, driven, top", low + "Side": "outside",
              top + "Side": "outside", low + "Teeth": 13, top + "Teeth": 13}
    centre = "Centre in mm"
    yield ("the chain .* would lie on the chain .*; choose other places",
           {**pushed, low + centre: "300, -40", top + centre: "300, 40"}, [{low + centre: "300, -60"}])
    yield (r"too short for the wheels where they are; choose other places, or at least (\d+) links",
           {**pushed, low + centre: "300, -60", top + centre: "300, 60", LINKS: 60}, [{LINKS: r"\1"}])
    yield ("but those of low and driven are auto; give all but one", {**pushed, top + centre: "300, 60"},
           [{low + centre: "300, -60"}])
    yield ("driver and low overlap: their centres are", {**pushed, low + centre: "30, 0", top + centre: "300, 60"},
           [{low + centre: "300, -60"}])
    odd = {**LAYERED, LINKS: 31}
    yield ("use one link more or less, auto, or for a chain with an offset link Model/Fidelity = simple", odd,
           [{LINKS: 30}, {LINKS: 32}, {LINKS: "auto"}, {FIDELITY: "simple"}])
    yield ("has no joints; choose taut or settled, or Model/Fidelity = layered", {L + "Start": "concentric", **SMALL},
           [{L + "Start": "taut"}, {L + "Start": "settled"}, {FIDELITY: "layered"}])
    concentric = {**LAYERED, L + "Start": "concentric", FROM: "pretension", L + "Pretension in N": 500}
    yield ("Start = concentric has no contact in its joints.*; (?:take|choose) Start = taut", concentric, [{L + "Start": "taut"}])
    pretension = {**SMALL, FROM: "pretension"}
    yield (rf"choose another one that is well above the weight of a span, {NUMBER} N, and below the working tension, or "
           "Centre distance from = slack or sag", {**pretension, L + "Pretension in N": 0.01},
           [{L + "Pretension in N": 100}, {FROM: "slack"}, {FROM: "sag"}])
    kept = {**pretension, L + "Pretension in N": 100, C + "Elongation in percent": 1, L + "Worn chain": "shafts kept"}
    yield ("shafts kept is for a chain that was laid with slack.*; choose slack, sag or given", kept,
           [{FROM: "slack"}, {FROM: "sag"}, {FROM: "given", LINKS: "auto", DISTANCE: 150}])
    yield ("stretches the chain before the start, which .* cannot do with its elastic parts; choose given, slack or sag",
           {**REDUCED, FROM: "pretension"}, [{FROM: "given", LINKS: "auto", DISTANCE: 150}, {FROM: "slack"}, {FROM: "sag"}])


def tensioners():
    wheels, low = D + "Wheels/", D + "Wheels/low/"
    held, arm, slide = low + "Held by", low + "Arm/", low + "Slide/"
    pressed = {**SMALL, LINKS: 52, FROM: "given", DISTANCE: 314, wheels + "Order of travel": "driver, low, driven",
               low + "Side": "outside", low + "Teeth": 13, low + "Centre in mm": "157, -54", held: "arm",
               arm + "Pivot in mm": "90, -90", arm + "Moment in N m": 5, arm + "Stiffness in N m/rad": 5, slide + "Force in N": 60}
    yield ("stretches the chain at the start, for which .* needs Drive/Layout/Start = settled", {**pressed, FIDELITY: "reduced"},
           [{L + "Start": "settled"}])
    yield ("is for an idler; choose bearing for a wheel with a load, or Role = idler", {**pressed, low + "Role": "driven"},
           [{held: "bearing"}, {low + "Role": "idler"}])
    yield ("moves the wheel from where it has no travel; give .*Centre in mm",
           {**pressed, low + "Centre in mm": "auto", wheels + "driven/Centre in mm": "314, 0"}, [{low + "Centre in mm": "157, -54"}])
    yield ("turns about a pivot; give .*Pivot in mm", {**pressed, arm + "Pivot in mm": "auto"}, [{arm + "Pivot in mm": "90, -90"}])
    yield ("must be at least 1 mm from Centre in mm", {**pressed, arm + "Pivot in mm": "157, -54.5"}, [{arm + "Pivot in mm": "90, -90"}])
    yield ("whose spring decides tension and sag; choose given, or slack", {**pressed, FROM: "sag"}, [{FROM: "given"}, {FROM: "slack"}])
    yield ("the chain cannot bear the spring .*; choose taut or settled", {**pressed, FIDELITY: "layered", L + "Start": "concentric"},
           [{L + "Start": "taut"}, {L + "Start": "settled"}])
    yield ("Least angle in degrees must be below Greatest angle in degrees",
           {**pressed, arm + "Least angle in degrees": 5, arm + "Greatest angle in degrees": -5}, [{arm + "Greatest angle in degrees": 20}])
    yield ("nothing presses the wheel against the chain; give one", {**pressed, arm + "Moment in N m": 0, arm + "Stiffness in N m/rad": 0},
           [{arm + "Moment in N m": 5}])
    along = {**pressed, held: "slide", slide + "Direction in degrees": 0}
    yield ("moves the wheel along the chain.*; choose another Direction in degrees", along, [{slide + "Direction in degrees": 90}])
    short = r"too short for the tensioner.*; choose another place of the wheel, or (\d+) links"
    yield (short, {**pressed, LINKS: 50, arm + "Least angle in degrees": -3}, [{LINKS: r"\1"}])
    yield (short.replace("short", "long"), {**pressed, LINKS: 90}, [{LINKS: r"\1"}])


def chain_and_sprockets():
    yield (r"is not a chain this program knows; did you mean (\w+)\?", {C + "Designation": "08BB"}, [{C + "Designation": r"\1"}])
    yield (r"is not a chain this program knows. Known are: (\w+),", {C + "Designation": "xyzzy"}, [{C + "Designation": r"\1"}])
    for outer, inner, value in (("Roller diameter", "Roller bore", 10.159), ("Bush diameter", "Bush bore", 7.429),
                                ("Pin diameter", "Pin bore", 5.239)):
        outside = {"Roller diameter": 10.16, "Bush diameter": 7.43, "Pin diameter": 5.24}[outer]
        yield (rf"leave .* of .*; at least a thousandth of the diameter is accepted, {NUMBER} mm",
               {C + inner + " in mm": value}, [{C + inner + " in mm": lambda wall, outside=outside: outside - 2 * float(wall)}])
    yield (rf"outside diameter in mm = .* must lie between {NUMBER}, where the seat ends, and {NUMBER},",
           {S + "Driver outside diameter in mm": 60},
           [{S + "Driver outside diameter in mm": r"\1"}, {S + "Driver outside diameter in mm": lambda low, high: 0.5 * (float(low) + float(high))},
            {S + "Driver outside diameter in mm": r"\2"}])
    bottoms = {S + "Driver bottom diameter in mm": 66.19, S + "Driven bottom diameter in mm": 202.27}
    yield ("needs both Driver bottom diameter in mm and Driven bottom diameter in mm; give them, or choose iso or pitch",
           {S + "Seat centre": "bottom diameter"}, [bottoms, {S + "Seat centre": "iso"}, {S + "Seat centre": "pitch"}])
    literal = {S + "Driver bottom diameter in mm": 66.41, S + "Driven bottom diameter in mm": 202.87}
    yield ("Choose Seat centre = bottom diameter with both bottom diameters, or Pitch set = standard",
           {C + "Pitch set": "paper literal"}, [{S + "Seat centre": "bottom diameter", **literal}, {C + "Pitch set": "standard"}])
    yield (rf"the bore not larger than the hub, the hub smaller than the root diameter {NUMBER} mm",
           {S + "Driver hub diameter in mm": 90}, [{S + "Driver hub diameter in mm": 60}])
    yield (rf"must be positive and less than the {NUMBER} mm between the inner plates", {S + "Width in mm": 9},
           [{S + "Width in mm": 7}])
    facets = S + "Facets per tooth"
    yield ("must be an even number from 12 on, or 0", {facets: 13}, [{facets: 12}, {facets: 14}, {facets: 0}])
    rigid = "is for rigid teeth, but those of the .* are elastic .*; choose (.*), or 0"
    yield (rigid, {**FULL, facets: 12}, [{M + "Elastic sprockets": "off"}, {facets: 0}])
    for of in ("driver", "driven"):
        yield (rigid, {**FULL, facets: 12, M + "Elastic sprockets": "off", E + f"Elastic {of}": "on"},
               [{E + f"Elastic {of}": "off"}, {facets: 0}])
    yield ("has the flanks of its mesh; choose 0", {facets: 12, S + "Driver mesh": MESH}, [{facets: 0}])
    yield ("names roller 500, but a chain of (\\d+) links has the rollers 0 to (\\d+)", {O + "Rollers": "500"}, [{O + "Rollers": r"\2"}])


def softness():
    # a start that pulls no harder than operation does
    gentle = {"Loads/Ramp time in ms": 1000, "Loads/Torque ramp angle in rad": 1}
    for torque in (17, 149, 777):
        yield (rf"Roller-tooth stiffness in N/m = .*Choose at least {NUMBER} N/m, or a smaller {TORQUE}",
               {**gentle, K + "Roller-tooth stiffness in N/m": 1e5, TORQUE: torque},
               [{K + "Roller-tooth stiffness in N/m": r"\1"}, {TORQUE: torque / 1e3}])
        yield (rf"Stiffness per pitch in N/m = .*Choose at least {NUMBER} N/m, or a smaller {TORQUE}",
               {M + "Stiffness per pitch in N/m": 1e5, TORQUE: torque},
               [{M + "Stiffness per pitch in N/m": r"\1"}, {TORQUE: torque / 1e3}])
    yield (rf"Roller-bush stiffness in N/m = .*Choose at least {NUMBER} N/m, or a smaller {TORQUE}",
           {**LAYERED, **gentle, K + "Roller-bush stiffness in N/m": 1e5}, [{K + "Roller-bush stiffness in N/m": r"\1"}, {TORQUE: 0.1}])
    yield (rf"Tooth stiffness in N/m = .*Choose at least {NUMBER} N/m, or a smaller {TORQUE}",
           {**REDUCED, K + "Tooth stiffness in N/m": 1e5}, [{K + "Tooth stiffness in N/m": r"\1"}, {TORQUE: 0.1}])
    yield (rf"Roller-tooth stiffness in N/m = .*Choose at least {NUMBER} N/m, or a smaller {AFTER}",
           {K + "Roller-tooth stiffness in N/m": 1e7, AFTER_TIME: 5, AFTER: 3333},
           [{K + "Roller-tooth stiffness in N/m": r"\1"}, {AFTER: 500}])
    yield (rf"Roller-tooth stiffness in N/m = .*Choose at least {NUMBER} N/m, or a smaller {L}Pretension in N",
           {K + "Roller-tooth stiffness in N/m": 1e7, FROM: "pretension", L + "Pretension in N": 70000},
           [{L + "Pretension in N": 700}])


def times():
    for safety in (0.3, 0.77):
        for stiffness in (1e8, 2e8):
            yield (rf"is above the critical time step: at most {NUMBER} us .* choose a smaller step or auto",
                   {STEP: 50, T + "Safety factor": safety, K + "Roller-tooth stiffness in N/m": stiffness},
                   [{STEP: r"\1"}, {STEP: "auto"}])
    yield ("must be above Time/Start time in ms", {END: 5, START: 6, WINDOW: 6}, [{END: 30, WINDOW: 10}])
    yield ("longer than the whole run.*; choose a smaller step or auto", {STEP: 60000}, [{STEP: 0.1}, {STEP: "auto"}])
    yield ("longer than the whole run.*; choose a shorter interval", {O + "History interval in us": 60000},
           [{O + "History interval in us": 10}])
    yield ("nothing would be averaged.*; begin the window earlier or run longer", {WINDOW: 40}, [{WINDOW: 10}, {END: 80}])
    yield ("Window end in ms must be above Output/Window start in ms", {WINDOW: 10, WINDOW_END: 5}, [{WINDOW_END: 20}])
    yield ("lies after the end of the run.*; end the window earlier, choose auto, or run longer", {WINDOW_END: 60},
           [{WINDOW_END: 20}, {WINDOW_END: "auto"}, {END: 60}])
    yield ("leave Window end in ms auto", {WINDOW: "settled", WINDOW_END: 20}, [{WINDOW_END: "auto"}])
    yield ("counts the pitches that the driver takes in, but .* = 0; give a time", {WINDOW: "settled", SPEED: 0}, [{WINDOW: 10}])
    yield ("give a time, or choose Elastic links = all", {**REDUCED, WINDOW: "settled", M + "Elastic links": "region of interest",
                                                           M + "Other links": "rigid", END: 3},
           [{WINDOW: 1}, {M + "Elastic links": "all"}])
    yield ("are allowed: choose a larger Time/Time step in us or an earlier Time/End time in ms", {STEP: 1e-8}, [{STEP: 0.1}])


def models():
    none = "in which no body is elastic; choose auto or off"
    yield ("Symmetry model = true is for elastic bodies: .* has none[;.]", {M + "Symmetry model": "true"}, [{M + "Symmetry model": "auto"}])
    yield ("Cells along = 2 leaves one ring.*needs at least 4", {**REDUCED, "Mesh/Inner link/Cells along": 2},
           [{"Mesh/Inner link/Cells along": 4}])
    yield ("Mass per pitch in g is that of the parts in .*: leave it auto", {**REDUCED, M + "Mass per pitch in g": 10},
           [{M + "Mass per pitch in g": "auto"}])
    yield (r"\(Drive/Layout/Start = settled\): leave it auto", {**REDUCED, M + "Stiffness per pitch in N/m": 3e8},
           [{M + "Stiffness per pitch in N/m": "auto"}, {L + "Start": "settled"}])
    yield ("leave them auto and choose Penalty factor", {**FULL, K + "Roller-tooth stiffness in N/m": 3e8},
           [{K + "Roller-tooth stiffness in N/m": "auto", K + "Penalty factor": 1}])
    exact, modes = K + "Enforcement", "Reduction/Modes up to in kHz"
    yield ("is for bodies that deform in modes, which .* has not; choose penalty, or Model/Fidelity = reduced",
           {**LAYERED, exact: "exact joints"}, [{exact: "penalty"}, {FIDELITY: "reduced"}])
    yield (rf"is too low for .* joints, .*; choose at least {NUMBER}, or auto", {**REDUCED, exact: "exact joints", modes: 60},
           [{modes: r"\1"}, {modes: "auto"}])
    yield ("but Effects/Elastic links is off; choose on, or Enforcement = penalty",
           {**REDUCED, exact: "exact joints", E + "Elastic links": "off"}, [{E + "Elastic links": "on"}, {exact: "penalty"}])
    yield ("but Model/Elastic links = region of interest; choose all, or Enforcement = penalty",
           {**REDUCED, exact: "exact joints", M + "Elastic links": "region of interest", END: 3, WINDOW: 1},
           [{M + "Elastic links": "all"}, {exact: "penalty"}])
    yield ("has the flanks of its mesh; choose Enforcement = exact joints",
           {**REDUCED, exact: "exact", D + "Driver teeth": 15, D + "Number of links": 34, S + "Driver mesh": MESH,
            S + "Driver outside diameter in mm": 81.8, S + "Driver hub diameter in mm": 33, S + "Driver bore in mm": 25},
           [{exact: "exact joints"}])
    yield ("lets nothing overlap that could be damped, but Effects/Contact damping is on; choose auto, or Enforcement = penalty",
           {**REDUCED, exact: "exact", E + "Contact damping": "on"}, [{E + "Contact damping": "auto"}, {exact: "penalty"}])
    yield ("Plate faces = on is for elastic bodies: .* has none; choose off", {K + "Plate faces": "on"}, [{K + "Plate faces": "off"}])
    yield (none, {M + "Elastic sprockets": "on"}, [{M + "Elastic sprockets": "auto"}, {M + "Elastic sprockets": "off"}])
    yield ("in which no link is elastic; choose all, or Fidelity = full", {**SMALL, M + "Elastic links": "region of interest", END: 3, WINDOW: 1},
           [{M + "Elastic links": "all"}, {FIDELITY: "full"}])
    yield ("leaves no link that is not reduced; choose rigid, or Elastic links = all",
           {**REDUCED, M + "Elastic links": "region of interest", M + "Other links": "reduced", END: 3, WINDOW: 1},
           [{M + "Other links": "rigid"}, {M + "Elastic links": "all"}])
    for name in ("Elastic links", "Elastic rollers", "Elastic driver", "Elastic driven", "Plate bending", "Tooth compliance"):
        full = {FIDELITY: "full"}
        if name == "Tooth compliance":
            full["then"] = "for elastic rollers on a rigid sprocket"
        yield (none + ", or Model/Fidelity = full", {**SMALL, E + name: "on"}, [{E + name: "auto"}, {E + name: "off"}, full])
    planar = "Planar motion = on is not possible: .*; choose auto or off"
    for more in (FULL, REDUCED):
        yield (planar, {**more, E + "Planar motion": "on"}, [{E + "Planar motion": "auto"}, {E + "Planar motion": "off"}])
    arriving = {**FULL, M + "Elastic links": "region of interest", END: 3, WINDOW: 1}
    for entry in (E + "Elastic driver", E + "Elastic driven", M + "Elastic sprockets"):
        yield ("in which all sprockets are rigid; choose auto or off, or Elastic links = all", {**arriving, entry: "on"},
               [{entry: "auto"}, {entry: "off"}, {M + "Elastic links": "all"}])
        yield ("whose nodes touch the teeth, but Effects/Elastic rollers = off; choose auto for one of them",
               {**FULL, entry: "on", E + "Elastic rollers": "off"}, [{entry: "auto"}, {E + "Elastic rollers": "auto"}])
        yield ("is not possible with reduced bodies .*; choose auto or off, or Fidelity = full", {**REDUCED, entry: "on"},
               [{entry: "auto"}, {entry: "off"}, {FIDELITY: "full"}])
    yield ("needs plates of finite elements, and not reduced bodies .*; choose off, or Fidelity = full",
           {**REDUCED, K + "Plate faces": "on"}, [{K + "Plate faces": "off"}, {FIDELITY: "full"}])
    others = {**arriving, M + "Other links": "reduced"}
    yield ("needs plates of finite elements, and not reduced bodies .*; choose off", {**others, K + "Plate faces": "on"},
           [{K + "Plate faces": "off"}])
    yield ("Plate bending = off is for plates of finite elements.*; choose auto, or Fidelity = full",
           {**REDUCED, E + "Plate bending": "off"}, [{E + "Plate bending": "auto"}, {FIDELITY: "full"}])
    yield ("Plate bending = off is for plates of finite elements.*; choose auto", {**others, E + "Plate bending": "off"},
           [{E + "Plate bending": "auto"}])
    compliance = "Tooth compliance = on is for elastic rollers on a rigid sprocket, but .*; choose auto or off"
    for more in ({}, {E + "Elastic rollers": "off"}):
        yield (compliance, {**FULL, E + "Tooth compliance": "on", **more}, [{E + "Tooth compliance": "auto"}, {E + "Tooth compliance": "off"}])
    for more in ({E + "Elastic links": "off"},):
        yield ("Plate bending = on needs elastic links; choose Effects/Elastic links = on, or Plate bending = auto",
               {**FULL, E + "Plate bending": "on", **more}, [{E + "Elastic links": "on"}, {E + "Plate bending": "auto"}])
    for name in ("links", "rollers"):
        yield (rf"Symmetry model = true needs elastic links and rollers, .* but Effects/Elastic {name} is off .*; choose on, or Symmetry model "
               "= auto", {**FULL, M + "Symmetry model": "true", E + f"Elastic {name}": "off"},
               [{E + f"Elastic {name}": "on"}, {M + "Symmetry model": "auto"}])


def effects():
    for name, entry, value in (("Friction", K + "Friction coefficient", 0.1), ("Contact damping", K + "Damping ratio", 0.1),
                               ("Gravity", "Loads/Gravity in m/s2", 9.81), ("Drag", "Loads/Drag in 1/s", 1),
                               ("Chain damping", M + "Chain damping ratio", 0.01)):
        yield (f"Effects/{name} = on contradicts {entry} = 0; give a value above zero, or choose auto or off",
               {E + name: "on", entry: 0}, [{entry: value}, {E + name: "auto"}, {E + name: "off"}])
    own = K + "Roller-tooth friction"
    yield (f"Effects/Friction = on contradicts {own} = 0; give a value above zero, or choose auto or off",
           {E + "Friction": "on", own: 0, K + "Friction coefficient": 0.2}, [{own: 0.1}, {E + "Friction": "auto"}, {E + "Friction": "off"}])
    yield ("has no bars: .* damps its joints. Choose auto or off", {**LAYERED, E + "Chain damping": "on"},
           [{E + "Chain damping": "auto"}, {E + "Chain damping": "off"}])
    for name in ("Roller-bush", "Bush-pin"):
        yield ("which has no joints; choose auto or off, or Model/Fidelity = layered", {**SMALL, E + f"{name} clearance": "on"},
               [{E + f"{name} clearance": "auto"}, {E + f"{name} clearance": "off"}, {FIDELITY: "layered"}])


def quantities():
    quantity = O + "Quantities"
    for name, group in (("links", "plate stress"), ("rollers", "surface velocity")):
        for fidelity in ("simple", "layered"):
            yield (rf"Quantities = {group} needs Effects/Elastic {name}, which .* has not; choose Model/Fidelity = full, or leave {group} out",
                   {**SMALL, FIDELITY: fidelity, quantity: group}, [{FIDELITY: "full"}, {quantity: "all"}])
        yield (rf"Quantities = {group} needs Effects/Elastic {name}, which is off .*; choose on, or leave {group} out",
               {**FULL, quantity: group, E + f"Elastic {name}": "off"}, [{E + f"Elastic {name}": "on"}, {quantity: "all"}])
    yield ("needs joints .*; choose Model/Fidelity = layered or full, or leave joint forces out", {**SMALL, quantity: "joint forces"},
           [{FIDELITY: "layered"}, {FIDELITY: "full"}, {quantity: "all"}])
    yield ("needs an interval, but .* = 0 writes none; give one above zero, or leave fields out",
           {quantity: "fields", O + "Field interval in ms": 0}, [{O + "Field interval in ms": 1}, {quantity: "all"}])
    noise = {A + "Noise": "on"}
    yield ("needs the motion of the rollers; add roller motion to Output/Quantities", {**noise, quantity: "tooth forces"},
           [{quantity: "tooth forces, roller motion"}])
    yield ("needs the motion of all rollers, .*; choose all", {**noise, O + "Rollers": "1,2"}, [{O + "Rollers": "all"}])
    yield ("needs pitch times, but Loads/Driver speed in rad/s = 0[;.]", {**noise, SPEED: 0}, [{SPEED: 100}, {A + "Noise": "off"}])
    for interval in (31, 17, 7.3):
        yield (rf"Highest frequency in kHz = 100 is too high: .* tells of {NUMBER} kHz at most. Choose a lower one, or run with a shorter Output/History interval",
               {**noise, O + "History interval in us": interval, A + "Highest frequency in kHz": 100},
               [{A + "Highest frequency in kHz": r"\1"}, {O + "History interval in us": 2}])
    yield (rf"tell nothing of the tooth frequency of .* Hz. Run with an interval of at most {NUMBER}\.",
           {**noise, O + "History interval in us": 3000}, [{O + "History interval in us": r"\1"}])
    yield (rf"must lie below the drive and all observers, whose lowest is at y = {NUMBER} m", {**noise, A + "Floor height in m": 1},
           [{A + "Floor height in m": lambda y: float(y) - 0.01}])
    yield (rf"at least a pitch of {NUMBER} mm before or behind its plane, or outside of its radius of {NUMBER} mm",
           {**noise, A + "Observers": "0 0 0.001"},
           [{A + "Observers": lambda pitch, _: f"0 0 {1e-3 * float(pitch):.9g}"}])
    yield ("Choose a longer Drive/Chain/Roller length in mm, or no noise", {**noise, C + "Roller length in mm": 2, S + "Width in mm": 1},
           [{C + "Roller length in mm": 7}, {A + "Noise": "off"}])


def loads():
    yield ("needs a speed, but that of the driver is zero; give .*Loads/Resisting torque in N m", {POWER: 3, SPEED: 0},
           [{POWER: None, TORQUE: 10, WINDOW: 10}])
    yield ("are two forms of one quantity: give one of them", {POWER: 3, TORQUE: 10}, [{POWER: None}, {TORQUE: None}])
    yield ("are two forms of one quantity: give one of them", {RPM: 300, SPEED: 10}, [{RPM: None}, {SPEED: None}])


def warnings():
    """Design checks: what is advised silences them."""
    for torque in (700, 1313, 5000):
        yield (rf"breaks at .* or a {TORQUE} of at most {NUMBER}[,.]", {TORQUE: torque}, [{TORQUE: r"\1"}, {C + "Designation": "24B"}])
        yield (rf"breaks at .* or a {TORQUE} of at most {NUMBER}[,.]", {TORQUE: torque, SPEED: 300, FROM: "sag"}, [{TORQUE: r"\1"}])
        yield (rf"breaks at .* or a {TORQUE} of at most {NUMBER}[,.]",
               {TORQUE: torque, FROM: "pretension", L + "Pretension in N": 1500}, [{TORQUE: r"\1"}])
        yield (rf"breaks at .* which is a {POWER} of {NUMBER}\.", {POWER: torque * 0.0431, RPM: 1153}, [{POWER: r"\1"}])
        yield (rf"breaks at .* or a {AFTER} from -{NUMBER} to {NUMBER}\.", {AFTER: torque, AFTER_TIME: 5}, [{AFTER: r"\1"}, {AFTER: r"-\1"}])
    yield ("joints carry .*: choose a larger chain, or larger sprockets for the same power", {POWER: 30, RPM: 1000},
           [{C + "Designation": "24B"}, {D + "Driver teeth": 60, D + "Driven teeth": 168, LINKS: 300}])
    yield ("usually transmits .*: choose a larger chain, more teeth or less power", {POWER: 10, RPM: 1200, C + "Designation": "08B"},
           [{C + "Designation": "16B"}, {D + "Driver teeth": 40}, {POWER: 1}])
    yield (rf"gall above {NUMBER} rpm.*: choose a smaller pitch or a lower Loads/Driver speed", {SPEED: 700}, [{SPEED: lambda rpm: 0.1047 * float(rpm)},
                                                                                               {C + "Designation": "05B"}])
    yield (rf"gall above {NUMBER} rpm.*: choose a smaller pitch or a lower Loads/Driver speed", {RPM: 7000}, [{RPM: r"\1"}])
    yield ("degrees only, 120 or more are usual: take more links for a larger centre distance, or a smaller ratio",
           {D + "Driver teeth": 11, D + "Driven teeth": 90, LINKS: 100}, [{LINKS: 200}, {D + "Driven teeth": 30}])
    yield (r"degrees only, 120 or more are usual: take a larger Drive/Layout/Centre distance in mm with more links, or a smaller ratio",
           {D + "Driver teeth": 11, D + "Driven teeth": 90, LINKS: "auto", FROM: "given", DISTANCE: 380},
           [{DISTANCE: 1000}, {D + "Driven teeth": 30}])
    yield (r"take at least (\d+) teeth, better 17", {D + "Driver teeth": 10}, [{D + "Driver teeth": r"\1"}, {D + "Driver teeth": 17}])
    sag = "the chain may jump teeth. Take "
    yield (sag + "a smaller Drive/Layout/Slack in mm", {FROM: "slack", L + "Slack in mm": 40}, [{L + "Slack in mm": 5}])
    yield (sag + "a smaller Drive/Layout/Sag in percent", {FROM: "sag", L + "Sag in percent": 10}, [{L + "Sag in percent": 3}])
    yield (sag + "fewer links or a larger Drive/Layout/Centre distance in mm", {FROM: "given", DISTANCE: 619},
           [{LINKS: 107}, {DISTANCE: 643}])
    yield ("driven inertia on the tight span at .*: change the speed, the number of teeth or Model/Driven inertia in kg m2",
           {SPEED: 93.1}, [{SPEED: 120}, {D + "Driver teeth": 25}, {M + "Driven inertia in kg m2": 0.1}])
    for ramp in (1, 0.37):
        for inertia in (0.1, 3.1):
            yield (rf"times as much as in operation: choose Loads/Ramp time in ms of at least {NUMBER}, or Drive/Layout/Start = settled",
                   {"Loads/Ramp time in ms": ramp, M + "Driven inertia in kg m2": inertia},
                   [{"Loads/Ramp time in ms": r"\1"}, {L + "Start": "settled"}])
    few = rf"means and peaks settle over ten or more: choose {END} of at least {NUMBER}"
    for end in (13, 14, 17):
        yield (few, {WINDOW: 12.3, END: end}, [{END: r"\1"}])
    yield (rf"means and peaks settle over ten or more: choose {WINDOW_END} of at least {NUMBER}", {WINDOW: 12.3, END: 100, WINDOW_END: 14},
           [{WINDOW_END: r"\1"}])
    yield (rf"means and peaks settle over ten or more: choose {END} and {WINDOW_END} of at least {NUMBER}",
           {WINDOW: 12.3, END: 15, WINDOW_END: 14}, [{WINDOW_END: r"\1", END: r"\1"}])
    yield ("choose a larger Output/Window length in pitches", {WINDOW: "settled", O + "Window length in pitches": 3},
           [{O + "Window length in pitches": 20}])
    swings = rf"swings do not cancel in means over so few: choose {END} of at least {NUMBER}, or Output/Window start in ms = settled"
    yield (swings, {M + "Driven inertia in kg m2": 3, END: 60, "Loads/Ramp time in ms": 100}, [{END: r"\1"}, {WINDOW: "settled"}])
    yield (rf"start-up is not over before {NUMBER} ms, a pitch after the ramp: choose a later Output/Window start in ms, or settled",
           {WINDOW: 5, END: 100}, [{WINDOW: r"\1"}, {WINDOW: "settled"}])


def misspelt():
    """Names of entries: the suggestion takes the value."""
    for wrong, value in (("Model/Fidelty", "layered"), ("Loads/Driver sped in rad/s", 100), ("Drive/Layuot/Slack in mm", 1),
                         ("Slack in mm", 1), ("Output/Widow start in ms", 5), ("Model/Slack in mm", 1)):
        yield (r"[dD]id you mean '([^']+)'\?", {wrong: value}, [{wrong: None, MEANT: value}])
    for wrong, value in (("Time/End time in s", "0.03"), ("Drive/Chain/Pitch in inch", "0.625"), ("Loads/Power in W", "1500")):
        yield (rf"Did you mean '([^']+)'\? .* are {NUMBER} ", {wrong: value}, [{wrong: None, MEANT: r"\2"}])


TABLES = (layout, tensioners, chain_and_sprockets, softness, times, models, effects, quantities, loads, warnings, misspelt)
