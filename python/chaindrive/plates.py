# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stresses of the side plates that arrive at the driver one after the other: the paper's Figure 9 as numbers."""
from __future__ import annotations

import numpy as np
import pandas as pd

from chaindrive.errors import RunError
from chaindrive.run import Run


def nominal_stress(run: Run, link: int, tension: float) -> float:
    """The `tension` of a link, N, over the waists of both of its plates, Pa; nan where their dimensions are auto."""
    which = "Outer" if link % 2 else "Inner"
    try:
        height, thickness = (1e-3 * run.parameter(f"Drive/Chain/{which} plate {what} in mm") for what in ("height", "thickness"))
        return tension / (2 * run.parameter("Drive/Chain/Waist ratio") * height * thickness)
    except RunError:
        return np.nan


def plate_stresses(run: Run, n: int = 5) -> pd.DataFrame:
    """Stresses of the links behind the first `n` rollers that meet the driver in the window, Pa.

    A frame with a row per link, over the pitch time before the touch, when it is in the tight span.
    `nominal`: mean tension over both waists, which is the static solution of the pull; `axial`,
    `principal_1`, `principal_2`: means at the waist; `in_plane`, `out_of_plane`: r.m.s. of bending.
    doc/output.md defines them. RunError when no roller meets the driver so, or plates have no stresses.
    """
    rows, index = [], []
    for roller, touch, _ in run.arrivals(n):
        if touch - run.pitch_time < run.time[0]:
            continue
        link, part = run.link_behind(roller), (touch - run.pitch_time, touch)
        of = {name: run.column(f"plates/{name}", link, *part)
              for name in ("axial_stress", "bending_in_plane", "bending_out_of_plane", "principal_1", "principal_2")}
        rows.append({"kind": "outer" if link % 2 else "inner",
                     "nominal": nominal_stress(run, link, float(np.mean(run.column("links/tension", link, *part)))),
                     "axial": float(np.mean(of["axial_stress"])),
                     "in_plane": float(np.sqrt(np.mean(of["bending_in_plane"] ** 2))),
                     "out_of_plane": float(np.sqrt(np.mean(of["bending_out_of_plane"] ** 2))),
                     "principal_1": float(np.mean(of["principal_1"])),
                     "principal_2": float(np.mean(of["principal_2"]))})
        index.append(link)
    if not rows:
        raise RunError(f"In the run in '{run.folder}' no roller meets the driver in the window, a pitch time after the start and 1 ms before the "
                       "end: choose a later Time/End time in ms.")
    frame = pd.DataFrame(rows, index=pd.Index(index, name="link"))
    frame.attrs = {"unit": "Pa"}
    return frame
