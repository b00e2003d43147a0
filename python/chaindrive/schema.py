# SPDX-License-Identifier: LGPL-2.1-or-later
"""What histories and summaries of runs may hold, as the program says it: `chaindrive document --schema`.

HISTORIES and SUMMARY have a member for each path: a dictionary of `unit`, `description` and, where
Output/Quantities decides on it, `quantities`, the words that ask for it. In a path a star stands for any name, or
any place in a list: "engagements/*/time", "hubs/*_speed". history() has what is known of one history.

OLD_NAMES has what earlier versions called otherwise: the present path by the old one of `entries` of parameter
files and of members of the `summary`, and by entry the present `values` by the old ones.
"""
from __future__ import annotations

import json
import pathlib
import re
from typing import Any

_SCHEMA = json.loads(pathlib.Path(__file__).with_name("schema.json").read_text(encoding="utf-8"))

HISTORIES: dict[str, dict[str, Any]] = _SCHEMA["histories"]
SUMMARY: dict[str, dict[str, Any]] = _SCHEMA["summary"]
OLD_NAMES: dict[str, dict[str, Any]] = _SCHEMA["old_names"]


def about(member: str) -> tuple[str, str]:
    """Unit and description of a member of the summary."""
    return SUMMARY[member]["unit"], SUMMARY[member]["description"]


def history(path: str) -> dict[str, Any]:
    """The member of HISTORIES for a path, by its name or else by the star in its place; empty where there is none."""
    fitting = (known for known in HISTORIES if re.fullmatch(re.escape(known).replace(r"\*", "[^/]+"), path))
    return HISTORIES[path] if path in HISTORIES else HISTORIES.get(next(fitting, ""), {})


def below(path: str) -> dict[str, str]:
    """Names and units of the members of a path of the summary, such as "engagements/*"."""
    start = path + "/"
    return {name.removeprefix(start): one["unit"] for name, one in SUMMARY.items() if name.startswith(start)}
