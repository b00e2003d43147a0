# SPDX-License-Identifier: LGPL-2.1-or-later
"""copies.py PROGRAM: copies of a server (`chaindrive serve`) do what programs do that are started as usual."""
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

import h5py

import served
from program import REPOSITORY, check

PROGRAM = sys.argv[1]
SIMPLE, LAYERED = str(REPOSITORY / "prm/paper/simple.prm"), str(REPOSITORY / "prm/paper/layered.prm")
SHORT = ("--set", "Time/End time in ms=1", "--set", "Output/Window start in ms=0", "--set", "Output/Field interval in ms=0")


def until(condition, what, seconds=20):
    """Waits for what must come."""
    for _ in range(100 * seconds):
        if condition():
            return
        time.sleep(0.01)
    sys.exit(f"{what} has not come in {seconds} s")


def answers(path):
    """Whether a server listens on a socket: its file is there a moment before."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET) as connection:
        return path.exists() and connection.connect_ex(str(path)) == 0


def ready():
    """The socket of the server that has just been started."""
    path = pathlib.Path(os.environ[served.VARIABLE].rpartition(":")[0])
    until(lambda: answers(path), "the socket")
    return path


def begin(*words, keep=()):
    """A copy that writes what it says into the file said."""
    with open("said", "wb") as said:
        copy = served.popen([PROGRAM, *words], said, said, keep=keep)
    check(isinstance(copy, served.Copy), f"{words}: not by the server but as {copy}")
    return copy


def histories(directory):
    """All bytes of all histories."""
    found = {}
    with h5py.File(f"{directory}/histories.h5") as file:
        file.visititems(lambda name, item: found.update({name: item[:].tobytes()}) if isinstance(item, h5py.Dataset) else None)
    return found


def same():
    """What is said and written, the status, the environment, the working directory."""
    usual = [subprocess.run([PROGRAM, *words], capture_output=True, text=True)
             for words in (["template"], ["plan", "nowhere.prm"], ["--nonsense"])]
    words = [PROGRAM, SIMPLE, *SHORT, "--quiet", "--output"]
    check(subprocess.run([*words, "usual"]).returncode == 0, "a run as usual")
    with served.serving(PROGRAM):
        ready()
        for done in usual:
            copy = served.run(done.args)
            for name in ("returncode", "stdout", "stderr"):
                check(getattr(copy, name) == getattr(done, name), f"{done.args}: {name} is another one: {copy}")
        check(begin(*words[1:], "served").wait() == 0, "a run by the server")
        check(histories("usual") == histories("served") != {}, "the histories differ")
        # libraries, three quarters of it, are loaded by the server: the system does not count their pages in a copy
        usually, here = (json.loads(pathlib.Path(name, "summary.json").read_text())["memory_peak"] for name in ("usual", "served"))
        check(0.85 < here / usually < 1.1, f"memory: {here} B by the server, {usually} B as usual")
        copy = served.run([PROGRAM, "--version"], {**os.environ, "CHAINDRIVE_SIMD_WIDTH": "1"})
        check("one number at a time" in copy.stdout, f"the environment is another one: {copy}")
        os.makedirs("below", exist_ok=True)
        shutil.copy(SIMPLE, "below/below.prm")
        copy = served.run([PROGRAM, "plan", "below.prm"], folder="below")
        check(copy.returncode == 0, f"the working directory is another one: {copy}")
    print("the same as usual")


def signals():
    """A copy ends as a program does: asked to, when nobody waits for it any more, and with the server."""
    shutil.rmtree("stopped", ignore_errors=True)
    words = [LAYERED, "--set", "Time/End time in ms=300", "--output", "stopped"]

    def steps():
        return "t = " in pathlib.Path("said").read_text()

    def ended():
        return "Stopped by SIGTERM" in pathlib.Path("said").read_text()

    with served.serving(PROGRAM):
        ready()
        copy = begin(*words)
        until(steps, "the first step")
        copy.send_signal(signal.SIGTERM)
        check(copy.wait() == 4 and ended(), "the status after SIGTERM")

        copy = begin(*words, "--resume", "auto")
        until(steps, "the first step")
        copy.connection.close()
        until(ended, "the end of a copy that nobody waits for")

        copy = begin(*words, "--resume", "auto")
        until(steps, "the first step")
        copy.send_signal(signal.SIGKILL)
        check(copy.wait() == -signal.SIGKILL, "the status after SIGKILL")

    server = served.Server(PROGRAM)
    ready()
    copy = begin(*words, "--resume", "auto")
    until(steps, "the first step")
    server.process.kill()
    check(copy.wait() == -signal.SIGTERM, "the status after the server's end")
    until(ended, "the end of a copy whose server has died")
    check(served.run([PROGRAM, "--version"]).returncode == 0, "without the server: as usual")
    server.stop()
    print("ends as usual")


def strangers():
    """Who asks for nonsense gets no answer; the server goes on."""
    with served.serving(PROGRAM):
        path = ready()
        for message in (b"", b"nonsense", b"3\0a\0", b"99999999999999999999\0", b"1\0" + PROGRAM.encode() + b"\0"):
            connection = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
            connection.connect(str(path))
            if message:
                connection.send(message)
                check(connection.recv(16) == b"", f"an answer to {message}")
            connection.close()
        long = served.run([PROGRAM, "--version"], {**os.environ, "LONG": "x" * 100000, "LONGER": "x" * 120000})
        check(long.returncode == 0, "more than a message holds: as usual")
        check(begin("--version").wait() == 0, "a request after nonsense")
        taken = subprocess.run([PROGRAM, "serve", path], capture_output=True, text=True)
        check(taken.returncode == 3 and "Cannot listen on the socket" in taken.stderr, f"{taken}")
        process = begin(SIMPLE, *SHORT, "--output", "last")
    check(process.wait() == 0 and not path.exists(), "the server waits for its last copy and takes the socket away")
    long = subprocess.run([PROGRAM, "serve", "x" * 200], capture_output=True, text=True)
    check(long.returncode == 3 and "too long" in long.stderr, f"{long}")
    print("strangers are not served")


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    same()
    signals()
    strangers()
