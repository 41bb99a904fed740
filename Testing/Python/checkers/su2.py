# SPDX-License-Identifier: BSD-3-Clause
"""SU2 native mesh: dimension, elements, points, markers."""
import numpy as np

from .model import Model, demand

NODES = {10: 4, 13: 6, 14: 5, 5: 3, 9: 4}


def read(path):
    with open(path, encoding="ascii") as file:
        lines = [line.strip() for line in file if not line.startswith("%")]
    at = 0

    def value(key):
        nonlocal at
        name, text = lines[at].split("=")
        demand(name == key, f"{key}= expected, {lines[at]} found")
        at += 1
        return text.strip()

    model = Model()
    demand(value("NDIME") == "3", "three dimensions")
    for number in range(int(value("NELEM"))):
        kind, *nodes, index = map(int, lines[at].split())
        demand(len(nodes) == NODES[kind] and index == number, f"element {number}: {lines[at]}")
        model.cells.append(("", tuple(nodes)))
        at += 1
    points = []
    for number in range(int(value("NPOIN"))):
        *xyz, index = lines[at].split()
        demand(len(xyz) == 3 and int(index) == number, f"point {number}")
        points.append([float(x) for x in xyz])
        at += 1
    model.points = np.array(points)
    for _ in range(int(value("NMARK"))):
        tag = value("MARKER_TAG")
        demand(" " not in tag and tag not in model.side_sets, f"the marker {tag}")
        sides = []
        for _ in range(int(value("MARKER_ELEMS"))):
            kind, *nodes = map(int, lines[at].split())
            demand(kind in (5, 9) and len(nodes) == NODES[kind], f"a marker's element: {lines[at]}")
            sides.append(tuple(nodes))
            at += 1
        model.side_sets[tag] = sides
    demand(at == len(lines), "text after the markers")
    highest = max(max(nodes) for _, nodes in model.cells)
    demand(highest == len(points) - 1, "points that no element uses, or that are not there")
    return model
