# SPDX-License-Identifier: BSD-3-Clause
"""What a user sees after Apply: the array that colours each stage, categorical colours of materials; and the macro Mesh This
Image on a grey image, on an image of materials, and on what is not an image.

    xvfb-run -a pvpython TestPanel.py MACRO_FOLDER
"""
import os
import re
import sys

import tiny
from paraview import simple
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


def main():
    check_colours()
    with open(os.path.join(sys.argv[1], "Mesh This Image.py"), encoding="utf-8") as file:
        check_macro(file.read())


if __name__ == "__main__":
    main()
