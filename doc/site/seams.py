# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of each seam of doc/architecture.md: who calls the interface, what it asks for, who implements it.

What the interface asks for and who implements it is read from the code. Who calls it is written below; each name must be in the file that
is said to have it, so that a picture which is no longer true stops the build.
"""
import dataclasses
import functools
import html
import pathlib
import re

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


@dataclasses.dataclass
class Code:
    """Something in a file: its title, the file, and names that the file has."""
    title: str
    file: str
    names: tuple = ()


@dataclasses.dataclass
class Interface:
    """A class that others implement: its virtual functions are read from its header."""
    title: str
    file: str


@dataclasses.dataclass
class Implementations:
    """All classes derived from this one, wherever they are."""
    of: str


@dataclasses.dataclass
class Seam:
    room: str
    text: str
    stages: list  # from left to right, each a list of what is above


def calls(title, file, *names):
    return Code(title, file, names)


SEAMS = {
    "quantity": Seam("observe", "The recorder calls all quantities in this order; each registers itself and is created only if the scene has it.", [
        [calls("Recorder", "source/observe/recorder.cc", "make_quantities", "reads_contacts", "add_channels", "update", "gather", "begin_interval",
               "serialize", "summarize")],
        [Interface("Quantity", "include/chaindrive/observe/quantity.h"),
         Code("Registered&lt;T&gt;", "include/chaindrive/observe/quantity.h", ("exists", "Registration"))],
        [Implementations("Quantity")]]),
    "addition to a scene": Seam("scene", "When all bodies of a drive are there, each addition that is active changes its scene, after those that it names.", [
        [calls("build_scene()", "source/scene/build.cc", "add_additions")],
        [Code("Addition&lt;T&gt;", "include/chaindrive/scene/addition.h", ("add_to", "AdditionRegistration", "AdditionSection"))],
        [Code("entries", "include/chaindrive/parameters/sections.h", ("Section", "SectionOf", "Sections"))]]),
    "term of a speed or torque": Seam("functions", "A shaft's program adds the terms that its sections ask for; each registers itself, for speeds or for torques.", [
        [calls("make_program()", "source/drive/programs.cc", "make_terms", "lasting_torque")],
        [Code("TermOf&lt;T&gt;", "include/chaindrive/functions/terms.h", ("make", "TermRegistration", "TermSection", "Term", "Variable"))],
        [Code("tables", "source/functions/terms/table.cc", ("TermOf",)),
         Code("harmonics", "source/functions/terms/harmonics.cc", ("TermOf",)),
         Code("changes of speed", "source/functions/terms/changes.cc", ("TermOf",)),
         Code("torque of speed", "source/functions/terms/resistance.cc", ("TermOf",))]]),
    "element block": Seam("element", "A part is a list of blocks. Bodies ask for the forces of a batch, statics and reduction for stiffness, results for stresses.", [
        [calls("ElasticPart", "source/element/elastic_part.cc", "add_forces"),
         calls("assemble()", "source/element/element_block.cc", "unknowns_per_node", "nodes_of", "element_stiffness"),
         calls("ElasticBodies", "source/bodies/elastic_bodies.cc", "make_stress_recovery"),
         calls("ReducedBodies", "source/bodies/reduced_bodies.cc", "make_stress_recovery")],
        [Interface("ElementBlock", "include/chaindrive/element/element_block.h"),
         Interface("StressRecovery", "include/chaindrive/element/stress.h")],
        [Implementations("ElementBlock"), Implementations("StressRecovery")]]),
    "body group": Seam("bodies", "The calls of one step, in order; the table in source/dynamics/system.cc says to which instant every array belongs.", [
        [calls("System::advance(), once", "source/dynamics/system.cc", "start"),
         calls("1. first_half()", "source/dynamics/newmark.cc", "kick", "drift"),
         calls("2. evaluate()", "source/dynamics/system.cc", "add_forces"),
         calls("3. Contacts, through World", "source/bodies/world.cc", "place_surface", "gather_forces"),
         calls("4. evaluate()", "source/dynamics/system.cc", "advance", "advance_shared"),
         calls("5. second_half()", "source/dynamics/newmark.cc", "kick", "finish"),
         calls("Relaxation", "source/dynamics/relaxation.cc", "use_forces"),
         calls("critical time step", "source/stability/closed_contact.cc", "critical_time_step", "modal_matrix", "largest_frequency"),
         calls("pictures, stresses", "source/observe/elastic_bodies.cc", "nodes_now", "stress_recoveries"),
         calls("make_world()", "source/bodies/make_world.cc", "add")],
        [Interface("BodyGroup", "include/chaindrive/bodies/body_group.h"),
         Interface("ForceGroup", "include/chaindrive/bodies/body_group.h"),
         Interface("SurfaceGroup", "include/chaindrive/bodies/body_group.h"),
         Interface("ElasticGroup", "include/chaindrive/bodies/elastic_group.h"),
         Interface("NodalGroup", "include/chaindrive/bodies/elastic_group.h"),
         Interface("ModalGroup", "include/chaindrive/bodies/elastic_group.h")],
        [Implementations("BodyGroup"), Implementations("ForceGroup"), Implementations("SurfaceGroup")]]),
    "force element": Seam("forces", "A scene lists its elements, and a system works on its own copies. Bars are one kind.", [
        [calls("System", "source/dynamics/system.cc", "clone", "add_forces", "serialize"),
         calls("step limit", "source/stability/step_limit.cc", "add_springs", "name"),
         calls("who looks for faults", "source/dynamics/fault_diagnosis.cc", "forces", "name")],
        [Interface("ForceElement", "include/chaindrive/forces/force_element.h")],
        [Implementations("ForceElement")]]),
    "surface": Seam("contact", "For each nearby slave: the nearest point, the closing velocity, and, after the contact law, the opposite force.", [
        [calls("SurfaceContact: search", "source/contact/surface_contact.cc", "needs_search", "is_near"),
         calls("PointContact", "source/contact/point_contact.cc", "is_beside", "project", "relative_velocity", "slip_velocity", "add_opposite", "main_direction"),
         calls("NodeContact", "source/contact/node_contact.cc", "half_width", "project", "relative_velocity", "slip_velocity", "add_opposite", "closed_side")],
        [Interface("Surface", "include/chaindrive/contact/surface.h")],
        [Implementations("Surface")]]),
    "slave set": Seam("contact", "A family holds the slaves of one kind of interface; Contacts calls all families in this order.", [
        [calls("Contacts", "source/contact/contacts.cc", "needs_search", "search", "announce", "place_surfaces", "fetch", "add_forces", "send_forces",
               "gather_forces", "add_springs"),
         calls("critical time step", "source/stability/coupled_modes.cc", "closed_pairs")],
        [Interface("Family", "include/chaindrive/contact/family.h")],
        [Implementations("Family")],
        [Code("points with a radius", "include/chaindrive/contact/surface_contact.h", ("SlavePoint",)),
         Code("SlaveNodes", "include/chaindrive/contact/slave_nodes.h", ("position", "velocity", "area", "cover", "announce"))]]),
    "contact law": Seam("contact", "The same code for one point and for packs of eight: an approach gives penetration and closing speed, update_touch() turns them into forces and energies.", [
        [calls("penalty_force()", "include/chaindrive/contact/point_force.h", "update_touch"),
         calls("joints, side by side", "include/chaindrive/contact/packed_joint.h", "update_touch")],
        [Code("update_touch()", "include/chaindrive/contact/penalty.h", ("ContactEnergies", "TouchStateOf"))],
        [Code("PointApproach", "include/chaindrive/contact/penalty.h", ("gap", "rate", "penetration", "book")),
         Code("NodeApproach", "include/chaindrive/contact/penalty.h", ("mean_penetration", "gap", "rate", "closing", "penetration", "book")),
         Code("ContactLaw", "include/chaindrive/scene/contact_law.h", ("stiffness", "damping", "friction"))]]),
    "observer": Seam("dynamics", "The time loop shows the system to all observers before the first step and after each step; a checkpoint holds their state.", [
        [calls("run()", "source/dynamics/time_loop.cc", "advance", "observe"),
         calls("Checkpoints", "source/observe/checkpoints.cc", "name", "serialize")],
        [Interface("Observer", "include/chaindrive/dynamics/observer.h"),
         Code("Services", "include/chaindrive/dynamics/services.h", ("stop_run", "ask", "asked", "gather_records", "write_state", "timer"))],
        [Implementations("Observer")]]),
    "fidelity": Seam("scene", "A fidelity is a row of capabilities and a builder; everything else sees bodies, bars and interfaces.", [
        [Code("register_fidelity()", "include/chaindrive/parameters/fidelity.h", ("register_fidelity", "fidelities", "capabilities_of")),
         Code("Capabilities", "include/chaindrive/parameters/fidelity.h", ("has_clearances", "is_elastic", "is_reduced"))],
        [Code("Model", "include/chaindrive/model/model.h", ("fidelity", "effects"))],
        [Code("build_scene()", "source/scene/build.cc", ("builder_of",)),
         Code("Fidelity", "include/chaindrive/scene/fidelity.h", ("Builder", "builder_of"))],
        [Code("simple", "source/scene/simple.cc", ("add_simple_chain",)),
         Code("layered", "source/scene/layered.cc", ("add_layered_chain",)),
         Code("reduced, full", "source/scene/full.cc", ("add_full_chain",)),
         Code("sprockets of all", "source/scene/sprockets.cc", ("add_sprockets",))],
        [Code("Scene", "include/chaindrive/scene/scene.h", ("bodies", "sprockets", "effects"))]]),
    "sprocket": Seam("drive", "Lists of sprockets and of the spans between them, in the order in which the chain runs over them.", [
        [Code("Drive", "include/chaindrive/drive/drive.h", ("sprockets",))],
        [Code("Layout", "include/chaindrive/drive/layout.h", ("sprockets", "spans"))],
        [Code("builders", "source/scene/sprockets.cc", ("add_sprockets",))],
        [Code("Scene", "include/chaindrive/scene/scene.h", ("sprockets",))]]),
    "command": Seam("program", "A row of the table of commands and a case in main(); manual page and completion are generated from the rows.", [
        [Code("main()", "source/main.cc", ("parse_command_line", "CommandLine"))],
        [Code("table of commands", "source/command_line.cc", ("CommandName", "find_command")),
         Code("manual page, completion", "source/command_texts.cc", ("man_page", "bash_completion"))],
        [Code("commands", "include/chaindrive/commands.h", ("run_command", "plan_command", "parts_command", "noise_command", "study_command", "report_command",
                                                           "template_command"))]]),
    "section of a report": Seam("program", "A report is a list of sections, each with figures and tables of one or several runs.", [
        [Code("write()", "python/chaindrive/report/__init__.py", ("write", "_lead", "_sections"))],
        [Code("sections", "python/chaindrive/report/__init__.py", ("answers", "checks", "motion", "spans", "rollers", "impacts", "vibration", "noise", "cost"))],
        [Code("curves", "python/chaindrive/report/curves.py", ("tensions", "contact_forces", "energies")),
         Code("facts", "python/chaindrive/report/facts.py", ("checks", "drive_tables", "statistics_tables"))]]),
}


def table(first):
    """{first column: the others} of the table of doc/architecture.md whose first heading is `first`."""
    lines = (REPOSITORY / "doc/architecture.md").read_text().splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith(f"| {first} |"))
    rows = {}
    for line in lines[start + 2:]:
        if not line.startswith("|"):
            break
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        rows[cells[0]] = cells[1:]
    return rows


@functools.cache
def text_of(file):
    path = REPOSITORY / file
    if not path.is_file():
        raise SystemExit(f"doc/site/seams.py: there is no file {file}")
    return path.read_text()


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


@functools.cache
def classes():
    """(class, its bases, its file) of all headers and sources."""
    found = []
    for folder in ("include", "source"):
        for path in sorted((REPOSITORY / folder).rglob("*")):
            if path.suffix in (".h", ".cc"):
                for name, bases in re.findall(r"^(?:class|struct) (\w+)(?: final)?\s*:\s*([^{;]*)\{", without_comments(path.read_text()), re.MULTILINE):
                    short = [re.sub(r"<.*", "", base).split()[-1].split("::")[-1] for base in bases.split(",")]
                    found.append((name, short, path.relative_to(REPOSITORY).as_posix()))
    return found


def derived(base, depth=0):
    """(depth, class, file) of everything derived from `base`, those of one class below it."""
    out = []
    for name, bases, file in classes():
        if base in bases:
            out += [(depth, name, file), *derived(name, depth + 1)]
    return out


def virtuals(interface):
    """(function, whether it must be implemented) of a class, in the order of its header."""
    text = without_comments(text_of(interface.file))
    match = re.search(rf"^class {interface.title}\b[^;{{]*\{{(.*?)^\}};", text, re.MULTILINE | re.DOTALL)
    if not match:
        raise SystemExit(f"doc/site/seams.py: {interface.file} has no class {interface.title}")
    found = re.findall(r"\bvirtual\s+(?!~)[^;{]*?(\w+)\s*\((?:[^()]|\([^()]*\))*\)([^;{]*)[;{]", match[1])
    if not found:
        raise SystemExit(f"doc/site/seams.py: {interface.title} of {interface.file} has no virtual functions")
    return [(name, re.search(r"=\s*0", rest) is not None) for name, rest in found]


def scope(interface):
    """The class with its namespace."""
    before = text_of(interface.file).split(f"class {interface.title}\n")[0]
    return f"{re.findall(r'^namespace ([a-z:]+)$', before, re.MULTILINE)[-1]}::{interface.title}"


def short(file):
    return re.sub(r"^(include/chaindrive|source|python/chaindrive)/", "", file)


def node(item):
    """A box of dot: a heading and rows."""
    head, rows, color, where = "", [], "#f4f4f4", ""
    if isinstance(item, Implementations):
        found = derived(item.of)
        if not found:
            raise SystemExit(f"doc/site/seams.py: nothing is derived from {item.of}")
        head, color = f"{len(found)} derived from {item.of}" if len(found) > 1 else f"derived from {item.of}", "#e6f0e6"
        rows = [f"{'&nbsp;' * 4 * depth}<B>{name}</B>&nbsp; <FONT COLOR=\"#666666\">{short(file)}</FONT>" for depth, name, file in found]
    elif isinstance(item, Interface):
        head, where, color = f"<B>{item.title}</B>", short(item.file), "#dde8f5"
        rows = [f"<B>{name}()</B> = 0" if pure else f"{name}()" for name, pure in virtuals(item)]
    else:
        text = text_of(item.file)
        for name in (*item.names, *re.findall(r"(\w+)\(\)", item.title)):
            if not re.search(rf"\b{re.escape(name)}\b", text):
                raise SystemExit(f"doc/site/seams.py: {item.file} has no {name}")
        head, where, rows = item.title, short(item.file), [html.escape(name) for name in item.names]
    room = "&nbsp;" * 4  # browsers have other fonts than dot thinks
    cells = [f'<TR><TD BGCOLOR="{color}" ALIGN="LEFT">{head}{room}</TD></TR>']
    if where:
        cells.append(f'<TR><TD BGCOLOR="{color}" ALIGN="LEFT"><FONT COLOR="#666666">{where}</FONT>{room}</TD></TR>')
    cells += [f'<TR><TD ALIGN="LEFT">{row}{room}</TD></TR>' for row in rows]
    return '<<TABLE BORDER="1" CELLBORDER="0" CELLSPACING="0" CELLPADDING="2" COLOR="#888888">' + "".join(cells) + "</TABLE>>"


def picture(seam):
    lines = ["digraph seam {", "rankdir=LR; ranksep=0.5; nodesep=0.15;", 'node [shape=plain, fontname="Helvetica", fontsize=10];', 'edge [color="#888888"];']
    names = []
    for s, stage in enumerate(seam.stages):
        names.append([f"n{s}_{k}" for k in range(len(stage))])
        for name, item in zip(names[-1], stage):
            link = f', URL="\\ref {scope(item)}"' if isinstance(item, Interface) else ""
            lines.append(f"{name} [label={node(item)}{link}];")
    for left, right in zip(names, names[1:]):
        lines += [f"{a} -> {b};" for a in left for b in right]
    return "\n".join(lines + ["}"])


def pictures():
    """{seam: its picture in dot}. Every seam of doc/architecture.md has one, and no other."""
    told = set(table("seam"))
    if told != set(SEAMS):
        raise SystemExit(f"doc/site/seams.py and the seams of doc/architecture.md differ: {', '.join(sorted(told ^ set(SEAMS)))}")
    return {name: picture(seam) for name, seam in SEAMS.items()}
