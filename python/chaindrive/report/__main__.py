# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -m chaindrive.report DIRECTORY... [--output FILE]: writes a report on runs and prints its path."""
import argparse
import sys

from chaindrive import RunError, report
from chaindrive.errors import exit_status


def main() -> int:
    """Write the report that the command line asks for, and return the exit status."""
    parser = argparse.ArgumentParser(prog="chaindrive report", description="Writes a report on runs: one HTML file.")
    parser.add_argument("folders", nargs="+", metavar="DIRECTORY", help="directory with the results of a run")
    parser.add_argument("--output", metavar="FILE", help="output file; by default report.html in the first directory")
    parser.add_argument("--quiet", action="store_true", help="do not print the path")
    parser.add_argument("--after-run", action="store_true", help=argparse.SUPPRESS)  # which has ended well, whatever becomes of the page
    words = parser.parse_args()
    status = exit_status(lambda: _write(words), "The report")
    return 0 if words.after_run else status


def _write(words: argparse.Namespace) -> None:
    if len(words.folders) > report.MOST_RUNS:
        raise RunError(f"A report compares up to {report.MOST_RUNS} runs, not {len(words.folders)}.")
    file = report.write(words.folders, words.output)
    if not words.quiet:
        print(f"Report: {file}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
