# SPDX-License-Identifier: BSD-3-Clause
"""Apply alone, stage after stage in the menu's order, makes a mesh that passes its audit: no property is set, on no data set.

    pvpython TestApplyAlone.py SHARED_DATA [CASE ...]    without CASE: all
"""
import os
import sys
import time

import lamina  # noqa: F401  before any object of the plugin is looked at
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNrrdReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

simple.LoadPlugin(os.environ["LAMINA_PLUGIN"], remote=False)
SKIPPED = 77

# What enters, at which stage, in the order of their costs.
CASES = {
    "phantom": ("grey", None),
    "mickey": ("labels", "cleaver_tests/mickey.nrrd"),
    "spheres1": ("grey", "cleaver_tests/spheres1.nrrd"),
    "spheres2": ("grey", "cleaver_tests/spheres2.nrrd"),
    "spheres3": ("grey", "cleaver_tests/spheres3.nrrd"),
    "spheres4": ("grey", "cleaver_tests/spheres4.nrrd"),
    "heart_surface": ("surface", "biv_heart_surface/heart.vtp"),
    "aorta_surface": ("surface", "vmtk_aorta/aorta-surface.stl"),
    "aorta": ("grey", "vmtk_aorta/aorta.mha"),
    "heart_cta_masked": ("grey", "heart_cta/ct.mha", "heart_cta/mask.mha"),
    "tooth": ("grey", "tooth/tooth.nhdr"),
    "heart_cta": ("grey", "heart_cta/ct.mha"),
    "aorta_labels": ("labels", "vmtk_aorta/aorta-otsu4-labels.mha"),
    "digimouse": ("labels", "digimouse/labels.mha"),
    "frog": ("labels", "frogtissue/frogtissue.mhd"),
}
READERS = {".nrrd": vtkNrrdReader, ".nhdr": vtkNrrdReader, ".mha": vtkMetaImageReader, ".mhd": vtkMetaImageReader,
           ".vtp": vtkXMLPolyDataReader, ".stl": vtkSTLReader}


def source_of(path):
    reader = READERS[os.path.splitext(path)[1]]()
    reader.SetFileName(path)
    reader.Update()
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(reader.GetOutputDataObject(0))
    return source


def stages_of(kind, paths):
    """Each stage by name; of each only the inputs are set."""
    stages = {}
    source = simple.HeartPhantom() if paths[0] is None else source_of(paths[0])
    if kind == "grey":
        source = stages["segmentation"] = simple.MultimaterialSegmentation(Input=source)
        if len(paths) > 1:
            source.Mask = source_of(paths[1])
    if kind != "surface":
        source = stages["cubes"] = simple.MultimaterialMarchingCubes(Input=source)
        source = stages["smoothing"] = simple.VolumeConservingSmoothing(Input=source)
    source = stages["sizes"] = simple.FeatureSize(Input=source)
    surface = stages["refinement"] = simple.SurfaceRefinement(Input=source)
    stages["solids"] = simple.LayeredTetrahedra(Input=surface)
    stages["prisms"] = simple.PrismLayer(Input=surface)
    stages["core"] = simple.CoreTetrahedra(Input=servermanager.OutputPort(stages["prisms"], 1))
    stages["mesh"] = simple.FluidSolidMesh(Input=[stages["solids"], stages["prisms"], stages["core"]], Surface=surface)
    stages["audit"] = simple.MeshAudit(Input=stages["mesh"], Surface=surface)
    return stages


def run(name, kind, paths):
    """What is wrong with the mesh of one data set; nothing if it is sound."""
    begin = time.monotonic()
    messages = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(messages)
    stages = stages_of(kind, paths)
    wrong = []
    for stage, proxy in stages.items():
        since = time.monotonic()
        proxy.UpdatePipeline()
        print(f"  {name}, {stage}: {time.monotonic() - since:.1f} s", flush=True)
        if "ERR" in messages.GetOutput():
            wrong.append(f"{stage}: {messages.GetOutput()[-600:]}")
            break
    vtkOutputWindow.SetInstance(None)
    information = stages["audit"].GetDataInformation()
    cells = information.GetNumberOfCells()
    if not wrong and (cells == 0 or not stages["audit"].GetClientSideObject().GetPassed()):
        wrong.append(f"{cells} cells, the audit did not pass: {messages.GetOutput()[-600:]}")
    quality = stages["audit"].CellData["MeshQuality"]
    least = quality.GetRange(0)[0] if quality else float("nan")
    print(f"{name}: {cells:,} cells, least quality {least:.3g}, {time.monotonic() - begin:.0f} s: {'FAILED' if wrong else 'sound'}", flush=True)
    for source in list(simple.GetSources().values())[::-1]:
        simple.Delete(source)
    return [f"{name}: {text}" for text in wrong]


def main():
    sys.stdout = open(1, "w", buffering=1, closefd=False)  # pvpython prints through the window of messages, which is caught
    data, chosen = sys.argv[1], sys.argv[2:] or list(CASES)
    wrong = []
    for name in chosen:
        kind, *files = CASES[name]
        paths = [file and os.path.join(data, file) for file in files]
        if not all(path is None or os.path.isfile(path) for path in paths):
            print(f"{name}: skipped, {paths[0]} is not there")
            if len(chosen) == 1:
                return SKIPPED
            continue
        wrong += run(name, kind, paths)
    for text in wrong:
        print("FAILED:", text)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
