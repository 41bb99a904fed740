# SPDX-License-Identifier: BSD-3-Clause
"""A broken mesh of each kind is caught and named by Mesh Audit, with the surface and without; figures against image and sizes.
With the sources as argument also the command lamina-audit."""
import json
import os
import subprocess
import sys
import tempfile

import formats
import numpy as np
import tiny
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

failures = []


def check(condition, text):
    if not condition:
        failures.append(text)
        print("FAILED:", text, flush=True)


def producer(data):
    source = simple.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def audit(grid, **inputs):
    stage = simple.MeshAudit(Input=producer(grid), **inputs)
    stage.UpdatePipeline()
    algorithm = stage.GetClientSideObject()
    report = json.loads(algorithm.GetReportAsJSON())
    flags = vtk_to_numpy(algorithm.GetOutputDataObject(0).GetCellData().GetArray("MeshingFlags"))
    return report, flags, algorithm.GetOutputDataObject(1)


def copy(grid):
    other = vtkUnstructuredGrid()
    other.DeepCopy(grid)
    return other


def cells_of(grid):
    types = vtk_to_numpy(grid.GetCellTypesArray())
    ids = []
    for c in range(grid.GetNumberOfCells()):
        points = grid.GetCell(c).GetPointIds()
        ids.append([points.GetId(i) for i in range(points.GetNumberOfIds())])
    return types.tolist(), ids


def rebuild(grid, types, cells, points, data, keep_field=True):
    """A grid of these cells with the arrays of cells as lists."""
    other = vtkUnstructuredGrid()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    other.SetPoints(places)
    for kind, ids in zip(types, cells):
        other.InsertNextCell(kind, len(ids), ids)
    for name, values in data.items():
        array = numpy_to_vtk(np.asarray(values, np.int32), deep=True)
        array.SetName(name)
        other.GetCellData().AddArray(array)
    if keep_field:
        other.GetFieldData().ShallowCopy(grid.GetFieldData())
    return other


def expect(name, report, flags, words, flagged=True):
    findings = "; ".join(report["findings"])
    check(not report["passed"], f"{name} passes")
    for word in words:
        check(word in findings, f"{name}: '{word}' is not said: {findings[:600]}")
    check(not flagged or (flags & 0xfd).any(), f"{name}: no cell is flagged")
    print("caught:", name, "|", findings[:160], flush=True)


def parts(grid):
    types, cells = cells_of(grid)
    points = vtk_to_numpy(grid.GetPoints().GetData()).copy()
    data = {name: vtk_to_numpy(grid.GetCellData().GetArray(name)).tolist() for name in ("MaterialIds", "LayerIds")}
    return types, cells, points, data


def inverted(grid):
    types, cells, points, data = parts(grid)
    victim = types.index(VTK_TETRA)
    cells[victim][0], cells[victim][1] = cells[victim][1], cells[victim][0]
    return rebuild(grid, types, cells, points, data)


def doubled_cell(grid):
    types, cells, points, data = parts(grid)
    victim = types.index(VTK_TETRA)
    types.append(VTK_TETRA)
    cells.append(list(cells[victim]))
    for values in data.values():
        values.append(values[victim])
    return rebuild(grid, types, cells, points, data)


def gap(grid, width=1e-9):
    """One cell goes by a copy of a node that it shares, a hair away."""
    types, cells, points, data = parts(grid)
    inner = [i for i, k in enumerate(types) if k == VTK_TETRA and data["MaterialIds"][i] == 1]
    victim = inner[len(inner) // 2]
    points = np.vstack([points, points[cells[victim][0]] + [width, 0, 0]])
    cells[victim][0] = len(points) - 1
    return rebuild(grid, types, cells, points, data)


def hanging(grid):
    """One tetrahedron is cut in two by the middle of an edge; its neighbours are not."""
    types, cells, points, data = parts(grid)
    victim = next(i for i, k in enumerate(types) if k == VTK_TETRA and data["MaterialIds"][i] == 1)
    a, b, c, d = cells[victim]
    points = np.vstack([points, 0.5 * (points[a] + points[b])])
    middle = len(points) - 1
    cells[victim] = [middle, b, c, d]
    types.append(VTK_TETRA)
    cells.append([a, middle, c, d])
    for values in data.values():
        values.append(values[victim])
    return rebuild(grid, types, cells, points, data)


def change_patches(grid, change):
    other = copy(grid)
    faces = vtk_to_numpy(other.GetFieldData().GetArray("PatchFaces"))
    names = other.GetFieldData().GetAbstractArray("PatchNames")
    numbers = {names.GetValue(i): i for i in range(names.GetNumberOfValues())}
    change(faces, numbers)
    return other


def swap(a, b):
    def change(faces, numbers):
        first, second = faces[:, 2] == numbers[a], faces[:, 2] == numbers[b]
        faces[first, 2], faces[second, 2] = numbers[b], numbers[a]
    return change


def move_one(faces, numbers):
    """A face of the wall goes to a plane end of the same material."""
    faces[np.flatnonzero(faces[:, 2] == numbers["epicardium"])[0], 2] = numbers["border_tissue_1"]


def lose_one(faces, numbers):
    """A row names another cell's face: one is missing, one is not there."""
    faces[np.flatnonzero(faces[:, 2] == numbers["epicardium"])[0], 1] ^= 1


def broken(mesh, surface):
    grid = mesh.GetClientSideObject().GetOutputDataObject(0)
    for title, inputs in (("with the surface", {"Surface": surface}), ("alone", {})):
        report, _, _ = audit(grid, **inputs)
        check(report["passed"], f"a sound mesh {title}: {report['findings']}")
        expect(f"inverted cell {title}", *audit(inverted(grid), **inputs)[:2], ["cells are inverted"])
        expect(f"duplicated cell {title}", *audit(doubled_cell(grid), **inputs)[:2], ["cells are there twice"])
        expect(f"gap of 1e-9 {title}", *audit(gap(grid), **inputs)[:2], ["there is a gap"])
        expect(f"hanging node {title}", *audit(hanging(grid), **inputs)[:2], ["nodes hang on a face or an edge"])
        expect(f"wall and border swapped {title}", *audit(change_patches(grid, swap("epicardium", "border_tissue_1")), **inputs)[:2],
               ["a patch is swapped" if inputs else "is not plane"], bool(inputs))
        expect(f"opening and interface swapped {title}",
               *audit(change_patches(grid, swap("opening_blood_1", "interface_tissue_blood_1")), **inputs)[:2], ["a patch is swapped"])
        expect(f"a face in the wrong patch {title}", *audit(change_patches(grid, move_one), **inputs)[:2],
               ["a patch is swapped" if inputs else "is not plane"], bool(inputs))
        expect(f"a lost face {title}", *audit(change_patches(grid, lose_one), **inputs)[:2], ["are in no patch"])
    for title, inputs in (("with the surface", {"Surface": surface}), ("alone", {})):
        expect(f"openings swapped {title}", *audit(change_patches(grid, swap("opening_blood_1", "opening_blood_2")), **inputs)[:2],
               ["they are swapped"], False)


def twins(surface_of):
    mesh, _ = formats.build(tiny.open_tube(), True, doubled=True)
    grid = mesh.GetClientSideObject().GetOutputDataObject(0)
    report, _, _ = audit(grid, Surface=surface_of(mesh))
    check(report["passed"], f"doubled nodes: {report['findings']}")
    check(report["twinMismatches"] == 0 and report["interfaceMismatches"] == 0, "doubled nodes match")
    moved = copy(grid)
    places = vtk_to_numpy(moved.GetPoints().GetData())
    pairs = vtk_to_numpy(moved.GetPointData().GetArray("TwinNodeIds"))
    places[np.flatnonzero(pairs >= 0)[0]] += [1e-12, 0, 0]
    expect("a twin that moved by 1e-12", *audit(moved)[:2], ["twin nodes of an interface"], False)


def figures(mesh, surface, image):
    grid = mesh.GetClientSideObject().GetOutputDataObject(0)
    report, _, table = audit(grid, Surface=surface, Image=producer(image))
    check(report["passed"], f"{report['findings']}")
    picture = report["image"][0]
    for row in picture["materials"]:
        error = abs(row["meshVolume"] / row["voxelVolume"] - 1)
        check(error < 0.005, f"material {row['material']}: {100 * error:.3f}% from its voxels' volume")
    for row in picture["distancesInVoxels"]:
        print("distance", row, flush=True)
        check(row["median"] < 0.5 and row["withinHalfVoxel"] > 0.9, f"distances {row}")
    print("sizes:", {k: v for k, v in report.items() if "Target" in k or k == "sizedEdges"}, flush=True)
    check(report["sizedEdges"] > 0 and report["edgesNearTarget"] > 0.5, "sizes against the field")
    blood = next(row for row in report["materials"] if row["material"] == 2)
    check({q["type"] for q in blood["qualities"]} == {"tetrahedra", "wedges", "pyramids"}, "quality by type")
    for quality in blood["qualities"]:
        check(sum(quality["histogram"]) == quality["count"], "the histogram counts every cell")
        check(quality["least"] <= quality["percentiles"][0] <= quality["percentiles"][3] <= quality["percentiles"][4], "percentiles")
    check(sum(row["count"] for row in report["layersAchieved"]) > 0, "layers achieved")
    worst = [row for row in report["worstCells"] if row["type"] == "wedges"]
    check(len(worst) == 10 and worst[0]["quality"] == next(q["least"] for q in blood["qualities"] if q["type"] == "wedges"), "worst cells")
    check(table.GetNumberOfRows() > 50, "the table")
    shifted = type(image)()
    shifted.DeepCopy(image)
    shifted.SetOrigin(3.0, 0, 0)
    report, _, _ = audit(grid, Image=producer(shifted))
    check(report["image"][0]["distancesInVoxels"][0]["median"] > 0.5, "an image that lies elsewhere is seen in the distances")


def command(root):
    """Utilities/lamina-audit on a sound mesh, on a broken one, on a surface, and on what is none."""
    script = os.path.join(root, "Utilities", "lamina-audit")
    mesh, _ = formats.build(tiny.open_tube(), True)
    grid = mesh.GetClientSideObject().GetOutputDataObject(0)
    with tempfile.TemporaryDirectory() as folder:
        files = {"sound mesh.vtu": grid, "broken.vtu": inverted(grid)}
        for name, data in files.items():
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(os.path.join(folder, name))
            writer.SetInputData(data)
            writer.Write()
        whole = mesh.Surface.GetClientSideObject().GetOutputDataObject(0)
        torn = type(whole)()
        torn.DeepCopy(whole)
        torn.BuildLinks()
        torn.DeleteCell(0)
        torn.RemoveDeletedCells()
        for name, data in (("whole.vtp", whole), ("torn.vtp", torn)):
            writer = vtkXMLPolyDataWriter()
            writer.SetFileName(os.path.join(folder, name))
            writer.SetInputData(data)
            writer.Write()
        with open(os.path.join(folder, "text.vtu"), "w", encoding="ascii") as file:
            file.write("no mesh")
        for name, code, word in (("sound mesh.vtu", 0, "passed, 0 findings"), ("broken.vtu", 1, "finding: 1 cells are inverted"),
                                 ("whole.vtp", 0, "passed, 0 findings"), ("torn.vtp", 1, "open"),
                                 ("text.vtu", 3, "cannot be read"), ("nothing.vtu", 3, "no such file"), ("mesh.stl", 3, "no such file")):
            done = subprocess.run([script, name], cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120)
            check(done.returncode == code and word in done.stdout, f"lamina-audit {name}: {done.returncode} {done.stdout[-500:]}")
            page = os.path.join(folder, name + ".audit.html")
            check(os.path.isfile(page) == (code < 3), f"lamina-audit {name}: the page")
            if code < 3:
                with open(page, encoding="utf-8") as file:
                    text = file.read()
                check((text.count("<svg") >= 4 or name.endswith(".vtp")) and ("nothing wrong" in text) == (code == 0), f"lamina-audit {name}: the page's text")
                check("http" not in text, "the page needs nothing from elsewhere")
        print("ok: lamina-audit", flush=True)


def stable():
    """The same patches under another mesh size: names, kinds, and where they are."""
    found = []
    for layers in (2, 4):
        stages = tiny.pipeline(tiny.open_tube(), True)
        stages["sized"].Layers = layers
        stages["mesh"].UpdatePipeline()
        algorithm = stages["mesh"].GetClientSideObject()
        table = algorithm.GetOutputDataObject(2)
        rows = {table.GetValueByName(r, "Name").ToString():
                [table.GetValueByName(r, name).ToDouble() for name in ("X", "Y", "Z", "Area")] for r in range(table.GetNumberOfRows())}
        found.append((algorithm.GetOutputDataObject(0).GetNumberOfCells(), rows))
    (coarse, first), (fine, second) = found
    check(fine > 1.5 * coarse, f"two mesh sizes: {coarse} and {fine} cells")
    check(list(first) == list(second) and len(first) == 6, f"{list(first)} and {list(second)}")
    for name in first:
        a, b = np.array(first[name]), np.array(second[name])
        check(np.abs(a[:3] - b[:3]).max() < 0.5 and abs(a[3] / b[3] - 1) < 0.1, f"{name} is at {a} and {b}")
    print("ok: the same patches in", coarse, "and", fine, "cells:", ", ".join(first), flush=True)


def main():
    stable()
    if len(sys.argv) > 1:
        command(sys.argv[1])
    image = tiny.open_tube()
    mesh, _ = formats.build(image, True)
    surface = mesh.Surface
    broken(mesh, surface)
    twins(lambda other: other.Surface)
    figures(mesh, surface, image)
    if failures:
        sys.exit(f"{len(failures)} failed")


if __name__ == "__main__":
    main()
