# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether files of the repository are what the program writes: documentation.py PATH_OF_CHAINDRIVE."""

import difflib
import subprocess
import sys

import style

# The files that options of `chaindrive document` write.
WRITTEN = {"doc/parameters.md": [], "python/chaindrive/schema.json": ["--schema"]}


def difference(stored, written, name="stored"):
    return list(difflib.unified_diff(stored.splitlines(), written.splitlines(), name, "program", lineterm=""))


def main():
    for name, options in WRITTEN.items():
        result = subprocess.run([sys.argv[1], "document", *options], capture_output=True, text=True, check=True)
        file = style.ROOT / name
        lines = difference(file.read_text(encoding="utf-8") if file.exists() else "", result.stdout, name)
        print(*lines[:40], sep="\n")
        if lines or not result.stdout:
            sys.exit(f"{name} is out of date: {' '.join(['build/source/chaindrive document', *options])} > {name}")
        print(f"{name} is current")


if __name__ == "__main__":
    main()
