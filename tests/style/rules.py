# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rules of style that a script can check.

Each rule takes the tree as a dictionary {path: text} and returns its violations, one line each.
test_rules.py shows for every rule a tree that it accepts and one that it does not.
"""

import json
import posixpath
import re

LICENCE = "SPDX-License-Identifier: LGPL-2.1-or-later"
MAX_LINES = 600
MAX_BYTES = 1_000_000
MAX_COLUMNS = 100

# Documents that a program writes.
GENERATED = {"doc/parameters.md", "doc/validation/verification.md"}

# Beyond the order of rooms: what a room may not reach, directly or through our own headers.
OUT_OF_BOUNDS = {
    "drive": (r"mpi\.h|deal\.II/base/mpi|deal\.II/dofs/", "pure geometry knows neither MPI nor DoFHandler"),
}

# The hosts that documentation may point to.
HOSTS = {
    "dealii.org", "debian.org", "doi.org", "github.com", "gmsh.info", "gnu.org", "hdfgroup.org",
    "keepachangelog.com", "paraview.org", "semver.org", "snakemake.github.io", "www.dealii.org", "www.debian.org",
    "www.gnu.org", "www.paraview.org", "www.w3.org",
}


def is_code(path):
    return path.endswith((".cc", ".h", ".py", ".cmake", ".sh", "CMakeLists.txt", "run", "check", "study", "site", "Snakefile"))


def is_cxx(path):
    return path.endswith((".cc", ".h"))


# ---- rooms


def rooms_to_the_left(tree):
    """{room: set of rooms it may include}, from the list in source/rooms.txt."""
    allowed, left = {}, set()
    for line in tree["source/rooms.txt"].splitlines():
        if not line.startswith("#"):
            allowed.update({room: left | {room} for room in line.split()})
            left = left | set(line.split())
    return allowed


def room_of(path):
    match = re.match(r"(?:include/chaindrive|source)/(\w+)/", path)
    return match and match[1]


def includes(text):
    return re.findall(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', text, re.MULTILINE)


def reach(tree, path):
    """The headers that a file includes, directly or through headers of this project."""
    found, pending = set(), [path]
    while pending:
        for _, header in includes(tree.get(pending.pop(), "")):
            if header not in found:
                found.add(header)
                pending.append("include/" + header)
    return found


def layering(tree):
    allowed = rooms_to_the_left(tree)
    violations = [f"rules.py: source/rooms.txt has no room '{room}'" for room in OUT_OF_BOUNDS if room not in allowed]
    for path in filter(is_cxx, tree):
        room = room_of(path)
        if room is None:
            continue
        if room not in allowed:
            violations.append(f"{path}: source/rooms.txt has no room '{room}'")
            continue
        for quote, header in includes(tree[path]):
            target = re.match(r"chaindrive/(\w+)/", header)
            if quote == '"':
                violations.append(f'{path}: write <chaindrive/room/...> instead of "{header}"')
            elif target and target[1] not in allowed[room]:
                violations.append(f"{path}: '{room}' may not include <{header}>")
        pattern, reason = OUT_OF_BOUNDS.get(room, (r"(?!)", ""))
        for header in sorted(reach(tree, path)):
            if re.match(pattern, header):
                violations.append(f"{path}: '{room}' reaches <{header}>, but {reason}")
    return violations


# ---- files


def licence(tree):
    """The licence in the first line, below the interpreter of a script."""
    violations = []
    for path, text in tree.items():
        lines = text.splitlines()
        if lines and lines[0].startswith("#!"):
            lines = lines[1:]
        script = text.startswith("#!") or path.startswith(".clang")
        if not (is_code(path) or script or path.endswith((".prm", ".prm.in", ".geo"))):
            continue
        mark = "//" if path.endswith((".cc", ".h", ".geo")) else "#"
        if not lines or lines[0] != f"{mark} {LICENCE}":
            violations.append(f"{path}: the first line is not '{mark} {LICENCE}'")
    return violations


def imports(tree):
    """Python finds modules by where it is started and by what is installed, not by what a file does to its paths."""
    ban = re.compile(r"\bsys\.pat[h]\b|\bfrom sys import\b.*\bpath\b|\bsite\.addsitedi[r]\b")
    return [
        f"{path}:{number}: a module's place is not found by the file that imports it: {line.strip()}"
        for path, text in tree.items()
        if path.endswith((".py", "Snakefile", ".md"))
        for number, line in enumerate(text.splitlines(), 1)
        if ban.search(line)
    ]


def halves(tree):
    """What a symmetry model computes is made whole by utilities/mirror_symmetry.h alone."""
    factor = r"\d+\.\d*"
    ban = re.compile(
        rf"\b\w*half\w*(?:\(\))?\s*\?\s*{factor}\s*:\s*{factor}"  # half ? 2. : 1.
        rf"|\bif\s*\([^;{{}}]*\bhalf\w*(?:\(\))?\s*\)[^;{{}}]*\*=\s*{factor}"  # if (half) x *= 2.
    )
    return [
        f"{path}: doubles or halves by itself, which MirrorSymmetry does: {' '.join(found.split())}"
        for path, text in tree.items()
        if is_cxx(path) and path.startswith(("source/", "include/")) and not path.endswith("/mirror_symmetry.h")
        for found in ban.findall(text)
    ]


def length(tree):
    violations = [
        f"{path}: {text.count(chr(10))} lines, more than {MAX_LINES}"
        for path, text in tree.items()
        if is_code(path) and text.count("\n") > MAX_LINES
    ]
    violations += [
        f"{path}: {len(text)} bytes, more than {MAX_BYTES}"
        for path, text in tree.items()
        if len(text) > MAX_BYTES
    ]
    return violations


def words(tree):
    """Nothing that belongs to one machine or one day."""
    bans = [
        (r"(?<![\w.$}])/(?:home|root|work|tmp|Users|mnt|media)/", "a path of one machine"),
        (r"\b(?:TO[D]O|FIX[M]E|XX[X])\b", "unfinished work"),
        (r"^[^$]*(?<!\w)@[A-Z]+@", "a placeholder"),
        (r"^(?:<<<<<<< |>>>>>>> )", "a conflict of merging"),
        (r"[ \t]+$", "blanks at the end of a line"),
    ]
    violations = []
    for path, text in tree.items():
        if path.endswith((".output", ".msh", ".prm.in")) or path == "LICENSE":
            continue
        for number, line in enumerate(text.splitlines(), 1):
            violations += [
                f"{path}:{number}: {what}: {line.strip()}" for ban, what in bans if re.search(ban, line)
            ]
            violations += [
                f"{path}:{number}: a host not in the list of rules.py: {host}"
                for host in re.findall(r"\w+://([\w.-]+)", line)
                if host not in HOSTS
            ]
    return violations


def links(tree):
    """Relative links of the documentation lead to files (or folders) that exist."""
    folders = {posixpath.dirname(path) for path in tree}
    folders |= {posixpath.dirname(folder) for folder in folders}
    violations = []
    for path, text in tree.items():
        if not path.endswith(".md"):
            continue
        for target in re.findall(r"\]\(([^)\s#]+)(?:#[^)]*)?\)", text):
            if "://" in target:
                continue
            file = posixpath.normpath(posixpath.join(posixpath.dirname(path), target))
            if file not in tree and file not in folders:
                violations.append(f"{path}: the link to {target} leads nowhere")
    return violations


def prose(tree):
    """Lines of the documents fit the page, but for tables, fenced code, headings and single links."""
    violations = []
    for path, text in tree.items():
        if not path.endswith(".md") or path in GENERATED:
            continue
        fenced = False
        for number, line in enumerate(text.splitlines(), 1):
            if line.lstrip().startswith("```"):
                fenced = not fenced
            exempt = fenced or line.lstrip().startswith(("|", "#")) or " " not in line.strip()
            if len(line) > MAX_COLUMNS and not exempt:
                violations.append(f"{path}:{number}: {len(line)} columns, more than {MAX_COLUMNS}")
    return violations


def results_documented(tree):
    """doc/output.md names every history and every member of the summary that runs write."""
    text = re.sub(r"```.*?```", "", tree.get("doc/output.md", ""), flags=re.DOTALL)
    named = set(re.findall(r"`([^`\n]+)`", text))
    violations = []
    schema = json.loads(tree["python/chaindrive/schema.json"])
    for kind in ("histories", "summary"):
        for path in schema[kind]:
            name = [part for part in path.split("/") if part != "*"][-1]
            if not named & {name, re.sub(r".*(_peak|_gap)$", r"...\1", name)}:
                violations.append(f"doc/output.md: the {kind} have {path}, which is not explained")
    return violations


def prm_listed(tree):
    """Every .prm for users is in a table that says what it answers."""
    tables = tree.get("README.md", "") + tree.get("prm/README.md", "")
    return [
        f"{path} is neither in README.md nor in prm/README.md"
        for path in tree
        if path.startswith("prm/") and path.endswith(".prm") and path.removeprefix("prm/") not in tables
    ]


def packages(tree):
    """The list of packages has the form that shell and CMake read, and what scripts and messages name is in it."""
    path = "packaging/packages.txt"
    rows = [line for line in tree.get(path, "").splitlines() if line and not line.startswith("#")]
    violations = [f"{path}: not USE NAME # WHY: {row}" for row in rows if not re.fullmatch(r"[a-z]+ +[a-z0-9][a-z0-9.+-]+( +# [^][;]+)?", row)]
    named = [tuple(row.split()[:2]) for row in rows]
    violations += [f"{path}: twice: {' '.join(pair)}" for pair in sorted(set(named)) if named.count(pair) > 1]
    known = {pair[-1] for pair in named}
    for file, text in tree.items():
        if file.startswith(("python/", "source/", "scripts/study/", "packaging/")) or file == "CMakeLists.txt":
            for name in sorted(set(re.findall(r"\b(?:python3-[a-z0-9]+(?:-[a-z0-9]+)*|lib[a-z0-9.+-]+-dev)\b", text)) - known):
                violations.append(f"{file}: {name} is not in {path}")
    return violations


# What the field calls otherwise: a word of old, and the field's.
FIELD_WORDS = [
    (r"\b\w*giv(?:e|es|ing)[ _]way\w*", "deflect, compliance"),
    (r"\b(?:by|of|to|on)_shapes\b|\bby (?:\w+ )?shapes\b|\battachment[ _]vectors?\b", "mode, attachment mode"),
    (r"\bdealt[ _]out\b|\bis_dealt_out\b|\bDeals?\b", "distributed, partition"),
    (r"\bmoment of momentum\b", "angular momentum"),
    (r"\b\w*[Ss]table[ _]steps?\w*", "critical time step"),
    (r"\b\w*senseless\w*|\boverlap_max\b|\b(?:the|an|largest|mean|its) overlap\b", "penetration, penetration limit"),
    (r"\bsound[ _](?:runs?|until)\w*", "valid, valid until"),
    (r"\beats? (?:up )?(?:the )?energy\b", "dissipates"),
    (r"\bWall::|\b(?:Wall(?:Stresses|Cell)|ThroughWall)\b", "element type, through the thickness"),
    (r"\b\w*[Cc]olumn[ _]?[Mm]ass(?:es)?\w*", "selective mass scaling"),
    (r"\bhalf[ _]models?\b|\bHalfModel\b", "symmetry model"),
    (r"\b(?:\w+_)?[Ff]ollowers?\b", "rigid surface nodes"),
    (r"\barriving links\b|\w*_links_arrive\b", "links in the region of interest"),
    (r"\bcomes?_apart\b|\blose_touch\b", "separate, lose contact"),
    (r"\b\w+_stations?\b|\baxial stations?\b", "axial ring"),
    (r"\bfore(?:tells?|told)\b", "predict, estimate"),
    (r"\bHeard\b|(?<!::)\blisten\w*\(", "radiated sound, received"),
    (r"\bmoves_by_nodes\b", "nodal"),
    (r"\bPictures\b|\b\w+_in_pictures\b", "field output"),
    (r"\b(?:hold|put|take|some|more|there)_(?=\W)", "a name that can be searched"),
]
EVERYDAY = r"\b(?:hold|put|take)\("  # functions; in Python numpy has some


def field_words(tree):
    """Code and its comments call things as the field does. Old names that are still read have files of their own."""
    violations = []
    for path, text in tree.items():
        if not path.startswith(("source/", "include/", "python/", "scripts/")) or not path.endswith((".cc", ".h", ".py")):
            continue
        if path.endswith("/old_names.cc"):
            continue
        joined = re.sub(r"[ \t]*\n[ \t]*(?://[/!]?<?|#)?[ \t]*", " ", text)
        for ban, field in FIELD_WORDS + ([(EVERYDAY, "a name that can be searched")] if is_cxx(path) else []):
            violations += [f"{path}: '{found.strip()}': {field}" for found in sorted({m[0] for m in re.finditer(ban, joined)})]
    return violations


RULES = {rule.__name__: rule for rule in (layering, licence, imports, halves, length, words, links, prose, results_documented,
                                          prm_listed, packages, field_words)}
