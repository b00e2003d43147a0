# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same mesh in the binary and the partitioned forms of Gmsh's format, and ways to spoil their bytes."""

import re
import struct

import meshes

DIMENSION = {"3": 2, "5": 3}  # of Gmsh's types of elements
N_PARTITIONS = 2
HUGE = [0, 1, 2, 7, 255, 2**15, 2**20, 2**24, 2**31 - 1, 2**31, 2**32 - 1, 2**32, 2**40, 2**53, 10**15, 2**63, 2**64 - 1]


class Mesh:
    """Nodes, elements and names of an ASCII file of version 2.2."""

    def __init__(self, text):
        lines = text.split("\n")
        self.names = lines[slice(*meshes.section(lines, "PhysicalNames"))]
        self.nodes = [(int(number), *map(float, x)) for number, *x in self.words(lines, "Nodes")]
        # number, type, group, nodes
        self.elements = [(int(words[0]), words[1], int(words[3]), [int(word) for word in words[5:]])
                         for words in self.words(lines, "Elements")]

    @staticmethod
    def words(lines, name):
        return [line.split() for line in lines[slice(*meshes.section(lines, name))]]


class Writer:
    """Numbers as Gmsh writes them: int i, size_t s and double d."""

    def __init__(self, order):
        self.order, self.out = order, bytearray()

    def text(self, *lines):
        self.out += "".join(line + "\n" for line in lines).encode()

    def put(self, kinds, *values):
        self.out += struct.pack(self.order + kinds.replace("s", "Q"), *values)

    def section(self, name):
        self.text("$" + name)

    def end(self, name):
        self.text("", "$End" + name)


def begin(mesh, version, order):
    out = Writer(order)
    out.text("$MeshFormat", f"{version} 1 8")
    out.put("i", 1)
    out.end("MeshFormat")
    out.text("$PhysicalNames", str(len(mesh.names)), *mesh.names, "$EndPhysicalNames")
    return out


def as_version_2(mesh, order, partitioned):
    """Elements one by one, each with its own header, as Gmsh writes them."""
    out = begin(mesh, "2.2", order)
    out.text("$Nodes", str(len(mesh.nodes)))
    for node in mesh.nodes:
        out.put("iddd", *node)
    out.end("Nodes")
    out.text("$Elements", str(len(mesh.elements)))
    for number, kind, group, nodes in mesh.elements:
        tags = [group, group, 1, 1 + number % N_PARTITIONS] if partitioned else [group, group]
        out.put("iii", int(kind), 1, len(tags))
        out.put("i" * (1 + len(tags) + len(nodes)), number, *tags, *nodes)
    out.end("Elements")
    return bytes(out.out)


def put_entities(out, dimensions, partitions):
    """`dimensions`: tags of surfaces and volumes, each with that group; in `partitions`, two parts of each."""
    out.put("ssss", 0, 0, *(len(dimensions[d]) * max(1, partitions) for d in (2, 3)))
    for dimension in (2, 3):
        for tag in dimensions[dimension]:
            for part in range(max(1, partitions)):
                if partitions:
                    out.put("iiisi", tag * 10 + part, dimension, tag, 1, part + 1)
                else:
                    out.put("i", tag)
                out.put("ddddddsis", -50, -50, -10, 50, 50, 10, 1, tag, 0)


def as_version_4(mesh, order, partitioned):
    """An entity for each group, or one for each of its parts."""
    out, dimensions, blocks = begin(mesh, "4.1", order), {2: [], 3: []}, {}
    for number, kind, group, nodes in mesh.elements:
        dimension, part = DIMENSION[kind], number % N_PARTITIONS
        if group not in dimensions[dimension]:
            dimensions[dimension].append(group)
        blocks.setdefault((dimension, group * 10 + part if partitioned else group, kind), []).append((number, nodes))
    out.section("Entities")
    put_entities(out, dimensions, 0)
    out.end("Entities")
    if partitioned:
        out.section("PartitionedEntities")
        out.put("ss", N_PARTITIONS, 1)
        out.put("ii", 900, 2)  # a ghost entity
        put_entities(out, dimensions, N_PARTITIONS)
        out.end("PartitionedEntities")
    n = len(mesh.nodes)
    out.section("Nodes")
    out.put("ssss", 1, n, 1, n)
    out.put("iiis", 3, dimensions[3][0] * (10 if partitioned else 1), 0, n)
    out.put("s" * n, *(node[0] for node in mesh.nodes))
    for node in mesh.nodes:
        out.put("ddd", *node[1:])
    out.end("Nodes")
    out.section("Elements")
    out.put("ssss", len(blocks), len(mesh.elements), 1, len(mesh.elements))
    for (dimension, tag, kind), elements in blocks.items():
        out.put("iiis", dimension, tag, int(kind), len(elements))
        for number, nodes in elements:
            out.put("s" * (1 + len(nodes)), number, *nodes)
    out.end("Elements")
    return bytes(out.out)


def partitioned_text(text):
    """An ASCII file of version 4.1 with its entities in two parts each."""
    lines, out, inside = text.split("\n"), [], ""
    for line in lines:
        words = line.split()
        if line.startswith("$"):
            inside = line[1:]
        elif inside == "Entities" and len(words) == 4:
            line = f"2\n1\n900 2\n0 0 {int(words[2]) * 2} {int(words[3]) * 2}"
        elif inside == "Entities":
            dimension = 2 if int(words[0]) < 4 else 3
            line = "\n".join(f"{words[0]}{part} {dimension} {words[0]} 1 {part + 1} {' '.join(words[1:])}" for part in (0, 1))
        elif inside in ("Nodes", "Elements") and len(words) == 4 and words[0] in ("2", "3") and words[2] in ("0", "3", "5"):
            line = f"{words[0]} {words[1]}0 {words[2]} {words[3]}"
        out.append(line)
    return "\n".join(out).replace("Entities", "PartitionedEntities")


def all_forms(text):
    """Files of this mesh: binary of both orders of bytes, whole and partitioned, and partitioned ASCII."""
    mesh = Mesh(text)
    return [write(mesh, order, partitioned) for write in (as_version_2, as_version_4) for partitioned in (False, True)
            for order in ("<", "<", ">")] + [partitioned_text(meshes.as_version_4(text)).encode()]


def many_groups(n=20000):
    """A small file in which n elements are in n groups each."""
    numbers = " ".join(str(1 + i) for i in range(n))
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", str(n), *(f'2 {1 + i} "hub"' for i in range(n))]
    lines += ["$EndPhysicalNames", "$Entities", "0 0 1 0", f"1 0 0 0 1 1 1 {n} {numbers} 0", "$EndEntities"]
    lines += ["$Nodes", "1 1 1 1", "2 1 0 1", "1", "0 0 0", "$EndNodes", "$Elements", f"1 {n} 1 {n}", f"2 1 15 {n}"]
    return "\n".join([*lines, *(f"{1 + i} 1" for i in range(n)), "$EndElements", ""]).encode()


def place(data, random):
    """Somewhere in a file, most often near the beginning of a section, where the counts are."""
    marks = [mark.start() for mark in re.finditer(rb"\$[A-Z]", data)] if random.random() < 0.7 else []
    at = random.choice(marks) + random.randint(0, 120) if marks else random.randrange(max(1, len(data)))
    return min(at, max(0, len(data) - 1))


def flip_bits(data, random):
    for _ in range(random.choice([1, 1, 1, 2, 8, 64])):
        at = place(data, random)
        data[at : at + 1] = bytes([data[at] ^ 1 << random.randrange(8)]) if data else b""


def other_bytes(data, random):
    at, n = place(data, random), random.choice([1, 4, 8, 40, 1000])
    data[at : at + n] = random.choice([bytes(n), b"\xff" * n, random.randbytes(n), b"\n" * n])


def huge_number(data, random):
    """A count, or a number of a node, that cannot be."""
    at, value = place(data, random), random.choice(HUGE)
    new = struct.pack(random.choice("<>") + "Q", value)
    data[at : at + 8] = random.choice([new, new[:4], new[4:]])


def huge_count(data, random):
    """The same exactly where a section begins."""
    marks = [m for m in (b"$Entities\n", b"$PartitionedEntities\n", b"$Nodes\n", b"$Elements\n") if m in data]
    if marks:
        mark = random.choice(marks)
        at = data.index(mark) + len(mark) + 8 * random.randrange(6)
        data[at : at + 8] = struct.pack(random.choice("<>") + "Q", random.choice(HUGE))


def cut(data, random):
    del data[place(data, random) :]


def remove(data, random):
    at = place(data, random)
    del data[at : at + random.choice([1, 2, 4, 8, 100, 10000])]


def repeat(data, random):
    first, at = place(data, random), place(data, random)
    data[at:at] = data[first : first + random.choice([1, 4, 8, 1000, 100000])]


MUTATIONS = [flip_bits] * 3 + [other_bytes, huge_number, huge_number, huge_count, huge_count, huge_count, cut, remove, repeat]


def spoiled(data, random):
    """`data` after one to three mutations."""
    data = bytearray(data)
    for _ in range(random.choice([1, 1, 1, 2, 3])):
        if data:
            random.choice(MUTATIONS)(data, random)
    return bytes(data)
