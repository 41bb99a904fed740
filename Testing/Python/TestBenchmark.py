# SPDX-License-Identifier: BSD-3-Clause
"""A small run of the benchmark of the whole chain: every stage is told, with seconds, elements and memory. Times are not judged.

    pvpython TestBenchmark.py ROOT
"""
import json
import os
import subprocess
import sys
import tempfile

STAGES = ["Reading", "Multimaterial Segmentation", "Multimaterial Marching Cubes", "Volume-Conserving Smoothing", "Feature Size",
          "Mesh Estimate", "Surface Refinement", "Layered Tetrahedra", "Prism Layer", "Core Tetrahedra", "Fluid-Solid Mesh", "Mesh Audit",
          "Writing"]


def main():
    program = os.path.join(sys.argv[1], "Testing", "Benchmarks", "BenchmarkPipeline.py")
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        done = subprocess.run(["python3", program, "--cases", "26,32", "--threads", "1,2", "--json", report], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=280)
        assert done.returncode == 0, done.stdout
        with open(report, encoding="utf-8") as file:
            cases = json.load(file)["cases"]
    assert sorted(cases) == ["phantom 26", "phantom 32"], cases.keys()
    for name, runs in cases.items():
        assert sorted(runs) == ["1", "2"], (name, runs.keys())
        for run in runs.values():
            assert [stage["stage"] for stage in run["stages"]] == STAGES, run["stages"]
            assert all(stage["seconds"] >= 0 and stage["peakMemoryMB"] > 0 for stage in run["stages"]), run["stages"]
        cells = [[stage.get("cells") for stage in run["stages"]] for run in runs.values()]
        assert cells[0] == cells[1], f"{name} depends on the number of threads: {cells}"
    for head in ("## phantom 26, 1 thread\n", "## phantom 32: 1 thread to 2\n", "## Growth with the number of elements\n"):
        assert head in done.stdout, (head, done.stdout)
    print("the benchmark tells all stages of", len(cases), "phantoms")


if __name__ == "__main__":
    main()
