# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results for other programs: histories as CSV files, the sound of a run as WAV files.

python3 -m chaindrive.export DIRECTORY... --as csv | wav [--output FOLDER] writes them and prints their paths.
"""
from __future__ import annotations

import argparse
import csv
import math
import os
import pathlib
import re
import sys
import wave
from collections.abc import Sequence

import h5py
import numpy as np

from chaindrive import comparison
from chaindrive.errors import RunError, exit_status
from chaindrive.files import replacing
from chaindrive.report.foreign import ForeignRun
from chaindrive.run import Array, Run

#: Samples per second of WAV files.
RATE = 48000
#: Their length, s.
SECONDS = 5
#: The largest pressure of all, of the largest number of a file: 1 dB is left.
HEADROOM = 10 ** (-1 / 20)


def as_csv(run: Run, folder: str | os.PathLike[str] | None = None) -> list[pathlib.Path]:
    """Writes each group of histories to histories_GROUP.csv in `folder`, that of the run by default; returns the paths.

    The first line names the columns with their units, as in files that `Output/CSV` asks for; time, s, is the first.
    Numbers have the digits that are needed to read them back exactly. RunError where histories are missing or
    damaged.
    """
    into = pathlib.Path(folder) if folder is not None else run.folder
    n_samples = len(run.time)
    groups: dict[str, list[str]] = {}
    for path in run.histories.index:
        history = run.dataset(path)
        if "/" in path and history.ndim in (1, 2) and len(history) >= n_samples and np.issubdtype(history.dtype, np.floating):
            groups.setdefault(path.split("/")[0], []).append(path)
    if not groups:
        raise RunError(f"The run in '{run.folder}' has no histories; Output/Quantities asks for them.")
    return [_group_as_csv(run, into / f"histories_{_word(group)}.csv", paths) for group, paths in groups.items()]


def _group_as_csv(run: Run, file: pathlib.Path, paths: Sequence[str]) -> pathlib.Path:
    titles, columns = ["time [s]"], [run.time[:, None]]
    for path in sorted(paths, key=lambda path: int(h5py.h5o.get_info(run.dataset(path).id).addr)):  # as the run has made them
        name, unit = path.split("/", 1)[1], run.unit(path)
        values = run.values(path).reshape(len(run.time), -1)
        labels = [name] if run.dataset(path).ndim == 1 else [f"{name} {label}" for label in run.labels(path)]
        titles += [_title(f"{label} [{unit}]") for label in labels]
        columns.append(values)
    file.parent.mkdir(parents=True, exist_ok=True)
    with replacing(file) as part, open(part, "w", newline="", encoding="utf-8") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(titles)
        for row in range(len(run.time)):
            writer.writerow([_shortest(value) for values in columns for value in values[row]])
    return file


def _shortest(value: np.floating) -> str:  # type: ignore[type-arg]
    """The fewest digits from which its type reads the number back."""
    text = str(value)
    return text[:-2] if text.endswith(".0") else text


def _word(text: str) -> str:
    """A part of a file name: whatever else a text of a file has, its letters and digits."""
    return re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_")[:80] or "unnamed"


def _title(text: str) -> str:
    """A title that a spreadsheet does not take for a formula."""
    text = re.sub(r"[\x00-\x1f]", " ", text)
    return f"'{text}" if text[:1] in ("=", "+", "-", "@") else text


def as_wav(runs: Sequence[Run], folder: str | os.PathLike[str] | None = None) -> tuple[list[pathlib.Path], float]:
    """Writes what each observer of each run hears to noise_OBSERVER.wav; returns the paths and the full scale, Pa.

    Into `folder`, or that of the run by default; of several runs their names are part of those of the files, in a
    `folder`. Files have 24 bits, 48 kHz, one channel and five seconds, in which the record of the run is repeated
    (`loop`). All have the same full scale, so that they can be compared by ear: 1 dB above the largest pressure.
    RunError when no noise of a run was computed.
    """
    sounds: list[tuple[pathlib.Path, Array]] = []
    for run, name in zip(runs, comparison.names(runs)):
        into = pathlib.Path(folder) if folder is not None else run.folder
        which = f"{_word(name)}_" if folder is not None and len(runs) > 1 else ""
        heard = run.sound()
        observers = [_word(str(observer)) for observer in heard.columns]
        for k, observer in enumerate(observers):
            again = f"_{k}" if observer in observers[:k] else ""
            pressure = heard.iloc[:, k].to_numpy(float)
            repeated = loop(heard.index.to_numpy(float), pressure, _periods(run), _highest(run))
            sounds.append((into / f"noise_{which}{observer}{again}.wav", repeated))
    if len({file for file, _ in sounds}) < len(sounds):
        raise RunError("Two runs of one name would write the same files: export them one at a time.")
    full = max(float(np.abs(sound).max()) for _, sound in sounds) / HEADROOM
    if not math.isfinite(full) or full <= 0:
        raise RunError("There is nothing to be heard: the pressure is zero or not a number.")
    for file, sound in sounds:
        file.parent.mkdir(parents=True, exist_ok=True)
        with replacing(file) as part:
            _write_wav(part, sound / full)
    return [file for file, _ in sounds], full


def _number(run: Run, name: str) -> float:
    value = run.acoustics.get(name)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value) or value <= 0:
        raise RunError(f"'{run.folder / 'acoustics.json'}' has no {name}: chaindrive noise {run.folder} computes it again.")
    return float(value)


def _periods(run: Run) -> int:
    return max(1, int(_number(run, "periods")))


def _highest(run: Run) -> float:
    return _number(run, "highest_frequency")


def loop(time: Array, pressure: Array, periods: int, highest: float, seconds: float = SECONDS) -> Array:
    """`seconds` of a record of whole pitch times, at RATE.

    `time`, s, evenly spaced, and `pressure` are the record of so many `periods`. Its end would not go over into its
    beginning without a click. The loop has one pitch time less, and in the first tenth of its first one the beginning
    of the one that is left out fades out while it fades in itself (a single pitch time is repeated as it is).
    Frequencies above `highest`, Hz, are left out.
    RunError for a record without two samples in a pitch time.
    """
    period = len(pressure) // periods
    if period < 2 or len(time) != len(pressure) or not np.isfinite(pressure).all() or not time[-1] > time[0]:
        raise RunError("The record of the pressure is damaged, or too short to be heard.")
    step = (time[-1] - time[0]) / (len(time) - 1)
    once = pressure[:periods * period].copy()
    if periods > 1:
        once, rest = once[:-period], once[-period:]
        fading = -(-period // 10)
        fade = np.arange(fading) / fading
        once[:fading] = fade * once[:fading] + (1 - fade) * rest[:fading]
    lines = np.fft.rfft(once)
    lines[np.fft.rfftfreq(len(once), step) > highest] = 0
    finer = 16  # the record has four samples or so in the shortest period
    at = np.arange(round(seconds * RATE)) * finer / (RATE * step) % (finer * len(once))
    once = finer * np.fft.irfft(lines, finer * len(once))
    return np.interp(at, np.arange(len(once) + 1), np.append(once, once[0]))


def _write_wav(file: pathlib.Path, sound: Array) -> None:
    """Numbers from -1 to 1 as 24 bits."""
    whole = np.round(sound * (2 ** 23 - 1)).astype("<i4")
    with open(file, "wb") as out, wave.open(out, "wb") as to:
        to.setnchannels(1)
        to.setsampwidth(3)
        to.setframerate(RATE)
        to.writeframes(whole.view(np.uint8).reshape(-1, 4)[:, :3].tobytes())


def main() -> int:
    """Write the files that the command line asks for, and return the exit status."""
    parser = argparse.ArgumentParser(prog="chaindrive export", description="Writes results for other programs.")
    parser.add_argument("folders", nargs="+", metavar="DIRECTORY", help="directory with the results of a run")
    parser.add_argument("--as", choices=("csv", "wav"), required=True, dest="kind", help="histories (csv) or sound (wav)")
    parser.add_argument("--output", metavar="FOLDER", help="folder of the files; by default the directory of each run")
    parser.add_argument("--quiet", action="store_true", help="do not print the paths")
    words = parser.parse_args()
    return exit_status(lambda: _export(words), "The files, or their names,")


def _export(words: argparse.Namespace) -> None:
    files, line = _write(words)
    if not words.quiet:
        print(line, *files, sep="\n", flush=True)


def _write(words: argparse.Namespace) -> tuple[list[pathlib.Path], str]:
    runs = [ForeignRun(folder, partial=words.kind == "csv") for folder in words.folders]
    if words.kind == "wav":
        files, full = as_wav(runs, words.output)
        return files, f"{len(files)} files of {SECONDS} s, whose full scale is {full:.4g} Pa:"
    if words.output is not None and len(runs) > 1:
        raise RunError("Histories of several runs would write the same files: name one run with --output, or leave it out.")
    files = [file for run in runs for file in as_csv(run, words.output)]
    return files, f"{len(files)} files:"


if __name__ == "__main__":
    sys.exit(main())
