# SPDX-License-Identifier: BSD-3-Clause
"""What programs that no one here wrote read in our files: gmsh, meshio, OpenFOAM's checkMesh, CalculiX, VTK's readers. The names
and counts of every set are compared.  TestExternal.py"""
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np

import formats
import tiny
from checkers import gmsh
from TestWriters import check, compare, failures, write
from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader

SKIPPED = 77
KINDS = {4: "tetra", 5: "pyramid", 6: "wedge"}


def run(command, folder, limit=200):
    # OpenFOAM of Debian keeps its settings beside its programs' folder, and wants to be told.
    foam = os.path.join(os.path.dirname(os.path.dirname(shutil.which("checkMesh"))), "share", "openfoam")
    environment = {"WM_PROJECT_DIR": foam, **os.environ}
    done = subprocess.run(command, env=environment, cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=limit)
    return done.returncode, done.stdout


def in_our_numbers(model, truth):
    """Programs may number nodes anew: go by their places."""
    key = lambda p: tuple(np.round(p, 9) + 0.0)  # noqa: E731
    place = {key(p): i for i, p in enumerate(truth.points)}
    ours = [place[key(p)] for p in model.points]
    check(sorted(ours) == list(range(len(truth.points))), "nodes are not where they were")
    model.points = np.array([model.points[i] for i in np.argsort(ours)])
    model.cells = [(m, tuple(ours[n] for n in nodes)) for m, nodes in model.cells]
    model.side_sets = {k: [tuple(ours[n] for n in side) for side in sides] for k, sides in model.side_sets.items()}


def with_gmsh(folder, mesh, truth):
    for version, name in (("4.1", "new.msh"), ("2.2", "old.msh")):
        ok, errors, _ = write("Gmsh", mesh, os.path.join(folder, name), Version=version)
        check(ok, errors)
        code, text = run(["gmsh", "-0", name, "-save_all", "-format", "msh22", "-o", "again.msh"], folder)
        check(code == 0 and "Error" not in text, f"gmsh {version}: {text[-800:]}")
        code, text = run(["gmsh", "-0", name, "-format", "msh22", "-o", "again.msh"], folder)
        again = gmsh.read(os.path.join(folder, "again.msh"))
        in_our_numbers(again, truth)
        compare(f"gmsh of {version}", again, truth, 1e-12)
    ok, errors, _ = write("Nastran", mesh, os.path.join(folder, "mesh.bdf"))
    code, text = run(["gmsh", "-0", "mesh.bdf", "-save_all", "-format", "msh22", "-o", "bdf.msh"], folder)
    check(code == 0 and "Error" not in text, f"gmsh of .bdf: {text[-800:]}")
    with open(os.path.join(folder, "bdf.msh"), encoding="utf-8") as file:
        rows = file.read().split("$Elements\n")[1].split("$EndElements")[0].splitlines()[1:]
    kinds = [int(row.split()[1]) for row in rows]
    tags = [int(row.split()[4]) for row in rows]
    check({k: kinds.count(k) for k in (4, 6, 7)} == {4: total(truth, 4), 6: total(truth, 6), 7: total(truth, 5)}, "gmsh of .bdf: cells")
    sides = [sum(1 for k, t in zip(kinds, tags) if t == 3 + i and k in (2, 3)) for i in range(len(truth.sides))]
    check(sorted(sides) == sorted(len(s) for s in truth.sides.values()), f"gmsh of .bdf: sets {sides}")
    print("ok: gmsh", flush=True)


def total(truth, nodes):
    return sum(counts.get(nodes, 0) for counts in truth.counts.values())


def with_meshio(folder, mesh, tets, truth, tet_truth):
    try:
        import meshio
    except ImportError:
        sys.exit(SKIPPED)
    # meshio knows no pyramids of Abaqus: tetrahedra alone.
    for name, file, source, own in (("Gmsh", "m.msh", mesh, truth), ("Nastran", "m.bdf", mesh, truth),
                                    ("Abaqus", "t.inp", tets, tet_truth), ("Nastran", "t.bdf", tets, tet_truth)):
        path = os.path.join(folder, file)
        ok, errors, _ = write(name, source, path)
        check(ok, errors)
        read = meshio.read(path)
        check(np.abs(read.points - own.points).max() < 1e-8, f"meshio: the points of {file}")
        for nodes, kind in KINDS.items():
            count = sum(len(block.data) for block in read.cells if block.type == kind)
            check(count == total(own, nodes), f"meshio: {count} {kind} in {file}, {total(own, nodes)} in the mesh")
        if name == "Abaqus":
            check({k: len(v) for k, v in read.point_sets.items() if k in own.sides} ==
                  {k: len(v) for k, v in own.node_sets.items()}, f"meshio: node sets of {file}: {list(read.point_sets)}")
            for material, counts in own.counts.items():
                check(sum(len(part) for part in read.cell_sets[material] if part is not None) == sum(counts.values()),
                      f"meshio: {material} in {file}")
        if name == "Gmsh":
            check({k for k in read.field_data} == set(own.sides) | set(own.counts), f"meshio: names {list(read.field_data)}")
            for key, (tag, dimension) in read.field_data.items():
                count = sum(int(np.count_nonzero(values == tag)) for block, values in zip(read.cells, read.cell_data["gmsh:physical"])
                            if (block.type in ("triangle", "quad")) == (dimension == 2))
                wanted = len(own.sides[key]) if dimension == 2 else sum(own.counts[key].values())
                check(count == wanted, f"meshio: {count} in {key}, {wanted} in the mesh")
    write("SU2", mesh, os.path.join(folder, "m.su2"))
    for material in truth.counts:
        read = meshio.read(os.path.join(folder, f"m_{material}.su2"))
        found = {kind: sum(len(b.data) for b in read.cells if b.type == kind) for kind in KINDS.values()}
        wanted = {kind: truth.counts[material].get(nodes, 0) for nodes, kind in KINDS.items()}
        check(found == wanted, f"meshio: {found} in {material}, {wanted} in the mesh")
        sides = sum(len(b.data) for b in read.cells if b.type in ("triangle", "quad"))
        check(sides == sum(len(s) for n, s in truth.sides.items() if material in n or (n == "epicardium" and material == "tissue")),
              f"meshio: sides of {material}")
    print("ok: meshio", flush=True)


def with_openfoam(folder, mesh, truth):
    os.mkdir(os.path.join(folder, "case"))
    path = os.path.join(folder, "case", "case.foam")
    ok, errors, _ = write("OpenFOAM", mesh, path)
    check(ok, errors)
    code, text = run(["checkMesh", "-case", os.path.join(folder, "case"), "-allTopology"], folder)
    check(code == 0 and "Mesh OK." in text, f"checkMesh: {text[-3000:]}")
    for name, sides in truth.sides.items():
        if not name.startswith("interface"):
            rows = [line.split() for line in text.splitlines() if line.split()[:1] == [name]]
            check(rows and int(rows[0][1]) == len(sides) and int(rows[0][2]) == len(truth.node_sets[name]),
                  f"checkMesh: {name}: {rows[:1]}, not {len(sides)} faces and {len(truth.node_sets[name])} points")
    check(f"cells:            {len(truth.cells)}" in text, "checkMesh: cells")
    reader = vtkOpenFOAMReader()
    reader.SetFileName(path)
    reader.SetReadZones(True)
    reader.UpdateInformation()
    reader.EnableAllPatchArrays()
    reader.Update()
    output = reader.GetOutput()
    check(output.GetBlock(0).GetNumberOfCells() == len(truth.cells), "VTK's OpenFOAM reader: cells")
    print("ok: OpenFOAM", flush=True)


def with_exodus(folder, mesh, truth):
    path = os.path.join(folder, "mesh.exo")
    ok, errors, _ = write("FluidSolidExodus", mesh, path)
    check(ok, errors)
    reader = vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    counts = {}
    for kind, sets in ((vtkExodusIIReader.ELEM_BLOCK, None), (vtkExodusIIReader.SIDE_SET, truth.sides), (vtkExodusIIReader.NODE_SET, truth.node_sets)):
        for i in range(reader.GetNumberOfObjects(kind)):
            reader.SetObjectStatus(kind, i, 1)
            # The reader adds what kind of object it is, and its id, to the name.
            name = reader.GetObjectName(kind, i).split(" ")[0]
            counts[kind, name] = reader.GetNumberOfEntriesInObject(kind, i)
        if sets is not None:
            found = {name: n for (k, name), n in counts.items() if k == kind}
            check(found == {name: len(s) for name, s in sets.items()}, f"VTK's Exodus reader: {found}")
    blocks = {name: n for (k, name), n in counts.items() if k == vtkExodusIIReader.ELEM_BLOCK}
    check(blocks == {"tissue": truth.counts["tissue"][4], "blood": truth.counts["blood"][4], "blood_w": truth.counts["blood"][6],
                     "blood_p": truth.counts["blood"][5]}, f"VTK's Exodus reader: {blocks}")
    reader.Update()
    cells = reader.GetOutput().GetBlock(0)
    check(sum(cells.GetBlock(i).GetNumberOfCells() for i in range(cells.GetNumberOfBlocks())) == len(truth.cells), "Exodus: cells")
    print("ok: Exodus", flush=True)


CCX = """*INCLUDE, INPUT=mesh.inp
*MATERIAL, NAME=soft
*ELASTIC
1., .3
*SOLID SECTION, ELSET=tissue, MATERIAL=soft
*SOLID SECTION, ELSET=blood, MATERIAL=soft
*BOUNDARY
border_tissue_1, 1, 3
*STEP
*STATIC
*DSLOAD
epicardium_faces, P, 0.001
{prints}*END STEP
"""


def with_calculix(folder, tets, truth):
    place = os.path.join(folder, "ccx")
    os.mkdir(place)
    ok, errors, _ = write("Abaqus", tets, os.path.join(place, "mesh.inp"))
    check(ok, errors)
    names = sorted(truth.sides)
    prints = "".join(f"*NODE PRINT, NSET={name}\nU\n" for name in names)
    with open(os.path.join(place, "run.inp"), "w", encoding="ascii") as file:
        file.write(CCX.format(prints=prints))
    code, text = run(["ccx", "run"], place)
    check(code == 0 and "Job finished" in text and "ERROR" not in text, f"ccx: {text[-2000:]}")
    sizes = {}
    with open(os.path.join(place, "run.dat"), encoding="ascii") as file:
        for line in file:
            words = line.split()
            if line.strip().startswith("displacements"):
                name = line.split("set ")[1].split(" ")[0]
                sizes[name] = 0
            elif len(words) == 4:
                sizes[name] += 1
                check(all(np.isfinite(float(w)) for w in words), f"ccx: {line}")
    check(sizes == {name.upper(): len(nodes) for name, nodes in truth.node_sets.items()}, f"ccx: sets {sizes}")
    print("ok: CalculiX", flush=True)


def main():
    missing = [program for program in ("gmsh", "checkMesh", "ccx") if not shutil.which(program)]
    if missing:
        print("skipped, not installed:", ", ".join(missing), "(Utilities/install-dependencies.sh --all)")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        mesh, truth = formats.build(tiny.open_tube(), True)
        tets, tet_truth = formats.tetrahedra(mesh)
        with_gmsh(folder, mesh, truth)
        with_meshio(folder, mesh, tets, truth, tet_truth)
        with_openfoam(folder, mesh, truth)
        with_exodus(folder, mesh, truth)
        with_calculix(folder, tets, tet_truth)
    if failures:
        sys.exit(f"{len(failures)} failed")


if __name__ == "__main__":
    main()
