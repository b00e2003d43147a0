# SPDX-License-Identifier: LGPL-2.1-or-later
"""A report as one HTML file that needs nothing else."""
from __future__ import annotations

import base64
import gzip
import importlib.util
import json
import pathlib
from collections.abc import Iterable, Sequence
from typing import Any, Union

from chaindrive.report import motion, svg
from chaindrive.errors import RunError
from chaindrive.files import replacing
from chaindrive.report.figure import Figure, as_data
from chaindrive.report.parts import DAMAGE, of_other_files
from chaindrive.report.text import escape, number, sentences

#: What sections are made of: HTML, or a figure.
Part = Union[str, Figure]

HERE = pathlib.Path(__file__).resolve().parent
DEBIAN = pathlib.Path("/usr/share/python3-plotly/plotly.js")
LICENCES = pathlib.Path("/usr/share/doc/python3-plotly/copyright")


def plotly() -> pathlib.Path | None:
    """The file of plotly.js: Debian's, or that of the Python package plotly; None without."""
    if DEBIAN.exists():
        return DEBIAN
    package = importlib.util.find_spec("plotly")
    for folder in (package.submodule_search_locations or []) if package else []:
        if (file := pathlib.Path(folder) / "package_data/plotly.min.js").exists():
            return file
    return None


def packed(data: bytes, level: int = 6) -> str:
    """Bytes as a script of a page can hold them."""
    return base64.b64encode(gzip.compress(data, level, mtime=0)).decode()


class Page:
    """Collects HTML and what the scripts draw."""

    def __init__(self) -> None:
        self.panels: list[dict[str, Any]] = []
        self.films: list[dict[str, Any]] = []

    def figure(self, figure: Figure) -> str:
        """A figure as HTML: legend, panels with their still pictures, sentences in the place of what is missing."""
        if not figure.panels and not figure.missing:
            return ""
        data: list[dict[str, Any]] = []
        stills: list[str] = []
        for panel in figure.panels:
            try:
                data.append(json.loads(json.dumps(as_data(panel), allow_nan=False)))
                stills.append(svg.draw(panel, f"clip{len(self.panels) + len(data) - 1}"))
            except DAMAGE as error:
                return sentences([f"{figure.title} could not be drawn: {of_other_files(error)}"], "missing")
        legend = "".join(f'<li><button type="button" aria-pressed="true">{_look(color, dash, kind)}{escape(label)}</button></li>'
                         for label, color, dash, kind in figure.legend())
        out = [f'<figure id="{figure.key}"><h3>{escape(figure.title)}</h3><p class="caption">{escape(figure.sentence)}</p>']
        if legend:
            out.append(f'<ul class="key">{legend}</ul>')
        out.append(f'<div class="panels{" single" if len(figure.panels) == 1 else ""}">')
        for panel, numbers, still in zip(figure.panels, data, stills):
            which = len(self.panels)
            self.panels.append(numbers)
            title = f"<h4>{escape(panel.title)}</h4>" if panel.title else ""
            out.append(f'<div class="panel">{title}<div class="live" data-panel="{which}"></div>{still}</div>')
        out.append("</div>" + sentences(figure.missing, "missing") + "</figure>")
        return "".join(out)

    def film(self, frames: dict[str, Any], title: str) -> str:
        """The chain in motion."""
        json.dumps(frames, allow_nan=False)  # or it is damaged, before anything is made of it
        which = len(self.films)
        self.films.append({**frames, "light": motion.LIGHT, "dark": motion.DARK})
        light, dark = (", ".join(motion.color(k / 5, stops) for k in range(6)) for stops in (motion.LIGHT, motion.DARK))
        bars = f"--light: linear-gradient(to right, {light}); --dark: linear-gradient(to right, {dark})"
        heading = f"<h4>{escape(title)}</h4>" if title else ""
        return (f'<figure class="moving">{heading}<div class="film" data-film="{which}"><canvas role="img" aria-label="The chain in motion"></canvas>'
                '<div class="controls"><button type="button">Play</button><input type="range" min="0" value="0" aria-label="Instant">'
                '<output></output><select aria-label="View"><option value="">whole drive</option></select></div></div>' + motion.still(frames) +
                f'<p class="scale caption">tension of a link: <span>{number(frames["low"])} N</span><i style="{bars}"></i>'
                f'<span>{number(frames["high"])} N</span></p></figure>')

    def write(self, file: pathlib.Path, title: str, lead: str,
              sections: Iterable[tuple[str, str, Sequence[Part]]]) -> None:
        """Writes the page with its `sections`: (key, title, parts), each part HTML or a Figure."""
        menu = "".join(f'<a href="#{key}">{escape(key.capitalize())}</a>' for key, _, _ in sections)
        body = []
        for key, name, parts in sections:
            html = "".join(self.figure(part) if isinstance(part, Figure) else part for part in parts)
            body.append(f'<section id="{key}"><h2>{escape(name)}</h2>{html}</section>')
        library = plotly()
        scripts, footer = "", f"<p>{MADE_BY}. It needs no network and no other file.</p>"
        if library is not None:
            text = library.read_bytes()
            version = text[:200].decode(errors="replace").split("plotly.js v")[-1].split()[0]
            scripts = f'<script type="application/gzip" id="plotly">{packed(text)}</script>'
            licence = LICENCES.read_text(encoding="utf-8", errors="replace") if LICENCES.exists() else ""
            footer += (f"<p>Interactive plots by plotly.js {escape(version)}, copyright 2012-2021 Plotly, Inc., under the MIT licence, parts under BSD and "
                       "Apache licences; its source is in this file.</p>")
            if licence:
                footer += f"<details><summary>Licences of plotly.js</summary><pre>{escape(licence)}</pre></details>"
        else:
            footer += "<p>python3-plotly is not installed: the figures are still pictures.</p>"
        data = json.dumps({"panels": self.panels, "films": self.films}, separators=(",", ":"), allow_nan=False).encode()
        page = (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
                f"<title>{escape(title)}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n{(HERE / 'page.css').read_text()}</style>\n</head>\n<body>\n"
                f"<header><h1>{escape(title)}</h1>{lead}</header>\n<nav><div>{menu}</div></nav>\n<main>\n" + "\n".join(body) +
                f"\n</main>\n<footer>{footer}</footer>\n<script type=\"application/gzip\" id=\"data\">{packed(data)}</script>\n{scripts}\n"
                f"<script>\n{(HERE / 'page.js').read_text()}</script>\n</body>\n</html>\n")
        replace(file, page)


MADE_BY = "Made by <code>chaindrive report</code>"


def replace(file: pathlib.Path, page: str) -> None:
    """Puts a page in the place of an earlier one, all at once. RunError when anything else stands there."""
    if file.is_symlink() or (file.exists() and not file.is_file()):
        raise RunError(f"'{file}' is no file that a report could replace: --output takes the name of a new file, such as report.html.")
    if file.exists() and MADE_BY.encode() not in file.read_bytes():
        raise RunError(f"'{file}' is not a page of chaindrive and stays as it is: --output takes the name of a new file, such as report.html.")
    with replacing(file) as part:
        part.write_text(page, encoding="utf-8", errors="replace")


def _look(color: int, dash: int, kind: str) -> str:
    """A curve in a legend."""
    if kind in ("bars", "band"):
        return f'<svg viewBox="0 0 30 12" aria-hidden="true"><rect class="{"bar" if kind == "bars" else "band"} c{color % 8}" y="2" width="30" height="8"/></svg>'
    if kind == "points":
        return f'<svg viewBox="0 0 30 12" aria-hidden="true"><path class="points c{color % 8}" d="M15 6h0"/></svg>'
    dashes = f' stroke-dasharray="{svg.DASHES[dash % 5]}"' if dash % 5 else ""
    return f'<svg viewBox="0 0 30 12" aria-hidden="true"><path class="line c{color % 8}"{dashes} d="M0 6H30"/></svg>'
