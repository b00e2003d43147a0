# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks one rule of style on the whole repository: style.py RULE. Exit status 1 on violations."""

import os
import subprocess
import sys
from pathlib import Path

import rules

ROOT = Path(__file__).resolve().parents[2]


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


def main():
    checks = {**rules.RULES, "formatting": formatting}
    if len(sys.argv) != 2 or sys.argv[1] not in checks:
        sys.exit(f"usage: style.py {' | '.join(checks)}")
    tree = repository()
    violations = checks[sys.argv[1]](tree)
    print(*violations, sep="\n")
    print(f"{sys.argv[1]}: {len(tree)} files, {len(violations)} violations")
    sys.exit(bool(violations))


if __name__ == "__main__":
    main()
