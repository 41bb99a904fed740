# SPDX-License-Identifier: BSD-3-Clause
"""A tiny image and the whole pipeline on it, by the plugin's names in paraview.simple."""
import os

import numpy

import lamina  # noqa: F401  before any object of the plugin is looked at, or Python takes it for one of its base class
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

simple.LoadPlugin(os.environ["LAMINA_PLUGIN"], remote=False)


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


def open_tube(edge=20):
    """A tube of blood (2) in tissue (1) that leaves the image at both ends."""
    axis = numpy.arange(edge) - 0.5 * (edge - 1)
    _, y, x = numpy.meshgrid(numpy.arange(12), axis, axis, indexing="ij")
    radius = numpy.sqrt(x * x + y * y)
    labels = numpy.where(radius < 4.6, 2, numpy.where(radius < 8.6, 1, 0)).astype(numpy.int32)
    image = vtkImageData()
    image.SetDimensions(edge, edge, 12)
    array = numpy_to_vtk(labels.ravel(), deep=True)
    array.SetName("MaterialIds")
    image.GetPointData().SetScalars(array)
    return image


def pipeline(image=None, is_open=False):
    """The stages from the image of materials to the audit, by name; not updated yet."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(image or nested_spheres())
    stages = {}
    stages["surface"] = simple.MultimaterialMarchingCubes(Input=source)
    if is_open:
        stages["surface"].OpenMaterials = [2]
        stages["surface"].OpenAtImageBorder = 1
    stages["smooth"] = simple.VolumeConservingSmoothing(Input=stages["surface"])
    stages["sized"] = simple.FeatureSize(Input=stages["smooth"], Layers=2)
    stages["refined"] = simple.SurfaceRefinement(Input=stages["sized"])
    stages["solid"] = simple.LayeredTetrahedra(Input=stages["refined"], Layers=2)
    stages["prisms"] = simple.PrismLayer(Input=stages["refined"], Layers=3)
    if is_open:
        stages["prisms"].LeastQuality = 0.65  # more than this coarse wall allows: some columns end in pyramids
    stages["core"] = simple.CoreTetrahedra(Input=servermanager.OutputPort(stages["prisms"], 1))
    stages["mesh"] = simple.FluidSolidMesh(Input=[stages["solid"], stages["prisms"], stages["core"]], Surface=stages["refined"])
    stages["audit"] = simple.MeshAudit(Input=stages["mesh"], Surface=stages["refined"])
    return stages
