# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs clang-tidy on our sources: tidy.py BUILD_FOLDER. Exit status 1 on complaints.

First every source is compiled without the precompiled header, to see that it includes what it
needs. Then clang-tidy reads them, several as one because nearly all of its time goes into deal.II's
headers; where the sources of such a batch do not go together, in smaller ones.

A file that passed is not looked at again until it, a header of ours that it includes, the flags or
the configuration change; the folder style/ of the build remembers.
"""

import hashlib
import json
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import rules
import style

CONFIGURATION = style.ROOT / ".clang-tidy"


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
    return json.loads((build / "compile_commands.json").read_text())


def language_flags(commands):
    """The standard, macros and folders of headers of all compile commands together."""
    flags = {}
    for entry in commands:
        words = iter(shlex.split(entry["command"]))
        for word in words:
            if word == "-isystem":
                flags["-isystem" + next(words)] = None
            elif word.startswith(("-std", "-D", "-I")):
                flags[word] = None
    return list(flags)


class Linter:
    def __init__(self, build):
        commands = compile_commands(build)
        self.memory = build / "style"
        self.memory.mkdir(exist_ok=True)
        self.tree = style.repository()
        paths = {os.path.relpath(entry["file"], style.ROOT): entry for entry in commands}
        paths = {path: entry for path, entry in paths.items() if path in self.tree and path.startswith("source/")}
        self.sources = sorted(paths)
        self.flags = language_flags(paths.values())
        self.version = run("clang-tidy", "--version").stdout

    def stamp(self, path):
        """A file whose name changes with everything that the verdict on a source depends on."""
        digest = hashlib.sha256(CONFIGURATION.read_bytes())
        digest.update(self.version.encode() + " ".join(self.flags).encode() + path.encode())
        for file in [path, *sorted("include/" + header for header in rules.reach(self.tree, path))]:
            digest.update(self.tree.get(file, "").encode())
        return self.memory / digest.hexdigest()

    def together(self, paths):
        """[(sources, what is wrong with them)]: all as one, or in parts where two share a name."""
        file = self.memory / f"{self.stamp(paths[0]).name}.cc"
        file.write_text("".join(f'#include "{style.ROOT / path}"\n' for path in paths))
        if len(paths) > 1 and compiles(file, self.flags):
            return self.together(paths[::2]) + self.together(paths[1::2])
        verdict = lint(file, self.flags)
        file.unlink()
        return [(paths, verdict)]

    def complaints(self):
        """What is wrong with the sources that are new or changed, with their number."""
        n_parallel = os.cpu_count()
        new = [path for path in self.sources if not self.stamp(path).exists()]
        with ThreadPoolExecutor(n_parallel) as pool:
            errors = list(pool.map(lambda path: compiles(style.ROOT / path, self.flags), new))
            valid = [path for path, error in zip(new, errors) if not error]

            # Neighbours in the list share a room and might share a name: they go to different batches.
            n_batches = min(2 * n_parallel, -(-len(valid) // 4))
            batches = pool.map(self.together, [valid[i::n_batches] for i in range(n_batches)])
            results = [result for parts in batches for result in parts]

        for paths, verdict in results:
            for path in paths:
                if not verdict:
                    self.stamp(path).touch()
        verdicts = [verdict for _, verdict in results]
        return [text for text in [*errors, *verdicts] if text], len(new)


def main():
    linter = Linter(Path(sys.argv[1]))
    if not linter.sources:
        sys.exit("tidy.py: no sources in compile_commands.json")
    complaints, n_new = linter.complaints()
    print(*complaints, sep="\n")
    verdict = "complaints above" if complaints else "no complaints"
    print(f"clang-tidy: {len(linter.sources)} files, {n_new} new or changed, {verdict}")
    sys.exit(bool(complaints))


if __name__ == "__main__":
    main()
