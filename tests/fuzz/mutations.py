# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways to spoil a parameter file or a Gmsh mesh, each a function of the text and a random.Random."""

import re

import meshes

NUMBERS = [
    "0", "-0", "-1", "1", "2", "7", "1e-300", "1e-12", "1e-6", "0.001", "0.499999", "0.5", "3.5", "9", "10", "50", "99.9",
    "1000", "12345.678", "1e6", "1e9", "1e13", "1e300", "1e400", "-1e400", "4294967296", "99999999999999999999",
]
NONSENSE = [
    "", "auto", "nan", "inf", "-inf", "1,5", "1.5 mm", "0x10", "1e", "--1", "1/2", "true", "false", "on", "off", "all", "none",
    "simple", "layered", "full", "settled", "concentric", "given", "slack", "sag", "pretension", "paper literal", "nominal", "ansi",
    "iso max", "bottom diameter", "pitch", "region of interest", "one point", "lower", "every step", "0,1,2", "5,,6", "-3,4", "08B", "428",
    "12A", "nowhere.msh", "..", "/", "{1|2}", "$x", "\\", "#", "ä", "面", "\u202e", "\ufeff", "\x00", "\x07", "a" * 5000,
]


def entries(documentation):
    """[(section, entry, what is allowed)] of doc/parameters.md, but for studies, which are not run here."""
    found, section = [], ""
    for line in documentation.splitlines():
        if line.startswith("## "):
            section = line[3:]
        elif section == "Study":
            continue
        elif match := re.match(r"\| `([^`]+)` \| [^|]* \| ([^|]*) \|", line):
            found.append((section, match[1], match[2]))
    return found


def accepted(allowed, random):
    """A value that the entry takes: one of its words, or a number of its range."""
    limits = [float(number) for number in re.findall(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e\d+)?(?!\w)", allowed)]
    if "number" not in allowed or len(limits) < 2:
        return random.choice(re.split(r", | or ", allowed))
    low, high = limits[0], limits[1]
    if "auto" in allowed and random.random() < 0.1:
        return "auto"
    value = random.choice([low, high, random.uniform(low, high), high * 10 ** random.uniform(-9, 0)])
    return f"{value:.0f}" if "whole" in allowed else f"{value:g}"


def scaled(value, random):
    """A number that looks likely: not far from what was there, or in another unit."""
    return f"{float(value) * random.choice([-1, 0.01, 0.1, 0.5, 0.9, 0.99, 1.01, 1.1, 2, 10, 100, 1e-3, 1e3, 1e6, 25.4, 57.2958]):g}"


def any_value(random, before=""):
    if random.random() < 0.4 and re.fullmatch(r"-?\d+(\.\d+)?(e-?\d+)?", before.strip()):
        return scaled(before, random)
    return random.choice(NUMBERS if random.random() < 0.6 else NONSENSE)


def change_value(lines, random, _):
    places = [i for i, line in enumerate(lines) if re.match(r"\s*set .*=", line)]
    if places:
        i = random.choice(places)
        name, value = lines[i].split("=", 1)
        lines[i] = f"{name}= {any_value(random, value)}"


def add_entry(lines, random, known):
    section, name, allowed = random.choice(known)
    parts = section.split("/")
    value = accepted(allowed, random) if random.random() < 0.8 else any_value(random)
    lines += [f"subsection {part}" for part in parts] + [f"set {name} = {value}"] + ["end"] * len(parts)


def misspell(lines, random, _):
    i = random.randrange(len(lines))
    if lines[i]:
        at = random.randrange(len(lines[i]))
        lines[i] = lines[i][:at] + random.choice(["", "x", "=", " ", "#", "é"]) + lines[i][at + 1 :]


def drop_line(lines, random, _):
    del lines[random.randrange(len(lines))]


def repeat_line(lines, random, _):
    lines.insert(random.randrange(len(lines)), random.choice(lines))


def repeat_block(lines, random, _):
    first = random.randrange(len(lines))
    at = random.randrange(len(lines))
    lines[at:at] = lines[first : first + random.randint(1, 20)]


def insert_word(lines, random, _):
    words = ["end", "subsection Drive", "subsection", "set", "set x", "include nowhere.prm", "subsection \x00", "set = 3", "}{"]
    lines.insert(random.randrange(len(lines) + 1), random.choice(words))


def swap_lines(lines, random, _):
    i, k = random.randrange(len(lines)), random.randrange(len(lines))
    lines[i], lines[k] = lines[k], lines[i]


def drop_section(lines, random, _):
    """From a `subsection` or a `$` to the next `end` or `$`."""
    starts = [i for i, line in enumerate(lines) if re.match(r"\s*subsection|\$(?!End)", line)]
    if starts:
        first = random.choice(starts)
        ends = [i for i in range(first + 1, len(lines)) if re.match(r"\s*end\s*$|\$", lines[i])]
        del lines[first : (ends or [first])[0] + 1]


def junk(lines, random, _):
    """Bytes that are not text, or a run of them."""
    i = random.randrange(len(lines))
    at = random.randrange(len(lines[i]) + 1)
    n = random.choice([1, 1, 1, 3, 100])
    bytes_ = bytes(random.randrange(256) for _ in range(n)) if random.random() < 0.5 else bytes([random.randrange(128, 256)] * n)
    lines[i] = lines[i][:at] + bytes_.decode("utf-8", "surrogateescape") + lines[i][at:]


def truncate(lines, random, _):
    text = "\n".join(lines)
    lines[:] = text[: random.randrange(len(text) + 1)].split("\n")


ANY = [drop_line, repeat_line, repeat_block, swap_lines, drop_section, junk, truncate]
PRM = [change_value] * 10 + [add_entry] * 20 + [misspell, insert_word] + ANY


def change_token(lines, random, _):
    i = random.randrange(len(lines))
    tokens = lines[i].split(" ")
    at = random.randrange(len(tokens))
    tokens[at] = any_value(random, tokens[at])
    lines[i] = " ".join(tokens)


def change_section(lines, random, _):
    marks = [i for i, line in enumerate(lines) if line.startswith("$")]
    if marks:
        i = random.choice(marks)
        lines[i] = random.choice(["", "$Nodes", "$EndNodes", "$Elements", "$PhysicalNames", "$Nothing", "$"])


def change_head(lines, random, known):
    """Where the counts and names are."""
    marks = [i for i, line in enumerate(lines) if line.startswith("$")]
    i = min(len(lines) - 1, random.choice(marks or [0]) + random.randint(1, 3))
    piece = [lines[i]]
    change_token(piece, random, known)
    lines[i] = piece[0]


MSH = [change_token] * 4 + [change_head] * 4 + [change_section] + ANY + meshes.MUTATIONS * 2


def spoiled(text, mutations, random, known=()):
    """@p text after one to four mutations."""
    lines = text.split("\n")
    for _ in range(random.choice([1, 1, 1, 2, 2, 3, 4])):
        if not lines:
            lines = [""]
        random.choice(mutations)(lines, random, known)
    return "\n".join(lines)
