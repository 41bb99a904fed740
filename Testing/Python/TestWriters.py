# SPDX-License-Identifier: BSD-3-Clause
"""Every writer: its file is read back by a strict checker of the format and holds the mesh's nodes, cells, materials and sets;
and what it does with bad names, empty sets, cells it cannot hold, a full disk, no permission.  TestWriters.py [FORMAT]"""
import os
import resource
import signal
import subprocess
import sys
import tempfile

import numpy as np

import formats
import tiny
from checkers import abaqus, carp, exodus, febio, foam, gmsh, lsdyna, nastran, su2
from paraview import simple
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkFieldData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

PRISMS = {
    "Abaqus": ("mesh.inp", abaqus.read, 1e-15),
    "Gmsh": ("mesh.msh", gmsh.read, 1e-15),
    "Nastran": ("mesh.bdf", nastran.read, 1e-8),
    "LSDyna": ("mesh.k", lsdyna.read, 1e-8),
    "FEBio": ("mesh.feb", febio.read, 1e-15),
    "OpenFOAM": ("mesh.foam", foam.read, 1e-15),
    "FluidSolidExodus": ("mesh.exo", exodus.read, 1e-15),
}
failures = []


def check(condition, text):
    if not condition:
        failures.append(text)
        print("FAILED:", text, flush=True)


def write(name, proxy, path, **properties):
    """Write; returns (ok, errors, warnings)."""
    writer = getattr(simple, name + "Writer")(Input=proxy, FileName=path, **properties)
    algorithm = writer.GetClientSideObject()
    errors, warnings = [], []

    @calldata_type(VTK_STRING)
    def on_error(_, __, text):
        errors.append(text)

    @calldata_type(VTK_STRING)
    def on_warning(_, __, text):
        warnings.append(text)
    algorithm.AddObserver("ErrorEvent", on_error)
    algorithm.AddObserver("WarningEvent", on_warning)
    ok = algorithm.Write() == 1 and algorithm.GetErrorCode() == 0
    simple.Delete(writer)
    return ok, " ".join(errors), " ".join(warnings)


def same_sides(name, found, truth, title):
    check({k for k, v in found.items() if v} == set(truth), f"{title}: the sets are {sorted(found)}, not {sorted(truth)}")
    for key in set(truth) & set(found):
        a = sorted(tuple(sorted(side)) for side in found[key])
        b = sorted(tuple(sorted(side)) for side in truth[key])
        check(a == b, f"{title}: the sides of {key}: {len(a)} in the file, {len(b)} in the mesh")


def compare(name, model, truth, tolerance, scale=1.0):
    """A model read back against the mesh."""
    size = np.abs(truth.points).max()
    check(model.points.shape == truth.points.shape, f"{name}: {model.points.shape} points")
    check(np.abs(model.points - scale * truth.points).max() <= tolerance * scale * size, f"{name}: coordinates differ")
    if name != "OpenFOAM":
        check(model.counts() == truth.counts, f"{name}: cells {model.counts()}, not {truth.counts}")
        model.volumes()
        a = sorted((m, tuple(sorted(n))) for m, n in model.cells)
        b = sorted((m, tuple(sorted(n))) for m, n in truth.cells)
        check(a == b, f"{name}: cells have other nodes")
    same_sides(name, model.side_sets, truth.sides, name)
    for key, sides in truth.sides.items():
        if name != "Abaqus" and key in model.side_sets:
            own = model.vector_area(key)
            reference = formats.np.zeros(3)
            model_points, model.points = model.points, truth.points * scale
            model.side_sets["_"] = sides
            reference = model.vector_area("_")
            del model.side_sets["_"]
            model.points = model_points
            check(np.linalg.norm(own - reference) <= 1e-6 * scale ** 2 * max(1, np.linalg.norm(reference)),
                  f"{name}: {key} looks the wrong way: {own}, not {reference}")
    if model.node_sets:
        found = {k: v for k, v in model.node_sets.items() if k != "all_nodes"}
        check(found == truth.node_sets, f"{name}: node sets {sorted(found)}")
    if model.layers:
        check(model.layers == truth.layers, f"{name}: layers {model.layers}, not {truth.layers}")


def with_prisms(folder, mesh, truth):
    for name, (file, read, tolerance) in PRISMS.items():
        place = os.path.join(folder, name)
        os.mkdir(place)
        path = os.path.join(place, file)
        ok, errors, warnings = write(name, mesh, path)
        check(ok and not errors and not warnings, f"{name}: {errors} {warnings}")
        check(not [f for f in os.listdir(place) if "unfinished" in f], f"{name}: left unfinished files")
        compare(name, read(path), truth, tolerance)
        if name == "Gmsh":
            ok, errors, _ = write(name, mesh, path, Version="2.2")
            check(ok, errors)
            compare("Gmsh 2.2", read(path), truth, tolerance)
        print("ok:", name, os.path.getsize(path), "bytes", flush=True)
    types = foam.read(os.path.join(folder, "OpenFOAM", "mesh.foam")).kinds
    check({types[n] for n in truth.sides if n.startswith("opening")} == {"patch"}, f"OpenFOAM: types {types}")
    su2_files(folder, mesh, truth)
    xdmf(folder, mesh, truth)


def su2_files(folder, mesh, truth):
    ok, errors, warnings = write("SU2", mesh, os.path.join(folder, "mesh.su2"))
    check(ok and "a file a material" in warnings, f"SU2: {errors} {warnings}")
    for material in ("tissue", "blood"):
        model = su2.read(os.path.join(folder, f"mesh_{material}.su2"))
        check(model.counts() == {"": truth.counts[material]}, f"SU2 {material}: {model.counts()}")
        model.volumes()
        expected = {n: len(s) for n, s in truth.sides.items() if material in n or (n == "epicardium" and material == "tissue")}
        check({n: len(s) for n, s in model.side_sets.items()} == expected, f"SU2 {material}: {expected}")
        total = sum((model.vector_area(n) for n in model.side_sets), np.zeros(3))
        check(np.linalg.norm(total) < 1e-9, f"SU2 {material}: its boundary is not closed, or turned: {total}")
    print("ok: SU2", flush=True)


def xdmf(folder, mesh, truth):
    """ParaView's own writer and reader of XDMF and HDF5: places, cells and their arrays, bit for bit."""
    path = os.path.join(folder, "mesh.xdmf")
    simple.Xdmf3Writer(Input=mesh, FileName=path).UpdatePipeline()
    check(os.path.isfile(os.path.join(folder, "mesh.h5")), "XDMF: no mesh.h5")
    reader = simple.Xdmf3ReaderS(FileName=[path])
    reader.UpdatePipeline()
    grid = reader.GetClientSideObject().GetOutputDataObject(0)
    check(np.array_equal(vtk_to_numpy(grid.GetPoints().GetData()), truth.points), "XDMF: the points")
    for name in ("MaterialIds", "LayerIds"):
        found, own = (g.GetCellData().GetArray(name) for g in (grid, truth.grid))
        check(found is not None and np.array_equal(vtk_to_numpy(found), vtk_to_numpy(own)), f"XDMF: {name}")
    cells = [tuple(grid.GetCell(c).GetPointId(k) for k in range(grid.GetCell(c).GetNumberOfPoints()))
             for c in range(grid.GetNumberOfCells())]
    check(cells == [nodes for _, nodes in truth.cells], "XDMF: the cells")
    print("ok: XDMF", flush=True)


def with_tetrahedra(folder, tets, truth):
    place = os.path.join(folder, "carp")
    os.mkdir(place)
    ok, errors, warnings = write("CARP", tets, os.path.join(place, "mesh.elem"))
    check(ok and "no Fibers" in warnings, f"CARP: {errors} {warnings}")
    model = carp.read(os.path.join(place, "mesh.elem"))
    model.cells = [({1: "tissue", 2: "blood"}[tag], nodes) for tag, nodes in model.cells]
    compare("CARP", model, truth, 1e-14, 1000.0)  # millimetres to micrometres
    fibers = simple.RuleBasedFibers(Input=tets)
    ok, errors, warnings = write("CARP", fibers, os.path.join(place, "fibers.elem"))
    check(ok and not warnings, f"CARP with fibres: {errors} {warnings}")
    carp.read(os.path.join(place, "fibers.elem"))
    with open(os.path.join(place, "fibers.lon"), encoding="ascii") as file:
        rows = np.array([[float(v) for v in line.split()] for line in file.read().split("\n")[1:-1]])
    lengths = np.linalg.norm(rows, axis=1)
    check(np.count_nonzero(lengths > 0.5) == truth.counts["tissue"][4], "fibres in the tissue, none in the blood")
    print("ok: CARP", flush=True)
    wall_depth(tets, truth)
    simvascular(os.path.join(folder, "mesh-complete"), tets, truth)
    for name in ("Abaqus", "Nastran", "FEBio"):
        path = os.path.join(place, PRISMS[name][0])
        ok, errors, _ = write(name, tets, path)
        check(ok, errors)
        compare(name, PRISMS[name][1](path), truth, PRISMS[name][2])


def wall_depth(tets, truth):
    """From the blood's side to the outside, in the tissue only; names that do not fit are told."""
    depth = simple.WallDepth(Input=tets, InnerWalls="1-2", OuterWalls="1-0")
    depth.UpdatePipeline()
    grid = depth.GetClientSideObject().GetOutputDataObject(0)
    cells = vtk_to_numpy(grid.GetCellData().GetArray("WallDepth"))
    points = vtk_to_numpy(grid.GetPointData().GetArray("WallDepth"))
    normals = np.linalg.norm(vtk_to_numpy(grid.GetCellData().GetArray("LayerNormals")), axis=1)
    tissue = vtk_to_numpy(grid.GetCellData().GetArray("MaterialIds")) == 1
    check(np.all(cells[~tissue] == -1) and np.all(cells <= 1), "the depth leaves its range")
    check(np.count_nonzero(cells[tissue] >= 0) > 0.5 * np.count_nonzero(tissue), "the tissue has no depth")
    check(np.allclose(normals[cells >= 0], 1) and np.all(normals[cells < 0] == 0), "LayerNormals are of length 1, or 0")
    check(points.min() == -1 and points.max() == 1 and np.any(points == 0), "the points reach both walls")
    print("ok: Wall Depth", flush=True)


def simvascular(place, tets, truth):
    os.mkdir(place)
    ok, errors, warnings = write("SimVascular", tets, os.path.join(place, "mesh-complete.mesh.vtu"))
    check(ok and "a folder a material" in warnings, f"SimVascular: {errors} {warnings}")
    for material in ("tissue", "blood"):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(os.path.join(place, material, "mesh-complete.mesh.vtu"))
        reader.Update()
        grid = reader.GetOutput()
        check(grid.GetNumberOfCells() == truth.counts[material][4], f"SimVascular: {material}")
        ids = [int(grid.GetPointData().GetArray("GlobalNodeID").GetComponent(i, 0)) - 1 for i in range(grid.GetNumberOfPoints())]
        check(all(grid.GetPoint(i) == tuple(truth.points[ids[i]]) for i in range(len(ids))), "SimVascular: GlobalNodeID")
        names = {n for n in truth.sides if material in n or (n == "epicardium" and material == "tissue")}
        found = {f[:-4] for f in os.listdir(os.path.join(place, material, "mesh-surfaces"))}
        check(found == names, f"SimVascular: {found}, not {names}")
        check(os.path.isfile(os.path.join(place, material, "walls_combined.vtp")), "SimVascular: no walls")
        for name in names:
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(os.path.join(place, material, "mesh-surfaces", name + ".vtp"))
            reader.Update()
            surface = reader.GetOutput()
            nodes = {int(surface.GetPointData().GetArray("GlobalNodeID").GetComponent(i, 0)) - 1
                     for i in range(surface.GetNumberOfPoints())}
            check(nodes == truth.node_sets[name], f"SimVascular: the nodes of {name}")
    print("ok: SimVascular", flush=True)


def doubled(folder):
    mesh, truth = formats.build(tiny.open_tube(), True, doubled=True)
    twins = [n for n in truth.sides if n.startswith("interface")]
    for name in ("Abaqus", "OpenFOAM", "FluidSolidExodus"):
        path = os.path.join(folder, PRISMS[name][0])
        ok, errors, _ = write(name, mesh, path)
        check(ok, errors)
        model = PRISMS[name][1](path)
        for key in twins:
            twin = model.side_sets.pop(key + "_twin", [])
            check(len(twin) == len(truth.sides[key]), f"{name}: {key}_twin has {len(twin)} sides")
            own = {tuple(sorted(map(tuple, model.points[list(s)]))) for s in truth.sides[key]}
            other = {tuple(sorted(map(tuple, model.points[list(s)]))) for s in twin}
            check(own == other, f"{name}: {key} and its twin do not lie in the same place")
            check(not {n for s in twin for n in s} & {n for s in truth.sides[key] for n in s}, f"{name}: nodes are shared")
            model.node_sets.pop(key + "_twin", None)
        same_sides(name, model.side_sets, truth.sides, name + " doubled")
    print("ok: doubled nodes", flush=True)


def quadratic(folder, mesh):
    cells = simple.QuadraticCells(Input=mesh)
    cells.UpdatePipeline()
    grid = cells.GetClientSideObject().GetOutputDataObject(0)
    for name in ("Gmsh", "FluidSolidExodus"):
        path = os.path.join(folder, PRISMS[name][0])
        ok, errors, _ = write(name, cells, path)
        check(ok, f"{name} quadratic: {errors}")
        model = PRISMS[name][1](path)
        check(len(model.points) == grid.GetNumberOfPoints() and len(model.cells) == grid.GetNumberOfCells(), f"{name} quadratic")
        model.volumes()
    ok, errors, _ = write("LSDyna", cells, os.path.join(folder, "quadratic.k"))
    check(not ok and "from before Quadratic Cells" in errors, f"LSDyna quadratic: {errors}")
    print("ok: quadratic", flush=True)


def by_extension(folder, mesh, tets):
    """Save Data finds the writers by the endings of names; ParaView's own formats keep theirs."""
    place = os.path.join(folder, "saved")
    os.mkdir(place)
    for ending, name in (("inp", "AbaqusWriter"), ("msh", "GmshWriter"), ("k", "LSDynaWriter"), ("feb", "FEBioWriter"),
                         ("bdf", "NastranWriter"), ("su2", "SU2Writer"), ("foam", "OpenFOAMWriter"), ("exo", "FluidSolidExodusWriter"),
                         ("elem", "CARPWriter"), ("sv", "SimVascularWriter"), ("vtu", "XMLUnstructuredGridWriter")):
        writer = simple.CreateWriter(os.path.join(place, "m." + ending), tets)
        check(type(writer).__name__ == name, f".{ending} is saved by {type(writer).__name__}, not {name}")
        simple.Delete(writer)
    simple.SaveData(os.path.join(place, "mesh-complete.sv"), proxy=tets)
    check(os.path.isfile(os.path.join(place, "blood", "mesh-complete.mesh.vtu")), f"saved as .sv: {os.listdir(place)}")
    print("ok: Save Data", flush=True)


def empty_sets(folder, mesh):
    """A patch without faces: formats that have no empty sets leave it out and say so; no file breaks."""
    grid = mesh.GetClientSideObject().GetOutputDataObject(0).NewInstance()
    grid.ShallowCopy(mesh.GetClientSideObject().GetOutputDataObject(0))
    field = vtkFieldData()
    field.DeepCopy(grid.GetFieldData())
    field.GetAbstractArray("PatchNames").InsertNextValue("nothing")
    field.GetArray("PatchKinds").InsertNextTuple1(1)
    field.GetArray("PatchMaterials").InsertNextTuple2(1, 0)
    grid.SetFieldData(field)
    source = simple.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(grid)
    for name, (file, read, _) in PRISMS.items():
        place = os.path.join(folder, "empty", name)
        os.makedirs(place)
        path = os.path.join(place, file)
        ok, errors, warnings = write(name, source, path)
        check(ok and not errors, f"{name} with an empty set: {errors}")
        check(("no empty sets" in warnings) == (name in ("Abaqus", "LSDyna")), f"{name} with an empty set: {warnings}")
        model = read(path)
        check(not model.side_sets.get("nothing"), f"{name}: the empty set has sides")
    print("ok: empty sets", flush=True)


def bad_input(folder, mesh):
    for name in ("CARP", "SimVascular"):
        ok, errors, _ = write(name, mesh, os.path.join(folder, "bad.elem"))
        check(not ok and "prisms" in errors and "run Prisms to Tetrahedra first" in errors, f"{name}: {errors}")
    ok, errors, _ = write("Abaqus", mesh, os.path.join(folder, "nowhere", "mesh.inp"))
    check(not ok and "nowhere" in errors and "No such file" in errors, f"no folder: {errors}")
    ok, errors, _ = write("Abaqus", simple.Threshold(Input=mesh, Scalars=["CELLS", "MaterialIds"], LowerThreshold=9, UpperThreshold=9),
                          os.path.join(folder, "mesh.inp"))
    check(not ok and "empty" in errors, f"empty mesh: {errors}")
    blood = simple.Threshold(Input=mesh, Scalars=["CELLS", "MaterialIds"], LowerThreshold=2, UpperThreshold=2)
    path = os.path.join(folder, "blood.inp")
    ok, errors, warnings = write("Abaqus", blood, path)
    check(ok and "found anew" in warnings, f"stale patches: {errors} {warnings}")
    check(set(abaqus.read(path).side_sets) == {"wall_blood_1"}, "a fluid without a wall has one boundary")
    long = "the left ventricular endocardium with its trabeculae " * 3
    mesh.Names = f"1=heart muscle; 2=blood; interface_heart muscle_blood_1={long}"
    mesh.UpdatePipeline()
    names = set()
    for _ in range(2):
        path = os.path.join(folder, "long.exo")
        ok, errors, warnings = write("FluidSolidExodus", mesh, path)
        check(ok and "is written as" in warnings and "30 characters" in warnings, f"long names: {errors} {warnings}")
        names |= set(exodus.read(path).side_sets)
    check(len([n for n in names if n.startswith("the_left")]) == 1 and all(len(n) <= 32 for n in names), f"stable names: {names}")
    mesh.Names = formats.NAMES
    mesh.UpdatePipeline()
    print("ok: bad input", flush=True)


def confined(folder):
    """As a process that may write 2 kB a file, and one that is nobody: both leave nothing behind."""
    result = subprocess.run([sys.executable if "pvpython" in sys.executable else "pvpython", os.path.abspath(__file__), "--full", folder],
                            text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=250)
    check(result.returncode == 0, f"full disk: {result.stdout[-2000:]}")


def full_disk(folder):
    mesh, _ = formats.build(tiny.open_tube(), True)
    tets, _ = formats.tetrahedra(mesh)
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))
    for name, (file, _, _) in {**PRISMS, "SU2": ("mesh.su2", None, 0), "CARP": ("mesh.elem", None, 0),
                               "SimVascular": ("mesh.mesh.vtu", None, 0)}.items():
        place = os.path.join(folder, "full", name)
        os.makedirs(place)
        source = tets if name in ("CARP", "SimVascular") else mesh
        ok, errors, _ = write(name, source, os.path.join(place, file))
        check(not ok and "disk is full" in errors, f"{name} on a full disk: {errors}")
        left = [f for _, _, fs in os.walk(place) for f in fs if "unfinished" in f or f == file]
        check(not left, f"{name} left {left}")
    if os.geteuid() == 0:
        os.setegid(65534)
        os.seteuid(65534)
    place = os.path.join(folder, "full")
    ok, errors, _ = write("Abaqus", mesh, os.path.join(place, "mesh.inp"))
    check(not ok and "you may write to" in errors, f"no permission: {errors}")


def main():
    if "--full" in sys.argv:
        full_disk(sys.argv[-1])
        sys.exit("failed" if failures else 0)
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        mesh, truth = formats.build(tiny.open_tube(), True)
        print("sets:", {n: len(s) for n, s in truth.sides.items()}, "cells:", truth.counts, flush=True)
        check(sum(n.startswith("opening_blood") for n in truth.sides) == 2, f"two openings: {sorted(truth.sides)}")
        check(any(n.startswith("border_tissue") for n in truth.sides), f"borders: {sorted(truth.sides)}")
        with_prisms(folder, mesh, truth)
        quadratic(folder, mesh)
        tets, tet_truth = formats.tetrahedra(mesh)
        check(set(tet_truth.sides) == set(truth.sides), "the patches of tetrahedra")
        with_tetrahedra(folder, tets, tet_truth)
        by_extension(folder, mesh, tets)
        empty_sets(folder, mesh)
        bad_input(folder, mesh)
        doubled(folder)
        confined(folder)
    if failures:
        sys.exit(f"{len(failures)} failed")


if __name__ == "__main__":
    main()
