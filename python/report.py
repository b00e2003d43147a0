# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `chaindrive report` starts: chaindrive.report, from the folder in which the package lies."""
import sys

PACKAGES = {"h5py": "python3-h5py", "numpy": "python3-numpy", "pandas": "python3-pandas"}

try:
    from chaindrive.report.__main__ import main
except ModuleNotFoundError as error:
    if error.name not in PACKAGES:
        raise
    print(f"chaindrive: A report needs the Debian package {PACKAGES[error.name]}, which is not installed.", file=sys.stderr)
    sys.exit(0 if "--after-run" in sys.argv else 2)
sys.exit(main())
