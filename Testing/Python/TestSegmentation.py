# SPDX-License-Identifier: BSD-3-Clause
"""Multimaterial Segmentation through the plugin: its properties, and two real scans.

    pvpython TestSegmentation.py EXAMPLES [SHARED_DATA]

Exits 77 after the plugin's own checks if the folder of real data is asked for and is not there.
"""
import json
import os
import pathlib
import sys

import numpy as np

import lamina  # noqa: F401  before any object of the plugin is looked at, or Python takes it for one of its base class
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

simple.LoadPlugin(os.environ["LAMINA_PLUGIN"], remote=False)
sys.path.insert(0, sys.argv[1])


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def image_of(values, spacing=(1, 1, 1)):
    """An image of an array indexed k, j, i."""
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetSpacing(spacing)
    array = numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=True)
    array.SetName("values")
    image.GetPointData().SetScalars(array)
    return image


def producer(image):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(image)
    return source


def segment(image, **properties):
    """The labels, indexed k, j, i, the flags, and the report."""
    stage = simple.MultimaterialSegmentation(Input=producer(image), **properties)
    stage.UpdatePipeline()
    output = stage.GetClientSideObject().GetOutputDataObject(0)
    check(output.GetNumberOfPoints() == image.GetNumberOfPoints(), "the segmentation failed")
    shape = image.GetDimensions()[::-1]
    points = output.GetPointData()
    report = json.loads(output.GetFieldData().GetAbstractArray("LaminaReport_MultimaterialSegmentation").GetValue(0))
    return (vtk_to_numpy(points.GetArray("MaterialIds")).reshape(shape),
            vtk_to_numpy(points.GetArray("Disputed")).reshape(shape), report)


def has_forbidden_contact(labels, first, second):
    """Whether two materials touch over faces, edges or corners."""
    one, padded = labels == first, np.pad(labels == second, 1)
    grown = np.zeros_like(one)
    for k in range(3):
        for j in range(3):
            for i in range(3):
                grown |= padded[k:k + one.shape[0], j:j + one.shape[1], i:i + one.shape[2]]
    return bool((one & grown).any())


def critical_blocks(labels):
    """Lattice edges across which only a material touches itself."""
    count = 0
    for a, b in ((0, 1), (0, 2), (1, 2)):
        def part(da, db, a=a, b=b):
            cut = [slice(None)] * 3
            cut[a] = slice(da, labels.shape[a] - 1 + da)
            cut[b] = slice(db, labels.shape[b] - 1 + db)
            return labels[tuple(cut)]
        p0, p1, p2, p3 = part(0, 0), part(0, 1), part(1, 1), part(1, 0)
        count += int((((p0 == p2) & (p0 != p1) & (p0 != p3)) | ((p1 == p3) & (p1 != p0) & (p1 != p2))).sum())
    return count


def skin_voxels(labels):
    """Voxels of material 1 with 0 and 2 on opposite sides along an axis, at most two voxels of 1 between them."""
    skin = np.zeros(labels.shape, bool)
    padded = np.pad(labels, 2, mode="edge")

    def moved(axis, steps):
        cut = [slice(2, -2)] * 3
        cut[axis] = slice(2 + steps, padded.shape[axis] - 2 + steps)
        return padded[tuple(cut)]

    for axis in range(3):
        for sign in (1, -1):
            for before, behind in ((1, 1), (1, 2), (2, 1)):
                line = (labels == 1) & (moved(axis, -before * sign) == 0) & (moved(axis, behind * sign) == 2)
                for step in list(range(1 - before, 0)) + list(range(1, behind)):
                    line &= moved(axis, step * sign) == 1
                skin |= line
    return int(skin.sum())


def try_properties():
    # Half values around a block of 190 in 20.
    values = np.full((16, 16, 16), 20, np.int16)
    values[4:12, 4:12, 4:12] = 108
    values[5:11, 5:11, 5:11] = 190
    image = image_of(values)
    labels, _, _ = segment(image, Thresholds=[50, 150])
    check((labels == 1).sum() == 8**3 - 6**3 and not has_forbidden_contact(labels, 0, 2), "the wall is not kept")
    labels, _, report = segment(image, Thresholds=[50, 150], ForbiddenContacts=[])
    check((labels == 1).sum() == 0 and (labels == 2).sum() == 8**3, "an empty list of contacts does not allow them")
    check(any(rule["rule"] == "skin dissolved" for rule in report["rules"]), "the report does not tell of the skin")
    labels, _, _ = segment(image, Thresholds=[50, 150], ForbiddenContacts=[], DissolveSkins=0)
    check((labels == 1).sum() == 8**3 - 6**3, "Dissolve Skins does not matter")
    # Four blocks in tissue, two of which meet in an edge.
    values = np.full((24, 24, 24), 20, np.int16)
    values[2:22, 2:22, 2:22] = 85
    values[4:9, 4:9, 4:20] = 190
    values[9:14, 9:14, 4:20] = 190
    values[16:20, 4:8, 4:8] = 190
    image = image_of(values, (1, 1, 4))
    labels, flags, report = segment(image, MinimumVoxels=0, MinimumShare=0)
    check(critical_blocks(labels) == 0 and (flags == 4).sum() > 0, "the edge is not repaired")
    check(report["criticalEdges"] == 16 and report["faultsLeft"] == 0, f"faults are counted wrongly: {report}")
    labels, flags, _ = segment(image, MinimumVoxels=0, MinimumShare=0, RepairTopology="Flag Only")
    check(critical_blocks(labels) == 16 and (flags == 2).sum() > 0, "faults are not flagged")
    labels, flags, _ = segment(image, RepairTopology="Off", KeptComponents="Largest Few", ComponentCount=2)
    check((labels == 2).sum() == 2 * 25 * 16 and flags.sum() == 0, "not the two largest")
    labels, _, _ = segment(image, RepairTopology="Off", KeptComponents="Largest")
    check((labels == 2).sum() == 25 * 16, "not the largest")
    print("properties work")


def try_heart(folder):
    from lamina_images import read_image
    image, mask = (read_image(str(folder / "heart_cta" / name)) for name in ("ct.mha", "mask.mha"))
    for region in (None, mask):
        options = {"Mask": producer(region)} if region else {}
        labels, _, report = segment(image, Thresholds=[-20, 215], **options)
        before = {row["material"]: row for row in report["materialsBefore"]}
        after = {row["material"]: row for row in report["materials"]}
        print(f"heart_cta {'in its mask' if region else 'whole'}: noise {report['noise']:.1f}, islands of tissue and blood "
              f"{before[1]['components']}, {before[2]['components']} in, {after[1]['components']}, "
              f"{after[2]['components']} out; edges {report['criticalEdges']}, corners {report['criticalCorners']}, "
              f"forbidden contacts {report['forbiddenContacts']}, repaired {report['repairedVoxels']}, left "
              f"{report['faultsLeft']}, passes {report['passes']}")
        for rule in report["rules"]:
            print(f"  {rule['rule']} -> {rule['material']}: {100 * rule['voxels'] / labels.size:.3f}%")
        check(critical_blocks(labels) == 0 and report["faultsLeft"] == 0, "critical configurations are left")
        check(not has_forbidden_contact(labels, 0, 2), "blood touches background")
        check(before[1]["components"] > 20 * after[1]["components"], "islands are left")


def try_tooth(folder):
    values = np.fromfile(folder / "tooth" / "tooth.raw", ">u2").astype(np.uint16).reshape(161, 94, 103)
    image = image_of(values)
    options = {"Thresholds": [520, 950], "ForbiddenContacts": []}
    plain, _, _ = segment(image, DissolveSkins=0, **options)
    labels, _, report = segment(image, **options)
    print(f"tooth: skin voxels {skin_voxels(plain)} without and {skin_voxels(labels)} with the rule; "
          f"components {[row['components'] for row in report['materials']]}")
    with_walls = segment(image, Thresholds=[520, 950])[2]
    check("partial volume between materials 0 and 2" in str(with_walls["warnings"]), "no warning of walls on the enamel")
    check(skin_voxels(plain) > 10000 and skin_voxels(labels) < 0.001 * skin_voxels(plain), "the skin is left")
    check(critical_blocks(labels) == 0, "critical configurations are left")
    check([row["components"] for row in report["materials"]][1:] == [1, 1], "dentine or enamel fell apart")


def main():
    try_properties()
    if len(sys.argv) < 3:
        return
    folder = pathlib.Path(sys.argv[2])
    if not (folder / "heart_cta").is_dir() or not (folder / "tooth").is_dir():
        print(f"no real data in {folder}")
        sys.exit(77)
    try_heart(folder)
    try_tooth(folder)


if __name__ == "__main__":
    main()
