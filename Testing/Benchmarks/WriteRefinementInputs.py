# SPDX-License-Identifier: BSD-3-Clause
"""Write the inputs of MeasureRefinement: labels of the phantom and of the shared images, and closed surfaces.

    LAMINA_PLUGIN=.../Lamina.so pvpython WriteRefinementInputs.py SHARED_DATA OUTPUT [NAME]...

with PYTHONPATH set to the plugin's folder. A .labels file: three sizes (int64), three spacings (double), the material
ids (int32), i fastest. A .surface file: the numbers of points and triangles (int64), points (double), corners (int64).
"""
import os
import sys
from types import SimpleNamespace

import lamina  # noqa: F401  before any object of the plugin is looked at
import numpy as np
from ClosedSurfaces import read_closed_surface

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Examples"))
from lamina_images import read_image  # noqa: E402
from lamina_pipeline import Pipeline, load_plugin, read_mask, simple  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402


def save_labels(path, image, part=None):
    array = image.GetPointData().GetArray("MaterialIds") or image.GetPointData().GetScalars()
    labels = vtk_to_numpy(array).reshape(image.GetDimensions()[::-1]).astype(np.int32)
    labels = labels[part] if part else labels
    with open(path, "wb") as file:
        file.write(np.array(labels.shape[::-1], np.int64).tobytes())
        file.write(np.array(image.GetSpacing(), float).tobytes())
        file.write(np.ascontiguousarray(labels).tobytes())


def save_surface(path, surface):
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(np.int64)
    with open(path, "wb") as file:
        file.write(np.array([len(points), len(triangles)], np.int64).tobytes())
        file.write(points.tobytes())
        file.write(triangles.tobytes())


def phantom(resolution):
    def make(pipeline, _data):
        grey, = pipeline.update(simple.HeartPhantom(Resolution=resolution))
        return pipeline.segment(grey, None, SimpleNamespace(thresholds=[50, 110, 150], open_border=[]))
    return make


def scan(pipeline, data):
    image = read_image(os.path.join(data, "heart_cta", "ct.mha"))
    mask = read_mask(os.path.join(data, "heart_cta", "mask.mha"), image)
    return pipeline.segment(image, mask, SimpleNamespace(thresholds=[-20, 215], open_border=[]))


def tooth(pipeline, data):
    image = read_image(os.path.join(data, "tooth", "tooth.nhdr"))
    return pipeline.segment(image, None, SimpleNamespace(thresholds=[520, 950], open_border=[]))


def spheres(_pipeline, data):
    """Each voxel takes the number of the highest of four fields."""
    images = [read_image(os.path.join(data, "cleaver_tests", f"spheres{i}.nrrd")) for i in (1, 2, 3, 4)]
    fields = [vtk_to_numpy(i.GetPointData().GetScalars()) for i in images]
    labels = numpy_to_vtk(1 + np.argmax(fields, axis=0).astype(np.int32), deep=True)
    labels.SetName("MaterialIds")
    images[0].GetPointData().AddArray(labels)
    return images[0]


def image(*path):
    return lambda _pipeline, data: read_image(os.path.join(data, *path))


THORAX = slice(5, 95), slice(160, 330), slice(35, 135)
LABELS = {"phantom60": phantom(60), "phantom120": phantom(120), "heart_cta": scan, "tooth": tooth,
          "mickey": image("cleaver_tests", "mickey.nrrd"), "spheres": spheres,
          "digimouse": image("digimouse", "labels.mha"), "thorax": image("digimouse", "labels.mha"),
          "frog": image("frogtissue", "frogtissue.mhd"), "aorta_labels": image("vmtk_aorta", "aorta-otsu4-labels.mha")}
SURFACES = {"biv_heart": "biv_heart_surface", "vmtk_aorta": "vmtk_aorta"}


def write(name, data, output):
    """The input of this name; returns its file."""
    if name in SURFACES:
        path = os.path.join(output, f"{name}.surface")
        save_surface(path, read_closed_surface(data, SURFACES[name]))
        return path
    path = os.path.join(output, f"{name}.labels")
    save_labels(path, LABELS[name](Pipeline(), data), THORAX if name == "thorax" else None)
    return path


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    data, output = sys.argv[1:3]
    os.makedirs(output, exist_ok=True)
    load_plugin()
    for name in sys.argv[3:] or (*LABELS, *SURFACES):
        write(name, data, output)


if __name__ == "__main__":
    main()
