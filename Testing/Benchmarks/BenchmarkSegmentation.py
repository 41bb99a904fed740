# SPDX-License-Identifier: BSD-3-Clause
"""Time and peak memory of Multimaterial Segmentation, and of the plain part of its work done by VTK, in one run.

    pvpython BenchmarkSegmentation.py [RESOLUTION [NOISE]]

with PYTHONPATH set to the plugin's folder. The image is the heart phantom; at 298 voxels, the default, it has as many
voxels as one of 249 x 216 x 240. The plain part: the three materials by vtkImageThreshold, and the components of each
by vtkImageConnectivityFilter, or where this VTK lacks it (as ParaView's packages do) by scipy.ndimage.label. Memory is
that of the process above what it had before.
"""
import resource
import sys
import time

import lamina
from vtkmodules.vtkImagingCore import vtkImageThreshold

try:
    from vtkmodules.vtkImagingMorphological import vtkImageConnectivityFilter
except ImportError:  # ParaView's packages lack it
    vtkImageConnectivityFilter = None
    from scipy import ndimage
    from vtkmodules.util.numpy_support import vtk_to_numpy


def status(field):
    """A field of the process's memory in bytes."""
    with open("/proc/self/status", encoding="ascii") as lines:
        return next(int(line.split()[1]) * 1024 for line in lines if line.startswith(field))


def measured(work):
    """What work() gives, its seconds by the clock and of the processors, and its peak of memory in bytes."""
    with open("/proc/self/clear_refs", "w", encoding="ascii") as reset:
        reset.write("5")
    before = status("VmRSS")
    start, used = time.perf_counter(), resource.getrusage(resource.RUSAGE_SELF)
    result = work()
    seconds, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_SELF)
    processor = after.ru_utime + after.ru_stime - used.ru_utime - used.ru_stime
    return result, seconds, processor, status("VmHWM") - before


def plain(image):
    """Materials by thresholds and the number of components of each."""
    counts = []
    for lower, upper in ((0, 50), (50, 130), (130, 255)):
        threshold = vtkImageThreshold()
        threshold.SetInputData(image)
        threshold.ThresholdBetween(lower, upper - 1)
        threshold.SetInValue(1)
        threshold.SetOutValue(0)
        threshold.SetOutputScalarTypeToUnsignedChar()
        threshold.Update()
        if vtkImageConnectivityFilter:
            components = vtkImageConnectivityFilter()
            components.SetInputConnection(threshold.GetOutputPort())
            components.SetScalarRange(1, 1)
            components.SetExtractionModeToAllRegions()
            components.SetLabelScalarTypeToInt()
            components.Update()
            counts.append(components.GetNumberOfExtractedRegions())
        else:
            values = vtk_to_numpy(threshold.GetOutput().GetPointData().GetScalars())
            counts.append(ndimage.label(values.reshape(image.GetDimensions()[::-1]))[1])
    return counts


def main():
    resolution = int(sys.argv[1]) if len(sys.argv) > 1 else 298
    noise = float(sys.argv[2]) if len(sys.argv) > 2 else 12.0
    phantom = lamina.vtkHeartPhantomSource()
    phantom.SetResolution(resolution)
    phantom.SetNoise(noise)
    phantom.Update()
    image = phantom.GetOutputDataObject(0)
    voxels = image.GetNumberOfPoints()
    print(f"{' x '.join(map(str, image.GetDimensions()))} = {voxels / 1e6:.1f} million voxels, noise {noise:g}")
    segmentation = lamina.vtkMultimaterialSegmentation()
    segmentation.SetInputData(image)
    for name, work in (("Multimaterial Segmentation", segmentation.Update),
                       ("vtkImageThreshold + components", lambda: plain(image))):
        result, seconds, processor, memory = measured(work)
        print(f"{name}: {seconds:.2f} s ({processor:.2f} s of processor), {memory / voxels:.1f} bytes a voxel at the peak"
              + (f"; components {result}" if result else ""))
    table = segmentation.GetOutputDataObject(1)
    for row in range(table.GetNumberOfRows()):
        print("  " + "  ".join(table.GetValue(row, c).ToString() for c in range(table.GetNumberOfColumns())))


if __name__ == "__main__":
    main()
