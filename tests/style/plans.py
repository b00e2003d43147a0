# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the program accepts every .prm of the folder prm/: plans.py PATH_OF_CHAINDRIVE."""

import subprocess
import sys

import style


def refused(program, paths):
    """Those that it does not plan, with what it says."""
    said = {}
    for path in paths:
        words = ["study", path, "--dry-run", "--set", "Study/Phases=1"] if path.startswith("prm/studies/") else ["plan", path]
        result = subprocess.run([program, *words], cwd=style.ROOT, capture_output=True, text=True)
        if result.returncode:
            said[path] = result.stderr.strip()
    return said


def main():
    paths = [path for path in style.repository() if path.startswith("prm/") and path.endswith(".prm")]
    said = refused(sys.argv[1], paths)
    for path, text in said.items():
        print(f"{path}: {text}")
    print(f"{len(paths)} files, {len(said)} refused")
    sys.exit(bool(said) or not paths)


if __name__ == "__main__":
    main()
