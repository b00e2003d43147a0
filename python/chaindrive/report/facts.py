# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was run, the drive's block, statistics and costs, as HTML."""
from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Any

import numpy as np

from chaindrive import certainty, comparison, schema
from chaindrive.drive import span_title
from chaindrive.errors import RunError
from chaindrive.plates import plate_stresses
from chaindrive.report.answers import loads_are_alike, shaft_loads
from chaindrive.report.parts import Subject
from chaindrive.report.text import escape, number, percent, quantity, sentences, table
from chaindrive.run import Run

WORDS = {"simple": "lumped rollers and elastic bars", "layered": "rigid rollers and links with clearances",
         "reduced": "bodies that deform by some modes each", "full": "elastic finite elements"}

#: Beside what is found in a window whose means tell nothing.
INVALID = ' <b class="invalid">not valid</b>'


def invalid_window(run: Run, what: str) -> str:
    """A sentence above `what` that is found in the window of a run, where that is not valid; else nothing."""
    return sentences([f"{what} not valid: an event lies in the window, see above."]) if run.window_is_valid is False else ""


def question(run: Run) -> str:
    """The comment at the head of the parameter file, without the licence."""
    file = run.folder / "input.prm"
    lines = []
    for line in file.read_text(encoding="utf-8", errors="replace").splitlines() if file.exists() else []:
        if not line.startswith("#"):
            break
        if "SPDX" not in line:
            lines.append(line.lstrip("# ").rstrip())
    return " ".join(" ".join(lines).split())


def of_paper(subjects: Sequence[Subject], sentence: str) -> str:
    """A sentence on figures of the paper for runs whose files speak of it; of others, nothing: their readers do not know it."""
    return f" Zheng, Wang and Quek (2004) show it in {sentence}." if all("Zheng, Wang and Quek" in question(s.run) for s in subjects) else ""


def in_words(values: Sequence[object]) -> str:
    """Numbers as a sentence lists them: "15 and 42"."""
    *most, last = map(str, values)
    return f"{', '.join(most)} and {last}" if most else last


def drive_in_words(run: Run) -> str:
    """The drive in a line, as HTML."""
    drive = run.drive
    if not drive:
        return f"{run.n_links} links, {in_words(run.sprockets)} teeth"
    first = drive["sprockets"][0]
    return (f"{escape(drive['chain'])} chain of {drive['links']} links, {in_words([one['teeth'] for one in drive['sprockets']])} teeth, "
            f"{quantity(first['speed'], 'rad/s')}, {quantity(drive['power'], 'W')}")


def what(run: Run) -> list[tuple[str, str]]:
    """Facts about the run itself: (name, HTML)."""
    entries, fidelity = run.parameters, run.parameters.get("Model/Fidelity", "")
    rows = [("drive", drive_in_words(run)), ("model", f"{escape(fidelity)}: {WORDS.get(fidelity, '')}")]
    summary = run.summary
    if run.finished:
        start, end = run.window
        if np.isfinite(start):
            periods = (end - start) / run.pitch_time
            rows.append(("window of the means", f"{quantity(start, 's')} to {quantity(end, 's')}, {number(periods, 3)} pitch times"
                         + (INVALID if run.window_is_valid is False else "")))
        else:
            rows.append(("window of the means", "none: the drive had not settled when the run ended"))
        rows.append(("time step", f"{quantity(summary.get('time_step'), 's')}, {number(summary.get('steps'))} steps; stable below "
                     f"{quantity(summary.get('critical_time_step'), 's')}"))
        took = summary.get("cpu_seconds", {}).get("total")
        rows.append(("computing", f"{number(summary.get('wall_seconds'), 3)}\u00a0s elapsed, {number(took, 3)}\u00a0s of CPU time on "
                     f"{number(summary.get('ranks'))} rank{'s' if summary.get('ranks', 1) != 1 else ''}, {quantity(summary.get('memory_peak'), 'B', 3)}"))
        rows.append(("finished", time.strftime("%Y-%m-%d %H:%M", time.localtime((run.folder / "summary.json").stat().st_mtime))))
    try:
        rows.append(("program", escape(run.attribute("program"))))
    except RunError:
        pass
    rows.append(("quantities kept", escape(entries.get("Output/Quantities", ""))))
    rows.append(("folder", f"<code>{escape(run.folder)}</code>"))
    return rows


def checks(subjects: Sequence[Subject]) -> str:
    """What the design checks say."""
    out = ""
    for subject in subjects:
        found = subject.run.summary.get("checks")
        name = f"<b>{escape(subject.name)}:</b> " if len(subjects) > 1 else ""
        if found:
            items = "".join(f'<li class="warning">{escape(check["sentence"])}</li>' for check in found)
            out += (f"<p>{name}</p>" if name else "") + f'<ul class="checks">{items}</ul>'
        elif found is not None:
            out += f'<p class="fine">{name}The design checks have nothing to say against this drive.</p>'
        elif subject.run.finished:
            out += f"<p class='note'>{name}The summary has no design checks.</p>"
    return out


def life_rows(life: dict[str, Any]) -> list[tuple[str, str]]:
    """Rows on how long the chain lasts, of member `life` of the summary; none where an older version has written it."""
    if not life:
        return []

    def hours(value: float | None) -> str:
        return "endless" if value is None else f"{number(float(f'{value:.2g}'), 6)}\u00a0h"

    def interval(name: str, where: str) -> str:
        found = life.get("certainty", {}).get(name)
        if found is None:
            return f" (interval not known: fewer than four {where})"
        return f" (95\u00a0% {hours(found['low'])} to {hours(found.get('high'))})"

    simulated = life.get("simulated_wear_hours")
    scatter = "" if "plate_hours_early" not in life else \
        f" (19 of 20 chains {hours(life['plate_hours_early'])} to {hours(life.get('plate_hours_late'))})"
    source = life.get("strength_from", "ISO 606")
    safety = f"safety {number(life['plate_safety'], 3)}, " if "plate_safety" in life else ""
    rows = [
        (f"wear to {number(100 * life['elongation'], 3)}\u00a0%", f"{hours(life.get('wear_hours'))}, within a factor of 3"
         + (f"; by the friction work of this run {hours(simulated)}{interval('wear', 'batches of pitches')}" if simulated else "")
         + f"; frame of ISO\u00a010823 {hours(life.get('frame_hours'))}; lubrication {escape(life['lubrication'])} or better"),
        ("plates", f"dynamic strength {quantity(life['dynamic_strength'], 'N')}" + (f" by the {escape(source)}" if source != "ISO 606" else "")
         + f", {safety}{hours(life.get('plate_hours'))}{scatter}"
         + (f"; newer ratings {quantity(life['newer_power'], 'W', 3)}" if "newer_power" in life else "")),
    ]
    if "fatigue" in life:
        fatigue = life["fatigue"]
        safety = f"safety {number(life['simulated_plate_safety'], 3)}, " if "simulated_plate_safety" in life else ""
        rows.append(("plates, by the tensions of this run",
                     f"{safety}{hours(life.get('simulated_plate_hours'))}{interval('plates', 'turns') if 'early_plate_hours' in life else ''}, weak ones {hours(life.get('early_plate_hours'))}; largest ranges at the hole"
                     f"{' (formula)' if life.get('holes_from') == 'formula' else ''} "
                     f"{quantity(fatigue['inner_plate']['hole'], 'Pa', 3)} inside, {quantity(fatigue['outer_plate']['hole'], 'Pa', 3)} outside; "
                     f"pins bend by {quantity(fatigue['pin']['bending'], 'Pa', 3)}, press with {quantity(fatigue['pin']['pressure'], 'Pa', 3)}. "
                     f"Turns of the chain from {number(fatigue['pitches'])} pitches of each link, which differ by "
                     f"{number(100 * fatigue['step'], 2)}\u00a0% of the range where they join"))
    rows.append(("rollers and bushes", f"{hours(life.get('roller_hours'))} of impacts"
                 + (f"; by the peaks of this run {hours(life.get('simulated_roller_hours'))}{interval('rollers', 'groups of impacts')}" if "impacts" in life else "")
                 + "; of their scatter nothing is known"))
    return rows


def strands_in_words(drive: dict[str, Any]) -> str:
    """What tells that figures of a chain are those of one of its strands; nothing for a simplex chain."""
    strands = drive.get("strands", 1)
    return "" if strands == 1 else f"{strands} strands, of which one is described here and elsewhere; torques, loads of shafts, " \
        "power, losses and energies are those of all: "


def separate_strands(summary: dict[str, Any]) -> list[tuple[str, str]]:
    """A row on what each strand pulls where strands are bodies of their own; none elsewhere."""
    if "strands" not in summary:
        return []
    pulls = [summary["statistics"][f"strand_{number + 1}_tension"]["mean"] for number in range(len(summary["strands"]["z"]))]
    if None in pulls:  # nothing fell into the window
        return []
    uneven = summary["strands"]["uneven"]
    return [("separate strands", "tight span pulled with " + ", ".join(quantity(pull, "N") for pull in pulls)
             + (f", at most {number(uneven, 4)} times the mean" if uneven else "")
             + f"; number {summary['strands']['shown']} is shown in joints, links, rollers and teeth")]


def drive_tables(run: Run) -> str:
    """The drive's block. RunError when the summary has none."""
    drive = run.drive
    if not drive:
        raise RunError(f"The summary of the run in '{run.folder}' does not say what the drive is; an older version has written it."
                       if run.finished else f"The run in '{run.folder}' has not finished: there is no block of the drive yet.")
    q, alike = quantity, loads_are_alike(drive)
    pitches = number(drive["centre_distance"] / drive["pitch"], 4)
    chain = [
        ("chain", f"{strands_in_words(drive)}{escape(drive['chain'])}, {drive['links']} links, pitch {q(drive['pitch'], 'm', 6)} ({q(drive['loaded_pitch'], 'm', 6)} under load), "
         f"{q(drive['mass_per_metre'], 'kg/m', 3)}"),
        *separate_strands(run.summary),
        ("centre distance, ratio", f"{q(drive['centre_distance'], 'm', 6)}, {pitches} pitches; {number(drive['ratio'], 4)}"),
        ("power, chain speed", f"{q(drive['power'], 'W')}, {q(drive['chain_speed'], 'm/s')}"),
        ("tooth frequency, pitch time", f"{q(drive['tooth_frequency'], 'Hz', 5)}, {q(drive['pitch_time'], 's')}"),
        ("tension", f"effective {q(drive['effective_tension'], 'N')}, centrifugal {q(drive['centrifugal_tension'], 'N', 3)}"
         + (f", while the speed grows {q(drive['start_tension'], 'N')}" if drive.get("start_tension") else "")),
        ("strength, safety", f"{q(drive['tensile_strength'], 'N')}, {number(drive['safety'], 3)}" if drive.get("safety") else "not listed for this chain"),
        ("joint pressure", f"{q(drive['joint_pressure'], 'Pa', 3)} on {q(drive['bearing_area'], 'm2', 3)}"),
        *([("load of each shaft", q(drive["shaft_load"], "N"))] if alike else []),
        ("driven inertia", f"{q(drive['driven_inertia'], 'kg m2')}, on the tight span {q(drive['driven_frequency'], 'Hz')} (met by the teeth at "
         f"{q(drive['driven_resonance'], 'rad/s')})"),
        ("usual limits of this size", f"{q(drive['rated_power'], 'W', 3)} at this speed; driver up to {q(drive['highest_speed'], 'rad/s')}"),
        *life_rows(run.summary.get("life", {})),
    ]
    sprockets = [("teeth", [str(s["teeth"]) for s in drive["sprockets"]])]
    for name, title, unit, digits in (("pitch_diameter", "pitch diameter", "m", 6), ("wrap", "wrap", "rad", 4), ("speed", "speed", "rad/s", 4),
                                      ("torque", "torque", "N m", 4), ("seating_velocity", "links seat at", "m/s", 3)):
        sprockets.append((title, [q(s[name], unit, digits) for s in drive["sprockets"]]))
    sprockets.append(("polygon effect", [number(100 * s["polygon_effect"], 3) + "\u00a0%" for s in drive["sprockets"]]))
    if not alike:
        sprockets.append(("load of the shaft", [q(load, "N") for load in shaft_loads(drive)]))
    spans = [(title, [q(0. if unit == "m" and abs(s[name]) < 1e-9 else s[name], unit, digits) if unit else number(s[name]) for s in drive["spans"]])
             for name, title, unit, digits in (("links", "links", "", 3), ("length", "length", "m", 6), ("slack", "slack", "m", 3), ("sag", "sag", "m", 3),
                                               ("tension", "tension", "N", 4), ("frequency", "lowest frequency", "Hz", 3),
                                               ("resonance", "met by the teeth at a driver speed of", "rad/s", 4))]
    return (table([], [(escape(a), b) for a, b in chain], classes="facts") + '<div class="side">'
            + table(["", *(escape(s["title"]) for s in drive["sprockets"])], [(name, *cells) for name, cells in sprockets])
            + table(["", *(escape(span_title(s)) for s in drive["spans"])], [(name, *cells) for name, cells in spans]) + "</div>")


def plate_table(subjects: Sequence[Subject]) -> str:
    """Stresses of the plates behind the rollers that engage, of all runs that have them; nothing where none has."""
    rows, several = [], len(subjects) > 1
    for subject in subjects:
        try:
            frame = plate_stresses(subject.run)
        except RunError:
            continue
        invalid = INVALID if subject.run.window_is_valid is False else ""
        for link, row in frame.iterrows():
            rows.append((*((escape(subject.name),) if several else ()), f"{link}, {row['kind']}{invalid}",
                         *(quantity(row[name], "Pa", 3) for name in ("nominal", "axial", "in_plane", "out_of_plane", "principal_1", "principal_2"))))
    head = [*(("",) if several else ()), "link", "tension over waists", "pull", "bending in the plane", "out of the plane", "first principal",
            "second principal"]
    return table(head, rows, "Stress at the waist in the pitch time before the roller ahead touches the driver: means, bending r.m.s.",
                 "numbers") if rows else ""


#: What signals of the window statistics are called.
TITLES = {path.split("/")[1]: one["description"].removesuffix(", mean") for path, one in schema.SUMMARY.items()
          if path.startswith("statistics/") and path.endswith("/mean")}


def around(half: float | None, unit: str) -> str:
    """Half of the 95 % interval of a mean; a dash where it is not known."""
    return f"± {quantity(half, unit, 2)}" if half is not None and np.isfinite(half) else "± –"


def statistics_tables(run: Run) -> str:
    """Window statistics, impacts and losses. RunError where the summary has none of them."""
    summary, out = run.summary, ""
    rows = []
    for name, one in summary.get("statistics", {}).items():
        if isinstance(one, dict) and "mean" in one:
            unit = one.get("unit", "1")
            rows.append((escape(TITLES.get(name, name.replace("_", " "))), quantity(one["mean"], unit), around(one.get("uncertainty"), unit),
                         *(quantity(one.get(which), unit) for which in ("deviation", "least", "largest")),
                         *(quantity(value, unit, 3) for value in (one.get("harmonics") or [None] * 4)[:4])))
    if rows:
        out += table(["", "mean", "95 %", "deviation", "least", "largest", "1st", "2nd", "3rd", "4th harmonic"], rows,
                     "In the window; 95 %: half of the interval of the mean; harmonics of the tooth frequency are amplitudes")
    settled = summary.get("statistics", {}).get("settled")
    if settled is not None:
        out += sentences(["The drive had settled at the end of the window." if settled else
                          "The drive had not settled at the end of the window: means still change, and a longer run would tell more."],
                         "fine" if settled else "note")
    rows = []
    for sprocket, one in summary.get("impacts", {}).items():
        rows.append((escape(sprocket), number(one["number"]), *(f"{quantity(one[name]['mean'], unit)} {around(one[name].get('uncertainty'), unit)},"
                     f"<br>deviation {quantity(one[name]['deviation'], unit, 2)},<br>at most {quantity(one[name]['largest'], unit)}" for name, unit in (("peak_force", "N"), ("impulse", "N s"), ("normal_speed", "m/s")))))
    if rows:
        out += table(["impacts on", "number", "peak force", "impulse", "normal speed"], rows, "Means with half of their 95 % intervals")
    rows = [(escape(name), quantity(one.get("power"), "W", 3), around(one.get("uncertainty"), "W"), quantity(one.get("friction"), "J", 3) if "friction" in one else "–",
             quantity(one.get("damping"), "J", 3) if "damping" in one else "–") for name, one in summary.get("losses", {}).items()]
    if rows:
        energy = summary.get("window_energy", {})
        out += table(["loss in", "mean power", "95 %", "by friction", "by damping"], rows)
        out += sentences([f"Over the window the driver supplied {quantity(energy.get('drive_work'), 'J')}, the load took "
                          f"{quantity(energy.get('resisting_work'), 'J')}, {quantity(energy.get('lost'), 'J', 3)} {around(energy.get('lost_uncertainty'), 'J')} were lost and "
                          f"{quantity(energy.get('stored'), 'J', 3)} more are stored than before."], "plain")
    rows = [(escape(name.replace("_", " ")), *(f"{100 * one[which]:+.2g} %" for which in ("error", "low", "high")))
            for name, one in summary.get("accuracy", {}).items()]
    if rows:
        out += table(["error of the model in", "mean", "from", "to"], rows,
                     "Against contact without penalty, as the calibration of this drive has found it, with 95 % intervals")
    if not out:
        raise RunError(f"The summary of the run in '{run.folder}' has no window statistics.")
    return invalid_window(run, "These figures are") + out


def noise_tables(run: Run) -> str:
    """Levels at the observers, and what the sprockets add. Empty without noise."""
    if not run.acoustics:
        return ""

    def level(value: float | None) -> str:
        return f"{value:.1f}" if value is not None else "–"

    def known(one: dict[str, Any], which: str) -> str:
        return f"{level(one[which])} {around(one.get(f'{which}_uncertainty'), 'dB')}" if one[which] is not None else "–"

    rows = [(escape(o["name"]), ", ".join(number(x, 3) for x in o["position"]), known(o, "level"), known(o, "level_a"), quantity(o["peak_pressure"], "Pa", 3))
            for o in run.acoustics["observers"]]
    out = invalid_window(run, "These levels are") + table(["observer", "position (m)", "level (dB)", "level (dB(A))", "peak"], rows, f"Over {run.acoustics['periods']} pitch times, re 20 µPa")
    parts = run.acoustics.get("contributions", {})
    if parts:
        first, *others = ((wheel.title, level(parts.get(wheel.name))) for wheel in run.wheels)
        out += sentences([f"At {run.acoustics['observers'][0]['name']} the rollers at the {first[0]} make {first[1]} dB"
                          + "".join(f", those at the {title} {one} dB" for title, one in others) + "."], "plain")
    return out


def costs(run: Run) -> str:
    """CPU time and energy at the end."""
    cpu = run.summary.get("cpu_seconds")
    if not cpu:
        raise RunError(f"The summary of the run in '{run.folder}' has no CPU times." if run.finished else
                       f"The run in '{run.folder}' has not finished: there is no table of times yet.")
    total = cpu["total"]
    rows = [(escape(name.replace("_", " ")), f"{number(seconds, 3)}\u00a0s", f'<span class="share" style="--part:{seconds / total:.3f}"></span>'
             f"{number(100 * seconds / total, 3)}\u00a0%") for name, seconds in cpu.items() if name != "total"]
    rows.append(("all", f"{number(total, 3)}\u00a0s", "100\u00a0%"))
    out = table(["phase", "CPU time", "share"], rows, "CPU time of all ranks")
    energy = run.summary.get("energy")
    if energy:
        ledger = [(escape(name.replace("_", " ")), quantity(value, "J")) for name, value in energy.items() if value]
        for name, title in (("drive_work", "supplied by the driver"), ("resisting_work", "taken by the load"), ("energy_turned_over", "turned over")):
            if run.summary.get(name) is not None:
                ledger.append((title, quantity(run.summary[name], "J")))
        out += table(["energy at the end", ""], ledger, "Ledger of the whole run")
    overlap = run.summary.get("penetration_max")
    if overlap:
        out += table(["interface", "largest penetration"], [(escape(name), quantity(value, "m", 3)) for name, value in overlap.items()])
    return f'<div class="side">{out}</div>'


def differences(subjects: Sequence[Subject]) -> str:
    """Figures of several runs with what they differ by from the first one, and how certain that is.

    A figure of a window that is not valid differs by nothing.
    """
    frame = comparison.compare([subject.run for subject in subjects])
    columns = comparison.names([subject.run for subject in subjects])
    head = ["", *(escape(subject.name) + ('<span class="difference">difference</span>' if k else "") for k, subject in enumerate(subjects))]
    frame = frame[~frame.index.isin(["steps", "wall_seconds", "driven_angle_end"])]
    rows: list[tuple[str, ...]] = []
    unknown: dict[str, list[str]] = {}
    found = set()
    invalid = [subject.run.window_is_valid is False for subject in subjects]
    for name, row in frame.iterrows():
        cells, of_window = [], name not in comparison.WHOLE_RUN
        for number_, column in enumerate(columns):
            cell = quantity(row[column], row["unit"])
            if of_window and invalid[number_] and np.isfinite(row[column]):
                cell += INVALID
            elif number_ and not (of_window and invalid[0]) and np.isfinite(row[f"{column} difference in %"]):
                half, words = row[f"{column} difference uncertainty"], row[f"{column} certainty"]
                cell += f'<span class="difference">{_with_interval(row[columns[0]], row[f"{column} difference"], half)}</span>'
                if np.isfinite(half):
                    found.add(words)
                elif words != certainty.SINGLE:
                    titles = unknown.setdefault(words, [])
                    titles += [row["meaning"]] if row["meaning"] not in titles else []
            cells.append(cell)
        rows.append((escape(row["meaning"]), *cells))
    return table(head, rows, f"Differences are those from {escape(subjects[0].name)}", "numbers") + _on_intervals(found, unknown)


def _with_interval(first: float, difference: float, half: float) -> str:
    """A difference in percent of the first run's figure, with half of its 95 % interval where that is known."""
    if not np.isfinite(half):
        return percent(100. * difference / first)
    relative = 100. * difference / first
    around = f" ± {number(abs(100. * half / first), 2)}\u00a0%"
    chance = ", within chance" if abs(difference) <= half else ""
    return percent(relative).removesuffix("\u00a0%") + around + chance


def _on_intervals(found: set[str], unknown: dict[str, list[str]]) -> str:
    """What the intervals of differences are, and which are not known."""
    texts = []
    if found:
        how = "paired by phase, since these are runs of one drive at the same phases" if found == {certainty.PAIRED} else \
            "not paired, since drives or phases differ" if found == {certainty.APART} else "paired where runs are of one drive at the same phases"
        texts.append(f"± is half of the 95 % interval of a difference, from means over tooth periods and from single impacts in the window, {how}. "
                     "Within chance: the interval contains zero, and a longer window or several phases would have to tell. Differences without ± are of "
                     "one value of each run, such as the largest in a window, of which it is not known how certain they are.")
    texts += [f"How certain differences are is {words}: {', '.join(titles)}." for words, titles in unknown.items()]
    return sentences(texts, "fine")


def changed_entries(subjects: Sequence[Subject]) -> str:
    """The entries in which the parameters of several runs differ."""
    frame = comparison.changes([subject.run for subject in subjects])
    if frame.empty:
        return sentences(["All entries of these runs are the same."], "plain")
    return table(["entry", *(escape(s.name) for s in subjects)], [(f"<code>{escape(path)}</code>", *(escape(v) for v in row)) for path, row in
                                                                  zip(frame.index, frame.to_numpy())], "Entries in which these runs differ")


def all_entries(run: Run) -> str:
    """All entries of a run, folded away."""
    rows = [(f"<code>{escape(path)}</code>", escape(value)) for path, value in run.parameters.items()]
    return f"<details><summary>All {len(rows)} entries as they were used</summary>{table(['entry', 'value'], rows)}</details>"
