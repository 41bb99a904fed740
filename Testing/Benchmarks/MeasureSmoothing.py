# SPDX-License-Identifier: BSD-3-Clause
"""What smoothing keeps on real images: volumes, intersections, gaps and angles, after 5, 20 and 100 sweeps.

    pvpython MeasureSmoothing.py FOLDER [NAME ...]

with PYTHONPATH set to the plugin's folder; FOLDER holds the shared data (CONTRIBUTING.md). NAME: digimouse, mickey,
vmtk_aorta, heart_cta, tooth, frogtissue or biv_heart_surface; all by default. Grey images get materials by thresholds.
"""
import json
import pathlib
import sys
import time

import numpy as np

import lamina
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNrrdReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

#: file, and thresholds between materials 0, 1, 2 (None: the image holds labels)
IMAGES = {"digimouse": ("digimouse/labels.mha", None), "mickey": ("cleaver_tests/mickey.nrrd", None),
          "vmtk_aorta": ("vmtk_aorta/aorta-otsu4-labels.mha", None), "heart_cta": ("heart_cta/ct.mha", (-20, 215)),
          "tooth": ("tooth/tooth.nhdr", (520, 950)), "frogtissue": ("frogtissue/frogtissue.mhd", None)}
SURFACE = ("biv_heart_surface", "biv_heart_surface/heart.vtp")


def labels_of(path, thresholds):
    reader = vtkNrrdReader() if path.suffix in (".nrrd", ".nhdr") else vtkMetaImageReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    values = np.digitize(values, thresholds) if thresholds else values
    out = vtkImageData()
    out.CopyStructure(image)
    array = numpy_to_vtk(values.astype(np.int32), deep=1)
    array.SetName("MaterialIds")
    out.GetPointData().SetScalars(array)
    return out


def report(source, stage):
    return json.loads(source.GetOutput().GetFieldData().GetAbstractArray("LaminaReport_" + stage).GetValue(0))


def smooth(name, surface):
    for sweeps in (5, 20, 100):
        smoothing = lamina.vtkVolumeConservingSmoothing()
        smoothing.SetInputData(surface)
        smoothing.SetSweeps(sweeps)
        start = time.perf_counter()
        smoothing.Update()
        if smoothing.GetOutput().GetNumberOfCells() == 0:
            print(f"{name}: refused, see the error above")
            return
        r = report(smoothing, "VolumeConservingSmoothing")
        print(f"{name}, {sweeps} sweeps ({r['sweeps']} done): {time.perf_counter() - start:.1f} s, "
              f"{r['intersectingPairs']} pairs intersect, least gap {r['leastClearance']:.3g}, "
              f"least angle {r['leastAngle']:.1f}, {r['pieces']} pieces, largest volume error of those from 100 voxels "
              f"{r['largestPieceError']:.1e}, {r['piecesMissed']} smaller ones missed", flush=True)


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "../shared/data")
    if not folder.is_dir():
        print(f"no folder {folder}: nothing measured")
        return
    wanted = sys.argv[2:] or [*IMAGES, SURFACE[0]]
    for name in wanted:
        path = folder / (SURFACE[1] if name == SURFACE[0] else IMAGES[name][0])
        if not path.exists():
            print(f"{name}: no {path}")
            continue
        if name == SURFACE[0]:
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(str(path))
            reader.Update()
            smooth(name, reader.GetOutput())
            continue
        extraction = lamina.vtkMultimaterialMarchingCubes()
        extraction.SetInputData(labels_of(path, IMAGES[name][1]))
        start = time.perf_counter()
        extraction.Update()
        r = report(extraction, "MultimaterialMarchingCubes")
        print(f"{name}: {r['triangles']:,} triangles in {time.perf_counter() - start:.1f} s, {len(r['materials'])} materials, "
              f"{r['repairedVoxels']} voxels repaired, {r['lostVoxels']} of pieces lost", flush=True)
        smooth(name, extraction.GetOutput())


if __name__ == "__main__":
    main()
