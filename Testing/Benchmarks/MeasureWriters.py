# SPDX-License-Identifier: BSD-3-Clause
"""Speed of the writers and of the audit on a block of prisms: MeasureWriters.py [EDGE] (cubes along an edge, 80).

Two prisms a cube; the lower half is material 1, the upper 2. Prints megabytes a second of each writer, with vtkXMLUnstructuredGridWriter
beside them, and the seconds of naming patches, cutting prisms and auditing.
"""
import os
import sys
import tempfile
import time

import numpy as np

import lamina  # noqa: F401
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_WEDGE, vtkCellArray, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

simple.LoadPlugin(os.environ["LAMINA_PLUGIN"], remote=False)
FILES = {"Abaqus": "m.inp", "FEBio": "m.feb", "FluidSolidExodus": "m.exo", "Gmsh": "m.msh", "LSDyna": "m.k", "Nastran": "m.bdf",
         "OpenFOAM": "foam/m.foam", "SU2": "m.su2", "CARP": "carp/m.elem", "SimVascular": "sv/m.mesh.vtu"}


def block(edge):
    axis = np.arange(edge + 1) / edge * 100
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    side = edge + 1
    k, j, i = np.meshgrid(np.arange(edge), np.arange(edge), np.arange(edge), indexing="ij")
    base = (i + side * (j + side * k)).ravel()
    up = side * side
    a, b, c, d = base, base + 1, base + side + 1, base + side
    one = np.stack([a, c, b, a + up, c + up, b + up], axis=1)
    two = np.stack([a, d, c, a + up, d + up, c + up], axis=1)
    cells = np.stack([one, two], axis=1).reshape(-1, 6)
    grid = vtkUnstructuredGrid()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    grid.SetPoints(places)
    array = vtkCellArray()
    array.SetData(numpy_to_vtkIdTypeArray(np.arange(0, 6 * len(cells) + 1, 6, dtype=np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(cells.ravel().astype(np.int64), deep=True))
    grid.SetCells(VTK_WEDGE, array)
    materials = numpy_to_vtk((1 + (np.repeat(k.ravel(), 2) >= edge // 2)).astype(np.int32), deep=True)
    materials.SetName("MaterialIds")
    grid.GetCellData().AddArray(materials)
    return grid


def size_of(folder):
    return sum(os.path.getsize(os.path.join(root, name)) for root, _, names in os.walk(folder) for name in names)


def timed(title, work):
    since = time.monotonic()
    work()
    print(f"{title}: {time.monotonic() - since:.2f} s", flush=True)


def rate(title, work, folder):
    """By the clock, and by the processor's time: the latter is the same when other work runs beside it."""
    since, busy = time.monotonic(), time.process_time()
    work()
    size = size_of(folder) / 1e6
    print(f"{title}: {size:.0f} MB, {size / (time.monotonic() - since):.0f} MB/s by the clock, "
          f"{size / (time.process_time() - busy):.0f} MB/s of processor time", flush=True)


def main():
    edge = int(sys.argv[1]) if len(sys.argv) > 1 else 80
    source = simple.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(block(edge))
    mesh = simple.FluidSolidMesh(Input=[source], Unit="mm")
    timed(f"Fluid-Solid Mesh of {2 * edge ** 3:,} prisms", mesh.UpdatePipeline)
    tets = simple.PrismstoTetrahedra(Input=mesh)
    timed(f"Prisms to Tetrahedra, {6 * edge ** 3:,}", tets.UpdatePipeline)
    timed("Mesh Audit of the prisms", simple.MeshAudit(Input=mesh).UpdatePipeline)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "m.vtu")
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputData(mesh.GetClientSideObject().GetOutputDataObject(0))
        writer.SetFileName(path)
        rate("vtkXMLUnstructuredGridWriter, compressed", writer.Write, folder)
        writer.SetCompressorTypeToNone()
        writer.SetDataModeToAppended()
        writer.EncodeAppendedDataOff()
        rate("vtkXMLUnstructuredGridWriter, raw", writer.Write, folder)
        os.remove(path)
        for name, file in FILES.items():
            place = os.path.join(folder, name)
            os.makedirs(os.path.dirname(os.path.join(place, file)))
            proxy = getattr(simple, name + "Writer")(Input=tets if name in ("CARP", "SimVascular") else mesh,
                                                     FileName=os.path.join(place, file))
            rate(name, proxy.UpdatePipeline, place)


if __name__ == "__main__":
    main()
