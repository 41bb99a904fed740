# SPDX-License-Identifier: BSD-3-Clause
"""OpenFOAM polyMesh in ASCII: faces in upper triangular order, patches behind them, zones."""
import os
import re

import numpy as np

from .model import Model, demand


def body(folder, name, kind):
    with open(os.path.join(folder, name), encoding="ascii") as file:
        text = file.read()
    head, rest = text.split("}\n", 1)
    demand(f"class       {kind};" in head and f"object      {name};" in head, f"the head of {name}")
    return rest.strip()


def entries(text):
    count, rest = text.split("\n(\n", 1)
    rows = rest.rsplit("\n)", 1)[0].split("\n") if not rest.startswith(")") else []
    demand(int(count) == len(rows), f"{count} entries announced, {len(rows)} found")
    return rows


def dictionaries(text):
    found = {}
    for name, inside in re.findall(r"(\w+)\s*\{(.*?)\n\s*\}", text, re.S):
        found[name] = inside
    return found


def labels(inside, key):
    count, values = re.search(key + r"\s+List<\w+>\s*(\d+)\s*\((.*?)\)", inside, re.S).groups()
    values = [int(v) for v in values.split()]
    demand(len(values) == int(count), f"{key}: {count} announced, {len(values)} found")
    return values


def read(path):
    folder = os.path.join(os.path.dirname(path), "constant", "polyMesh")
    model = Model()
    model.points = np.array([[float(v) for v in row.strip("()").split()] for row in entries(body(folder, "points", "vectorField"))])
    faces = []
    for row in entries(body(folder, "faces", "faceList")):
        size, nodes = row.rstrip(")").split("(")
        faces.append(tuple(int(n) for n in nodes.split()))
        demand(int(size) == len(faces[-1]), f"the face {row}")
    owner = [int(v) for v in entries(body(folder, "owner", "labelList"))]
    neighbour = [int(v) for v in entries(body(folder, "neighbour", "labelList"))]
    demand(len(owner) == len(faces), "an owner each face")
    inner = list(zip(owner, neighbour))
    demand(all(a < b for a, b in inner) and inner == sorted(inner), "upper triangular order")
    check_closed(model, faces, owner, neighbour)
    patches = dictionaries(entries_text(body(folder, "boundary", "polyBoundaryMesh")))
    start = len(neighbour)
    for name, inside in patches.items():
        values = dict(re.findall(r"(\w+)\s+(\w+);", inside))
        demand(int(values["startFace"]) == start, f"{name} begins at {values['startFace']}, not at {start}")
        start += int(values["nFaces"])
        model.side_sets[name] = faces[int(values["startFace"]):start]
        model.kinds[name] = values["type"]
    demand(start == len(faces), "faces that belong to no patch")
    cells = dictionaries(entries_text(body(folder, "cellZones", "regIOobject")))
    for name, inside in cells.items():
        model.cells += [(name, cell) for cell in labels(inside, "cellLabels")]
    demand(sorted(c for _, c in model.cells) == list(range(max(owner + neighbour) + 1)), "each cell in one zone")
    for name, inside in dictionaries(entries_text(body(folder, "faceZones", "regIOobject"))).items():
        flips = labels(inside, "flipMap")
        numbers = labels(inside, "faceLabels")
        demand(len(flips) == len(numbers) and set(flips) <= {0, 1}, f"{name}: a flip each face")
        model.side_sets[name] = [tuple(reversed(faces[f])) if flip else faces[f] for f, flip in zip(numbers, flips)]
    return model


def entries_text(text):
    return text.split("\n(\n", 1)[1] if "\n(\n" in text else ""


def check_closed(model, faces, owner, neighbour):
    """The faces' vector areas, outwards, add up to nothing in every cell, and its volume is positive."""
    count = max(owner + neighbour) + 1
    areas, volumes, scale = np.zeros((count, 3)), np.zeros(count), np.zeros(count)
    for f, nodes in enumerate(faces):
        p = model.points[list(nodes)]
        area = sum(0.5 * np.cross(p[k] - p[0], p[k + 1] - p[0]) for k in range(1, len(nodes) - 1))
        for cell, sign in [(owner[f], 1)] + ([(neighbour[f], -1)] if f < len(neighbour) else []):
            areas[cell] += sign * area
            volumes[cell] += sign * float(np.dot(p.mean(axis=0), area)) / 3
            scale[cell] += np.linalg.norm(area)
    demand((np.linalg.norm(areas, axis=1) <= 1e-12 * scale).all(), "a cell that is not closed")
    demand((volumes > 0).all(), "a cell that is inside out")
    model.total = float(volumes.sum())
