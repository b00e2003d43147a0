# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drives that are computed from Python: parameter files with changed entries, one after the other or several at a time."""
from __future__ import annotations

import os
import pathlib
import shutil
import tempfile
import warnings
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Optional, Union

from chaindrive import run as results
from chaindrive import served
from chaindrive.errors import RunError

#: What an entry can be set to: lists are written with commas, True and False in small letters.
Value = Union[str, float, bool, Sequence[Union[str, float]]]

#: Names the program where it is neither in build/ of the sources nor on the PATH.
VARIABLE = "CHAINDRIVE_PROGRAM"

_STOPPED = 4


def find_program() -> str:
    """The path of the program. RunError when it is nowhere."""
    built = pathlib.Path(__file__).resolve().parents[2] / "build/source/chaindrive"
    given = os.environ.get(VARIABLE)
    found = given or (str(built) if built.exists() else shutil.which("chaindrive"))
    if not found or not shutil.which(found):
        raise RunError(f"There is no program '{found}'." if found else
                       f"The program chaindrive is not on the PATH: build it with ./run, install it, or name it in {VARIABLE}.")
    return found


class Drive:
    """A drive that can be computed: a parameter file whose entries may be changed.

        drive = chaindrive.Drive("prm/paper/simple.prm", {"Contact/Friction coefficient": 0.2})
        drive["Loads/Driver speed in rad/s"] = 300
        run = drive.run("results/fast")

    `entries` are {"Section/Entry": value}, as after --set. RunError where the program refuses something.
    """

    def __init__(self, file: str | os.PathLike[str], entries: Mapping[str, Value] | None = None, plugins: Sequence[str] = ()) -> None:
        self.file = pathlib.Path(file)
        self.entries = dict(entries or {})
        self.plugins = [str(plugin) for plugin in plugins]
        self._text: Optional[str] = None  # of a file that is yet to be written

    @classmethod
    def designed(cls, chain: str, teeth: tuple[int, int], centre: float, rpm: float, *, kW: float | None = None,
                 Nm: float | None = None, fidelity: str | None = None) -> Drive:
        """The drive that `chaindrive template` writes.

        A chain such as 10B, teeth of driver and driven sprocket, centre distance (mm), speed of the driver (rpm), and power
        (kW) or torque at the driver (N m).
        """
        options = {"chain": chain, "teeth": f"{teeth[0]}/{teeth[1]}", "centre": centre, "rpm": rpm, "kW": kW, "Nm": Nm, "fidelity": fidelity}
        words = [f"--{name}={value}" for name, value in options.items() if value is not None]
        drive = cls("drive.prm")
        drive._text = _done([find_program(), "template", *words])
        return drive

    def __getitem__(self, entry: str) -> Value:
        return self.entries[entry]

    def __setitem__(self, entry: str, value: Value) -> None:
        self.entries[entry] = value

    def changed(self, entries: Mapping[str, Value]) -> Drive:
        """A copy with other entries besides."""
        copy = Drive(self.file, {**self.entries, **entries}, self.plugins)
        copy._text = self._text
        return copy

    def plan(self) -> str:
        """What `chaindrive plan` prints: design data, what would be computed, its cost."""
        return self._start("plan")

    def run(self, folder: str | os.PathLike[str], *, ranks: int = 1, resume: bool = False) -> results.Run:
        """Computes the drive, writes the results into `folder` and returns them.

        `resume`: goes on from the last checkpoint there. What the program warns of is a Python warning. A run that is
        interrupted writes a checkpoint first.
        """
        self._start("run", "--quiet", "--output", str(folder), *(["--resume", "auto"] if resume else []), ranks=ranks)
        return results.open(folder)

    def _start(self, command: str, *options: str, ranks: int = 1) -> str:
        with tempfile.TemporaryDirectory(prefix="chaindrive-") as folder:
            file = self.file
            if self._text is not None:
                file = pathlib.Path(folder) / self.file
                file.write_text(self._text)
            sets = [word for name, value in self.entries.items() for word in ("--set", f"{name}={_written(value)}")]
            plugins = [word for plugin in self.plugins for word in ("--plugin", plugin)]
            launcher = ["mpirun", "-n", str(ranks)] if ranks > 1 else []
            return _done([*launcher, find_program(), command, str(file), *sets, *plugins, *options])


def run_all(drives: Mapping[str, Drive], folder: str | os.PathLike[str], cores: int | None = None) -> dict[str, results.Run]:
    """Computes the drives, `cores` of them at a time, by default as many as there are; returns the results by name.

    Each writes into the folder of its name in `folder`. RunError, when all others have come to their end, if one has failed.
    """
    failed: dict[str, RunError] = {}

    def run(name: str) -> Any:
        try:
            return drives[name].run(pathlib.Path(folder) / name)
        except RunError as error:
            failed[name] = error
            return None

    with served.serving(find_program()), ThreadPoolExecutor(cores or os.cpu_count()) as pool:
        found = dict(zip(drives, pool.map(run, drives)))
    if failed:
        raise RunError("\n".join(f"{name}: {error}" for name, error in failed.items()))
    return found


def _written(value: Value) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (str, int, float)):
        return str(value)
    return ", ".join(map(_written, value))


def _done(words: Sequence[str]) -> str:
    """What the words print. RunError, with their sentence, if they fail."""
    done = served.run(words, {**served.ENVIRONMENT, **os.environ})
    lines = [line.removeprefix("chaindrive: ").strip() for line in done.stderr.splitlines() if line.strip()]
    if done.returncode == _STOPPED:
        raise RunError(" ".join(lines) or "The run was stopped; resume=True goes on from its last checkpoint.")
    if done.returncode != 0:
        told = [line.removeprefix("chaindrive: ").strip() for line in done.stderr.splitlines() if line.startswith("chaindrive: ")]
        raise RunError(" ".join(told or lines[-1:]) or f"The program has ended with status {done.returncode}.")
    for line in lines:
        warnings.warn(line, stacklevel=4)
    return done.stdout
