# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong when drives are computed or results are read, and how a command says so."""
from __future__ import annotations

import sys
from collections.abc import Callable


class RunError(Exception):
    """A sentence that says what of a run cannot be used, and what to do about it."""


def exit_status(write: Callable[[], None], what: str) -> int:
    """That of a command which `write` carries out: 0, or 2 or 3 once standard error has a sentence on why it could not.

    2 stands for results that cannot be used, 3 for `what` cannot be written.
    """
    try:
        write()
    except RunError as error:
        print(f"chaindrive: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"chaindrive: {what} cannot be written: {error}.", file=sys.stderr)
        return 3
    return 0
