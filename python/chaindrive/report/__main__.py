# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -m chaindrive.report DIRECTORY... [--output FILE]: writes a report on runs and prints its path."""
import argparse
import importlib.util
import pathlib
import sys

PACKAGES = ("python3-h5py", "python3-numpy", "python3-pandas")  # each has the module of its name


def main():
    if __package__ in (None, ""):  # started by its path
        sys.path[0] = str(pathlib.Path(__file__).resolve().parents[2])
    parser = argparse.ArgumentParser(prog="chaindrive report", description="Writes a report on runs: one HTML file.")
    parser.add_argument("folders", nargs="+", metavar="DIRECTORY", help="with the results of a run")
    parser.add_argument("--output", metavar="FILE", help="report.html in the first directory by default")
    parser.add_argument("--quiet", action="store_true", help="do not print the path")
    parser.add_argument("--after-run", action="store_true", help=argparse.SUPPRESS)  # which has ended well, whatever becomes of the page
    words = parser.parse_args()
    status = write(words)
    return 0 if words.after_run else status


def write(words):
    missing = [package for package in PACKAGES if importlib.util.find_spec(package.removeprefix("python3-")) is None]
    if missing:
        print("chaindrive: A report needs packages of Debian that are not installed: apt install --no-install-recommends " + " ".join(missing),
              file=sys.stderr)
        return 2
    from chaindrive import RunError, report
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
