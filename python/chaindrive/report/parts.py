# SPDX-License-Identifier: LGPL-2.1-or-later
"""What sections of a report are made of."""
import dataclasses

import numpy as np

from chaindrive.errors import RunError
from chaindrive.report.figure import Curve, Figure, Panel


@dataclasses.dataclass
class Section:
    """A heading with HTML and figures, in the order of `parts`."""
    key: str
    title: str
    parts: list = dataclasses.field(default_factory=list)


class Subject:
    """A run in a report: its name there and its colour."""

    def __init__(self, run, name, color):
        self.run, self.name, self.color = run, name, color


def of_each(subjects, make):
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


def of_other_files(error):
    return f"its files are damaged, or not as this version writes them ({type(error).__name__}: {error})."


def together(subjects, key, title, sentence, x, y, curve_of, **axes):
    """A figure with a curve for each run on the same axes; `curve_of(run)` gives x and y."""
    done, missing = of_each(subjects, lambda subject: curve_of(subject.run))
    curves = [Curve(s.name if len(subjects) > 1 else "", px, py, s.color, s.color) for s, (px, py) in done]
    return Figure(key, title, sentence, [Panel(x, y, curves, **axes)], missing)


def beside(subjects, key, title, sentence, panels_of):
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


def finite(x, y):
    """Without points that are no numbers."""
    good = np.isfinite(x) & np.isfinite(y)
    return np.asarray(x)[good], np.asarray(y)[good]
