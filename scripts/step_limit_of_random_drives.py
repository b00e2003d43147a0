# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the critical time step of reduced drives is above the smallest one that any search finds.

    step_limit_of_random_drives.py [-n 100] [--seed 0] [--list]

Runs random reduced drives: chain, teeth, tooth form, friction, damping and stiffness of contacts. Their contacts may
close in many ways; the program uses the way that CoupledModes::find_worst() finds. tests/benchmarks/step_limit.cc looks
for ways with a higher frequency and reports by how many percent: `more` by a thorough search, `waves` in waves between q = 0
and pi, `pitches` with pitches closed in different ways. Prints median, 90th percentile and largest. The bases of parts are
read from and written to the cache of chaindrive.
"""
import argparse
import random
import statistics
import subprocess

import program

BENCHMARK = program.REPOSITORY / "build/tests/benchmarks/step_limit_benchmark"
COLUMNS = ("more", "waves", "pitches")


def draw(rng):
    """Entries of a reduced drive. Chains and meshes are few, since each needs bases of its own."""
    driver, driven = rng.randint(9, 30), rng.randint(9, 60)
    return {
        "Model/Fidelity": "reduced",
        "Model/Stiffness from": "dimensions",
        "Model/Symmetry model": rng.choice(("true", "false")),
        "Mesh/Refinement": 0,
        "Drive/Chain/Designation": rng.choice(("525", "08B")),
        "Drive/Number of links": 2 * (driver + driven),
        "Drive/Driver teeth": driver,
        "Drive/Driven teeth": driven,
        "Drive/Sprockets/Tooth form": rng.choice(("iso min", "iso mid", "iso max")),
        "Drive/Layout/Start": "taut",
        "Contact/Friction coefficient": rng.choice((0, 0.1, 0.3)),
        "Contact/Damping ratio": rng.choice((0, 0.1, 0.5, 1)),
        "Contact/Tangential ratio": round(rng.uniform(0.2, 1), 3),
        "Contact/Enforcement": "penalty",
        "Contact/Penalty factor": round(10 ** rng.uniform(-1, 1), 3),
        "Effects/Tooth compliance": rng.choice(("on", "off")),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("-n", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--list", action="store_true", help="print the result of each drive")
    options = parser.parse_args()
    drives = [draw(random.Random(f"{options.seed} {k}")) for k in range(options.n)]
    lines = "".join("\t".join(f"{name}={value}" for name, value in drive.items()) + "\n" for drive in drives)
    words = [str(BENCHMARK), str(program.REPOSITORY / "prm/verification/hard.prm")]
    found, others, head = [], [], []
    with subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as benchmark:
        benchmark.stdin.write(lines)
        benchmark.stdin.close()
        for k, row in enumerate(benchmark.stdout):
            numbers = row.split()
            if k == 0:
                head = numbers
            elif len(numbers) == len(head) and numbers[0].isdigit():
                found.append(dict(zip(head, map(float, numbers))))
            else:
                others.append(row.strip())
            if options.list and k > 0:
                print(row.strip(), drives[k - 1], flush=True)
    program.check(benchmark.returncode == 0, f"the benchmark ends with status {benchmark.returncode}")
    print(f"{len(found)} drives of {options.n}; {len(others)} refused or not coupled")
    for row in sorted(set(others)):
        print(" ", row)
    program.check(len(found) > 0.8 * options.n, "most drives were refused: nothing was tried")
    print("percent of the frequency: median, 90th percentile, largest")
    for column in COLUMNS:
        values = sorted(row[column] for row in found)
        print(f"  {column:8} {statistics.median(values):8.4f} {values[int(0.9 * len(values))]:8.4f} {values[-1]:8.4f}")


if __name__ == "__main__":
    main()
