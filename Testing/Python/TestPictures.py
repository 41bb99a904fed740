# SPDX-License-Identifier: BSD-3-Clause
"""A picture of each stage, and a cut through the final mesh, against the baselines.

    xvfb-run -a pvpython TestPictures.py BASELINE_FOLDER OUTPUT_FOLDER [--write]

--write makes the baselines anew. A picture that differs is kept in OUTPUT_FOLDER.
"""
import json
import pathlib
import sys

import tiny
from paraview import simple
from views import cut, drawn_mask, image_slice
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader

SIZE = [320, 240]
MIDDLE = [5.75, 5.75, 5.75]
TOLERANCE = 60.0  # of vtkImageDifference's thresholded error: some pixels on edges may differ between drivers


def scenes():
    """Name, what to show, the array that colours it, whether edges are drawn."""
    phantom = simple.HeartPhantom(Resolution=48)
    phantom.UpdatePipeline()
    segmented = simple.MultimaterialSegmentation(Input=phantom)
    segmented.UpdatePipeline()
    grey = phantom.GetClientSideObject().GetOutputDataObject(0).GetPointData().GetScalars().GetName()
    yield "HeartPhantom", image_slice(phantom), ("POINTS", grey), False
    yield "MultimaterialSegmentation", image_slice(segmented), ("POINTS", "MaterialIds"), False
    edited = simple.ReassignVoxels(Input=segmented, Shape="None")
    middle = [0.5 * (a + b) for a, b in zip(*[iter(segmented.GetDataInformation().GetBounds())] * 2)]
    size = segmented.GetDataInformation().GetBounds()[1]
    edited.Edits = [json.dumps({"shape": "sphere", "center": middle, "radius": 0.2 * size, "to": 1}),
                    json.dumps({"shape": "sphere", "center": middle, "radius": 0.1 * size, "to": 2})]
    edited.UpdatePipeline()
    yield "ReassignVoxels", image_slice(edited), ("POINTS", "MaterialIds"), False
    noisy = simple.HeartPhantom(Resolution=64, Noise=25)
    flagged = simple.MultimaterialSegmentation(Input=noisy)
    flagged.UpdatePipeline()
    yield "SegmentationFlags", image_slice(flagged), ("POINTS", "Disputed"), False
    propagated = simple.PropagateMask(Input=phantom, Mask=drawn_mask(phantom))
    propagated.UpdatePipeline()
    yield "PropagateMask", image_slice(propagated), ("POINTS", "Mask"), False
    stages = tiny.pipeline()
    yield "MultimaterialMarchingCubes", stages["surface"], None, True
    yield "VolumeConservingSmoothing", stages["smooth"], None, True
    yield "FeatureSize", stages["sized"], ("POINTS", "FeatureSize"), False
    yield "SurfaceRefinement", stages["refined"], None, True
    yield "LayeredTetrahedra", cut(stages["solid"], MIDDLE), ("CELLS", "LayerIds"), True
    yield "PrismLayer", cut(stages["prisms"], MIDDLE), ("CELLS", "LayerIds"), True
    yield "CoreTetrahedra", cut(stages["core"], MIDDLE), None, True
    yield "FluidSolidMesh", cut(stages["mesh"], MIDDLE), ("CELLS", "MaterialIds"), True
    yield "MeshAudit", cut(stages["audit"], MIDDLE), ("CELLS", "MeshQuality"), True


def show(source, colour, edges, path):
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    display = simple.Show(source, view)
    display.Representation = "Surface With Edges" if edges else "Surface"
    if colour:
        simple.ColorBy(display, colour)
        # The same colours whatever presets the plugin brings along.
        colours = simple.GetColorTransferFunction(colour[1])
        colours.InterpretValuesAsCategories = 0
        colours.ApplyPreset("Cool to Warm", True)
        display.RescaleTransferFunctionToDataRange(False, True)
    else:
        display.ColorArrayName = ["POINTS", ""]
    view.CameraPosition = [0, -1, 0.35]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    simple.ResetCamera(view)
    simple.Render(view)
    simple.SaveScreenshot(str(path), view, ImageResolution=SIZE)
    simple.Delete(view)


def error_between(picture, baseline):
    readers = []
    for path in (picture, baseline):
        reader = vtkPNGReader()
        reader.SetFileName(str(path))
        readers.append(reader)
    difference = vtkImageDifference()
    difference.SetInputConnection(readers[0].GetOutputPort())
    difference.SetImageConnection(readers[1].GetOutputPort())
    difference.Update()
    return difference.GetThresholdedError()


def main():
    baselines, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    write = "--write" in sys.argv
    output.mkdir(parents=True, exist_ok=True)
    failures = []
    for name, source, colour, edges in scenes():
        picture = (baselines if write else output) / f"{name}.png"
        show(source, colour, edges, picture)
        if write:
            continue
        baseline = baselines / f"{name}.png"
        error = error_between(picture, baseline) if baseline.exists() else float("inf")
        print(f"{name}: error {error:.2f}")
        if error > TOLERANCE:
            failures.append(name)
        else:
            picture.unlink()
    if failures:
        sys.exit(f"FAILED: {', '.join(failures)} differ from the baselines; pictures are in {output}")


if __name__ == "__main__":
    main()
