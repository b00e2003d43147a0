# SPDX-License-Identifier: LGPL-2.1-or-later
"""ends.py CASE PROGRAM REPOSITORY: how runs end, and what they leave to each other.

  console    nobody reads what is said, or nobody is there any more: the run reaches its end all the same
  signals    each signal that asks for the end: a checkpoint and status 4
  ranks      the same under mpirun, while mpirun reads nothing; `scripts/ranks` asked, and killed
  directory  two runs in one directory; what a run that is refused, resumed or stopped by the guard leaves there
"""
import atexit
import fcntl
import os
import pathlib
import pty
import re
import shutil
import signal
import socket
import subprocess
import sys
import time

from resume import PROGRAM, REPOSITORY, check, checkpoints, command, drive, fresh, run, wait_for

SHORT = {**drive("layered"), "Time/End time in ms": 0.6, "Output/Field interval in ms": 0}
LONG = {**SHORT, "Time/End time in ms": 500}
PATIENCE = 30  # s, on a busy machine


def start(directory, entries, options=(), launcher=(), **how):
    how = {"stdout": subprocess.DEVNULL, "stderr": subprocess.STDOUT, **how}
    process = subprocess.Popen([*launcher, *command(directory, entries, options)], **how)
    atexit.register(process.kill)  # of a case that fails nothing goes on
    return process


def end_of(process, what):
    """The status, within a time that a run which hangs exceeds."""
    try:
        return process.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()
        sys.exit(f"{what}: it hangs")


def log_of(directory):
    file = pathlib.Path(directory) / "log.txt"
    return file.read_text() if file.exists() else ""


def computes(directory):
    """The first line of progress comes after 5 %, that of a long run late: what stands before it will do."""
    return "\nStep: " in log_of(directory)


def fill(descriptor):
    """Writes until the reader's end takes no more."""
    flags = fcntl.fcntl(descriptor, fcntl.F_GETFL)
    fcntl.fcntl(descriptor, fcntl.F_SETFL, flags | os.O_NONBLOCK)
    try:
        while True:
            os.write(descriptor, b"." * 64)
    except BlockingIOError:
        fcntl.fcntl(descriptor, fcntl.F_SETFL, flags)


def console():
    for name in ("terminal", "pipe", "errors"):
        fresh("unread")
        reader, writer = pty.openpty() if name == "terminal" else os.pipe()
        fill(writer)
        how = {"stderr" if name == "errors" else "stdout": writer}
        process = start("unread", SHORT, ["--quiet", "--set", "Time/Energy limit in percent=1e-9"] if name == "errors" else [], **how)
        status = end_of(process, f"nobody reads the {name}")
        check(status == (3 if name == "errors" else 0), f"nobody reads the {name}: status {status}")
        os.close(reader)
        os.close(writer)
        check(name == "errors" or "Results: unread" in log_of("unread"), "log.txt is not complete")
    for name in ("terminal", "pipe"):
        fresh("gone")
        reader, writer = pty.openpty() if name == "terminal" else os.pipe()
        os.close(reader)
        status = end_of(start("gone", SHORT, stdout=writer), f"the {name} is gone")
        os.close(writer)
        check(status == 0, f"the {name} is gone: status {status}")
        check("Results: gone" in log_of("gone"), "log.txt is not complete")

    # "... | head" has had enough; a disk that is full is no reader
    for words in (["document"], ["--help"], ["study", "--help"]):
        reader, writer = os.pipe()
        os.close(reader)
        done = subprocess.run([PROGRAM, *words], stdout=writer, stderr=subprocess.PIPE, text=True)
        os.close(writer)
        check(done.returncode == 0 and done.stderr == "", f"{words}, nobody reads: {done.returncode}, {done.stderr}")
        with open("/dev/full", "w") as disk:
            done = subprocess.run([PROGRAM, *words], stdout=disk, stderr=subprocess.PIPE, text=True)
        said = done.stderr.strip()
        check(done.returncode == 3 and said.endswith("could not be written.") and "\n" not in said, f"{words}, full disk: {said}")

    # neither is it where the answer goes by a thread of its own; a run's log stands in a file as well
    simple = f"{REPOSITORY}/prm/paper/simple.prm"
    pathlib.Path("compared.prm").write_text(f"include {simple}\nsubsection Loads\n  set Drag in 1/s = {{0 | 1}}\nend\n")
    fresh("kept")
    for words, status in ((["plan", simple], 3), (["study", "compared.prm", "--dry-run"], 3),
                          ([simple, "--output", "kept", "--set", "Time/End time in ms=0.1", "--set", "Output/Window start in ms=0"], 0)):
        with open("/dev/full", "w") as disk:
            done = subprocess.run([PROGRAM, *words], stdout=disk, stderr=subprocess.PIPE, text=True)
        check(done.returncode == status and ("chaindrive: Standard output could not be written.\n" in done.stderr) == (status == 3),
              f"{words}, full disk: {done.returncode}, {done.stderr}")
    check("Results: kept" in log_of("kept"), "log.txt is not complete")

    # a pager: the plan stands in no file, so its reader is waited for
    reader, writer = os.pipe()
    fcntl.fcntl(writer, 1031, 4096)  # F_SETPIPE_SZ
    process = start("plan", SHORT, ["--plan"], stdout=writer)
    os.close(writer)
    time.sleep(2.5)  # a run waits two seconds for its reader
    with os.fdopen(reader) as file:
        said = file.read()
    check(end_of(process, "plan") == 0 and said.rstrip().endswith("MB"), f"the plan is not complete:\n{said}")
    check(not pathlib.Path("plan").exists(), "a plan makes no directory")

    # warnings are not to be missed
    file = pathlib.Path("twice.prm")
    file.write_text((REPOSITORY / "prm/paper/simple-auto.prm").read_text() + "\nsubsection Time\n  set End time in ms = 0.1\nend\n")
    words = [PROGRAM, str(file), "--output", "twice", "--quiet", "--set", "Output/Window start in ms=0"]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    check(done.returncode == 0 and done.stdout == "", f"--quiet says {done.stdout}")
    check("End time in ms was set before" in done.stderr, f"--quiet hides the warning: {done.stderr}")


def signals():
    for number in (signal.SIGHUP, signal.SIGPIPE, signal.SIGUSR1):
        fresh("stopped")
        process = start("stopped", LONG)
        wait_for(lambda: computes("stopped"), process)
        time.sleep(0.1)
        process.send_signal(number)
        process.send_signal(number)  # what comes together is one request
        status = end_of(process, number.name)
        check(status == 4, f"{number.name}: status {status}")
        check(checkpoints("stopped"), f"{number.name}: no checkpoint")
        check(f"Stopped by {number.name}" in log_of("stopped"), f"{number.name} is not named")

    fresh("stopped")
    process = start("stopped", LONG, launcher=["nohup"])
    wait_for(lambda: computes("stopped"), process)
    process.send_signal(signal.SIGHUP)
    time.sleep(0.5)
    check(process.poll() is None, "nohup is of no use")
    process.send_signal(signal.SIGTERM)
    check(end_of(process, "nohup") == 4, "SIGTERM after SIGHUP")


FULL = {**drive("full"), "Time/End time in ms": 20}


def ranks_of(process):
    """Numbers of the program's processes below @p process, the first rank first."""
    found = {}
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if (folder / "exe").resolve() != pathlib.Path(PROGRAM).resolve():
                continue
            session = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
            rank = re.search(rb"OMPI_COMM_WORLD_RANK=(\d+)", (folder / "environ").read_bytes())
            if rank and session == process:
                found[int(rank[1])] = int(folder.name)
        except (OSError, ValueError):
            pass
    return [found[rank] for rank in sorted(found)]


def child_of(pid):
    """mpirun, whose parent is the script; that of OpenMPI 5 has another name."""
    said = subprocess.run(["pgrep", "-P", str(pid), "mpirun|prterun"], stdout=subprocess.PIPE, text=True).stdout.split()
    return int(said[0]) if said else 0


def ranks():
    for mpirun_itself in (True, False):
        fresh("stopped")
        launcher = ["mpirun", "-n", "2"] if mpirun_itself else [str(REPOSITORY / "scripts/ranks"), "2"]
        with open("out.txt", "wb") as out:
            process = start("stopped", FULL, launcher=launcher, stdout=out)
        wait_for(lambda: computes("stopped"), process)
        time.sleep(1)
        mpirun = process.pid if mpirun_itself else child_of(process.pid)
        first = ranks_of(mpirun)[0]
        os.kill(mpirun, signal.SIGSTOP)  # as it does after a signal, it reads nothing
        terminal = os.open(f"/proc/{first}/fd/1", os.O_WRONLY | os.O_NOCTTY)
        fill(terminal)
        os.close(terminal)
        time.sleep(1)
        if mpirun_itself:
            os.kill(first, signal.SIGTERM)
            since = time.time()
            while not checkpoints("stopped"):
                check(time.time() - since < PATIENCE, "without mpirun no checkpoint is written")
                time.sleep(0.1)
            os.kill(mpirun, signal.SIGCONT)
        else:
            os.kill(mpirun, signal.SIGCONT)
            process.send_signal(signal.SIGTERM)
        status = end_of(process, "ranks")
        check(status == 4, f"status {status}:\n{pathlib.Path('out.txt').read_text()}")
        check(checkpoints("stopped"), "there is no checkpoint")
        said = pathlib.Path("out.txt").read_bytes()
        check(b"\r" not in said.replace(b"\r\n", b"\n") and b"\x1b" not in said, f"control characters in a file:\n{said[-500:]}")

    # who kills the script asks the run
    fresh("stopped")
    process = start("stopped", FULL, launcher=[str(REPOSITORY / "scripts/ranks"), "2"])
    wait_for(lambda: computes("stopped"), process)
    time.sleep(1)
    mpirun = child_of(process.pid)
    process.kill()
    since = time.time()
    while os.path.exists(f"/proc/{mpirun}"):
        check(time.time() - since < PATIENCE, "the run goes on without the script")
        time.sleep(0.1)
    check(checkpoints("stopped"), "there is no checkpoint")

    # what one rank cannot do, all ranks end for, with its words and its status
    entries = {**FULL, "Time/End time in ms": 0.01}
    os.environ["OMPI_MCA_odls_base_sigkill_timeout"] = "0"  # nobody is left to be killed
    for output, words in (("/dev/null", "is a file, not a directory"), ("/proc/none", "cannot be used")):
        done = subprocess.run(
            ["mpirun", "-n", "2", *command(output, entries)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
        )
        check(done.returncode == 2 and words in done.stdout, f"status {done.returncode}:\n{done.stdout}")
        check(done.stdout.count("chaindrive: ") == 1, done.stdout)


def contents(directory):
    folder = pathlib.Path(directory)
    return {str(file): file.read_bytes() for file in folder.rglob("*") if file.is_file() and file.name != "chaindrive.lock"}


def refused(words, directory, entries, options=()):
    before = contents(directory)
    said = run(directory, entries, options, status=2)
    check(re.search(words, said, re.S), f"it does not say {words}:\n{said}")
    check("xception" not in said and "filesystem error" not in said, said)
    check(contents(directory) == before, f"{words}: what was there is not as it was")


def directory():
    # one run at a time
    fresh("shared", "link")
    process = start("shared", LONG)
    wait_for(lambda: computes("shared"), process)
    pathlib.Path("link").unlink(missing_ok=True)
    os.symlink("shared", "link")
    process.send_signal(signal.SIGSTOP)
    time.sleep(0.3)
    who = f"Another run is at work.*process {process.pid} on {re.escape(socket.gethostname())}"
    refused(who, "shared", SHORT)
    refused(who, "link", SHORT, ["--resume", "auto"])
    run("shared", SHORT, ["--plan"])  # which writes nothing
    process.kill()
    process.wait()
    check(pathlib.Path("shared/chaindrive.lock").exists(), "kill -9 leaves the file")
    short = {**SHORT, "Output/Checkpoint interval in ms": 0.2}
    run("shared", short)  # which is no lock any more
    check(not pathlib.Path("shared/chaindrive.lock").exists(), "the lock is left behind")

    # what is refused leaves all as it was
    newest = checkpoints("shared")[-1]
    further = {**short, "Time/End time in ms": 1.2}
    resume = ["--resume", "auto"]
    refused("other parameters", "shared", {**further, "Loads/Resisting torque in N m": 30}, resume)
    refused("window", "shared", {**further, "Output/Window start in ms": 0.05}, resume)
    refused("after Time/End time", "shared", {**SHORT, "Time/End time in ms": 0.3}, ["--resume", str(newest)])
    os.mkdir("shared/checkpoint-000000077.ckpt")
    refused("checkpoint-000000077.ckpt' is a directory", "shared", SHORT)
    refused("checkpoint-000000077.ckpt' is a directory", "shared", further, resume)
    os.rmdir("shared/checkpoint-000000077.ckpt")

    # files that look like ours stay, ours go; a resumed run that stops leaves no older summary
    pathlib.Path("shared/histories_mine.csv").write_text("mine")
    check(pathlib.Path("shared/summary.json").exists(), "there is no summary")
    run("shared", {**further, "Output/CSV": "false", "Output/Wall-clock limit in s": 1e-3}, resume, status=4)
    check(not pathlib.Path("shared/summary.json").exists(), "the summary of the earlier end is still there")
    left = sorted(file.name for file in pathlib.Path("shared").glob("*.csv"))
    check(left == ["histories_mine.csv"], f"CSV files that are not continued: {left}")
    run("shared", short)
    check(len(list(pathlib.Path("shared").glob("*.csv"))) == 7 + 1, "CSV files")
    run("shared", {**SHORT, "Output/CSV": "false"})
    check([file.name for file in pathlib.Path("shared").glob("*.csv")] == left, "CSV files of the earlier run")

    # directories that cannot be
    run("x/" * 2000, SHORT, status=2)
    run("y" * 300, SHORT, status=2)
    os.mkdir("deleted")
    there = shutil.which("sh")
    words = command("here", SHORT)
    done = subprocess.run(
        [there, "-c", 'cd deleted && rmdir ../deleted && exec "$@"', "sh", *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    check(done.returncode == 2 and "chaindrive: " in done.stdout, f"status {done.returncode}:\n{done.stdout}")
    check("filesystem error" not in done.stdout, done.stdout)

    # what the guard says is in the log
    said = run("guarded", {**SHORT, "Time/Energy limit in percent": 1e-9}, status=3)
    message = re.search("chaindrive: (.*)", said)[1]
    check(log_of("guarded").rstrip().endswith(message), f"log.txt does not say: {message}")


if __name__ == "__main__":
    {"console": console, "signals": signals, "ranks": ranks, "directory": directory}[sys.argv[1]]()
