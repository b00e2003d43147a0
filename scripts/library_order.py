#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""library_order.py [PROGRAM]: the order of shared libraries in which the loader finds symbols soonest.

The loader looks for a symbol in one library after the other, in the order in which the program names them (ld.so(8)). Counts in
which library it finds the symbols of a program (build/source/chaindrive) when it starts (LD_DEBUG=bindings) and prints the names of
those in which it finds most, the first first: source/library_order.txt. Libraries that have a symbol, not a weak one, of the same
name as one of another library are left out: in front they might take the other's place.
"""
import collections
import os
import re
import subprocess
import sys

LEAST = 1500  # symbols found that make a library worth its line
EVERYWHERE = {"_edata", "_end", "__bss_start"}  # the linker's, which nobody looks up


def bindings(program):
    """How many symbols of the starting program the loader finds in each library."""
    environment = os.environ | {"LD_DEBUG": "bindings"}
    run = subprocess.run([program, "--version"], env=environment, capture_output=True, text=True, errors="replace", check=True)
    found = re.findall(r"binding file \S+ \[0\] to (\S+) \[0\]", run.stderr)
    return collections.Counter(found)


def strong(library):
    """The names of all symbols that a library has and that are not weak, of a version its own or of none."""
    lines = subprocess.run(["nm", "-D", "--defined-only", library], capture_output=True, text=True, check=True).stdout.split("\n")
    return {words[2] for words in map(str.split, lines) if len(words) == 3 and words[1] not in "WwVvuA"} - EVERYWHERE


def name_of(library):
    """libgmsh.so.4.8: gmsh"""
    return re.sub(r"^lib|\.so[.0-9]*$", "", os.path.basename(library))


def main(arguments):
    program = arguments[0] if arguments else "build/source/chaindrive"
    found = bindings(program)
    libraries = [path for path in found if ".so" in path and os.path.exists(path) and not re.search("/openmpi/|/hwloc/", path)]
    owners = collections.Counter(symbol for path in libraries for symbol in strong(path))
    for path in sorted(libraries, key=lambda path: -found[path]):
        if found[path] >= LEAST and all(owners[symbol] == 1 for symbol in strong(path)):
            print(name_of(path))


if __name__ == "__main__":
    main(sys.argv[1:])
