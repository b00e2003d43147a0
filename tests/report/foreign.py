# SPDX-License-Identifier: LGPL-2.1-or-later
"""foreign.py CASE PROGRAM: pages on runs of others.

  poison   markup in every text and every name of a member of summary.json, acoustics.json, histories.h5 and parameters.prm, and in the name of
           the folder: none of it is an element of the page
  damage   a summary with members changed, gone or of other kinds, files that are cut off or of other bytes: a page or a sentence, no traceback
  target   a page takes the place of a page, and of nothing else; what cannot be written leaves nothing behind
"""
import copy
import json
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys

import program
from elements import Elements
from program import check

try:
    import h5py
    from chaindrive import report
    from chaindrive.errors import RunError
except ModuleNotFoundError as error:
    if error.name not in ("h5py", "pandas", "numpy"):
        raise
    sys.exit(77)

CASE, PROGRAM = sys.argv[1:3]
os.environ.pop("PYTHONPATH", None)  # what is started finds its modules by itself
MARK = "poisoned"
POISON = f"<img src=x onerror={MARK}()>\"'><script>{MARK}()</script>"


def base():
    """A short run with its noise."""
    if not pathlib.Path("base/acoustics.h5").exists():
        entries = {"Time/End time in ms": 18, "Output/Window start in ms": 8, "Output/Field interval in ms": 0, "Acoustics/Noise": "on"}
        program.run("prm/paper/simple.prm", entries, "--output", "base", program=PROGRAM)
    return pathlib.Path("base")


def harmless(page, what):
    """Nothing of the poison is an element or an attribute of one but as a text; nor does a script build one of it."""
    text = pathlib.Path(page).read_text(encoding="utf-8")
    for tag, attributes in Elements(text).found:
        check(tag != "img", f"{what}: an element img")
        for name, value in attributes:
            check(not name.startswith("on") and "poisoned" not in name, f"{what}: {tag} has an attribute {name}")
            check("<" not in (value or "") or "poisoned" not in value, f"{what}: {tag} {name} = {value}")
    check(f"<script>{MARK}" not in text, f"{what}: a script")
    import base64
    import gzip
    import re
    data = re.search(r'id="data">([^<]*)<', text)[1]
    check(f"<img src=x onerror={MARK}" not in gzip.decompress(base64.b64decode(data)).decode(), f"{what}: markup in the data of the scripts")
    return text


def poisoned(value, names):
    if isinstance(value, dict):
        return {(name + POISON if names else name): poisoned(member, names) for name, member in value.items()}
    if isinstance(value, list):
        return [poisoned(member, names) for member in value]
    return value + POISON if isinstance(value, str) else value


def poison():
    source, shown = base(), 0
    for what in ("values", "names", "numbers", "histories", "parameters", "folder"):
        folder = pathlib.Path("victim<img src=x onerror=poisoned()>" if what == "folder" else "victim")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(source, folder)
        if what in ("values", "names"):
            for name in ("summary.json", "acoustics.json"):
                path = folder / name
                path.write_text(json.dumps(poisoned(json.loads(path.read_text()), what == "names")))
        if what == "names":  # those that are read as a list: losses, statistics, phases
            summary = json.loads((source / "summary.json").read_text())
            for group in ("losses", "statistics", "energy", "phases"):
                if isinstance(summary.get(group), dict):
                    summary[group].update({POISON: value for value in list(summary[group].values())[:1]})
            (folder / "summary.json").write_text(json.dumps(summary))
        if what == "numbers":  # texts where numbers belong
            summary = json.loads((source / "summary.json").read_text())
            for sprocket in summary["drive"]["sprockets"]:
                sprocket["teeth"] = POISON
            summary["drive"]["links"] = POISON
            (folder / "summary.json").write_text(json.dumps(summary))
        if what == "histories":
            with h5py.File(folder / "histories.h5", "r+") as file:
                def spoil(_, item):
                    for name, value in list(item.attrs.items()):
                        if isinstance(value, str):
                            item.attrs[name] = value + POISON
                        elif name == "columns":
                            item.attrs.create(name, [str(text) + POISON for text in value], dtype=h5py.string_dtype())
                for name in ("program",):
                    file.attrs[name] = POISON
                file.visititems(spoil)
        if what == "parameters":
            path = folder / "parameters.prm"
            path.write_text(path.read_text().replace("set Designation = 525", f"set Designation = {POISON}"))
        report.write([folder], "page.html")
        text = harmless("page.html", what)
        shown += MARK in text
        pathlib.Path("page.html").unlink()
    check(shown >= 3, f"the poison was shown as a text in {shown} pages only: it was not read")


def mutations(summary, rng):
    """A summary with one member changed: gone, of another kind, not finite, empty, huge."""
    changed = copy.deepcopy(summary)
    place, path = changed, []
    while True:
        keys = list(place) if isinstance(place, dict) else list(range(len(place)))
        key = rng.choice(keys)
        path.append(key)
        inner = place[key]
        if not isinstance(inner, (dict, list)) or not inner or rng.random() < 0.3:
            break
        place = inner
    how = rng.choice(("gone", "text", "list", "object", "null", "nan", "huge", "zero", "negative", "truth"))
    if how == "gone":
        del place[key]
    else:
        place[key] = {"text": "abc", "list": [], "object": {}, "null": None, "nan": float("nan"), "huge": 1e300, "zero": 0, "negative": -1,
                      "truth": True}[how]
    return changed, f"{'/'.join(map(str, path))} {how}"


def damage(n=int(os.environ.get("CHAINDRIVE_MUTATIONS", "25"))):
    source = base()
    folder = pathlib.Path("victim")
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(source, folder)
    summary, rng, pages = json.loads((folder / "summary.json").read_text()), random.Random(int(os.environ.get("CHAINDRIVE_SEED", "1"))), 0
    for _ in range(n):
        changed, what = mutations(summary, rng)
        (folder / "summary.json").write_text(json.dumps(changed))
        try:
            report.write([folder], "page.html")
            pages += 1
        except RunError as error:
            check(str(error).strip(), what)
        except Exception as error:  # what a user would see as a traceback
            raise AssertionError(f"{what}: {type(error).__name__}: {error}") from error
    check(pages > 0.9 * n, f"only {pages} of {n} have a page")

    def page_of(name, content, *words):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(source, folder)
        path = folder / name
        path.write_bytes(content(path.read_bytes()))
        done = subprocess.run([PROGRAM, "report", str(folder)], capture_output=True, text=True)
        check(done.returncode == 0 and "Traceback" not in done.stderr, f"{name}: status {done.returncode}: {done.stdout}{done.stderr}")
        text = (folder / "report.html").read_text(encoding="utf-8")
        for word in words:
            check(word in text, f"{name}: the page does not say {word}")

    page_of("summary.json", lambda data: data[:-40], "summary.json", "damaged")
    page_of("summary.json", lambda data: b"[1, 2]", "is not the summary of a run")
    page_of("summary.json", lambda data: b"\xff" * 100, "damaged")
    page_of("acoustics.json", lambda data: data[:100], "acoustics.json", "damaged")
    page_of("acoustics.json", lambda data: b"7", "is not the noise of a run")
    page_of("parameters.prm", lambda data: data.replace(b"Designation = 525", b"Designation = 525 # Stra\xdfe"), "525")
    page_of("histories.h5", lambda data: data[:3000], "histories.h5", "damaged")
    for place in (0.01, 0.02, 0.05, 0.5):  # spoiled blocks, of which the library may die
        cut = lambda data: data[:int(place * len(data))] + b"\xa5" * 700 + data[int(place * len(data)) + 700:]  # noqa: E731,B023
        page_of("histories.h5", cut)


def target():
    folder = base()
    histories = (folder / "histories.h5").read_bytes()

    def refused(file, *words):
        done = subprocess.run([PROGRAM, "report", str(folder), "--output", str(file)], capture_output=True, text=True)
        check(done.returncode == 2 and all(word in done.stderr for word in words), f"{file}: status {done.returncode}: {done.stdout}{done.stderr}")

    refused(folder / "histories.h5", "is not a page of chaindrive", "report.html")
    check((folder / "histories.h5").read_bytes() == histories, "histories were touched")
    refused("/dev/null", "is no file that a report could replace")
    refused(".", "is no file that a report could replace")
    pathlib.Path("mine.txt").write_text("mine")
    pathlib.Path("link.html").unlink(missing_ok=True)
    os.symlink("mine.txt", "link.html")
    refused("link.html", "is no file that a report could replace")
    check(pathlib.Path("mine.txt").read_text() == "mine", "the target of the link was touched")

    # what the advice says, and again in its own place
    for _ in range(2):
        check(program.start([PROGRAM, "report", str(folder), "--output", "report.html"]).returncode == 0, "report.html is refused")
    page = pathlib.Path("report.html").read_bytes()
    limits = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))  # noqa: E731
    done = subprocess.run([PROGRAM, "report", str(folder), "--output", "report.html"], capture_output=True, text=True, preexec_fn=limits)
    check(done.returncode == 3 and "cannot be written" in done.stderr, f"full disk: {done.returncode} {done.stdout}{done.stderr}")
    check(pathlib.Path("report.html").read_bytes() == page, "the earlier page is not as it was")
    check(not list(pathlib.Path().glob("*.part")), "a .part is left behind")


if CASE not in ("poison", "damage", "target"):
    sys.exit(__doc__)
globals()[CASE]()
