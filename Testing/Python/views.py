# SPDX-License-Identifier: BSD-3-Clause
"""What the pictures of tests and pages show: halves, slices, a mask drawn on some slices."""
import os
import shutil
import subprocess

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

OBLIQUE, SIDE = (0.35, -1, 0.25), (0, -1, 0)


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


def draw(source, colour, edges, zoom, path, size, scale=None):
    """A picture of `size` pixels; colours over `scale`, or the array's own range."""
    view = simple.CreateView("RenderView")
    view.ViewSize = size
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    shown = simple.Show(source, view)
    shown.Representation = "Surface With Edges" if edges else "Surface"
    shown.EdgeColor = [0.15, 0.15, 0.2]
    shown.NonlinearSubdivisionLevel = 3
    if colour:
        simple.ColorBy(shown, colour)
        if colour[1] == "Intensity":
            simple.GetColorTransferFunction(colour[1]).ApplyPreset("Grayscale", True)
        if colour[1] != "MaterialIds":
            shown.RescaleTransferFunctionToDataRange(False, True)
        if scale:
            simple.GetColorTransferFunction(colour[1]).RescaleTransferFunction(*scale)
        shown.SetScalarBarVisibility(view, False)
    else:
        shown.ColorArrayName = ["POINTS", ""]
        shown.AmbientColor = shown.DiffuseColor = [0.88, 0.66, 0.55]
    view.CameraParallelProjection = 1
    view.CameraPosition = SIDE if source.SMProxy.GetXMLName() == "Cut" else OBLIQUE  # ParaView's slice is called Cut
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    simple.ResetCamera(view)
    view.CameraParallelScale = view.CameraParallelScale / (1.5 * zoom)
    simple.Render(view)
    simple.SaveScreenshot(path, view, ImageResolution=size)
    simple.Delete(view)


def beside(rows, path):
    """One picture of rows of files, which are removed."""
    pixels = []
    for row in rows[::-1]:
        pixels.append([])
        for part in row:
            reader = vtkPNGReader()
            reader.SetFileName(part)
            reader.Update()
            image = reader.GetOutput()
            size = image.GetDimensions()
            pixels[-1].append(vtk_to_numpy(image.GetPointData().GetScalars()).reshape(size[1], size[0], -1))
            os.remove(part)
    whole = np.concatenate([np.concatenate(row, axis=1) for row in pixels], axis=0)
    image = vtkImageData()
    image.SetDimensions(whole.shape[1], whole.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(whole.reshape(-1, whole.shape[2]), deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def fewer_colours(path, colours=64):
    """A small file, where ImageMagick is there."""
    if shutil.which("convert"):
        subprocess.run(["convert", path, "-strip", "+dither", "-colors", str(colours), f"PNG8:{path}"], check=True)
