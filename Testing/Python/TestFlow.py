# SPDX-License-Identifier: BSD-3-Clause
"""OpenFOAM's potentialFoam and icoFoam on the blood of a tube that leaves the image at both ends: what flows in flows out, nothing
through the wall.  TestFlow.py"""
import os
import re
import shutil
import sys
import tempfile

import tiny
from checkers import foam
from paraview import simple
from TestExternal import SKIPPED, run
from TestWriters import check, failures, write

HEAD = "FoamFile {{ version 2.0; format ascii; class {0}; object {1}; }}\n"
CONTROL = """application icoFoam; startFrom startTime; startTime 0; stopAt endTime; endTime {end}; deltaT {step};
writeControl timeStep; writeInterval {every}; writeFormat ascii; writePrecision 15; timePrecision 8;
"""
SCHEMES = """ddtSchemes { default Euler; } gradSchemes { default Gauss linear; } divSchemes { default none; div(phi,U) Gauss upwind; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }
"""
SOLUTION = """solvers { "(p|pFinal|Phi)" { solver GAMG; smoother GaussSeidel; tolerance 1e-13; relTol 0; }
U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-12; relTol 0; } }
potentialFlow { nNonOrthogonalCorrectors 10; } PISO { nCorrectors 3; nNonOrthogonalCorrectors 3; pRefCell 0; pRefValue 0; }
"""


def put(folder, name, kind, text):
    os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
    with open(os.path.join(folder, name), "w", encoding="ascii") as file:
        file.write(HEAD.format(kind, os.path.basename(name)) + text)


def fields(folder, wall, inlet, outlet, at_wall):
    put(folder, "0/U", "volVectorField",
        f"dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField {{ {wall} {{ {at_wall} }}\n"
        f"{inlet} {{ type surfaceNormalFixedValue; refValue uniform -1; value uniform (0 0 0); }}\n"
        f"{outlet} {{ type zeroGradient; }} }}\n")
    put(folder, "0/p", "volScalarField",
        f"dimensions [0 2 -2 0 0 0 0]; internalField uniform 0; boundaryField {{ {wall} {{ type zeroGradient; }}\n"
        f"{inlet} {{ type zeroGradient; }} {outlet} {{ type fixedValue; value uniform 0; }} }}\n")


def fluxes(path, sizes):
    """The sum of phi through each patch."""
    with open(path, encoding="ascii") as file:
        text = file.read().split("boundaryField", 1)[1]
    sums = {}
    for name, size in sizes.items():
        inside = re.search(r"\b" + name + r"\s*\{(.*?)\n    \}", text, re.S).group(1)
        uniform = re.search(r"value\s+uniform\s+(\S+);", inside)
        if uniform:
            sums[name] = size * float(uniform.group(1))
        else:
            values = re.search(r"List<scalar>\s*(\d+)\s*\((.*?)\)", inside, re.S)
            sums[name] = sum(map(float, values.group(2).split()))
            check(int(values.group(1)) == size, f"{name}: {values.group(1)} fluxes for {size} faces")
    return sums


def judge(title, sums, wall, inlet, outlet):
    print(title, sums, flush=True)
    check(sums[inlet] < 0 and abs(sums[inlet] + sums[outlet]) < 1e-6 * abs(sums[inlet]), f"{title}: mass balance {sums}")
    check(abs(sums[wall]) < 1e-9 * abs(sums[inlet]), f"{title}: flux through the wall {sums}")


def main():
    if not (shutil.which("potentialFoam") and shutil.which("checkMesh")):
        print("skipped: OpenFOAM is not installed (Utilities/install-dependencies.sh --all)")
        sys.exit(SKIPPED)
    stages = tiny.pipeline(tiny.open_tube(), True)
    mesh = simple.FluidSolidMesh(Input=[stages["prisms"], stages["core"]], Surface=stages["refined"], Names="2=blood")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "case.foam")
        ok, errors, _ = write("OpenFOAM", mesh, path)
        check(ok, errors)
        patches = {name: len(sides) for name, sides in foam.read(path).side_sets.items()}
        wall, inlet, outlet = "wall_blood_1", "opening_blood_1", "opening_blood_2"
        check(set(patches) == {wall, inlet, outlet}, f"patches {patches}")
        put(folder, "constant/transportProperties", "dictionary", "nu [0 2 -1 0 0 0 0] 1;\n")
        put(folder, "system/fvSchemes", "dictionary", SCHEMES)
        put(folder, "system/fvSolution", "dictionary", SOLUTION)
        put(folder, "system/controlDict", "dictionary", CONTROL.format(end=0.2, step=0.01, every=20))
        fields(folder, wall, inlet, outlet, "type slip;")
        code, text = run(["potentialFoam", "-case", folder, "-writephi"], folder)
        check(code == 0 and "End" in text, f"potentialFoam: {text[-1500:]}")
        judge("potentialFoam", fluxes(os.path.join(folder, "0", "phi"), patches), wall, inlet, outlet)
        os.remove(os.path.join(folder, "0", "phi"))
        fields(folder, wall, inlet, outlet, "type noSlip;")
        code, text = run(["icoFoam", "-case", folder], folder)
        check(code == 0 and "End" in text, f"icoFoam: {text[-1500:]}")
        judge("icoFoam", fluxes(os.path.join(folder, "0.2", "phi"), patches), wall, inlet, outlet)
    if failures:
        sys.exit(f"{len(failures)} failed")


if __name__ == "__main__":
    main()
