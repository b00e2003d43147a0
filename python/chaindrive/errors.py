# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong when drives are computed or results are read."""


class RunError(Exception):
    """A sentence that says what of a run cannot be used, and what to do about it."""
