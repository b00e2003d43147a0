# SPDX-License-Identifier: LGPL-2.1-or-later
"""The entries of a parameter file, as a run has used them."""
from __future__ import annotations

import re
from typing import Any

from chaindrive import schema
from chaindrive.errors import RunError


def _current(name: str) -> str:
    """What is the name in this version of an entry that an earlier one called `name`, with or without its section."""
    for old, path in schema.OLD_NAMES["entries"].items():
        if name == old or (name == old.rpartition("/")[2] and "/" not in name):
            return str(path)
    return name


class Parameters(dict[str, str]):
    """Texts by path: `parameters["Drive/Driver teeth"]`.

    The last words of a path suffice where they mean one entry only: `parameters["Driver teeth"]`. Entries and
    values are called as in this version, whichever has written the file; entries are also found by their old names.
    """

    def __init__(self, text: str) -> None:
        super().__init__()
        path: list[str] = []
        for line in text.splitlines():
            line = line.split("#")[0].strip()
            if line.startswith("subsection "):
                path.append(line.removeprefix("subsection ").strip())
            elif line == "end" and path:
                path.pop()
            elif match := re.match(r"set\s+(.*?)\s*=\s*(.*)", line):
                entry = _current("/".join([*path, match[1]]))
                self[entry] = schema.OLD_NAMES["values"].get(entry, {}).get(match[2].strip(), match[2].strip())

    def __missing__(self, name: str) -> str:
        paths = [path for path in self if path.endswith("/" + name)]
        if len(paths) == 1:
            return self[paths[0]]
        if (current := _current(name)) != name:
            return self[current]
        raise RunError(f"There is no entry '{name}' in the parameters of this run." if not paths else
                       f"The entry '{name}' may be {' or '.join(paths)}: name the section too.")

    def __contains__(self, name: object) -> bool:
        return super().__contains__(_current(name) if isinstance(name, str) else name)

    def get(self, name: str, default: Any = None) -> Any:
        """The text of the entry with this path, which may be an old one; `default` where there is none."""
        return super().get(_current(name), default)

    def number(self, name: str) -> float:
        """The value as a number, in the unit that its name says. RunError when it is none."""
        try:
            return float(self[name])
        except ValueError:
            raise RunError(f"The entry '{name}' = {self[name]} is no number.") from None
