# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Debian packages that a study needs beside Snakemake: python3-NAME has the module NAME."""
import importlib.util
import os
import sys

PACKAGES = ("python3-h5py", "python3-jinja2", "python3-matplotlib", "python3-numpy", "python3-pandas")


def end_without_them():
    """Ends this process with a sentence if one is missing."""
    missing = [package for package in PACKAGES if importlib.util.find_spec(package.removeprefix("python3-")) is None]
    if missing:
        print("chaindrive: A study needs packages of Debian that are not installed: apt install --no-install-recommends " + " ".join(missing),
              file=sys.stderr, flush=True)
        os._exit(3)  # Snakemake would show an exception
