# SPDX-License-Identifier: BSD-3-Clause
"""Time and memory of extraction, beside vtkDiscreteMarchingCubes, and of smoothing, in one run.

    pvpython BenchmarkInterfaces.py [RESOLUTION]

with PYTHONPATH set to the plugin's folder. The image is the heart phantom's true labels, at Resolution 240 by default.
Memory is the peak of the process above what it had before, for each triangle.
"""
import sys

import lamina
from vtkmodules.vtkFiltersGeneral import vtkDiscreteMarchingCubes

from BenchmarkSegmentation import measured


def figures(source):
    data = source.GetOutput().GetFieldData()
    return {name: data.GetArray(name).GetComponent(0, 0) for name in ("IntersectingPairs", "LeastClearance", "LeastAngle")}


def main():
    phantom = lamina.vtkHeartPhantomSource()
    phantom.SetResolution(int(sys.argv[1]) if len(sys.argv) > 1 else 240)
    phantom.Update()
    labels = phantom.GetOutputDataObject(1)
    ours = lamina.vtkMultimaterialMarchingCubes()
    ours.SetInputData(labels)
    theirs = vtkDiscreteMarchingCubes()
    theirs.SetInputData(labels)
    theirs.GenerateValues(2, 1, 2)
    for label, filter_ in (("vtkDiscreteMarchingCubes", theirs), ("Multimaterial Marching Cubes", ours)):
        _, seconds, processor, memory = measured(filter_.Update)
        count = filter_.GetOutput().GetNumberOfCells()
        print(f"{label}: {count:,} triangles, {seconds:.2f} s ({processor:.2f} s of processors), "
              f"{memory / count:.0f} bytes a triangle", flush=True)
    smoothing = lamina.vtkVolumeConservingSmoothing()
    smoothing.SetInputData(ours.GetOutput())
    _, seconds, processor, memory = measured(smoothing.Update)
    count = smoothing.GetOutput().GetNumberOfCells()
    print(f"Volume-Conserving Smoothing, {smoothing.GetSweeps()} sweeps with certificate: {seconds:.2f} s "
          f"({processor:.2f} s of processors), {memory / count:.0f} bytes a triangle")
    print(figures(smoothing))


if __name__ == "__main__":
    main()
