#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad input never crashes: spoils parameter files and meshes of this repository at random, but the same
way each time, and runs the program on each. It must end by itself, in time and without a signal: with
status 0 and finite results, or with status 2 or 3 and a sentence.

    fuzz.py                          20,000 inputs, one at a time
    fuzz.py --count 500 --jobs 4     the first 500, four at a time
    fuzz.py --meshes                 all of them meshes, half of these binary
    fuzz.py --only 17                input 17, with what the program says
    fuzz.py --server                 by `chaindrive serve`, which loads the libraries once: much faster

Inputs that fail are left in the folder of --results.
"""

import argparse
import atexit
import json
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from random import Random

import binary_meshes
import meshes
import mutations
import served

ROOT = Path(__file__).resolve().parents[2]
# One process needs no network, and OpenMPI looks for none.
ENVIRONMENT = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_pml": "ob1",
    "OMPI_MCA_btl": "self",
    **os.environ,
}
MOST_MEMORY = 1e9  # bytes that an input of less than a megabyte may make the program use
NOT_FOR_USERS = r"exception|deal\.ii|assert|HDF5-DIAG|std::|bad_alloc|terminate"
# few steps of a run that was meant to be long
SHORT = {
    "Time/End time in ms": 0.02,
    "Time/Time step in us": "auto",
    "Time/Safety factor": 0.9,
    "Output/Window start in ms": 0,
    "Output/History interval in us": 2,
    "Output/Field interval in ms": 0.01,
}


class Inputs:
    """Input number i is a function of the seed and i alone; the first is one that asked for gigabytes once."""

    def __init__(self, seed, only_meshes=False):
        self.seed, self.only_meshes = seed, only_meshes
        self.files = sorted(file for file in ROOT.glob("prm/**/*.prm") if file.parent.name != "studies")
        mesh = (ROOT / "meshes/sprocket-15.msh").read_text()
        self.meshes = [mesh, mesh, meshes.as_version_4(mesh)]
        self.binary = binary_meshes.all_forms(mesh)
        self.known = mutations.entries((ROOT / "doc/parameters.md").read_text())

    def write(self, i, folder):
        """Writes input @p i to @p folder; returns the program's options and whether it is to run."""
        random = Random(f"{self.seed} {i}")
        runs = random.random() < 0.2
        file = folder / "input.prm"
        # elastic solutions take seconds for each chain
        options = ([] if runs else ["plan"]) + [str(file), "--set", "Model/Stiffness from=dimensions"]
        if runs:
            options += [x for k, v in SHORT.items() for x in ("--set", f"{k}={v}")]
        if i == 0 or self.only_meshes or random.random() < 0.25:
            source = ROOT / "prm/paper/imported-sprocket.prm"
            file.write_text(source.read_text())
            if i == 0:
                (folder / "input.msh").write_bytes(binary_meshes.many_groups())
            elif random.random() < 0.5:
                (folder / "input.msh").write_bytes(binary_meshes.spoiled(random.choice(self.binary), random))
            else:
                text = mutations.spoiled(random.choice(self.meshes), mutations.MSH, random)
                (folder / "input.msh").write_text(text, errors="surrogateescape")
            options += ["--set", f"Drive/Sprockets/Driver mesh={folder / 'input.msh'}"]
        else:
            source = random.choice([f for f in self.files if not runs or "full" not in f.name])
            text = mutations.spoiled(source.read_text(), mutations.PRM, random, self.known)
            file.write_text(text, errors="surrogateescape")
        return options + ["--output", str(folder / "results")], runs


class Program:
    """Runs the program; called with its options, it returns the exit status, or minus the signal that ended it, and the
    largest memory in bytes."""

    def __init__(self, program, seconds, memory):
        self.program, self.seconds, self.memory = str(program.resolve()), seconds, memory

    def __call__(self, options, folder):
        with open(folder / "stdout", "wb") as out, open(folder / "stderr", "wb") as said:
            process = subprocess.Popen(
                [self.program, *options], stdout=out, stderr=said, stdin=subprocess.DEVNULL, cwd=folder, env=ENVIRONMENT, preexec_fn=self.limit
            )
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            return process.returncode, usage.ru_maxrss * 1024

    def limit(self):
        if self.memory:
            resource.setrlimit(resource.RLIMIT_AS, (self.memory, self.memory))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        signal.alarm(self.seconds)


class Server(Program):
    """The same by a server, whose copies have its limits."""

    def __init__(self, program, seconds, memory):
        super().__init__(program, seconds, memory)
        server = served.Server(self.program)
        atexit.register(server.stop)
        resource.prlimit(server.process.pid, resource.RLIMIT_CORE, (0, 0))
        if memory:
            resource.prlimit(server.process.pid, resource.RLIMIT_AS, (memory, memory))
        while not os.path.exists(f"{server.folder}/socket") and server.process.poll() is None:
            time.sleep(0.01)

    def __call__(self, options, folder):
        with open(folder / "stdout", "wb") as out, open(folder / "stderr", "wb") as said:
            copy = served.popen([self.program, *options], out, said, ENVIRONMENT, str(folder))
        if not isinstance(copy, served.Copy):
            sys.exit(f"there is no server to do {options}")
        if copy.poll(self.seconds) is None:
            copy.send_signal(signal.SIGALRM)
        return copy.wait(), copy.memory


def numbers_that_are_none(summary):
    """Members of a summary that must be finite and are not; what Output/Quantities leave out is not there."""
    asked = [k for k in ("drive_work", "resisting_work", "driven_angle_end") if k in summary] + ["time_step"]
    return [k for k in asked if not isinstance(summary.get(k), (int, float))] + [
        k for k, v in summary.get("energy", {}).items() if not isinstance(v, (int, float))
    ]


def judge(program, options, runs, folder):
    """(exit status, what is wrong or nothing, what the program said)."""
    status, memory = program(options, folder)
    out, said = ((folder / name).read_text(errors="replace") for name in ("stdout", "stderr"))
    if status == -signal.SIGALRM:
        return status, f"still running after {program.seconds} s", said
    if status < 0 or status > 128:
        return status, f"ended by signal {-status if status < 0 else status - 128}", said
    if status not in (0, 2, 3):
        return status, f"exit status {status}", said
    if memory > MOST_MEMORY:
        return status, f"{memory / 1e9:.1f} GB of memory", said
    if status:
        message = said[said.find("chaindrive: ") + 12 :] if "chaindrive: " in said else ""
        if len(message.split()) < 3:
            return status, "no sentence", said
        if bad := re.search(NOT_FOR_USERS, said, re.IGNORECASE):
            return status, f"a message that is not for users: {bad[0]}", said
        if (folder / "input.msh").exists() and "input.msh" not in said:
            return status, "a message that does not name the mesh", said
        return status, "", said
    if bad := re.search(r"(?<![\w.])-?(nan|inf)(?!\w)", re.sub(r"pitch time.*", "", out)):
        return status, f"{bad[0]} in the output", out
    if runs:
        bad = numbers_that_are_none(json.loads((folder / "results/summary.json").read_text()))
        return status, "not a number: " + ", ".join(bad) if bad else "", out
    return status, "", said


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=20000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--only", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--meshes", action="store_true")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--timeout", type=int, default=120, help="seconds for one input")
    parser.add_argument("--memory", type=float, default=6.0, help="GB: what asks for more is told that it cannot have it; 0: any")
    parser.add_argument("--program", default=ROOT / "build/source/chaindrive", type=Path)
    parser.add_argument("--server", action="store_true", help="start the program by its server")
    parser.add_argument("--results", type=Path, default=Path("results/fuzz"))
    options = parser.parse_args()

    inputs, limits = Inputs(options.seed, options.meshes), (options.timeout, int(options.memory * 2**30))
    program = (Server if options.server else Program)(options.program, *limits)
    began = time.time()

    def one(i):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            arguments, runs = inputs.write(i, folder)
            status, wrong, said = judge(program, arguments, runs, folder)
            if wrong or options.only is not None:
                kept = options.results / f"{options.seed}-{i}"
                kept.mkdir(parents=True, exist_ok=True)
                for file in folder.glob("input.*"):
                    (kept / file.name).write_bytes(file.read_bytes())
                (kept / "command").write_text(" ".join(map(repr, arguments)).replace(name, str(kept)) + "\n" + said)
            return i, status, wrong, said

    numbers = range(options.first, options.first + options.count) if options.only is None else [options.only]
    statuses, failed = Counter(), 0
    with ThreadPoolExecutor(options.jobs) as pool:
        for i, status, wrong, said in pool.map(one, numbers):
            statuses[status] += 1
            if wrong:
                failed += 1
                print(f"input {i}: {wrong}\n  {said.strip()[-600:]}", flush=True)
            elif options.only is not None:
                print(f"status {status}\n{said}")
            if sum(statuses.values()) % 1000 == 0:
                print(f"{sum(statuses.values())} inputs, {failed} failed", flush=True)
    told = ", ".join(f"{n} with status {status}" for status, n in sorted(statuses.items()))
    seconds = (time.time() - began) / len(numbers)
    print(f"{len(numbers)} inputs of seed {options.seed}: {told}; {failed} failed; {seconds:.2f} s for each")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
