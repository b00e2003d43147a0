# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -m chaindrive.report DIRECTORY... [--output FILE]: writes a report on runs and prints its path."""
import argparse
import sys

from chaindrive import RunError, report


def main() -> int:
    """Write the report that the command line asks for, and return the exit status."""
    parser = argparse.ArgumentParser(prog="chaindrive report", description="Writes a report on runs: one HTML file.")
    parser.add_argument("folders", nargs="+", metavar="DIRECTORY", help="directory with the results of a run")
    parser.add_argument("--output", metavar="FILE", help="output file; by default report.html in the first directory")
    parser.add_argument("--quiet", action="store_true", help="do not print the path")
    parser.add_argument("--after-run", action="store_true", help=argparse.SUPPRESS)  # which has ended well, whatever becomes of the page
    words = parser.parse_args()
    status = _write(words)
    return 0 if words.after_run else status


def _write(words: argparse.Namespace) -> int:
    try:
        if len(words.folders) > report.MOST_RUNS:
            raise RunError(f"A report compares up to {report.MOST_RUNS} runs, not {len(words.folders)}.")
        file = report.write(words.folders, words.output)
    except RunError as error:
        print(f"chaindrive: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"chaindrive: The report cannot be written: {error}.", file=sys.stderr)
        return 3
    if not words.quiet:
        print(f"Report: {file}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
