# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run left behind, in the form that figures.py and criteria.py need."""
import json
import os
import re

import h5py
import numpy as np


class History:
    """Histories and summary of the run in `folder`; a dataset by its path: `run["time"]`."""

    def __init__(self, folder):
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            self.summary = json.load(file)
        self.file = h5py.File(os.path.join(folder, "histories.h5"), "r")
        self.time = self.file["time"][:]
        self.folder = folder
        self.along = np.array(self.file.attrs["span_direction"].split(), float)
        self.outward = np.array(self.file.attrs["span_normal"].split(), float)
        teeth = self.parameter("Driver teeth")
        self.pitch_time = 2 * np.pi / (teeth * self.parameter("Driver speed in rad/s"))
        self.n_links = int(self.parameter("Number of links"))
        self.start = self.summary["window"]["start"]

    def parameter(self, name):
        """A number from the parameter file, in the unit of its entry."""
        text = self.file.attrs["parameters"]
        return float(re.search(rf"set {re.escape(name)} = ([-+.\de]+)", text)[1])

    def __contains__(self, path):
        return path in self.file

    def __getitem__(self, path):
        return self.file[path][:]

    def column(self, path, number):
        """The column of a dataset that is labelled `number`."""
        dataset = self.file[path]
        labels = [str(label.decode() if isinstance(label, bytes) else label)
                  for label in dataset.attrs["columns"]]
        return dataset[:, labels.index(str(number))]

    def engagements(self, n=5):
        """The first `n` rollers that meet the driver in the window, 1 ms or more before the end:
        (roller, time, peak force)."""
        return [(e["roller"], e["time"], e["peak_force"]) for e in self.summary["engagements"]
                if e["sprocket"] == "driver" and e["complete"] and e["time"] >= self.start][:n]

    def velocity(self, roller, surface=True):
        """Velocity along the span and along its normal: of the roller's surface node where there is
        one and `surface` asks for it, or else of its centre of mass."""
        if surface and "rollers/surface_velocity_normal" in self:
            return (self.column("rollers/surface_velocity_tangential", roller),
                    self.column("rollers/surface_velocity_normal", roller))
        x = self.column("rollers/velocity_x", roller)
        y = self.column("rollers/velocity_y", roller)
        return tuple(x * axis[0] + y * axis[1] for axis in (self.along, self.outward))

    def link_behind(self, roller):
        """The link between a roller and the next one to arrive."""
        return (roller - 1) % self.n_links

    def between(self, start, end):
        return (self.time >= start) & (self.time <= end)

    def mean(self, values, start, end):
        return float(np.mean(values[self.between(start, end)]))

    def aligned(self, values, start, end, shift, n=2000):
        """`values` over [start, end] + shift at n instants, by linear interpolation."""
        return np.interp(np.linspace(start, end, n) + shift, self.time, values)
