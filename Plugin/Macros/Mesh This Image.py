# SPDX-License-Identifier: BSD-3-Clause
"""Build the whole pipeline on the selected image and show the mesh: once Macros > Import New Macro, then a click.

Grey images get thresholds from their histogram; images of materials (MaterialIds, or whole numbers up to 32) are taken as they
are. Every stage stands in the pipeline browser afterwards: change its properties and press Apply.
"""
import json

from paraview import servermanager, simple

MOST_LABELS = 32
MOST_EDGES = 500_000  # cells; the edges of more are but a dark cloud


def say(text):
    """Into the window of output messages, or the terminal."""
    from vtkmodules.vtkCommonCore import vtkOutputWindow
    vtkOutputWindow.GetInstance().DisplayText(text + "\n")


def scalars_of(image):
    """Name, range and whether whole numbers, of the array that is shown: the active scalars, or the first."""
    points = image.GetDataInformation().DataInformation.GetPointDataInformation()
    info = points.GetAttributeInformation(0) or (points.GetArrayInformation(0) if points.GetNumberOfArrays() else None)
    if info is None or info.GetNumberOfComponents() != 1:
        raise ValueError("the image has no array of one component on its points")
    return info.GetName(), info.GetComponentRange(0), info.GetDataTypeAsString() not in ("float", "double")


def run(stage):
    stage.UpdatePipeline()
    if stage.GetDataInformation().GetNumberOfPoints() == 0:
        raise ValueError(f"{stage.SMProxy.GetXMLLabel()} made nothing; see the messages above it, change its properties or those "
                         "before it, press Apply and go on from there by hand")
    return stage


def labels_of(image):
    name, (least, most), whole = scalars_of(image)
    if name == "MaterialIds" or (whole and least >= 0 and most <= MOST_LABELS):
        return image
    labels = run(simple.MultimaterialSegmentation(registrationName="Materials", Input=image))
    table = servermanager.Fetch(simple.OutputPort(labels, 1))
    report = json.loads(table.GetFieldData().GetAbstractArray("LaminaReport_MultimaterialSegmentation").GetValue(0))
    say("Thresholds from the histogram: " + ", ".join(f"{t:.4g}" for t in report["thresholds"]))
    return labels


def build(image):
    labels = labels_of(image)
    cubes = run(simple.MultimaterialMarchingCubes(registrationName="Interfaces", Input=labels))
    smooth = run(simple.VolumeConservingSmoothing(registrationName="Smooth", Input=cubes))
    sized = run(simple.FeatureSize(registrationName="Sizes", Input=smooth))
    surface = run(simple.SurfaceRefinement(registrationName="Surface", Input=sized))
    parts = [simple.LayeredTetrahedra(registrationName="Solids", Input=surface),
             simple.PrismLayer(registrationName="Prisms", Input=surface)]
    parts.append(simple.CoreTetrahedra(registrationName="Core", Input=simple.OutputPort(parts[1], 1)))
    mesh = run(simple.FluidSolidMesh(registrationName="Mesh", Input=parts, Surface=surface))
    return run(simple.MeshAudit(registrationName="Audit", Input=mesh, Surface=surface))


def tell(audit):
    """The line that a user wants: how many cells, how good the worst."""
    information = audit.GetDataInformation()
    quality = audit.CellData["MeshQuality"]
    least = f", least quality {quality.GetRange(0)[0]:.3g}" if quality else ""
    say(f"{information.GetNumberOfCells():,} cells, {information.GetNumberOfPoints():,} points{least}; the report of Audit "
        "(its second output) tells more")


def show(audit, image):
    """The half of the mesh behind a plane through its middle, whole cells, by material."""
    bounds = audit.GetDataInformation().GetBounds()
    half = simple.ExtractCellsByRegion(registrationName="Cut", Input=audit)
    half.IntersectWith = "Plane"
    half.IntersectWith.Origin = [0.5 * (bounds[2 * k] + bounds[2 * k + 1]) for k in range(3)]
    half.IntersectWith.Normal = [0, 1, 0]
    half.ExtractionSide = "outside"
    half.Extractintersected = 1
    hide_widgets = getattr(simple, "HideInteractiveWidgets", None) or simple.Hide3DWidgets  # its name since 5.12, and before
    hide_widgets(proxy=half.IntersectWith)
    view = simple.GetActiveViewOrCreate("RenderView")
    for port in range(image.SMProxy.GetNumberOfOutputPorts()):
        simple.Hide(simple.OutputPort(image, port), view)
    shown = simple.Show(half, view)
    shown.Representation = "Surface With Edges" if audit.GetDataInformation().GetNumberOfCells() < MOST_EDGES else "Surface"
    shown.EdgeColor = [0.15, 0.15, 0.2]
    simple.ColorBy(shown, ("CELLS", "MaterialIds"))
    view.CameraFocalPoint = half.IntersectWith.Origin
    view.CameraPosition = [half.IntersectWith.Origin[0], bounds[2] - 3 * (bounds[3] - bounds[2]), half.IntersectWith.Origin[2]]
    view.CameraViewUp = [0, 0, 1]
    simple.ResetCamera(view)
    simple.SetActiveSource(audit)  # not the cut, whose plane would stand before the mesh
    simple.Render(view)


def main():
    image = simple.GetActiveSource()
    if image is None:
        say("Mesh This Image: select an image in the pipeline browser first, or make one: Sources > Lamina > Heart Phantom")
        return
    if not hasattr(simple, "CoreTetrahedra"):
        simple._add_functions(vars(simple))  # the plugin was loaded after paraview.simple
    if not hasattr(simple, "CoreTetrahedra"):
        say("Mesh This Image: the plugin Lamina is not loaded: Tools > Manage Plugins")
        return
    try:
        image.UpdatePipeline()
        if image.GetDataInformation().GetDataSetTypeAsString() != "vtkImageData":
            raise ValueError("what is selected is not an image")
        audit = build(image)
        tell(audit)
        show(audit, image)
    except ValueError as error:
        say(f"Mesh This Image stopped: {error}")


main()
