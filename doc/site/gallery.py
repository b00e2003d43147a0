# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drives of prm/ with what their runs find: for each a page with a picture, figures, its .prm and its report."""
import os
import pathlib
import re
import shutil
import subprocess

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]

# In the order of the gallery; each runs in less than half a minute.
DRIVES = {
    "simple": "prm/paper/simple.prm",
    "layered": "prm/paper/layered.prm",
    "reduced-window": "prm/paper/reduced-window.prm",
    "imported-sprocket": "prm/paper/imported-sprocket.prm",
    "08b-19-57": "prm/tutorial/08b-19-57.prm",
    "12a-11-23-low-speed": "prm/tutorial/12a-11-23-low-speed.prm",
    "06b-25-25": "prm/tutorial/06b-25-25.prm",
    "525-14-41": "prm/tutorial/525-14-41.prm",
    "slow": "prm/verification/slow.prm",
}

# Of summary.json: what it is called, its unit, by how much it is multiplied.
FIGURES = {
    "tight_tension_mean": ("mean tight-span tension", "N", 1.),
    "slack_tension_mean": ("mean slack-span tension", "N", 1.),
    "span_speed_mean": ("chain speed", "m/s", 1.),
    "driven_speed_mean": ("speed of the driven sprocket", "rad/s", 1.),
    "driver_torque_mean": ("mean driver torque", "N m", 1.),
    "efficiency": ("efficiency", "%", 100.),
}

STYLE = ("<style>.sprocket{fill:#d5d8dc;stroke:#8a9099;stroke-width:.6}.rollers{fill:none;stroke:#33373d;stroke-linecap:round}"
         "path{fill:none}</style>")


def questions():
    """{file below prm/: the question it answers}, from the tables of prm/README.md."""
    rows = re.findall(r"^\| \[[^\]]*\]\(([^)]*\.prm)\) \| (.*) \| [^|]* \|$", (REPOSITORY / "prm/README.md").read_text(), re.MULTILINE)
    return {f"prm/{file}": text for file, text in rows}


def run(name, program, folder):
    """Runs a drive into `folder` unless it has been since program and file changed."""
    file, done = REPOSITORY / DRIVES[name], folder / "report.html"
    if done.is_file() and done.stat().st_mtime > max(pathlib.Path(program).stat().st_mtime, file.stat().st_mtime):
        return
    shutil.rmtree(folder, ignore_errors=True)
    words = [str(program), "run", str(file), "--report", "--output", str(folder)]
    ended = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    if ended.returncode or not done.is_file():
        raise SystemExit(f"{ended.stdout}the run {' '.join(words)} ended with {ended.returncode}"
                         f"{'' if done.is_file() else ' and without a report'}")


def drawing(run_of, file):
    """The chain at the end of the run, its tension as colours, as the report draws it."""
    from chaindrive.report import motion
    svg = motion.still(motion.frames_of(run_of))
    box = re.search(r'viewBox="\S+ \S+ (\S+) (\S+)"', svg)
    width, height = 760, round(760 * float(box[2]) / float(box[1]))
    svg = svg.replace("<svg ", f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" ', 1)  # a name, no address
    file.write_text(svg.replace(">", ">" + STYLE, 1))


def page(name, runs, pages):
    """The page of one drive; its picture and .prm beside it."""
    import chaindrive
    found = chaindrive.open(str(runs / name))
    drawing(found, pages / f"{name}.svg")
    shutil.copy(REPOSITORY / DRIVES[name], pages / f"{name}.prm")
    question = questions()[DRIVES[name]]
    lines = [f"# {name}", "", question, "", f"![The chain of {name} at the end of the run, coloured by tension]({name}.svg)", "",
             f'<a href="{name}/report.html">The report of this run</a>: key figures, curves, the chain in motion. '
             f"The file: [{name}.prm]({name}.prm). To run it:", "", f"    ./run {DRIVES[name]}", "", "| quantity | value |", "|---|---|"]
    drive = found.drive
    lines.append(f"| teeth | {', '.join(str(about['teeth']) for about in drive['sprockets'])} |")
    lines.append(f"| links, pitch | {found.n_links}, {1e3 * drive['pitch']:.6g} mm |")
    for key, (text, unit, factor) in FIGURES.items():
        value = found.summary.get(key)
        if value is not None and found.window_is_valid:
            lines.append(f"| {text} | {factor * value:.4g} {unit} |")
    lines.append(f"| computing time | {found.summary['cpu_seconds']['total']:.2g} s |")
    (pages / f"{name}.md").write_text("\n".join(lines) + "\n")


def build(names, program, runs, pages, extra, say):
    """Runs the drives, writes their pages into `pages` and their reports into `extra`, which is copied beside these."""
    pages.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("CHAINDRIVE_CACHE", os.path.expanduser("~/.cache/chaindrive"))
    lines = ["# Gallery", "", "The drives that come with the program and their results. These pages are made by running them.", ""]
    for number, name in enumerate(names, 1):
        say(f"drive {number} of {len(names)}: {name}")
        run(name, program, runs / name)
        page(name, runs, pages)
        (extra / "gallery" / name).mkdir(parents=True, exist_ok=True)
        shutil.copy(runs / name / "report.html", extra / "gallery" / name / "report.html")
        lines += [f"## {name}", "", questions()[DRIVES[name]], "", f"[![The chain of {name}]({name}.svg)]({name}.md)", "",
                  f'[Results and file]({name}.md), <a href="{name}/report.html">report</a>', ""]
    lines += ["```{toctree}", ":hidden:", "", *names, "```"]
    (pages / "index.md").write_text("\n".join(lines) + "\n")
