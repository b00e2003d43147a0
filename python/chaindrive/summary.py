# SPDX-License-Identifier: LGPL-2.1-or-later
"""The summary of a run, by the names of this version and by those of earlier ones."""
from __future__ import annotations

from typing import Any

from chaindrive import schema


class Summary(dict[str, Any]):
    """The members of summary.json by their present names, whichever version has written them.

    `schema.OLD_NAMES` lists the old ones, by which they are found too: that they are is an aid of one version.
    """

    def __init__(self, written: dict[str, Any]) -> None:
        super().__init__({_current(name): value for name, value in written.items()})

    def __missing__(self, name: str) -> Any:
        if (current := _current(name)) != name:
            return self[current]
        raise KeyError(name)

    def __contains__(self, name: object) -> bool:
        return super().__contains__(_current(name) if isinstance(name, str) else name)

    def get(self, name: str, default: Any = None) -> Any:
        """The member of this name, which may be an old one; `default` where there is none."""
        return super().get(_current(name), default)


def _current(name: str) -> str:
    return str(schema.OLD_NAMES["summary"].get(name, name))
