# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests of a drive look at: a run, and how near its figures are."""
import math

import numpy as np

import chaindrive
import program


class Drive:
    """A run of a file by a program, with histories in the window."""

    def __init__(self, by, file):
        self.said = program.run(file, {"Output/History precision": "double"}, "--output", "results", program=by)
        self.run = chaindrive.open("results")
        self.summary = program.summary("results")
        self.time = np.asarray(self.run["time"])
        window = self.summary["window"]
        self.inside = (self.time >= window["start"]) & (self.time <= window["end"])
        self.wheels = {wheel["name"]: wheel for wheel in self.summary["drive"]["sprockets"]}
        program.check(window["valid"], f"not valid: {self.summary['events']}")

    def of(self, history, inside=True):
        values = np.asarray(self.run[history])
        return values[self.inside] if inside else values

    def tension(self, span):
        return self.summary["spans"][span]["tension_mean"]

    def pull(self, wheel):
        """Of the mean torque on a wheel."""
        return 2 * math.pi * self.of(f"hubs/{wheel}_torque").mean() / (self.wheels[wheel]["teeth"] * self.summary["drive"]["loaded_pitch"])


def near(what, is_value, wanted, within):
    print(f"{what}: {is_value:.6g}, wanted {wanted:.6g} +- {within:.2g}")
    program.check(abs(is_value - wanted) <= within, f"{what}: {is_value} instead of {wanted}")


def below(what, value, most):
    print(f"{what}: {value:.3g}, at most {most:.3g}")
    program.check(value <= most, f"{what}: {value}")
