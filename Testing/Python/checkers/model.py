# SPDX-License-Identifier: BSD-3-Clause
"""What a checker finds in a file: nodes, cells, materials, sets. All ids count from 0."""
import numpy as np


class Bad(Exception):
    """The file breaks a rule of its format."""


def demand(condition, text):
    if not condition:
        raise Bad(text)


class Model:
    def __init__(self):
        self.points = None     # n x 3
        self.cells = []        # (material name, nodes in the order: tet, pyramid with its base, wedge from below)
        self.node_sets = {}    # name -> set of nodes
        self.side_sets = {}    # name -> list of tuples of corners
        self.layers = {}       # name -> number of cells
        self.kinds = {}        # side set -> type, where the format has one

    def counts(self):
        found = {}
        for material, nodes in self.cells:
            found.setdefault(material, {}).setdefault(len(nodes), 0)
            found[material][len(nodes)] += 1
        return found

    def volumes(self):
        """Of each material; every cell must be positive."""
        sums = {}
        for material, nodes in self.cells:
            volume = cell_volume(self.points[list(nodes)])
            demand(volume > 0, f"cell {nodes} of {material} has the volume {volume}")
            sums[material] = sums.get(material, 0) + volume
        return sums

    def vector_area(self, name):
        """Sum of the sides' vector areas: their order tells where outside is."""
        total = np.zeros(3)
        for side in self.side_sets[name]:
            p = self.points[list(side)]
            for k in range(1, len(side) - 1):
                total += 0.5 * np.cross(p[k] - p[0], p[k + 1] - p[0])
        return total


def tet(a, b, c, d):
    return float(np.dot(np.cross(b - a, c - a), d - a)) / 6


def cell_volume(p):
    """Tetrahedron; pyramid (base seen from the apex counter-clockwise); wedge (lower triangle seen from the upper one)."""
    if len(p) == 4:
        return tet(*p)
    if len(p) == 5:
        return 0.5 * (tet(p[0], p[1], p[2], p[4]) + tet(p[0], p[2], p[3], p[4]) + tet(p[0], p[1], p[3], p[4]) +
                      tet(p[1], p[2], p[3], p[4]))
    if len(p) == 6:
        one = tet(p[0], p[1], p[2], p[5]) + tet(p[0], p[1], p[5], p[4]) + tet(p[0], p[4], p[5], p[3])
        two = tet(p[0], p[1], p[2], p[3]) + tet(p[1], p[2], p[3], p[4]) * -1 + tet(p[2], p[3], p[4], p[5])
        return 0.5 * (one + abs(two)) if one > 0 else one
    raise Bad(f"a cell of {len(p)} nodes")


def outer_faces(nodes):
    """Faces of a cell of that order, seen from outside."""
    n = nodes
    if len(n) == 4:
        return [(n[0], n[2], n[1]), (n[0], n[1], n[3]), (n[1], n[2], n[3]), (n[0], n[3], n[2])]
    if len(n) == 5:
        return [(n[0], n[3], n[2], n[1]), (n[0], n[1], n[4]), (n[1], n[2], n[4]), (n[2], n[3], n[4]), (n[3], n[0], n[4])]
    return [(n[0], n[2], n[1]), (n[3], n[4], n[5]), (n[0], n[1], n[4], n[3]), (n[1], n[2], n[5], n[4]), (n[2], n[0], n[3], n[5])]
