# SPDX-License-Identifier: BSD-3-Clause
"""LS-DYNA keyword file in fixed columns (Keyword User's Manual, Volume I: *ELEMENT_SOLID, *NODE, *PART, *SET)."""
import numpy as np

from .model import Model, demand


def columns(line, widths):
    demand(len(line) <= 80, f"a line of {len(line)} columns: {line}")
    found, at = [], 0
    for width in widths:
        found.append(line[at:at + width].strip())
        at += width
    demand(line[at:].strip() == "", f"more columns than fields: {line}")
    return found


def numbers(line, width):
    demand(len(line) % width == 0 and len(line) <= 80, f"fields of {width}: {line}")
    return [int(line[i:i + width]) for i in range(0, len(line), width)]


def cards(path):
    current = None
    with open(path, encoding="ascii") as file:
        for line in file:
            line = line.rstrip("\n")
            if line.startswith("$"):
                continue
            if line.startswith("*"):
                if current:
                    yield current
                current = (line[1:], [])
            else:
                current[1].append(line)
    yield current


def cell_of(eight):
    """The solid that a hexahedron with repeated nodes stands for, its base first."""
    n = eight
    if len(set(n)) == 8:
        demand(False, "hexahedra are not expected")
    if len(set(n)) == 4:
        demand(n[3] == n[4] == n[5] == n[6] == n[7], f"a tetrahedron repeats its fourth node: {n}")
        return n[:4]
    if len(set(n)) == 5:
        demand(n[4] == n[5] == n[6] == n[7], f"a pyramid repeats its fifth node: {n}")
        return n[:5]
    demand(len(set(n)) == 6 and n[4] == n[5] and n[6] == n[7], f"a pentahedron has nodes 5, 6 and 7, 8 in common: {n}")
    # Its triangles are 1 2 5 and 4 3 7. Hexahedra have 1 2 3 4 counter-clockwise seen from 5 to 8, so 1 5 2 looks to 4 7 3.
    return (n[0], n[4], n[1], n[3], n[6], n[2])


def read(path):
    model, parts, points, elements, keywords = Model(), {}, {}, [], []
    for keyword, data in cards(path):
        keywords.append(keyword)
        if keyword == "NODE":
            for line in data:
                number, *xyz = columns(line, (8, 16, 16, 16))
                points[int(number)] = [float(v) for v in xyz]
        elif keyword == "PART":
            pid, secid, mid = columns(data[1], (10, 10, 10))
            demand(len(data[0]) <= 70 and int(secid) > 0 and int(mid) > 0, f"the part {data[0]}")
            parts[int(pid)] = data[0]
        elif keyword == "ELEMENT_SOLID":
            for line in data:
                elements.append([int(v) for v in columns(line, (8,) * 10)])
        elif keyword == "SET_NODE_LIST_TITLE":
            demand(len(data) > 2, f"the set {data[0]} is empty")
            ids = sum((numbers(line, 10) for line in data[2:]), [])
            demand(all(len(line) == 80 for line in data[2:-1]), "eight ids a line")
            model.node_sets[data[0]] = {n - 1 for n in ids}
        elif keyword == "SET_SEGMENT_TITLE":
            sides = []
            for line in data[2:]:
                a, b, c, d = numbers(line, 10)
                sides.append(tuple(n - 1 for n in ((a, b, c) if c == d else (a, b, c, d))))
            model.side_sets[data[0]] = sides
        elif keyword == "SET_SOLID_TITLE":
            model.layers[data[0]] = sum(len(numbers(line, 10)) for line in data[2:])
        else:
            demand(keyword in ("KEYWORD", "TITLE", "CONTROL_SOLID", "SECTION_SOLID", "END"), f"the keyword *{keyword}")
    demand(keywords[0] == "KEYWORD" and keywords[-1] == "END", "*KEYWORD first, *END last")
    demand("SECTION_SOLID" in keywords, "the section that the parts name")
    demand(len({e[0] for e in elements}) == len(elements), "an element's number twice")
    demand(sorted(points) == list(range(1, len(points) + 1)), "node numbers")
    for _, pid, *nodes in elements:
        demand(all(n in points for n in nodes), "an element names a node that is not there")
        model.cells.append((parts[pid], tuple(n - 1 for n in cell_of(tuple(nodes)))))
    model.points = np.array([points[n] for n in sorted(points)])
    return model
