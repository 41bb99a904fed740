# SPDX-License-Identifier: BSD-3-Clause
"""FEBio input file, format 4.0 (User's Manual, chapter Free Format Input, section Mesh)."""
import xml.etree.ElementTree as ElementTree

import numpy as np

from .model import Model, demand

NODES = {"tet4": 4, "penta6": 6, "pyra5": 5, "tet10": 10, "penta15": 15, "tri3": 3, "quad4": 4, "tri6": 6, "quad8": 8}
CORNERS = {"tet4": 4, "penta6": 6, "pyra5": 5, "tet10": 4, "penta15": 6, "tri3": 3, "quad4": 4, "tri6": 3, "quad8": 4}
ORDER = ["Nodes", "Elements", "NodeSet", "ElementSet", "Surface", "PartList"]


def ids(text):
    return [int(word) for word in text.split(",")] if text and text.strip() else []


def read(path):
    root = ElementTree.parse(path).getroot()
    demand(root.tag == "febio_spec" and root.get("version") == "4.0", "febio_spec 4.0")
    demand(root[0].tag == "Module" and root[0].get("type"), "Module comes first")
    mesh = root.find("Mesh")
    tags = [child.tag for child in mesh]
    demand(set(tags) <= set(ORDER), f"sections {set(tags)}")
    demand(tags == sorted(tags, key=ORDER.index), "the order of sections: what is named must stand before")
    model, points, elements, domains, names = Model(), {}, {}, {}, set()
    for child in mesh:
        name = child.get("name")
        demand(name and (child.tag, name) not in names, f"{child.tag} {name}: a name, once")
        names.add((child.tag, name))
        if child.tag == "Nodes":
            for node in child:
                points[int(node.get("id"))] = [float(v) for v in node.text.split(",")]
        elif child.tag == "Elements":
            kind = child.get("type")
            domains[name] = []
            for elem in child:
                nodes = ids(elem.text)
                number = int(elem.get("id"))
                demand(elem.tag == "elem" and len(nodes) == NODES[kind] and number not in elements, f"element {number}")
                demand(all(n in points for n in nodes), f"element {number} names a node that is not there")
                elements[number] = nodes[:CORNERS[kind]]
                domains[name].append(number)
        elif child.tag == "NodeSet":
            model.node_sets[name] = {n - 1 for n in ids(child.text)}
        elif child.tag == "ElementSet":
            demand(all(e in elements for e in ids(child.text)), f"{name} names an element that is not there")
            model.layers[name] = len(ids(child.text))
        elif child.tag == "Surface":
            sides = []
            for side in child:
                nodes = ids(side.text)
                demand(len(nodes) == NODES[side.tag] and int(side.get("id")) == len(sides) + 1, f"{name}: {side.tag}")
                sides.append(tuple(n - 1 for n in nodes[:CORNERS[side.tag]]))
            model.side_sets[name] = sides
        else:
            for part in child.text.split(","):
                for number in domains.pop(part):
                    model.cells.append((name, tuple(n - 1 for n in elements[number])))
    demand(not domains, f"parts in no list: {domains.keys()}")
    demand(sorted(points) == list(range(1, len(points) + 1)), "node numbers")
    model.points = np.array([points[n] for n in sorted(points)])
    return model
