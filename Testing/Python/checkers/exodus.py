# SPDX-License-Identifier: BSD-3-Clause
"""Exodus II by its netCDF variables (EXODUS: A Finite Element Data Model, appendix on the implementation)."""
import numpy as np
from scipy.io import netcdf_file

from .model import Model, demand

NODES = {"TETRA4": 4, "WEDGE6": 6, "PYRAMID5": 5, "TETRA10": 10, "WEDGE15": 15, "PYRAMID13": 13}
CORNERS = {"TETRA4": 4, "WEDGE6": 6, "PYRAMID5": 5, "TETRA10": 4, "WEDGE15": 6, "PYRAMID13": 5}
SIDES = {
    4: [(1, 2, 4), (2, 3, 4), (1, 4, 3), (1, 3, 2)],
    6: [(1, 2, 5, 4), (2, 3, 6, 5), (1, 4, 6, 3), (1, 3, 2), (4, 5, 6)],
    5: [(1, 2, 5), (2, 3, 5), (3, 4, 5), (1, 5, 4), (1, 4, 3, 2)],
}


def texts(variable):
    return [b"".join(row).split(b"\0")[0].decode() for row in variable[:]]


def read(path):
    model = Model()
    with netcdf_file(path, "r", mmap=False) as file:
        v = file.variables
        model.points = np.stack([v["coordx"][:], v["coordy"][:], v["coordz"][:]], axis=1).astype(float)
        names = texts(v["eb_names"])
        demand(len(set(names)) == len(names) and all(0 < len(n) <= 32 for n in names), f"the blocks' names {names}")
        elements = []
        for block, name in enumerate(names, 1):
            connect = v[f"connect{block}"]
            kind = connect.elem_type.decode()
            demand(connect.shape[1] == NODES[kind], f"block {name} of {kind}")
            base = name[:-2] if name.endswith(("_w", "_p")) else name
            elements += [(base, tuple(int(n) - 1 for n in row[:CORNERS[kind]])) for row in connect[:]]
        demand(len(elements) == file.dimensions["num_elem"], "the number of elements")
        order = v["elem_num_map"][:].astype(int)
        demand(sorted(order) == list(range(1, len(elements) + 1)), "the elements' map")
        model.cells = elements
        for kind, variable in (("ss", "elem_ss"), ("ns", "node_ns")):
            filled = [variable + str(i) in v for i in range(1, len(v[kind + "_status"][:]) + 1)]
            demand(filled == [bool(x) for x in v[kind + "_status"][:]], f"the status of {kind} tells which sets are empty")
        for s, name in enumerate(texts(v["ss_names"]), 1):
            sides = []
            if f"elem_ss{s}" not in v:
                model.side_sets[name] = sides
                continue
            for element, side in zip(v[f"elem_ss{s}"][:], v[f"side_ss{s}"][:]):
                nodes = elements[int(element) - 1][1]
                sides.append(tuple(nodes[k - 1] for k in SIDES[len(nodes)][int(side) - 1]))
            model.side_sets[name] = sides
        for s, name in enumerate(texts(v["ns_names"]), 1):
            model.node_sets[name] = {int(n) - 1 for n in v[f"node_ns{s}"][:]} if f"node_ns{s}" in v else set()
    return model
