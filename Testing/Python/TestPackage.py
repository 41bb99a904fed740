# SPDX-License-Identifier: BSD-3-Clause
"""The Python package `lamina` without ParaView's proxies: a chain of stages runs, classes have docstrings.

    TestPackage.py [FOLDER]    nothing of FOLDER may be loaded: with it, an installed tree proves that it needs no build
"""
import sys

import lamina
from lamina import (vtkCoreTetrahedra, vtkFeatureSize, vtkFeatureSizeRefinement, vtkHeartPhantomSource, vtkMultimaterialMarchingCubes,
                    vtkMultimaterialSegmentation, vtkPrismLayer, vtkVolumeConservingSmoothing)

CHAIN = (vtkMultimaterialSegmentation, vtkMultimaterialMarchingCubes, vtkVolumeConservingSmoothing, vtkFeatureSize,
         vtkFeatureSizeRefinement, vtkPrismLayer)


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def main():
    classes = sorted(name for name in dir(lamina) if name.startswith("vtk"))
    for name in classes:
        text = getattr(lamina, name).__doc__ or ""
        check(len(text.split()) > 5, f"{name} has no docstring")
    stages = [vtkHeartPhantomSource()]
    stages[0].SetResolution(40)
    for kind in CHAIN:
        stages.append(kind())
        stages[-1].SetInputConnection(stages[-2].GetOutputPort())
    core = vtkCoreTetrahedra()
    core.SetInputConnection(stages[-1].GetOutputPort(1))
    core.Update()
    cells = core.GetOutput().GetNumberOfCells()
    check(cells > 1000, f"lamina-tetgen made {cells} tetrahedra")
    if len(sys.argv) > 1:
        with open("/proc/self/maps", encoding="utf-8") as maps:
            loaded = [line.split()[-1] for line in maps if sys.argv[1] in line]
        check(not loaded, f"something of the build is loaded: {loaded[:1]}")
    print(f"{len(classes)} classes, {cells} tetrahedra")


if __name__ == "__main__":
    main()
