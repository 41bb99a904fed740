# SPDX-License-Identifier: BSD-3-Clause
"""CalculiX on a thick-walled tube: quadratic cells and Lame's solution, and a reaction that equals its load.  TestSolvers.py"""
import math
import os
import shutil
import sys
import tempfile

import numpy as np

import tiny  # noqa: F401  loads the plugin
from checkers import abaqus
from paraview import simple
from TestExternal import SKIPPED, run
from TestWriters import check, failures, write
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import VTK_WEDGE, vtkCellArray, vtkPolyData, vtkUnstructuredGrid

INNER, OUTER, LENGTH = 1.0, 2.0, 0.5
YOUNG, POISSON, PRESSURE = 1000.0, 0.3, 1.0


def points_of(around, across, along):
    """Nodes of a tube about z, by radius, angle and height."""
    r = np.linspace(INNER, OUTER, across + 1)
    phi = 2 * math.pi * np.arange(around) / around
    z = np.linspace(0, LENGTH, along + 1)
    zz, pp, rr = np.meshgrid(z, phi, r, indexing="ij")
    return np.stack([rr * np.cos(pp), rr * np.sin(pp), zz], axis=-1).reshape(-1, 3)


def number(i, j, k, around, across):
    return i + (across + 1) * (j % around + around * k)


def producer(data):
    source = simple.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def vtk_points(array):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(array), deep=True))
    return points


def tube(around, across, along):
    grid = vtkUnstructuredGrid()
    grid.SetPoints(vtk_points(points_of(around, across, along)))
    materials = vtkIntArray()
    materials.SetName("MaterialIds")
    for k in range(along):
        for j in range(around):
            for i in range(across):
                low = [number(a, b, k, around, across) for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
                up = [n + (across + 1) * around for n in low]
                for a, b, c in ((0, 2, 1), (0, 3, 2)):
                    grid.InsertNextCell(VTK_WEDGE, 6, [low[a], low[b], low[c], up[a], up[b], up[c]])
                    materials.InsertNextValue(1)
    grid.GetCellData().AddArray(materials)
    return grid


def boundary(around, across, along):
    """The tube's surface with its ends as patches; its triangles are those of the wedges' own triangles at the ends."""
    polys, labels, patches = vtkCellArray(), vtkIntArray(), vtkIntArray()
    labels.SetName("BoundaryLabels")
    labels.SetNumberOfComponents(2)
    patches.SetName("PatchIds")

    def add(nodes, patch):
        for a, b, c in ((0, 1, 2), (0, 2, 3)):
            polys.InsertNextCell(3, [nodes[a], nodes[b], nodes[c]])
            labels.InsertNextTuple2(1, 0)
            patches.InsertNextValue(patch)
    for j in range(around):
        for i in range(across):
            low = [number(a, b, 0, around, across) for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
            top = [n + (across + 1) * around * along for n in low]
            add([low[0], low[3], low[2], low[1]], 1)
            add(top, 2)
        for k in range(along):
            for i, turned in ((0, True), (across, False)):
                side = [number(i, b, c, around, across) for b, c in ((j, k), (j + 1, k), (j + 1, k + 1), (j, k + 1))]
                add(side[::-1] if turned else side, 0)
    surface = vtkPolyData()
    surface.SetPoints(vtk_points(points_of(around, across, along)))
    surface.SetPolys(polys)
    surface.GetCellData().AddArray(labels)
    surface.GetCellData().AddArray(patches)
    names = vtkStringArray()
    names.SetName("PatchNames")
    for name in ("wall", "border_1", "border_2"):
        names.InsertNextValue(name)
    surface.GetFieldData().AddArray(names)
    return surface


def results(folder):
    """Values a node of each list in the .dat file: (what, set) -> rows."""
    tables, key = {}, None
    with open(os.path.join(folder, "run.dat"), encoding="ascii") as file:
        for line in file:
            words = line.split()
            if "for set" in line:
                key = (line.split("(")[0].strip(), line.split("set ")[1].split()[0])
                tables[key] = []
            elif key and words:
                tables[key].append([float(w) for w in words])
    return {key: np.array(rows) for key, rows in tables.items()}


def solve(folder, cells, text):
    os.mkdir(folder)
    ok, errors, _ = write("Abaqus", cells, os.path.join(folder, "mesh.inp"))
    check(ok, errors)
    abaqus.read(os.path.join(folder, "mesh.inp"))
    with open(os.path.join(folder, "run.inp"), "w", encoding="ascii") as file:
        file.write("*INCLUDE, INPUT=mesh.inp\n*MATERIAL, NAME=elastic\n*ELASTIC\n"
                   f"{YOUNG}, {POISSON}\n*SOLID SECTION, ELSET=steel, MATERIAL=elastic\n" + text)
    code, out = run(["ccx", "run"], folder)
    check(code == 0 and "Job finished" in out, f"ccx: {out[-1500:]}")
    return results(folder)


def supports(points):
    """Nodes on the axes x and y may only move along them: the tube cannot turn or drift."""
    lines = []
    for n, p in enumerate(points, 1):
        if abs(p[1]) < 1e-9:
            lines.append(f"{n}, 2, 2")
        if abs(p[0]) < 1e-9:
            lines.append(f"{n}, 1, 1")
    return "\n".join(lines) + "\n"


def lame(folder, mesh):
    fine = producer(boundary(192, 2, 2))
    cells = simple.QuadraticCells(Input=mesh, Surface=fine)
    cells.UpdatePipeline()
    grid = cells.GetClientSideObject().GetOutputDataObject(0)
    points = vtk_to_numpy(grid.GetPoints().GetData())
    found = solve(os.path.join(folder, "lame"), cells, "*BOUNDARY\nborder_steel_1, 3, 3\nborder_steel_2, 3, 3\n" + supports(points) +
                  f"*STEP\n*STATIC\n*DSLOAD\ninner_faces, P, {PRESSURE}\n*NODE PRINT, NSET=inner\nU\n*NODE PRINT, NSET=outer\nU\n"
                  "*END STEP\n")
    for name, radius in (("INNER", INNER), ("OUTER", OUTER)):
        rows = found["displacements (vx,vy,vz)" if ("displacements (vx,vy,vz)", name) in found else "displacements", name]
        nodes = rows[:, 0].astype(int) - 1
        place = points[nodes][:, :2]
        radial = np.einsum("ij,ij->i", rows[:, 1:3], place / np.linalg.norm(place, axis=1)[:, None])
        exact = (1 + POISSON) * PRESSURE * INNER ** 2 / (YOUNG * (OUTER ** 2 - INNER ** 2)) * ((1 - 2 * POISSON) * radius + OUTER ** 2 / radius)
        error = np.abs(radial / exact - 1)
        print(f"{name}: {len(nodes)} nodes, displacement {radial.mean():.8f}, exact {exact:.8f}, largest error {100 * error.max():.3f}%",
              flush=True)
        check(error.max() < 0.02, f"Lame's solution at the {name}: {100 * error.max():.2f}% off")


def reaction(folder, tets):
    """One end is held, the other drawn: what holds it equals what draws."""
    grid = tets.GetClientSideObject().GetOutputDataObject(0)
    found = solve(os.path.join(folder, "reaction"), tets, "*BOUNDARY\nborder_steel_1, 1, 3\n*STEP\n*STATIC\n*DSLOAD\n"
                  f"border_steel_2_faces, P, {PRESSURE}\n*NODE PRINT, NSET=border_steel_1, TOTALS=ONLY\nRF\n*END STEP\n")
    total = next(rows[0] for (what, name), rows in found.items() if "force" in what)
    side = 2 * OUTER * math.sin(math.pi / 32)
    area = 32 * 0.25 * (side ** 2 - (side * INNER / OUTER) ** 2) / math.tan(math.pi / 32)
    print("reaction", total, "load", area * PRESSURE, "cells", grid.GetNumberOfCells(), flush=True)
    check(abs(abs(total[-1]) / (area * PRESSURE) - 1) < 1e-6, f"the reaction is {total}, the load {area * PRESSURE}")
    check(np.abs(total[-3:-1]).max() < 1e-6 * area, f"the reaction across is {total}")


def main():
    if not shutil.which("ccx"):
        print("skipped: CalculiX is not installed (Utilities/install-dependencies.sh --all)")
        sys.exit(SKIPPED)
    mesh = simple.FluidSolidMesh(Input=[producer(tube(32, 4, 2))], Surface=producer(boundary(32, 4, 2)),
                                 Names="1=steel; wall_steel_1=outer; wall_steel_2=inner")
    tets = simple.PrismstoTetrahedra(Input=mesh)
    tets.UpdatePipeline()
    with tempfile.TemporaryDirectory() as folder:
        lame(folder, tets)
        reaction(folder, tets)
    if failures:
        sys.exit(f"{len(failures)} failed")


if __name__ == "__main__":
    main()
