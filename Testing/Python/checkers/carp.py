# SPDX-License-Identifier: BSD-3-Clause
"""openCARP mesh files: .pts, .elem, .lon, .vtx, .surf; ids from 0."""
import glob
import os

import numpy as np

from .model import Model, demand


def counted(path):
    with open(path, encoding="ascii") as file:
        lines = file.read().split("\n")
    demand(lines[-1] == "", f"{path} does not end with a line's end")
    return lines[:-1]


def read(path):
    base = path[:-len(".elem")]
    model = Model()
    lines = counted(base + ".pts")
    demand(int(lines[0]) == len(lines) - 1, "the number of points")
    model.points = np.array([[float(v) for v in line.split()] for line in lines[1:]])
    demand(model.points.shape[1] == 3, "three coordinates")
    lines = counted(path)
    demand(int(lines[0]) == len(lines) - 1, "the number of elements")
    for line in lines[1:]:
        kind, *numbers = line.split()
        demand(kind == "Tt" and len(numbers) == 5, f"an element: {line}")
        *nodes, tag = map(int, numbers)
        demand(0 <= min(nodes) and max(nodes) < len(model.points), "a point that is not there")
        model.cells.append((tag, tuple(nodes)))
    lines = counted(base + ".lon")
    demand(lines[0] in ("1", "2") and len(lines) - 1 == len(model.cells), "a fibre each element")
    for line in lines[1:]:
        length = np.linalg.norm([float(v) for v in line.split()])
        demand(abs(length - 1) < 1e-6 or length == 0, f"the fibre {line}")
    for name in glob.glob(glob.escape(base) + "_*.vtx"):
        lines = counted(name)
        demand(lines[1] in ("intra", "extra") and int(lines[0]) == len(lines) - 2, f"the head of {name}")
        model.node_sets[os.path.basename(name)[len(os.path.basename(base)) + 1:-4]] = {int(v) for v in lines[2:]}
    for name in glob.glob(glob.escape(base) + "_*.surf"):
        lines = counted(name)
        demand(int(lines[0]) == len(lines) - 1, f"the head of {name}")
        sides = []
        for line in lines[1:]:
            kind, *nodes = line.split()
            demand(kind == "Tr" and len(nodes) == 3, f"a side: {line}")
            sides.append(tuple(map(int, nodes)))
        model.side_sets[os.path.basename(name)[len(os.path.basename(base)) + 1:-5]] = sides
    return model
