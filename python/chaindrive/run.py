# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a run: what it found, over time and as figures."""
from __future__ import annotations

import functools
import json
import os
import pathlib
from collections.abc import Callable, Iterable
from typing import Any, Union

import h5py
import numpy as np
import numpy.typing as npt
import pandas as pd

from chaindrive import schema, spectra
from chaindrive.drive import Span, Wheel, as_now, spans_of, wheels_of
from chaindrive.errors import RunError
from chaindrive.parameters import Parameters
from chaindrive.summary import Summary
from chaindrive.units import Units, convert, squared

#: Numbers of a history, or of figures.
Array = npt.NDArray[np.float64]
#: What names a column: the number of a roller, link or tooth, or a text.
Label = Union[int, str]

#: Units of what is known of an engagement, by name.
ENGAGEMENT_UNITS = schema.below("engagements/*")

#: Bytes above which an array is read anew, and only the columns that are asked for.
LARGE = 64e6


def open(folder: str | os.PathLike[str], partial: bool = False) -> Run:
    """The run whose results are in `folder`.

    With `partial` also one that has no summary.json, because it goes on, was stopped or has failed.
    RunError when there is no such folder, none of a run, a file is damaged, or the run has not finished.
    """
    return Run(folder, partial)


class Run:
    """A run. `run["spans/tight_tension"]` is an array, `run.history(...)` a frame that knows its units."""

    def __init__(self, folder: str | os.PathLike[str], partial: bool = False) -> None:
        self.folder = pathlib.Path(folder)
        #: what tells it from others
        self.name = self.folder.resolve().name
        if not self.folder.is_dir():
            raise RunError(f"There is no folder '{folder}'." if not self.folder.exists() else
                           f"'{folder}' is a file: name the folder of a run.")
        known = ("summary.json", "histories.h5", "parameters.prm", "log.txt")
        if not any((self.folder / name).exists() for name in known[:3]):
            raise RunError(f"'{folder}' is not the folder of a run: it has no {known[0]}, no {known[1]} and no {known[2]}.")
        self.finished = (self.folder / known[0]).exists()
        if not self.finished and not partial:
            raise RunError(f"The run in '{folder}' has not finished: there is no summary.json. The end of log.txt says why; "
                           "--resume auto goes on from its last checkpoint.")

    # ---- figures

    def _json(self, name: str) -> Any:
        path = self.folder / name
        try:
            return json.loads(path.read_text(encoding="utf-8", errors="replace"))
        except OSError as error:
            raise RunError(f"'{path}' cannot be read: {error}.") from None
        except (json.JSONDecodeError, RecursionError) as error:
            raise RunError(f"'{path}' is damaged: {error}.") from None

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json: doc/output.md defines its members. Empty for a run that has not finished.

        Members have their present names, whichever version has written them, and are also found by old ones.
        """
        summary = self._json("summary.json") if self.finished else {}
        if not isinstance(summary, dict):
            raise RunError(f"'{self.folder / 'summary.json'}' is not the summary of a run.")
        return Summary(summary)

    @functools.cached_property
    def drive(self) -> dict[str, Any]:
        """What closed forms say of the drive, member `drive` of the summary; empty where it has none.

        In the words of this version, whichever has written it.
        """
        return as_now(self.summary.get("drive", {}), self._sense())

    def _sense(self) -> int | None:
        """That of the drive as its parameters say it, 1 is counter-clockwise; None without them."""
        try:
            return -1 if self.parameters.get("Drive/Layout/Tight span") == "lower" else 1
        except RunError:
            return None

    @property
    def wheels(self) -> tuple[Wheel, ...]:
        """Name and title of each sprocket, the driver first, in the direction of travel.

        Those that parameters can ask for where the summary does not say what the drive is.
        """
        return wheels_of(self.drive)

    @property
    def spans(self) -> tuple[Span, ...]:
        """Name, label and title of each span, the tight one first, against the direction of travel."""
        return spans_of(self.drive)

    @property
    def events(self) -> list[dict[str, Any]] | None:
        """What makes key figures of the run meaningless, such as a chain that jumped: member `events` of the summary.

        None where nobody looked, in runs that have not finished and summaries of older versions.
        """
        return self.summary.get("events")

    @property
    def window_is_valid(self) -> bool | None:
        """Whether means over the window tell what they are said to.

        False when one of the events lies in it; None where nobody looked, or there is no window.
        """
        window = self.summary.get("window")
        valid = window.get("valid") if isinstance(window, dict) else None
        return False if self._events_in_window() else valid if isinstance(valid, bool) else None

    @property
    def window_faults(self) -> list[str]:
        """Why the window is not valid, a sentence for each event in it; empty where it is valid, or nobody knows."""
        if self.window_is_valid is not False:
            return []
        return self._sentences(self._events_in_window()) or ["The summary says that the window is not valid, and not why."]

    @property
    def event_sentences(self) -> list[str]:
        """A sentence for each of the events, wherever it lies."""
        return self._sentences(self._valid_events())

    def _valid_events(self) -> list[dict[str, Any]]:
        """Events that are what they should be: a summary may come from anybody."""
        return [event for event in self.events if isinstance(event, dict)] if isinstance(self.events, list) else []

    def _events_in_window(self) -> list[dict[str, Any]]:
        return [event for event in self._valid_events() if event.get("in_window") is True]

    @staticmethod
    def _sentences(events: list[dict[str, Any]]) -> list[str]:
        return [event["sentence"] for event in events if isinstance(event.get("sentence"), str) and event["sentence"].strip()]

    @functools.cached_property
    def acoustics(self) -> dict[str, Any]:
        """acoustics.json, what `chaindrive noise` has found; empty without it."""
        found: dict[str, Any] = self._json("acoustics.json") if (self.folder / "acoustics.json").exists() else {}
        return found

    def sound(self, name: str = "pressure") -> pd.DataFrame:
        """What the observers of `chaindrive noise` hear: a frame with a column for each.

        `name`: pressure, Pa, over time in s, or spectrum, the mean square on each line, Pa2, over frequency in
        Hz. RunError when no noise was computed.
        """
        path = self.folder / "acoustics.h5"
        if not path.exists() or not self.acoustics:
            raise RunError(f"There is no noise of the run in '{self.folder}': chaindrive noise {self.folder} computes it.")
        over = {"pressure": "time", "spectrum": "frequency"}[name]
        try:
            with h5py.File(path, "r") as file:
                index, values = file[over][:], file[name][:]
        except (OSError, KeyError) as error:
            raise RunError(f"'{path}' is damaged: {error}.") from None
        try:
            columns = [observer["name"] for observer in self.acoustics["observers"]]
            frame = pd.DataFrame(values.reshape(len(index), -1), index=pd.Index(index, name=over), columns=columns)
        except (KeyError, TypeError, ValueError):
            raise RunError(f"'{self.folder / 'acoustics.json'}' is damaged, or is not of '{path}': its observers are others.") from None
        frame.attrs = {"unit": "Pa" if name == "pressure" else "Pa2"}
        return frame

    @functools.cached_property
    def parameters(self) -> Parameters:
        """All entries as they were used."""
        return Parameters(self._parameter_text())

    def _parameter_text(self) -> str:
        """A byte that is no UTF-8, as in a name of Latin-1, spoils its sign alone."""
        path = self.folder / "parameters.prm"
        if path.exists():
            try:
                return path.read_text(encoding="utf-8", errors="replace")
            except OSError as error:
                raise RunError(f"'{path}' cannot be read: {error}.") from None
        return str(self.attribute("parameters"))

    def parameter(self, name: str) -> float:
        """A number from the parameters, in the unit of its entry."""
        return self.parameters.number(name)

    @property
    def sprockets(self) -> tuple[int, ...]:
        """Teeth of all sprockets, those of the driver first."""
        if "sprockets" in self.drive:
            return tuple(int(one["teeth"]) for one in self.drive["sprockets"])
        return tuple(int(self.parameter(f"Drive/{wheel.name.capitalize()} teeth")) for wheel in self.wheels)

    @functools.cached_property
    def n_links(self) -> int:
        """The number of links of the chain."""
        return int(self.drive["links"] if "links" in self.drive else self.parameter("Drive/Number of links"))

    @functools.cached_property
    def pitch_time(self) -> float:
        """From one tooth of the driver to the next, s, at its full speed."""
        if "pitch_time" in self.drive:
            return float(self.drive["pitch_time"])
        return 2 * np.pi / (self.sprockets[0] * self.parameter("Loads/Driver speed in rad/s"))

    @property
    def window(self) -> tuple[float, float]:
        """Begin and end of the window of the means, s; of all histories where the summary has none.

        Two nan where the window waited for the drive to settle, and it has not.
        """
        if "window" not in self.summary:
            return self.time[0], self.time[-1]
        start, end = (np.nan if self.summary["window"][name] is None else self.summary["window"][name] for name in ("start", "end"))
        return start, end

    @property
    def start(self) -> float:
        """Begin of the window of the means, s."""
        return self.window[0]

    @property
    def end(self) -> float:
        """End of the window of the means, s."""
        return self.window[1]

    # ---- histories

    @functools.cached_property
    def file(self) -> h5py.File:
        """histories.h5, opened."""
        path = self.folder / "histories.h5"
        if not path.exists():
            raise RunError(f"There is no '{path}': the histories of this run were not kept.")
        try:
            return h5py.File(path, "r")
        except OSError as error:
            raise RunError(f"'{path}' is damaged or no HDF5 file: {error}.") from None

    def close(self) -> None:
        """Closes histories.h5."""
        if "file" in self.__dict__:
            self.file.close()

    def __enter__(self) -> Run:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def attribute(self, name: str) -> Any:
        """An attribute of histories.h5."""
        if name not in self.file.attrs:
            raise RunError(f"'{self.file.filename}' has no attribute '{name}': it was not written by chaindrive, or by a version that "
                           "is not compatible.")
        value = self.file.attrs[name]
        return value.decode() if isinstance(value, bytes) else value

    def _direction(self, name: str) -> Array:
        return np.array(str(self.attribute(name)).split(), float)

    @functools.cached_property
    def along(self) -> Array:
        """Unit vector along the tight span, in its direction of travel."""
        return self._direction("span_direction")

    @functools.cached_property
    def outward(self) -> Array:
        """Unit vector normal to the tight span, away from the other one."""
        return self._direction("span_normal")

    @functools.cached_property
    def time(self) -> Array:
        """Times of the samples, s. Rows that a run has not reached yet are left out, here and everywhere."""
        time = self._read("time", slice(None))
        time = time[:int(np.argmax(np.isnan(time)))] if np.isnan(time).any() else time
        if len(time) == 0:
            raise RunError(f"'{self.folder / 'histories.h5'}' has no samples yet.")
        return time

    def __contains__(self, path: str) -> bool:
        return path in self.file and isinstance(self.file[path], h5py.Dataset)

    def dataset(self, path: str) -> h5py.Dataset:
        """A dataset of histories.h5. RunError when it is missing, with the entry that makes it."""
        if path in self:
            return self.file[path]
        hint = ""
        for word in schema.history(path).get("quantities", []):
            hint = f" Output/Quantities makes it with '{word}'"
            if word in ("joint forces", "plate stress", "surface velocity"):
                hint += ", where the fidelity has such parts"
            hint += f"; this run had {self.parameters.get('Output/Quantities', 'none')}."
        raise RunError(f"The run in '{self.folder}' has no history '{path}'.{hint}")

    def _read(self, path: str, rows: Any) -> Array:
        try:
            values: Array = self.dataset(path)[rows]
        except OSError as error:
            raise RunError(f"The dataset '{path}' of '{self.folder / 'histories.h5'}' is damaged: {error}.") from None
        return values

    def rows(self, start: float | None = None, end: float | None = None) -> slice:
        """The samples from `start` to `end`, s, as a slice; all by default."""
        first = 0 if start is None else int(np.searchsorted(self.time, start))
        last = len(self.time) if end is None else int(np.searchsorted(self.time, end, side="right"))
        return slice(first, last)

    @functools.cached_property
    def _cache(self) -> Callable[[str, int, int], Array]:
        return functools.lru_cache(maxsize=6)(lambda path, first, last: self._read(path, slice(first, last)))

    def _is_large(self, path: str, rows: slice) -> bool:
        return bool(8 * (rows.stop - rows.start) * int(np.prod(self.dataset(path).shape[1:], dtype=int)) > LARGE)

    def values(self, path: str, start: float | None = None, end: float | None = None,
               every: int = 1) -> Array:
        """A dataset from `start` to `end` as an array, a row per sample, or per `every` samples."""
        rows = self.rows(start, end)
        if every > 1 or self._is_large(path, rows):
            return self._read(path, slice(rows.start, rows.stop, every))
        values = self._cache(path, rows.start, rows.stop)
        values.flags.writeable = False  # others get the same
        return values

    def __getitem__(self, path: str) -> Array:
        return self.values(path)

    def labels(self, path: str) -> list[Label]:
        """Labels of the columns of a dataset, whole numbers where they are numbers; of a single column its name."""
        attributes = self.dataset(path).attrs
        if "columns" not in attributes:
            n = self.dataset(path).shape[1:]
            return list(range(n[0])) if n else [path.split("/")[-1]]
        texts = [label.decode() if isinstance(label, bytes) else str(label) for label in np.atleast_1d(attributes["columns"])]
        return [int(text) if text.isdigit() else text for text in texts]

    def column(self, path: str, label: Label, start: float | None = None, end: float | None = None) -> Array:
        """The column of a dataset with this label, such as the number of a roller."""
        labels = self.labels(path)
        if label not in labels:
            entry = " Output/Rollers chooses them." if path.startswith("rollers/") else ""
            raise RunError(f"The history '{path}' of the run in '{self.folder}' has no column {label}.{entry}")
        rows = self.rows(start, end)
        if len(self.dataset(path).shape) > 1 and self._is_large(path, rows):
            return self._read(path, (rows, labels.index(label)))
        values = self.values(path, start, end)
        return values if values.ndim == 1 else values[:, labels.index(label)]

    def unit(self, path: str) -> str:
        """Unit of a dataset."""
        unit = self.dataset(path).attrs.get("unit", "1")
        return unit.decode() if isinstance(unit, bytes) else str(unit)

    def description(self, path: str) -> str:
        """What a dataset is, in words."""
        text = self.dataset(path).attrs.get("description", "")
        return text.decode() if isinstance(text, bytes) else str(text)

    @functools.cached_property
    def histories(self) -> pd.DataFrame:
        """What there is: a frame with a row per dataset, its unit, description and number of columns."""
        paths: list[str] = []
        self.file.visititems(lambda name, item: paths.append(name) if isinstance(item, h5py.Dataset) and name != "time" else None)
        rows = [(self.unit(path), self.description(path), int(np.prod(self.file[path].shape[1:], dtype=int))) for path in paths]
        return pd.DataFrame(rows, index=pd.Index(paths, name="history"), columns=["unit", "description", "columns"])

    def history(self, path: str, columns: Iterable[Label] | None = None, start: float | None = None,
                end: float | None = None, units: Units = ()) -> pd.DataFrame:
        """A dataset over time: a frame with time as index and a column per label, or only these `columns`.

        `units` names units to convert to, such as ("mm", "ms", "kN"). Attributes of the frame: unit,
        time_unit, description, history.
        """
        time_unit, time_scale = convert("s", units)
        unit, scale = convert(self.unit(path), units)
        labels = self.labels(path)
        if columns is None:
            values = self.values(path, start, end).reshape(-1, len(labels))
        else:
            labels = list(columns)
            values = np.column_stack([self.column(path, label, start, end) for label in labels])
        index = pd.Index(time_scale * self.time[self.rows(start, end)], name="time")
        frame = pd.DataFrame(scale * values, index=index, columns=labels)
        frame.attrs = {"unit": unit, "time_unit": time_unit, "description": self.description(path), "history": path}
        return frame

    def group(self, name: str, start: float | None = None, end: float | None = None,
              units: Units = ()) -> pd.DataFrame:
        """All histories of a group that have a single column, such as `hubs`, in one frame.

        Its attribute `units` has a unit for each column.
        """
        paths = [path for path in self.histories.index if path.startswith(name + "/") and self.file[path].ndim == 1]
        if not paths:
            self.dataset(name + "/")
        parts = [self.history(path, start=start, end=end, units=units) for path in paths]
        frame = pd.concat(parts, axis=1)
        frame.attrs = {"units": {path.split("/")[-1]: part.attrs["unit"] for path, part in zip(paths, parts)},
                       "time_unit": parts[0].attrs["time_unit"]}
        return frame

    # ---- engagements

    def engagements(self, sprocket: str | None = None, window: bool = False,
                    units: Units = ()) -> pd.DataFrame:
        """First touches of rollers with sprockets, one per row, as in the summary.

        All, or those with the sprocket of this name, such as "driver"; with `window` only those that begin in it and are
        complete. The attribute `units` has a unit for each column.
        """
        if "engagements" not in self.summary:
            raise RunError(f"The summary of the run in '{self.folder}' has no engagements." +
                           (" Output/Quantities makes them with 'engagements'." if self.finished else " The run has not finished."))
        frame = pd.DataFrame(self.summary["engagements"], columns=list(ENGAGEMENT_UNITS))
        if sprocket is not None:
            frame = frame[frame["sprocket"] == sprocket]
        if window:
            frame = frame[frame["complete"].astype(bool) & frame["time"].between(*self.window)]
        frame = frame.reset_index(drop=True)
        frame.attrs["units"] = {}
        for column, unit in ENGAGEMENT_UNITS.items():
            name, scale = convert(unit, units)
            frame.attrs["units"][column] = name
            if scale != 1.:
                frame[column] = scale * frame[column].astype(float)
        return frame

    def arrivals(self, n: int = 5) -> list[tuple[int, float, float]]:
        """The first `n` rollers that meet the driver in the window, 1 ms or more before the end: (roller, time, peak force)."""
        found = self.engagements("driver")
        found = found[found["complete"].astype(bool) & (found["time"] >= self.start)]
        return [(row.roller, row.time, row.peak_force) for row in found[:n].itertuples()]

    def aligned_engagements(self, sprocket: str = "driver", n: int | None = None, before: float = 0.2e-3,
                            after: float = 2e-3, quantity: str = "force_peak",
                            units: Units = ()) -> pd.DataFrame:
        """The force of the teeth on each roller that engages in the window, against the time since its touch.

        A frame with a column for each, its number in engagements(sprocket, window=True), from `before` to `after`
        the touch, s. `quantity`: force_peak, force, or gap.
        """
        path = f"rollers/{sprocket}_{quantity}"
        interval = self.interval()
        since = interval * np.arange(-int(round(before / interval)), int(round(after / interval)) + 1)
        columns: dict[int, Array] = {}
        for number, one in enumerate(self.engagements(sprocket, window=True).itertuples()):
            inside = one.time + since[0] >= self.time[0] and one.time + since[-1] <= self.time[-1]
            if inside and (n is None or len(columns) < n):
                part = (one.time + since[0] - 2 * interval, one.time + since[-1] + 2 * interval)
                time, values = self.time[self.rows(*part)], self.column(path, one.roller, *part)
                if quantity.endswith("_peak"):  # of the interval in which the instant lies: interpolation would cut peaks off
                    columns[number] = values[np.minimum(np.searchsorted(time, one.time + since), len(time) - 1)]
                else:
                    columns[number] = np.interp(one.time + since, time, values)
        unit, scale = convert(self.unit(path), units)
        time_unit, time_scale = convert("s", units)
        frame = pd.DataFrame(columns, index=pd.Index(time_scale * since, name="time since touch")) * scale
        frame.attrs = {"unit": unit, "time_unit": time_unit, "description": self.description(path), "history": path}
        return frame

    # ---- spectra

    def interval(self) -> float:
        """Time between two samples, s. RunError when it is not the same everywhere."""
        return spectra.interval_of(self.time, f"histories of the run in '{self.folder}'")

    def spectrum(self, path: str, label: Label | None = None, start: float | None = None,
                 end: float | None = None, window: str = "pitches") -> pd.DataFrame:
        """Mean square of a history per line of its spectrum, without its mean: a frame over frequency in Hz.

        From `start` to `end`, s, by default the window of the means. `window`: "pitches" cuts to whole
        pitch times, so that tooth harmonics do not leak; "hann" tapers, for what has no known period;
        "none". RunError for samples that are not equally spaced.
        """
        first, last = self.window
        first, last = (first if start is None else start), (last if end is None else end)
        self.interval()
        label = self.labels(path)[0] if label is None else label
        time, values = self.time[self.rows(first, last)], self.column(path, label, first, last)
        if len(time) < 8:
            raise RunError("The drive had not settled when the run ended: there is no window." if np.isnan(first) else
                           f"There are only {len(time)} samples between {first:g} s and {last:g} s: too few for a spectrum.")
        if window == "pitches":
            time, values = spectra.whole_periods(time, values, self.pitch_time)
        frequency, power = spectra.mean_square_lines(values - values.mean(), (time[-1] - time[0]) / (len(time) - 1),
                                                     "hann" if window == "hann" else "none")
        frame = pd.DataFrame({"mean_square": power}, index=pd.Index(frequency, name="frequency"))
        frame.attrs = {"unit": self.unit(path), "power_unit": squared(self.unit(path)), "history": path, "label": label, "description": self.description(path),
                       "window": window}
        return frame

    # ---- parts of curves, for scripts

    def velocity(self, roller: int, surface: bool = True) -> tuple[Array, Array]:
        """Velocity of a roller along the span and along its normal, m/s.

        Of its surface node where there is one and `surface` asks for it, or else of its centre of mass.
        """
        if surface and "rollers/surface_velocity_normal" in self:
            return (self.column("rollers/surface_velocity_tangential", roller),
                    self.column("rollers/surface_velocity_normal", roller))
        x = self.column("rollers/velocity_x", roller)
        y = self.column("rollers/velocity_y", roller)
        along, outward = (x * axis[0] + y * axis[1] for axis in (self.along, self.outward))
        return along, outward

    def link_behind(self, roller: int) -> int:
        """The link between a roller and the next one to arrive."""
        return (roller - 1) % self.n_links

    def between(self, start: float, end: float) -> npt.NDArray[np.bool_]:
        """Which samples lie between two times, s."""
        return (self.time >= start) & (self.time <= end)

    def mean(self, values: Array, start: float, end: float) -> float:
        """Mean of `values`, one per sample, between two times, s."""
        return float(np.mean(values[self.between(start, end)]))

    def aligned(self, values: Array, start: float, end: float, shift: float, n: int = 2000) -> Array:
        """`values` over [start, end] + shift at n instants, by linear interpolation."""
        return np.interp(np.linspace(start, end, n) + shift, self.time, values)
