# SPDX-License-Identifier: LGPL-2.1-or-later
"""study_events.py CASE PROGRAM REPOSITORY: variants whose means tell nothing, in an empty folder.

  jump      a chain that jumps is a row with its sentence: no figures, no interval, no point in the chart, and not compared with;
            a variant that jumps from one start phase has no figures either
  against   the same in a study against an entry: a gap in its curve, no row in the waterfall
  foreign   events of others: markup, texts that no file can hold, members of other kinds; a page of all others whatever they are

Without Snakemake, h5py, matplotlib or pandas they end with 77: left out."""
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys

from elements import Elements
from program import check

if shutil.which("snakemake") is None:
    sys.exit(77)
try:
    import h5py
    import report
    import sweep
except ModuleNotFoundError as error:
    if error.name not in ("h5py", "jinja2", "matplotlib", "numpy", "pandas", "PIL"):
        raise
    sys.exit(77)

CASE, PROGRAM, REPOSITORY = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
os.environ.pop("PYTHONPATH", None)  # what is started finds its modules by itself

STUDY = """
include {repository}/prm/paper/simple.prm
subsection Drive
  subsection Layout
    set Centre distance from = slack
    set Slack in mm = {slacks}
  end
end
subsection Loads
  set Resisting torque in N m = {torques}
end
subsection Time
  set End time in ms = 40
end
subsection Output
  set Window start in ms = 8
  set Field interval in ms = 0
end
subsection Study
  set Outputs = tight_tension_mean, driver_peak_mean, losses
  {entries}
end
"""
JUMPED = "The chain jumped"


def study(torques, slacks, entries, name="there", status=0):
    """What was said. Much slack and torque make the chain jump."""
    shutil.rmtree(name, ignore_errors=True)
    pathlib.Path("jump.prm").write_text(STUDY.format(repository=REPOSITORY, torques=torques, slacks=slacks, entries=entries))
    return again(name, status)


def again(name="there", status=0):
    words = [PROGRAM, "study", "jump.prm", "--cores", "2", "--output", name, "--quiet"]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    check(done.returncode == status, f"status {done.returncode} instead of {status}:\n{done.stdout}")
    return done.stdout


def write_report(name="there"):
    """report.py alone; returns the first line of its output."""
    done = subprocess.run([sys.executable, "-B", str(REPOSITORY / "scripts/study/report.py"), name], capture_output=True, text=True)
    check(done.returncode == 0 and "Traceback" not in done.stderr, f"status {done.returncode}: {done.stdout}{done.stderr}")
    return done.stdout.partition("\n")[0]


def table(name="there"):
    with open(f"{name}/table.csv", encoding="utf-8") as file:
        return {row["variant"]: row for row in csv.DictReader(file)}


def text(file):
    return pathlib.Path("there", file).read_text(encoding="utf-8")


def has_no_figures(row, what):
    """All but what a row says of itself is no number."""
    figures = {name: value for name, value in row.items() if name not in ("variant", "ranks", "runs", "failed", "not valid", "message")
               and not name.endswith("efficient")}
    check(set(figures.values()) <= {"nan", ""} and row["runs"] == "0", f"{what} has figures: {row}")
    check(not any(value == "True" for name, value in row.items() if name.endswith("efficient")), f"{what} is efficient: {row}")


def row_of(page, name):
    return next(line for line in page.splitlines() if line.startswith(f"| {name}"))


def jump():
    said = study("{100 | 110 | 600}", "{{5 | 5 | 70}}", "set Names = reference, light, heavy\n set Reference = reference\n set Phases = 4")
    rows = table()
    check(said.splitlines()[0] == "1 of 3 variants has no figures: means over their window are not valid.", f"the first line:\n{said}")
    row = rows["heavy"]
    has_no_figures(row, "heavy")
    check(row["not valid"] == "4" and row["failed"] == "0" and row["message"].startswith(JUMPED), f"the row: {row}")
    check("not valid in 4 of 4 runs" in row["message"], f"how many: {row}")
    for name in ("reference", "light"):
        check(rows[name]["message"] == "" and float(rows[name]["tight_tension_mean low"]) > 0 and rows[name]["not valid"] == "0", f"{rows[name]}")
    with h5py.File("there/table.h5") as file:
        check(all(value != value for value in file["by_phase/heavy/tight_tension_mean"]), "phases of heavy have figures")
        check(list(file["not valid"][:]) == [0, 0, 4], "HDF5: not valid")
    page = text("study.md")
    check(JUMPED in row_of(page, "heavy") and "%" not in row_of(page, "heavy").replace(row["message"], ""), f"the page's row: {row_of(page, 'heavy')}")
    check(page.split("\n")[2].strip("*") == said.splitlines()[0], f"the page does not begin with it:\n{page[:300]}")
    check("colspan" in text("study.html") and JUMPED in text("study.html"), "the row of study.html")
    check(">light<" in text("chart.svg").replace("<!-- light -->", ">light<") and "heavy" not in text("chart.svg"), "the chart shows heavy")

    # no comparison with a reference that jumps, and this is said
    about = json.loads(text("study.json"))
    pathlib.Path("there/study.json").write_text(json.dumps({**about, "reference": "heavy"}))
    write_report()
    rows = table()
    check(all(row["tight_tension_mean error"] == "nan" for row in rows.values()) and float(rows["light"]["tight_tension_mean"]) > 0, f"{rows}")
    check("heavy` is one of them: there are no errors" in text("study.md") and "there are no errors" in text("study.html"), "the reference is not told")
    check("inf" not in text("study.md"), "an infinite error")

    # one start phase of four: what the others say is kept by phase, and is no mean of the variant
    pathlib.Path("there/study.json").write_text(json.dumps(about))
    path = sorted(pathlib.Path("there/light").glob("phase-*/summary.json"))[1]
    summary = json.loads(path.read_text())
    event = {"kind": "jumped", "in_window": True, "sentence": "The chain jumped here."}
    path.write_text(json.dumps({**summary, "events": [event], "window": {**summary["window"], "valid": False}}))
    check(write_report().startswith("2 of 3 variants have no figures"), "one phase that jumps does not count")
    rows = table()
    has_no_figures(rows["light"], "light")
    check(rows["light"]["message"] == "The chain jumped here. (not valid in 1 of 4 runs)", f"{rows['light']}")
    with h5py.File("there/table.h5") as file:
        check(sum(value == value for value in file["by_phase/light/tight_tension_mean"]) == 3, "phases of light that are sound are lost")
    # an event outside of the window leaves its means as they are
    event["in_window"] = False
    path.write_text(json.dumps({**summary, "events": [event]}))
    check(write_report().startswith("1 of 3"), "an event outside of the window counts")
    check(float(table()["light"]["tight_tension_mean"]) > 0, "an event outside of the window takes figures away")
    done = subprocess.run([sys.executable, "-B", str(REPOSITORY / "scripts/study/distributions.py"), "there"], capture_output=True, text=True)
    check(done.returncode == 0 and "| heavy | 0 | - | - | - | - | - |" in done.stdout, f"distributions: {done.stdout}{done.stderr}")


def against():
    study("{100 | 600 | 120 | 140}", "{{5 | 70 | 5 | 5}}", "set Names = a, heavy, c, d\n set Phases = 1\n set Against = Loads/Resisting torque in N m")
    of = sweep.Sweep(report.Study("there"))
    check([len(of.results(v)) for v in of.study.variants] == [1, 0, 1, 1], "runs that jump are drawn")
    page = text("study.md")
    check(row_of(page, "600").startswith("| 600 | " + JUMPED) and "1 of 4 variants" in page, f"the row:\n{page}")
    check(row_of(page, "120").count("|") == row_of(page, "600").count("|") and JUMPED not in row_of(page, "120"), "columns of the table")


MARK = "poisoned"
POISON = f"<img src=x onerror={MARK}()>\"'|`**<script>{MARK}()</script>"


def foreign():
    study("{100 | 110 | 120}", "5", "set Names = a, b, c\n set Phases = 1")
    path = pathlib.Path("there/b/phase-0/summary.json")
    sound = json.loads(path.read_text())

    def rows_with(summary, what):
        path.write_text(summary if isinstance(summary, str) else json.dumps(summary))
        first = write_report()
        rows = table()
        check(float(rows["a"]["tight_tension_mean"]) > 0 and float(rows["c"]["tight_tension_mean"]) > 0, f"{what}: others are lost: {rows}")
        for tag, attributes in Elements(text("study.html")).found:
            check(tag not in ("img", "script") and not any(name.startswith("on") for name, _ in attributes), f"{what}: element {tag} {attributes}")
        check("<img" not in text("study.md") and "<script" not in text("study.md"), f"{what}: markup in study.md")
        check(row_of(text("study.md"), "b").replace("\\|", "").count("|") == row_of(text("study.md"), "a").count("|"), f"{what}: the table of study.md")
        return rows["b"], first

    valid = sound["window"]
    broken = {**valid, "valid": False}

    def event(sentence):
        return {"kind": "jumped", "in_window": True, "sentence": sentence}

    for sentence in (POISON, "a\x00b", "a\ud800b", "a\nb\r\n| c |", "x" * 100000, "\u202e\u0007"):
        row, first = rows_with({**sound, "events": [event(sentence)], "window": broken}, repr(sentence[:20]))
        has_no_figures(row, repr(sentence[:20]))
        check(first.startswith("1 of 3") and len(row["message"]) < 600, f"{first}; {len(row['message'])} letters")
    for events in (None, [], 7, "abc", {}, [None, 7, []], [event(7)], [event("")], [event(None)], [{"in_window": True}], [[event("x")]]):
        row, _ = rows_with({**sound, "events": events, "window": broken}, f"events {events}")
        has_no_figures(row, f"events {events}")
        check("not valid" in row["message"], f"events {events}: {row}")
    # events that the window knows nothing of: they count, and so it is with summaries of older versions, which have neither
    row, _ = rows_with({**sound, "events": [event("It jumped.")], "window": {"start": valid["start"], "end": valid["end"]}}, "no valid")
    has_no_figures(row, "no valid")
    old = {name: value for name, value in sound.items() if name != "events"}
    row, first = rows_with({**old, "window": {"start": valid["start"], "end": valid["end"]}}, "an older version")
    check(float(row["tight_tension_mean"]) > 0 and first == "", f"an older version: {row} {first}")
    for valid_ in (None, "false", 0, [], {}):
        row, _ = rows_with({**sound, "window": {**valid, "valid": valid_}}, f"valid {valid_}")
        check(float(row["tight_tension_mean"]) > 0, f"valid {valid_}: {row}")
    # what cannot be read is a row with its sentence
    for damaged in ("", "[]", "{", "[" * 100000, '{"cpu_seconds": {}}', json.dumps({**sound, "cpu_seconds": 7}), json.dumps({**sound, "steps": [1]}),
                    json.dumps({**sound, "window": 7}), json.dumps({**sound, "energy": []}), json.dumps({**sound, "engagements": 7}),
                    json.dumps({**sound, "cpu_seconds": {POISON: POISON}})):
        row, first = rows_with(damaged, damaged[:30])
        check(row["failed"] == "1" and "cannot be read" in row["message"] and "1 of 3" in first, f"{damaged[:30]}: {row}; {first}")
    rows_with({**sound, "steps": None, "cpu_seconds": {**sound["cpu_seconds"], POISON: 1}}, "a phase of others")
    path.write_text(json.dumps(sound))
    end = path.parent / "result.json"
    end.write_text(json.dumps({"status": 3, "error": POISON + "\x00\ud800"}))
    row, _ = rows_with(sound, "result.json")
    check(row["failed"] == "1" and "poisoned" in row["message"], f"result.json: {row}")


if CASE not in ("jump", "against", "foreign"):
    sys.exit(__doc__)
globals()[CASE]()
