# SPDX-License-Identifier: BSD-3-Clause
"""What image_to_mesh.py leaves behind: the files under their final names, and the report."""
import json
import os
import shutil
import subprocess

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_PYRAMID, VTK_TETRA, VTK_WEDGE, vtkPolyData

CELLS = {"tetrahedra": VTK_TETRA, "wedges": VTK_WEDGE, "pyramids": VTK_PYRAMID}


class Results:
    def __init__(self, pipeline, options):
        self.pipeline = pipeline
        self.options = options
        pipeline.scratch_folder(options.output)

    def finish(self, labels, surface, mesh, solid, fluid):
        from lamina_pipeline import Failed
        report = self.report(labels, mesh, solid, fluid)
        passed = report["passed"]
        self.pipeline.begin("Writing")
        self.pipeline.write(labels, "labels.vti")
        self.pipeline.write(scaled(surface, self.options.scale), "surface.vtp")
        self.pipeline.write(mesh, "mesh.vtu")
        self.pipeline.end()
        if passed and self.options.export:
            from lamina_export import export
            export(self.pipeline, mesh, self.options.export)
        drawn = self.draw() if passed and self.options.pictures else True
        report["stages"] = self.pipeline.stages
        self.write_json(report)
        # What an audit refuses may be looked at, but not under the names that promise a good mesh.
        names = self.publish("" if passed else "rejected-")
        if not passed:
            findings = "; ".join(report["audit"].get("findings", [])) or "see the report"
            raise Failed("Mesh Audit", f"the mesh did not pass: {findings}; look at MeshingFlags in "
                         f"{os.path.join(self.options.output, 'rejected-mesh.vtu')}")
        summary(report, self.options.output, names)
        if not drawn:
            raise Failed("Pictures", f"could not be drawn, the mesh is complete; try: xvfb-run -a pvpython "
                         f"Examples/pictures.py {self.options.output}")

    def report(self, labels, mesh, solid, fluid):
        from lamina_pipeline import report_of, scalars_of_labels
        audit = report_of(mesh, "Mesh Audit") or {}
        counts = np.bincount(scalars_of_labels(labels).ravel())
        voxel = float(np.prod(labels.GetSpacing())) * self.options.scale ** 3
        of_material = {row["material"]: row for row in audit.get("materials", [])}
        cells = cell_counts(mesh)
        materials = []
        for material in solid + fluid:
            row = {"material": material, "kind": "solid" if material in solid else "fluid",
                   "voxelVolume": int(counts[material]) * voxel, "cells": cells.get(material, {})}
            row.update({k: v for k, v in of_material.get(material, {}).items() if k not in row and k not in
                        ("tets", "wedges", "pyramids")})
            materials.append(row)
        return {"input": self.options.input, "scale": self.options.scale, "passed": bool(audit.get("passed")),
                "points": mesh.GetNumberOfPoints(), "cells": mesh.GetNumberOfCells(), "materials": materials,
                "audit": {k: v for k, v in audit.items() if k != "materials"}}

    def write_json(self, report):
        from lamina_pipeline import Failed
        try:
            with open(os.path.join(self.pipeline.scratch, "report.json"), "w") as file:
                json.dump(report, file, indent=1)
                file.write("\n")
                file.flush()
                os.fsync(file.fileno())
        except OSError as error:
            raise Failed("Writing", f"report.json could not be written: {error.strerror}; is the disk full?") from None

    def publish(self, prefix):
        """All files are complete: give them their names."""
        from lamina_pipeline import Failed
        names = sorted(os.listdir(self.pipeline.scratch))
        try:
            for name in names:
                target = os.path.join(self.options.output, prefix + name)
                if os.path.isdir(target):  # of an earlier run: a folder cannot be replaced in one step
                    shutil.rmtree(target)
                os.replace(os.path.join(self.pipeline.scratch, name), target)
        except OSError as error:
            raise Failed("Writing", f"{self.options.output}: {error.strerror}") from None
        return names

    def draw(self):
        """Pictures, made by another process: a broken X server must not cost the mesh. True if they are there."""
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "pictures.py")
        command = ["pvpython", "--no-mpi", script, self.pipeline.scratch]
        if not os.environ.get("DISPLAY"):
            # A number of our own: the server of somebody who has just left :99 may still be dying.
            command = ["xvfb-run", "-a", "-n", str(100 + os.getpid() % 800), "-s", "-screen 0 1280x1024x24 -noreset"] + command
        self.pipeline.begin("Pictures")
        for _ in range(2):  # on a busy machine a virtual X server may be late
            try:
                done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=600)
            except (OSError, subprocess.TimeoutExpired):
                return False
            if done.returncode == 0:
                self.pipeline.end()
                return True
        return False


def cell_counts(mesh):
    types = vtk_to_numpy(mesh.GetCellTypesArray())
    materials = vtk_to_numpy(mesh.GetCellData().GetArray("MaterialIds"))
    return {int(m): {name: int(np.count_nonzero(types[materials == m] == code)) for name, code in CELLS.items()}
            for m in np.unique(materials)}


def scaled(surface, factor):
    if factor == 1:
        return surface
    result = vtkPolyData()
    result.ShallowCopy(surface)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(vtk_to_numpy(surface.GetPoints().GetData()) * factor, deep=True))
    result.SetPoints(points)
    return result


def summary(report, folder, names):
    print(f"\n{report['cells']:,} cells, {report['points']:,} points; the audit found nothing wrong.")
    for row in report["materials"]:
        parts = ", ".join(f"{count:,} {name}" for name, count in row["cells"].items() if count)
        above = row.get("tetAboveGate")
        good = f"; tets: least quality {row['tetQualityMin']:.3g}, {100 * above:.3f}% above the gate" \
            if above is not None and row.get("tetQualityMin") is not None and row["cells"].get("tetrahedra") else ""
        volume = row.get("meshVolume")
        print(f"  material {row['material']} ({row['kind']}): {parts or 'no cells'}" +
              (f"; volume {volume:.6g}" if volume is not None else "") + good)
    print(f"{folder}: {', '.join(names)}")
    print(f"Open it: paraview {os.path.join(folder, 'mesh.vtu')}")
