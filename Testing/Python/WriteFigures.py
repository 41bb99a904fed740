# SPDX-License-Identifier: BSD-3-Clause
"""Measure whole runs of Utilities/mesh.sh and write the tables of docs/figures.md.

    pvpython WriteFigures.py ROOT OUTPUT.md [SHARED_DATA] [--note SENTENCE] [--only NAME]

Inputs whose data are absent are skipped with a line. Exits 1 if a run failed; the file then says which.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

RESOLUTIONS = (60, 120, 180)
CELLS = ("tetrahedra", "wedges", "pyramids")


def inputs(data):
    """Name, title, file that must be there (or a resolution of the phantom), options of mesh.sh."""
    for resolution in RESOLUTIONS:
        yield f"phantom-{resolution}", f"Heart phantom, Resolution {resolution}", resolution, []
    scan = os.path.join(data, "heart_cta")
    yield ("heart_cta", "CT angiography of a heart (heart_cta)", os.path.join(scan, "ct.mha"),
           ["--mask", os.path.join(scan, "mask.mha"), "--thresholds=-20,215"])
    yield ("mickey", "Five labels (mickey of the Cleaver tests)", os.path.join(data, "cleaver_tests", "mickey.nrrd"),
           ["--labels"])


def measure(root, folder, source, options):
    """The report of one run, or None and why there is none."""
    image = source
    if isinstance(source, int):
        image = os.path.join(folder, "phantom.vti")
        script = os.path.join(root, "Examples", "heart_phantom.py")
        subprocess.run(["pvpython", "--no-mpi", script, image, "--resolution", str(source)], check=True, timeout=300)
    output = os.path.join(folder, "out")
    command = [os.path.join(root, "Utilities", "mesh.sh"), image, "--output", output, *options]
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=1800)
    print(done.stdout, flush=True)
    if done.returncode != 0:
        return None, done.stdout.strip().splitlines()[-1]
    with open(os.path.join(output, "report.json"), encoding="utf-8") as file:
        return json.load(file), ""


def table(head, rows):
    """Markdown: the first column to the left, numbers to the right."""
    lines = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    return lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows] + [""]


def relative(mesh, wanted):
    return f"{abs(mesh / wanted - 1):.1e}" if wanted else "-"


def share(fraction):
    """As a percentage that says 100 only of all."""
    text = f"{100 * fraction:.3f} %"
    return "> 99.999 %" if fraction < 1 and text == "100.000 %" else text


def quality(row, kind):
    if not row["cells"]["tetrahedra" if kind == "tet" else "wedges"]:
        return ["-", "-"]
    return [f"{row[kind + 'QualityMin']:.3f}", f"{row[kind + 'QualityP1']:.3f}"]


def section(report):
    """The tables of one run."""
    cells = []
    for m in report["materials"]:
        cells.append([f"{m['material']} ({m['kind']})", *(f"{m['cells'].get(name, 0):,}" for name in CELLS), m["components"]])
    total = [sum(m["cells"].get(name, 0) for m in report["materials"]) for name in CELLS]
    cells.append(["all", *(f"{count:,}" for count in total), sum(m["components"] for m in report["materials"])])
    lines = table(["material", *CELLS, "components"], cells)
    shapes = []
    for m in report["materials"]:
        above = share(m["tetAboveGate"]) if m["cells"].get("tetrahedra") else "-"
        shapes.append([m["material"], *quality(m, "tet"), above, *quality(m, "wedge"),
                       relative(m["meshVolume"], m.get("surfaceVolume")), relative(m["meshVolume"], m["voxelVolume"])])
    lines += table(["material", "tets: least", "1 %", "above the gate", "prisms: least", "1 %", "volume error: of the surface",
                    "of the voxels"], shapes)
    stages = [[s["stage"], f"{s['seconds']:.1f}"] for s in report["stages"]]
    stages.append(["**all**", f"**{sum(s['seconds'] for s in report['stages']):.1f}**"])
    lines += table(["stage", "seconds"], stages)
    peak = max(s["peakMemoryMB"] for s in report["stages"])
    return lines + [f"{report['cells']:,} cells, {report['points']:,} points; peak memory {peak:,.0f} MB.", ""]


def introduction(note):
    cores = len(os.sched_getaffinity(0))
    return ["# Figures", "",
            "What whole runs give, at default options; written by `Testing/Python/WriteFigures.py`, which `Utilities/test.sh --all`",
            f"runs. Do not edit by hand. Measured on {cores} cores.", note, "",
            "- *Quality* of tetrahedra is 3 r/R (1 for a regular one), of prisms the scaled aspect ratio; *1 %* is the first",
            "  percentile; the *gate* is a tetrahedron's quality of 0.1.",
            "- *Volume error* is relative: of a material's cells against what its surface encloses, and against its voxels; the",
            "  latter is mostly the repair of contacts over edges and corners, which relabels voxels before the surface is made.",
            "- *Peak memory* is that of the largest process, pvpython or lamina-tetgen, over the whole run.",
            "- *Components* are pieces connected through faces.", ""]


def main():
    parser = argparse.ArgumentParser(description="Write docs/figures.md.")
    parser.add_argument("root")
    parser.add_argument("output")
    parser.add_argument("data", nargs="?", default="")
    parser.add_argument("--note", default="Other work may have run beside it: seconds are rather too many than too few.")
    parser.add_argument("--only", help="measure this input alone")
    options = parser.parse_args()
    lines = introduction(options.note)
    failed = 0
    for name, title, source, arguments in inputs(options.data):
        if options.only not in (None, name):
            continue
        if isinstance(source, str) and not os.path.isfile(source):
            print(f"skipped: {name}: {source} is not there (LAMINA_SHARED_DATA)", flush=True)
            continue
        with tempfile.TemporaryDirectory() as folder:
            report, why = measure(options.root, folder, source, arguments)
        lines += [f"## {title}", ""]
        lines += section(report) if report else [f"Failed: `{why}`", ""]
        failed += not report
    with open(options.output + ".part", "w", encoding="utf-8") as file:
        file.write("\n".join(lines).rstrip() + "\n")
    os.replace(options.output + ".part", options.output)
    print(f"wrote {options.output}, {failed} runs failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
