# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether doc/parameters.md is what the program writes: documentation.py PATH_OF_CHAINDRIVE."""

import difflib
import subprocess
import sys

import style

STORED = style.ROOT / "doc" / "parameters.md"


def difference(stored, written):
    return list(difflib.unified_diff(stored.splitlines(), written.splitlines(), "doc/parameters.md", "program", lineterm=""))


def main():
    result = subprocess.run([sys.argv[1], "document"], capture_output=True, text=True, check=True)
    stored = STORED.read_text(encoding="utf-8") if STORED.exists() else ""
    lines = difference(stored, result.stdout)
    print(*lines[:40], sep="\n")
    if lines or not result.stdout:
        sys.exit("doc/parameters.md is out of date: build/source/chaindrive document > doc/parameters.md")
    print("doc/parameters.md is current")


if __name__ == "__main__":
    main()
