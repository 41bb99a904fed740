# SPDX-License-Identifier: BSD-3-Clause
"""The whole pipeline through the plugin's names on a tiny image, with one and with two threads: same mesh, and it passes."""
import json
import os
import sys

import tiny
from digests import digest


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def main():
    digests = {}
    for threads in ("1", "2"):
        os.environ["VTK_SMP_MAX_THREADS"] = threads
        stage = tiny.pipeline()["audit"]
        stage.UpdatePipeline()
        audit = stage.GetClientSideObject()
        grid = audit.GetOutputDataObject(0)
        report = json.loads(audit.GetReportAsJSON())
        check(grid.GetNumberOfCells() > 0, "the mesh is empty")
        check(audit.GetPassed(), "the audit found: " + "; ".join(report.get("findings", ["nothing to audit"])))
        check(sum(m["wedges"] for m in report["materials"]) > 0, "there are no prisms")
        stages = [grid.GetFieldData().GetArrayName(i) for i in range(grid.GetFieldData().GetNumberOfArrays())]
        for name in ("MultimaterialMarchingCubes", "FeatureSize", "PrismLayer", "CoreTetrahedra", "FluidSolidMesh"):
            check("LaminaReport_" + name in stages, f"no report of {name} in {stages}")
        digests[threads] = digest(grid)
        print(threads, "threads:", grid.GetNumberOfCells(), "cells,", digests[threads][:16])
    check(digests["1"] == digests["2"], "the mesh depends on the number of threads")


if __name__ == "__main__":
    main()
