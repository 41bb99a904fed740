# SPDX-License-Identifier: BSD-3-Clause
"""Nastran bulk data in fixed columns: fields of eight characters, of sixteen where the card's name has an asterisk."""
import re

import numpy as np

from .model import Model, demand

NODES = {"CTETRA": 4, "CPENTA": 6, "CPYRAM": 5, "CTRIA3": 3, "CQUAD4": 4}


def fields(line, width):
    return [line[8 + i:8 + i + width].strip() for i in range(0, max(0, len(line) - 8), width)]


def read(path):
    with open(path, encoding="ascii") as file:
        lines = [line.rstrip("\n") for line in file]
    demand(lines[-1] == "ENDDATA", "ENDDATA at the end")
    model, points, names, sets, seen = Model(), {}, {}, {}, set()
    at = 0
    while at < len(lines):
        line = lines[at]
        at += 1
        name = re.match(r'^\$HMNAME COMP (\d+)"(.*)"$', line)
        if name:
            names[int(name.group(1))] = name.group(2)
        if line.startswith("$") or line in ("BEGIN BULK", "ENDDATA"):
            continue
        card = line[:8].strip()
        demand(len(line) <= 72, f"{card}: a line of {len(line)} columns")
        if card == "GRID*":
            demand(lines[at].startswith("*       "), "GRID* without a continuation")
            number, system, x, y = fields(line, 16)
            z, = fields(lines[at], 16)
            at += 1
            demand(system == "" and all("." in v for v in (x, y, z)), f"GRID* {number}: a real number without a point")
            points[int(number)] = [float(x), float(y), float(z)]
        elif card in NODES:
            number, pid, *nodes = map(int, fields(line, 8))
            demand(len(nodes) == NODES[card] and number not in seen, f"{card} {number}")
            demand(all(n in points for n in nodes), f"{card} {number} names a grid that is not there")
            seen.add(number)
            nodes = tuple(n - 1 for n in nodes)
            if card in ("CTRIA3", "CQUAD4"):
                model.side_sets.setdefault(names[pid], []).append(nodes)
            else:
                model.cells.append((names[pid], nodes))
        elif card == "SET1":
            pid, *ids = map(int, fields(line, 8))
            while lines[at].startswith("        "):
                ids += map(int, fields(lines[at], 8))
                at += 1
            demand(len(set(ids)) == len(ids), f"SET1 {pid}: an id twice")
            sets[pid] = {n - 1 for n in ids}
        else:
            demand(False, f"the card {card}")
    demand(sorted(points) == list(range(1, len(points) + 1)), "grid numbers")
    model.points = np.array([points[n] for n in sorted(points)])
    model.node_sets = {names[pid]: ids for pid, ids in sets.items()}
    return model
