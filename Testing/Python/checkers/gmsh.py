# SPDX-License-Identifier: BSD-3-Clause
"""Gmsh MSH, ASCII, versions 4.1 and 2.2."""
import numpy as np

from .model import Model, demand

TYPES = {2: 3, 3: 4, 4: 4, 6: 6, 7: 5, 9: 6, 16: 8, 11: 10, 18: 15, 19: 13}
CORNERS = {2: 3, 3: 4, 4: 4, 6: 6, 7: 5, 9: 3, 16: 4, 11: 4, 18: 6, 19: 5}
DIMENSION = {2: 2, 3: 2, 9: 2, 16: 2, 4: 3, 6: 3, 7: 3, 11: 3, 18: 3, 19: 3}


def sections(path):
    found = {}
    with open(path, encoding="utf-8") as file:
        lines = [line.rstrip("\n") for line in file]
    at = 0
    while at < len(lines):
        name = lines[at][1:]
        demand(lines[at].startswith("$"), f"line {at + 1} begins no section")
        end = lines.index("$End" + name, at)
        found[name] = lines[at + 1:end]
        at = end + 1
    return found


def read(path):
    parts = sections(path)
    version, binary, size = parts["MeshFormat"][0].split()
    demand(binary == "0" and size == "8", "the format's header")
    names = {}
    demand(int(parts["PhysicalNames"][0]) == len(parts["PhysicalNames"]) - 1, "the number of names")
    for line in parts["PhysicalNames"][1:]:
        dimension, tag, name = line.split(" ", 2)
        demand(name[0] == '"' == name[-1] and len(name) <= 129, f"the name {name}")
        names[int(dimension), int(tag)] = name[1:-1]
    model = Model()
    numbers, model.points = (nodes41 if version == "4.1" else nodes22)(parts["Nodes"])
    demand(list(numbers) == list(range(1, len(numbers) + 1)), "node numbers are not 1 to n")
    rows = elements41(parts) if version == "4.1" else elements22(parts["Elements"])
    seen = set()
    for number, kind, physical, nodes in rows:
        demand(number not in seen, f"element {number} twice")
        seen.add(number)
        demand(len(nodes) == TYPES[kind], f"element {number} of type {kind} with {len(nodes)} nodes")
        demand(min(nodes) >= 1 and max(nodes) <= len(numbers), f"element {number} names a node that is not there")
        corners = tuple(n - 1 for n in nodes[:CORNERS[kind]])
        name = names[DIMENSION[kind], physical]
        if DIMENSION[kind] == 2:
            model.side_sets.setdefault(name, []).append(corners)
        else:
            model.cells.append((name, corners))
    for (dimension, _), name in names.items():
        if dimension == 2:
            model.side_sets.setdefault(name, [])
    return model


def nodes22(lines):
    demand(int(lines[0]) == len(lines) - 1, "the number of nodes")
    table = np.array([[float(x) for x in line.split()] for line in lines[1:]])
    return table[:, 0].astype(int), table[:, 1:]


def nodes41(lines):
    blocks, total, least, most = map(int, lines[0].split())
    at, numbers, points = 1, [], []
    for _ in range(blocks):
        _, _, parametric, count = map(int, lines[at].split())
        demand(parametric == 0, "parametric nodes")
        numbers += [int(line) for line in lines[at + 1:at + 1 + count]]
        points += [[float(x) for x in line.split()] for line in lines[at + 1 + count:at + 1 + 2 * count]]
        at += 1 + 2 * count
    demand(at == len(lines) and len(numbers) == total and min(numbers) == least and max(numbers) == most, "the nodes' header")
    return numbers, np.array(points)


def elements22(lines):
    demand(int(lines[0]) == len(lines) - 1, "the number of elements")
    for line in lines[1:]:
        number, kind, tags, physical, _, *nodes = map(int, line.split())
        demand(tags == 2, "two tags are expected")
        yield number, kind, physical, nodes


def elements41(parts):
    physical = {}
    points, curves, surfaces, volumes = map(int, parts["Entities"][0].split())
    demand(points == curves == 0 and len(parts["Entities"]) == 1 + surfaces + volumes, "the entities")
    for i, line in enumerate(parts["Entities"][1:]):
        words = line.split()
        demand(int(words[7]) == 1, "one physical group an entity")
        boundary = int(words[9])
        demand(len(words) == 10 + boundary, "the entity's boundary")
        physical[2 if i < surfaces else 3, int(words[0])] = int(words[8])
    lines = parts["Elements"]
    blocks, total, least, most = map(int, lines[0].split())
    at, count_all = 1, 0
    for _ in range(blocks):
        dimension, tag, kind, count = map(int, lines[at].split())
        demand(DIMENSION[kind] == dimension, "an element of another dimension than its entity")
        for line in lines[at + 1:at + 1 + count]:
            number, *nodes = map(int, line.split())
            demand(least <= number <= most, "an element's number out of range")
            yield number, kind, physical[dimension, tag], nodes
        at += 1 + count
        count_all += count
    demand(at == len(lines) and count_all == total, "the elements' header")
