# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of others as a page may show them.

The folder of a run may come from anybody, and may be damaged: whatever text is in its files, names of
members included, loses what makes markup where it is read, and HDF5 files are read once by a process that
may die of them.
"""
from __future__ import annotations

import functools
import os
import pathlib
import signal
from typing import Any

import h5py
import numpy as np

from chaindrive.errors import RunError
from chaindrive.parameters import Parameters
from chaindrive.run import Label, Run

#: What makes markup of a text, and signs that look alike.
LOOK_ALIKE = str.maketrans({"<": "\u2039", ">": "\u203a", '"': "\u2033", "'": "\u2019", "`": "\u2018"})


def plain(value: Any) -> Any:
    """A value of a file, with lists and members, whose texts are no markup."""
    if isinstance(value, str):
        return value.translate(LOOK_ALIKE)
    if isinstance(value, dict):
        return {plain(name): plain(member) for name, member in value.items()}
    if isinstance(value, list):
        return [plain(member) for member in value]
    return value


def _read_all(path: pathlib.Path) -> None:
    with h5py.File(path, "r") as file:
        def read(_: str, item: h5py.Dataset | h5py.Group) -> None:
            list(item.attrs.items())
            if isinstance(item, h5py.Dataset) and item.size and np.issubdtype(item.dtype, np.floating):
                rows = max(1, int(4e6 / max(1, item.size // item.shape[0]))) if item.shape else 1
                for first in range(0, item.shape[0] if item.shape else 1, rows):
                    item[first:first + rows] if item.shape else item[()]
        file.visititems(read)


def check(path: pathlib.Path) -> None:
    """Reads an HDF5 file to its end: a RunError if it is damaged.

    The library may crash, or never return: a child process reads it first.
    """
    child = os.fork()
    if child == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
        signal.alarm(60)
        try:
            _read_all(path)
        except BaseException:  # noqa: B902  whatever it is, it is the answer
            os._exit(1)
        os._exit(0)
    _, status = os.waitpid(child, 0)
    if status != 0:
        raise RunError(f"'{path}' is damaged or no HDF5 file of chaindrive.")


class ForeignRun(Run):
    """A run of which only harmless texts are read. `damage`: what is wrong with its summary, which then is empty."""

    damage = ""

    def _json(self, name: str) -> Any:
        found = plain(super()._json(name))
        if name == "acoustics.json" and not isinstance(found, dict):
            raise RunError(f"'{self.folder / name}' is not the noise of a run.")
        return found

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json; empty where it is damaged."""
        try:
            return super().summary
        except RunError as error:
            self.damage = str(error)
            return {}

    @functools.cached_property
    def parameters(self) -> Parameters:
        """All entries as they were used."""
        return Parameters(plain(self._parameter_text()))

    @functools.cached_property
    def file(self) -> h5py.File:
        """histories.h5, opened."""
        if (self.folder / "histories.h5").exists():
            check(self.folder / "histories.h5")
        return super().file

    def attribute(self, name: str) -> Any:
        """An attribute of histories.h5."""
        return plain(super().attribute(name))

    def labels(self, path: str) -> list[Label]:
        """Labels of the columns of a dataset."""
        return [plain(label) for label in super().labels(path)]

    def unit(self, path: str) -> str:
        """Unit of a dataset."""
        return str(plain(super().unit(path)))

    def description(self, path: str) -> str:
        """What a dataset is, in words."""
        return str(plain(super().description(path)))
