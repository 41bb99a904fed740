# SPDX-License-Identifier: BSD-3-Clause
"""See a segmentation by eye: select a Multimaterial Segmentation in the pipeline browser, then click.

Two linked slice views, the grey image and the materials over it; the histogram of the grey values with a line at each threshold; and
the disputed voxels selected, ready for Copy Active Selection of Reassign Voxels.
"""
import json

from paraview import servermanager, simple

REPORT = "LaminaReport_MultimaterialSegmentation"
BINS = 128


def say(text):
    """Into the window of output messages, or the terminal."""
    from vtkmodules.vtkCommonCore import vtkOutputWindow
    vtkOutputWindow.GetInstance().DisplayText(text + "\n")


def report_of(labels):
    field = servermanager.Fetch(simple.OutputPort(labels, 1)).GetFieldData().GetAbstractArray(REPORT)
    if field is None:
        raise ValueError("it made nothing; see the messages above")
    return json.loads(field.GetValue(0))


def grey_of(labels):
    """The array that was segmented: the input's active scalars, or its first array."""
    points = labels.Input.GetDataInformation().DataInformation.GetPointDataInformation()
    return (points.GetAttributeInformation(0) or points.GetArrayInformation(0)).GetName()


def slice_of(data, view, array, opacity=1.0):
    shown = simple.Show(data, view)
    shown.Representation = "Slice"
    shown.SliceMode = "XZ Plane"
    extent = data.GetDataInformation().GetExtent()
    shown.Slice = (extent[2] + extent[3]) // 2
    simple.ColorBy(shown, ("POINTS", array))
    shown.Opacity = opacity
    shown.SetScalarBarVisibility(view, False)
    return shown


def slices(labels, grey):
    """The grey image, and beside it the same with the materials over it, in front by a little; one camera for both."""
    image = simple.OutputPort(labels, 0)
    bounds = image.GetDataInformation().GetBounds()
    views = []
    for over in (False, True):
        view = simple.CreateView("RenderView")
        view.InteractionMode = "2D"
        simple.AssignViewToLayout(view)
        slice_of(labels.Input, view, grey)
        if over:
            shown = slice_of(image, view, "MaterialIds", 0.45)
            shown.Position = [0, -0.001 * (bounds[3] - bounds[2]), 0]
        view.CameraParallelProjection = 1
        view.CameraFocalPoint = [0.5 * (bounds[2 * k] + bounds[2 * k + 1]) for k in range(3)]
        view.CameraPosition = [view.CameraFocalPoint[0], bounds[2] - 2 * (bounds[1] - bounds[0]), view.CameraFocalPoint[2]]
        view.CameraViewUp = [0, 0, 1]
        simple.ResetCamera(view)
        views.append(view)
    simple.GetColorTransferFunction(grey).ApplyPreset("Grayscale", True)
    simple.AddCameraLink(views[0], views[1], f"Slices of {id(views[0])}")
    return views


def histogram(labels, grey, thresholds):
    """Grey values against how many there are; the axis has a line at each threshold."""
    bars = simple.Histogram(registrationName="Grey values", Input=labels.Input, SelectInputArray=["POINTS", grey], BinCount=BINS)
    view = simple.CreateView("XYChartView")
    simple.AssignViewToLayout(view)
    shown = simple.Show(bars, view)
    shown.XArrayName = "bin_extents"
    shown.UseIndexForXAxis = 0
    shown.SeriesVisibility = ["bin_values"]
    view.ChartTitle = "Thresholds " + ", ".join(f"{t:.4g}" for t in thresholds)
    view.ShowLegend = 0
    view.LeftAxisLogScale = 1
    view.BottomAxisUseCustomLabels = 1
    view.BottomAxisLabels = [text for t in thresholds for text in (f"{t:.6g}", f"{t:.4g}")]
    return view


def main():
    labels = simple.GetActiveSource()
    if labels is None or labels.SMProxy.GetXMLName() != "MultimaterialSegmentation":
        say("Look At This Segmentation: select a Multimaterial Segmentation in the pipeline browser first")
        return
    try:
        labels.UpdatePipeline()
        report = report_of(labels)
        grey = grey_of(labels)
        views = slices(labels, grey)
        chart = histogram(labels, grey, report["thresholds"])
        simple.SetActiveSource(labels)
        simple.SetActiveView(views[1])  # where QuerySelect shows the source
        simple.QuerySelect(QueryString="(Disputed != 0)", FieldType="POINT", InsideOut=0)
        for view in (*views, chart):
            simple.Render(view)
        say(f"{report['summary']}; the disputed voxels are selected: in Reassign Voxels press Copy Active Selection")
    except ValueError as error:
        say(f"Look At This Segmentation stopped: {error}")


main()
