# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs clang-tidy on our sources and headers: tidy.py BUILD_FOLDER [--record]. Exit status 1 on complaints, 77
where another version of clang-tidy is installed than the one that decides.

A file that passed is not looked at again until its own text or the configuration changes. tests/style/
tidy.passed, which is committed, and the folder style/ of the build remember; --record writes to the
former what is true now. A header is a file of its own: when it changes it is looked at, but the
sources that include it are not. All are looked at anew where neither remembers anything.

First every file is compiled without the precompiled header, to see that it includes what it needs.
Then clang-tidy reads them, several as one because nearly all of its time goes into deal.II's headers;
where those of such a batch do not go together, in smaller ones.
"""

import argparse
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import style

CONFIGURATION = style.ROOT / ".clang-tidy"
RECORD = style.ROOT / "tests/style/tidy.passed"
LOOKED_AT = re.compile(r"(source|include)/.*\.(cc|h)")


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True)


def compiles(file, flags):
    """What the compiler says about a file; empty when it is valid."""
    result = run("c++", "-fsyntax-only", "-w", *flags, file)
    return result.stderr if result.returncode else ""


def lint(file, flags):
    """What clang-tidy says about a file; empty when it is content."""
    # A batch includes sources, and here that is meant.
    checks = "--checks=-bugprone-suspicious-include"
    result = run("clang-tidy", "--quiet", f"--config-file={CONFIGURATION}", checks, file, "--", *flags)
    return result.stdout.strip() or (result.stderr if result.returncode else "")


def compile_commands(build):
    """Those of the program's sources, or of the files that include several of them."""
    commands = json.loads((build / "compile_commands.json").read_text())
    folders = style.ROOT / "source", build.resolve() / "source"
    return [entry for entry in commands if any(Path(entry["file"]).is_relative_to(folder) for folder in folders)]


def language_flags(commands):
    """The standard, macros and folders of headers of all compile commands together."""
    flags = {}
    for entry in commands:
        words = iter(shlex.split(entry["command"]))
        for word in words:
            if word == "-isystem":
                flags["-isystem" + next(words)] = None
            elif word.startswith(("-std", "-D", "-I")) and not word.startswith("-Dmain="):
                flags[word] = None
    return list(flags)


def digest(configuration, path, text):
    """What a file's verdict is remembered by; the same on every machine."""
    return hashlib.sha256("\0".join([configuration, path, text]).encode()).hexdigest()[:16]


def recorded(file):
    """The digests of the files that passed, from lines 'digest path'."""
    return {line.split()[0] for line in file.read_text().splitlines()} if file.exists() else set()


def write_record(file, digests):
    file.write_text("".join(f"{digest} {path}\n" for path, digest in sorted(digests.items())))


class Linter:
    def __init__(self, build):
        self.memory = build / "style"
        self.memory.mkdir(exist_ok=True)
        self.flags = language_flags(compile_commands(build))
        configuration = CONFIGURATION.read_text()
        self.digests = {
            path: digest(configuration, path, text)
            for path, text in style.repository().items()
            if LOOKED_AT.fullmatch(path)
        }
        self.passed = recorded(RECORD) | recorded(self.memory / RECORD.name)

    def new(self):
        return [path for path, digest in self.digests.items() if digest not in self.passed]

    def together(self, paths):
        """[(files, what is wrong with them)]: all as one, or in parts where two share a name."""
        file = self.memory / f"{self.digests[paths[0]]}.cc"
        file.write_text("".join(f'#include "{style.ROOT / path}"\n' for path in paths))
        if len(paths) > 1 and compiles(file, self.flags):
            return self.together(paths[::2]) + self.together(paths[1::2])
        verdict = lint(file, self.flags)
        file.unlink()
        return [(paths, verdict)]

    def complaints(self):
        """What is wrong with the files that are new or changed; those that pass are remembered."""
        n_parallel, new = os.cpu_count(), self.new()
        with ThreadPoolExecutor(n_parallel) as pool:
            errors = list(pool.map(lambda path: compiles(style.ROOT / path, self.flags), new))
            valid = [path for path, error in zip(new, errors) if not error]

            # Neighbours in the list share a room and might share a name: they go to different batches.
            n_batches = min(2 * n_parallel, -(-len(valid) // 4))
            batches = pool.map(self.together, [valid[i::n_batches] for i in range(n_batches)])
            results = [result for parts in batches for result in parts]

        self.passed.update(self.digests[path] for paths, verdict in results if not verdict for path in paths)
        self.record(self.memory / RECORD.name)
        return [text for text in [*errors, *(verdict for _, verdict in results)] if text]

    def record(self, file):
        write_record(file, {path: digest for path, digest in self.digests.items() if digest in self.passed})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=Path)
    parser.add_argument("--record", action="store_true")
    arguments = parser.parse_args()
    if other := style.other_version("clang-tidy"):
        print(f"clang-tidy: nothing looked at: {other}")
        sys.exit(77)
    linter = Linter(arguments.build)
    if not linter.digests or not linter.flags:
        sys.exit("tidy.py: no sources, or none in compile_commands.json")
    n_new = len(linter.new())
    complaints = linter.complaints()
    if arguments.record:
        linter.record(RECORD)
    print(*complaints, sep="\n")
    verdict = "complaints above" if complaints else "no complaints"
    print(f"clang-tidy: {len(linter.digests)} files, {n_new} new or changed, {verdict}")
    sys.exit(bool(complaints))


if __name__ == "__main__":
    main()
