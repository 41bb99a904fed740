#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What Gmsh's HXT makes of a surface between materials, for ComparePeers.py: MeshByGmsh.py FILE OUTPUT [THREADS]

FILE: as for MeshByTetGen. The triangles stay as they are; each piece of each material is a volume of its own.
"""
import sys

import gmsh
import numpy as np


def read(path):
    with open(path, "rb") as file:
        points, triangles = np.fromfile(file, np.int64, 2)
        return (np.fromfile(file, np.float64, 3 * points).reshape(-1, 3),
                np.fromfile(file, np.int64, 3 * triangles).reshape(-1, 3), np.fromfile(file, np.int32, 2 * triangles).reshape(-1, 2))


def pieces(triangles, pairs, material):
    """Connected parts of a material's boundary: of each, the numbers of its triangles."""
    own = np.flatnonzero((pairs == material).any(axis=1))
    parent = {p: p for p in np.unique(triangles[own])}

    def root(p):
        while parent[p] != p:
            parent[p] = parent[parent[p]]
            p = parent[p]
        return p
    for a, b, c in triangles[own]:
        parent[root(a)] = root(b)
        parent[root(b)] = root(c)
    roots = np.array([root(t[0]) for t in triangles[own]])
    return [own[roots == r] for r in np.unique(roots)]


def main():
    points, triangles, pairs = read(sys.argv[1])
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Mesh.Algorithm3D", 10)
    gmsh.option.setNumber("General.NumThreads", int(sys.argv[3]) if len(sys.argv) > 3 else 0)
    # Triangles that have the same pieces on both sides are one surface.
    sides = np.zeros((len(triangles), 2), dtype=np.int64)
    volumes = []
    for material in np.unique(pairs[pairs > 0]):
        shells = pieces(triangles, pairs, material)
        signed = []
        for shell in shells:
            corners = points[triangles[shell]] - points[0]
            out = np.where(pairs[shell, 0] == material, 1, -1)
            signed.append((out * np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))).sum())
        # Cavities belong to the material's largest piece: enough for images of one large piece each.
        largest = int(np.argmax(signed))
        for number, shell in enumerate(shells):
            if signed[number] > 0:
                volumes.append((material, len(volumes) + 1))
            volume = len(volumes) if signed[number] > 0 else None
            shells[number] = (shell, volume)
        base = shells[largest][1]
        for shell, volume in shells:
            column = np.where(pairs[shell, 0] == material, 0, 1)
            sides[shell, column] = volume or base
    keys, which = np.unique(sides, axis=0, return_inverse=True)
    for number in range(len(keys)):
        gmsh.model.addDiscreteEntity(2, number + 1)
    gmsh.model.mesh.addNodes(2, 1, np.arange(1, len(points) + 1), points.ravel())
    for number in range(len(keys)):
        own = triangles[which.ravel() == number]
        gmsh.model.mesh.addElementsByType(number + 1, 2, [], (own + 1).ravel())
    gmsh.model.mesh.reclassifyNodes()
    for material, volume in volumes:
        faces = [number + 1 for number, key in enumerate(keys) if volume in key]
        gmsh.model.geo.addVolume([gmsh.model.geo.addSurfaceLoop(faces)], volume)
    gmsh.model.geo.synchronize()
    gmsh.model.mesh.generate(3)
    tags, places, _ = gmsh.model.mesh.getNodes()
    row = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    row[tags] = np.arange(len(tags))
    tets, materials = [], []
    for material, volume in volumes:
        nodes = gmsh.model.mesh.getElementsByType(4, volume)[1]
        tets.append(row[nodes].reshape(-1, 4))
        materials.append(np.full(len(tets[-1]), material, dtype=np.int32))
    with open(sys.argv[2], "wb") as file:
        np.array([len(tags), sum(map(len, tets))], dtype=np.int64).tofile(file)
        np.asarray(places, dtype=np.float64).tofile(file)
        np.concatenate(tets).tofile(file)
        np.concatenate(materials).tofile(file)
    gmsh.finalize()


if __name__ == "__main__":
    main()
