# SPDX-License-Identifier: BSD-3-Clause
"""The formats of solvers that `--export` writes beside mesh.vtu."""
import os

# name: (writer, file, properties, whether it needs tetrahedra)
FORMATS = {
    "abaqus": ("AbaqusWriter", "mesh.inp", {}, False),
    "carp": ("CARPWriter", "carp/mesh.elem", {}, True),
    "exodus": ("FluidSolidExodusWriter", "mesh.exo", {}, False),
    "febio": ("FEBioWriter", "mesh.feb", {}, False),
    "gmsh": ("GmshWriter", "mesh.msh", {}, False),
    "gmsh22": ("GmshWriter", "mesh-2.2.msh", {"Version": "2.2"}, False),
    "lsdyna": ("LSDynaWriter", "mesh.k", {}, False),
    "nastran": ("NastranWriter", "mesh.bdf", {}, False),
    "openfoam": ("OpenFOAMWriter", "openfoam/mesh.foam", {}, False),
    "simvascular": ("SimVascularWriter", "mesh-complete/mesh-complete.mesh.vtu", {}, True),
    "su2": ("SU2Writer", "mesh.su2", {}, False),
    "xdmf": ("Xdmf3Writer", "mesh.xdmf", {}, False),
}


def export(pipeline, grid, names):
    """Write the mesh in each format into the pipeline's folder of unfinished results."""
    from paraview import simple  # here: the names are needed before ParaView is
    from lamina_pipeline import Failed, producer
    whole = producer(grid)
    tets = None
    for name in names:
        writer, file, properties, needs_tets = FORMATS[name]
        source = whole
        if needs_tets:
            if tets is None:
                tets = simple.PrismstoTetrahedra(Input=whole)
                pipeline.run_stage("Prisms to Tetrahedra", tets)
            print(f"  {name} holds tetrahedra only: prisms and pyramids are cut")
            source = tets
        pipeline.begin(f"Export {name}")
        path = os.path.join(pipeline.scratch, file)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        proxy = getattr(simple, writer)(Input=source, FileName=path, **properties)
        pipeline.update(proxy)
        if not any(files for _, _, files in os.walk(os.path.dirname(path))):
            raise Failed(pipeline.stage, f"{file} could not be written; is the disk full?")
        pipeline.end()
