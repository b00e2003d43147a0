#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutation testing: how many small faults in the program its tests detect.

    mutate.py --folder FOLDER [--number 60] [--seed 1] [--longest SECONDS] [--again REGEX]

Draws places in function bodies of source/ at random, a third each of signs (+ and -), comparisons and
constants, and changes each: + to -, < to >=, 2 to 3. Error messages and tables of constants are skipped.
FOLDER gets a copy of the repository whose build contains all changes: the environment variable
CHAINDRIVE_MUTANT activates one by its number; without it the program is unchanged. For each change only
tests that reach its place are run, the shortest first, until one fails or takes ten times as long as
usual; each change starts with an empty cache.

Without --longest the tests of ./check --quick are run; with it, for undetected changes, also long tests
that take at most this number of seconds. Results are kept in FOLDER, and another call resumes from there:
after new tests have been written, --again REGEX runs those with matching names on all undetected
changes. A place that does not compile is replaced by another. Needs Debian's python3-clang, and as much
time as ./check on a clean clone plus about 40 minutes of one core.
"""

import argparse
import collections
import json
import os
import pathlib
import random
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time

import served

ROOT = pathlib.Path(__file__).resolve().parent.parent
KINDS = ("sign", "comparison", "constant")
PAIRS = (("+", "-"), ("+=", "-="), ("<", ">="), (">", "<="), ("==", "!="))
OPPOSITE = {**dict(PAIRS), **{second: first for first, second in PAIRS}}
MOST = 4096  # places
EXCLUDED = "^style/(?!documentation|plans)|^benchmarks/|^runs/mutate$"  # they do not run the program

# What a file with changes includes. The store tells which places a test reaches; of type bool, it leaves
# numbers alone, as the compiler sees.
SWITCH = """// The change that the environment asks for, and which places were reached.
#ifndef chaindrive_mutants
#define chaindrive_mutants
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <cstdlib>
namespace chaindrive_mutants
{
  inline int   chosen = -1;
  inline bool  nowhere[MOST];
  inline bool *reached = nowhere;
  namespace
  {
    [[gnu::noinline, gnu::cold, gnu::unused]] void ask()
    {
      const char *number = std::getenv("CHAINDRIVE_MUTANT"), *trace = std::getenv("CHAINDRIVE_MUTANT_TRACE");
      const int   file   = trace ? ::open(trace, O_RDWR | O_CREAT, 0666) : -1;
      if (file >= 0 && ::ftruncate(file, MOST) == 0)
        {
          void *const shared = ::mmap(nullptr, MOST, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
          if (shared != MAP_FAILED)
            reached = static_cast<bool *>(shared);
        }
      if (file >= 0)
        ::close(file);
      chosen = number ? std::atoi(number) : 0;
    }
    [[gnu::always_inline, gnu::unused]] inline bool on(const int number)
    {
      if (__builtin_expect(chosen < 0, 0))
        ask();
      reached[number] = true;
      return chosen == number;
    }
  } // namespace
} // namespace chaindrive_mutants
#endif
""".replace("MOST", str(MOST))


def fail(message):
    sys.exit(f"mutate.py: {message}")


# ---- places

TOKEN = re.compile(
    r"""(?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\.)*
        |R"(?P<mark>\w*)\(.*?\)(?P=mark)"|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+')
    |(?P<name>[A-Za-z_]\w*)
    |(?P<number>(?:\d[\d']*\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[A-Za-z]*)
    |(?P<operator><=>|<<=?|>>=|->\*?|\+\+|--|&&|\|\||[-+*/%&|^!=<>]=|[-+<>])""",
    re.VERBOSE | re.MULTILINE | re.DOTALL,
)


def other_constant(text):
    """A constant that differs: 2 becomes 3, 0.5 becomes 0.25 and 1e-6 becomes 1e-3; None for others."""
    if text.isdigit() or re.fullmatch(r"\d+[uU]", text):
        digits, suffix = re.fullmatch(r"(\d+)([uU]?)", text).groups()
        return f"{int(digits) + 1}{suffix}" if int(digits) > 0 else None
    if not re.fullmatch(r"(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", text):
        return None  # hexadecimal, or of another type
    value = float(text)
    if "e" in text.lower():
        return repr(value * 1e3)
    return repr(value + 1 if value == int(value) else value / 2)


OPERATOR_BEFORE = re.compile(r"(?:^|[^-+*/%<>=!])(?:[-+*/%<>]|[=!<>]=) $")
OPERATOR_AFTER = re.compile(r" (?:[-+*/%<>]|[=!<>]=) ")


def tokens(text):
    """[(kind, offset, text)] of what might be changed; blanks tell < from the bracket of a template."""
    found = []
    for match in TOKEN.finditer(text):
        token, around = match.group(), text[max(match.start() - 1, 0) : match.end() + 1].split(match.group())
        if match["operator"] in ("+", "-", "+=", "-="):
            sides = text[max(match.start() - 80, 0) : match.start()], text[match.end() : match.end() + 80]
            if sides[0].rstrip()[-1:] == '"' or sides[1].lstrip()[:1] == '"':
                continue  # of texts
            found.append(("sign", match.start(), token))
        elif match["operator"] in OPPOSITE and all(part.isspace() for part in around):
            found.append(("comparison", match.start(), token))
        elif match["number"] and other_constant(token):
            before = text[max(match.start() - 4, 0) : match.start()]
            after = text[match.end() : match.end() + 4]
            if "." in token or OPERATOR_BEFORE.search(before) or OPERATOR_AFTER.match(after):
                found.append(("constant", match.start(), token))
    return found


class Source:
    """A source and its syntax tree; offsets are those of its bytes, which libclang counts."""

    def __init__(self, path, flags, index):
        self.path, self.flags, self.index = path, flags, index
        self.text = path.read_bytes().decode("latin-1")
        self.chosen = []  # (begin, end, text) of places in use
        self.tree = self.parse(self.text)
        self.top = [cursor for cursor in self.tree.cursor.get_children() if self.own(cursor)]

    def parse(self, text):
        from clang.cindex import TranslationUnitLoadError

        try:
            return self.index.parse(str(self.path), self.flags, [(str(self.path), text.encode("latin-1"))])
        except TranslationUnitLoadError:
            fail(f"libclang cannot read {self.path}")

    def own(self, cursor):
        return cursor.location.file and cursor.location.file.name == str(self.path)

    def paths(self, offset, cursors, path=()):
        """Cursors around an offset, from the outermost: variables of one declaration overlap."""
        for cursor in cursors:
            if cursor.extent.start.offset <= offset < cursor.extent.end.offset:
                yield from self.paths(offset, cursor.get_children(), (*path, cursor))
                yield (*path, cursor)

    def spans(self, cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def place(self, kind, offset, token):
        """(begin, end, text) of the change, or None where this token is not what it seems."""
        for path in self.paths(offset, self.top):
            kinds = [cursor.kind.name for cursor in path]
            if "COMPOUND_STMT" not in kinds or "CXX_THROW_EXPR" in kinds or self.in_table(path):
                continue
            begin, end = self.spans(path[-1])
            if kind == "constant":
                place = self.constant(kinds, begin, end, offset, token)
            else:
                place = self.operation(path[-1], kinds[-1], begin, end, offset, token)
            if place:
                return place
        return None

    def in_table(self, path):
        """Whether a list of more than six numbers surrounds it."""
        for cursor in path:
            if cursor.kind.name == "INIT_LIST_EXPR":
                found = TOKEN.finditer(self.text, *self.spans(cursor))
                if sum(bool(match["number"]) for match in found) > 6:
                    return True
        return False

    def constant(self, kinds, begin, end, offset, token):
        if kinds[-1] not in ("FLOATING_LITERAL", "INTEGER_LITERAL") or begin != offset:
            return None
        around = [kind for kind in kinds[:-1] if kind not in ("UNEXPOSED_EXPR", "PAREN_EXPR")][-1]
        if kinds[-1] == "INTEGER_LITERAL" and around != "BINARY_OPERATOR":
            return None
        changed = f"(chaindrive_mutants::on(@) ? {other_constant(token)} : {token})"
        return offset, offset + len(token), changed

    def operation(self, cursor, kind, begin, end, offset, token):
        if kind not in ("BINARY_OPERATOR", "COMPOUND_ASSIGNMENT_OPERATOR", "UNARY_OPERATOR", "CALL_EXPR"):
            return None
        after, text = offset + len(token), self.text
        if token == "-" and begin == offset:
            if kind == "CALL_EXPR" and cursor.spelling != "operator-":
                return None
            changed = text[after:end]
        else:
            parts = [self.spans(child) for child in cursor.get_children()]
            parts = sorted(part for part in parts if part != (offset, after))
            if len(parts) != 2 or text[parts[0][1] : parts[1][0]].strip() != token:
                return None
            changed = text[begin:offset] + OPPOSITE[token] + text[after:end]
        return begin, end, f"(chaindrive_mutants::on(@) ? {changed} : {text[begin:end]})"

    def compiles(self, place):
        tree = self.parse(changed_text(self.text, [(1, place)], ""))
        return not any(message.severity >= message.Error for message in tree.diagnostics)


def changed_text(text, numbered, head):
    """The text with the changes [(number, (begin, end, text))] in it."""
    for number, (begin, end, replacement) in sorted(numbered, key=lambda item: -item[1][0]):
        text = text[:begin] + replacement.replace("@", str(number), 1) + text[end:]
    return head + text


def draw(folder, files, number, seed):
    """The places, in turn a sign, a comparison and a constant, each as likely as any other of its kind."""
    try:
        from clang.cindex import Index
    except ImportError:
        fail("needs the Python package of libclang: Debian's python3-clang")
    entries = json.loads((folder / "build/compile_commands.json").read_text())
    rng, index, sources, places = random.Random(seed), Index.create(), {}, []
    flags = precompiled(folder, files, language_flags(entries) + ["-w"], index)
    pools = collections.defaultdict(list)
    for name in files:
        for kind, offset, token in tokens((folder / name).read_bytes().decode("latin-1")):
            pools[kind].append((name, offset, token))
    for kind in KINDS:
        rng.shuffle(pools[kind])
    while len(places) < number:
        kind = KINDS[len(places) % len(KINDS)]
        if not pools[kind]:
            fail(f"only {len(places)} places can be changed")
        name, offset, token = pools[kind].pop()
        if name not in sources:
            sources[name] = Source(folder / name, flags, index)
        source = sources[name]
        place = source.place(kind, offset, token)
        if not place or any(place[0] < end and begin < place[1] for begin, end, _ in source.chosen):
            continue
        if not source.compiles(place):
            continue
        source.chosen.append(place)
        line = source.text.count("\n", 0, offset) + 1
        change = f"{token} to {OPPOSITE.get(token) or other_constant(token)}"
        if token == "-" and place[0] == offset:
            change = "- left out"
        shown = " ".join(source.text.splitlines()[line - 1].split())
        places.append({"file": name, "line": line, "change": change, "place": place})
        print(f"{len(places)}: {name}:{line}: {change}: {shown}", flush=True)
    return places


def precompiled(folder, files, flags, index):
    """Flags with which libclang reads the headers of libraries only once, and knows the switch."""
    pattern = re.compile(r"^#include <(?:deal\.II/[^>]+|[a-z_]+)>", re.MULTILINE)  # those that stand alone
    headers = set()
    for name in files:
        headers.update(pattern.findall((folder / name).read_text(errors="replace")))
    header, saved = folder / "places.h", folder / "places.pch"
    header.write_text("\n".join(sorted(headers)) + "\nnamespace chaindrive_mutants { bool on(int); }\n")
    tree = index.parse(str(header), [*flags, "-x", "c++-header"])
    errors = [str(message) for message in tree.diagnostics if message.severity >= message.Error]
    if errors:
        fail(f"libclang cannot read the headers: {errors[0]}")
    tree.save(str(saved))
    return [*flags, "-include-pch", str(saved)]


def language_flags(entries):
    """The standard, macros and folders of headers of all compile commands together."""
    flags = {}
    for entry in entries:
        words = iter(shlex.split(entry["command"]))
        for word in words:
            if word == "-isystem":
                flags["-isystem" + next(words)] = None
            elif word.startswith(("-std", "-D", "-I")) and not word.startswith("-DSOURCE_DIR"):
                flags[word] = None
    return list(flags)


# ---- the copy


def listed(root):
    """What the repository consists of, as git sees it, or all of a folder without git."""
    if (root / ".git").exists():
        command = ["git", "-C", root, "-c", "safe.directory=*", "ls-files", "-z", "--cached", "--others"]
        names = call(*command, "--exclude-standard").split("\0")
        return [name for name in names if name and (root / name).is_file()]
    return [path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file()]


def write(path, content):
    """Leaves a file that has this content already as it is, so that nothing is compiled again."""
    if not path.exists() or path.read_bytes() != content:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def copy(root, folder, names, places):
    """The repository with the changes in it."""
    changes = collections.defaultdict(list)
    for number, place in enumerate(places, 1):
        changes[place["file"]].append((number, place["place"]))
    write(folder / "mutants.h", SWITCH.encode())
    for name in names:
        content = (root / name).read_bytes()
        if name in changes:
            head = f'#include "{folder}/mutants.h"\n'
            content = changed_text(content.decode("latin-1"), changes[name], head).encode("latin-1")
        write(folder / name, content)
        shutil.copymode(root / name, folder / name)


def call(*command):
    words = [str(word) for word in command]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        fail(f"{' '.join(words)} failed:\n{done.stdout[-4000:]}")
    return done.stdout


# ---- tests


class Tests:
    def __init__(self, folder, excluded):
        self.build, self.trace = folder / "build", folder / "trace"
        shown = json.loads(call("ctest", "--test-dir", self.build, "--show-only=json-v1"))
        self.all, self.long = {}, set()
        for test in shown["tests"]:
            properties = {entry["name"]: entry["value"] for entry in test.get("properties", [])}
            if not re.search(excluded, test["name"]) and test.get("command"):
                self.all[test["name"]] = (test["command"], properties)
                if "long" in properties.get("LABELS", []):
                    self.long.add(test["name"])

    def forget(self, name):
        """deal.II's harness runs a test again only where its output is missing."""
        command, properties = self.all[name]
        if any(word.startswith("-DTRGT=") for word in command):
            for file in ("output", "diff"):
                pathlib.Path(properties["WORKING_DIRECTORY"], file).unlink(missing_ok=True)

    def empty_cache(self):
        shutil.rmtree(self.build / "cache", ignore_errors=True)

    def run(self, name, mutant=0, limit=3600.0, trace=False):
        """(whether it passed, seconds)."""
        self.forget(name)
        environment = {**os.environ, "CHAINDRIVE_MUTANT": str(mutant)}
        environment["CHAINDRIVE_CACHE"] = str(self.build / "cache")
        if trace:
            self.trace.unlink(missing_ok=True)
            environment["CHAINDRIVE_MUTANT_TRACE"] = str(self.trace)
        words = ["ctest", "--test-dir", str(self.build), "--no-tests=error", "-R", f"^{re.escape(name)}$"]
        begin = time.monotonic()
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        process = subprocess.Popen(words, env=environment, start_new_session=True, **quiet)
        try:
            passed = process.wait(limit) == 0
        except subprocess.TimeoutExpired:
            passed = False
            end_session(process.pid)
            process.wait()
        return passed, time.monotonic() - begin

    def reached(self):
        bytes_of = self.trace.read_bytes() if self.trace.exists() else b""
        return [number for number, byte in enumerate(bytes_of) if byte]


def end_session(session):
    """Ends all that a test has started, whatever process groups it has made."""
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                if os.getsid(int(entry.name)) == session:
                    os.kill(int(entry.name), signal.SIGKILL)
            except (ProcessLookupError, PermissionError):
                pass


class Record:
    """What is known, in a file."""

    def __init__(self, path, empty):
        self.path = path
        self.data = json.loads(path.read_text()) if path.exists() else empty

    def save(self):
        new = self.path.with_suffix(".new")
        new.write_text(json.dumps(self.data, indent=1))
        new.replace(self.path)


def without_changes(tests, names, record, limit=3600.0):
    """How long each test takes, whether it passes in time and what it reaches, with an empty cache."""
    for name in names:
        known = record.data.get(name)
        if known is None or (known["stopped"] and known["seconds"] < limit):
            tests.empty_cache()
            passed, seconds = tests.run(name, limit=limit, trace=True)
            stopped = not passed and seconds >= limit
            found = {"passed": passed, "seconds": seconds, "stopped": stopped}
            record.data[name] = {**found, "reached": tests.reached()}
            record.save()
            if not passed:
                why = "takes too long" if stopped else "fails"
                print(f"{name} {why} without any change: left out", flush=True)


def try_changes(tests, names, normal, results, number):
    """Runs, for each change that nothing has noticed, the tests that reach it and were not tried yet."""
    passing = [name for name in names if normal[name]["passed"]]
    ordered = sorted(passing, key=lambda name: normal[name]["seconds"])
    for mutant in range(1, number + 1):
        result = results.data.setdefault(str(mutant), {"noticed": None, "tried": []})
        reaching = [name for name in ordered if mutant in normal[name]["reached"]]
        pending = [name for name in reaching if name not in result["tried"]]
        if result["noticed"] or not pending:
            continue
        tests.empty_cache()
        for name in pending:
            passed, _ = tests.run(name, mutant, limit=10 * normal[name]["seconds"] + 5)
            result["tried"].append(name)
            if not passed:
                result["noticed"] = name
                break
        results.save()
        noticed = result["noticed"]
        print(f"{mutant}: {f'noticed by {noticed}' if noticed else 'not noticed'}", flush=True)


def report(places, tests, normal, results):
    quick = whole = 0
    print("\n| | place | change | noticed by |\n|---|---|---|---|")
    for mutant, place in enumerate(places, 1):
        result = results.data.get(str(mutant), {"noticed": None})
        noticed = result["noticed"]
        quick += noticed is not None and noticed not in tests.long
        whole += noticed is not None
        reached = any(mutant in entry["reached"] for entry in normal.data.values())
        said = noticed or ("nothing" if reached else "nothing, and no test reaches it")
        print(f"| {mutant} | {place['file']}:{place['line']} | {place['change']} | {said} |")
    number = len(places)
    print(f"\nquick tests notice {quick} of {number}, all that were run {whole} of {number}")


def main():
    os.environ.update(served.ENVIRONMENT)
    title, text = __doc__.split("\n\n", 1)
    plain = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=title, epilog=text, formatter_class=plain)
    parser.add_argument("--folder", type=pathlib.Path, required=True, help="folder of the copy and its build")
    parser.add_argument("--number", type=int, default=60, help="number of places (60)")
    parser.add_argument("--seed", type=int, default=1, help="seed of the random places (1)")
    parser.add_argument("--longest", type=float, metavar="SECONDS", help="also run long tests of up to this time")
    parser.add_argument("--again", metavar="REGEX", help="run tests with matching names again")
    parser.add_argument("--only-draw", action="store_true", help="print the places and exit")
    parser.add_argument("--exclude", default=EXCLUDED, metavar="REGEX", help="tests to skip")
    parser.add_argument("--targets", default="all build_tests", help="build targets")
    parser.add_argument("--jobs", type=int, default=1, help="number of compilers at a time (1)")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the repository (this one)")
    options = parser.parse_args()
    if not 1 <= options.number < MOST:
        fail(f"--number = {options.number}: 1 to {MOST - 1} places")
    folder, root = options.folder.resolve(), options.root.resolve()
    if not (root / "source").is_dir():
        fail(f"--root = {root} has no folder source/")
    if folder == root or folder in root.parents:
        fail(f"--folder = {folder} would change the repository itself: choose another folder")

    names = [name for name in listed(root) if folder not in (root / name).parents]
    sources = sorted(name for name in names if name.startswith("source/") and name.endswith(".cc"))
    chosen = Record(folder / "places.json", {})
    asked = {"number": options.number, "seed": options.seed}
    old = {name: (root / name).read_bytes().decode("latin-1") for name in sources}
    if chosen.data:
        if chosen.data["asked"] != asked:
            there = chosen.data["asked"]
            fail(f"{folder} has {there['number']} places of seed {there['seed']}: choose another folder")
        changed = sorted({name for name, text in chosen.data["texts"].items() if old.get(name) != text})
        if changed:
            fail(f"{', '.join(changed)} changed since the places were drawn: choose another folder")
    else:
        copy(root, folder, names, [])
        if not (folder / "build/compile_commands.json").exists():
            configure(folder)
        places = draw(folder, sources, options.number, options.seed)
        texts = {place["file"]: old[place["file"]] for place in places}
        chosen.data = {"asked": asked, "places": places, "texts": texts}
        chosen.save()
    places = chosen.data["places"]
    if options.only_draw:
        return
    copy(root, folder, names, places)
    configure(folder)
    call("nice", "-n", "19", "ninja", "-C", folder / "build", "-j", options.jobs, *options.targets.split())

    tests = Tests(folder, options.exclude)
    normal, results = Record(folder / "normal.json", {}), Record(folder / "results.json", {})
    if options.again:
        for name in [name for name in normal.data if re.search(options.again, name)]:
            del normal.data[name]
            for result in results.data.values():
                result["tried"] = [tried for tried in result["tried"] if tried != name]
    quick = [name for name in tests.all if name not in tests.long]
    without_changes(tests, quick, normal)
    try_changes(tests, quick, normal.data, results, len(places))
    if options.longest:
        without_changes(tests, sorted(tests.long), normal, options.longest)
        try_changes(tests, tests.long, normal.data, results, len(places))
    report(places, tests, normal, results)


def configure(folder):
    """CMake finds new tests."""
    compile_commands = "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"
    call("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build", compile_commands)


if __name__ == "__main__":
    main()
