# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wear of a chain, from a study against its elongation: hours between states, of which each has its rate of wear."""
import math

import numpy as np

import outputs
import stats

PATH, OUTPUT = "Drive/Chain/Elongation in percent", "wear_rate"
HOUR = 3600.  # s


def applies(about):
    """Whether the study is one of wear."""
    return about.get("against") == PATH and OUTPUT in about["outputs"]


def hours(elongations, rates):
    """Hours from the first of rising `elongations` [1] to each, where rates [1/s, of the present length] change as straight
    lines between them; nan from one on that does not wear, or is not known."""
    growing = np.asarray(rates, float) * (1. + np.asarray(elongations, float))  # of the new chain's length
    growing[~(growing > 0.)] = np.nan
    passed = [0.]
    for e, f, a, b in zip(elongations, elongations[1:], growing, growing[1:]):
        mean = a if math.isclose(a, b, rel_tol=1e-9) else (b - a) / math.log(b / a) if a > 0. and b > 0. else np.nan
        passed.append(passed[-1] + (f - e) / mean / HOUR)
    return np.array(passed)


class Curve:
    """The states of one chain: `elongations` [1], mean `rates` [1/s], and `hours` since it was new, with `low` and `high`
    ends of their 95 % intervals over start phases, nan for few of them; `limit`: elongation at which it is replaced."""

    def __init__(self, study, label, variants):
        self.label = label
        known = [v for v in variants if study.done(v) and np.isfinite(v["row"].get(OUTPUT, np.nan))]
        self.elongations = np.array([float(v["changes"][PATH]) / 100. for v in known])
        self.rates = np.array([v["row"][OUTPUT] for v in known])
        self.hours = hours(self.elongations, self.rates)[:len(known)]
        self.low = self.high = np.full(len(known), np.nan)
        phases = [p for p in (study.done(known[0]) if known else ()) if all(p in study.done(v) for v in known)]
        if len(phases) >= stats.FEWEST:
            by_phase = np.array([[study.done(v)[p]["values"].get(OUTPUT, np.nan) for p in phases] for v in known])
            wide = stats.half(lambda chosen: hours(self.elongations, by_phase[:, chosen].mean(axis=1))[:len(known)], len(phases))
            self.low, self.high = self.hours - wide, self.hours + wide
        self.limit = self._limit(study, known)

    @staticmethod
    def _limit(study, known):
        for variant in known:
            for run in variant["runs"]:
                if run["phase"] in study.done(variant):
                    return outputs.chaindrive.open(study.directory / run["folder"]).summary.get("life", {}).get("elongation", np.nan)
        return np.nan

    def life(self):
        """Hours from new to `limit`; nan where no state is as long as that, or none is new."""
        if len(self.hours) < 2 or self.elongations[0] != 0. or not self.elongations[-1] >= self.limit - 1e-12:
            return np.nan
        at = np.append(self.elongations[self.elongations < self.limit - 1e-12], self.limit)
        return float(hours(at, np.interp(at, self.elongations, self.rates))[-1])

    def first_guess(self):
        """Hours to `limit` by the rate of the first state alone, as that of one run has it."""
        return float(self.limit / self.rates[0] / HOUR) if len(self.rates) and self.rates[0] > 0. else np.nan


def curves(sweep):
    """Those of a study of wear that have two states and more."""
    found = [Curve(sweep.study, label, variants) for label, variants in sweep.curves.items()]
    return [curve for curve in found if len(curve.hours) > 1]


def rounded(value):
    """Hours to three digits, without a power of ten."""
    return "-" if not np.isfinite(value) else f"{float(f'{value:.3g}'):.0f}" if abs(value) >= 100 else f"{value:.3g}"


def tables(found):
    """(head, body) of each curve."""
    all_tables = []
    for curve in found:
        head = ["elongation (%)" + (f", {curve.label}" if curve.label else ""), "wears in 1000 h by (%)", "hours since new", "95 % interval"]
        body = [[f"{100 * e:.4g}", f"{100 * r * 1000 * HOUR:.3g}", rounded(h), f"{rounded(low)} ... {rounded(high)}" if np.isfinite(low) and h > 0 else "-"]
                for e, r, h, low, high in zip(curve.elongations, curve.rates, curve.hours, curve.low, curve.high)]
        if np.isfinite(curve.life()):
            body.append([f"replaced at {100 * curve.limit:.3g}", "", rounded(curve.life()), f"by the first rate alone {rounded(curve.first_guess())}"])
        all_tables.append((head, body))
    return all_tables


def draw(found, axis, colours, marks, plain):
    """Elongation over hours, and what the first rate alone would have it."""
    for curve, colour, mark in zip(found, colours, marks):
        thousands = curve.hours / 1000.
        axis.plot(thousands, 100 * curve.elongations, mark + "-", color=colour, ms=4, lw=1.3, label=plain(curve.label or "chain"))
        sure = np.isfinite(curve.low)
        axis.hlines(100 * curve.elongations[sure], curve.low[sure] / 1000., curve.high[sure] / 1000., color=colour, lw=1)
        if np.isfinite(curve.first_guess()):
            end = curve.elongations[-1] / curve.limit * curve.first_guess() / 1000.
            axis.plot([0., end], [0., 100 * curve.elongations[-1]], ":", color=colour, lw=1)
    limits = {round(100 * curve.limit, 9) for curve in found if np.isfinite(curve.limit)}
    for limit in limits:
        axis.axhline(limit, color="0.5", lw=0.8, ls="--")
    axis.set(xlabel="hours, thousands", ylabel="elongation (%)", title="Wear of the chain")
    axis.set_xlim(left=0.)
    axis.grid(color="0.92", lw=0.6)
    if len(found) > 1:
        axis.legend(fontsize=8, frameon=False)
