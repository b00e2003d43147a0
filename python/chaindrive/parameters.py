# SPDX-License-Identifier: LGPL-2.1-or-later
"""The entries of a parameter file, as a run has used them."""
from __future__ import annotations

import re

from chaindrive.errors import RunError


class Parameters(dict[str, str]):
    """Texts by path: `parameters["Drive/Driver teeth"]`.

    The last words of a path suffice where they mean one entry only: `parameters["Driver teeth"]`.
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
                self["/".join([*path, match[1]])] = match[2].strip()

    def __missing__(self, name: str) -> str:
        paths = [path for path in self if path.endswith("/" + name)]
        if len(paths) == 1:
            return self[paths[0]]
        raise RunError(f"There is no entry '{name}' in the parameters of this run." if not paths else
                       f"The entry '{name}' may be {' or '.join(paths)}: name the section too.")

    def number(self, name: str) -> float:
        """The value as a number, in the unit that its name says. RunError when it is none."""
        try:
            return float(self[name])
        except ValueError:
            raise RunError(f"The entry '{name}' = {self[name]} is no number.") from None
