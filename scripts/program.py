# SPDX-License-Identifier: LGPL-2.1-or-later
"""How scripts start chaindrive and what they read of its results."""
import atexit
import json
import os
import pathlib
import sys
import threading

import served

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = REPOSITORY / "build/source/chaindrive"

os.environ.update(served.ENVIRONMENT)


STARTED = set()  # programs
LOCK = threading.Lock()


def serve(program):
    """A program that is started again gets a server, which has its libraries loaded."""
    name = pathlib.Path(program).name
    with LOCK:
        if name != "chaindrive" or served.VARIABLE in os.environ:
            return
        if program in STARTED:
            atexit.register(served.Server(program).stop)
        STARTED.add(program)


def command(file, entries=(), *options, program=PROGRAM, ranks=1):
    """The words that start a run of `file`, a path in the repository or any other: `entries` are {"Section/Entry": value}."""
    launcher = ["mpirun", "-n", str(ranks)] if ranks > 1 else []
    sets = [word for name, value in dict(entries).items() for word in ("--set", f"{name}={value}")]
    return [*launcher, str(program), str(REPOSITORY / file), *sets, *map(str, options)]


def start(words, environment=(), folder="."):
    """Runs `words` in `folder` to their end, with the variables {name: value} set besides; returns status, stdout and stderr."""
    serve(words[0])
    return served.run(words, {**os.environ, **dict(environment)}, folder)


def run(file, entries=(), *options, program=PROGRAM, ranks=1, status=0):
    """Runs to the end and returns what was said; any other exit status than `status` ends the script."""
    words = command(file, entries, *options, program=program, ranks=ranks)
    serve(words[0])
    done = served.run(words, merged=True)
    check(done.returncode == status, f"status {done.returncode} instead of {status}: {' '.join(words)}\n{done.stdout}")
    return done.stdout


def summary(directory):
    """summary.json of the run in `directory`."""
    return json.loads((pathlib.Path(directory) / "summary.json").read_text())


def check(condition, message):
    """Ends the script with `message` unless `condition` holds."""
    if not condition:
        sys.exit(message)
