# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways to spoil a Gmsh mesh so that it still looks like one: counts stay right, cells do not."""

TYPES = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 36, 92, 93, 140, -1, 2**31]
IDS = [0, -1, 1, 2**31 - 1, 2**31, 2**32 - 1, 2**32, 2**32 + 1, 10**9, 10**20]


def section(lines, name):
    """Indices of the first entry of a section and of the line after its last, behind the line with their number."""
    if "$" + name in lines and "$End" + name in lines:
        first, last = lines.index("$" + name) + 2, lines.index("$End" + name)
        if first < last:
            return first, last
    return None


def entry(lines, name, random):
    """Index of a random entry and its words."""
    where = section(lines, name)
    if where is None:
        return None, None
    i = random.randrange(*where)
    return i, lines[i].split()


def recount(lines, name):
    if where := section(lines, name):
        lines[where[0] - 1] = str(where[1] - where[0])


def remove_entries(lines, random, _):
    name = random.choice(["Nodes", "Elements"])
    i, words = entry(lines, name, random)
    if words:
        del lines[i : min(section(lines, name)[1], i + random.choice([1, 1, 2, 10, 1000]))]
        recount(lines, name)


def repeat_entry(lines, random, _):
    name = random.choice(["Nodes", "Elements", "Elements"])
    i, words = entry(lines, name, random)
    if words:
        if random.random() < 0.5:  # under a number of its own
            words[0] = str(section(lines, name)[1])
        lines.insert(random.randrange(*section(lines, name)), " ".join(words))
        recount(lines, name)


def turn_element(lines, random, _):
    """Its nodes in another order."""
    i, words = entry(lines, "Elements", random)
    if words and len(words) > 7:
        nodes = words[5:]
        random.choice([nodes.reverse, lambda: random.shuffle(nodes), lambda: nodes.insert(0, nodes.pop())])()
        lines[i] = " ".join(words[:5] + nodes)


def other_node(lines, random, _):
    i, words = entry(lines, "Elements", random)
    if words and len(words) > 5:
        number = random.choice(IDS) if random.random() < 0.4 else random.randint(1, 3200)
        words[random.randrange(5, len(words))] = str(number)
        lines[i] = " ".join(words)


def other_number(lines, random, _):
    """A number of a node or an element that is huge, negative or taken."""
    i, words = entry(lines, random.choice(["Nodes", "Elements"]), random)
    if words:
        words[0] = str(random.choice(IDS + [2, 17, 3000]))
        lines[i] = " ".join(words)


def other_type(lines, random, _):
    """One element, or all of a type, of a type that it is not; also other numbers of tags."""
    i, words = entry(lines, "Elements", random)
    if words and len(words) > 2:
        new = str(random.choice(TYPES))
        if random.random() < 0.3:
            words[2] = str(random.choice([-1, 0, 1, 3, 7, 8, 2**31, 10**9]))
            lines[i] = " ".join(words)
            return
        old, everywhere = words[1], random.random() < 0.3
        for k in range(*section(lines, "Elements")) if everywhere else [i]:
            words = lines[k].split()
            if len(words) > 2 and words[1] == old:
                words[1] = new
                lines[k] = " ".join(words)


def other_tag(lines, random, _):
    """Physical surfaces and volumes that are not there, or are others'."""
    i, words = entry(lines, "Elements", random)
    if words and len(words) > 4:
        words[3] = str(random.choice([0, 1, 2, 3, 4, 5, 6, 255, 256, 65535, *IDS]))
        lines[i] = " ".join(words)


def move_node(lines, random, _):
    i, words = entry(lines, "Nodes", random)
    if words and len(words) == 4:
        k = random.randrange(1, 4)
        words[k] = random.choice(["0", "nan", "inf", "1e300", "-1e300", "1e9", f"{random.gauss(0, 1):g}", f"{random.gauss(0, 50):g}"])
        lines[i] = " ".join(words)


def merge_nodes(lines, random, _):
    """One node in the place, or under the number, of another."""
    i, first = entry(lines, "Nodes", random)
    k, second = entry(lines, "Nodes", random)
    if not first or not second or len(first) != 4:
        return
    if random.random() < 0.5:
        lines[i] = " ".join(first[:1] + second[1:])
    elif where := section(lines, "Elements"):
        for k in range(*where):
            words = lines[k].split()
            lines[k] = " ".join(words[:5] + [second[0] if word == first[0] else word for word in words[5:]])


def scale_nodes(lines, random, _):
    """Other units, a mirror image, a sprocket that is flat."""
    where, axes = section(lines, "Nodes"), random.choice([(1, 2, 3), (1,), (2,), (3,), (1, 2)])
    factor = random.choice([0.0, -1.0, 1e-3, 0.1, 0.98, 1.02, 25.4, 1e3, 1e200])
    for i in range(*where) if where else ():
        words = lines[i].split()
        try:
            lines[i] = " ".join(f"{float(w) * factor:.16g}" if k in axes else w for k, w in enumerate(words))
        except ValueError:
            pass  # a line that another mutation has spoiled


def as_version_4(text):
    """The same mesh in version 4.1 of the format: one entity for each physical group."""
    lines = text.split("\n")
    nodes = [line.split() for line in lines[slice(*section(lines, "Nodes"))]]
    names = lines[slice(*section(lines, "PhysicalNames"))]
    groups, blocks = {}, {}
    for words in (line.split() for line in lines[slice(*section(lines, "Elements"))]):
        blocks.setdefault((2 if words[1] == "3" else 3, words[3], words[1]), []).append([words[0], *words[5:]])
    for dimension, tag, _ in sorted(blocks):
        groups.setdefault(dimension, []).append(f"{tag} -50 -50 -10 50 50 10 1 {tag} 0")
    n = sum(map(len, blocks.values()))
    out = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names, "$EndPhysicalNames"]
    out += ["$Entities", f"0 0 {len(groups[2])} {len(groups[3])}", *groups[2], *groups[3], "$EndEntities"]
    out += ["$Nodes", f"1 {len(nodes)} 1 {len(nodes)}", f"3 {groups[3][0].split()[0]} 0 {len(nodes)}"]
    out += [words[0] for words in nodes] + [" ".join(words[1:]) for words in nodes] + ["$EndNodes"]
    out += ["$Elements", f"{len(blocks)} {n} 1 {n}"]
    for (dimension, tag, kind), elements in blocks.items():
        out += [f"{dimension} {tag} {kind} {len(elements)}", *map(" ".join, elements)]
    return "\n".join([*out, "$EndElements", ""])


MUTATIONS = [
    remove_entries, repeat_entry, turn_element, other_node, other_number, other_type, other_tag, move_node, merge_nodes, scale_nodes,
]
