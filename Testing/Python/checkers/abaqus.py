# SPDX-License-Identifier: BSD-3-Clause
"""Abaqus input file: keyword lines, data lines of at most 16 items, sets and element surfaces."""
import re

import numpy as np

from .model import Model, demand

NODES = {"C3D4": 4, "C3D5": 5, "C3D6": 6, "C3D10": 10, "C3D15": 15}
CORNERS = {"C3D4": 4, "C3D5": 5, "C3D6": 6, "C3D10": 4, "C3D15": 6}
# The element library's faces, corners from 1.
FACES = {
    4: {1: (1, 2, 3), 2: (1, 4, 2), 3: (2, 4, 3), 4: (3, 4, 1)},
    5: {1: (1, 2, 3, 4), 2: (1, 5, 2), 3: (2, 5, 3), 4: (3, 5, 4), 5: (4, 5, 1)},
    6: {1: (1, 2, 3), 2: (4, 6, 5), 3: (1, 4, 5, 2), 4: (2, 5, 6, 3), 5: (3, 6, 4, 1)},
}
NAME = re.compile(r"^[A-Za-z][A-Za-z0-9_]{0,79}$")


def blocks(path):
    """(keyword, parameters, data lines)."""
    current = None
    with open(path, encoding="ascii") as file:
        for line in file:
            line = line.rstrip("\n")
            demand(len(line) <= 256, "a line of more than 256 characters")
            if line.startswith("*"):
                if current:
                    yield current
                parts = [part.strip() for part in line[1:].split(",")]
                current = (parts[0].upper(), dict(part.split("=") for part in parts[1:]), [])
            else:
                demand(line.strip() != "", "an empty line")
                current[2].append(line)
    yield current


def ids(lines):
    numbers = []
    for line in lines:
        items = line.split(",")
        demand(len(items) <= 16, "more than 16 items in a line")
        numbers += [int(item) for item in items]
    return numbers


def read(path):
    model, elements, elsets, points = Model(), {}, {}, {}
    for keyword, parameters, data in blocks(path):
        for name in ("ELSET", "NSET", "NAME"):
            demand(name not in parameters or NAME.match(parameters[name]), f"the name {parameters.get(name)}")
        if keyword == "NODE":
            for line in data:
                number, *xyz = line.split(",")
                demand(all(len(x.strip()) <= 20 for x in xyz), f"node {number}: a number of more than 20 characters")
                points[int(number)] = [float(x) for x in xyz]
                demand(len(xyz) == 3, f"node {number} of {len(xyz)} coordinates")
        elif keyword == "ELEMENT":
            joined = " ".join(data).replace(", ", ",")
            kind = parameters["TYPE"]
            text = "\n".join(data).replace(",\n", ",")
            for line in text.split("\n"):
                number, *nodes = [int(item) for item in line.split(",")]
                demand(len(nodes) == NODES[kind], f"element {number} of {kind} with {len(nodes)} nodes")
                demand(number not in elements, f"element {number} twice")
                demand(all(n in points for n in nodes), f"element {number} names a node that is not there")
                elements[number] = (parameters["ELSET"], nodes[:CORNERS[kind]])
            demand(joined, "an empty *ELEMENT")
        elif keyword == "ELSET":
            demand(data, f"the set {parameters['ELSET']} is empty")
            elsets[parameters["ELSET"]] = ids(data)
        elif keyword == "NSET":
            demand(data, f"the set {parameters['NSET']} is empty")
            model.node_sets[parameters["NSET"]] = {n - 1 for n in ids(data)}
        elif keyword == "SURFACE":
            demand(parameters.get("TYPE") == "ELEMENT", "a surface of nodes")
            sides = []
            for line in data:
                name, face = [item.strip() for item in line.split(",")]
                demand(re.match(r"^S[1-6]$", face), f"the face {face}")
                for number in elsets[name]:
                    nodes = elements[number][1]
                    # Abaqus lists faces so that their normals point into the element or out of it by type: take corners.
                    sides.append(tuple(nodes[k - 1] - 1 for k in FACES[len(nodes)][int(face[1])]))
            model.side_sets[parameters["NAME"].removesuffix("_faces")] = sides
        else:
            demand(keyword == "HEADING", f"the keyword *{keyword}")
    demand(sorted(points) == list(range(1, len(points) + 1)), "node numbers are not 1 to n")
    model.points = np.array([points[n] for n in sorted(points)])
    model.cells = [(material, tuple(n - 1 for n in nodes)) for _, (material, nodes) in sorted(elements.items())]
    model.layers = {name: len(numbers) for name, numbers in elsets.items() if name.startswith("layer_")}
    return model
