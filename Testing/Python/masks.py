# SPDX-License-Identifier: BSD-3-Clause
"""Images whose masks are known on all slices, and how well the mask drawn on some of them is carried to the others."""
import os
import time

import numpy as np

import lamina  # noqa: F401  before any object of the plugin is looked at, or Python takes it for one of its base class
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageReader

simple.LoadPlugin(os.environ["LAMINA_PLUGIN"], remote=False)

SHAPE, REGISTRATION, AUTOMATIC = "Shape interpolation", "Registration", "Automatic"


def values_of(image):
    """The active scalars as [k, j, i]."""
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])


def with_values(image, values, name):
    """A new image on the same grid."""
    made = vtkImageData()
    made.CopyStructure(image)
    array = numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=1)
    array.SetName(name)
    made.GetPointData().SetScalars(array)
    return made


def phantom(resolution):
    """Grey image of the phantom, and its true masks by name."""
    source = simple.HeartPhantom(Resolution=resolution)
    source.UpdatePipeline()
    made = source.GetClientSideObject()
    grey, labels = made.GetOutputDataObject(0), values_of(made.GetOutputDataObject(1))
    return grey, {"heart": (labels > 0).astype(np.uint8), "blood": (labels == 2).astype(np.uint8)}


def scan(data):
    """The CT of a heart and its mask; None if the data are not there."""
    images = []
    for name in ("ct.mha", "mask.mha"):
        path = os.path.join(data, "heart_cta", name)
        if not os.path.isfile(path):
            return None
        reader = vtkMetaImageReader()
        reader.SetFileName(path)
        reader.Update()
        images.append(reader.GetOutput())
    return images[0], {"heart": (values_of(images[1]) == 1).astype(np.uint8)}


def drawn_on(truth, step, first):
    mask = np.zeros_like(truth)
    mask[first::step] = truth[first::step]
    return mask


def nearest_slice(truth, step, first):
    """Each slice like the nearest one that was drawn, empty ones among them."""
    drawn = np.arange(first, len(truth), step)
    nearest = drawn[np.abs(np.arange(len(truth))[:, None] - drawn[None, :]).argmin(axis=1)]
    return truth[nearest]


def producer(image):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(image)
    return source


def propagate(grey, mask, method=AUTOMATIC):
    """The mask on all slices by the plugin, and the seconds it took."""
    stage = simple.PropagateMask(Input=producer(grey), Mask=producer(with_values(grey, mask, "drawn")), Method=method)
    begin = time.perf_counter()
    stage.UpdatePipeline()
    seconds = time.perf_counter() - begin
    values = vtk_to_numpy(stage.GetClientSideObject().GetOutputDataObject(0).GetPointData().GetArray("Mask"))
    result = values.reshape(mask.shape).copy()
    simple.Delete(stage)
    return result, seconds


def dice(a, b):
    common = np.count_nonzero((a > 0) & (b > 0))
    return 2.0 * common / (np.count_nonzero(a) + np.count_nonzero(b))


def measure(grey, truth, step, first):
    """Dice coefficients with the truth: nearest slice, shape interpolation, registration, automatic; seconds of the last."""
    mask = drawn_on(truth, step, first)
    row = [dice(nearest_slice(truth, step, first), truth)]
    for method in (SHAPE, REGISTRATION, AUTOMATIC):
        result, seconds = propagate(grey, mask, method)
        assert np.array_equal(result[first::step], truth[first::step]), "a drawn slice was changed"
        row.append(dice(result, truth))
    return row, seconds
