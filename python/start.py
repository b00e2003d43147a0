# SPDX-License-Identifier: LGPL-2.1-or-later
"""start.py report | export WORD...: chaindrive.report or chaindrive.export, from the folder in which the package lies."""
import importlib
import importlib.util
import sys

PACKAGES = ("python3-h5py", "python3-numpy", "python3-pandas")  # each has the module of its name
WHAT = {"report": "A report", "export": "An export"}

command = sys.argv.pop(1)
missing = [package for package in PACKAGES if importlib.util.find_spec(package.removeprefix("python3-")) is None]
if missing:
    print(f"chaindrive: {WHAT[command]} needs packages of Debian that are not installed: apt install --no-install-recommends "
          + " ".join(missing), file=sys.stderr)
    sys.exit(0 if "--after-run" in sys.argv else 2)

sys.exit(importlib.import_module({"report": "chaindrive.report.__main__", "export": "chaindrive.export"}[command]).main())
