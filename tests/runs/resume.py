# SPDX-License-Identifier: LGPL-2.1-or-later
"""resume.py CASE PROGRAM REPOSITORY: runs that are interrupted and go on. Every case ends by comparing all
results with those of a run that nobody disturbed: histories, pictures, lists and summary, byte by byte.

  same FIDELITY     A to C is A to B to C, by a greater end time; simple, layered, reduced, exact, reduced and without
                    penalty, full, full2 on two ranks, or mixed, elastic rollers on rigid links; from a settled start with
                    the word `settled`
  ranks             a checkpoint of two ranks is read by one and the other way round: equal to round-off
  stop              SIGTERM, SIGINT and the wall-clock limit: a checkpoint, status 4, and what to do next; a signal before the
                    first step
  refuse            checkpoints that are cut off, damaged, of other parameters, versions and formats, or none
  histories         histories kept for a checkpoint that are cut off, damaged or gone
  mesh              an imported mesh whose contents have changed
  kill [N] [RANKS] [FIDELITY]
                    kill -9 at N random moments, 4 by default; layered on one rank, full on more
  bits [N]          one bit of a checkpoint turned round, at N places, 12 by default: refused, nothing touched
  cache             goes on after the cache of parts was deleted
"""
import contextlib
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import time

import h5py

import program
from program import check

PROGRAM, REPOSITORY = sys.argv[2], pathlib.Path(sys.argv[3])

DRIVE = {
    "Drive/Number of links": 22,
    "Drive/Driver teeth": 9,
    "Drive/Driven teeth": 9,
    "Drive/Sprockets/Driver outside diameter in mm": "auto",
    "Drive/Sprockets/Driven outside diameter in mm": "auto",
    "Drive/Sprockets/Driver hub diameter in mm": "auto",
    "Drive/Sprockets/Driver bore in mm": "auto",
    "Drive/Sprockets/Driven hub diameter in mm": "auto",
    "Drive/Sprockets/Driven bore in mm": "auto",
    "Drive/Layout/Centre distance from": "slack",
    "Drive/Layout/Slack in mm": 0.1,
    "Model/Driven inertia in kg m2": 1e-4,
    "Loads/Resisting torque in N m": 20,
    "Loads/Torque ramp angle in rad": 0.01,
    "Time/Time step in us": "auto",
    "Output/Window start in ms": 0,
    "Output/CSV": "true",
}
RIGID = {"Loads/Ramp time in ms": 0.5, "Output/History interval in us": 20, "Output/Field interval in ms": 0.5}
FULL = {
    "Model/Fidelity": "full",
    "Mesh/Refinement": 0,
    "Loads/Ramp time in ms": 0.01,
    "Output/History interval in us": 1,
    "Output/Field interval in ms": 0.01,
}


MIXED = {"Effects/Elastic driver": "off", "Effects/Elastic driven": "off", "Effects/Elastic links": "off"}
PENALTY = {"Contact/Enforcement": "penalty"}
INERTIA = {"Effects/Tooth inertia": "on"}
ELASTIC = ("full", "reduced", "mixed", "exact", "inertia")


def drive(fidelity, **more):
    """Entries of a small drive."""
    entries = dict(DRIVE)
    entries.update(FULL if fidelity in ELASTIC else RIGID)
    entries["Model/Fidelity"] = {"mixed": "full", "exact": "reduced", "inertia": "reduced"}.get(fidelity, fidelity)
    entries.update({"mixed": MIXED, "reduced": PENALTY, "inertia": INERTIA}.get(fidelity, {}))
    entries.update(more)
    return entries


def command(directory, entries, options=(), ranks=1):
    words = ("--output", directory, *options)
    return program.command("prm/paper/layered-auto.prm", entries, *words, program=PROGRAM, ranks=ranks)


def run(directory, entries, options=(), ranks=1, status=0):
    """Runs to the end, checks the exit status and returns what was said."""
    words = ("--output", directory, *options)
    return program.run("prm/paper/layered-auto.prm", entries, *words, program=PROGRAM, ranks=ranks, status=status)


def numbers(directory):
    """The summary without what belongs to the machine."""
    summary = program.summary(directory)
    return {name: value for name, value in summary.items() if name not in ("wall_seconds", "cpu_seconds", "memory_peak", "ranks")}


def results(directory):
    """Every result file by its name but for HDF5, and without the date that deal.II puts into lists."""
    folder = pathlib.Path(directory)
    return {
        str(file.relative_to(folder)): re.sub(rb"#This file was generated [^\n]*", b"", file.read_bytes())
        for pattern in ("*.csv", "*.pvd", "fields/*vtu")
        for file in folder.glob(pattern)
    }


def datasets(directory):
    """All bytes of all datasets by their paths; the CSV files hold the same numbers."""
    found = {}
    with h5py.File(f"{directory}/histories.h5") as file:
        file.visititems(lambda name, item: found.update({name: item[:].tobytes()}) if isinstance(item, h5py.Dataset) else None)
    check("time" in found and len(found) > 8, f"{directory}/histories.h5 has {sorted(found)} only")
    return found


def compare(undisturbed, resumed):
    expected, got = results(undisturbed), results(resumed)
    check(expected.keys() == got.keys(), f"{resumed}: {sorted(expected.keys() ^ got.keys())} are not in both")
    for name in expected:
        check(expected[name] == got[name], f"{resumed}/{name} is not as it is undisturbed")
    check(len(expected) > 8, "there were no results to compare")
    check(numbers(undisturbed) == numbers(resumed), f"{resumed}: another summary")
    check(datasets(undisturbed) == datasets(resumed), f"{resumed}/histories.h5 is not as it is undisturbed")
    left = [file.name for file in pathlib.Path(resumed).iterdir() if re.search(r"part$|saved$|histories-", file.name)]
    check(not left, f"{resumed}: {left} were left behind")


def fresh(*directories):
    for directory in directories:
        shutil.rmtree(directory, ignore_errors=True)


def checkpoints(directory):
    return sorted(pathlib.Path(directory).glob("checkpoint-*.ckpt"))


def same(fidelity, start="taut"):
    ranks = 2 if fidelity == "full2" else 1
    entries = drive(fidelity.rstrip("2"), **{"Drive/Layout/Start": start})
    end, middle = (0.06, 0.031) if fidelity.startswith(ELASTIC) else (3, 1.3)
    fresh("through", "resumed")
    run("through", {**entries, "Time/End time in ms": end}, ranks=ranks)
    run("resumed", {**entries, "Time/End time in ms": middle, "Output/Checkpoint interval in ms": middle / 3}, ranks=ranks)
    check(len(checkpoints("resumed")) == 2, "there are not two checkpoints")
    said = run("resumed", {**entries, "Time/End time in ms": end, "Output/Resume": "auto"}, ranks=ranks)
    check(re.search(f"Resumed from .* at {middle}", said), f"it does not say where it goes on:\n{said}")
    compare("through", "resumed")


def ranks():
    entries = {**drive("full"), "Time/End time in ms": 0.06, "Output/Checkpoint interval in ms": 0.03}
    for first, second in ((1, 2), (2, 1)):
        fresh("through", "resumed")
        run("through", entries, ranks=first)
        run("resumed", {**entries, "Time/End time in ms": 0.03}, ranks=first)
        run("resumed", entries, ["--resume", "auto"], ranks=second)
        expected, got = numbers("through"), numbers("resumed")
        largest = max(abs(value) for value in expected["energy"].values())
        for name, value in expected["energy"].items():
            check(abs(value - got["energy"][name]) < 1e-9 * largest, f"{name}: {got['energy'][name]}, not {value}")
        for name in ("drive_work", "driven_angle_end"):
            check(abs(expected[name] - got[name]) < 1e-9 * abs(expected[name]), f"{name}: {got[name]}, not {expected[name]}")
        check(expected["searches"] == got["searches"], "another number of searches")


def begin(directory, entries, options=(), ranks=1):
    return subprocess.Popen(
        command(directory, entries, options, ranks), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )


def processes(process, ranks):
    """Numbers of the program's own processes."""
    if ranks == 1:
        return [process.pid]
    children = subprocess.run(["pgrep", "-P", str(process.pid)], stdout=subprocess.PIPE, text=True)
    return [int(pid) for pid in children.stdout.split()]


def wait_for(condition, process):
    while not condition():
        check(process.poll() is None, "the run was over too early")
        time.sleep(0.01)


def stop_early():
    """The run waits for its parameter file, a pipe, while the signal comes."""
    fresh("early")
    pipe = pathlib.Path("waits.prm")
    pipe.unlink(missing_ok=True)
    os.mkfifo(pipe)
    words = [PROGRAM, str(pipe), "--output", "early"]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    with open(pipe, "w") as file:  # returns when the program has opened it too
        os.kill(process.pid, signal.SIGTERM)
        file.write((REPOSITORY / "prm/paper/simple-auto.prm").read_text())
    said = process.communicate()[0]
    check(process.returncode == 4, f"status {process.returncode}:\n{said}")
    check("Stopped by SIGTERM before the first step" in said, said)
    check(not pathlib.Path("early").exists(), "it has written results")


def stop():
    stop_early()
    for fidelity, ranks, end in (("layered", 1, 200), ("full", 2, 0.3), ("reduced", 2, 0.8)):  # long enough to be stopped three times
        entries = {**drive(fidelity), "Time/End time in ms": end}
        fresh("through", "resumed")
        run("through", entries, ranks=ranks)
        for number in (signal.SIGTERM, signal.SIGINT):
            log = pathlib.Path("resumed/log.txt")
            before = log.stat().st_size if log.exists() else 0
            process = begin("resumed", entries, ["--resume", "auto"], ranks)
            wait_for(lambda: log.exists() and log.stat().st_size > before, process)
            time.sleep(0.2)
            for pid in processes(process, ranks):  # mpirun would report its own status
                os.kill(pid, number)
            said = process.communicate()[0]
            check(process.returncode == 4, f"status {process.returncode}:\n{said}")
            check("--resume auto" in said and "checkpoint-" in said, f"it does not say how to go on:\n{said}")
        said = run("resumed", {**entries, "Output/Wall-clock limit in s": 0.3}, ["--resume", "auto"], ranks, status=4)
        check("Wall-clock limit" in said, said)
        run("resumed", entries, ["--resume", "auto"], ranks)
        compare("through", "resumed")


def crc64(data):
    """CRC-64/XZ, by its definition."""
    table = []
    for byte in range(256):
        for _ in range(8):
            byte = byte >> 1 ^ (0xC96C5795D7870F42 if byte & 1 else 0)
        table.append(byte)
    crc = 2**64 - 1
    for byte in data:
        crc = table[(crc ^ byte) & 0xFF] ^ crc >> 8
    return crc ^ 2**64 - 1


def refuse():
    check(crc64(b"123456789") == 0x995DC9BBDF1939FA, "crc64 is wrong")
    entries = {**drive("simple"), "Time/End time in ms": 0.2, "Output/Checkpoint interval in ms": 0.1}
    fresh("whole", "other")
    run("whole", entries)
    older, newest = checkpoints("whole")
    content = newest.read_bytes()
    check(crc64(content[:-8]) == int.from_bytes(content[-8:], "little"), "the checksum is not that of the contents")

    def signed(data):
        return data + crc64(data).to_bytes(8, "little")

    def refused(text, change=None, more=None, options=("--resume", str(newest))):
        newest.write_bytes(content if change is None else change)
        before = results("whole")
        said = run("whole", {**entries, **(more or {})}, options, status=2)
        check(re.search(text, said, re.S), f"it does not say {text}:\n{said}")
        check("chaindrive: " in said and "xception" not in said, said)
        check(results("whole") == before, "results were touched")

    name = re.escape(str(newest))
    for size in (len(content) - 1, len(content) // 2, 150):
        refused(f"{name}.*damaged or was cut off", content[:size])
    for place in random.Random(1).sample(range(25, len(content)), 3):
        refused(f"{name}.*damaged", content[:place] + bytes([content[place] ^ 1]) + content[place + 1 :])
    refused(f"{name}' is no checkpoint", b"")
    refused(f"{name}' is no checkpoint", os.urandom(5000))
    number = re.search(rb"checkpoint (\d+)", content).group(1)
    refused(
        f"{name}.*format 77; this program reads the format {number.decode()}",
        signed(content[:-8].replace(b"checkpoint " + number, b"checkpoint 77", 1)),
    )
    refused(f"{name}.*written by chaindrive 9.9.9", signed(re.sub(rb"version [0-9.]+", b"version 9.9.9", content[:-8], 1)))
    refused(
        f"{name}.*other parameters: there Loads/Resisting torque in N m = 20, here .* = 30",
        more={"Loads/Resisting torque in N m": 30},
    )
    refused(f"{name}.*after Time/End time", more={"Time/End time in ms": 0.15})
    refused(f"{name}.*window", more={"Output/Window start in ms": 0.05})
    refused("nowhere.ckpt.*cannot be read", options=("--resume", "nowhere.ckpt"))
    os.mkdir("other")
    shutil.copy(older, "other")
    refused("other.*does not lie in the output directory", options=("--resume", f"other/{older.name}"))

    # by its name in the output directory
    said = run("whole", entries, ("--resume", older.name))
    check(f"Resumed from '{older}' at 0.1" in said, said)

    # auto: the older one, then none
    newest.write_bytes(content[:-100])
    said = run("whole", entries, ["--resume", "auto"])
    check(re.search(f"{name}.*cut off.*Resumed from '{older}' at 0.1", said, re.S), said)
    check(newest.read_bytes() == content or len(newest.read_bytes()) == len(content), "it was not made again")
    for file in checkpoints("whole"):
        file.write_bytes(content[:-100])
    refused("cut off.*cut off.*No other checkpoint", content[:-100], options=("--resume", "auto"))
    fresh("other")
    said = run("other", entries, ["--resume", "auto"])
    check("begins at its beginning" in said, said)


def turn_bit(file, place):
    content = bytearray(file.read_bytes())
    content[place] ^= 4
    file.write_bytes(content)


def histories():
    """Of a run that was stopped: which checkpoint --resume auto takes, and that all goes on as if nothing had been."""
    entries = {**drive("simple"), "Output/Checkpoint interval in ms": 0.2, "Output/History interval in us": 5}
    fresh("through")
    older = newest = 0
    while newest - older < 0.02:  # with samples between them
        fresh("stopped")
        process = begin("stopped", {**entries, "Time/End time in ms": 1e3})
        wait_for(lambda: len(checkpoints("stopped")) == 2, process)
        process.terminate()
        check(process.wait() == 4, "it did not stop")
        older, newest = (1e3 * float(re.search(rb"\ntime (\S+)", file.read_bytes())[1]) for file in checkpoints("stopped"))
    entries["Time/End time in ms"] = newest + 0.1
    run("through", entries)

    def damaged(time, *changes, options=("--resume", "auto"), status=0):
        fresh("resumed")
        shutil.copytree("stopped", "resumed")
        for change in changes:
            change(pathlib.Path("resumed"))
        said = run("resumed", entries, options, status=status)
        if status == 0:
            check(re.search(rf"Resumed from .* at {time:.6g}", said), f"it does not go on from {time} ms:\n{said}")
            compare("through", "resumed")
        return said

    rows = pathlib.Path("stopped/histories.saved").stat().st_size
    cut, turn_last, turn_first, remove, lose = (
        lambda folder: os.truncate(folder / "histories.saved", rows - 1),
        lambda folder: turn_bit(folder / "histories.saved", rows - 20),
        lambda folder: turn_bit(folder / "histories.saved", 20),
        lambda folder: (folder / "histories.saved").unlink(),
        lambda folder: (folder / "histories.h5").unlink(),
    )
    for change in (cut, turn_last):
        said = damaged(older, change, lose)
        check("histories.saved" in said and "The one before it is taken" in said, said)
    for change in (cut, turn_first, remove):
        damaged(newest, change)  # what the run had written is whole
    damaged(newest, lose)
    said = damaged(None, turn_first, lose, status=2)
    check("No other checkpoint" in said and "histories.saved" in said, said)
    name = checkpoints("stopped")[1].name
    said = damaged(None, cut, lose, options=("--resume", f"resumed/{name}"), status=2)
    check(name in said and "histories.saved" in said, said)


def mesh():
    content = (REPOSITORY / "meshes/sprocket-15.msh").read_text()
    file = pathlib.Path("driver.msh")
    entries = {
        **drive("simple"),
        "Drive/Number of links": 28,
        "Drive/Driver teeth": 15,
        "Drive/Sprockets/Driver outside diameter in mm": 81.8,
        "Drive/Sprockets/Driver hub diameter in mm": 33,
        "Drive/Sprockets/Driver bore in mm": 25,
        "Drive/Sprockets/Driver mesh": file,
        "Time/End time in ms": 0.2,
        "Output/Checkpoint interval in ms": 0.1,
    }
    fresh("whole")
    file.write_text(content)
    run("whole", entries)
    x = re.search(r"\$Nodes\n\d+\n1 (\S+)", content)  # of the first node
    file.write_text(content[: x.start(1)] + str(float(x[1]) + 1e-9) + content[x.end(1) :])
    said = run("whole", entries, ["--resume", "auto"], status=2)
    check("checksum of the mesh 'driver.msh'" in said and "Only the end time" in said, said)
    file.write_text(content)
    run("whole", entries, ["--resume", "auto"])


def bits(n=12):
    """Header, length of every place and numbers: whatever bit is wrong, the file is refused."""
    entries = {**drive("reduced"), "Time/End time in ms": 0.02, "Output/Checkpoint interval in ms": 0.01}
    fresh("whole")
    run("whole", entries)
    newest = checkpoints("whole")[-1]
    content, before = newest.read_bytes(), results("whole")
    places = random.Random(2).sample(range(8 * len(content)), n)
    for place in places:
        changed = bytearray(content)
        changed[place // 8] ^= 1 << place % 8
        newest.write_bytes(changed)
        said = run("whole", {**entries, "Time/End time in ms": 0.03}, ["--resume", str(newest)], status=2)
        check(re.search(re.escape(str(newest)), said) and "xception" not in said, f"bit {place}:\n{said}")
        check(results("whole") == before, f"bit {place}: results were touched")
    print(f"{n} bits of {len(content)} bytes: all refused")


def cache():
    """Parts are solved anew: the same numbers."""
    os.environ["CHAINDRIVE_CACHE"] = str(pathlib.Path("cache").resolve())
    entries = {**drive("reduced"), "Time/End time in ms": 0.06}
    fresh("through", "resumed", "cache")
    run("through", entries)
    run("resumed", {**entries, "Time/End time in ms": 0.03, "Output/Checkpoint interval in ms": 0.01})
    check(any(pathlib.Path("cache").iterdir()), "nothing was cached")
    fresh("cache")
    run("resumed", entries, ["--resume", "auto"])
    compare("through", "resumed")


def kill(n=4, ranks=1, fidelity=None):
    """Each kill comes at a random moment after the run has begun; what is finished must stay as it is."""
    random.seed(int(os.environ.get("CHAINDRIVE_SEED", "0")) or None)
    fidelity = fidelity or ("layered" if ranks == 1 else "full")
    end, interval = (0.015 * n, 0.002) if fidelity in ELASTIC else (0.5 * n, 0.05)
    entries = {**drive(fidelity), "Time/End time in ms": end, "Output/Checkpoint interval in ms": interval}
    fresh("through", "resumed")
    began = time.time()
    run("through", entries, ranks=ranks)
    duration = time.time() - began
    kills, lost = 0, []
    log = pathlib.Path("resumed/log.txt")
    while True:
        before = log.stat().st_size if log.exists() else 0
        process = begin("resumed", entries, ["--resume", "auto", "--quiet"], ranks)
        if kills < n:
            while random.random() < 0.99 and process.poll() is None and not (log.exists() and log.stat().st_size > before):
                time.sleep(0.02)  # mostly until it has started; now and then not
            if kills == n - 1 and not any(t is not None for t in lost):  # one kill at least finds a checkpoint
                while process.poll() is None and not checkpoints("resumed"):
                    time.sleep(0.01)
            try:
                process.wait(random.uniform(0, 2 * duration / n))
            except subprocess.TimeoutExpired:
                for pid in processes(process, ranks):
                    with contextlib.suppress(ProcessLookupError):  # mpirun kills the others too
                        os.kill(pid, signal.SIGKILL)
                kills += process.wait() != 0  # else it had come to its end by then
        process.communicate()
        if process.returncode == 0:
            if kills >= n:
                break
            fresh("resumed")  # it came to its end before all kills were done
            continue
        lost.append(examine("resumed"))
    compare("through", "resumed")
    check(any(t is not None for t in lost), "every kill came before the first checkpoint")
    print(f"{n} kills of a run of {duration:.1f} s; with checkpoints before {sum(t is not None for t in lost)}")


def examine(directory):
    """What a killed run has left: time of the checkpoint from which it can go on, in ms."""
    log = pathlib.Path(directory) / "log.txt"
    logged = [float(t) for t in re.findall(r"Checkpoint at ([0-9.e-]+) ms", log.read_text())] if log.exists() else []
    whole = []
    for file in checkpoints(directory):
        content = file.read_bytes()
        check(crc64(content[:-8]) == int.from_bytes(content[-8:], "little"), f"{file} is not whole")
        whole.append(1e3 * float(re.search(rb"\ntime (\S+)", content)[1]))
    for file in pathlib.Path(directory).glob("fields/*.vtu"):
        check(file.read_bytes().endswith(b"</VTKFile>\n"), f"{file} is not whole")
    for pvd in pathlib.Path(directory).glob("*.pvd"):
        for name in re.findall('file="([^"]+)"', pvd.read_text()):
            check((pathlib.Path(directory) / name).exists(), f"{pvd} names {name}, which is not there")
    # a checkpoint is due at every interval: whatever came after the last one is less than that
    if logged:
        check(whole and max(whole) > max(logged) * (1 - 1e-5), f"the last checkpoint, at {max(logged)} ms, is lost")
    return max(whole, default=None)


def main():
    case, arguments = sys.argv[1].split()[0], sys.argv[1].split()[1:]
    arguments = [int(word) if word.isdigit() else word for word in arguments]
    cases = (same, ranks, stop, refuse, histories, mesh, bits, cache, kill)
    {function.__name__: function for function in cases}[case](*arguments)


if __name__ == "__main__":
    main()
