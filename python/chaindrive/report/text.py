# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers, tables and sentences as HTML."""
from __future__ import annotations

import html
import math
from collections.abc import Iterable, Sequence

#: unit of the files: units for people, with the factor and the least value for which they are used
SHOWN: dict[str, tuple[tuple[str, float, float], ...]] = {
    "m": (("m", 1., 2.), ("mm", 1e3, 1e-4), ("µm", 1e6, 0.)), "s": (("s", 1., 1.), ("ms", 1e3, 1e-4), ("µs", 1e6, 0.)),
    "N": (("kN", 1e-3, 1e4), ("N", 1., 0.)), "Pa": (("MPa", 1e-6, 1e5), ("Pa", 1., 0.)), "W": (("kW", 1e-3, 1e3), ("W", 1., 0.)),
    "J": (("kJ", 1e-3, 1e4), ("J", 1., 0.1), ("mJ", 1e3, 0.)), "rad/s": (("rpm", 30. / math.pi, 0.),), "rad": (("°", 180. / math.pi, 0.),),
    "N s": (("N s", 1., 1.), ("mN s", 1e3, 0.)), "Hz": (("kHz", 1e-3, 1e4), ("Hz", 1., 0.)), "m2": (("mm²", 1e6, 0.),),
    "kg m2": (("kg m²", 1., 0.),), "B": (("MB", 1e-6, 0.),), "kg/m": (("kg/m", 1., 0.),), "m/s": (("m/s", 1., 0.),),
}


def escape(text: object) -> str:
    """Any text as HTML that is no markup."""
    return html.escape(str(text))


def number(value: float | str | None, digits: int = 4) -> str:
    """A number with so many digits, in a form that people read; a dash for none."""
    if value is None or isinstance(value, str) or not math.isfinite(value):
        return "–" if not isinstance(value, str) else escape(value)
    if isinstance(value, int) or (value == int(value) and abs(value) >= 10 ** digits):
        return f"{int(value):,}".replace(",", "\u202f").replace("-", "−")
    text = f"{value:.{digits}g}"
    if "e" in text:
        mantissa, exponent = text.split("e")
        if -5 < int(exponent) < 7:
            text = f"{value:.{max(0, digits - 1 - int(exponent))}f}"
        else:
            return f"{mantissa.replace('-', '−')}·10<sup>{str(int(exponent)).replace('-', '−')}</sup>"
    return text.replace("-", "−")


def scale_of(unit: str, value: float | None) -> tuple[str, float]:
    """The unit for people and the factor for a value of this size."""
    if not value and len(SHOWN.get(unit, ())) > 2:
        return SHOWN[unit][1][:2]
    for name, factor, least in SHOWN.get(unit, ()):
        if value is not None and math.isfinite(value) and abs(value) >= least:
            return name, factor
    if unit in SHOWN:
        return SHOWN[unit][-1][:2]
    return ("" if unit == "1" else unit), 1.


def quantity(value: float | None, unit: str, digits: int = 4) -> str:
    """A value in SI units as text with a unit: 0.0035, "s" is 3.5 ms."""
    if value is None or not math.isfinite(value):
        return "–"
    name, factor = scale_of(unit, value)
    return number(value * factor, digits) + ("" if not name else ("" if name == "°" else "\u00a0") + name.replace(" ", "\u00a0"))


def percent(value: float | None, digits: int = 2) -> str:
    """With its sign, for differences."""
    if value is None or not math.isfinite(value):
        return "–"
    text = f"{value:+.{digits}g}" if abs(value) < 100 else f"{value:+.0f}"
    if "e" in text:
        text = f"{value:+.1f}"
    return text.replace("-", "−") + "\u00a0%"


def table(head: Sequence[str], rows: Iterable[Sequence[str]], caption: str = "", classes: str = "") -> str:
    """A table; cells are HTML. The first column names the row."""
    top = "".join(f'<th scope="col">{cell}</th>' for cell in head)
    body = "".join("<tr>" + "".join(f'<th scope="row">{cell}</th>' if i == 0 else f"<td>{cell}</td>" for i, cell in enumerate(row)) + "</tr>"
                   for row in rows)
    title = f"<caption>{caption}</caption>" if caption else ""
    return f'<div class="scroll"><table class="{classes}">{title}' + (f"<thead><tr>{top}</tr></thead>" if head else "") + \
        f"<tbody>{body}</tbody></table></div>"


def sentences(texts: Iterable[object], kind: str = "note") -> str:
    """Paragraphs for what has to be said."""
    return "".join(f'<p class="{kind}">{escape(text)}</p>' for text in texts)
