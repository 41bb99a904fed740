#!/usr/bin/env pvpython
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a result: xvfb-run -a pvpython pictures.py FOLDER

Reads labels.vti, surface.vtp and mesh.vtu of FOLDER and leaves slice.png (the image's middle slice and its materials),
surface.png (coloured by FeatureSize), mesh.png (the whole mesh) and cut.png (prisms, core and layered tets) there.
"""
import os
import sys

from paraview import simple

SIZE = [1200, 900]


def open_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    return view


def look_along(view, bounds, direction, zoom=1.0):
    """Look at a box along y or from the front, without perspective, so that it fills the picture."""
    centre = [0.5 * (bounds[2 * a] + bounds[2 * a + 1]) for a in range(3)]
    extent = [bounds[2 * a + 1] - bounds[2 * a] for a in range(3)]
    far = 4 * max(extent)
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = centre
    view.CameraPosition = [c - far * d for c, d in zip(centre, direction)]
    view.CameraViewUp = [0, 0, 1]
    view.CameraParallelScale = 0.53 * max(extent[2], max(extent[:2]) * SIZE[1] / SIZE[0]) / zoom
    simple.Render(view)


def save(view, path):
    simple.SaveScreenshot(path, view, ImageResolution=SIZE)
    simple.Delete(view)
    if not os.path.isfile(path) or os.path.getsize(path) == 0:
        raise RuntimeError(f"{path} could not be drawn or written; is there an X server, and room on the disk?")


FRONT = (0.4, 0.85, -0.25)
BACKWARDS = (0, 1, 0)


def draw_slice(folder, target):
    view = open_view()
    labels = simple.XMLImageDataReader(FileName=[os.path.join(folder, "labels.vti")])
    labels.UpdatePipeline()
    names = [labels.PointData.GetArray(a).Name for a in range(labels.PointData.GetNumberOfArrays())]
    grey = next((name for name in names if name not in ("MaterialIds", "Disputed")), "MaterialIds")
    extent = labels.GetDataInformation().GetExtent()
    middle = (extent[2] + extent[3]) // 2
    bounds = labels.GetDataInformation().GetBounds()
    width = 1.05 * (bounds[1] - bounds[0])
    for place, name in enumerate((grey, "MaterialIds")):
        plane = simple.ExtractSubset(Input=labels, VOI=[extent[0], extent[1], middle, middle, extent[4], extent[5]])
        moved = simple.Transform(Input=plane)
        moved.Transform.Translate = [place * width, 0, 0]
        shown = simple.Show(moved, view)
        shown.Representation = "Surface"
        simple.ColorBy(shown, ("POINTS", name))
        shown.RescaleTransferFunctionToDataRange(False)
        simple.GetColorTransferFunction(name).ApplyPreset(
            "Grayscale" if name == grey and name != "MaterialIds" else "Cool to Warm", True)
    look_along(view, [bounds[0], bounds[0] + 2.05 * width] + list(bounds[2:]), BACKWARDS)
    save(view, os.path.join(target, "slice.png"))


def draw_surface(folder, target):
    view = open_view()
    surface = simple.XMLPolyDataReader(FileName=[os.path.join(folder, "surface.vtp")])
    surface.UpdatePipeline()
    shown = simple.Show(surface, view)
    shown.Representation = "Surface With Edges"
    shown.EdgeColor = [0.3, 0.3, 0.3]
    shown.LineWidth = 0.5
    simple.ColorBy(shown, ("POINTS", "FeatureSize"))
    shown.RescaleTransferFunctionToDataRange(False)
    shown.SetScalarBarVisibility(view, True)
    look_along(view, surface.GetDataInformation().GetBounds(), FRONT)
    save(view, os.path.join(target, "surface.png"))


def draw_mesh(folder, target):
    mesh = simple.XMLUnstructuredGridReader(FileName=[os.path.join(folder, "mesh.vtu")])
    mesh.UpdatePipeline()
    view = open_view()
    shown = simple.Show(mesh, view)
    shown.Representation = "Surface With Edges"
    shown.EdgeColor = [0.2, 0.2, 0.2]
    shown.LineWidth = 0.5
    simple.ColorBy(shown, ("CELLS", "MaterialIds"))
    simple.GetColorTransferFunction("MaterialIds").RGBPoints = [1, 0.85, 0.6, 0.5, 2, 0.75, 0.1, 0.1]
    look_along(view, mesh.GetDataInformation().GetBounds(), FRONT)
    save(view, os.path.join(target, "mesh.png"))

    view = open_view()
    bounds = mesh.GetDataInformation().GetBounds()
    cut = simple.ExtractCellsByRegion(Input=mesh)
    cut.IntersectWith = "Plane"
    cut.IntersectWith.Origin = [0.5 * (bounds[2 * a] + bounds[2 * a + 1]) for a in range(3)]
    cut.IntersectWith.Normal = [0, 1, 0]
    cut.ExtractionSide = "outside"
    cut.Extractintersected = 1
    kinds = simple.Calculator(Input=cut, AttributeType="Cell Data", ResultArrayName="MaterialAndLayer",
                              Function="MaterialIds*10+LayerIds")
    shown = simple.Show(kinds, view)
    shown.Representation = "Surface With Edges"
    shown.EdgeColor = [0.1, 0.1, 0.1]
    shown.LineWidth = 0.5
    simple.ColorBy(shown, ("CELLS", "MaterialAndLayer"))
    shown.RescaleTransferFunctionToDataRange(False)
    look_along(view, bounds, BACKWARDS)
    save(view, os.path.join(target, "cut.png"))


def draw(folder, target):
    simple.LoadPalette("WhiteBackground")
    draw_slice(folder, target)
    draw_surface(folder, target)
    draw_mesh(folder, target)


if __name__ == "__main__":
    if len(sys.argv) < 2 or not os.path.isfile(os.path.join(sys.argv[1], "mesh.vtu")):
        sys.exit("pictures: error: name a folder that holds labels.vti, surface.vtp and mesh.vtu")
    draw(sys.argv[1], sys.argv[1])
