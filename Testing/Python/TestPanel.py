# SPDX-License-Identifier: BSD-3-Clause
"""What a user sees after Apply: the array that colours each stage, categorical colours of materials; and the macro Mesh This
Image on a grey image, on an image of materials, and on what is not an image.

    xvfb-run -a pvpython TestPanel.py MACRO_FOLDER
"""
import os
import re
import sys

import tiny
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

FIRST = {"surface": ("CELLS", "BoundaryLabels"), "smooth": ("CELLS", "BoundaryLabels"), "sized": ("POINTS", "FeatureSize"),
         "refined": ("POINTS", "FeatureSize"), "solid": ("CELLS", "LayerIds"), "prisms": ("CELLS", "LayerIds"),
         "core": ("CELLS", "MaterialIds"), "mesh": ("CELLS", "MaterialIds"), "audit": ("CELLS", "MeshQuality")}


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def check_colours():
    view = simple.CreateView("RenderView")
    for name, stage in tiny.pipeline().items():
        shown = simple.Show(stage, view)
        found = tuple(shown.ColorArrayName)
        check(found == FIRST[name], f"{name} is coloured by {found}, not {FIRST[name]}")
    materials = simple.GetColorTransferFunction("MaterialIds")
    check(materials.InterpretValuesAsCategories == 1, "materials have no categorical colours")
    check(len(materials.Annotations) == 64, f"{len(materials.Annotations) // 2} materials have a colour")
    quality = list(simple.GetColorTransferFunction("MeshQuality").RGBPoints)
    check(quality[1] > quality[2] and quality[-3] < quality[-2], "poor quality is not red, or good quality not green")
    simple.Delete(view)
    print(len(FIRST), "stages show their array")


def summary_of(stage):
    """The line of the panel, as the window gets it: from the server."""
    stage.SMProxy.UpdatePropertyInformation()
    return stage.SMProxy.GetProperty("Summary").GetElement(0)


def check_summaries():
    """Each stage tells in a line what it made, empty before it ran; running it again is not needed for that."""
    stages = tiny.pipeline()
    for name, stage in stages.items():
        check(summary_of(stage) == "", f"{name} tells before it ran: {summary_of(stage)}")
    for name, stage in stages.items():
        stage.UpdatePipeline()
        line = summary_of(stage)
        check(line and line == stage.GetClientSideObject().GetSummary(), f"{name} tells '{line}'")
        check(len(line) < 200 and "\n" not in line, f"{name} tells too much: {line}")
        print(f"  {name}: {line}")
    cells = stages["audit"].GetDataInformation().GetNumberOfCells()
    told = summary_of(stages["audit"])
    check(re.match(rf"sound: {cells} cells, .* worst 0\.\d", told), f"{cells} cells are told as {told}")
    # The mesh without its core is not sound, and the line says so.
    part = simple.MeshAudit(Input=stages["prisms"], Surface=stages["refined"])
    part.UpdatePipeline()
    check(summary_of(part).startswith("NOT sound, "), summary_of(part))


def check_materials():
    """What the panel lists: the ids and, where they have any, names of the input's materials."""
    def listed(stage, port=0):
        info = servermanager.OutputPort(stage, port).GetDataInformation().DataInformation.GetFieldDataInformation()
        array = info.GetArrayInformation("MaterialList")
        return array.GetStringValue(0) if array else None
    stages = tiny.pipeline()
    stages["mesh"].Names = "1=wall; 2=lumen"
    stages["audit"].UpdatePipeline()
    for name in ("surface", "smooth", "sized", "refined"):
        check(listed(stages[name]) == "1\n2\n", f"{name} lists {listed(stages[name])!r}")
    for name in ("mesh", "audit"):
        check(listed(stages[name]) == "1 wall\n2 lumen\n", f"{name} lists {listed(stages[name])!r}")
    print("materials are listed by ids and names")


def check_errors():
    """What is wrong comes through in one readable line behind ParaView's own place of it."""
    messages = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(messages)
    wrong = simple.MultimaterialSegmentation(Input=simple.HeartPhantom(Resolution=20), Thresholds=[80.0, 60.0])
    wrong.UpdatePipeline()
    vtkOutputWindow.SetInstance(None)
    # The executive adds lines of its own, which begin with its own name.
    told = [line for line in messages.GetOutput().splitlines() if line.startswith("vtkMultimaterialSegmentation (")]
    check(len(told) == 1, f"told {len(told)} times: {messages.GetOutput()}")
    text = told[0].split("): ", 1)[1]
    check(text == "the thresholds are out of order: 80 is not below 60", text)
    check(not re.search(r"/|\.cxx|0x", text), f"places of the source in: {text}")
    print("errors are told once, in a line:", text)


def run_macro(macro):
    messages = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(messages)
    exec(compile(macro, "macro", "exec"), {"__name__": "__main__"})
    vtkOutputWindow.SetInstance(None)
    return messages.GetOutput()


def check_macro(macro):
    phantom = simple.HeartPhantom(Resolution=40)
    simple.SetActiveSource(phantom)
    said = run_macro(macro)
    check("Thresholds from the histogram" in said and "least quality" in said, said)
    audit = simple.FindSource("Audit")
    check(audit.GetClientSideObject().GetPassed(), "the macro's mesh did not pass its audit")
    first = re.search(r"histogram: ([\d.]+), ([\d.]+), ([\d.]+)", said)
    check(first and 30 < float(first[1]) < 75 and 100 < float(first[2]) < float(first[3]) < 175, f"tissue is 85, blood 190: {said}")
    for source in list(simple.GetSources().values())[::-1]:
        simple.Delete(source)
    labels = simple.TrivialProducer()
    labels.GetClientSideObject().SetOutput(tiny.nested_spheres())
    simple.SetActiveSource(labels)
    said = run_macro(macro)
    check("Thresholds" not in said and "least quality" in said, said)
    simple.SetActiveSource(simple.Sphere())
    check("not an image" in run_macro(macro), "a sphere is taken for an image")
    simple.SetActiveSource(None)
    check("select an image" in run_macro(macro), "nothing is taken for an image")
    print("the macro meshes grey images and materials, and says what is wrong with others")


def check_look(macro):
    """Slices in two views with one camera, the histogram with its thresholds, the disputed voxels selected."""
    phantom = simple.HeartPhantom(Resolution=40)
    labels = simple.MultimaterialSegmentation(Input=phantom)
    before, links = len(simple.GetViews()), servermanager.ProxyManager().GetNumberOfLinks()
    simple.SetActiveSource(labels)
    said = run_macro(macro)
    check("disputed voxels are selected" in said, said)
    views = simple.GetViews()
    kinds = sorted(view.SMProxy.GetXMLName() for view in views)
    check(len(views) == before + 3 and kinds.count("XYChartView") == 1, f"views: {kinds}")
    chart = next(view for view in views if view.SMProxy.GetXMLName() == "XYChartView")
    told = re.search(r"thresholds ([\d.]+), ([\d.]+), ([\d.]+)", said)
    labelled = [float(text) for text in list(chart.BottomAxisLabels)[::2]]
    check(told and all(abs(a - float(b)) < 1 for a, b in zip(labelled, told.groups())), f"{labelled} for {said}")
    selection = labels.SMProxy.GetSelectionInput(0)
    check(selection is not None, "nothing is selected")
    check(servermanager.ProxyManager().GetNumberOfLinks() == links + 1, "the cameras are not linked")
    simple.SetActiveSource(phantom)
    check("select a Multimaterial Segmentation" in run_macro(macro), "a phantom is taken for a segmentation")
    print("a segmentation can be seen by eye")


def main():
    check_colours()
    check_summaries()
    check_materials()
    check_errors()
    with open(os.path.join(sys.argv[1], "Mesh This Image.py"), encoding="utf-8") as file:
        check_macro(file.read())
    with open(os.path.join(sys.argv[1], "Look At This Segmentation.py"), encoding="utf-8") as file:
        check_look(file.read())


if __name__ == "__main__":
    main()
