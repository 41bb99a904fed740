#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One label image meshed by this project and by others, in one run: elements a second, memory, quality, volumes, components.

    pvpython ComparePeers.py IMAGE [--work FOLDER] [-- OPTIONS OF mesh.sh]

IMAGE: what mesh.sh takes, or a resolution of the heart phantom. Beside it, each with the mean edge of our interfaces: CGAL's
Mesh_3 on the same labels (its size is found by trial runs, which do not count), TetGen alone and Gmsh's HXT on our refined surface. The
programs: ninja -C build/release MeshByCgal MeshByTetGen; Gmsh with its Python module (python3-gmsh). What is not there is left
out with a line. Seconds of others are of whole processes, files read and written; ours are of the stages without reading, audit
and writing. Image, surfaces and meshes lie in the work folder.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
from scipy.ndimage import label
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Python"))
from WriteFigures import measure, table  # noqa: E402

FACES = ((1, 2, 3), (0, 2, 3), (0, 1, 3), (0, 1, 2))
EDGES = ((0, 1), (0, 2), (1, 2))


def load(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


# What is measured ---------------------------------------------------------------------------------------------------------

def shapes(points, tets):
    """Volumes, and 3 r/R of each tetrahedron."""
    a, b, c, d = (points[tets[:, k]] for k in range(4))
    u, v, w = b - a, c - a, d - a
    volume = np.einsum("ij,ij->i", np.cross(u, v), w) / 6
    areas = sum(0.5 * np.linalg.norm(np.cross(p, q), axis=1) for p, q in ((u, v), (u, w), (v, w), (v - u, w - u)))
    lengths = [np.linalg.norm(e, axis=1) for e in (u, v, w, w - v, w - u, v - u)]
    p, q, r = (lengths[k] * lengths[k + 3] for k in range(3))
    root = np.sqrt(np.maximum(0, (p + q + r) * (-p + q + r) * (p - q + r) * (p + q - r)))
    with np.errstate(divide="ignore", invalid="ignore"):
        quality = 3 * (3 * np.abs(volume) / areas) / (root / (24 * np.abs(volume)))
    return volume, np.nan_to_num(quality)


def faces_of(tets):
    """Every face of every tetrahedron with sorted corners, and which tetrahedra share each."""
    faces = np.sort(np.concatenate([tets[:, f] for f in FACES]), axis=1)
    order = np.lexsort(faces.T)
    same = (faces[order][1:] == faces[order][:-1]).all(axis=1)
    owner = np.tile(np.arange(len(tets)), 4)[order]
    return faces[order], owner, same


def figures(points, tets, materials, voxels):
    """Of a mesh of tetrahedra. `voxels`: by material, the volume of the voxels and their number of components."""
    volume, quality = shapes(points, tets)
    faces, owner, same = faces_of(tets)
    one, two = owner[:-1][same], owner[1:][same]
    inner = materials[one] == materials[two]
    count, piece = connected_components(coo_matrix((np.ones(inner.sum()), (one[inner], two[inner])), shape=(len(tets),) * 2))
    # Triangles between materials, or at the outside.
    single = np.ones(len(faces), dtype=bool)
    single[:-1] &= ~same
    single[1:] &= ~same
    border = np.concatenate([faces[single], faces[:-1][same][~inner]])
    edge = np.mean([np.linalg.norm(points[border[:, i]] - points[border[:, j]], axis=1).mean() for i, j in EDGES])
    error, lost = 0.0, 0
    for material, (amount, components) in voxels.items():
        own = materials == material
        error = max(error, abs(np.abs(volume[own]).sum() / amount - 1))
        lost += max(0, components - len(np.unique(piece[own])))
    return {"cells": len(tets), "least": quality.min(), "mean": quality.mean(), "poor": int((quality <= 0.1).sum()), "edge": edge,
            "error": error, "lost": lost}


def voxels_of(image):
    labels = vtk_to_numpy(image.GetPointData().GetArray("MaterialIds")).reshape(image.GetDimensions()[::-1])
    one = float(np.prod(image.GetSpacing()))
    # Contacts over edges and corners are none, as in the surface.
    return {int(m): (one * np.count_nonzero(labels == m), label(labels == m)[1]) for m in np.unique(labels) if m > 0}


# The programs -------------------------------------------------------------------------------------------------------------

#: Starts a command and tells its peak memory in kB. A small process between, as the kernel counts what the caller holds
#: at the start for the child's.
STARTER = """
import os, subprocess, sys
child = subprocess.Popen(sys.argv[1:])
_, status, usage = os.wait4(child.pid, 0)
print("peak", usage.ru_maxrss)
sys.exit(status != 0)
"""


def timed(command):
    """Seconds, peak memory in MB; None for seconds if it failed."""
    if not os.path.exists(command[0]):
        raise FileNotFoundError(2, "not there", str(command[0]))
    since = time.monotonic()
    done = subprocess.run(["/usr/bin/python3", "-c", STARTER, *map(str, command)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    seconds = time.monotonic() - since
    if done.returncode != 0:
        print(f"{command[0]} failed: {done.stdout.strip()[-300:]}", flush=True)
        return None, 0
    return seconds, int(done.stdout.split()[-1]) / 1024


def read_peer(path):
    with open(path, "rb") as file:
        points, tets = np.fromfile(file, np.int64, 2)
        return (np.fromfile(file, np.float64, 3 * points).reshape(-1, 3), np.fromfile(file, np.int64, 4 * tets).reshape(-1, 4),
                np.fromfile(file, np.int32, tets))


def write_labels(image, path):
    with open(path, "wb") as file:
        np.array(image.GetDimensions(), dtype=np.int64).tofile(file)
        np.array(image.GetSpacing(), dtype=np.float64).tofile(file)
        vtk_to_numpy(image.GetPointData().GetArray("MaterialIds")).astype(np.int32).tofile(file)


def write_surface(surface, path):
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).astype(np.int64).reshape(-1, 3)
    with open(path, "wb") as file:
        np.array([surface.GetNumberOfPoints(), len(triangles)], dtype=np.int64).tofile(file)
        vtk_to_numpy(surface.GetPoints().GetData()).astype(np.float64).tofile(file)
        triangles.tofile(file)
        vtk_to_numpy(surface.GetCellData().GetArray("BoundaryLabels")).astype(np.int32).tofile(file)


def ours(image, options, folder, voxels_for):
    report, why = measure(str(ROOT), folder, image, options)
    if report is None:
        sys.exit(f"mesh.sh failed: {why}")
    out = pathlib.Path(folder, "out")
    labels = load(vtkXMLImageDataReader(), out / "labels.vti")
    surface = load(vtkXMLPolyDataReader(), out / "surface.vtp")
    voxels_for.update(voxels_of(labels))
    grid = load(vtkXMLUnstructuredGridReader(), out / "mesh.vtu")
    points = vtk_to_numpy(grid.GetPoints().GetData())
    types = vtk_to_numpy(grid.GetCellTypesArray())
    starts = vtk_to_numpy(grid.GetCells().GetOffsetsArray())[:-1][types == 10]
    nodes = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    volume, quality = shapes(points, np.stack([nodes[starts + k] for k in range(4)], axis=1))
    corners = vtk_to_numpy(surface.GetPoints().GetData())
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    edge = np.mean([np.linalg.norm(corners[triangles[:, i]] - corners[triangles[:, j]], axis=1).mean() for i, j in EDGES])
    made = {material["material"]: material for material in report["materials"]}
    stages = [stage for stage in report["stages"] if stage["stage"] not in ("Reading", "Mesh Audit", "Writing")]
    row = {"cells": report["cells"], "least": quality.min(), "mean": quality.mean(), "poor": int((quality <= 0.1).sum()),
           "edge": edge, "error": max(abs(made[m]["meshVolume"] / amount - 1) for m, (amount, _) in voxels_for.items()),
           "lost": sum(max(0, pieces - made[m]["components"]) for m, (_, pieces) in voxels_for.items()),
           "seconds": sum(stage["seconds"] for stage in stages), "memory": max(stage["peakMemoryMB"] for stage in stages)}
    volume_stages = [s["seconds"] for s in stages if s["stage"] in ("Layered Tetrahedra", "Prism Layer", "Core Tetrahedra")]
    return row, dict(row, seconds=sum(volume_stages)), labels, surface


def peer(command, output, voxels):
    seconds, memory = timed(command)
    if seconds is None:
        return None
    return dict(figures(*read_peer(output), voxels), seconds=seconds, memory=memory)


def cgal(program, labels, folder, edge, voxels):
    """The size at which its interfaces have our mean edge, to a twentieth."""
    size, row = 0.75 * edge, None
    for _ in range(4):
        row = peer([program, labels, folder / "cgal.tets", f"size={size!r}"], folder / "cgal.tets", voxels)
        if row is None or abs(row["edge"] / edge - 1) < 0.05:
            break
        size *= edge / row["edge"]
    return row


def tell(name, row):
    return [name, f"{row['cells']:,}", f"{row['seconds']:.1f}", f"{row['cells'] / row['seconds']:,.0f}", f"{row['memory']:,.0f}",
            f"{row['edge']:.3f}", f"{row['least']:.4f}", f"{row['mean']:.3f}", f"{row['poor']:,}", f"{100 * row['error']:.4f} %", row["lost"]]


def main():
    parser = argparse.ArgumentParser(description="Ours and others on one label image.")
    parser.add_argument("image", help="an image, or a resolution of the phantom")
    parser.add_argument("--work", help="folder for images, surfaces and meshes (a scratch folder)")
    parser.add_argument("options", nargs="*", help="of mesh.sh, after --")
    asked = parser.parse_args()
    build = pathlib.Path(os.environ.get("LAMINA_BUILD_DIR", ROOT / "build" / "release"))
    os.environ.setdefault("LAMINA_PLUGIN", str(next(build.glob("lib/**/Lamina.so"))))
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(asked.work or scratch)
        folder.mkdir(parents=True, exist_ok=True)
        image = int(asked.image) if asked.image.isdigit() else os.path.abspath(asked.image)
        voxels = {}
        whole, volumes, labels, surface = ours(image, asked.options, str(folder), voxels)
        write_labels(labels, folder / "image.labels")
        write_surface(surface, folder / "surface.triangles")
        programs = build / "Testing" / "Benchmarks"
        triangles = folder / "surface.triangles"
        rows = [tell("Lamina, from the image", whole)]
        for name, run in (
                ("CGAL Mesh_3, from the labels",
                 lambda: cgal(programs / "MeshByCgal", folder / "image.labels", folder, whole["edge"], voxels)),
                ("Lamina, volume stages", lambda: volumes),
                ("TetGen, from our surface", lambda: peer([programs / "MeshByTetGen", triangles, folder / "tetgen.tets"],
                                                          folder / "tetgen.tets", voxels)),
                ("Gmsh HXT, from our surface", lambda: peer(["/usr/bin/python3", ROOT / "Testing/Benchmarks/MeshByGmsh.py", triangles,
                                                             folder / "gmsh.tets"], folder / "gmsh.tets", voxels))):
            try:
                row = run()
            except FileNotFoundError as missing:
                print(f"{name}: left out, as {missing.filename} is not there", flush=True)
                continue
            if not row:
                continue
            rows.append(tell(name, row))
            print("done:", rows[-1], flush=True)
            if name.endswith("our surface"):
                before = whole["seconds"] - volumes["seconds"]
                rows.append(tell(name.split(",")[0] + ", with our surface stages", dict(row, seconds=row["seconds"] + before)))
        print("\n".join(table(["", "cells", "seconds", "cells a second", "memory, MB", "mean edge", "least 3r/R", "mean", "at most 0.1",
                               "largest volume error", "components lost"], rows)))


if __name__ == "__main__":
    main()
