# SPDX-License-Identifier: BSD-3-Clause
"""A vessel that is cut by hand: its ends keep their names in the mesh and in every file, and the audit passes; and fluids without a
wall.  TestCut.py"""
import json
import os
import sys
import tempfile

import numpy as np

import tiny
from checkers import abaqus, exodus, foam, gmsh
from paraview import simple
from TestWriters import check, failures, write
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkImageData

ENDS = {"opening_aorta", "border_aorta", "opening_2_1", "border_1_1"}


def cut_spheres():
    """The pipeline on nested spheres with two oblique ends, one of them with a name."""
    stages = tiny.pipeline()
    first = simple.VesselCut(Input=stages["smooth"], Origin=[5.9, 5.6, 7.3], Normal=[0.2, 0.1, 1], Name="aorta")
    second = simple.VesselCut(Input=first, Origin=[5.9, 5.6, 4.4], Normal=[0.3, 0, -1])
    stages["sized"].Input = second
    return stages


def names_of(field):
    names = field.GetAbstractArray("PatchNames")
    return [names.GetValue(i) for i in range(names.GetNumberOfValues())]


def ends_have_names(folder):
    stages = cut_spheres()
    stages["audit"].UpdatePipeline()
    audit = stages["audit"].GetClientSideObject()
    report = json.loads(audit.GetReportAsJSON())
    check(audit.GetPassed() and report["interfaceMismatches"] == 0, f"the audit of a cut vessel: {report['findings']}")
    grid = stages["mesh"].GetClientSideObject().GetOutputDataObject(0)
    check(ENDS <= set(names_of(grid.GetFieldData())), f"patches {names_of(grid.GetFieldData())}")
    boundary = stages["mesh"].GetClientSideObject().GetOutputDataObject(1)
    patches = vtk_to_numpy(boundary.GetCellData().GetArray("PatchIds"))
    points = vtk_to_numpy(boundary.GetPoints().GetData())
    normal = np.array([0.2, 0.1, 1]) / np.linalg.norm([0.2, 0.1, 1])
    for name in ("opening_aorta", "border_aorta"):
        number = names_of(boundary.GetFieldData()).index(name)
        ids = {boundary.GetCell(int(c)).GetPointId(k) for c in np.flatnonzero(patches == number) for k in range(3)}
        heights = (points[sorted(ids)] - [5.9, 5.6, 7.3]) @ normal
        check(len(ids) > 10 and np.abs(heights).max() < 1e-6, f"{name}: {len(ids)} points, up to {np.abs(heights).max()} off the plane")
    for title, file, read in (("Abaqus", "m.inp", abaqus.read), ("Gmsh", "m.msh", gmsh.read), ("OpenFOAM", "case/m.foam", foam.read),
                              ("FluidSolidExodus", "m.exo", exodus.read)):
        path = os.path.join(folder, file)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        ok, errors, _ = write(title, stages["mesh"], path)
        check(ok, errors)
        check(ENDS <= set(read(path).side_sets), f"{title}: {sorted(read(path).side_sets)}")
    kinds = foam.read(os.path.join(folder, "case", "m.foam")).kinds
    check(kinds["opening_aorta"] == "patch", f"OpenFOAM: {kinds}")
    print("ok: a cut vessel in", grid.GetNumberOfCells(), "cells:", ", ".join(sorted(ENDS)), flush=True)


def error_of(proxy):
    algorithm, errors = proxy.GetClientSideObject(), []

    @calldata_type(VTK_STRING)
    def on_error(_, __, text):
        errors.append(text)
    algorithm.AddObserver("ErrorEvent", on_error)
    proxy.UpdatePipeline()
    return " ".join(errors)


def misses():
    stages = tiny.pipeline()
    cut = simple.VesselCut(Input=stages["smooth"], Origin=[5.9, 5.6, 40], Normal=[0, 0, 1])
    text = error_of(cut)
    check("misses the surface" in text, f"a plane that misses: {text}")
    check(cut.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints() == 0, "a plane that misses leaves nothing")
    print("ok: a plane that misses:", text.strip().splitlines()[-1] if text else "", flush=True)


def uniform(label, edge=8):
    image = vtkImageData()
    image.SetDimensions(edge, edge, edge)
    array = numpy_to_vtk(np.full(edge ** 3, label, np.int32), deep=True)
    array.SetName("MaterialIds")
    image.GetPointData().SetScalars(array)
    return image


def no_wall():
    """A fluid that is all openings has nothing for prisms to stand on; a closed one without tissue has its own wall."""
    stages = tiny.pipeline(uniform(2), True)
    mesh = simple.FluidSolidMesh(Input=[stages["prisms"], stages["core"]], Surface=stages["refined"])
    audit = simple.MeshAudit(Input=mesh, Surface=stages["refined"])
    texts = [error_of(stages[name]) for name in ("sized", "refined", "prisms", "core")] + [error_of(mesh), error_of(audit)]
    told = next((t for t in texts if t), "")
    grid = mesh.GetClientSideObject().GetOutputDataObject(0)
    check(bool(told) or (grid.GetNumberOfCells() > 0 and audit.GetClientSideObject().GetPassed()), f"a fluid without a wall: {texts}")
    print("a fluid without a wall:", grid.GetNumberOfCells(), "cells;", told.strip().splitlines()[-1] if told else "no error", flush=True)


def main():
    with tempfile.TemporaryDirectory() as folder:
        ends_have_names(folder)
    misses()
    no_wall()
    if failures:
        sys.exit(f"{len(failures)} failed")


if __name__ == "__main__":
    main()
