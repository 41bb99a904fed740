#!/usr/bin/env pvpython
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a result: xvfb-run -a pvpython pictures.py FOLDER [IMAGE]

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
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    return view


def save(view, path):
    simple.SaveScreenshot(path, view, ImageResolution=SIZE)
    simple.Delete(view)
    if not os.path.isfile(path) or os.path.getsize(path) == 0:
        raise RuntimeError(f"{path} could not be drawn or written; is there an X server, and room on the disk?")


def look_from_front(view):
    view.ResetCamera()
    view.CameraFocalPoint = list(view.CameraFocalPoint)
    focus = list(view.CameraFocalPoint)
    reach = view.CameraParallelScale * 4
    view.CameraPosition = [focus[0] - 0.45 * reach, focus[1] - 0.85 * reach, focus[2] + 0.3 * reach]
    view.CameraViewUp = [0, 0, 1]
    view.ResetCamera()
    simple.Render(view)


def draw_slice(folder, target, image):
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
    view.ResetCamera()
    focus = list(view.CameraFocalPoint)
    view.CameraPosition = [focus[0], focus[1] - 4 * width, focus[2]]
    view.CameraViewUp = [0, 0, 1]
    view.CameraParallelProjection = 1
    view.ResetCamera()
    save(view, os.path.join(target, "slice.png"))


def draw_surface(folder, target):
    view = open_view()
    surface = simple.XMLPolyDataReader(FileName=[os.path.join(folder, "surface.vtp")])
    shown = simple.Show(surface, view)
    shown.Representation = "Surface With Edges"
    shown.EdgeColor = [0.3, 0.3, 0.3]
    shown.LineWidth = 0.5
    simple.ColorBy(shown, ("POINTS", "FeatureSize"))
    shown.RescaleTransferFunctionToDataRange(False)
    shown.SetScalarBarVisibility(view, True)
    look_from_front(view)
    save(view, os.path.join(target, "surface.png"))


def draw_mesh(folder, target):
    mesh = simple.XMLUnstructuredGridReader(FileName=[os.path.join(folder, "mesh.vtu")])
    view = open_view()
    shown = simple.Show(mesh, view)
    shown.Representation = "Surface With Edges"
    shown.EdgeColor = [0.2, 0.2, 0.2]
    shown.LineWidth = 0.5
    simple.ColorBy(shown, ("CELLS", "MaterialIds"))
    look_from_front(view)
    save(view, os.path.join(target, "mesh.png"))

    view = open_view()
    bounds = mesh.GetDataInformation().GetBounds()
    cut = simple.ExtractCellsByRegion(Input=mesh)
    cut.IntersectWith = "Plane"
    cut.IntersectWith.Origin = [0.5 * (bounds[2 * a] + bounds[2 * a + 1]) for a in range(3)]
    cut.IntersectWith.Normal = [0, -1, 0]
    cut.Extractionside = "outside"
    kinds = simple.Calculator(Input=cut, AttributeType="Cell Data", ResultArrayName="MaterialAndLayer",
                              Function="MaterialIds*10+LayerIds")
    shown = simple.Show(kinds, view)
    shown.Representation = "Surface With Edges"
    shown.EdgeColor = [0.1, 0.1, 0.1]
    shown.LineWidth = 0.5
    simple.ColorBy(shown, ("CELLS", "MaterialAndLayer"))
    shown.RescaleTransferFunctionToDataRange(False)
    view.ResetCamera()
    focus = list(view.CameraFocalPoint)
    view.CameraPosition = [focus[0], focus[1] - 100 * view.CameraParallelScale, focus[2]]
    view.CameraViewUp = [0, 0, 1]
    view.ResetCamera()
    view.GetActiveCamera().Zoom(1.2)
    save(view, os.path.join(target, "cut.png"))


def draw(folder, target, image=None):
    draw_slice(folder, target, image)
    draw_surface(folder, target)
    draw_mesh(folder, target)


if __name__ == "__main__":
    if len(sys.argv) < 2 or not os.path.isfile(os.path.join(sys.argv[1], "mesh.vtu")):
        sys.exit("pictures: error: name a folder that holds labels.vti, surface.vtp and mesh.vtu")
    draw(sys.argv[1], sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None)
