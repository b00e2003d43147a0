# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the program accepts every .prm of the folder prm/, of studies the quick form too: plans.py PATH_OF_CHAINDRIVE
parts | dimensions.

The latter word is for the entry Stiffness from: `parts` computes the stiffnesses of every drive, which takes minutes.
"""

import sys

import program
import style


def refused(which, paths, stiffness_from):
    """Those that it does not plan, with what it says."""
    said = {}
    for path in paths:
        text = (style.ROOT / path).read_text()
        settings = ["--set", f"Model/Stiffness from={stiffness_from}"]
        if stiffness_from == "dimensions" and "Tooth inertia" in text:  # which parts alone know
            settings += ["--set", "Effects/Tooth inertia=auto"]
        study = ["study", path, "--dry-run", "--set", "Study/Phases=1"]
        ways = [["plan", path]]
        if path.startswith("prm/studies/"):
            quick = [[*study, "--quick"]] if "set Quick " in text else []
            ways = [study, *quick]
        for words in ways:
            result = program.start([which, *words, *settings], folder=style.ROOT)
            if result.returncode:
                said[" ".join(words)] = result.stderr.strip()
    return said


def main():
    paths = [path for path in style.repository() if path.startswith("prm/") and path.endswith(".prm")]
    said = refused(sys.argv[1], paths, sys.argv[2])
    for words, text in said.items():
        print(f"{words}: {text}")
    print(f"{len(paths)} files, {len(said)} refused")
    sys.exit(bool(said) or not paths)


if __name__ == "__main__":
    main()
