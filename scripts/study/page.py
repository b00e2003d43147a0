# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a study: the chart of accuracy against cost, tables in Markdown and HTML."""
import math
import pathlib

import jinja2
import matplotlib
import numpy as np

import stats
import sweep

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "study"  # the same picture from the same figures
import matplotlib.pyplot as plt

NO_INTERVALS = f"Fewer than {stats.FEWEST} start phases give no interval."
MANY = 8  # panels; bands of a spectrum stand in the table only


def panels(study):
    """The outputs that have a panel: single numbers with an error."""
    return [c for c in study.columns if not c.endswith(" Hz")
            and any(np.isfinite(v["row"][f"{c} error"]) and v is not study.reference for v in study.variants)][:MANY]


def draw(study, file, dpi=100):
    """Error against CPU time, a panel for each output: a point with its interval for each variant, a line through the
    efficient ones, and the band within which the reference itself is known."""
    names = panels(study) or study.columns[:1]
    columns = min(2, len(names)) or 1
    rows = math.ceil(len(names) / columns) or 1
    figure, axes = plt.subplots(rows, columns, figsize=(4.6 * columns, 3.1 * rows), squeeze=False, layout="constrained")
    for axis, name in zip(axes.flat, names):
        _panel(study, axis, name)
    for axis in axes.flat[len(names):]:
        axis.set_visible(False)
    figure.savefig(file, dpi=dpi, metadata={"Date": None} if str(file).endswith("svg") else None)
    plt.close(figure)


def _panel(study, axis, name):
    reference = study.reference["row"]
    band = 50 * (reference[f"{name} high"] - reference[f"{name} low"]) / abs(reference[name]) if reference[name] else np.nan
    shown = [v for v in study.variants if np.isfinite(v["row"][f"{name} error"]) and v is not study.reference]
    sizes = [abs(v["row"][f"{name} error"]) for v in shown] + ([band] if np.isfinite(band) else [])
    floor = 0.5 * min([size for size in sizes if size > 0], default=1e-3)
    for variant in shown:
        row = variant["row"]
        error, low, high = (abs(row[f"{name} error{which}"]) for which in ("", " low", " high"))
        at_zero = row[f"{name} error low"] * row[f"{name} error high"] <= 0
        ends = (floor if at_zero else min(low, high), max(low, high))
        efficient = row[f"{name} efficient"]
        axis.plot([row["cpu"]] * 2, [max(end, floor) for end in ends], color="0.6", lw=1, zorder=1)
        axis.plot(row["cpu"], max(error, floor), "o", color="C3" if efficient else "C0", zorder=3)
        axis.annotate(variant["name"], (row["cpu"], max(error, floor)), xytext=(4, 4), textcoords="offset points", fontsize=7)
    front = sorted((v["row"]["cpu"], max(abs(v["row"][f"{name} error"]), floor)) for v in shown if v["row"][f"{name} efficient"])
    if len(front) > 1:
        axis.plot(*zip(*front), color="C3", lw=1, drawstyle="steps-post", zorder=2)
    if np.isfinite(band) and band > 0:
        axis.axhspan(floor / 2, band, color="0.93", zorder=0)
    axis.axvline(reference["cpu"], color="0.5", lw=0.8, ls=":", zorder=0)
    axis.annotate(study.about["reference"], (reference["cpu"], 0.02), xycoords=("data", "axes fraction"), rotation=90,
                  fontsize=7, ha="right", color="0.4")
    axis.set(xscale="log", yscale="log", title=name.replace("_", " "), xlabel="CPU time of a run (s)", ylabel="error (%)")
    axis.title.set_fontsize(9)


def number(value, digits=4):
    """Short text; a hyphen where there is nothing."""
    if isinstance(value, str):
        return value
    return "-" if value is None or not np.isfinite(value) else f"{value:.{digits}g}"


def error_text(row, column):
    """Error with its interval in percent."""
    error, low, high = (row[f"{column} error{which}"] for which in ("", " low", " high"))
    if not np.isfinite(error):
        return "-"
    interval = f" ({_percent(low)} ... {_percent(high)})" if np.isfinite(low) else ""
    return f"{_percent(error)} %{interval}"


def _percent(value):
    """Two digits, and never a power of ten."""
    return f"{value:+.0f}" if abs(value) >= 10 else f"{value:+.2g}"


def heading(study, column):
    """Name and unit of an output."""
    unit = study.about.get("units", {}).get(column.split(" ")[0], "1")
    return column.replace("_", " ") + (f" ({unit})" if unit != "1" else "")


def result_rows(study):
    """Table of outputs: heading and rows. A row that ends early has its last cell across the rest."""
    head = ["variant", "CPU (s)", *(heading(study, c) for c in study.columns)]
    body = []
    for variant in study.variants:
        row = variant["row"]
        name = variant["name"] + (" (reference)" if variant is study.reference else "")
        if row["not valid"]:
            body.append([name, row["message"]])
            continue
        cells = [name, number(row["cpu"], 3)]
        for column in study.columns:
            cells.append(number(row[column]) + ("" if variant is study.reference else ", " + error_text(row, column)))
        body.append([cell.replace("-, -", "-") for cell in cells])
    return head, body


def cost_rows(study):
    phases = [name for name in study.fields() if name.startswith("cpu ")]
    head = ["variant", "runs", "steps", "CPU (s)", *(p[4:].replace("_", " ") for p in phases), "elapsed (s)", "memory (MB)"]
    body = [[v["name"], f'{v["row"]["runs"]} of {len(v["runs"])}', number(v["row"]["steps"], 6), number(v["row"]["cpu"], 3),
             *(number(study.value(p, v), 3) for p in phases), number(v["row"]["wall"], 3), number(v["row"]["memory"] / 1e6, 3)]
            for v in study.variants]
    return head, body


def markdown(head, body):
    """A table; of a row that ends early the rest is empty."""
    lines = [head, ["---"] * len(head), *([*row, *[""] * (len(head) - len(row))] for row in body)]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)


def table(study):
    """For a document: a line for each output and for what the runs cost, a column for each variant. Of a spectrum the bands
    an octave apart."""
    def cell(variant, column):
        value = number(variant["row"][column])
        return value if variant is study.reference or value == "-" else f'{value}<br>{error_text(variant["row"], column)}'

    columns = [c for c in study.columns if not c.endswith(" Hz") or c.split(" ")[1] in ("1000", "2000", "4000", "8000", "16000")]
    return markdown(["", *(v["name"] + (", the reference" if v is study.reference else "") for v in study.variants)],
                    [[heading(study, c), *(cell(v, c) for v in study.variants)] for c in columns]
                    + [["runs", *(str(v["row"]["runs"]) for v in study.variants)],
                       ["steps", *(number(v["row"]["steps"], 6) for v in study.variants)],
                       ["CPU time of a run (s)", *(number(v["row"]["cpu"], 3) for v in study.variants)]])


def _svg(file):
    text = file.read_text(encoding="utf-8")
    return text[text.index("<svg"):]


def _phases(study):
    return len(study.variants[0]["runs"])


def draw_all(study, folder, name="chart", kind="svg", dpi=100):
    """All pictures of a study: (what it shows, file, what to see in it)."""
    chart = folder / f"{name}.{kind}"
    if not study.about.get("against"):
        draw(study, chart, dpi)
        return [("Error against CPU time", chart, "Red: the efficient variants, of which none is cheaper and more accurate. "
                 "Grey band: within it the reference itself is not known.")]
    of = sweep.Sweep(study)
    sweep.draw(of, chart, dpi)
    pictures = [(f"Outputs against {of.label}", chart, ("Bars: 95 % intervals over start phases." if _phases(study) >= stats.FEWEST else NO_INTERVALS) + (
        " Dashed and dotted lines: the order of tooth frequency meets the frequency of the driven inertia." if of.resonances() else ""))]
    worn = folder / f"{name}-wear.{kind}"
    if sweep.draw_wear(of, worn, dpi):
        pictures.insert(0, ("Elongation over hours", worn, "From the friction work of each state; dotted: by the rate of the first state alone, which "
                            "is all that one run knows. Dashed: the elongation at which the chain is replaced. The wear coefficient is known within "
                            "a factor of 3, and with it all hours."))
    orders = folder / f"{name}-orders.{kind}"
    if sweep.draw_orders(of, orders, dpi):
        pictures.append(("Orders of tooth frequency at each speed", orders, "A row for each speed; lines: the frequencies "
                         "that the design data of the drive predict."))
    return pictures


def _intervals(study):
    if _phases(study) < stats.FEWEST:
        return "without intervals, which fewer than four start phases do not give"
    return "with their 95 % intervals (jackknife over the start phases)"


def write(study, directory):
    """study.md and, last of all results, study.html, each at once."""
    folder = pathlib.Path(__file__).resolve().parent
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(folder), keep_trailing_newline=True,
                                     autoescape=lambda name: name.startswith("page.html"), trim_blocks=True, lstrip_blocks=True)
    pictures = draw_all(study, directory)
    failed = [(v["name"], v["row"]["message"]) for v in study.variants if v["row"]["failed"] or v["row"]["not valid"]]
    cpu = sum(run["cpu"].get("total", 0.) for v in study.variants for run in v["results"].values() if "cpu" in run)
    against = study.about.get("against")
    found = sweep.tables(sweep.Sweep(study), heading, number) if against else [result_rows(study)]
    no_errors = not against and bool(study.reference["row"]["not valid"])
    about = dict(about=study.about, shortfall=study.shortfall(), no_errors=no_errors, against=against, tables=[*found, cost_rows(study)], failed=failed,
                 pictures=[(what, file.name, _svg(file), text) for what, file, text in pictures],
                 cpu=cpu, markdown=markdown, changes=[(v["name"], v.get("changes", {})) for v in study.variants],
                 phases=_phases(study), intervals=_intervals(study))
    for source, target in (("page.md.j2", "study.md"), ("page.html.j2", "study.html")):
        part = directory / (target + ".part")
        part.write_text(environment.get_template(source).render(about), encoding="utf-8")
        part.replace(directory / target)
