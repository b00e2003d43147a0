# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `chaindrive report` starts: chaindrive.report, from the folder in which the package lies."""
import importlib.util
import sys

PACKAGES = ("python3-h5py", "python3-numpy", "python3-pandas")  # each has the module of its name

missing = [package for package in PACKAGES if importlib.util.find_spec(package.removeprefix("python3-")) is None]
if missing:
    print("chaindrive: A report needs packages of Debian that are not installed: apt install --no-install-recommends " + " ".join(missing),
          file=sys.stderr)
    sys.exit(0 if "--after-run" in sys.argv else 2)

from chaindrive.report.__main__ import main  # noqa: E402

sys.exit(main())
