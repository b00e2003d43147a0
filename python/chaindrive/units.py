# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units. Files hold SI units only; frames convert to others where that is asked for."""
from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Union

from chaindrive.errors import RunError

#: Names of units to convert to: one, or several such as ("mm", "ms").
Units = Union[str, Sequence[str]]

#: unit: (unit of the files, by which a number of that is multiplied)
SCALES = {
    "mm": ("m", 1e3), "um": ("m", 1e6),
    "ms": ("s", 1e3), "us": ("s", 1e6),
    "mm/s": ("m/s", 1e3),
    "kN": ("N", 1e-3), "kN m": ("N m", 1e-3),
    "MPa": ("Pa", 1e-6), "N/mm2": ("Pa", 1e-6),
    "kW": ("W", 1e-3), "kJ": ("J", 1e-3), "mJ": ("J", 1e3),
    "mN s": ("N s", 1e3),
    "deg": ("rad", 180. / math.pi), "rpm": ("rad/s", 30. / math.pi),
    "kHz": ("Hz", 1e-3), "%": ("1", 100.), "g": ("kg", 1e3),
}


def squared(unit: str) -> str:
    """The unit of a mean square."""
    return f"({unit})2" if set(unit) & set("/ 0123456789") else unit + "2"


def convert(unit: str, wanted: Units = ()) -> tuple[str, float]:
    """The unit and the factor that lead from `unit` to the one of `wanted` that measures the same.

    `unit` itself and 1 where there is none. RunError for a unit that is not known.
    """
    for name in (wanted,) if isinstance(wanted, str) else wanted:
        if name not in SCALES and name not in {base for base, _ in SCALES.values()}:
            raise RunError(f"There is no unit '{name}'. There are: {', '.join(SCALES)}, and the units of the files.")
        if name in SCALES and SCALES[name][0] == unit:
            return name, SCALES[name][1]
    return unit, 1.
