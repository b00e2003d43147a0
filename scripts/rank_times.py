#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""rank_times.py FILE [--program PROGRAM] [--set SECTION/ENTRY=VALUE]...

Predicts how long two ranks take for FILE, with reduced bodies, on a machine that has two cores for them, on one
that other programs use as well: by an MPI wrapper library (rank_times.cc, compiled with mpicxx) each rank notes
the CPU time that it spends between its calls of MPI, and these stretches are put one after the other here as if
nothing else had run, a rank waiting wherever it needs what the other one has not yet sent. Prints, in seconds:
what each rank is busy for before the first step, in the time loop and afterwards; how long the loop and all of it
take; and how long each rank waits in the loop, at the sum in each step, for messages and for all ranks.
"""
import argparse
import collections
import os
import pathlib
import subprocess
import tempfile

import program

EXCHANGE, SEND, RECEIVE, COLLECTIVE, END = range(5)
LATENCY = 4e-6  # of an exchange, s: doc/performance.md
NAMES = {EXCHANGE: "sums", RECEIVE: "messages", COLLECTIVE: "all ranks"}


def compiled(folder):
    """The wrapper library, compiled into `folder`."""
    library = pathlib.Path(folder, "times.so")
    source = pathlib.Path(__file__).resolve().with_name("rank_times.cc")
    subprocess.run(["mpicxx", "-std=c++17", "-O2", "-shared", "-fPIC", "-o", library, source], check=True)
    return library


def read(folder, rank):
    """The calls of a rank: (busy seconds before it, kind, tag)."""
    lines = pathlib.Path(folder, str(rank)).read_text().split("\n")[:-1]
    return [(float(busy), int(kind), int(tag)) for busy, kind, tag in (line.split() for line in lines)]


def parts(calls):
    """Before the first step, the time loop and the rest: the first two exchanges are of the start."""
    exchanges = [i for i, call in enumerate(calls) if call[1] == EXCHANGE]
    program.check(len(exchanges) > 3, "The ranks exchange no sums: choose reduced bodies and more steps.")
    first, last = exchanges[2] + 1, exchanges[-1] + 1
    return calls[:first], calls[first:last], calls[last:]


def busy(calls):
    return sum(call[0] for call in calls)


class Rank:
    """Goes through the calls of a loop as far as it does not depend on the other rank."""

    def __init__(self, calls):
        self.calls, self.next, self.time, self.at_call = calls, 0, 0.0, False
        self.sent = collections.defaultdict(collections.deque)  # by tag: when
        self.waited = collections.Counter()  # by kind

    def advance(self, other):
        """The kind of the call at which it waits, END after the last one."""
        while self.next < len(self.calls):
            seconds, kind, tag = self.calls[self.next]
            if not self.at_call:
                self.time += seconds
            self.at_call = True
            if kind == SEND:
                self.sent[tag].append(self.time)
            elif kind == RECEIVE:
                if not other.sent[tag]:
                    return kind
                self.wait_until(other.sent[tag].popleft(), kind)
            else:
                return kind
            self.pass_call()
        return END

    def wait_until(self, when, kind):
        self.waited[kind] += max(0.0, when - self.time)
        self.time = max(self.time, when)

    def pass_call(self):
        self.next, self.at_call = self.next + 1, False


def replay(first, second):
    """Both ranks after their loops."""
    ranks = [Rank(first), Rank(second)]
    while True:
        places = [(rank.next, rank.at_call) for rank in ranks]
        kinds = [rank.advance(other) for rank, other in zip(ranks, ranks[::-1])]
        if kinds == [END, END]:
            return ranks
        if kinds[0] == kinds[1] != RECEIVE:
            latest = max(rank.time for rank in ranks)
            for rank in ranks:
                rank.wait_until(latest, kinds[0])
                rank.time += LATENCY
                rank.pass_call()
        program.check(places != [(rank.next, rank.at_call) for rank in ranks], "The ranks wait for each other.")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("--program", default=str(program.PROGRAM))
    parser.add_argument("--set", action="append", default=[])
    asked = parser.parse_args()
    entries = dict(text.split("=", 1) for text in asked.set)
    with tempfile.TemporaryDirectory() as folder:
        options = ("--quiet", "--output", f"{folder}/run")
        words = program.command(os.path.abspath(asked.file), entries, *options, program=asked.program, ranks=2)
        done = program.start(words, {"LD_PRELOAD": str(compiled(folder)), "TIMES_FOLDER": folder})
        program.check(done.returncode == 0, f"status {done.returncode}: {' '.join(words)}\n{done.stdout}{done.stderr}")
        of_ranks = [parts(read(folder, rank)) for rank in range(2)]
    ranks = replay(of_ranks[0][1], of_ranks[1][1])
    for number, (before, loop, after) in enumerate(of_ranks):
        waits = ", ".join(f"{NAMES[kind]} {ranks[number].waited[kind]:.2f}" for kind in NAMES)
        print(f"rank {number}: busy {busy(before):.2f} + {busy(loop):.2f} + {busy(after):.2f}; waits: {waits}")
    took = max(rank.time for rank in ranks)
    ends = [max(busy(of[i]) for of in of_ranks) for i in (0, 2)]
    print(f"time loop {took:.2f}, all {ends[0] + took + ends[1]:.2f}")


if __name__ == "__main__":
    main()
