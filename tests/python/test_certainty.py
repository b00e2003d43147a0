# SPDX-License-Identifier: LGPL-2.1-or-later
"""How certain means and differences are: against the program, tables of Student's distribution, and sequences whose mean is known."""
import math
import shutil

import numpy as np
import pytest

import chaindrive
from chaindrive import certainty, comparison

LONGER = {"Time/End time in ms": 30, "Output/Window start in ms": 8}
START = "Drive/Layout/Start phase"


@pytest.fixture(scope="module")
def runs(run):
    return [run("plain", LONGER), run("rough", {**LONGER, "Contact/Friction coefficient": 0.2}), run("late", {**LONGER, START: 0.5}),
            run("light", {**LONGER, "Loads/Resisting torque in N m": 75})]


def test_quantiles():
    # M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, table 26.10
    for degrees, expected in ((1, 12.706), (2, 4.303), (3, 3.182), (4, 2.776), (9, 2.262), (19, 2.093)):
        assert certainty.student(degrees) == pytest.approx(expected, rel=0, abs=6e-4)


def test_what_the_program_says(runs):
    plain = runs[0]
    for signal in ("tight_tension", "slack_tension", "driven_speed", "span_speed", "driven_load"):
        found, written = comparison.means(plain, f"{signal}_mean"), plain.summary["statistics"][signal]
        assert len(found.values) == plain.summary["statistics"]["tooth_periods"] >= 6
        # samples of 20 us instead of all steps
        assert certainty.uncertainty_of_mean(found.values, found.least) == pytest.approx(written["uncertainty"], rel=0.02, abs=0), signal
    impacts = comparison.means(plain, "driver_peak_force_mean")
    assert certainty.uncertainty_of_mean(impacts.values, impacts.least) == pytest.approx(
        plain.summary["impacts"]["driver"]["peak_force"]["uncertainty"], rel=1e-9, abs=0)
    statistics, spans = plain.summary["statistics"], {span["label"]: span for span in plain.summary["spans"].values()}
    assert spans["tight"]["tension_uncertainty"] == statistics["tight_tension"]["uncertainty"]
    assert spans["slack"]["tension_uncertainty"] == statistics["slack_tension"]["uncertainty"]
    assert spans["tight"]["speed_uncertainty"] == statistics["span_speed"]["uncertainty"] != spans["slack"]["speed_uncertainty"] > 0
    times = comparison.means(plain, "pitch_time_mean")
    assert certainty.uncertainty_of_mean(times.values, times.least) == pytest.approx(plain.summary["pitch_time_uncertainty"], rel=1e-9, abs=0)


def test_what_the_program_says_of_losses(runs):
    # of two kinds, of all, and of the efficiency, the ratio of what comes out to that and what is lost (Cochran)
    for run in runs:
        loss = comparison.means(run, "loss")
        edges = run.start + run.pitch_time * np.arange(len(loss.values) + 1)

        def rates(*names, run=run, edges=edges):
            return np.diff(sum(np.interp(edges, run.time, run[f"energy/{name}"]) for name in names)) / run.pitch_time

        out, lost, energy = rates("resisting_work"), loss.values, run.summary["window_energy"]
        off = out - run.summary["efficiency"] * (out + lost)
        teeth = sum(run.summary["losses"][f"roller-{wheel}"]["uncertainty"] ** 2 for wheel in ("driver", "driven")) ** 0.5
        for written, expected in ((run.summary["losses"]["chain damping"]["uncertainty"], rates("chain_damping_loss")),
                                  (energy["lost_uncertainty"] / energy["duration"], lost),
                                  (run.summary["efficiency_uncertainty"], off / (out + lost).mean())):
            assert certainty.uncertainty_of_mean(expected, loss.least) == pytest.approx(written, rel=0.1, abs=0)
        assert comparison.uncertainty(run, "loss") < 3 * (teeth + run.summary["losses"]["chain damping"]["uncertainty"])


def test_every_mean_has_its_interval(runs):
    table = chaindrive.compare(runs)
    known = {name for name in table.index if math.isfinite(table.loc[name, "plain uncertainty"])}
    assert {"driven_speed_mean", "driver_torque_mean", "tight_tension_mean", "slack_tension_mean", "span_speed_mean", "pitch_time_mean",
            "efficiency", "loss", "driver_load_mean", "driver_peak_force_mean", "driver_impulse_mean", "driver_normal_speed_mean",
            "driven_speed_deviation"} <= known, set(table.index) - known
    assert table.loc["efficiency", "plain uncertainty"] == runs[0].summary["efficiency_uncertainty"]
    assert not known & {"driven_angle_end", "tight_tension_largest", "cpu_seconds"}


def test_losses(runs):
    for run in runs:
        energy, loss = run.summary["window_energy"], comparison.means(run, "loss")
        edges = run.start + run.pitch_time * np.arange(len(loss.values) + 1)
        lost = sum(np.interp(edges, run.time, run[f"energy/{name}_loss"]) for name in ("friction", "contact_damping", "chain_damping"))
        assert loss.values == pytest.approx(np.diff(lost) / run.pitch_time, rel=1e-6, abs=0)
        assert comparison.means(run, "efficiency").values.mean() == pytest.approx(
            1 - loss.values.mean() * energy["duration"] / (energy["drive_work"] - energy["stored"]), rel=1e-12, abs=0)


def test_intervals_hold_what_they_promise():
    """Of 95 % intervals of differences, 95 % hold the true one: with what both have in common paired, and without."""
    make, paired, apart, trials = np.random.default_rng(1), [], [], 600
    widths = []
    for _ in range(trials):
        common, own = 10. * make.standard_normal(80), make.standard_normal((2, 80))
        one, other = (certainty.Means(common + own[0] + 3., 1, ("drive", 0.)), certainty.Means(common + own[1], 1, ("drive", 0.)))
        stranger = other._replace(values=10. * make.standard_normal(80) + own[1], phase=("drive", 0.25))
        for second, found in ((other, paired), (stranger, apart)):
            certain = certainty.of_difference(one, second)
            assert certain.words == (certainty.PAIRED if second is other else certainty.APART)
            found.append(abs(np.mean(one.values) - np.mean(second.values) - 3.) <= certain.uncertainty)
            widths.append(certain.uncertainty)
    # binomial: 3 standard deviations of 600 trials are 2.7 %; the correlation of neighbours makes intervals a little longer, not shorter
    assert 0.92 < np.mean(paired) <= 0.99 and 0.92 < np.mean(apart) <= 0.995
    # without what is common only the scatter of each is left: sqrt(2) / (10 sqrt(2)); root of a sum of squares for the others
    assert np.median(widths[::2]) / np.median(widths[1::2]) == pytest.approx(0.1, rel=0.15, abs=0)


def test_correlation_lengthens_intervals():
    """A sequence of first order, correlated over a few values, whose plain standard error is too short by a factor of 3."""
    make, inside, trials = np.random.default_rng(2), 0, 400
    for _ in range(trials):
        values = np.zeros(400)
        for k in range(1, 400):
            values[k] = 0.8 * values[k - 1] + make.standard_normal()
        inside += abs(values[50:].mean()) <= certainty.uncertainty_of_mean(values[50:])
    assert 0.90 < inside / trials


def test_fewer_than_four():
    assert math.isnan(certainty.uncertainty_of_mean([1., 2., 3.])) and math.isfinite(certainty.uncertainty_of_mean([1., 2., 3., 4.]))
    assert math.isnan(certainty.uncertainty_of_mean(np.arange(11.), least=3))
    few = certainty.Means(np.arange(3.), 1, ("drive", 0.))
    assert certainty.of_difference(few, few).words == certainty.FEW


def test_differences_of_runs(runs):
    plain, rough, late, light = runs
    table = chaindrive.compare(runs)
    row = table.loc["driver_torque_mean"]
    assert row["rough certainty"] == certainty.PAIRED == table.loc["driver_peak_force_mean", "rough certainty"]
    assert row["late certainty"] == certainty.APART
    assert abs(row["light difference"]) > 5 * row["light difference uncertainty"]  # half of the torque is no chance
    means = [comparison.means(run, "driver_torque_mean") for run in (plain, rough)]
    assert row["rough difference uncertainty"] == certainty.uncertainty_of_mean(means[1].values - means[0].values, means[0].least)
    apart = np.hypot(*(certainty.uncertainty_of_mean(one.values, one.least) for one in means))
    assert row["rough difference uncertainty"] < 0.5 * apart
    assert table.loc["tight_tension_largest", "rough certainty"] == certainty.SINGLE
    assert math.isnan(table.loc["tight_tension_largest", "rough difference uncertainty"])
    deviations = table.loc["driven_speed_deviation"]
    assert 0 < deviations["rough difference uncertainty"] < plain.summary["statistics"]["driven_speed"]["deviation"]
    same = chaindrive.compare([plain, plain])
    assert same.loc["tight_tension_mean"].iloc[-2] == 0.


def test_runs_without_histories(runs, tmp_path):
    shutil.copytree(runs[0].folder, tmp_path / "bare")
    (tmp_path / "bare/histories.h5").unlink()
    bare = chaindrive.open("bare")
    row = chaindrive.compare([runs[0], bare]).loc["tight_tension_mean"]
    uncertainty = runs[0].summary["statistics"]["tight_tension"]["uncertainty"]
    assert row["bare certainty"] == certainty.APART
    assert row["bare difference uncertainty"] == pytest.approx(np.sqrt(2) * uncertainty, rel=1e-9, abs=0)
    assert chaindrive.compare([runs[0], bare]).loc["driven_speed_deviation", "bare certainty"] == certainty.UNSAMPLED


def test_too_short_a_window(run):
    short = chaindrive.compare([run("simple"), run("braked", {"Loads/Resisting torque in N m": 75})])
    assert short.loc["driver_torque_mean", "braked certainty"] == certainty.FEW
    assert math.isnan(short.loc["driver_torque_mean", "braked difference uncertainty"])
