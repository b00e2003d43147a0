# SPDX-License-Identifier: LGPL-2.1-or-later
"""chaindrive report: what runs have found, as one page. write() makes it; page.py is how it looks."""
from __future__ import annotations

import os
import pathlib
from collections.abc import Callable, Iterator, Sequence
from typing import Any, TypeVar

import numpy as np

from chaindrive import comparison
from chaindrive.report import curves, facts, motion
from chaindrive.report.answers import Answer, answers
from chaindrive.report.page import Page, Part
from chaindrive.errors import RunError
from chaindrive.report.foreign import ForeignRun, plain
from chaindrive.report.parts import DAMAGE, Subject, of_each, of_other_files
from chaindrive.report.text import escape, number, quantity, sentences, table
from chaindrive.run import Run

T = TypeVar("T")

#: As many as there are colours.
MOST_RUNS = 7


def write(folders: Sequence[str | os.PathLike[str]],
          file: str | os.PathLike[str] | None = None) -> pathlib.Path:
    """Writes the report on the runs in `folders` to `file`, report.html in the first folder by default; returns its path.

    RunError when a folder is not that of a run.
    """
    runs = [ForeignRun(folder, partial=True) for folder in folders]
    names = [plain(name) for name in comparison.names(runs)]
    subjects = [Subject(run, name, k) for k, (run, name) in enumerate(zip(runs, names))]
    page = Page()
    file = pathlib.Path(file) if file is not None else runs[0].folder / "report.html"
    title = names[0] if len(runs) == 1 else "Comparison of " + ", ".join(names)
    page.write(file, title, _shown(_lead, subjects), [section for section in _sections(page, subjects) if section[2]])
    return file


def _shown(make: Callable[..., T], *arguments: Any) -> T | str:
    """What `make` gives, or the sentence on why it cannot."""
    try:
        return make(*arguments)
    except RunError as error:
        return sentences([error], "missing")
    except DAMAGE as error:
        return sentences([f"This could not be drawn: {of_other_files(error)}"], "missing")


def _lead(subjects: Sequence[Subject]) -> str:
    run = subjects[0].run
    if len(subjects) > 1:
        lead = f'<p class="lead">{len(subjects)} runs on the same axes; differences are those from {escape(subjects[0].name)}.</p>'
        known, _ = of_each(subjects, lambda s: (s.run.n_links, s.run.sprockets))
        if len(known) == len(subjects) and not comparison.one_drive([s.run for s in subjects]):
            lead += sentences(["These are runs of different drives: curves and figures differ by the drive too, and pitch times are not the same."])
    else:
        done, missing = of_each(subjects, lambda s: facts.drive_in_words(s.run))
        lead = "".join(f'<p class="lead">{words}, {escape(s.run.parameters.get("Model/Fidelity", ""))} model</p>' for s, words in done) + sentences(missing)
        question = facts.question(run)
        if question:
            lead += f'<p class="question">{escape(question.split("? ")[0] + "?" if "? " in question else question[:300])}</p>'
    for subject in subjects:
        subject.run.summary  # looks at it
        if subject.run.damage:
            lead += sentences([f"{subject.run.damage} What the other files hold is shown."])
        if not subject.run.finished:
            lead += sentences([f"The run in '{subject.run.folder}' has not finished: there is no summary.json. What its histories hold is shown."])
    return _events(subjects) + lead


def _events(subjects: Sequence[Subject]) -> str:
    """What makes figures of the runs meaningless, above all else."""
    texts = []
    for subject in subjects:
        which, faults = f"{subject.name}: " if len(subjects) > 1 else "", subject.run.window_faults
        texts += [f"{which}{fault} Means over the window are not valid." for fault in faults]
        texts += [f"{which}{sentence}" for sentence in subject.run.event_sentences if sentence not in faults]
    return sentences(texts)


def _each(subjects: Sequence[Subject], make: Callable[[ForeignRun], str], heading: bool = True) -> str:
    """HTML of each run, with its name above, and the sentences of those that have none."""
    done, missing = of_each(subjects, lambda s: make(s.run))
    out = "".join((f"<h3>{escape(s.name)}</h3>" if heading and len(subjects) > 1 else "") + html for s, html in done if html)
    return out + sentences(missing, "missing")


def _figure(value: float, unit: str, digits: int) -> str:
    return quantity(value, unit, digits) if unit not in ("%", "dB(A)") else f"{number(value, min(digits, 3))}\u00a0{unit}"


def _around(answer: Answer) -> str:
    """Half of the 95 % interval of a key figure; nothing where that is not known."""
    return f'<span class="around"> ± {_figure(answer.half, answer.unit, 2)}</span>' if np.isfinite(answer.half) else ""


def _cards(run: Run) -> str:
    found, invalid = answers(run), run.window_is_valid is False
    cards = "".join(f'<div class="card{" warning" if a.warns or invalid and a.of_window else ""}"><div class="name">{escape(a.name)}'
                    f'{facts.INVALID if invalid and a.of_window else ""}</div><div class="value">'
                    f'{_figure(a.value, a.unit, 4)}{_around(a)}</div><p>{a.sentence}</p></div>'
                    for a in found)
    return f'<div class="cards">{cards}</div>' if cards else sentences(["There are no key figures: the run has no summary, or was asked for none."])


def _what(subjects: Sequence[Subject]) -> str:
    if len(subjects) == 1:
        return table([], facts.what(subjects[0].run), classes="facts")
    done, missing = of_each(subjects, lambda s: dict(facts.what(s.run)))
    names = list(dict.fromkeys(name for _, rows in done for name in rows))
    return table(["", *(escape(s.name) for s, _ in done)], [(name, *(rows.get(name, "–") for _, rows in done)) for name in names],
                 classes="facts") + sentences(missing, "missing")


def _motion(page: Page, subjects: Sequence[Subject]) -> str:
    films, unmoved = of_each(subjects, lambda s: motion.frames_of(s.run))
    for one in ("low", "high"):  # the same colours for all
        extreme = (min if one == "low" else max)((frames[one] for _, frames in films), default=0)
        for _, frames in films:
            frames[one] = extreme
    return "".join(page.film(frames, s.name if len(subjects) > 1 else "") for s, frames in films) + sentences(unmoved, "missing")


def _sections(page: Page, subjects: Sequence[Subject]) -> Iterator[tuple[str, str, Sequence[Part]]]:
    """(key, title, parts) of all sections."""
    several = len(subjects) > 1
    moving = _shown(_motion, page, subjects)
    answered = [_shown(_each, subjects, _cards)]
    if several:
        done, missing = of_each(subjects[:1], lambda _: facts.differences(subjects))
        answered = [html for _, html in done] + [sentences(missing, "missing")]
        done, missing = of_each(subjects[:1], lambda _: facts.changed_entries(subjects))
        answered += [html for _, html in done] + [sentences(missing, "missing")]
        answered += [f"<details><summary>Key figures of {escape(s.name)} in sentences</summary>{_each([s], _cards)}</details>" for s in subjects]
    yield "answers", "Key figures", answered
    yield "checks", "Design checks", [_shown(facts.checks, subjects)]
    yield "run", "What was run", [_shown(_what, subjects)]
    yield "drive", "The drive", [_shown(_each, subjects, facts.drive_tables)]
    yield "motion", "The chain in motion", [moving]
    yield "spans", "Spans and shafts", [_shown(curves.tensions, subjects), _shown(curves.offsets, subjects), _shown(curves.shapes, subjects), _shown(curves.shafts, subjects)]
    yield "rollers", "Engaging rollers", [_shown(curves.velocities, subjects), _shown(curves.link_forces, subjects), _shown(curves.contact_forces, subjects),
                                          _shown(curves.plate_stress, subjects), _shown(facts.plate_table, subjects)]
    yield "impacts", "Impacts and tooth load", [_shown(curves.aligned, subjects), _shown(curves.peaks, subjects), _shown(curves.wrap, subjects)]
    yield "vibration", "Spectra", [_shown(curves.line_spectra, subjects), _shown(curves.roller_bands, subjects)]
    yield "noise", "Noise", [_shown(_each, subjects, facts.noise_tables), _shown(curves.noise_spectra, subjects), _shown(curves.pressures, subjects),
                             _shown(curves.noise_engagements, subjects), _shown(curves.directivity, subjects)]
    yield "statistics", "Window statistics", [_shown(_each, subjects, facts.statistics_tables)]
    yield "cost", "Energy and computing time", [_shown(curves.energies, subjects), _shown(_each, subjects, facts.costs)]
    yield "entries", "Entries", [_shown(_each, subjects, facts.all_entries)]
