# SPDX-License-Identifier: BSD-3-Clause
"""A mesh and what every file made of it must hold, known without the writers: from the outputs of Fluid-Solid Mesh."""
import numpy as np

import tiny  # loads the plugin
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

NAMES = "1=tissue; 2=blood; wall_tissue_1=epicardium"


class Truth:
    """Counts and sets of a grid; sides come from the boundary's surface, whose nodes have the grid's numbers or are found by place."""

    def __init__(self, grid, boundary, by_place=False):
        self.grid = grid
        self.points = vtk_to_numpy(grid.GetPoints().GetData())
        materials = vtk_to_numpy(grid.GetCellData().GetArray("MaterialIds"))
        names = {1: "tissue", 2: "blood"}
        self.counts, self.cells = {}, []
        for c in range(grid.GetNumberOfCells()):
            ids = grid.GetCell(c).GetPointIds()
            nodes = tuple(ids.GetId(i) for i in range(ids.GetNumberOfIds()))
            name = names[materials[c]]
            self.cells.append((name, nodes))
            self.counts.setdefault(name, {}).setdefault(len(nodes), 0)
            self.counts[name][len(nodes)] += 1
        self.sides = {}
        patch_names = boundary.GetFieldData().GetAbstractArray("PatchNames")
        patches = vtk_to_numpy(boundary.GetCellData().GetArray("PatchIds"))
        node_of = vtk_to_numpy(boundary.GetPointData().GetArray("GlobalNodeIds"))
        if by_place:  # put together anew, the mesh may number its nodes in another order
            numbers = {tuple(p): i for i, p in enumerate(self.points)}
            node_of = [numbers[boundary.GetPoint(i)] for i in range(boundary.GetNumberOfPoints())]
        for c in range(boundary.GetNumberOfCells()):
            ids = boundary.GetCell(c).GetPointIds()
            side = tuple(int(node_of[ids.GetId(i)]) for i in range(ids.GetNumberOfIds()))
            self.sides.setdefault(patch_names.GetValue(int(patches[c])), []).append(side)
        self.node_sets = {name: {n for side in sides for n in side} for name, sides in self.sides.items()}
        layers = vtk_to_numpy(grid.GetCellData().GetArray("LayerIds"))
        self.layers = {f"layer_{names[m]}_{k}": int(np.count_nonzero((materials == m) & (layers == k)))
                       for m in names for k in range(1, int(layers.max()) + 1) if np.any((materials == m) & (layers == k))}


def build(image, is_open, doubled=False):
    """(the proxy of the mesh, its truth)."""
    stages = tiny.pipeline(image, is_open)
    mesh = stages["mesh"]
    mesh.Names = NAMES
    mesh.Unit = "mm"
    mesh.InterfaceNodes = "Doubled" if doubled else "Shared"
    mesh.UpdatePipeline()
    filter_ = mesh.GetClientSideObject()
    return mesh, Truth(filter_.GetOutputDataObject(0), filter_.GetOutputDataObject(1))


def tetrahedra(mesh):
    """The same as tetrahedra, and the truth of them: sides are taken from the grid's own outer and inner faces."""
    tets = simple.PrismstoTetrahedra(Input=mesh)
    tets.UpdatePipeline()
    anew = simple.FluidSolidMesh(Input=[tets], Surface=mesh.Surface, Names=NAMES)
    anew.UpdatePipeline()
    filter_ = anew.GetClientSideObject()
    return tets, Truth(tets.GetClientSideObject().GetOutputDataObject(0), filter_.GetOutputDataObject(1), True)
