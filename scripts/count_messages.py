#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""count_messages.py FILE [--ranks 2,4,8,16] [--program PROGRAM] [--steps 100,300] [--set SECTION/ENTRY=VALUE]...

Counts the messages between ranks in a time step of FILE, by an MPI wrapper library (count_messages.cc,
compiled with mpicxx). The difference between two runs of the given numbers of steps excludes the start.
Prints for each number of ranks, per step: messages and bytes of the rank that sends most; of the rank that
receives most; of all ranks; calls of collective functions, and the bytes that each rank contributes to them.
There may be more ranks than cores: only time suffers.
"""
import argparse
import math
import os
import pathlib
import subprocess
import tempfile

import program

QUIET = {
    "Output/Field interval in ms": 0,
    "Output/Checkpoint interval in ms": 0,
    "Output/Window start in ms": 0,
}


def counter(folder):
    """The library that counts, compiled into `folder`."""
    library = pathlib.Path(folder, "messages.so")
    source = pathlib.Path(__file__).resolve().with_name("count_messages.cc")
    subprocess.run(["mpicxx", "-std=c++17", "-O1", "-shared", "-fPIC", "-o", library, source], check=True)
    return library


def counted(library, file, entries, ranks, end, which):
    """What a run up to `end` (ms) has sent: steps, {(from, to): messages and bytes}, {function: calls and bytes}."""
    with tempfile.TemporaryDirectory() as folder:
        output = f"{folder}/run"
        entries = {**QUIET, **entries, "Time/End time in ms": repr(end)}
        words = program.command(file, entries, "--quiet", "--output", output, program=which, ranks=ranks)
        done = program.start(words, {"LD_PRELOAD": str(library), "MESSAGES_FOLDER": folder})
        program.check(done.returncode == 0, f"status {done.returncode}: {' '.join(words)}\n{done.stdout}{done.stderr}")
        steps = program.summary(output)["steps"]
        sent, together = {}, {}
        for rank in range(ranks):
            for line in pathlib.Path(folder, str(rank)).read_text().splitlines():
                name, *numbers = line.split()
                if name == "to":
                    sent[rank, int(numbers[0])] = [int(number) for number in numbers[1:]]
                elif rank == 0:
                    together[name] = [int(number) for number in numbers]
    return steps, sent, together


def per_step(library, file, entries, ranks, steps, which=program.PROGRAM):
    """Per step: {rank: messages and bytes} sent and received, and {function: calls and bytes} of the first rank."""
    step = step_of(file, entries, which)
    first, last = (counted(library, file, entries, ranks, (n - 0.5) * step, which) for n in steps)
    n = last[0] - first[0]

    def growth(before, after):
        return [(b - a) / n for a, b in zip(before, after)]

    pairs = {pair: growth(first[1][pair], last[1][pair]) for pair in last[1]}
    def total(end, rank):
        counts = [count for pair, count in pairs.items() if pair[end] == rank and pair[0] != pair[1]]
        return [math.fsum(count[i] for count in counts) for i in (0, 1)]

    sent, received = ({rank: total(end, rank) for rank in range(ranks)} for end in (0, 1))
    together = {name: growth(first[2].get(name, [0, 0]), count) for name, count in last[2].items()}
    return sent, received, {name: count for name, count in together.items() if count[0] > 0}


def step_of(file, entries, which):
    """The step (ms), from a short run."""
    with tempfile.TemporaryDirectory() as folder:
        words = ("--quiet", "--output", f"{folder}/run")
        program.run(file, {**QUIET, **entries, "Time/End time in ms": 0.006}, *words, program=which)
        return program.summary(f"{folder}/run")["time_step"] * 1e3


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("--ranks", default="2,4,8,16")
    parser.add_argument("--program", default=str(program.PROGRAM))
    parser.add_argument("--steps", default="100,300")
    parser.add_argument("--set", action="append", default=[])
    asked = parser.parse_args()
    file = os.path.abspath(asked.file)
    entries = dict(text.split("=", 1) for text in asked.set)
    steps = [int(n) for n in asked.steps.split(",")]
    with tempfile.TemporaryDirectory() as folder:
        library = counter(folder)
        print("| ranks | most sent | most received | all ranks | together |\n|---|---|---|---|---|")
        for ranks in map(int, asked.ranks.split(",")):
            sent, received, together = per_step(library, file, entries, ranks, steps, asked.program)

            def text(messages, bytes_sent):
                return f"{messages:.1f}, {bytes_sent / 1e3:.1f} kB"

            cells = [
                text(*(max(count[i] for count in of.values()) for i in (0, 1))) for of in (sent, received)
            ]
            cells.append(text(*(math.fsum(count[i] for count in sent.values()) for i in (0, 1))))
            cells.append("; ".join(f"{name} {text(*count)}" for name, count in sorted(together.items())))
            print(f"| {ranks} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
