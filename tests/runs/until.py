# SPDX-License-Identifier: LGPL-2.1-or-later
"""until.py PROGRAM FILE: runs that end when they know their means as well as Output/Until asks.

The run ends before its end time; summary, log and window say so, and the uncertainty is that of the statistics; less
asked for takes less time; one that goes on from a checkpoint ends at the same step with the same means; one that ends
too early says what it would take, and with that end time it is enough; means that there are not are refused.
"""
import json
import pathlib
import re
import sys

from program import check, start

PROGRAM, FILE = sys.argv[1:]
DRIVE = ("Drive/Layout/Start=settled", "Output/Window start in ms=settled", "Time/Time step in us=auto",
         "Output/History interval in us=1000", "Output/Quantities=speeds, tensions, engagements, energy")


def run(folder, end, until, *more, status=0):
    """(Summary, both streams) of a run that ends at `end` ms."""
    words = [PROGRAM, FILE, "--output", folder]
    for entry in (*DRIVE, f"Time/End time in ms={end}", f"Output/Until={until}", *more):
        words += ["--set", entry] if not entry.startswith("--") else entry.split()
    said = start(words)
    check(said.returncode == status, f"{until}: status {said.returncode}: {said.stdout}{said.stderr}")
    summary = pathlib.Path(folder, "summary.json")
    return (json.loads(summary.read_text()) if status == 0 else None), said.stdout + said.stderr


def main():
    fine, said = run("fine", 1000, "driver_peak_mean=25, tight_tension_mean=12")
    both, window = fine["until"], fine["window"]
    check(all(one["reached"] and one["uncertainty"] <= one["wanted"] for one in both.values()), f"{both}")
    check(both["driver_peak_mean"]["wanted"] == 0.25, f"{both}")
    check(window["end"] < 0.95 and abs(fine["steps"] * fine["time_step"] - window["end"]) < fine["time_step"], f"{window}")
    peaks, tension = fine["impacts"]["driver"]["peak_force"], fine["statistics"]["tight_tension"]
    for name, found in (("driver_peak_mean", peaks), ("tight_tension_mean", tension)):
        check(abs(both[name]["uncertainty"] / (found["uncertainty"] / found["mean"]) - 1) < 1e-12, f"{name}: {both}")
    check("the run knows what Output/Until asks for: driver_peak_mean to " in said, said)

    span, _ = run("span", 1000, "driven_to_driver_tension_mean=12, tight_tension_mean=12")
    check(len(set(one["uncertainty"] for one in span["until"].values())) == 1 and span["spans"]["driven_to_driver"]["label"] == "tight", f"{span['until']}")

    coarse, said = run("coarse", 1000, "driver_peak_mean=80")
    check(coarse["steps"] < fine["steps"], "less asked for does not take less time")

    run("parts", 1e3 * (window["start"] + window["end"]) / 2, "driver_peak_mean=25, tight_tension_mean=12")
    parts, said = run("parts", 1000, "driver_peak_mean=25, tight_tension_mean=12", "--resume auto")
    for member in ("steps", "until", "statistics", "impacts", "window", "spans", "losses", "window_energy", "efficiency_uncertainty",
                   "pitch_time_uncertainty"):
        check(parts[member] == fine[member], f"after a checkpoint another {member}: {parts[member]} for {fine[member]}")

    early, said = run("early", 1e3 * (window["start"] + 0.7 * (window["end"] - window["start"])), "tight_tension_mean=0.001")
    check(not early["until"]["tight_tension_mean"]["reached"], f"{early['until']}")
    check("does not know what Output/Until asks for: tight_tension_mean to " in said, said)
    wanted = re.search(r"Time/End time in ms = ([0-9.e+]+) may be enough", said)
    check(wanted is not None and float(wanted[1]) > 1e3 * early["window"]["end"], said)
    short, said = run("short", 45, "tight_tension_mean=1")
    check(short["until"]["tight_tension_mean"]["uncertainty"] is None, f"{short['until']}")

    for until, sentence in (("nothing_mean=2", "Output/Until: this run has no mean 'nothing_mean'. It has: "),
                            ("tight_tension_mean", "is not allowed"), ("tight_tension_mean=0", "is not allowed"),
                            ("tight_tension_mean=2, tight_tension_mean=3", "is not allowed"), ("=2", "is not allowed"),
                            ("tight_tension_mean=1e999", "is not allowed"), ("tight_tension_mean=nan", "is not allowed")):
        check(sentence in " ".join(run("none", 20, until, status=2)[1].split()), until)
    said = run("none", 20, "driver_peak_mean=2", "Output/Quantities=tensions", status=2)[1]
    check("Output/Quantities choose them" in " ".join(said.split()), said)
    said = run("none", 20, "tight_tension_mean=2", "Loads/Driver speed in rad/s=0", "Output/Window start in ms=0", status=2)[1]
    check("leave Until empty" in " ".join(said.split()), said)


if __name__ == "__main__":
    main()
