# SPDX-License-Identifier: BSD-3-Clause
"""The same fluid meshed by Gmsh: its boundary's triangles, filled with tetrahedra by a program that no one here wrote."""
import os

import numpy as np

SCRIPT = """Merge "boundary.msh";
CreateTopology;
Surface Loop(1) = Surface{{:}};
Volume(1) = {{1}};
Physical Volume("fluid") = {{1}};
Mesh.MeshSizeExtendFromBoundary = 1;
Mesh.Optimize = 1;
Mesh 3;
{refine}Mesh.MshFileVersion = 2.2;
Save "fluid.msh";
"""


def write_boundary(path, points, triangles, patch_of, names):
    """Gmsh 2.2: each patch a surface of its own with a physical name."""
    with open(path, "w", encoding="ascii") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n")
        file.write(f"{len(names)}\n" + "".join(f'2 {n + 1} "{name}"\n' for n, name in enumerate(names)) + "$EndPhysicalNames\n")
        file.write(f"$Nodes\n{len(points)}\n" + "".join(f"{i + 1} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(points.tolist())))
        file.write(f"$EndNodes\n$Elements\n{len(triangles)}\n")
        for i, (a, b, c) in enumerate((triangles + 1).tolist()):
            file.write(f"{i + 1} 2 2 {patch_of[i] + 1} {patch_of[i] + 1} {a} {b} {c}\n")
        file.write("$EndElements\n")


def case(folder, points, triangles, patch_of, names, run, refined):
    """A polyMesh in `folder`; returns the text that the programs said."""
    used = np.unique(triangles)
    numbers = np.full(len(points), -1)
    numbers[used] = np.arange(len(used))
    write_boundary(os.path.join(folder, "boundary.msh"), points[used], numbers[triangles], patch_of, names)
    with open(os.path.join(folder, "fluid.geo"), "w", encoding="ascii") as file:
        file.write(SCRIPT.format(refine="RefineMesh;\n" * refined))
    code, text = run(["gmsh", "-", "fluid.geo"], folder)
    assert code == 0 and os.path.isfile(os.path.join(folder, "fluid.msh")), text[-1500:]
    code, more = run(["gmshToFoam", "fluid.msh", "-case", folder], folder)
    assert code == 0 and "End" in more, more[-1500:]
    return text + more
