# SPDX-License-Identifier: BSD-3-Clause
"""What the pictures of tests and pages show: halves, slices, a mask drawn on some slices."""
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData


def cut(source, origin=None):
    """The half behind a plane through the middle, or through `origin`; whole cells."""
    source.UpdatePipeline()
    half = simple.ExtractCellsByRegion(Input=source)
    half.IntersectWith = "Plane"
    bounds = source.GetDataInformation().GetBounds()
    half.IntersectWith.Origin = origin or [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    half.IntersectWith.Normal = [0, 1, 0]
    half.ExtractionSide = "outside"
    half.Extractintersected = 1
    return half


def image_slice(source, port=0):
    producer = simple.servermanager.OutputPort(source, port)
    middle = simple.Slice(Input=producer)
    middle.SliceType = "Plane"
    bounds = producer.GetDataInformation().GetBounds()
    middle.SliceType.Origin = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    middle.SliceType.Normal = [0, 1, 0]
    return middle


def drawn_mask(phantom):
    """The phantom's true heart on every eighth slice."""
    mask = vtkImageData()
    mask.DeepCopy(phantom.GetClientSideObject().GetOutputDataObject(1))
    values = vtk_to_numpy(mask.GetPointData().GetScalars()).reshape(mask.GetDimensions()[::-1])
    values[values > 0] = 1
    for k in range(len(values)):
        values[k] *= k % 8 == 4
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(mask)
    return source
