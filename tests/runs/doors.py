# SPDX-License-Identifier: LGPL-2.1-or-later
"""doors.py CASE PROGRAM: what others have put, or do, where a run writes.

  links      symbolic links under every name that a run or its noise writes: nothing that they lead to is touched
  strangers  files of somebody under the names of results, and beside them; results that go far away
  histories  removed, cut off, or opened by another program before they are compressed: the run ends as it should
  memory     with too little memory every end has its sentence
  full       the disk is full while the noise is written: a sentence, and no signal
"""
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import time

import program
from program import check
from small_drives import RIGID

CASE, PROGRAM = sys.argv[1:3]
BASE = "prm/verification/hard.prm"
ENTRIES = {
    **RIGID,
    "Time/End time in ms": 20,
    "Output/CSV": "true",
    "Output/Field interval in ms": 5,
    "Output/Checkpoint interval in ms": 5,
    "Acoustics/Noise": "on",
}


def run(directory, entries=(), *options, status=0):
    return program.run(BASE, {**ENTRIES, **dict(entries)}, "--output", directory, *options, program=PROGRAM, status=status)


def fresh(*names):
    for name in names:
        shutil.rmtree(name, ignore_errors=True)
        pathlib.Path(name).unlink(missing_ok=True) if not pathlib.Path(name).is_dir() else None


def names_of(directory):
    return sorted(str(path.relative_to(directory)) for path in pathlib.Path(directory).rglob("*") if path.is_file())


def links():
    fresh("sound", "planted")
    run("sound")
    names = names_of("sound")
    check("acoustics.h5" in names and "histories.h5" in names and len(names) > 12, f"only {names}")
    secret = pathlib.Path("secret").resolve()
    secret.write_text("what others must not change")
    tried = 0
    for name in [*names, *(f"{name}.part" for name in names), "chaindrive.lock", "histories.saved"]:
        if name.startswith("fields/"):
            continue
        fresh("planted")
        os.mkdir("planted")
        os.symlink(secret, f"planted/{name}")
        words = program.command(BASE, ENTRIES, "--output", "planted", program=PROGRAM)
        done = program.start(words)
        check(done.returncode in (0, 2), f"{name}: status {done.returncode}: {done.stdout}{done.stderr}")
        check(done.returncode == 0 or "symbolic link" in done.stderr or "not of a run" in done.stderr, f"{name}: {done.stderr}")
        check(secret.read_text() == "what others must not change", f"{name} was written through")
        tried += 1
    fresh("planted", "elsewhere")
    os.mkdir("planted")
    os.mkdir("elsewhere")
    os.symlink(pathlib.Path("elsewhere").resolve(), "planted/fields")
    said = run("planted", status=2)
    check("fields' is a symbolic link" in said and not os.listdir("elsewhere"), said)
    print(f"{tried} names: nothing was written through a link")


def strangers():
    # somebody's own parameters.prm, run where it stands
    fresh("mine")
    os.mkdir("mine")
    text = (program.REPOSITORY / BASE).read_text() + "# mine\n"
    file = pathlib.Path("mine/parameters.prm")
    file.write_text(text)
    said = program.run(file.resolve(), RIGID, "--output", "mine", program=PROGRAM, status=2)
    check("is the parameter file of this run, and would be replaced" in said, said)
    said = run("mine", status=2)
    check("there and not of a run" in said and "rename" in said, said)
    check(file.read_text() == text and os.listdir("mine") == ["parameters.prm"], "it was touched")
    # the advice: a new name
    file.rename("mine/drive.prm")
    said = program.run(pathlib.Path("mine/drive.prm").resolve(), {**RIGID, "Time/End time in ms": 1}, "--output", "mine", program=PROGRAM)
    check("1 file that no run has written, such as 'drive.prm'" in said, said)
    check(pathlib.Path("mine/drive.prm").read_text() == text, "it was touched")
    said = program.run(pathlib.Path("mine/parameters.prm").resolve(), {"Time/End time in ms": 0.5}, "--output", "mine", program=PROGRAM)
    check("that no run has written" not in said, f"said again of the folder of a run: {said}")

    # the file alone sends results far away
    far = pathlib.Path("../far-away").resolve()
    fresh(far)
    os.makedirs("call", exist_ok=True)
    shutil.copy(program.REPOSITORY / BASE, "call/theirs.prm")
    words = [PROGRAM, "theirs.prm", "--set", "Time/End time in ms=0.1", "--set", f"Output/Directory={far}", "--set", "Output/Window start in ms=0"]
    done = subprocess.run(words, cwd="call", capture_output=True, text=True)
    check(done.returncode == 0 and "outside of its folder" in done.stdout + done.stderr, done.stdout + done.stderr)
    words[-3] = "Output/Directory=near/by"
    done = subprocess.run(words, cwd="call", capture_output=True, text=True)
    check(done.returncode == 0 and "outside of its folder" not in done.stdout + done.stderr, done.stdout + done.stderr)
    fresh(far)


def histories():
    import h5py

    def undo(directory, change):
        """Starts a run and changes its histories while it computes."""
        fresh(directory)
        words = program.command(BASE, {**ENTRIES, "Time/End time in ms": 60, "Acoustics/Noise": "off"}, "--output", directory, program=PROGRAM)
        process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        path = pathlib.Path(directory) / "histories.h5"
        while not (pathlib.Path(directory) / "histories.saved").exists():
            check(process.poll() is None, f"{directory}: over too early")
            time.sleep(0.01)
        kept = change(path)
        said = process.communicate()[0]
        check(process.returncode == 0, f"{directory}: status {process.returncode}:\n{said}")
        check("Histories were not compressed: " in said, f"{directory}: it does not say so:\n{said}")
        check(program.summary(directory)["steps"] > 0, f"{directory}: no summary")
        return kept, said

    _, said = undo("removed", lambda path: path.unlink())
    check("No such file" in said, said)
    check(pathlib.Path("removed/histories.saved").exists(), "the rows that are still there were removed")
    undo("cut", lambda path: os.truncate(path, 3000))
    kept, said = undo("opened", lambda path: h5py.File(path, "r+"))
    check("another program has the file open" in said, said)
    kept.close()
    with h5py.File("opened/histories.h5", "r") as file:
        check(len(file["time"][:]) > 100, "histories are missing")


def memory():
    # from too little, which lets the libraries start, to enough: each end has a sentence or is a good one
    ends = {}
    for limit in (*range(460000, 700000, 10000), 4000000):
        def limited(words):
            return subprocess.run(["sh", "-c", f'ulimit -v {limit} && exec "$@"', "sh", *words], capture_output=True, text=True, errors="replace")

        if limited([PROGRAM, "--version"]).returncode != 0:
            continue  # the libraries themselves, MPI among them, could not start
        done = limited(program.command(BASE, {**RIGID, "Time/End time in ms": 1}, "--output", "small", program=PROGRAM))
        unable = {1: ("cannot be selected",)}.get(done.returncode, ("ompi_mpi_init", "OPAL ERROR"))
        if done.returncode not in (0, 3) and any(words in done.stderr for words in unable):
            continue  # MPI itself could not start, and ended the process
        ends[limit] = done.returncode
        check(done.returncode == 0 or "chaindrive: " in done.stderr, f"{limit} KiB: status {done.returncode} and not one word: {done.stderr}")
    check(set(ends.values()) <= {0, 3} and ends[4000000] == 0 and 3 in ends.values(), f"status by limit: {ends}")
    print(ends)


def full():
    fresh("loud")
    run("loud", {"Acoustics/Noise": "off"})
    sizes = pathlib.Path("loud/histories.h5").stat().st_size

    def limited(limit):
        fresh("limited")
        shutil.copytree("loud", "limited")
        words = [PROGRAM, "noise", "limited"]
        limits = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))  # noqa: E731
        return subprocess.run(words, capture_output=True, text=True, preexec_fn=limits)

    seen = set()
    for limit in (1, 1000, 3000, 8000, 20000, 50000, 100000, 10**8):
        done = limited(limit)
        check(done.returncode in (0, 3), f"limit {limit}: status {done.returncode}: {done.stderr}")
        if done.returncode:
            check("Cannot write" in done.stderr and "acoustics" in done.stderr, f"limit {limit}: {done.stderr}")
            check(not [name for name in names_of("limited") if name.startswith("acoustics")], f"limit {limit}: left behind")
        seen.add(done.returncode)
    check(seen == {0, 3} and sizes > 0, f"only {seen} was seen")


if CASE not in ("links", "strangers", "histories", "memory", "full"):
    sys.exit(__doc__)
globals()[CASE]()
