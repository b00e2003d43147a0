# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/mutate.py on a program of three functions whose test looks at one of them, then at two."""
import importlib.util
import pathlib
import re
import subprocess
import sys

from program import REPOSITORY, check

# one sign, one comparison and one constant; what else looks like them is none
SOURCE = """// 1 + 2 < 3
#include <stdexcept>
#include <string>
#include <vector>
/* 4. - 5. */
const double everywhere = 6. - 7.;
double difference(double a, double b)
{
  if (!b)
    throw std::runtime_error("8 - 9" + std::to_string(10. + a));
  return a - b;
}
bool above(double a, double b)
{
  const std::vector<std::vector<double>> table = {{1., 2., 3., 4., 5., 6., 7., 8.}};
  return b < a && !table.empty();
}
double twice(double a)
{
  const auto function = [&](double b) { return 2.5 * b; };
  return function(a);
}
"""
CHECK = """double difference(double, double);
double twice(double);
int main()
{
  const double a = difference(3., 1.), b = twice(2.);
  return a == 2. && (b == 5. || !%s) ? 0 : 1;
}
"""
CMAKE = """cmake_minimum_required(VERSION 3.18)
project(small CXX)
enable_testing()
add_executable(small_test source/functions.cc test.cc)
add_test(NAME small COMMAND small_test)
"""


def mutate(*options):
    script, folders = REPOSITORY / "scripts/mutate.py", ["--root", "small", "--folder", "copy"]
    words = [sys.executable, str(script), *folders, "--number", "3", "--targets", "all", *options]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(done.stdout)
    return done.returncode, done.stdout


def main():
    if importlib.util.find_spec("clang") is None:
        print("python3-clang is not installed")
        sys.exit(77)
    subprocess.run(["rm", "-rf", "small", "copy"], check=True)
    small = pathlib.Path("small")
    (small / "source").mkdir(parents=True)
    (small / "source/functions.cc").write_text(SOURCE)
    (small / "CMakeLists.txt").write_text(CMAKE)
    (small / "test.cc").write_text(CHECK % "0")
    status, said = mutate()
    check(status == 0, "failed")
    rows = dict(re.findall(r"^\| \d+ \| source/functions.cc:\d+ \| (.*) \| (.*) \|$", said, re.M))
    expected = {"- to +": "small", "< to >=": "nothing, and no test reaches it", "2.5 to 1.25": "nothing"}
    check(rows == expected, f"{rows} instead of {expected}")
    check("quick tests notice 1 of 3," in said, "another share")
    # a test that looks at the constant too
    (small / "test.cc").write_text(CHECK % "1")
    status, said = mutate("--again", "small")
    check(status == 0 and "quick tests notice 2 of 3," in said, "the better test notices no more")
    # others than what was asked for first
    status, said = mutate("--seed", "2")
    check(status == 1 and "has 3 places of seed 1" in said, "another seed is mixed with the first")
    (small / "source/functions.cc").write_text(SOURCE + "\n")
    status, said = mutate()
    check(status == 1 and "source/functions.cc changed since" in said, "a source that changed is not seen")


main()
