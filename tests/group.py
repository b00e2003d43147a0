#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""group.py GROUP.cc TEST.cc...: writes one program that is several tests, of which it runs the one whose name it bears.

Most of what a test takes to compile are templates of libraries, which tests in one source share. What
they include stands first, once; then each test in a namespace of its own.
"""

import pathlib
import re
import sys

HEAD = """// Several tests in one program.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
"""
TAIL = """
namespace
{
[[maybe_unused]] int call(int (*test)(), int, char **) { return test(); }
[[maybe_unused]] int call(int (*test)(int, char **), int argc, char **argv) { return test(argc, argv); }
} // namespace

int main(int argc, char **argv)
{
  const std::string name = std::filesystem::path(argv[0]).stem().string();
"""


def main(output, *sources):
    includes, tests, calls = {}, [], []
    for source in map(pathlib.Path, sources):
        lines = source.read_text().rstrip().split("\n")
        for number, line in enumerate(lines):
            if re.match(r"#\s*include\b", line):
                includes[line] = None
                lines[number] = ""
        if lines.pop() != "}":
            sys.exit(f"{source}: the last line of a test is the brace that ends main()")
        text = "\n".join(lines)
        tests.append(f'\nnamespace test_{source.stem}\n{{\n#line 1 "{source}"\n{text}\n  return EXIT_SUCCESS;\n}}\n}}\n')
        calls.append(f'  if (name == "{source.stem}")\n    return call(test_{source.stem}::main, argc, argv);\n')
    end = '  std::cerr << "no test " << name << std::endl;\n  return EXIT_FAILURE;\n}\n'
    pathlib.Path(output).write_text(HEAD + "\n".join(includes) + "\n" + "".join(tests) + TAIL + "".join(calls) + end)


main(*sys.argv[1:])
