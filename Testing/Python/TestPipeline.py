# SPDX-License-Identifier: BSD-3-Clause
"""The whole pipeline through the plugin's names on a tiny image, with one and with two threads: same mesh, and it passes."""
import hashlib
import json
import os
import sys

import numpy

import lamina  # before any object of the plugin is looked at
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

simple.LoadPlugin(os.environ["LAMINA_PLUGIN"], remote=False)


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def nested_spheres(edge=24):
    """Blood (2) in a ball of tissue (1), voxels of 0.5."""
    axis = (numpy.arange(edge) - 0.5 * (edge - 1)) / edge
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    radius = numpy.sqrt(x * x + y * y + z * z)
    labels = numpy.where(radius < 0.2, 2, numpy.where(radius < 0.4, 1, 0)).astype(numpy.int32)
    image = vtkImageData()
    image.SetDimensions(edge, edge, edge)
    image.SetSpacing(0.5, 0.5, 0.5)
    array = numpy_to_vtk(labels.ravel(), deep=True)
    array.SetName("MaterialIds")
    image.GetPointData().SetScalars(array)
    return image


def run():
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(nested_spheres())
    surface = simple.MultimaterialMarchingCubes(Input=source)
    smooth = simple.VolumeConservingSmoothing(Input=surface)
    sized = simple.FeatureSize(Input=smooth)
    sized.Layers = 2
    fine = simple.SurfaceRefinement(Input=sized)
    solid = simple.LayeredTetrahedra(Input=fine)
    solid.Layers = 2
    prisms = simple.PrismLayer(Input=fine)
    prisms.Layers = 3
    core = simple.CoreTetrahedra(Input=servermanager.OutputPort(prisms, 1))
    mesh = simple.FluidSolidMesh(Input=[solid, prisms, core])
    audit = simple.MeshAudit(Input=mesh, Surface=fine)
    audit.UpdatePipeline()
    return audit.GetClientSideObject()


def digest(grid):
    parts = [grid.GetPoints().GetData(), grid.GetCells().GetConnectivityArray(), grid.GetCells().GetOffsetsArray()]
    for data in (grid.GetPointData(), grid.GetCellData()):
        parts += [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    sums = hashlib.sha256()
    for part in parts:
        sums.update(vtk_to_numpy(part).tobytes())
    return sums.hexdigest()


def main():
    digests = {}
    for threads in ("1", "2"):
        os.environ["VTK_SMP_MAX_THREADS"] = threads
        audit = run()
        grid = audit.GetOutputDataObject(0)
        report = json.loads(audit.GetReportAsJSON())
        check(grid.GetNumberOfCells() > 0, "the mesh is empty")
        check(audit.GetPassed(), "the audit found: " + "; ".join(report.get("findings", ["nothing to audit"])))
        check(sum(m["wedges"] for m in report["materials"]) > 0, "there are no prisms")
        stages = [grid.GetFieldData().GetArrayName(i) for i in range(grid.GetFieldData().GetNumberOfArrays())]
        for stage in ("MultimaterialMarchingCubes", "FeatureSize", "PrismLayer", "CoreTetrahedra", "FluidSolidMesh"):
            check("LaminaReport_" + stage in stages, f"no report of {stage} in {stages}")
        digests[threads] = digest(grid)
        print(threads, "threads:", grid.GetNumberOfCells(), "cells,", digests[threads][:16])
    check(digests["1"] == digests["2"], "the mesh depends on the number of threads")


if __name__ == "__main__":
    main()
