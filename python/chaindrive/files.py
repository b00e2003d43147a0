# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are there whole or not at all."""
from __future__ import annotations

import contextlib
import os
import pathlib
import tempfile
from collections.abc import Iterator


@contextlib.contextmanager
def replacing(file: pathlib.Path) -> Iterator[pathlib.Path]:
    """An empty file beside `file` to be written, which then takes its place, all at once; nothing is left if that fails."""
    descriptor, part = tempfile.mkstemp(prefix=file.name + ".", suffix=".part", dir=file.parent)
    os.close(descriptor)
    try:
        yield pathlib.Path(part)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(part, 0o666 & ~mask)
        os.replace(part, file)
    except BaseException:
        pathlib.Path(part).unlink(missing_ok=True)
        raise
