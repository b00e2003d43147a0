# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks one rule of style on the whole repository: style.py RULE. Exit status 1 on violations, 77 where a checker is of another
version than the one that decides."""

import os
import re
import subprocess
import sys
from pathlib import Path

import rules

ROOT = Path(__file__).resolve().parents[2]

# mypy, pyflakes, pydocstyle and numpy's type hints belong to Debian's Python.
PYTHON = "/usr/bin/python3" if os.access("/usr/bin/python3", os.X_OK) else sys.executable


def listed_by_git():
    """Tracked files and new ones that are not ignored; none where this is not a git checkout."""
    command = ["git", "-c", "safe.directory=*", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    try:
        listing = subprocess.run(command, cwd=ROOT, capture_output=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return []
    return [name for name in listing.decode().split("\0") if name]


def found_by_walking():
    """What an unpacked archive holds, but for what building and running leave behind."""
    ignored = (ROOT / ".gitignore").read_text().split()
    names = []
    for folder, subfolders, files in os.walk(ROOT):
        here = Path(folder)
        subfolders[:] = [
            name
            for name in subfolders
            if name != ".git" and not any(Path("/", here.relative_to(ROOT), name).match(i.rstrip("/")) for i in ignored)
        ]
        names += [(here / name).relative_to(ROOT).as_posix() for name in files]
    return names


def repository():
    """{path: text} of every file; of a picture only the size counts."""
    tree = {}
    for name in sorted(listed_by_git() or found_by_walking()):
        path = ROOT / name
        if path.is_file():
            try:
                tree[name] = path.read_text(encoding="utf-8")
            except UnicodeDecodeError:
                tree[name] = "\0" * path.stat().st_size
    return tree


def clang_format(files):
    """The first complaints of clang-format about these files."""
    command = ["clang-format", f"--style=file:{ROOT}/.clang-format", "--dry-run", "-Werror", *files]
    result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    complaints = [line for line in result.stderr.splitlines() if ": error:" in line]
    return complaints or ([result.stderr] if result.returncode else [])


def formatting(tree):
    return clang_format([path for path in tree if rules.is_cxx(path)])


def said_by(checker, *words):
    """The complaints of a checker that is a module of Python."""
    result = subprocess.run([PYTHON, "-B", "-m", checker, *map(str, words)], cwd=ROOT, capture_output=True, text=True)
    return [line for line in (result.stdout + result.stderr).splitlines() if line] if result.returncode else []


def pyflakes(files):
    """Names and imports that are not used, or not defined."""
    return said_by("pyflakes", *files)


def pydocstyle(files):
    """Docstrings that are missing or not of the one kind."""
    return said_by("pydocstyle", f"--config={ROOT}/pyproject.toml", *files)


def mypy(files=()):
    """Type hints that are missing or wrong, in the package unless other files are named."""
    return said_by("mypy", f"--config-file={ROOT}/pyproject.toml", "--cache-dir=/dev/null", "--no-error-summary", *files)


# What decides on these rules is the checker of Debian 12: others break some lines elsewhere, know other types of numpy, or
# complain of more.
DECIDES = {"clang-tidy": (["clang-tidy"], "14"), "formatting": (["clang-format"], "14"),
           "python_types": ([PYTHON, "-m", "mypy"], "1.0")}


def other_version(rule):
    """In a sentence, which version of its checker is there if it is not the one that decides; else nothing."""
    command, decides = DECIDES.get(rule, ([], ""))
    if not command:
        return ""
    said = subprocess.run([*command, "--version"], capture_output=True, text=True).stdout
    there = re.search(r"\d+(\.\d+)*", said)
    found = there[0] if there else "none"
    return "" if f"{found}.".startswith(f"{decides}.") else f"{' '.join(command)} {decides} decides on this, and {found} is there"


def python_names(tree):
    return pyflakes([path for path in tree if path.endswith(".py")])


def python_docstrings(tree):
    return pydocstyle([path for path in tree if path.startswith("python/chaindrive/") and path.endswith(".py")])


def python_types(_):
    return mypy()


CHECKS = {**rules.RULES, **{check.__name__: check for check in (formatting, python_names, python_docstrings, python_types)}}


def main():
    if len(sys.argv) != 2 or sys.argv[1] not in CHECKS:
        sys.exit(f"usage: style.py {' | '.join(CHECKS)}")
    if other := other_version(sys.argv[1]):
        print(f"{sys.argv[1]}: not checked: {other}")
        sys.exit(77)
    tree = repository()
    violations = CHECKS[sys.argv[1]](tree)
    print(*violations, sep="\n")
    print(f"{sys.argv[1]}: {len(tree)} files, {len(violations)} violations")
    sys.exit(bool(violations))


if __name__ == "__main__":
    main()
