# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reference of the code by Doxygen: one group per room, with a picture of each of its seams."""
import pathlib
import re
import subprocess
import xml.etree.ElementTree as xml

import seams

HERE = pathlib.Path(__file__).resolve().parent
REPOSITORY = HERE.parents[1]
PROGRAM = "program"  # the group of what lies in no room
TOP = ("`simulation`, `commands` and what `main` is made of: prepares a run, runs it, returns its summary; what the user can ask for")


def rooms():
    """{room: what it contains} in the order of source/rooms.txt, from the table of doc/architecture.md."""
    rows = seams.table("room")
    names = [room for line in (REPOSITORY / "source/rooms.txt").read_text().splitlines() if not line.startswith("#") for room in line.split()]
    missing = [name for name in names if f"`{name}`" not in rows]
    if missing:
        raise SystemExit(f"doc/architecture.md has no row for the room {missing[0]} of source/rooms.txt")
    return {**{name: rows[f"`{name}`"][0] for name in names}, PROGRAM: TOP}


def grouped(text, room):
    """A header that puts itself, and what its namespaces have, into the group of its room; formulas, which stand by themselves and are
    indented, stay as they are written. Lines stay where they are."""
    lines = text.split("\n")
    for k in range(1, len(lines)):
        if re.match(r" *///   +\S", lines[k]) and re.match(r" *///(     .*)?$", lines[k - 1]):
            lines[k] = lines[k].replace("///", "///  ", 1)
    lines[0] = f"/** @ingroup {room} @file */"
    open_braces = []  # those in the first column: whether they are of a namespace
    for k in range(1, len(lines)):
        if lines[k] == "{":
            open_braces.append(re.match(r"namespace [\w:]+$", lines[k - 1]) is not None)
            if open_braces[-1]:
                lines[k] += f" /** @room{{{room}}} */"
        elif re.match(r"}[;]?( *//.*)?$", lines[k]) and open_braces.pop():
            lines[k] = "/** @} */ " + lines[k]
    return "\n".join(lines)


def stage(folder):
    """Headers with their groups, and the text of the groups, into `folder`."""
    known = rooms()
    for header in sorted((REPOSITORY / "include").rglob("*.h")):
        path = header.relative_to(REPOSITORY)
        room = path.parts[2] if len(path.parts) > 3 else PROGRAM
        if room not in known:
            raise SystemExit(f"{path} lies in no room of source/rooms.txt")
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(grouped(header.read_text(), room))
    pictures = seams.pictures()
    pages = ["/** @mainpage Reference of the code", "",
             "The code is divided into rooms (modules): each is a folder of `source/` with its headers, and includes only rooms above it in this list.",
             '<a href="../doc/architecture.html">Architecture</a> explains how they work together; formulas are in',
             '<a href="../doc/theory.html">Theory</a>. A seam is an extension point, where an addition is a new file behind a small interface: its room has a diagram of it.', ""]
    for room, contents in known.items():
        inside = [name for name, seam in seams.SEAMS.items() if seam.room == room]
        pages.append(f"- @ref {room} \"{room}\": {contents}" + (f". Seams: {', '.join(inside)}" if inside else ""))
    pages.append("*/")
    for room, contents in known.items():
        pages += [f"/** @defgroup {room} {room}", f"@brief {contents[0].upper()}{contents[1:]}.", ""]
        for name, seam in seams.SEAMS.items():
            if seam.room == room:
                pages += [f"<h3>The seam: {name}</h3>", "", seam.text, "", "@dot", pictures[name], "@enddot", ""]
        pages.append("*/")
    names = {re.sub(r"^namespace ", "", line) for header in (REPOSITORY / "include").rglob("*.h")
             for line in header.read_text().splitlines() if re.match(r"namespace [\w:]+$", line)}
    for name in sorted(names):
        room = name.split("::")[1] if "::" in name else ""
        if room in known:
            pages.append(f"/** @namespace {name}\n@brief Of the room @ref {room}. */")
    (folder / "rooms.dox").write_text("\n".join(pages) + "\n")


def layout(file):
    """Doxygen's own layout, with a way back to the manual, and the pictures of a room before the list of what is in it."""
    subprocess.run(["doxygen", "-l", file], check=True, capture_output=True)
    tree = xml.parse(file)
    bar, group = tree.find("navindex"), tree.find("group")
    bar.insert(0, xml.Element("tab", type="user", url="../index.html", title="Manual"))
    bar.find("tab[@type='modules']").set("title", "Rooms")
    text = group.find("detaileddescription")
    group.remove(text)
    group.insert(1, text)
    group.find("memberdecl/namespaces").set("visible", "no")
    tree.write(file)


def build(work, output, version):
    """The pages into output/api. Returns what Doxygen complains about."""
    folder = work / "api"
    stage(folder)
    layout(folder / "layout.xml")
    settings = {"PROJECT_NUMBER": version, "INPUT": folder, "OUTPUT_DIRECTORY": output, "HTML_OUTPUT": "api", "STRIP_FROM_PATH": folder / "include",
                "STRIP_FROM_INC_PATH": folder / "include", "LAYOUT_FILE": folder / "layout.xml", "HTML_EXTRA_STYLESHEET": HERE / "static/api.css"}
    text = (HERE / "Doxyfile").read_text() + "".join(f'{name} = "{value}"\n' for name, value in settings.items())
    done = subprocess.run(["doxygen", "-"], input=text, capture_output=True, text=True)
    for page in (output / "api").glob("*.html"):  # Doxygen 1.9 links to a list of nested classes even where all are private and it has none
        text = page.read_text()
        if 'href="#nested-classes"' in text and 'name="nested-classes"' not in text:
            page.write_text(re.sub(r'<a href="#nested-classes">[^<]*</a>(?: &#124;\s*)?', "", text))
    complaints = (done.stdout + done.stderr).replace(f"{folder}/", "").strip()
    return complaints if complaints or not done.returncode else f"Doxygen ended with {done.returncode}"


def reference():
    """A page of the manual that leads to the groups."""
    lines = ["# Reference of the code", "", 'Made from the headers by Doxygen: <a href="api/index.html">all of it</a>, '
             '<a href="api/annotated.html">classes</a>, <a href="api/files.html">files</a>. One page per room:', "",
             "| room | contents | seams |", "|---|---|---|"]
    for room, contents in rooms().items():
        inside = ", ".join(name for name, seam in seams.SEAMS.items() if seam.room == room)
        lines.append(f'| <a href="api/group__{room}.html">{room}</a> | {contents} | {inside} |')
    return "\n".join(lines) + "\n"
