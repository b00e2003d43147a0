# SPDX-License-Identifier: LGPL-2.1-or-later
"""What sections of a report are made of."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import numpy as np

from chaindrive.errors import RunError
from chaindrive.report.figure import Curve, Figure, Panel
from chaindrive.report.foreign import ForeignRun
from chaindrive.run import Array

T = TypeVar("T")


class Subject:
    """A run in a report: its name there and its colour."""

    def __init__(self, run: ForeignRun, name: str, color: int) -> None:
        self.run, self.name, self.color = run, name, color


def of_each(subjects: Sequence[Subject],
            make: Callable[[Subject], T]) -> tuple[list[tuple[Subject, T]], list[str]]:
    """What `make(subject)` gives for those runs that can, and the sentences of those that cannot."""
    done, missing = [], []
    for subject in subjects:
        try:
            done.append((subject, make(subject)))
        except RunError as error:
            missing.append(str(error))
        except DAMAGE as error:
            missing.append(f"This could not be drawn of the run in '{subject.run.folder}': {of_other_files(error)}")
    return done, list(dict.fromkeys(missing))


#: What files that are damaged, or of other versions, make of a reader.
DAMAGE = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError, OSError, RuntimeError, StopIteration)


def of_other_files(error: BaseException) -> str:
    """A sentence on files that a reader does not expect."""
    return f"its files are damaged, or not as this version writes them ({type(error).__name__}: {error})."


def together(subjects: Sequence[Subject], key: str, title: str, sentence: str, x: str, y: str,
             curve_of: Callable[[ForeignRun], tuple[Array, Array]], **axes: Any) -> Figure:
    """A figure with a curve for each run on the same axes; `curve_of(run)` gives x and y."""
    done, missing = of_each(subjects, lambda subject: curve_of(subject.run))
    curves = [Curve(s.name if len(subjects) > 1 else "", px, py, s.color, s.color) for s, (px, py) in done]
    return Figure(key, title, sentence, [Panel(x, y, curves, **axes)], missing)


def beside(subjects: Sequence[Subject], key: str, title: str, sentence: str,
           panels_of: Callable[[ForeignRun], list[Panel]]) -> Figure:
    """A figure with a panel or several for each run; `panels_of(run)` gives them. The panels of several runs have their names."""
    done, missing = of_each(subjects, lambda subject: panels_of(subject.run))
    panels = []
    for number in range(max((len(p) for _, p in done), default=0)):
        for subject, own in done:
            if number < len(own):
                if len(subjects) > 1:
                    own[number].title = ": ".join(part for part in (subject.name, own[number].title) if part)
                panels.append(own[number])
    return Figure(key, title, sentence, panels, missing)


def finite(x: Array, y: Array) -> tuple[Array, Array]:
    """Without points that are no numbers."""
    good = np.isfinite(x) & np.isfinite(y)
    return np.asarray(x)[good], np.asarray(y)[good]
