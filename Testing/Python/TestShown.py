# SPDX-License-Identifier: BSD-3-Clause
"""Whole runs of Utilities/mesh.sh held against the project's promises: TestShown.py ROOT CASE [SHARED_DATA].

CASE: phantom (Resolution 120), scan (a CT of a heart), mickey (five labels), materials (our own four-material phantom),
open (the phantom's vessels leave through the border)."""
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter, vtkXMLPolyDataReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

SKIPPED = 77


def read(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def mesh(root, folder, image, *options):
    output = os.path.join(folder, "out")
    command = [os.path.join(root, "Utilities", "mesh.sh"), image, "--output", output, *options]
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=900)
    print(done.stdout)
    assert done.returncode == 0, f"mesh.sh ended with {done.returncode}"
    with open(os.path.join(output, "report.json"), encoding="utf-8") as file:
        report = json.load(file)
    return output, report


def check_faces(output):
    """Independently of the audit: every triangle between solid and fluid has one cell on each side, with shared ids."""
    grid = read(vtkXMLUnstructuredGridReader(), os.path.join(output, "mesh.vtu"))
    cells = grid.GetCells()
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    nodes = vtk_to_numpy(cells.GetConnectivityArray())
    types = vtk_to_numpy(grid.GetCellTypesArray())
    materials = vtk_to_numpy(grid.GetCellData().GetArray("MaterialIds"))
    faces = {10: [(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)], 13: [(0, 1, 2), (3, 5, 4)],
             14: [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]}
    keys, owners = [], []
    for kind, corners in faces.items():
        chosen = np.flatnonzero(types == kind)
        for face in corners:
            keys.append(np.sort(nodes[offsets[chosen][:, None] + np.array(face)], axis=1))
            owners.append(materials[chosen])
    keys, owners = np.concatenate(keys).astype(np.int64), np.concatenate(owners)
    unique, inverse, counts = np.unique(keys, axis=0, return_inverse=True, return_counts=True)
    assert counts.max() <= 2, "a face of more than two cells"
    order = np.argsort(inverse.ravel(), kind="stable")
    first = np.concatenate([[0], np.cumsum(counts)[:-1]])[counts == 2]
    pairs = np.stack([owners[order[first]], owners[order[first + 1]]], axis=1)
    between = int((pairs[:, 0] != pairs[:, 1]).sum())
    surface = read(vtkXMLPolyDataReader(), os.path.join(output, "surface.vtp"))
    labels = vtk_to_numpy(surface.GetCellData().GetArray("BoundaryLabels"))
    wanted = int((labels.min(axis=1) > 0).sum())
    assert between == wanted, f"{between} faces between materials, but {wanted} interface triangles"
    points = vtk_to_numpy(grid.GetPoints().GetData())
    assert len(np.unique(points, axis=0)) == len(points), "points that lie on each other"
    return grid


def check(report, full=True):
    audit = report["audit"]
    assert audit["passed"] and audit["invertedCells"] == 0 and audit["overlaps"] == 0, audit["findings"]
    assert audit["largestVolumeError"] < 1e-9, audit["largestVolumeError"]
    smoothing = next(s for s in report["stages"] if s["stage"] == "Volume-Conserving Smoothing")
    assert smoothing["report"]["largestVolumeChange"] < 1e-10, smoothing
    for material in report["materials"]:
        assert material["tetAboveGate"] >= 0.995, material
        assert material["wedgeQualityMin"] > 0, material
        if full:
            assert material["cells"]["pyramids"] == 0, material


def phantom(root, folder, resolution, *options):
    image = os.path.join(folder, "phantom.vti")
    script = os.path.join(root, "Examples", "heart_phantom.py")
    subprocess.run(["pvpython", script, image, "--resolution", str(resolution), *options], check=True, timeout=300)
    return image


def case_phantom(root, folder, _):
    output, report = mesh(root, folder, phantom(root, folder, 120))
    check(report)
    check_faces(output)
    assert report["cells"] >= 500000, report["cells"]
    assert {m["material"]: m["components"] for m in report["materials"]} == {1: 1, 2: 4}, report["materials"]


def case_scan(root, folder, data):
    scan = os.path.join(data, "heart_cta")
    output, report = mesh(root, folder, os.path.join(scan, "ct.mha"), "--mask", os.path.join(scan, "mask.mha"),
                          "--thresholds=-20,215")
    check(report)
    check_faces(output)


def case_mickey(root, folder, data):
    output, report = mesh(root, folder, os.path.join(data, "cleaver_tests", "mickey.nrrd"), "--labels")
    check(report)
    check_faces(output)
    assert sorted(m["material"] for m in report["materials"]) == [1, 2, 3, 4, 5], report["materials"]


def four_materials(path):
    """A ball of three sectors with a vessel through them: up to four materials and background meet."""
    size = 36
    k, j, i = np.mgrid[0:size, 0:size, 0:size] - (size - 1) / 2
    angle = np.arctan2(j, i)
    sector = np.where(angle < -1, 1, np.where(angle < 1, 3, 4))
    labels = np.where(i**2 + j**2 + k**2 < 14**2, sector, 0)
    labels[((i - 3)**2 + (j - 2)**2 < 3.2**2) & (np.abs(k) < 8)] = 2
    image = vtkImageData()
    image.SetDimensions(size, size, size)
    image.SetSpacing(0.5, 0.5, 0.5)
    array = numpy_to_vtk(labels.astype(np.int32).ravel(), deep=1)
    array.SetName("Labels")
    image.GetPointData().SetScalars(array)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    assert writer.Write() == 1
    return {m: int((labels == m).sum()) for m in (1, 2, 3, 4)}


def case_materials(root, folder, _):
    image = os.path.join(folder, "labels.vti")
    counts = four_materials(image)
    output, report = mesh(root, folder, image, "--labels", "--solid", "1,3,4", "--fluid", "2", "--scale", "0.001")
    check(report)
    check_faces(output)
    for material in report["materials"]:
        volume = counts[material["material"]] * (0.5 * 0.001)**3
        assert abs(material["meshVolume"] / volume - 1) < 0.005, (material, volume)


def case_open(root, folder, _):
    image = phantom(root, folder, 72, "--open")
    output, report = mesh(root, folder, image, "--open-border", "image")
    check(report, full=False)
    check_faces(output)
    surface = read(vtkXMLPolyDataReader(), os.path.join(output, "surface.vtp"))
    names = surface.GetFieldData().GetAbstractArray("PatchNames")
    openings = [p for p in range(names.GetNumberOfValues()) if names.GetValue(p).startswith("opening_")]
    assert openings, "no opening"
    patches = vtk_to_numpy(surface.GetCellData().GetArray("PatchIds"))
    labels = vtk_to_numpy(surface.GetCellData().GetArray("BoundaryLabels"))
    points = vtk_to_numpy(surface.GetPoints().GetData())
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    for p in openings:
        chosen = patches == p
        assert (labels[chosen] == (2, 0)).all(), "an opening that is not the blood's end"
        spread = np.ptp(points[np.unique(corners[chosen])], axis=0)
        assert spread.min() < 1e-9 * spread.max(), f"opening {p} is not plane: {spread}"


def main():
    root, case = sys.argv[1:3]
    data = sys.argv[3] if len(sys.argv) > 3 else ""
    if case in ("scan", "mickey") and not os.path.isdir(data):
        print(f"skipped: no shared data in '{data}' (LAMINA_SHARED_DATA)")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        globals()["case_" + case](root, folder, data)
    print("all holds")


if __name__ == "__main__":
    main()
